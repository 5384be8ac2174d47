#pragma once

#include "hexoderm/session/session.h"
#include "hexoderm/solve/reconstructor.h"

#include <gtest/gtest.h>

#include <memory>
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

/// A test that is done for every solver, of pin-jointed skins: the global solver gets their gap model.
class EverySolverTest : public ::testing::TestWithParam<Solver> {
 protected:
  [[nodiscard]] static std::shared_ptr<const Reconstruction> solve(const Session& session) {
    return reconstruct(*session.snapshot(), by(GetParam(), GapModel::Pivot));
  }
  /// The tree is exact; the elastomer's prior pulls every joint of the global solver a little towards straight.
  [[nodiscard]] static double exactOr(double of_global) { return GetParam() == Solver::Tree ? 1e-9 : of_global; }
};

/// The name of a test that is done for every solver.
inline std::string solverOfTest(const ::testing::TestParamInfo<Solver>& test) {
  return std::string(solverName(test.param));
}

}  // namespace hexoderm::test
