#include "hexoderm/mounting/parts/rigid_fit.h"

#include "tests/core/mounting/parts/gravity_draw.h"
#include "tests/support/matchers.h"

namespace hexoderm {
namespace {

constexpr GravityErrors kHardlyAny{1e-7, 1e-7, 1e-7};

// Of the stated covariance: the errors of rotations and of the common gravity, and the misfit.
TEST(RigidFit, ErrorsAndMisfitsAreAsLargeAsStated) {
  constexpr int kSeeds = 400;
  double turns = 0;
  double gravity = 0;
  double misfit = 0;
  int improbable = 0;
  for (int seed = 0; seed < kSeeds; ++seed) {
    GravityDraw draw(static_cast<std::uint64_t>(seed));
    const std::vector<Eigen::Vector3d> up = draw.directions(5);
    const std::array<Eigen::Matrix3d, 2> R = {draw.rotation(), draw.rotation()};
    const std::array<GravitySeen, 3> bodies = {draw.see(up, {}), draw.see(seenFrom(R[0], up), {}),
                                               draw.see(seenFrom(R[1], up), {0.02, 0.05, 0.01})};
    const RigidFit fit = fitRigid(bodies);
    Eigen::Matrix<double, 6, 1> e;
    e << logSO3(fit.R[1].transpose() * R[0]), logSO3(fit.R[2].transpose() * R[1]);
    turns += e.dot(fit.covariance.bottomRightCorner<6, 6>().llt().solve(e)) / 6 / kSeeds;
    Eigen::VectorXd e_g(10);
    for (std::size_t k = 0; k < 5; ++k) {
      e_g.segment<2>(static_cast<Eigen::Index>(2 * k)) = acrossBasis(fit.gravity.up[k]).transpose() * up[k];
    }
    gravity += e_g.dot(fit.gravity.covariance.llt().solve(e_g)) / 10 / kSeeds;
    misfit += fit.misfit.chi_squared / fit.misfit.freedom / kSeeds;
    improbable += fit.misfit.probability() < 0.05 ? 1 : 0;
  }
  EXPECT_NEAR(turns, 1, 0.15);
  EXPECT_NEAR(gravity, 1, 0.15);
  EXPECT_NEAR(misfit, 1, 0.06);
  EXPECT_NEAR(improbable, 0.05 * kSeeds, 14);  // 3 sigma
}

TEST(RigidFit, DoesNotDependOnTheFramesOfTheBodies) {
  GravityDraw draw(3);
  const std::vector<Eigen::Vector3d> up = draw.directions(4);
  const GravitySeen a = draw.see(up, {});
  const GravitySeen b = draw.see(seenFrom(draw.rotation(), up), {});
  const RigidFit fit = fitRigid(std::array{a, b});
  const RigidFit back = fitRigid(std::array{b, a});
  EXPECT_NEAR(fit.misfit.chi_squared, back.misfit.chi_squared, 0.02 * fit.misfit.chi_squared);
  EXPECT_LE(rotationAngle(fit.R[1] * back.R[1]), 1e-3);

  // The same directions in another frame, with the same covariances there.
  const Eigen::Matrix3d Q = draw.rotation();
  const RigidFit other = fitRigid(std::array{a, turnedBy(Q, b)});
  EXPECT_NEAR(fit.misfit.chi_squared, other.misfit.chi_squared, 1e-6);
  EXPECT_LE(rotationAngle((fit.R[1] * Q.transpose()).transpose() * other.R[1]), 1e-7);
}

TEST(RigidFit, BodiesMayLackPoses) {
  GravityDraw draw(4);
  const std::vector<Eigen::Vector3d> up = draw.directions(6);
  const Eigen::Matrix3d R = draw.rotation();
  const GravitySeen a = draw.see(up, kHardlyAny, 0);
  const GravitySeen b = draw.see(seenFrom(R, up), kHardlyAny, 0);
  const std::array<std::size_t, 4> first = {0, 1, 2, 3};
  const std::array<std::size_t, 4> last = {2, 3, 4, 5};
  const RigidFit fit = fitRigid(std::array{onlyPoses(a, first), onlyPoses(b, last)});
  EXPECT_LE(rotationAngle(fit.R[1].transpose() * R), 1e-9);
  ASSERT_EQ(fit.gravity.size(), 6U);
  for (std::size_t k = 0; k < 6; ++k) {
    EXPECT_LE(angleBetween(fit.gravity.up[k], up[fit.gravity.poses[k].value() - 1]), 1e-7);
  }
  EXPECT_EQ(fit.misfit.freedom, 16 - 12 - 3);
}

TEST(RigidFit, SaysWhichTurnThePosesLeaveOpen) {
  GravityDraw draw(5);
  const Eigen::Vector3d line = draw.direction();
  const std::vector<Eigen::Vector3d> up = {line, -line, line};
  const Eigen::Matrix3d R = draw.rotation();
  const std::array<GravitySeen, 2> bodies = {draw.see(up, {}), draw.see(seenFrom(R, up), {})};
  const RigidFit fit = fitRigid(bodies);
  const Eigen::Matrix3d C = fit.covariance.bottomRightCorner<3, 3>();
  const Eigen::Vector3d line_b = R.transpose() * line;
  EXPECT_GT(std::sqrt(line_b.dot(C * line_b)), 0.5);
  EXPECT_LT(std::sqrt(C.trace() - line_b.dot(C * line_b)), 0.2);
  EXPECT_EQ(fit.misfit.freedom, 12 - 6 - 2);
  EXPECT_TRUE(fit.R[1].allFinite());

  const std::array<std::size_t, 1> first = {0};
  const std::array<std::size_t, 1> last = {2};
  const RigidFit none = fitRigid(std::array{onlyPoses(bodies[0], first), onlyPoses(bodies[1], last)});
  EXPECT_TRUE(none.R[1].allFinite() && none.covariance.allFinite());
  EXPECT_EQ(none.misfit.probability(), 1);
}

}  // namespace
}  // namespace hexoderm
