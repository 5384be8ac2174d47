#pragma once

// The matrix that the joint estimate of a simulated sheet of cells begins with: of its cells, at the tree's placements,
// in three poses.

#include "hexoderm/solve/estimate/patch_solver.h"
#include "hexoderm/solve/global/elimination_plan.h"
#include "hexoderm/solve/sparse/supernodes.h"
#include "tests/support/estimated_links.h"
#include "tests/support/simulated_skins.h"

#include <Eigen/SparseCore>
#include <memory>
#include <vector>

namespace hexoderm {

struct SheetProblem {
  SheetProblem(std::size_t rows, std::size_t columns) {
    const test::EstimatedLinks estimated(test::simulatedSession(test::bentSheet(rows, columns), 3));
    const SkinLinks& links = estimated.links;
    const PatchSolver tree(links, linkWeights(links), 0);
    for (const TreePlacement& placed : tree.treePlacements()) placements.push_back(placed.T_o_u);
    const GlobalRefinement joint(links.model(), links.graph(), links.table(), estimated.options, tree.cells(),
                                 tree.origin(), placements);
    model = links.model();
    problem = joint.problem();
    problem.model = &model;
    state = joint.solution().state;
  }
  SheetProblem(const SheetProblem&) = delete;
  SheetProblem& operator=(const SheetProblem&) = delete;

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
