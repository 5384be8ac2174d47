#include "hexoderm/base/covariance.h"
#include "hexoderm/base/se3.h"
#include "tests/support/testing.h"

namespace hexoderm {
namespace {

TEST(IsCovariance, TakesWhatVarianceCanBe) {
  const Eigen::Matrix3d R = expSO3({0.4, -1.1, 0.7});
  for (const double unit : {1.0, 1e-6, 1e-300, 1e13}) {
    for (const Eigen::Vector3d& variances :
         {Eigen::Vector3d(1, 2, 3), Eigen::Vector3d(1, 0, 0), Eigen::Vector3d(1, 1, 0), Eigen::Vector3d(0, 0, 0)}) {
      const Eigen::Matrix3d C = unit * (R * variances.asDiagonal() * R.transpose());
      EXPECT_TRUE(isCovariance(Eigen::Matrix3d((C + C.transpose()) / 2))) << C;
    }
  }
  // Positions in metres beside rotations in radians.
  Eigen::Matrix<double, 6, 6> mixed = Eigen::Matrix<double, 6, 6>::Zero();
  mixed.diagonal() << 1e-10, 1e-10, 1e-10, 1e-2, 1e-2, 1e-2;
  mixed(0, 3) = mixed(3, 0) = 0.9e-6;
  EXPECT_TRUE(isCovariance(mixed));
}

TEST(IsCovariance, RefusesWhatNoVarianceCanBe) {
  const auto refused = [](double xx, double xy, double xz, double yy, double yz, double zz) {
    Eigen::Matrix3d C;
    C << xx, xy, xz, xy, yy, yz, xz, yz, zz;
    return !isCovariance(C);
  };
  EXPECT_TRUE(refused(-1, 0, 0, 1, 0, 1)) << "a negative variance";
  EXPECT_TRUE(refused(1, 1.01, 0, 1, 0, 1)) << "a correlation beyond 1";
  EXPECT_TRUE(refused(1e-6, 1.01e-6, 0, 1e-6, 0, 1e-6));
  EXPECT_TRUE(refused(1, 0.9, 0.9, 1, -0.9, 1)) << "correlations that contradict each other";
  EXPECT_TRUE(refused(0, 0, 0, 0, 1e-9, 0)) << "correlated without varying";
  EXPECT_TRUE(refused(1, 1e308, 0, 1, 0, 1));
  EXPECT_TRUE(refused(1, std::nan(""), 0, 1, 0, 1));
  Eigen::Matrix3d asymmetric = Eigen::Matrix3d::Identity();
  asymmetric(0, 1) = 0.5;
  EXPECT_FALSE(isCovariance(asymmetric));
}

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

TEST(Ellipsoid95, HasTheAxesOfTheErrorsTimesTheRootOfChiSquaredTheLongestLast) {
  const Eigen::Matrix3d R = expSO3({0.4, -1.1, 0.7});
  const Eigen::Vector3d sigma(2e-4, 1e-3, 5e-3);
  const Eigen::Matrix3d A = ellipsoid95(R * sigma.cwiseAbs2().asDiagonal() * R.transpose());
  for (Eigen::Index k = 0; k < 3; ++k) {
    EXPECT_NEAR(std::abs(A.col(k).dot(R.col(k))), 2.7955 * sigma[k], 1e-6) << k;
    EXPECT_NEAR(A.col(k).norm(), 2.7955 * sigma[k], 1e-6) << k;
  }
}

TEST(Ellipsoid95, OfNothingIsAPoint) { EXPECT_EQ(ellipsoid95(Eigen::Matrix3d::Zero()).norm(), 0); }

}  // namespace
}  // namespace hexoderm
