#include "hexoderm/capture/sample_slots.h"

#include "hexoderm/device/gravity_accumulator.h"

#include <algorithm>
#include <cassert>
#include <cmath>

namespace hexoderm {
namespace {

constexpr double kLongestSlot_s = 1;
constexpr double kHeardInSlot = 0.8;  // share of the cells that must have been heard before a slot ends
constexpr double kRecent_s = 0.1;
constexpr double kGap_s = 0.5;
constexpr double kGapInFrames = 5;
constexpr double kSilentSlots = 2;
constexpr float kAbsurd_g = 100;
constexpr double kRounding_s = 1e-6;

}  // namespace

template <class AddTo>
bool SampleSlots::take(CellId cell, const Eigen::Vector3d& value_g, const AddTo& add_to) {
  const std::size_t k = index_.of(cell);
  if (k == CellIndex::kNone) return true;
  const Eigen::Vector3f value = value_g.cast<float>();
  // A comparison with NaN is false.
  const bool is_sane = value.squaredNorm() < kAbsurd_g * kAbsurd_g;
  if (k >= sums_.size()) meet(is_sane ? value : Eigen::Vector3f::Zero());
  if (!is_sane) return true;
  Sums& sums = sums_[k];
  if (!noteChange(sums, value)) return false;
  if (sums.count == 0) ++heard_in_slot_;
  add_to(sums, Eigen::Vector3f(value - sums.base_g));
  return true;
}

/// Whether the reading is new.
bool SampleSlots::noteChange(Sums& sums, const Eigen::Vector3f& value_g) {
  if (sums.equal > 0 && value_g == sums.last_g) return repeats_.isNew(++sums.equal);
  if (sums.equal > 0) {
    for (const float change : (value_g - sums.last_g).cwiseAbs()) {
      if (change > 0) step_g_ = std::min(step_g_, change);
    }
    if (sums.run_is_whole) repeats_.note(sums.equal);
    sums.run_is_whole = true;
  }
  sums.last_g = value_g;
  sums.equal = 1;
  return true;
}

void SampleSlots::takeAll(const SampleFrame& frame) {
  const bool keeps_new = repeats_.any();
  if (keeps_new) {
    new_.time_s = frame.time_s;
    new_.temperatures = frame.temperatures;
    new_.samples.clear();
    new_.means.clear();
  }
  for (const CellSample& sample : frame.samples) {
    const bool is_new = take(sample.cell, sample.acceleration_g, [](Sums& sums, const Eigen::Vector3f& difference) {
      sums.sum_g += difference;
      sums.squares_g2 += difference.squaredNorm();
      sums.count += 1;
    });
    if (keeps_new && is_new) new_.samples.push_back(sample);
  }
  for (const CellMean& mean : frame.means) {
    if (!isUsable(mean)) continue;
    const float n = static_cast<float>(mean.count);
    const float variance_g2 = static_cast<float>(mean.variance_g2.sum());
    const bool is_new = take(mean.cell, mean.mean_g, [n, variance_g2](Sums& sums, const Eigen::Vector3f& difference) {
      sums.sum_g += n * difference;
      sums.squares_g2 += n * difference.squaredNorm() + (n - 1) * variance_g2;
      sums.count += n;
    });
    if (keeps_new && is_new) new_.means.push_back(mean);
  }
}

void SampleSlots::meet(const Eigen::Vector3f& first_g) {
  sums_.push_back({first_g});
  cells_.emplace_back();
  cells_.back().heard_s = cells_.back().changed_s = last_s_;
}

SampleSlots::Event SampleSlots::add(const SampleFrame& frame) {
  assert(std::isfinite(frame.time_s) && (!has_time_ || frame.time_s >= last_s_));
  Event event = Event::None;
  if (!has_time_) {
    has_time_ = true;
    open_s_ = frame.time_s;
    for (Cell& cell : cells_) cell.heard_s = cell.changed_s = frame.time_s;
  } else if (frame.time_s > last_s_) {
    const double step_s = frame.time_s - last_s_;
    if (usual_step_s_ == 0) usual_step_s_ = std::min(step_s, kLongestSlot_s);
    if (step_s > std::max(kGap_s, kGapInFrames * usual_step_s_)) {
      usual_step_s_ = 0;  // if the next one is as long, it is usual
      forgetSlots();
      open_s_ = frame.time_s;
      event = Event::Gap;
    } else {
      usual_step_s_ += 0.1 * (std::min(step_s, kLongestSlot_s) - usual_step_s_);
      if (endSlotIfDue(frame.time_s)) event = repeats_.update() ? Event::Gap : Event::SlotEnded;
      // What was counted so far was counted several times.
      if (event == Event::Gap) forgetSlots();
    }
  }
  last_s_ = frame.time_s;
  takeAll(frame);
  return event;
}

bool SampleSlots::endSlotIfDue(double now_s) {
  const double length_s = now_s - open_s_;
  const bool heard_enough =
      heard_in_slot_ > 0 && static_cast<double>(heard_in_slot_) >= kHeardInSlot * static_cast<double>(live_);
  if (length_s < (heard_enough ? kSlot_s : kLongestSlot_s) - kRounding_s) return false;

  newest_ = (newest_ + 1) % kSlots;
  count_ = std::min(count_ + 1, kSlots);
  start_s_[newest_] = open_s_;
  middle_s_[newest_] = (open_s_ + last_s_) / 2;
  slot_s_ = count_ == 1 ? length_s : slot_s_ + 0.2 * (length_s - slot_s_);
  open_s_ = now_s;
  heard_in_slot_ = 0;
  live_ = 0;
  for (std::size_t k = 0; k < sums_.size(); ++k) {
    Sums& sums = sums_[k];
    Cell& cell = cells_[k];
    CellSlot& slot = cell.slots[newest_];
    slot.count = sums.count;
    if (sums.count > 0) {
      cell.heard_s = last_s_;
      if (sums.squares_g2 > 0) cell.changed_s = last_s_;
      const Eigen::Vector3f shift = sums.sum_g / sums.count;
      slot.mean_g = sums.base_g + shift;
      slot.scatter_g2 = std::max(0.0F, sums.squares_g2 - sums.sum_g.dot(shift));
      clear(sums, slot.mean_g);
    }
    if (isHeard(k)) ++live_;
  }
  return true;
}

void SampleSlots::forgetSlots() {
  count_ = 0;
  heard_in_slot_ = 0;
  for (Sums& sums : sums_) clear(sums, sums.base_g);
}

void SampleSlots::clear(Sums& sums, const Eigen::Vector3f& base_g) {
  sums.base_g = base_g;
  sums.sum_g.setZero();
  sums.squares_g2 = sums.count = 0;
}

void SampleSlots::restart() {
  forgetSlots();
  has_time_ = false;
  usual_step_s_ = 0;
}

bool SampleSlots::isHeard(std::size_t cell) const {
  return cells_[cell].heard_s >= open_s_ - std::max(silent_after_s_, kSilentSlots * slot_s_);
}

std::size_t SampleSlots::spanning(double span_s, std::size_t least) const {
  for (std::size_t n = least; n <= count_; ++n) {
    if (open_s_ - start_s(n - 1) >= span_s - slot_s_ / 2) return n;
  }
  return count_ == kSlots ? kSlots : 0;
}

std::optional<Eigen::Vector3d> SampleSlots::recent_g(std::size_t cell, double least) const {
  Eigen::Vector3d sum = Eigen::Vector3d::Zero();
  double count = 0;
  for (std::size_t n = 0; n < count_; ++n) {
    if (n > 0 && (count >= least || count == 0) && open_s_ - start_s(n) > kRecent_s + slot_s_ / 2) break;
    const CellSlot& slot = cells_[cell].slots[at(n)];
    sum += static_cast<double>(slot.count) * slot.mean_g.cast<double>();
    count += static_cast<double>(slot.count);
  }
  if (count == 0) return std::nullopt;
  return sum / count;
}

}  // namespace hexoderm
