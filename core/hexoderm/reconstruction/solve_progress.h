#pragma once

#include <atomic>
#include <cstddef>
#include <functional>
#include <memory>
#include <utility>

namespace hexoderm {

struct Reconstruction;

/// What reconstruct() is doing just now.
enum class SolveStage {
  Links,     ///< estimates every link from the readings, and looks for links and readings that can't be right
  Patches,   ///< places all cells of a patch together
  Findings,  ///< looks for what does not fit the solved patches
  Figures,   ///< uncertainties, verdict and advice
};

/// How far one solve is: written by the thread that solves, read by any other. The members are not of one moment, which
/// is enough for an operator who watches.
class SolveProgress {
 public:
  /// Is given cells that are placed.
  using Report = std::function<void(std::shared_ptr<const Reconstruction>)>;

  /// From now on `report` is given the cells as soon as they are placed, long before a result of a large skin is
  /// complete: by the tree, where there is nothing better to start from, and by the joint estimate of the global
  /// solver. What it gets is a Reconstruction with neither covariances nor findings, estimates of sensors and
  /// assessment, and with links as their own readings show them; what is found out afterwards may lead to other
  /// placements. It is called on the thread that solves, which waits for it; must not throw. To be set while nothing is
  /// being solved.
  void reportPlacements(Report report) { report_ = std::move(report); }
  [[nodiscard]] const Report& placementsReport() const { return report_; }  ///< empty: nobody wants to know

  void enter(SolveStage stage) { stage_.store(stage, std::memory_order_relaxed); }  ///< a stage begins
  /// `patch` of `patches` is being solved; the first is 0.
  void enterPatch(std::size_t patch, std::size_t patches) {
    patch_.store(patch, std::memory_order_relaxed);
    patches_.store(patches, std::memory_order_relaxed);
    enter(SolveStage::Patches);
  }

  /// The stage that is being done.
  [[nodiscard]] SolveStage stage() const { return stage_.load(std::memory_order_relaxed); }
  /// The number of the patch that is being solved.
  [[nodiscard]] std::size_t patch() const { return patch_.load(std::memory_order_relaxed); }
  /// The number of patches there are.
  [[nodiscard]] std::size_t patches() const { return patches_.load(std::memory_order_relaxed); }

 private:
  Report report_;
  std::atomic<SolveStage> stage_{SolveStage::Links};
  std::atomic<std::size_t> patch_{0};
  std::atomic<std::size_t> patches_{0};
};

}  // namespace hexoderm
