#include "hexoderm/reconstruction/accelerometer/rigidity.h"

#include "hexoderm/geometry/se3.h"
#include "tests/support/normal_draw.h"

#include <gmock/gmock.h>

#include <limits>

namespace hexoderm {
namespace {

/// A cell whose sensor errs, with readings whose variances differ.
struct Cell {
  Eigen::Matrix3d R;
  std::vector<CellReading> readings;
  std::vector<Eigen::Vector3d> f_o;

  Cell(std::size_t poses, test::NormalDraw& draw) : R(draw.rotation()) {
    const Eigen::Vector3d offset = 0.06 * draw.vector();
    for (std::size_t pose = 0; pose < poses; ++pose) {
      f_o.push_back(draw.direction());
      readings.push_back(
          {pose, R.transpose() * f_o.back() + offset + 0.005 * draw.vector(), 2e-5 * static_cast<double>(1 + pose)});
    }
  }
  [[nodiscard]] std::vector<Eigen::Vector3d> forcesIn(const Eigen::Matrix3d& R_o_a) const {
    std::vector<Eigen::Vector3d> v_g;
    for (const Eigen::Vector3d& f : f_o) v_g.emplace_back(R_o_a.transpose() * f);
    return v_g;
  }
  /// By the fit of the errors alone.
  [[nodiscard]] double chiSquaredAt(const Eigen::Matrix3d& R_o_a) const {
    AccelerometerFit fit;
    fitAccelerometer(AccelerometerPrior{Accelerometer{}}, readings, forcesIn(R_o_a),
                     {std::numeric_limits<double>::infinity()}, fit);
    return 2 * fit.cost;
  }
};

TEST(FindAttitude, FindsWhereTheErrorsOfTheSensorExplainTheReadingsBest) {
  test::NormalDraw draw(1);
  const AccelerometerPrior prior{Accelerometer{}};
  for (int trial = 0; trial < 100; ++trial) {
    for (const std::size_t poses : {3U, 6U, 20U}) {
      const Cell cell(poses, draw);
      const OwnAttitude own = findAttitude(prior, cell.readings, cell.f_o, cell.R * expSO3(0.1 * draw.vector()), 50);
      EXPECT_LT((own.R.transpose() * own.R - Eigen::Matrix3d::Identity()).norm(), 1e-13);
      const double least = cell.chiSquaredAt(own.R);
      // What is left is the difference of sums that are up to some ten thousand.
      EXPECT_NEAR(testRigidity(prior, cell.readings, cell.forcesIn(own.R)).chi_squared, least, 1e-8 * (1 + least));
      for (int axis = 0; axis < 3; ++axis) {
        const Eigen::Vector3d turn = 1e-3 * Eigen::Vector3d::Unit(axis);
        const double rise = cell.chiSquaredAt(own.R * expSO3(turn)) + cell.chiSquaredAt(own.R * expSO3(-turn));
        EXPECT_NEAR(rise / 2 - least, turn.dot(own.information * turn), 1e-2 * turn.dot(own.information * turn) + 1e-6);
        EXPECT_GT(cell.chiSquaredAt(own.R * expSO3(turn)), least);
      }
    }
  }
}

TEST(FindAttitude, StaysWhereTheReadingsShowNothing) {
  test::NormalDraw draw(2);
  Cell cell(1, draw);
  const Eigen::Vector3d up = cell.R.transpose() * cell.f_o.front();
  const OwnAttitude own = findAttitude(AccelerometerPrior{Accelerometer{}}, cell.readings, cell.f_o, cell.R);
  EXPECT_NEAR(up.dot(logSO3(cell.R.transpose() * own.R)), 0, 1e-3);
  EXPECT_NEAR(up.dot(own.information * up), 0, 1e-6 * own.information.norm());
}

}  // namespace
}  // namespace hexoderm
