#pragma once

#include "hexoderm/reconstruction/result/solver_options.h"

#include <gtest/gtest.h>

#include <string>

namespace hexoderm::test {

/// The defaults of a solver.
inline SolverOptions by(Solver solver, GapModel gap_model = GapModel::Fit) {
  SolverOptions options;
  options.solver = solver;
  options.gap_model = gap_model;
  return options;
}

/// The tree as in the paper: no readings centred, and no support axes.
inline SolverOptions papersMethod() {
  SolverOptions options = by(Solver::Tree);
  options.centring = Centring::Off;
  options.support_axes = SupportAxes::Off;
  return options;
}

/// The name of a test that is done for every solver.
inline std::string solverOfTest(const ::testing::TestParamInfo<Solver>& test) {
  return std::string(solverName(test.param));
}

}  // namespace hexoderm::test
