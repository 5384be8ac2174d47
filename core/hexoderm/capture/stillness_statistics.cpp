#include "hexoderm/capture/pose_recorder.h"

#include <algorithm>
#include <functional>
#include <utility>

namespace hexoderm {
namespace {

CellId decidingCell(const Stillness& stillness) {
  switch (stillness.blocker) {
    case Blocker::Shaking:
      return stillness.excess_cell;
    case Blocker::CellTurning:
      return stillness.turning_cell;
    default:
      return {};
  }
}

}  // namespace

void StillnessStatistics::add(const HoldStatus& hold) {
  const Stillness& stillness = hold.stillness;
  const double step_s = last_ ? std::max(0.0, stillness.time_s - last_->stillness.time_s) : 0;
  last_ = hold;
  watched_s_ += step_s;
  if (hold.phase != HoldPhase::Watching || stillness.blocker == Blocker::None) {
    still_s_ += step_s;
    return;
  }
  Entry& entry = entries_[stillness.blocker];
  entry.duration_s += step_s;
  entry.message = stillness.message;
  const CellId cell = decidingCell(stillness);
  if (cell != CellId()) entry.cells_s[cell] += step_s;
}

std::vector<BlockedTime> StillnessStatistics::blocked() const {
  std::vector<BlockedTime> times;
  for (const auto& [blocker, entry] : entries_) {
    BlockedTime time{blocker, entry.duration_s, {}, 0, entry.message};
    for (const auto& [cell, duration_s] : entry.cells_s) {
      if (time.cell != CellId() && duration_s <= time.cell_s) continue;
      time.cell = cell;
      time.cell_s = duration_s;
    }
    times.push_back(std::move(time));
  }
  std::ranges::stable_sort(times, std::greater(), &BlockedTime::duration_s);
  return times;
}

}  // namespace hexoderm
