#include "hexoderm/geometry/covariance.h"
#include "hexoderm/geometry/se3.h"

#include <gtest/gtest.h>
#include <random>

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

TEST(Ellipsoid95, HoldsNinetyFivePercentOfThePoints) {
  const Eigen::Matrix3d R = expSO3({0.4, -1.1, 0.7});
  const Eigen::Vector3d sigma(1e-3, 2e-4, 5e-3);
  const Eigen::Matrix3d A = ellipsoid95(R * sigma.cwiseAbs2().asDiagonal() * R.transpose());
  std::mt19937_64 random(5);
  std::normal_distribution<double> normal;
  constexpr int kPoints = 20000;
  int inside = 0;
  for (int k = 0; k < kPoints; ++k) {
    const Eigen::Vector3d point =
        R * sigma.cwiseProduct(Eigen::Vector3d(normal(random), normal(random), normal(random)));
    if ((A.inverse() * point).norm() <= 1) ++inside;
  }
  EXPECT_NEAR(static_cast<double>(inside) / kPoints, 0.95, 0.006);
  EXPECT_NEAR(A.col(2).norm(), 2.7955 * 5e-3, 1e-6) << "the longest axis comes last";
}

TEST(Ellipsoid95, OfNothingIsAPoint) { EXPECT_EQ(ellipsoid95(Eigen::Matrix3d::Zero()).norm(), 0); }

}  // namespace
}  // namespace hexoderm
