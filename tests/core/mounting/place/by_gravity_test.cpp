#include "hexoderm/mounting/attachment/links.h"
#include "hexoderm/mounting/place/place.h"

#include "hexoderm/base/se3.h"
#include "hexoderm/base/units.h"
#include "tests/support/options.h"
#include "tests/support/testing.h"

namespace hexoderm {
namespace {

PatchTurn turnOnLink(const std::string& link, double yaw) {
  return {link, rotationFromRpy({0, 0, yaw}), 1e-4 * Eigen::Matrix3d::Identity()};
}

TEST(RotationByGravity, IsThatOfTheLinkThatIsAskedFor) {
  PatchLinks patch;
  EXPECT_FALSE(rotationByGravity(patch, "forearm"));
  patch.candidates = {test::with(&LinkCandidate::links, {turnOnLink("forearm", 0.1), turnOnLink("hand", 0.2)})};
  patch.nearest = test::with(&LinkCandidate::links, {turnOnLink("base", 0.3)});
  patch.placed = turnOnLink("forearm", 0.4);
  const auto yaw = [&](std::string_view link) {
    const auto found = rotationByGravity(patch, link);
    return found ? rpyFromRotation(found->R_l_o).z() : -1;
  };
  EXPECT_NEAR(yaw("forearm"), 0.4, 1e-12) << "where it is placed it was found together with all others";
  EXPECT_NEAR(yaw("hand"), 0.2, 1e-12);
  EXPECT_NEAR(yaw("base"), 0.3, 1e-12);
  EXPECT_EQ(yaw("finger"), -1);
}

TEST(AgainstGravity, IsWhatIsTurnedByMoreThanIsUncertain) {
  const double sigma = 1 * kDegree;
  const KnownRotation known{rotationFromRpy({0.5, 0.2, -1}), sigma * sigma * Eigen::Matrix3d::Identity()};
  const auto at = [&](const Eigen::Vector3d& e) { return againstGravity(known, known.R_l_o * expSO3(e), 2 * kDegree); };
  EXPECT_FALSE(at(Eigen::Vector3d::Zero()));
  EXPECT_FALSE(at({8 * kDegree, 0, 0})) << "sqrt(16.3) deviations of sqrt(1 + 4) degrees are 9.0 degrees";
  const auto against = at({0, 10 * kDegree, 0});
  ASSERT_TRUE(against);
  EXPECT_NEAR(against->angle_rad, 10 * kDegree, 1e-9);
  EXPECT_NEAR(against->sigma_rad, sigma, 1e-12);
}

TEST(AgainstGravity, SaysNothingAboutAnAxisThatIsLeftOpen) {
  // All poses on one line: the turn about the patch's z is open.
  const KnownRotation known{Eigen::Matrix3d::Identity(), Eigen::Vector3d(1e-4, 1e-4, 1).asDiagonal()};
  EXPECT_FALSE(againstGravity(known, expSO3({0, 0, 2}), 2 * kDegree));
  const auto against = againstGravity(known, expSO3({0.4, 0, 0}), 2 * kDegree);
  ASSERT_TRUE(against);
  EXPECT_NEAR(against->angle_rad, 0.4, 1e-9);
  EXPECT_NEAR(against->sigma_rad, 0.01, 1e-12);
  // Nothing is known at all.
  EXPECT_FALSE(againstGravity({Eigen::Matrix3d::Identity(), Eigen::Matrix3d::Identity()}, expSO3({3, 0, 0}), 0.1));
}

}  // namespace
}  // namespace hexoderm
