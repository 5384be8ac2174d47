#include "hexoderm/solve/result/reconstruction.h"

#include "hexoderm/base/units.h"

#include <gtest/gtest.h>

namespace hexoderm {
namespace {

CellPlacement cellWith(const Eigen::Vector3d& position_sigma_m, const Eigen::Vector3d& rotation_sigma_rad) {
  CellPlacement cell;
  cell.cov_t_r.emplace(Matrix6d::Zero());
  // Turned, so that the worst axis is none of the frame's.
  const Eigen::Matrix3d R = expSO3({0.4, -0.7, 1.1});
  cell.cov_t_r->topLeftCorner<3, 3>() = R * position_sigma_m.cwiseAbs2().asDiagonal() * R.transpose();
  cell.cov_t_r->bottomRightCorner<3, 3>() = R * rotation_sigma_rad.cwiseAbs2().asDiagonal() * R.transpose();
  return cell;
}

TEST(Uncertainty, IsThatOfTheWorstAxisAt95Percent) {
  const auto known = uncertaintyOf(cellWith({0.0002, 0.001, 0.0005}, {0.02, 0.01, 0.005}));
  ASSERT_TRUE(known);
  EXPECT_NEAR(known->position_m, 1.96 * 0.001, 1e-6);
  EXPECT_NEAR(known->orientation_rad, 1.96 * 0.02, 1e-6);
}

TEST(Uncertainty, IsZeroForTheOriginAndAbsentWhereNoneIsStated) {
  EXPECT_EQ(uncertaintyOf(cellWith({0, 0, 0}, {0, 0, 0}))->position_m, 0);
  EXPECT_FALSE(uncertaintyOf(CellPlacement()));
}

TEST(Uncertainty, OfAnOrientationThatNothingFixesIsAHalfTurn) {
  EXPECT_EQ(uncertaintyOf(cellWith({0, 0, 0}, {10, 0, 0}))->orientation_rad, kPi);
}

}  // namespace
}  // namespace hexoderm
