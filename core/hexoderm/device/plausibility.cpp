#include "hexoderm/device/plausibility.h"

#include "hexoderm/base/median.h"
#include "hexoderm/base/units.h"

#include <algorithm>
#include <cmath>

namespace hexoderm {
namespace {

/// Uncalibrated sensors and a hand's motion change the median of many norms by less.
constexpr double kNearGravity = 0.25;
constexpr double kMinGravity_g = 0.5;
constexpr double kMaxGravity_g = 2;

bool isNear(double norm, double unit) { return std::abs(norm / unit - 1) <= kNearGravity; }

ProtocolViolation unitViolation(const char* field, Message what) {
  return {ProtocolViolationKind::AccelerationUnit, located(field, std::move(what))};
}

/// A factor of a thousand in words of time.
struct TimeUnitGuess {
  double factor;  ///< of the expected step to the one that came
  Message name;
};

/// The unit in which a step would be right; empty if it is right, or in none.
Message unitOfStep(double factor) {
  constexpr double kRoom = 3.5;  // a rate is stated roughly, and a host's clock seen through a buffer
  const TimeUnitGuess guesses[] = {
      {1e3, message("milliseconds")}, {1e6, message("seconds")}, {1e-3, message("nanoseconds")}};
  for (const TimeUnitGuess& guess : guesses) {
    if (factor > guess.factor / kRoom && factor < guess.factor * kRoom) return guess.name;
  }
  return {};
}

constexpr const char* kTimeField = "samples.time_us";

/// A rate that is another than the one that the device states, but no other unit.
std::optional<ProtocolViolation> offenceOfRate(double step_us, double stated_hz) {
  constexpr double kRoom = 1.5;
  const double measured_hz = 1e6 / step_us;
  if (!(stated_hz > 0) || (measured_hz < stated_hz * kRoom && measured_hz > stated_hz / kRoom)) return std::nullopt;
  if (!unitOfStep(stated_hz / measured_hz).empty() || !unitOfStep(measured_hz / stated_hz).empty()) return std::nullopt;
  const Number stated{stated_hz};
  const Number measured{measured_hz, 1};
  return ProtocolViolation{
      ProtocolViolationKind::WrongValue,
      located("hello.rate_hz",
              measured_hz < stated_hz
                  ? message("says {} Hz, but a cell's samples come {} times a second by the device's own clock; are "
                            "ticks left out, or is time_us wrong?",
                            stated, measured)
                  : message("says {} Hz, but a cell's samples come {} times a second by the device's own clock; is it "
                            "another rate, or is time_us wrong?",
                            stated, measured))};
}

/// Whether the part is still: the range of a cell's samples, noise included, is small beside the samples. Means are of
/// still parts. Nothing where no cell has sent twice yet.
std::optional<bool> isStill(const std::map<CellId, ReadingCheck::SampleRange>& ranges, double norm_g) {
  constexpr double kSmall_g = 0.3;
  constexpr double kShare = 0.3;
  if (ranges.empty()) return true;
  std::vector<double> sizes_g;
  for (const auto& [cell, range] : ranges) {
    if (range.samples > 1) sizes_g.push_back(range.box_g.sizes().maxCoeff());
  }
  if (sizes_g.empty()) return std::nullopt;
  return median(std::move(sizes_g)) <= std::max(kSmall_g, kShare * norm_g);
}

}  // namespace

std::optional<ProtocolViolation> offenceOfNorm(double median_norm, const Accelerometer& accelerometer,
                                               const char* field) {
  const Number norm{median_norm, median_norm < 10 ? 2 : 0};
  if (median_norm >= kMinGravity_g && median_norm <= kMaxGravity_g) return std::nullopt;
  if (isNear(median_norm, kStandardGravity)) {
    return unitViolation(field,
                         message("the norm of the readings is {} in the median: are these m/s2? Expected g, and 1 g "
                                 "at rest (1 g is 9.80665 m/s2)",
                                 norm));
  }
  if (isNear(median_norm, 1000)) {
    return unitViolation(
        field,
        message("the norm of the readings is {} in the median: are these mg? Expected g, and 1 g at rest", norm));
  }
  if (accelerometer.lsb_g > 0 && isNear(median_norm, 1 / accelerometer.lsb_g)) {
    return unitViolation(field,
                         message("the norm of the readings is {} in the median: are these LSB, of which the cell "
                                 "model has {} in 1 g? Expected g, and 1 g at rest",
                                 norm, Number{1 / accelerometer.lsb_g, 0}));
  }
  return ProtocolViolation{
      ProtocolViolationKind::NotGravity,
      located(field, message("the norm of the readings is {} g in the median, expected 1 g at rest", norm))};
}

// ---- readings

std::optional<ProtocolViolation> ReadingCheck::add(const SampleFrame& frame, const Accelerometer& accelerometer,
                                                   const char* field) {
  constexpr std::uint64_t kEvery = 4;
  constexpr std::uint32_t kFirst = 20;  // frames, which are looked at without a gap
  constexpr std::size_t kMaxCells = 64;
  constexpr std::uint32_t kJudgements = 4;  // a fall or a shock ends sooner
  const std::uint64_t number = frames_++;
  if (number >= kFirst && number % kEvery != 0) return std::nullopt;
  for (const CellSample& sample : frame.samples) {
    if (norms_g_.size() >= (looked_at_ + 1) * kMaxCells) break;
    norms_g_.push_back(sample.acceleration_g.norm());
    SampleRange& range = ranges_[sample.cell];
    range.box_g.extend(sample.acceleration_g);
    ++range.samples;
  }
  for (const CellMean& mean : frame.means) {
    if (norms_g_.size() >= (looked_at_ + 1) * kMaxCells) break;
    norms_g_.push_back(mean.mean_g.norm());
  }
  if (++looked_at_ < kFirst || norms_g_.empty()) return std::nullopt;
  const double norm_g = median(norms_g_);
  std::optional<ProtocolViolation> offence = offenceOfNorm(norm_g, accelerometer, field);
  norms_g_.clear();
  looked_at_ = 0;
  const bool no_gravity = offence && offence->kind == ProtocolViolationKind::NotGravity;
  const std::optional<bool> still = isStill(ranges_, norm_g);
  if (still) ranges_.clear();
  if (no_gravity && !still.value_or(false)) return std::nullopt;
  in_row_ = no_gravity ? in_row_ + 1 : 0;
  if (no_gravity && in_row_ < kJudgements) return std::nullopt;
  return offence;
}

// ---- times

std::optional<ProtocolViolation> ClockCheck::addSample(CellId cell, std::uint64_t time_us, double stated_hz,
                                                       double sensor_hz, bool is_whole) {
  constexpr std::uint32_t kSteps = 20;
  constexpr std::uint32_t kStepsOfRate = 60;  // a short hesitation counts little among so many
  if (!cell_) {
    cell_ = cell;
    first_us_ = time_us;
    return std::nullopt;
  }
  if (cell != *cell_ || steps_ >= kStepsOfRate) return std::nullopt;
  ++steps_;
  if ((steps_ != kSteps && steps_ != kStepsOfRate) || time_us <= first_us_) return std::nullopt;
  const double step_us = static_cast<double>(time_us - first_us_) / steps_;
  if (steps_ == kStepsOfRate) return is_whole ? offenceOfRate(step_us, stated_hz) : std::nullopt;
  if (stated_hz > 0) {
    const Message unit = unitOfStep(1e6 / stated_hz / step_us);
    if (unit.empty()) return std::nullopt;
    return ProtocolViolation{
        ProtocolViolationKind::TimeUnit,
        located(kTimeField, message("a cell's samples are {} us apart, but hello.rate_hz says {} Hz: are these "
                                    "{}? Expected microseconds",
                                    Number{step_us, 0}, Number{stated_hz}, unit))};
  }
  constexpr double kTooQuick = 20;  // times as quick as the sensor itself
  if (1e6 / sensor_hz / step_us < kTooQuick) return std::nullopt;
  return ProtocolViolation{
      ProtocolViolationKind::TimeUnit,
      located(kTimeField, message("a cell's samples are {} us apart, but the cell model's accelerometer has {} "
                                  "Hz: are these milliseconds? Expected microseconds",
                                  Number{step_us, 0}, Number{sensor_hz}))};
}

double ClockCheck::hostPerDevice(const Moment& from, const Moment& to) {
  if (to.device_us <= from.device_us) return 0;
  return std::chrono::duration<double, std::micro>(to.host - from.host).count() /
         static_cast<double>(to.device_us - from.device_us);
}

std::optional<ProtocolViolation> ClockCheck::compare(std::uint64_t last_us, Clock::time_point now, Pace pace) {
  constexpr std::uint32_t kMinChanges = 10;
  constexpr auto kMinTime = std::chrono::seconds(1);
  if (pace == Pace::Free) return std::nullopt;
  if (!began_) {
    began_ = last_ = {last_us, now};
    return std::nullopt;
  }
  // Only while times come: a silence is not a slow clock.
  if (last_us == last_.device_us) return std::nullopt;
  const Moment moment{last_us, now};
  const double step = hostPerDevice(last_, moment);
  last_ = moment;
  if ((step < 1 && pace == Pace::Faster) || unitOfStep(step).empty()) {
    // One step alone may be the clock that was set.
    began_ = moment;
    changes_ = 0;
    return std::nullopt;
  }
  if (++changes_ < kMinChanges || now - began_->host < kMinTime) return std::nullopt;
  const Message unit = unitOfStep(hostPerDevice(*began_, moment));
  if (unit.empty()) return std::nullopt;
  const double host_s = std::chrono::duration<double>(now - began_->host).count();
  return ProtocolViolation{
      ProtocolViolationKind::TimeUnit,
      located(kTimeField, message("in {} of this computer the times went on by {} us: are these {}? Expected "
                                  "microseconds",
                                  Seconds{host_s}, last_us - began_->device_us, unit))};
}

}  // namespace hexoderm
