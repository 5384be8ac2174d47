#pragma once

#include "hexoderm/capture/pose_recorder.h"

#include <map>
#include <optional>
#include <vector>

namespace hexoderm {

/// Device time for which one obstacle kept a capture from starting.
struct BlockedTime {
  Blocker blocker{};
  double duration_s = 0;
  CellId cell;        ///< the cell that decided for longest; ID 0 where none decides alone
  double cell_s = 0;  ///< ... for so long
  Message message{};  ///< the obstacle in words, as it was last
};

/// Adds up what a PoseRecorder says: why nothing was captured, once it is over.
class StillnessStatistics {
 public:
  /// The time since the state before counts for this one. Where device time goes back, none counts.
  void add(const HoldStatus& hold);

  /// The obstacles that there were, the longest first.
  [[nodiscard]] std::vector<BlockedTime> blocked() const;
  [[nodiscard]] double still_s() const { return still_s_; }      ///< while still, or being sampled
  [[nodiscard]] double watched_s() const { return watched_s_; }  ///< in all
  /// The last state; nullopt before the first.
  [[nodiscard]] const std::optional<HoldStatus>& last() const { return last_; }

 private:
  struct Entry {
    double duration_s = 0;
    std::map<CellId, double> cells_s;
    Message message;
  };
  std::map<Blocker, Entry> entries_;
  double still_s_ = 0;
  double watched_s_ = 0;
  std::optional<HoldStatus> last_;
};

}  // namespace hexoderm
