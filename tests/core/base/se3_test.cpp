#include "hexoderm/base/se3.h"

#include "hexoderm/base/is_rotation.h"
#include "hexoderm/base/units.h"
#include "tests/support/testing.h"

namespace hexoderm {
namespace {

const Eigen::Vector3d kAxis = Eigen::Vector3d(0.36, -0.48, 0.8);

double distance(const Eigen::Matrix3d& a, const Eigen::Matrix3d& b) { return (a - b).norm(); }

TEST(SE3, MapsPointsFromTheSecondFrameToTheFirst) {
  const SE3 T_a_b{expSO3({0, 0, kPi / 2}), {1, 2, 3}};
  EXPECT_LT((T_a_b * Eigen::Vector3d(1, 0, 0) - Eigen::Vector3d(1, 3, 3)).norm(), 1e-15);
}

TEST(SE3, ChainsAndInverts) {
  const SE3 T_a_b{expSO3({0.1, -0.7, 0.3}), {1, 2, 3}};
  const SE3 T_b_c{expSO3({-1.1, 0.2, 0.9}), {-0.4, 0.5, 0.6}};
  const Eigen::Vector3d x(0.7, -0.2, 0.1);
  EXPECT_LT(((T_a_b * T_b_c) * x - T_a_b * (T_b_c * x)).norm(), 1e-14);
  const SE3 identity = T_a_b * T_a_b.inverse();
  EXPECT_LT(distance(identity.R, Eigen::Matrix3d::Identity()), 1e-14);
  EXPECT_LT(identity.t.norm(), 1e-14);
}

TEST(RotationVector, SkewIsTheCrossProduct) {
  const Eigen::Vector3d w(1, 2, 3);
  const Eigen::Vector3d v(-4, 0.5, 2);
  EXPECT_LT((skew(w) * v - w.cross(v)).norm(), 1e-15);
}

class RotationVectorRoundTrip : public testing::TestWithParam<double> {};

TEST_P(RotationVectorRoundTrip, ComesBack) {
  const Eigen::Vector3d w = GetParam() * kAxis;
  const Eigen::Matrix3d R = expSO3(w);
  EXPECT_LT(distance(R * R.transpose(), Eigen::Matrix3d::Identity()), 1e-14);
  EXPECT_NEAR(R.determinant(), 1, 1e-14);
  EXPECT_LT((logSO3(R) - w).norm(), 1e-12 * std::max(GetParam(), 1e-3));
  EXPECT_NEAR(rotationAngle(R), GetParam(), 1e-13);
}

INSTANTIATE_TEST_SUITE_P(Angles, RotationVectorRoundTrip,
                         testing::Values(0.0, 1e-15, 1e-9, 0.99e-4, 1.01e-4, 1e-2, 1.0, 2.0, 3.0, kPi - 1e-6,
                                         kPi - 1e-9));

TEST(RotationVector, HalfTurnComesBackUpToItsSign) {
  for (const Eigen::Vector3d& axis :
       {Eigen::Vector3d(Eigen::Vector3d::UnitX()), Eigen::Vector3d(-Eigen::Vector3d::UnitY()), kAxis}) {
    const Eigen::Matrix3d R = expSO3(kPi * axis);
    const Eigen::Vector3d w = logSO3(R);
    EXPECT_NEAR(w.norm(), kPi, 1e-12);
    EXPECT_NEAR(std::abs(w.normalized().dot(axis)), 1, 1e-12);
    EXPECT_LT(distance(expSO3(w), R), 1e-12);
  }
}

TEST(Angles, BetweenVectorsIsAccurateForTinyAngles) {
  const Eigen::Vector3d a = Eigen::Vector3d::UnitX();
  EXPECT_NEAR(angleBetween(a, 5 * Eigen::Vector3d(1, 1e-10, 0)) / 1e-10, 1, 1e-6);
  EXPECT_NEAR(angleBetween(a, -2 * a), kPi, 1e-15);
}

TEST(ProjectToSO3, ReturnsTheNearestRotation) {
  const Eigen::Matrix3d R = expSO3({0.4, 0.5, -0.6});
  EXPECT_LT(distance(projectToSO3(R), R), 1e-14);
  Eigen::Matrix3d symmetric;  // R times a positive definite matrix has R as its polar factor
  symmetric << 2, 0.1, 0.2, 0.1, 1, 0.3, 0.2, 0.3, 3;
  EXPECT_LT(distance(projectToSO3(R * symmetric), R), 1e-13);
}

TEST(ProjectToSO3, NeverReflects) {
  EXPECT_NEAR(projectToSO3(Eigen::Vector3d(1, 1, -0.5).asDiagonal()).determinant(), 1, 1e-14);
}

TEST(ShortestRotation, TurnsOneVectorOntoTheOther) {
  const Eigen::Vector3d from = Eigen::Vector3d(1, 2, 3).normalized();
  const Eigen::Vector3d to = Eigen::Vector3d(-3, 0.5, 1).normalized();
  const Eigen::Matrix3d R = shortestRotation(from, to);
  EXPECT_LT((R * from - to).norm(), 1e-14);
  EXPECT_NEAR(rotationAngle(R), angleBetween(from, to), 1e-13);
}

TEST(ShortestRotation, WorksForOppositeVectors) {
  const Eigen::Matrix3d R = shortestRotation(kAxis, -kAxis);
  EXPECT_LT((R * kAxis + kAxis).norm(), 1e-12);
  EXPECT_NEAR(R.determinant(), 1, 1e-12);
}

TEST(RollPitchYaw, IsRzRyRx) {
  const Eigen::Vector3d rpy(0.1, -0.2, 0.3);
  const Eigen::Matrix3d expected = expSO3({0, 0, 0.3}) * expSO3({0, -0.2, 0}) * expSO3({0.1, 0, 0});
  EXPECT_LT(distance(rotationFromRpy(rpy), expected), 1e-14);
}

TEST(RollPitchYaw, ComesBack) {
  for (const double roll : {-3.0, -0.4, 0.0, 1.9}) {
    for (const double pitch : {-1.5, -0.3, 0.0, 1.2}) {
      for (const double yaw : {-2.8, 0.0, 0.6, 3.1}) {
        const Eigen::Vector3d rpy(roll, pitch, yaw);
        EXPECT_LT((rpyFromRotation(rotationFromRpy(rpy)) - rpy).norm(), 1e-12) << rpy.transpose();
      }
    }
  }
}

TEST(RollPitchYaw, InGimbalLockStillGivesTheSameRotationWithoutYaw) {
  for (const double pitch : {-kPi / 2, kPi / 2}) {
    for (const double roll : {-2.0, 0.0, 0.7}) {
      for (const double yaw : {-1.0, 0.0, 2.5}) {
        const Eigen::Matrix3d R = rotationFromRpy({roll, pitch, yaw});
        const Eigen::Vector3d rpy = rpyFromRotation(R);
        EXPECT_LT(distance(rotationFromRpy(rpy), R), 1e-8);
        EXPECT_EQ(rpy.z(), 0);
        EXPECT_NEAR(rpy.y(), pitch, 1e-8);
      }
    }
  }
}

TEST(IsRotation, OnlyWhatTurnsIsOne) {
  const Eigen::Matrix3d R = rotationFromRpy({0.3, -1.2, 2.0});
  EXPECT_TRUE(isRotation(R));
  EXPECT_FALSE(isRotation(-R)) << "it mirrors";
  EXPECT_FALSE(isRotation(1.00001 * R)) << "it stretches";
  EXPECT_FALSE(isRotation(std::numeric_limits<double>::quiet_NaN() * R));
}

}  // namespace
}  // namespace hexoderm
