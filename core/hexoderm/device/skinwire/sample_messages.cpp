#include "hexoderm/device/skinwire/sample_messages.h"

#include "hexoderm/base/error.h"
#include "hexoderm/base/rounding.h"
#include "hexoderm/base/text.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cassert>
#include <cmath>
#include <optional>
#include <utility>

namespace hexoderm::skinwire {
namespace {

// Major, type, CRC, every field's number and length, sequence, time and period: at most.
constexpr std::size_t kOverhead = 80;
constexpr std::size_t kFloatsPerCell = 12;

using Lsb = std::array<std::int32_t, 3>;

std::size_t varintSize(std::uint32_t value) { return (static_cast<std::size_t>(std::bit_width(value | 1U)) + 6) / 7; }
std::size_t zigzagSize(std::int32_t value) {
  return varintSize((static_cast<std::uint32_t>(value) << 1U) ^ static_cast<std::uint32_t>(value >> 31));
}
std::size_t sizeOf(const Lsb& lsb) { return zigzagSize(lsb[0]) + zigzagSize(lsb[1]) + zigzagSize(lsb[2]); }

/// The reading in LSB if it comes back as the same doubles.
std::optional<Lsb> exactLsb(const Eigen::Vector3d& acceleration_g, double lsb_g) {
  constexpr double kMax = 1e9;
  if (!(lsb_g > 0)) return std::nullopt;
  Lsb lsb{};
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const double value_g = acceleration_g[static_cast<Eigen::Index>(axis)];
    const double steps = nearestWhole(value_g / lsb_g);
    if (!(std::abs(steps) < kMax) || steps * lsb_g != value_g) return std::nullopt;
    lsb[axis] = static_cast<std::int32_t>(steps);
  }
  return lsb;
}

std::uint64_t microseconds(double time_s) {
  const double time_us = std::round(time_s * 1e6);
  if (!(time_us >= 0 && time_us <= static_cast<double>(kMaxTime_us))) {
    throw InvalidArgument("a frame's time can't be sent: expected 0 to 2^53 us, found " + formatExact(time_s) + " s");
  }
  return static_cast<std::uint64_t>(time_us);
}

void push(const Eigen::Vector3d& v, std::vector<float>& out) {
  for (const double value : v) out.push_back(static_cast<float>(value));
}

bool fitsFloats(const Eigen::Vector3d& v) { return v.cast<float>().allFinite(); }

bool sameCells(const SampleFrame& a, const SampleFrame& b) {
  return std::ranges::equal(a.samples, b.samples,
                            [](const CellSample& x, const CellSample& y) { return x.cell == y.cell; });
}

/// A message of one tick, which is sent, and another one begun, where the next item would make it too large.
template <class Send>
class GrowingMessage {
 public:
  GrowingMessage(const SampleFrame& frame, std::size_t most, const Send& send)
      : empty_{.time_us = microseconds(frame.time_s)}, most_(most), send_(send) {}
  Samples& withRoomFor(std::size_t bytes) {
    if (size_ + bytes > most_) end();
    size_ += bytes;
    return open_;
  }
  void end() {
    if (size_ > kOverhead) send_(std::exchange(open_, empty_));
    size_ = kOverhead;
  }

 private:
  Samples empty_;
  Samples open_ = empty_;
  std::size_t size_ = kOverhead;
  std::size_t most_;
  const Send& send_;
};

}  // namespace

void SampleEncoder::append(Samples message, std::vector<Samples>& out) {
  if (!message.cells.empty()) {
    message.sequence = sequence_;
    sequence_ += message.ticks() * message.cells.size();
  }
  out.push_back(std::move(message));
}

void SampleEncoder::encode(const SampleFrame& frame, std::vector<Samples>& out) {
  const auto send = [&](Samples message) { append(std::move(message), out); };
  // Either kind has messages of its own; at most two are open at any time.
  GrowingMessage raw(frame, max_body_, send);
  GrowingMessage floats(frame, max_body_, send);
  for (const CellSample& sample : frame.samples) {
    const std::size_t id_size = varintSize(sample.cell.value());
    if (const std::optional<Lsb> lsb = exactLsb(sample.acceleration_g, lsb_g_)) {
      Samples& open = raw.withRoomFor(id_size + sizeOf(*lsb));
      open.cells.push_back(sample.cell.value());
      open.raw_lsb.insert(open.raw_lsb.end(), lsb->begin(), lsb->end());
    } else if (fitsFloats(sample.acceleration_g)) {
      Samples& open = floats.withRoomFor(id_size + kFloatsPerCell);
      open.cells.push_back(sample.cell.value());
      push(sample.acceleration_g, open.acceleration_g);
    }
  }
  raw.end();
  floats.end();
  GrowingMessage means(frame, max_body_, send);
  for (const CellMean& mean : frame.means) {
    if (!fitsFloats(mean.mean_g) || !fitsFloats(mean.variance_g2) || mean.count == 0) continue;
    Samples& open = means.withRoomFor(varintSize(mean.cell.value()) + 2 * kFloatsPerCell + varintSize(mean.count));
    open.cells.push_back(mean.cell.value());
    push(mean.mean_g, open.mean_g);
    push(mean.variance_g2, open.variance_g2);
    open.count.push_back(mean.count);
  }
  means.end();
  GrowingMessage temperatures(frame, max_body_, send);
  for (const CellTemperature& temperature : frame.temperatures) {
    const auto celsius = static_cast<float>(temperature.temperature_c);
    if (!std::isfinite(celsius)) continue;
    Samples& open = temperatures.withRoomFor(varintSize(temperature.cell.value()) + sizeof(float));
    open.temperature_cells.push_back(temperature.cell.value());
    open.temperature_c.push_back(celsius);
  }
  temperatures.end();
}

void SampleEncoder::encodeBatch(std::span<const SampleFrame> frames, std::vector<Samples>& out) {
  const auto oneByOne = [&] {
    for (const SampleFrame& frame : frames) encode(frame, out);
  };
  if (frames.size() < 2 || frames[0].samples.empty()) return oneByOne();
  Samples batch;
  batch.time_us = microseconds(frames[0].time_s);
  std::size_t size = kOverhead;
  for (const CellSample& sample : frames[0].samples) {
    batch.cells.push_back(sample.cell.value());
    size += varintSize(sample.cell.value());
  }
  const std::uint64_t second_us = microseconds(frames[1].time_s);
  if (second_us <= batch.time_us || second_us - batch.time_us > UINT32_MAX) return oneByOne();
  batch.period_us = static_cast<std::uint32_t>(second_us - batch.time_us);
  for (std::size_t k = 0; k < frames.size(); ++k) {
    const SampleFrame& frame = frames[k];
    const bool fits_in = sameCells(frame, frames[0]) && frame.means.empty() && frame.temperatures.empty() &&
                         microseconds(frame.time_s) == batch.time_us + k * std::uint64_t{batch.period_us};
    if (!fits_in) return oneByOne();
    for (const CellSample& sample : frame.samples) {
      const std::optional<Lsb> lsb = exactLsb(sample.acceleration_g, lsb_g_);
      if (!lsb) return oneByOne();
      batch.raw_lsb.insert(batch.raw_lsb.end(), lsb->begin(), lsb->end());
      size += sizeOf(*lsb);
    }
    if (size > max_body_) return oneByOne();
  }
  append(std::move(batch), out);
}

Joints JointsEncoder::encode(const JointReport& report) {
  Joints message;
  message.time_us = static_cast<std::uint64_t>(std::llround(1e6 * std::max(0.0, report.time_s)));
  for (const auto& [name, position] : report.angles.positions) {
    message.names.push_back(name);
    message.position.push_back(position);
  }
  if (message.names == names_) {
    message.names.clear();
  } else {
    names_ = message.names;
  }
  return message;
}

void decodeTick(const Samples& message, std::size_t tick, double lsb_g, SampleFrame& frame) {
  assert(tick == 0 || tick < message.ticks());
  const std::size_t cells = message.cells.size();
  frame.time_s = static_cast<double>(message.time_us + tick * std::uint64_t{message.period_us}) / 1e6;
  frame.samples.clear();
  frame.means.clear();
  frame.temperatures.clear();
  const std::size_t first = 3 * cells * tick;
  if (!message.raw_lsb.empty()) {
    frame.samples.resize(cells);
    const std::int32_t* value = message.raw_lsb.data() + first;
    for (std::size_t k = 0; k < cells; ++k, value += 3) {
      frame.samples[k] = {CellId(message.cells[k]), {value[0] * lsb_g, value[1] * lsb_g, value[2] * lsb_g}};
    }
  } else if (!message.acceleration_g.empty()) {
    frame.samples.resize(cells);
    const float* value = message.acceleration_g.data() + first;
    for (std::size_t k = 0; k < cells; ++k, value += 3) {
      frame.samples[k] = {CellId(message.cells[k]), Eigen::Vector3f(value[0], value[1], value[2]).cast<double>()};
    }
  } else if (!message.mean_g.empty()) {
    frame.means.resize(cells);
    for (std::size_t k = 0; k < cells; ++k) {
      const float* mean = message.mean_g.data() + 3 * k;
      const float* variance = message.variance_g2.data() + 3 * k;
      frame.means[k] = {CellId(message.cells[k]), Eigen::Vector3f(mean[0], mean[1], mean[2]).cast<double>(),
                        Eigen::Vector3f(variance[0], variance[1], variance[2]).cast<double>(), message.count[k]};
    }
  }
  if (tick == 0) {
    for (std::size_t k = 0; k < message.temperature_cells.size(); ++k) {
      frame.temperatures.push_back(
          {CellId(message.temperature_cells[k]), static_cast<double>(message.temperature_c[k])});
    }
  }
}

}  // namespace hexoderm::skinwire
