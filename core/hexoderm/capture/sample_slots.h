#pragma once

// The last seconds of a stream, summed up per cell in slots of time.

#include "hexoderm/device/cell_index.h"
#include "hexoderm/device/sample_frame.h"

#include <Eigen/Core>
#include <algorithm>
#include <array>
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
  Event add(const SampleFrame& frame);
  /// What was new in the frame that was added last.
  [[nodiscard]] const SampleFrame& newIn(const SampleFrame& frame) const { return repeats_.any() ? new_ : frame; }
  /// Forgets all slots and the clock, but no cell.
  void restart();

  [[nodiscard]] std::size_t cellCount() const { return cells_.size(); }
  [[nodiscard]] CellId id(std::size_t cell) const { return index_.id(cell); }
  /// Returns CellIndex::kNone for a cell that was never heard.
  [[nodiscard]] std::size_t find(CellId cell) const { return index_.find(cell); }
  [[nodiscard]] const CellSlots& slotsOf(std::size_t cell) const { return cells_[cell].slots; }
  [[nodiscard]] double heard_s(std::size_t cell) const { return cells_[cell].heard_s; }
  /// The time at which the cell's readings last differed from each other.
  [[nodiscard]] double changed_s(std::size_t cell) const { return cells_[cell].changed_s; }
  [[nodiscard]] bool isHeard(std::size_t cell) const;
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
  [[nodiscard]] std::size_t spanning(double span_s, std::size_t least) const;
  /// Mean of about the last 100 ms, or of the last `least` samples if that takes longer; nullopt if the cell sent
  /// nothing then.
  [[nodiscard]] std::optional<Eigen::Vector3d> recent_g(std::size_t cell, double least = 1) const;
  /// The smallest difference between two readings of a cell that differ; infinite before there are any.
  [[nodiscard]] float step_g() const { return step_g_; }

 private:
  static constexpr double kSlot_s = 0.05;

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
  bool take(CellId cell, const Eigen::Vector3d& value_g, const AddTo& add_to);
  bool noteChange(Sums& sums, const Eigen::Vector3f& value_g);
  void takeAll(const SampleFrame& frame);
  static void clear(Sums& sums, const Eigen::Vector3f& base_g);
  void meet(const Eigen::Vector3f& first_g);
  bool endSlotIfDue(double now_s);
  void forgetSlots();

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
