#include "hexoderm/capture/stillness_trace.h"

#include <algorithm>
#include <cmath>

namespace hexoderm {
namespace {

constexpr double kMeanOver_s = 1;
constexpr double kDecisiveFor_s = 1;

TraceState stateOf(const HoldStatus& hold) {
  if (hold.phase != HoldPhase::Watching) return TraceState::Collecting;
  return hold.stillness.still ? TraceState::Still : TraceState::Moving;
}

std::optional<Eigen::Vector3d> readingOf(const std::vector<CellSample>& means, CellId cell) {
  const auto found = std::ranges::find(means, cell, &CellSample::cell);
  return found == means.end() ? std::nullopt : std::optional(found->acceleration_g);
}

}  // namespace

void StillnessTrace::add(const HoldStatus& hold, const SkinPreview& preview) {
  const double time_s = preview.time_s;
  if (!std::isfinite(time_s)) return;
  if (!points_.empty() && time_s < points_.back().time_s) clear();
  if (hold.stillness.excess_limit_g > 0) limit_g_ = hold.stillness.excess_limit_g;
  const CellId before = cell();
  noteDecisive(hold.stillness.excess_cell, time_s);
  if (cell() != before) showOther();
  noteEvents(hold, time_s);
  addPoint(time_s, stateOf(hold), preview.means);
}

void StillnessTrace::noteDecisive(CellId cell, double time_s) {
  if (cell == CellId()) return;
  if (cell != candidate_) {
    candidate_ = cell;
    candidate_since_s_ = time_s;
  }
  if (decisive_ == CellId() || time_s - candidate_since_s_ >= kDecisiveFor_s) decisive_ = candidate_;
}

void StillnessTrace::noteEvents(const HoldStatus& hold, double time_s) {
  const bool armed = hold.stillness.armed;
  if (was_armed_ && !*was_armed_ && armed) events_.push_back({time_s, TraceEventKind::ArmedAgain, {}});
  if (hold.restarts > restarts_ && was_armed_) events_.push_back({time_s, TraceEventKind::StartsOver, {}});
  was_armed_ = armed;
  restarts_ = hold.restarts;
}

void StillnessTrace::addPoint(double time_s, TraceState state, const std::vector<CellSample>& means) {
  readings_.push_back(readingOf(means, cell()));
  kept_.push_back(means.size() <= kMaxKeptCells ? means : std::vector<CellSample>());
  points_.push_back({time_s, std::nullopt, state});
  while (points_.front().time_s < time_s - kSpan_s) {
    points_.pop_front();
    readings_.pop_front();
    kept_.pop_front();
  }
  std::erase_if(events_, [&](const TraceEvent& event) { return event.time_s < time_s - kSpan_s; });
  points_.back().deviation_g = deviation(points_.size() - 1);
}

std::optional<Eigen::Vector3d> StillnessTrace::deviation(std::size_t point) const {
  if (!readings_[point]) return std::nullopt;
  Eigen::Vector3d sum = Eigen::Vector3d::Zero();
  int count = 0;
  for (std::size_t k = point + 1; k-- > 0;) {
    if (points_[k].time_s < points_[point].time_s - kMeanOver_s) break;
    if (!readings_[k]) continue;
    sum += *readings_[k];
    ++count;
  }
  return *readings_[point] - sum / count;
}

void StillnessTrace::addCaptured(PoseId pose, double time_s) {
  if (std::isfinite(time_s)) events_.push_back({time_s, TraceEventKind::Captured, pose});
}

void StillnessTrace::pick(std::optional<CellId> picked) {
  const CellId before = cell();
  picked_ = picked;
  if (cell() != before) showOther();
}

void StillnessTrace::showOther() {
  for (std::size_t k = 0; k < points_.size(); ++k) readings_[k] = readingOf(kept_[k], cell());
  for (std::size_t k = 0; k < points_.size(); ++k) points_[k].deviation_g = deviation(k);
}

void StillnessTrace::clear() {
  points_.clear();
  events_.clear();
  kept_.clear();
  readings_.clear();
  decisive_ = candidate_ = CellId();
  was_armed_.reset();
}

}  // namespace hexoderm
