#pragma once

// The matrix that the joint estimate of a simulated sheet of cells begins with: of its cells, at the tree's placements,
// in three poses.

#include "hexoderm/sim/simulated_session.h"
#include "hexoderm/sim/simulated_skin.h"
#include "hexoderm/solve/estimate/patch_solver.h"
#include "hexoderm/solve/global/elimination_plan.h"
#include "hexoderm/solve/sparse/supernodes.h"

#include <Eigen/SparseCore>
#include <memory>
#include <string>
#include <vector>

namespace hexoderm {

/// A sheet bent round a cylinder of a size that goes with it.
inline SimulatedSkinOptions sheetOptions(std::int64_t rows, std::int64_t columns) {
  SimulatedSkinOptions options;
  options.patch = "sheet:" + std::to_string(rows) + "x" + std::to_string(columns);
  options.surface = "cylinder:r=" + std::to_string(0.25 * static_cast<double>(columns) / 36);
  return options;
}

struct SheetProblem {
  SheetProblem(std::int64_t rows, std::int64_t columns)
      : skin(builtInCellModel("hex-bma150"), sheetOptions(rows, columns)) {
    const auto snapshot = simulateSession(skin, 3).snapshot();
    std::vector<Finding> findings;
    const SolverOptions options;
    SkinLinks links(*snapshot, options, findings);
    links.estimateEdges();
    const PatchSolver tree(links, linkWeights(links), 0);
    for (const TreePlacement& placed : tree.treePlacements()) placements.push_back(placed.T_o_u);
    const GlobalRefinement joint(links.model(), links.graph(), links.table(), options, tree.cells(), tree.origin(),
                                 placements);
    model = links.model();
    problem = joint.problem();
    problem.model = &model;
    state = joint.solution().state;
  }
  SheetProblem(const SheetProblem&) = delete;
  SheetProblem& operator=(const SheetProblem&) = delete;

  SimulatedSkin skin;
  CellModel model;
  std::vector<SE3> placements;
  GlobalProblem problem;
  GlobalState state;
};

struct SheetMatrix {
  using Sparse = Eigen::SparseMatrix<double>;

  LargeVector<Matrix6d> diagonal;
  std::vector<BlockCouple> couples;
  LargeVector<Matrix6d> blocks;  ///< per couple
  Eigen::MatrixXd border;
  Sparse lower;  ///< the lower triangle of the same

  [[nodiscard]] std::shared_ptr<const SupernodalPattern> pattern() const {
    return std::make_shared<const SupernodalPattern>(analysePattern(diagonal.size(), couples));
  }

  static SheetMatrix of(const SheetProblem& sheet) {
    SheetMatrix matrix;
    NormalEquations equations;
    linearize(sheet.problem, sheet.state, equations);
    matrix.diagonal = equations.cells;
    matrix.blocks = equations.links;
    matrix.border = equations.border_cells;
    for (const GlobalLink& link : sheet.problem.links) matrix.couples.push_back({link.c, link.n});
    matrix.lower = matrix.lowerTriangle();
    return matrix;
  }

 private:
  [[nodiscard]] Sparse lowerTriangle() const {
    std::vector<Eigen::Triplet<double>> elements;
    const auto put = [&](std::size_t row_block, std::size_t column_block, const Matrix6d& block) {
      for (int column = 0; column < 6; ++column) {
        for (int row = 0; row < 6; ++row) {
          const int i = static_cast<int>(6 * row_block) + row;
          const int j = static_cast<int>(6 * column_block) + column;
          if (i >= j) elements.emplace_back(i, j, block(row, column));
        }
      }
    };
    for (std::size_t k = 0; k < diagonal.size(); ++k) put(k, k, diagonal[k]);
    for (std::size_t k = 0; k < couples.size(); ++k) {
      if (couples[k].row > couples[k].column) {
        put(couples[k].row, couples[k].column, blocks[k]);
      } else {
        put(couples[k].column, couples[k].row, blocks[k].transpose());
      }
    }
    const auto size = static_cast<Eigen::Index>(6 * diagonal.size());
    Sparse triangle(size, size);
    triangle.setFromTriplets(elements.begin(), elements.end());
    return triangle;
  }
};

}  // namespace hexoderm
