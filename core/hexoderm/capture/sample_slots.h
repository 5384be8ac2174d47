#pragma once

// The last seconds of a stream, summed up per cell in slots of time.

#include "hexoderm/device/cell_index.h"
#include "hexoderm/device/gravity_accumulator.h"
#include "hexoderm/device/sample_frame.h"

#include <Eigen/Core>
#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>
#include <utility>
#include <vector>

namespace hexoderm {

/// A slot takes 50 ms, or as long as it takes until 80 % of the cells have sent something new, 1 s at most. The last
/// kSlots are kept.
inline constexpr std::size_t kSlots = 64;

/// One cell in one slot.
struct CellSlot {
  Eigen::Vector3f mean_g = Eigen::Vector3f::Zero();
  float scatter_g2 = 0;  ///< sum over samples and axes of the squared distance from the mean
  float count = 0;       ///< samples, each reading counted once; 0: none came
};
using CellSlots = std::array<CellSlot, kSlots>;

/// Tells from how long readings stay the same whether each is sent several times over. A gateway that passes 20
/// readings a second on at 100 Hz sends four or five equal ones in a row and hardly ever fewer; a sensor whose noise is
/// below its step repeats itself by chance, and then one equal reading is the most frequent run.
class Repeats {
 public:
  /// `length` equal readings of one cell have come, then another one.
  void note(std::uint32_t length) {
    ++runs_[std::min<std::size_t>(length, kLongest)];
    if (++count_ < kForgetAfter) return;
    before_ = std::exchange(runs_, {});
    count_before_ = std::exchange(count_, 0);
  }

  /// Looks again at the runs; true if it was not known yet that readings come several times over. To be called now and
  /// then.
  bool update() {
    const std::uint32_t all = count_ + count_before_;
    if (all < kFewestRuns) return false;
    std::uint32_t shorter = 0, short_run = 1;
    for (std::size_t length = 1; length <= kLongest; ++length) {
      shorter += runs_[length] + before_[length];
      short_run = static_cast<std::uint32_t>(length);
      if (kShortShare * shorter >= all) break;
    }
    // Twice as many may be two readings that happen to be equal.
    const std::uint32_t was = std::exchange(times_, 2 * short_run - 1);
    return was == 1 && times_ > 1;
  }

  /// Whether readings come several times over.
  [[nodiscard]] bool any() const { return times_ > 1; }
  /// Whether the n-th of equal readings in a row, n >= 1, says something new.
  [[nodiscard]] bool isNew(std::uint32_t n) const { return (n - 1) % times_ == 0; }

 private:
  static constexpr std::size_t kLongest = 127;
  static constexpr std::uint32_t kFewestRuns = 8;
  static constexpr std::uint32_t kForgetAfter = 1000;
  static constexpr std::uint32_t kShortShare = 10;  // one run in ten may be shorter

  std::array<std::uint32_t, kLongest + 1> runs_{}, before_{};
  std::uint32_t count_ = 0, count_before_ = 0;
  std::uint32_t times_ = 1;
};

class SampleSlots {
 public:
  /// A cell that has not been heard for this long (or for two slots) is silent.
  explicit SampleSlots(double silent_after_s) : silent_after_s_(silent_after_s) {}

  enum class Event { None, SlotEnded, Gap };
  /// Adds a frame, with the rules of StillnessDetector::add. A frame that ends a slot belongs to the next one; after a
  /// gap there are no slots. Readings that were sent before are left out; that they come several times over is found
  /// within the first few, and counts as a gap.
  Event add(const SampleFrame& frame) {
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
  /// What was new in the frame that was added last.
  [[nodiscard]] const SampleFrame& newIn(const SampleFrame& frame) const { return repeats_.any() ? new_ : frame; }
  /// Forgets all slots and the clock, but no cell.
  void restart() {
    forgetSlots();
    has_time_ = false;
    usual_step_s_ = 0;
  }

  [[nodiscard]] std::size_t cellCount() const { return cells_.size(); }
  [[nodiscard]] CellId id(std::size_t cell) const { return index_.id(cell); }
  /// Returns CellIndex::kNone for a cell that was never heard.
  [[nodiscard]] std::size_t find(CellId cell) const { return index_.find(cell); }
  [[nodiscard]] const CellSlots& slotsOf(std::size_t cell) const { return cells_[cell].slots; }
  [[nodiscard]] double heard_s(std::size_t cell) const { return cells_[cell].heard_s; }
  /// The time at which the cell's readings last differed from each other.
  [[nodiscard]] double changed_s(std::size_t cell) const { return cells_[cell].changed_s; }
  [[nodiscard]] bool isHeard(std::size_t cell) const {
    return cells_[cell].heard_s >= open_s_ - std::max(silent_after_s_, kSilentSlots * slot_s_);
  }
  /// Number of cells that were heard when the last slot ended.
  [[nodiscard]] std::size_t heardCount() const { return live_; }

  [[nodiscard]] std::size_t newest() const { return newest_; }
  [[nodiscard]] std::size_t count() const { return count_; }  ///< number of slots since the last gap, at most kSlots
  /// The n-th newest slot: where it is in CellSlots, its start and the middle of its frames.
  [[nodiscard]] std::size_t at(std::size_t n) const { return (newest_ + kSlots - n) % kSlots; }
  [[nodiscard]] double start_s(std::size_t n) const { return start_s_[at(n)]; }
  [[nodiscard]] double middle_s(std::size_t n) const { return middle_s_[at(n)]; }
  [[nodiscard]] double end_s() const { return open_s_; }         ///< end of the newest slot
  [[nodiscard]] double slotLength_s() const { return slot_s_; }  ///< length of the latest slots
  /// The number of newest slots that span `span_s`, at least `least`; 0 if there are too few.
  [[nodiscard]] std::size_t spanning(double span_s, std::size_t least) const {
    for (std::size_t n = least; n <= count_; ++n) {
      if (open_s_ - start_s(n - 1) >= span_s - slot_s_ / 2) return n;
    }
    return count_ == kSlots ? kSlots : 0;
  }
  /// Mean of about the last 100 ms, or of the last `least` samples if that takes longer; nullopt if the cell sent
  /// nothing then.
  [[nodiscard]] std::optional<Eigen::Vector3d> recent_g(std::size_t cell, double least = 1) const {
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
  /// The smallest difference between two readings of a cell that differ; infinite before there are any.
  [[nodiscard]] float step_g() const { return step_g_; }

 private:
  static constexpr double kSlot_s = 0.05;
  static constexpr double kLongestSlot_s = 1;
  static constexpr double kHeardInSlot = 0.8;  // share of the cells that must have been heard before a slot ends
  static constexpr double kRecent_s = 0.1;
  static constexpr double kGap_s = 0.5;
  static constexpr double kGapInFrames = 5;
  static constexpr double kSilentSlots = 2;
  static constexpr float kAbsurd_g = 100;
  static constexpr double kRounding_s = 1e-6;

  /// Sums of the open slot, about the cell's last slot mean: floats are enough for small differences.
  struct Sums {
    Eigen::Vector3f base_g;
    Eigen::Vector3f sum_g = Eigen::Vector3f::Zero();
    float squares_g2 = 0;
    float count = 0;
    Eigen::Vector3f last_g = Eigen::Vector3f::Zero();
    std::uint32_t equal = 0;    ///< how often last_g has come in a row
    bool run_is_whole = false;  ///< its beginning was seen
  };
  struct Cell {
    CellSlots slots;
    double heard_s = 0;
    double changed_s = 0;
  };

  /// Returns false for a reading that was sent before.
  template <class AddTo>
  bool take(CellId cell, const Eigen::Vector3d& value_g, const AddTo& add_to) {
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
  bool noteChange(Sums& sums, const Eigen::Vector3f& value_g) {
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
  void takeAll(const SampleFrame& frame) {
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
  static void clear(Sums& sums, const Eigen::Vector3f& base_g) {
    sums.base_g = base_g;
    sums.sum_g.setZero();
    sums.squares_g2 = sums.count = 0;
  }
  void meet(const Eigen::Vector3f& first_g) {
    sums_.push_back({first_g});
    cells_.emplace_back();
    cells_.back().heard_s = cells_.back().changed_s = last_s_;
  }
  bool endSlotIfDue(double now_s) {
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
  void forgetSlots() {
    count_ = 0;
    heard_in_slot_ = 0;
    for (Sums& sums : sums_) clear(sums, sums.base_g);
  }

  double silent_after_s_;
  CellIndex index_;
  std::vector<Sums> sums_;
  std::vector<Cell> cells_;

  bool has_time_ = false;
  double last_s_ = 0;
  double usual_step_s_ = 0;  ///< between frames
  double open_s_ = 0;        ///< when the open slot began
  std::size_t heard_in_slot_ = 0;
  std::size_t live_ = 0;
  std::array<double, kSlots> start_s_{}, middle_s_{};
  std::size_t newest_ = kSlots - 1;
  std::size_t count_ = 0;
  double slot_s_ = kSlot_s;

  Repeats repeats_;
  SampleFrame new_;  ///< of the last frame; only while there are repetitions
  float step_g_ = std::numeric_limits<float>::infinity();
};

}  // namespace hexoderm
