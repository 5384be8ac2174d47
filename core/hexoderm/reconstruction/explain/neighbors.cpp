#include "hexoderm/reconstruction/explain/explainer.h"
#include "hexoderm/reconstruction/faults/suspects.h"

namespace hexoderm {
namespace {

Finding describeInconsistentPose(PoseId pose) {
  return makeFinding(FindingCode::InconsistentPose,
                     message("In pose {} most neighbouring cells contradict each other, and without it they don't: the "
                             "part probably moved while it was sampled. The pose is not used; take it again.",
                             pose),
                     {}, {}, {pose});
}

class Neighbors : public Explainer {
 public:
  [[nodiscard]] Estimate::Stage needs() const override { return Estimate::Stage::Links; }

  [[nodiscard]] std::optional<Explanation> explain(const Estimate& estimate) override {
    if (links_are_judged_) return std::nullopt;
    follow(estimate);
    const SkinLinks& skin = estimate.skin();
    Explanation found;
    if (const auto pose = search_->worstPose()) {
      found.findings.push_back(describeInconsistentPose(skin.poseId(*pose)));
      found.poses.push_back(*pose);
    } else if (const auto cell = search_->worstCell(suspicious_)) {
      if (hasTooFewPoses(skin.table(), *cell) && !search_->isClearlyWrong(*cell)) {
        found.remarks.push_back(describeSuspiciousSensor(skin.graph(), skin.table(), *cell));
        suspicious_.push_back(*cell);
      } else {
        found.findings.push_back(describeBadSensor(skin.graph(), skin.table(), skin.snapshot(), *cell, false));
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
    if (search_ != nullptr && revision_ == estimate.linkRevision()) return;
    if (search_ != nullptr && revision_ + 1 == estimate.linkRevision() && estimate.changedLinks()) {
      search_->update(*estimate.changedLinks());
    } else {
      const SkinLinks& skin = estimate.skin();
      search_ = std::make_unique<SuspectSearch>(skin.model(), skin.graph(), skin.table(), skin.readings(), skin.edges(),
                                                skin.options());
    }
    revision_ = estimate.linkRevision();
  }

  std::unique_ptr<SuspectSearch> search_;
  std::size_t revision_ = 0;
  std::vector<std::size_t> suspicious_;  // cells
  bool links_are_judged_ = false;
};

}  // namespace

std::unique_ptr<Explainer> makeNeighborExplainer() { return std::make_unique<Neighbors>(); }

}  // namespace hexoderm
