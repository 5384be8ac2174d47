#include "hexoderm/solve/explain/explainer.h"
#include "hexoderm/solve/faults/suspects.h"

namespace hexoderm {
namespace {

Finding describeInconsistentPose(PoseId pose) {
  return makeFinding(FindingCode::InconsistentPose,
                     message("In pose {} most neighbouring cells contradict each other, and without it they don't: the "
                             "part probably moved while it was sampled. The pose is not used; take it again.",
                             pose),
                     {}, {}, {pose});
}

class Neighbors {
 public:
  [[nodiscard]] std::optional<Explanation> operator()(const Estimate& estimate) {
    if (links_are_judged_) return std::nullopt;
    follow(estimate);
    const SkinLinks& skin = estimate.skin();
    Explanation found;
    if (const auto pose = search_->worstPose()) {
      found.findings.push_back(describeInconsistentPose(skin.poseId(*pose)));
      found.poses.push_back(*pose);
    } else if (const auto cell = search_->worstCell(suspicious_)) {
      if (hasTooFewPoses(skin, *cell) && !search_->isClearlyWrong(*cell)) {
        found.remarks.push_back(describeSuspiciousSensor(skin, *cell));
        suspicious_.push_back(*cell);
      } else {
        found.findings.push_back(describeBadSensor(skin, *cell, false));
        found.cells.push_back(*cell);
      }
    } else {
      // From here on the links are judged by more than two cells each.
      links_are_judged_ = true;
      for (const SuspectSearch::BadLink& bad : search_->badLinks(suspicious_)) {
        found.links[bad.findings.front().code].push_back(bad.link);
        found.findings.insert(found.findings.end(), bad.findings.begin(), bad.findings.end());
      }
      search_.reset();
    }
    return found.empty() ? std::nullopt : std::optional(std::move(found));
  }

 private:
  /// Judges the links anew that have changed since it was last asked.
  void follow(const Estimate& estimate) {
    if (search_ && revision_ == estimate.linkRevision()) return;
    if (search_ && revision_ + 1 == estimate.linkRevision() && estimate.changedLinks()) {
      search_->update(*estimate.changedLinks());
    } else {
      search_.emplace(estimate.skin());
    }
    revision_ = estimate.linkRevision();
  }

  std::optional<SuspectSearch> search_;
  std::size_t revision_ = 0;
  std::vector<std::size_t> suspicious_;  // cells
  bool links_are_judged_ = false;
};

}  // namespace

Explainer makeNeighborExplainer() { return {Estimate::Stage::Links, Neighbors()}; }

}  // namespace hexoderm
