#pragma once

#include <atomic>
#include <cstddef>
#include <functional>
#include <memory>
#include <utility>

namespace hexoderm {

struct Reconstruction;

/// What reconstruct() is doing just now. Patches and Findings alternate until nothing is found.
enum class SolveStage {
  Links,     ///< estimates every link from the readings, and looks for links and readings that can't be right
  Patches,   ///< places all cells of a patch together
  Findings,  ///< looks for what does not fit the solved patches
  Figures,   ///< uncertainties, verdict and advice
};

/// How far one solve is: stage and patch are written by the thread that solves, and read by any other. They are not of
/// one moment, which is enough for an operator who watches.
class SolveProgress {
 public:
  /// Is given the cells as far as they are placed, on the thread that solves, which waits for it. Must not throw.
  using Report = std::function<void(std::shared_ptr<const Reconstruction>)>;

  /// From now on `report` is told of skins of `least_cells` cells or more where their cells are, long before the result
  /// of a large skin is complete: as the tree has them, if the global solver has no earlier result to start from, and
  /// each time as the joint estimate has them. What it gets is a Reconstruction without covariances, findings,
  /// estimates of sensors and an assessment; its links are as the readings of their two cells show them, and gravity is
  /// the mean of what the cells read. Faults that are found afterwards may lead to other placements. To be set while
  /// nothing is being solved.
  void setPlacementsReport(Report report, std::size_t least_cells = 0) {
    report_ = std::move(report);
    least_cells_ = least_cells;
  }
  /// Empty where nobody wants to know of a skin of so many cells.
  [[nodiscard]] Report placementsReport(std::size_t cells) const { return cells < least_cells_ ? Report() : report_; }

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
  std::size_t least_cells_ = 0;
  std::atomic<SolveStage> stage_{SolveStage::Links};
  std::atomic<std::size_t> patch_{0};
  std::atomic<std::size_t> patches_{0};
};

}  // namespace hexoderm
