#pragma once

#include "hexoderm/solve/estimate/patch_solver.h"
#include "hexoderm/solve/faults/explanation.h"
#include "hexoderm/solve/result/solve_progress.h"

#include <optional>
#include <span>
#include <stop_token>
#include <unordered_map>
#include <vector>

namespace hexoderm {

/// A skin as far as it is estimated, from all that was measured less what explanations exclude. Each stage is brought
/// up to date when it is asked for, at the cost of what has changed since.
class Estimate {
 public:
  enum class Stage {
    Links,    ///< the rotation of every link
    Patches,  ///< the placements of all cells, by the tree or jointly
  };

  /// Excludes what the operator does not want used, and readings that can't be of gravity (judgeCells()). `earlier`: a
  /// result of the same skin for the joint estimate to start from; may be null. `progress`: is told of the cells as
  /// soon as they are placed; may be null. All must outlive the estimate. Throws InvalidArgument for a cell that is to
  /// be left out and is not in the skin.
  Estimate(const SessionSnapshot& snapshot, const SolverOptions& options, const Reconstruction* earlier = nullptr,
           SolveProgress* progress = nullptr);
  // The patches refer to the skin.
  Estimate(const Estimate&) = delete;
  Estimate& operator=(const Estimate&) = delete;

  /// Everything up to this stage is that of what is not excluded.
  [[nodiscard]] Completion bringTo(Stage stage, const std::stop_token& stop);
  /// Takes out of the estimate what the explanation excludes. What depends on it is estimated anew when it is asked
  /// for: without a link, a pose or a motion all links are, without cells only theirs. The patches are placed anew too,
  /// unless the explanation keeps the placements and the solver is the global one, which then solves the cells' patches
  /// again.
  void exclude(Explanation explanation);
  /// Tells the progress of the cells' placements, if they are others than it was last told.
  void reportPlacements(const std::stop_token& stop);

  [[nodiscard]] const SkinLinks& skin() const { return skin_; }
  [[nodiscard]] std::span<const double> weights() const { return weights_; }  ///< per link, of the paths
  [[nodiscard]] std::span<const PatchSolver> patches() const { return patches_; }
  [[nodiscard]] const std::vector<Finding>& findings() const { return findings_; }
  /// How often rotations of links were estimated, and which the last time changed: nothing stands for all.
  [[nodiscard]] std::size_t linkRevision() const { return link_revision_; }
  /// How often the patches were placed from nothing.
  [[nodiscard]] std::size_t placementRevision() const { return placement_revision_; }
  [[nodiscard]] const std::optional<std::vector<std::size_t>>& changedLinks() const { return changed_links_; }

 private:
  void updateLinks();
  void placePatches(const std::stop_token& stop);
  [[nodiscard]] Completion solvePatches(const std::stop_token& stop);
  [[nodiscard]] const PatchReconstruction* earlierOf(const PatchSolver& patch) const;

  std::vector<Finding> findings_;
  SkinLinks skin_;
  SolveProgress* progress_;
  std::unordered_map<CellId, const PatchReconstruction*> earlier_;  ///< patches of the earlier result by their origins
  bool all_links_stale_ = true;
  std::vector<std::size_t> stale_cells_;  ///< else: whose links are
  std::size_t link_revision_ = 0;
  std::size_t placement_revision_ = 0;
  std::optional<std::vector<std::size_t>> changed_links_;
  std::vector<double> weights_;
  std::vector<PatchSolver> patches_;
  bool is_placed_ = false;   ///< the patches are those of the links
  bool was_solved_ = false;  ///< jointly, all patches at least once
  bool unreported_ = false;  ///< placements have changed since the progress was last told
};

}  // namespace hexoderm
