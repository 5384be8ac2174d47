#include "hexoderm/mounting/parts/gravity_seen.h"

#include "hexoderm/solve/reconstructor.h"
#include "tests/core/mounting/parts/gravity_draw.h"
#include "tests/core/mounting/parts/jointed_skins.h"
#include "tests/support/slow_build.h"

#include <numeric>

namespace hexoderm {
namespace {

using test::kSlowBuild;

/// Mean over seeds of e^T C^-1 e per degree of freedom of a patch's gravity in all poses, in the frame of its origin.
double neesOfGravity(const std::string& patch, std::size_t poses, int seeds) {
  double sum = 0;
  double count = 0;
  for (int seed = 1; seed <= seeds; ++seed) {
    JointedSkins skins(JointedSkinsOptions{.body_of_patch = {0},
                                           .patch = patch,
                                           .seed = static_cast<std::uint64_t>(seed),
                                           .hand_held = false});  // the truth is one direction a pose
    const auto result = reconstruct(*skins.session(poses).snapshot());
    const PatchReconstruction& solved = result->patches.front();
    std::vector<std::size_t> all(solved.gravity.size());
    std::iota(all.begin(), all.end(), 0U);
    const GravitySeen seen = gravityOf(solved, all, 0);
    Eigen::VectorXd error(static_cast<Eigen::Index>(2 * poses));
    for (std::size_t k = 0; k < poses; ++k) {
      const Eigen::Vector3d up =
          skins.T_body_u(solved.origin).R.transpose() * skins.forceAt(k, skins.middleOf(0)).normalized();
      error.segment<2>(static_cast<Eigen::Index>(2 * k)) = acrossBasis(seen.up[k]).transpose() * up;
    }
    sum += error.dot(seen.covariance.llt().solve(error));
    count += static_cast<double>(error.size());
  }
  return sum / count;
}

// The errors of all poses together, with what they have in common: the origin's attitude and the sensors' offsets. On a
// robot that holds quite still they are smaller than stated, because the solver takes readings for as good as a hand's
// tremor leaves them (3 mg) and forces for 1 g to 10 mg.
TEST(GravitySeen, ErrorsAreNoLargerThanStated) {
  for (const auto& [patch, poses] :
       {std::pair("x17", 4U), std::pair("x17", 8U), std::pair("sheet:3x3", 4U), std::pair("sheet:1x1", 6U)}) {
    const double nees = neesOfGravity(patch, poses, kSlowBuild ? 2 : 100);
    EXPECT_TRUE(std::isfinite(nees));
    if (kSlowBuild) continue;
    EXPECT_GT(nees, 0.3) << patch << ", " << poses << " poses";
    EXPECT_LT(nees, 1.5) << patch << ", " << poses << " poses";
  }
}

// A hand's swing makes the force differ from place to place: the further away a place may be, the less is known there.
TEST(GravitySeen, PlacesThatAreNotKnownCostCertainty) {
  const auto result = reconstruct(*JointedSkins(JointedSkinsOptions{.body_of_patch = {0}}).session(4).snapshot());
  const std::array<std::size_t, 4> all = {0, 1, 2, 3};
  const GravitySeen here = gravityOf(result->patches.front(), all, 0);
  const GravitySeen somewhere = gravityOf(result->patches.front(), all, 0.2);
  const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> more(somewhere.covariance - here.covariance);
  EXPECT_GT(more.eigenvalues().minCoeff(), 0);
}

// On a table nothing but the sensors' noise disturbs a reading, and the solver grants each of them 3 mg.
TEST(GravitySeen, IsMoreCertainWithLessOfAHand) {
  const auto result =
      reconstruct(*JointedSkins(JointedSkinsOptions{.body_of_patch = {0}, .hand_held = false}).session(4).snapshot());
  const PatchReconstruction& patch = result->patches.front();
  ASSERT_NE(patch.gravity_covariance->withoutTremor(), nullptr);
  const std::array<std::size_t, 4> all = {0, 1, 2, 3};
  const Eigen::MatrixXd usual = gravityOf(patch, all, 0.1).covariance;
  const Eigen::MatrixXd half = gravityOf(patch, all, 0.1, 0.5).covariance;
  const Eigen::MatrixXd none = gravityOf(patch, all, 0.1, 0).covariance;
  EXPECT_LE((half - (usual + none) / 2).norm(), 1e-9 * usual.norm());
  const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> less(usual - none);
  EXPECT_GT(less.eigenvalues().minCoeff(), 0);
  EXPECT_EQ(none.llt().info(), Eigen::Success);
}

}  // namespace
}  // namespace hexoderm
