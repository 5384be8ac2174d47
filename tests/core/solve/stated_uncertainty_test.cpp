// Checks that the stated uncertainty is honest: normalised estimation errors squared of positions and orientations on
// simulated skins, through the public interface; 1 if errors are as large as stated, more if they are larger.
// `hexoderm-reproduce --only uncertainty` counts them for more skins, laws of links and sensors, and with wrong
// priors.

#include "hexoderm/solve/reconstructor.h"
#include "tests/support/nees.h"
#include "tests/support/simulated_skins.h"
#include "tests/support/slow_build.h"
#include "tests/support/solvers.h"
#include "tests/support/testing.h"

#include <Eigen/Cholesky>

namespace hexoderm {
namespace {

using test::kSlowBuild;
using test::Nees;

struct Limits {
  double least = 0;
  double most = 0;
};

/// Few seeds scatter too much for limits.
void expectWithin(const Nees& nees, const Limits& of_position, const Limits& of_orientation, const std::string& name) {
  const std::string figures =
      "position " + std::to_string(nees.position) + ", orientation " + std::to_string(nees.orientation);
  ::testing::Test::RecordProperty(name, figures);
  EXPECT_TRUE(std::isfinite(nees.position) && std::isfinite(nees.orientation)) << name << ": " << figures;
  if (kSlowBuild) return;
  EXPECT_GT(nees.position, of_position.least) << name << ": " << figures;
  EXPECT_LT(nees.position, of_position.most) << name << ": " << figures;
  EXPECT_GT(nees.orientation, of_orientation.least) << name << ": " << figures;
  EXPECT_LT(nees.orientation, of_orientation.most) << name << ": " << figures;
}

/// Of skins of these options with many seeds; the truth is moved so that the origin cells coincide.
Nees neesOf(SimulatedSkinOptions options, std::uint64_t seeds, std::size_t poses, const SolverOptions& solver = {},
            std::size_t readings = 100) {
  Nees nees;
  for (options.seed = 1; options.seed <= (kSlowBuild ? 2U : seeds); ++options.seed) {
    SimulatedSkin skin = test::simulatedSkin(options);
    const auto result = reconstruct(*simulateSession(skin, poses, readings).snapshot(), solver);
    for (const PatchReconstruction& patch : result->patches) {
      nees.addPatch(patch, [&](CellId cell) { return test::truePlacement(skin, cell); });
    }
  }
  return nees;
}

/// Two sessions of one skin have its sensors and its mould in common, so what repeats in both errors is not in their
/// difference: they differ by no more than stated, and by more than nothing, because hands never do the same twice.
TEST(StatedUncertainty, TwoSessionsOfOneSkinDifferByNoMoreThanStated) {
  Nees nees;
  for (std::uint64_t seed = 1; seed <= (kSlowBuild ? 2U : 100U); ++seed) {
    SimulatedSkin skin = test::simulatedSkin(test::skinOptions("x17", "", seed));
    const auto first = reconstruct(*simulateSession(skin, 3).snapshot());
    const auto second = reconstruct(*simulateSession(skin, 3).snapshot());
    ASSERT_EQ(first->patches.front().origin, second->patches.front().origin);
    for (const CellPlacement& a : first->patches.front().cells) {
      if (a.cell == first->patches.front().origin) continue;
      const CellPlacement& b = *second->find(a.cell).cell;
      nees.add(a.T_o_u, b.T_o_u, *a.cov_t_r + *b.cov_t_r);
    }
  }
  expectWithin(nees, {0.002, 1.2}, {0.01, 1.2}, "repeatability");
}

TEST(StatedUncertainty, IsHonestFromThreePosesOnAndOfTheRightOrderWithTwo) {
  for (const auto& [poses, limits] :
       {std::pair(2U, Limits{0.3, 5}), std::pair(3U, Limits{0.7, 1.5}), std::pair(6U, Limits{0.7, 1.5})}) {
    expectWithin(neesOf(test::skinOptions("x17"), 200, poses), limits, limits, std::to_string(poses) + " poses");
  }
}

TEST(StatedUncertainty, OfTheTreeKnowsThatAHandTurnsThePart) {
  for (const std::size_t readings : {10U, 30U, 100U}) {
    const Nees nees =
        neesOf(test::skinOptions("sheet:10x12", "cylinder:r=0.1"), 20, 4, test::by(Solver::Tree), readings);
    expectWithin(nees, {0.5, 1.5}, {0.5, 1.5}, std::to_string(readings) + " readings");
  }
}

}  // namespace
}  // namespace hexoderm
