// Checks that the stated uncertainty is honest: normalised estimation errors squared of positions and orientations on
// simulated skins, through the public interface; 1 if errors are as large as stated, more if they are larger.

#include "hexoderm/reconstruction/reconstructor.h"
#include "hexoderm/session/simulated_session.h"
#include "tests/support/slow_build.h"

#include <gmock/gmock.h>

#include <Eigen/Cholesky>
#include <cmath>
#include <string>

namespace hexoderm {
namespace {

using test::kSlowBuild;

struct Nees {
  double position = 0;
  double orientation = 0;
};

/// Truth moved so that the origin cells coincide; mean over the other cells of e^T C^-1 e / 3.
Nees neesOf(const Reconstruction& result, const std::vector<TrueCell>& truth) {
  Nees sum;
  double count = 0;
  const auto trueOf = [&](CellId id) { return truth[id.value() - 1].T_b_u; };
  for (const PatchReconstruction& patch : result.patches) {
    const SE3 T_o_b = trueOf(patch.origin).inverse();
    for (const CellPlacement& cell : patch.cells) {
      if (cell.cell == patch.origin) continue;
      const SE3 T = T_o_b * trueOf(cell.cell);
      const Eigen::Vector3d e_t = T.t - cell.T_o_u.t;
      const Eigen::Vector3d e_r = logSO3(cell.T_o_u.R.transpose() * T.R);
      const Eigen::Matrix3d C_t = cell.cov_t_r->topLeftCorner<3, 3>();
      const Eigen::Matrix3d C_r = cell.cov_t_r->bottomRightCorner<3, 3>();
      sum.position += e_t.dot(C_t.ldlt().solve(e_t)) / 3;
      sum.orientation += e_r.dot(C_r.ldlt().solve(e_r)) / 3;
      ++count;
    }
  }
  return {sum.position / count, sum.orientation / count};
}

struct Case {
  std::string patch;
  std::size_t poses = 3;
  int seeds = 200;
  LinkLaw law = LinkLaw::Bend;
  std::string surface{};
  double offset_sigma_g = 0.06;
  double prior_factor = 1;  ///< the model's prior of offsets over the true one
  Solver solver = Solver::Global;
  std::size_t samples = 100;  ///< that a hand is held still for
};

std::string nameOf(const Case& c) {
  return c.patch + (c.surface.empty() ? "" : " on " + c.surface) + ", " + std::to_string(c.poses) + " poses, law " +
         (c.law == LinkLaw::Bend ? "bend" : "surface") + ", offsets " +
         std::to_string(static_cast<int>(std::lround(1000 * c.offset_sigma_g))) + " mg, prior x " +
         std::to_string(c.prior_factor).substr(0, 3) + ", " + std::string(solverName(c.solver)) + ", " +
         std::to_string(c.samples) + " samples";
}

/// Mean over seeds.
Nees meanNees(const Case& c) {
  CellModel real = builtInCellModel("hex-bma150");
  real.accelerometer.offset_sigma_g = c.offset_sigma_g;
  CellModel believed = real;
  believed.accelerometer.offset_sigma_g *= c.prior_factor;
  const int seeds = kSlowBuild ? 2 : c.seeds;
  Nees mean;
  for (int seed = 1; seed <= seeds; ++seed) {
    SimulatedSkinOptions options;
    options.patch = c.patch;
    options.surface = c.surface;
    options.link_law = c.law;
    options.seed = static_cast<std::uint64_t>(seed);
    SimulatedSkin skin(real, options);
    const Session simulated = simulateSession(skin, c.poses, c.samples);
    Session session(believed, simulated.neighbors());
    for (const SessionPose& pose : simulated.poses()) session.addPose(pose);
    SolverOptions solver_options;
    solver_options.solver = c.solver;
    const Nees nees = neesOf(*reconstruct(*session.snapshot(), solver_options), skin.truth());
    mean.position += nees.position / seeds;
    mean.orientation += nees.orientation / seeds;
  }
  return mean;
}

/// Both figures within the limits. Few seeds scatter too much for limits.
void expectNees(const Case& c, double least, double most) {
  const Nees nees = meanNees(c);
  const std::string figures =
      "position " + std::to_string(nees.position) + ", orientation " + std::to_string(nees.orientation);
  ::testing::Test::RecordProperty(nameOf(c), figures);
  EXPECT_TRUE(std::isfinite(nees.position) && std::isfinite(nees.orientation)) << nameOf(c) << ": " << figures;
  if (kSlowBuild) return;
  EXPECT_GT(nees.position, least) << nameOf(c) << ": " << figures;
  EXPECT_LT(nees.position, most) << nameOf(c) << ": " << figures;
  EXPECT_GT(nees.orientation, least) << nameOf(c) << ": " << figures;
  EXPECT_LT(nees.orientation, most) << nameOf(c) << ": " << figures;
}

/// Two sessions of one skin have its sensors and its mould in common, so what repeats in both errors is not in their
/// difference: they differ by no more than stated, and by more than nothing, because hands never do the same twice.
TEST(StatedUncertainty, TwoSessionsOfOneSkinDifferByNoMoreThanStated) {
  const int seeds = kSlowBuild ? 2 : 100;
  double position = 0;
  double orientation = 0;
  for (int seed = 1; seed <= seeds; ++seed) {
    SimulatedSkinOptions options;
    options.seed = static_cast<std::uint64_t>(seed);
    SimulatedSkin skin(builtInCellModel("hex-bma150"), options);
    const auto first = reconstruct(*simulateSession(skin, 3).snapshot());
    const auto second = reconstruct(*simulateSession(skin, 3).snapshot());
    ASSERT_EQ(first->patches.front().origin, second->patches.front().origin);
    double count = 0;
    Nees sum;
    for (const CellPlacement& a : first->patches.front().cells) {
      if (a.cell == first->patches.front().origin) continue;
      const CellPlacement& b = *second->find(a.cell).cell;
      const Matrix6d C = *a.cov_t_r + *b.cov_t_r;
      const Eigen::Vector3d d_t = b.T_o_u.t - a.T_o_u.t;
      const Eigen::Vector3d d_r = logSO3(a.T_o_u.R.transpose() * b.T_o_u.R);
      sum.position += d_t.dot(C.topLeftCorner<3, 3>().ldlt().solve(d_t)) / 3;
      sum.orientation += d_r.dot(C.bottomRightCorner<3, 3>().ldlt().solve(d_r)) / 3;
      ++count;
    }
    position += sum.position / count / seeds;
    orientation += sum.orientation / count / seeds;
  }
  ::testing::Test::RecordProperty("repeatability", std::to_string(position) + " / " + std::to_string(orientation));
  EXPECT_TRUE(std::isfinite(position) && std::isfinite(orientation));
  if (kSlowBuild) return;
  EXPECT_LT(position, 1.2) << orientation;
  EXPECT_LT(orientation, 1.2) << position;
  EXPECT_GT(position, 0.002) << orientation;
  EXPECT_GT(orientation, 0.01) << position;
}

TEST(StatedUncertainty, IsHonestFromThreePosesOn) {
  for (const LinkLaw law : {LinkLaw::Bend, LinkLaw::Surface}) {
    for (const char* patch : {"x17", "ring8", "ring8:closed"}) {
      for (const std::size_t poses : {3U, 6U}) expectNees({patch, poses, 200, law}, 0.7, 1.5);
    }
  }
}

TEST(StatedUncertainty, IsOfTheRightOrderWithTwoPoses) {
  for (const LinkLaw law : {LinkLaw::Bend, LinkLaw::Surface}) {
    for (const char* patch : {"x17", "ring8", "ring8:closed"}) expectNees({patch, 2, 200, law}, 0.3, 5);
  }
}

TEST(StatedUncertainty, IsHonestForBetterSensorsWithAPriorThatSaysSo) {
  for (const std::size_t poses : {3U, 6U}) expectNees({"x17", poses, 200, LinkLaw::Bend, "", 0.02}, 0.7, 1.5);
  expectNees({"x17", 2, 200, LinkLaw::Bend, "", 0.02}, 0.3, 5);
}

TEST(StatedUncertainty, SurvivesAPriorThatIsWrongByAFactorOfTwo) {
  for (const double factor : {0.5, 2.0}) {
    for (const double offset_g : {0.02, 0.06}) {
      for (const char* patch : {"x17", "ring8:closed"}) {
        expectNees({patch, 3, 200, LinkLaw::Bend, "", offset_g, factor}, 0.3, 4);
      }
    }
  }
}

TEST(StatedUncertainty, OfTheTreeKnowsThatAHandTurnsThePart) {
  for (const std::size_t samples : {10U, 30U, 100U}) {
    expectNees({.patch = "sheet:10x12",
                .poses = 4,
                .seeds = 20,
                .surface = "cylinder:r=0.1",
                .solver = Solver::Tree,
                .samples = samples},
               0.5, 1.5);
  }
}

TEST(StatedUncertainty, IsHonestOnASheetThatCurvesBothWays) {
  expectNees({"sheet:10x10", 3, 40, LinkLaw::Bend, "torus:R=0.2,r=0.1"}, 0.7, 1.5);
}

}  // namespace
}  // namespace hexoderm
