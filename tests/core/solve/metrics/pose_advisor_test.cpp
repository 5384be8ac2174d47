#include "hexoderm/solve/metrics/pose_coverage.h"

#include "hexoderm/base/se3.h"
#include "hexoderm/base/units.h"
#include "hexoderm/solve/reconstructor.h"
#include "tests/support/pin_jointed_skin.h"

#include <gtest/gtest.h>

namespace hexoderm {
namespace {

const CellModel& model() {
  static const CellModel kModel = builtInCellModel("hex-bma150");
  return kModel;
}

TEST(PoseAdvisor, FirstTwoAreAboutARightAngleApart) {
  const Eigen::Vector3d first = Eigen::Vector3d(0.2, 0.3, 0.9).normalized();
  const PoseAdvice advice = adviseNextPose(model(), {first});
  EXPECT_NEAR(toDegrees(angleBetween(advice.up, first)), 90, 15);
  EXPECT_LT(advice.sigma_then_rad, advice.sigma_now_rad);
  EXPECT_LT(std::abs(adviseNextPose(model(), {Eigen::Vector3d::UnitX()}).up.x()), 0.5);
}

TEST(PoseAdvisor, FirstFourAreNotInAPlane) {
  std::vector<Eigen::Vector3d> seen = {Eigen::Vector3d::UnitZ()};
  while (seen.size() < 4) seen.push_back(adviseNextPose(model(), seen).up);
  Eigen::Matrix3Xd differences(3, 3);
  for (Eigen::Index k = 0; k < 3; ++k) differences.col(k) = seen[static_cast<std::size_t>(k) + 1] - seen[0];
  EXPECT_GT(std::abs(differences.determinant()), 0.5) << "a tetrahedron's edges, not a plane's";
}

TEST(PoseAdvisor, EveryAdvisedPoseHelpsLessThanTheOneBefore) {
  std::vector<Eigen::Vector3d> seen = {Eigen::Vector3d::UnitZ()};
  double sigma = adviseNextPose(model(), seen).sigma_now_rad;
  for (int k = 0; k < 6; ++k) {
    const PoseAdvice advice = adviseNextPose(model(), seen);
    EXPECT_LT(advice.sigma_then_rad, sigma);
    sigma = advice.sigma_then_rad;
    seen.push_back(advice.up);
  }
  EXPECT_LT(toDegrees(sigma), 2.5);
}

TEST(PoseAdvisor, SaysWhichCellFacesWhere) {
  const auto result = reconstruct(*bentX17().session(orthogonalUps(2)).snapshot());
  PoseAdvice advice;
  advice.up = result->find(CellId(9)).cell->T_o_u.R.col(2);
  EXPECT_EQ(adviceText(advice, *result).english(), "Turn the part so that cell 9 faces the ceiling.");
  advice.up = -advice.up;
  EXPECT_EQ(adviceText(advice, *result).english(), "Turn the part so that cell 9 faces the floor.");
}

}  // namespace
}  // namespace hexoderm
