#include "hexoderm/geometry/covariance.h"
#include "hexoderm/geometry/se3.h"

#include <gtest/gtest.h>

namespace hexoderm {
namespace {

TEST(LargestDeviation, IsThatOfTheWorstAxisHoweverItLies) {
  const Eigen::Matrix3d R = expSO3({0.4, -1.1, 0.7});
  for (const Eigen::Vector3d& sigma : {Eigen::Vector3d(1, 2, 3), Eigen::Vector3d(3, 3, 3),
                                       Eigen::Vector3d(1e-3, 5e-8, 1e-3), Eigen::Vector3d(2, 0, 0)}) {
    const Eigen::Matrix3d covariance = R * sigma.cwiseAbs2().asDiagonal() * R.transpose();
    EXPECT_NEAR(largestDeviation(covariance), sigma.maxCoeff(), 1e-7 * sigma.maxCoeff());
  }
}

TEST(LargestDeviation, OfNothingIsNothing) {
  EXPECT_EQ(largestDeviation(Eigen::Matrix3d::Zero()), 0);
  EXPECT_EQ(largestDeviation(-1e-20 * Eigen::Matrix3d::Identity()), 0);
}

}  // namespace
}  // namespace hexoderm
