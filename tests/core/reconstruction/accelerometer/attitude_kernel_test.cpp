#include "hexoderm/reconstruction/accelerometer/attitude_kernel.h"

#include "hexoderm/geometry/se3.h"
#include "hexoderm/reconstruction/accelerometer/rigidity.h"

#include <gmock/gmock.h>

#include <random>

namespace hexoderm {
namespace {

using Kernel = void (*)(const AttitudeKernelOptions&, const OwnAttitudeKernelInput&, OwnAttitudeKernelOutput&);

/// kLanes cells whose sensors err, and starts that are some degrees off. Lane l lacks the reading of pose l, but for
/// the last.
struct Cells {
  std::size_t poses = 0;
  std::vector<double> f_o;
  std::vector<double> y_g;
  std::vector<double> precision;
  std::vector<double> R_start;
  std::array<std::vector<CellReading>, kLanes> readings;
  std::array<std::vector<Eigen::Vector3d>, kLanes> forces;
  std::array<Eigen::Matrix3d, kLanes> start;

  [[nodiscard]] OwnAttitudeKernelInput input() const {
    return {static_cast<int>(poses), f_o.data(), y_g.data(), precision.data(), R_start.data()};
  }
};

Cells drawCells(std::size_t poses, std::mt19937& random) {
  std::normal_distribution<double> normal;
  const auto draw = [&](double sigma) -> Eigen::Vector3d {
    return Eigen::Vector3d::NullaryExpr([&] { return sigma * normal(random); });
  };
  Cells cells;
  cells.poses = poses;
  cells.f_o.assign(3 * kLanes * poses, 0);
  cells.y_g.assign(3 * kLanes * poses, 0);
  cells.precision.assign(kLanes * poses, 0);
  cells.R_start.assign(9 * kLanes, 0);
  std::vector<Eigen::Vector3d> up;
  // Directions that are clearly different: else the search takes more steps than it is given.
  while (up.size() < poses) {
    const Eigen::Vector3d next = draw(1).normalized();
    if (up.size() != 1 || up.front().cross(next).norm() > 0.5) up.push_back(next);
  }
  for (std::size_t lane = 0; lane < kLanes; ++lane) {
    const Eigen::Matrix3d R = expSO3(draw(1));
    cells.start[lane] = R * expSO3(draw(0.1));
    for (std::size_t k = 0; k < 9; ++k) {
      cells.R_start[kLanes * k + lane] =
          cells.start[lane](static_cast<Eigen::Index>(k / 3), static_cast<Eigen::Index>(k % 3));
    }
    const Eigen::Vector3d offset = draw(0.06);
    for (std::size_t pose = 0; pose < poses; ++pose) {
      if (pose == lane && poses > kLanes) continue;
      const double variance = 2e-5 * static_cast<double>(1 + lane + pose);
      const Eigen::Vector3d y = R.transpose() * up[pose] + offset + draw(0.005);
      cells.readings[lane].push_back({pose, y, variance});
      cells.forces[lane].push_back(up[pose]);
      cells.precision[kLanes * pose + lane] = 1 / variance;
      for (std::size_t axis = 0; axis < 3; ++axis) {
        const std::size_t at = kLanes * (3 * pose + axis) + lane;
        cells.f_o[at] = up[pose][static_cast<Eigen::Index>(axis)];
        cells.y_g[at] = y[static_cast<Eigen::Index>(axis)];
      }
    }
  }
  return cells;
}

Eigen::Matrix3d attitudeIn(const OwnAttitudeKernelOutput& out, std::size_t lane) {
  return Eigen::Matrix3d::NullaryExpr([&](Eigen::Index row, Eigen::Index column) {
    return out.R[kLanes * static_cast<std::size_t>(3 * row + column) + lane];
  });
}

TEST(AttitudeKernel, FindsWhatIsFoundCellByCell) {
  std::mt19937 random(1);
  const AccelerometerPrior prior{Accelerometer{}};
  const AttitudeKernelOptions options = attitudeKernelOptions(prior);
  int usual = 0;
  for (int trial = 0; trial < 100; ++trial) {
    for (const std::size_t poses : {2UL, 3UL, 6UL, 20UL}) {
      const Cells cells = drawCells(poses, random);
      OwnAttitudeKernelOutput one{};
      findAttitudesByOne(options, cells.input(), one);
      OwnAttitudeKernelOutput four = one;
      if (hasFourLanes()) findAttitudesByFour(options, cells.input(), four);
      for (std::size_t lane = 0; lane < kLanes; ++lane) {
        EXPECT_EQ(four.usual[lane], one.usual[lane]);
        if (one.usual[lane] == 0) continue;
        ++usual;
        const OwnAttitude expected = findAttitude(prior, cells.readings[lane], cells.forces[lane], cells.start[lane]);
        const Eigen::Matrix3d R = attitudeIn(one, lane);
        EXPECT_LT((R.transpose() * R - Eigen::Matrix3d::Identity()).norm(), 1e-13);
        // Both stop once a step is small: by 1e-7 rad, and a step of two poses leaves a hundredth of the error.
        EXPECT_LT(logSO3(expected.R.transpose() * R).norm(), 1e-7);
        EXPECT_LT(logSO3(R.transpose() * attitudeIn(four, lane)).norm(), 1e-9);
        Eigen::Index at = 0;
        for (Eigen::Index i = 0; i < 3; ++i) {
          EXPECT_NEAR(one.offset_g[kLanes * i + static_cast<Eigen::Index>(lane)], expected.offset_g[i], 1e-6);
          for (Eigen::Index j = 0; j < 3; ++j) {
            EXPECT_NEAR(one.gain[kLanes * (3 * i + j) + static_cast<Eigen::Index>(lane)], expected.gain(i, j), 1e-6);
          }
          for (Eigen::Index j = i; j < 3; ++j, ++at) {
            EXPECT_NEAR(one.information[kLanes * at + static_cast<Eigen::Index>(lane)], expected.information(i, j),
                        1e-5 * expected.information.norm());
          }
        }
      }
    }
  }
  EXPECT_GT(usual, 100 * 4 * kLanes * 9 / 10);
}

TEST(AttitudeKernel, LeavesCellsWithASingleDirectionToTheCarefulWay) {
  std::mt19937 random(2);
  Cells cells = drawCells(3, random);
  for (const std::size_t pose : {1UL, 2UL}) cells.precision[kLanes * pose + 2] = 0;
  const AttitudeKernelOptions options = attitudeKernelOptions(AccelerometerPrior{Accelerometer{}});
  for (const Kernel kernel :
       {Kernel{findAttitudesByOne}, Kernel{hasFourLanes() ? findAttitudesByFour : findAttitudesByOne}}) {
    OwnAttitudeKernelOutput out{};
    kernel(options, cells.input(), out);
    for (std::size_t lane = 0; lane < kLanes; ++lane) EXPECT_EQ(out.usual[lane], lane == 2 ? 0 : 1) << lane;
  }
}

}  // namespace
}  // namespace hexoderm
