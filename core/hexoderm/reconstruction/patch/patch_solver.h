#pragma once

#include "hexoderm/graph/shortest_paths.h"
#include "hexoderm/reconstruction/joint/joint_refinement.h"
#include "hexoderm/reconstruction/links/skin_links.h"
#include "hexoderm/reconstruction/links/tree_placement.h"
#include "hexoderm/reconstruction/result/completion.h"

#include <memory>
#include <optional>
#include <span>
#include <stop_token>
#include <vector>

namespace hexoderm {

/// Solves one patch of a skin: first its cells along the shortest-path tree, then, with refine(), all of them jointly.
/// Valid until links are muted, which may change the patches. Cells and links are indices of the graph.
class PatchSolver {
 public:
  /// Chooses the origin, a cell that measures, and places the cells along the tree. `weights`: per link
  /// (linkWeights()). Skin and weights must outlive the solver, and the skin have estimated edges.
  PatchSolver(SkinLinks& skin, std::span<const double> weights, std::size_t patch);

  /// The joint estimate. A cell whose readings fit the gravity of all others in no position is left out, with a
  /// finding, and the rest solved again, the worst cell first; its readings are dropped from the skin too, whose edges
  /// are then to be estimated again. `earlier`: this patch in an earlier result of the global solver, to start from if
  /// it had the same cells and origin; may be null. To be called once: the tree's placements are gone afterwards.
  [[nodiscard]] Completion refine(const PatchReconstruction* earlier, const std::stop_token& stop,
                                  std::vector<Finding>& findings);
  /// The patch had exactly these cells in an earlier result, and the same origin.
  [[nodiscard]] bool canStartFrom(const PatchReconstruction& earlier) const;
  [[nodiscard]] bool droppedCells() const { return dropped_cells_; }

  [[nodiscard]] std::size_t patch() const { return patch_; }
  [[nodiscard]] std::size_t origin() const { return paths_.root; }
  [[nodiscard]] const std::vector<std::size_t>& cells() const { return cells_; }  ///< ascending
  [[nodiscard]] const ShortestPaths& paths() const { return paths_; }
  /// Per cell of cells(); none after refine().
  [[nodiscard]] const std::vector<TreePlacement>& treePlacements() const { return placements_; }
  /// Of a cell of the graph, in the origin's frame: as the joint estimate has it, or else the tree.
  [[nodiscard]] const SE3& placementOf(std::size_t cell) const;
  [[nodiscard]] const JointRefinement* joint() const { return joint_.get(); }  ///< null before refine()

 private:
  [[nodiscard]] std::vector<SE3> startingPlacements(const PatchReconstruction* earlier) const;
  struct BadSensor {
    std::size_t cell = 0;
    std::optional<TurnBetweenPoses> turn;  ///< that is what is wrong with it
  };
  [[nodiscard]] std::optional<BadSensor> worstSensor(const std::vector<std::size_t>& but) const;
  [[nodiscard]] std::optional<TurnBetweenPoses> turnOf(std::size_t cell) const;
  [[nodiscard]] Finding describe(const BadSensor& bad) const;
  [[nodiscard]] bool isLeaf(std::size_t cell) const;

  void placeAlongPaths();
  [[nodiscard]] std::unique_ptr<JointRefinement> jointFrom(const PatchReconstruction* earlier);

  SkinLinks& skin_;
  std::span<const double> weights_;
  std::size_t patch_;
  std::vector<std::size_t> cells_;
  ShortestPaths paths_;
  std::vector<TreePlacement> placements_;
  std::unique_ptr<JointRefinement> joint_;
  bool dropped_cells_ = false;
};

/// Mutes in every refined patch the link that leaves its loops open by more than askew cells can: a cable that looks
/// like a skin link in its angles. One link a patch, because the others give way to it. True if there was any: then the
/// patches have to be solved again.
[[nodiscard]] bool muteOpenLinks(SkinLinks& skin, std::span<const PatchSolver> patches, std::vector<Finding>& findings);

/// Names the poses in which the cells of a refined patch contradict each other far more than in the others: the part
/// moved while it was sampled.
void nameInconsistentPoses(const SkinLinks& skin, const PatchSolver& patch, std::vector<Finding>& findings);

/// Says it where the joint estimate of the patch with this origin ended before its optimum.
void nameUnconverged(CellId origin, const JointSolution& solution, std::vector<Finding>& findings);

}  // namespace hexoderm
