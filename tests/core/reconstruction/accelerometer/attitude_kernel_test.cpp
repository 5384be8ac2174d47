#include "hexoderm/reconstruction/accelerometer/attitude_kernel.h"
#include "tests/core/reconstruction/accelerometer/lanes.h"

#include "hexoderm/geometry/se3.h"
#include "hexoderm/reconstruction/accelerometer/rigidity.h"
#include "hexoderm/util/vector_instructions.h"

#include <gmock/gmock.h>

#include <random>

namespace hexoderm {
namespace {

using Kernel = void (*)(const AttitudeKernelOptions&, const OwnAttitudeKernelInput&, OwnAttitudeKernelOutput&);

/// kLanes cells whose sensors err, and starts that are some degrees off. Lane l lacks the reading of pose l, but for
/// the last.
struct Cells {
  Lanes f_o;
  Lanes y_g;
  Lanes precision;
  Lanes R_start;
  std::array<std::vector<CellReading>, kLanes> readings;
  std::array<std::vector<Eigen::Vector3d>, kLanes> forces;
  std::array<Eigen::Matrix3d, kLanes> start;

  [[nodiscard]] OwnAttitudeKernelInput input() const {
    return {static_cast<int>(precision.rows()), f_o.data(), y_g.data(), precision.data(), R_start.data()};
  }
};

Cells drawCells(Eigen::Index poses, std::mt19937& random) {
  std::normal_distribution<double> normal;
  const auto draw = [&](double sigma) -> Eigen::Vector3d {
    return Eigen::Vector3d::NullaryExpr([&] { return sigma * normal(random); });
  };
  Cells cells;
  cells.f_o.setZero(3 * poses, kLanes);
  cells.y_g.setZero(3 * poses, kLanes);
  cells.precision.setZero(poses, kLanes);
  cells.R_start.resize(9, kLanes);
  std::vector<Eigen::Vector3d> up;
  // Directions that are clearly different: else the search takes more steps than it is given.
  while (up.size() < static_cast<std::size_t>(poses)) {
    const Eigen::Vector3d next = draw(1).normalized();
    if (up.size() != 1 || up.front().cross(next).norm() > 0.5) up.push_back(next);
  }
  for (Eigen::Index lane = 0; lane < kLanes; ++lane) {
    const auto l = static_cast<std::size_t>(lane);
    const Eigen::Matrix3d R = expSO3(draw(1));
    cells.start[l] = R * expSO3(draw(0.1));
    cells.R_start.col(lane) = columnOf(cells.start[l]);
    const Eigen::Vector3d offset = draw(0.06);
    for (Eigen::Index pose = 0; pose < poses; ++pose) {
      if (pose == lane && poses > kLanes) continue;
      const auto p = static_cast<std::size_t>(pose);
      const double variance = 2e-5 * static_cast<double>(1 + lane + pose);
      const Eigen::Vector3d y = R.transpose() * up[p] + offset + draw(0.005);
      cells.readings[l].push_back({p, y, variance});
      cells.forces[l].push_back(up[p]);
      cells.precision(pose, lane) = 1 / variance;
      cells.f_o.col(lane).segment<3>(3 * pose) = up[p];
      cells.y_g.col(lane).segment<3>(3 * pose) = y;
    }
  }
  return cells;
}

TEST(AttitudeKernel, FindsWhatIsFoundCellByCell) {
  std::mt19937 random(1);
  const AccelerometerPrior prior{Accelerometer{}};
  const AttitudeKernelOptions options = attitudeKernelOptions(prior);
  int usual = 0;
  for (int trial = 0; trial < 100; ++trial) {
    for (const int poses : {2, 3, 6, 20}) {
      const Cells cells = drawCells(poses, random);
      OwnAttitudeKernelOutput one{};
      findAttitudesByTwo(options, cells.input(), one);
      OwnAttitudeKernelOutput four = one;
      if (hasVectorInstructions()) findAttitudesByFour(options, cells.input(), four);
      for (int lane = 0; lane < kLanes; ++lane) {
        EXPECT_EQ(four.usual[lane], one.usual[lane]);
        if (one.usual[lane] == 0) continue;
        ++usual;
        const auto l = static_cast<std::size_t>(lane);
        const OwnAttitude expected = findAttitude(prior, cells.readings[l], cells.forces[l], cells.start[l]);
        const Eigen::Matrix3d R = matrixIn(one.R, lane);
        EXPECT_LT((R.transpose() * R - Eigen::Matrix3d::Identity()).norm(), 1e-13);
        // Both stop once a step is small: by 1e-7 rad, and a step of two poses leaves a hundredth of the error.
        EXPECT_LT(logSO3(expected.R.transpose() * R).norm(), 1e-7);
        EXPECT_LT(logSO3(R.transpose() * matrixIn(four.R, lane)).norm(), 1e-9);
        EXPECT_LE((laneOf(one.offset_g, lane) - expected.offset_g).cwiseAbs().maxCoeff(), 1e-6);
        EXPECT_LE((matrixIn(one.gain, lane) - expected.gain).cwiseAbs().maxCoeff(), 1e-6);
        const Eigen::Matrix3d& M = expected.information;
        const Eigen::Matrix<double, 6, 1> upper{M(0, 0), M(0, 1), M(0, 2), M(1, 1), M(1, 2), M(2, 2)};
        EXPECT_LE((laneOf(one.information, lane) - upper).cwiseAbs().maxCoeff(), 1e-5 * M.norm());
      }
    }
  }
  EXPECT_GT(usual, 100 * 4 * kLanes * 9 / 10);
}

TEST(AttitudeKernel, LeavesCellsWithASingleDirectionToTheCarefulWay) {
  std::mt19937 random(2);
  Cells cells = drawCells(3, random);
  cells.precision.col(2).tail<2>().setZero();
  const AttitudeKernelOptions options = attitudeKernelOptions(AccelerometerPrior{Accelerometer{}});
  for (const Kernel kernel :
       {Kernel{findAttitudesByTwo}, Kernel{hasVectorInstructions() ? findAttitudesByFour : findAttitudesByTwo}}) {
    OwnAttitudeKernelOutput out{};
    kernel(options, cells.input(), out);
    for (int lane = 0; lane < kLanes; ++lane) EXPECT_EQ(out.usual[lane], lane == 2 ? 0 : 1) << lane;
  }
}

}  // namespace
}  // namespace hexoderm
