#pragma once

#include "hexoderm/skin/shortest_paths.h"
#include "hexoderm/solve/global/global_refinement.h"
#include "hexoderm/solve/tree/skin_links.h"
#include "hexoderm/solve/tree/tree_placement.h"

#include <memory>
#include <span>
#include <stop_token>
#include <vector>

namespace hexoderm {

/// How a step that may take seconds ended: it did its work, or it left because stop was requested, and then what it was
/// to leave behind is not complete.
enum class Completion { Finished, Stopped };

/// Solves one patch of a skin: first its cells along the shortest-path tree, then, with solve(), all of them jointly.
/// Valid until links are muted, which may change the patches. Cells and links are indices of the graph.
class PatchSolver {
 public:
  /// Chooses the origin, a cell that measures, and places the cells along the tree. `weights`: per link
  /// (linkWeights()). Skin and weights must outlive the solver, and the skin have estimated edges.
  PatchSolver(const SkinLinks& skin, std::span<const double> weights, std::size_t patch);

  /// The joint estimate; after leaveOut() from where it was. `earlier`: this patch in an earlier result of the global
  /// solver, to start from if it had the same cells and origin; may be null. The tree's placements are gone afterwards.
  [[nodiscard]] Completion solve(const PatchReconstruction* earlier, const std::stop_token& stop);
  /// The readings of a cell of the patch are dropped from the skin: it is placed by its links. Needs place(), as soon
  /// as the skin has estimated edges again, and another solve().
  void leaveOut(std::size_t cell);
  /// Chooses an origin anew where the last one was left out, and places the cells along the tree from there.
  void place();
  /// The joint estimate is that of the readings of the skin.
  [[nodiscard]] bool isSolved() const { return solved_; }
  /// The patch had exactly these cells in an earlier result, and the same origin.
  [[nodiscard]] bool canStartFrom(const PatchReconstruction& earlier) const;

  [[nodiscard]] std::size_t patch() const { return patch_; }
  [[nodiscard]] std::size_t origin() const { return paths_.root; }
  [[nodiscard]] const std::vector<std::size_t>& cells() const { return cells_; }  ///< ascending
  [[nodiscard]] const ShortestPaths& paths() const { return paths_; }
  /// Per cell of cells(); none after solve().
  [[nodiscard]] const std::vector<TreePlacement>& treePlacements() const { return placements_; }
  /// Of a cell of the graph, in the origin's frame: as the joint estimate has it, or else the tree.
  [[nodiscard]] const SE3& placementOf(std::size_t cell) const;
  [[nodiscard]] const GlobalRefinement* joint() const { return joint_.get(); }  ///< null before solve()

 private:
  [[nodiscard]] std::vector<SE3> startingPlacements(const PatchReconstruction* earlier) const;
  void placeAlongPaths();
  [[nodiscard]] std::unique_ptr<GlobalRefinement> jointFrom(const PatchReconstruction* earlier);

  const SkinLinks& skin_;
  std::span<const double> weights_;
  std::size_t patch_;
  std::vector<std::size_t> cells_;
  ShortestPaths paths_;
  std::vector<TreePlacement> placements_;
  std::unique_ptr<GlobalRefinement> joint_;
  bool solved_ = false;
  bool lacks_origin_ = false;
};

/// Names the poses in which the cells of a solved patch contradict each other far more than in the others: the part
/// moved while it was sampled.
void nameInconsistentPoses(const SkinLinks& skin, const PatchSolver& patch, std::vector<Finding>& findings);

/// Says it where the joint estimate of the patch with this origin ended before its optimum.
void nameUnconverged(CellId origin, const GlobalSolution& solution, std::vector<Finding>& findings);

}  // namespace hexoderm
