#include "hexoderm/solve/global/attitude_kernel.h"
#include "hexoderm/base/lane_numbers.h"

#include "hexoderm/base/se3.h"
#include "hexoderm/base/vector_instructions.h"
#include "hexoderm/solve/global/rigidity.h"
#include "tests/support/testing.h"

namespace hexoderm {
namespace {

using Kernel = void (*)(const AttitudeKernelOptions&, const OwnAttitudeKernelInput&, OwnAttitudeKernelOutput&);

/// kLanes cells whose sensors err, and starts that are some degrees off. Lane l lacks the reading of pose l, but for
/// the last.
struct Cells {
  std::vector<double> f_o;
  std::vector<double> y_g;
  std::vector<double> precision;
  std::vector<double> R_start = std::vector<double>(9 * kLanes);
  std::array<std::vector<CellReading>, kLanes> readings;
  std::array<std::vector<Eigen::Vector3d>, kLanes> forces;
  std::array<Eigen::Matrix3d, kLanes> start;

  [[nodiscard]] OwnAttitudeKernelInput input() const {
    return {static_cast<int>(precision.size() / kLanes), f_o.data(), y_g.data(), precision.data(), R_start.data()};
  }
};

Cells drawCells(std::size_t poses, std::mt19937& random) {
  std::normal_distribution<double> normal;
  const auto draw = [&](double sigma) -> Eigen::Vector3d {
    return Eigen::Vector3d::NullaryExpr([&] { return sigma * normal(random); });
  };
  Cells cells;
  cells.f_o.resize(3 * kLanes * poses);
  cells.y_g.resize(3 * kLanes * poses);
  cells.precision.resize(kLanes * poses);
  std::vector<Eigen::Vector3d> up;
  // Directions that are clearly different: else the search takes more steps than it is given.
  while (up.size() < poses) {
    const Eigen::Vector3d next = draw(1).normalized();
    if (up.size() != 1 || up.front().cross(next).norm() > 0.5) up.push_back(next);
  }
  for (std::size_t lane = 0; lane < kLanes; ++lane) {
    const Eigen::Matrix3d R = expSO3(draw(1));
    cells.start[lane] = R * expSO3(draw(0.1));
    matrixOfLane(cells.R_start.data(), lane) = cells.start[lane];
    const Eigen::Vector3d offset = draw(0.06);
    for (std::size_t pose = 0; pose < poses; ++pose) {
      if (pose == lane && poses > kLanes) continue;
      const double variance = 2e-5 * static_cast<double>(1 + lane + pose);
      const Eigen::Vector3d y = R.transpose() * up[pose] + offset + draw(0.005);
      cells.readings[lane].push_back({pose, y, variance});
      cells.forces[lane].push_back(up[pose]);
      cells.precision[kLanes * pose + lane] = 1 / variance;
      vectorOfLane(&cells.f_o[3 * kLanes * pose], lane) = up[pose];
      vectorOfLane(&cells.y_g[3 * kLanes * pose], lane) = y;
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
    for (const std::size_t poses : {2U, 3U, 6U, 20U}) {
      const Cells cells = drawCells(poses, random);
      OwnAttitudeKernelOutput one{};
      findAttitudesByTwo(options, cells.input(), one);
      OwnAttitudeKernelOutput four = one;
      if (hasVectorInstructions()) findAttitudesByFour(options, cells.input(), four);
      for (std::size_t lane = 0; lane < kLanes; ++lane) {
        EXPECT_EQ(four.usual[lane], one.usual[lane]);
        if (one.usual[lane] == 0) continue;
        ++usual;
        const OwnAttitude expected = findAttitude(prior, cells.readings[lane], cells.forces[lane], cells.start[lane]);
        const Eigen::Matrix3d R = matrixOfLane(one.R, lane);
        EXPECT_LT((R.transpose() * R - Eigen::Matrix3d::Identity()).norm(), 1e-13);
        EXPECT_LT(logSO3(expected.R.transpose() * R).norm(), 1e-7);
        EXPECT_LT(logSO3(R.transpose() * Eigen::Matrix3d(matrixOfLane(four.R, lane))).norm(), 1e-9);
        EXPECT_LE((vectorOfLane(one.offset_g, lane) - expected.offset_g).cwiseAbs().maxCoeff(), 1e-6);
        EXPECT_LE((matrixOfLane(one.gain, lane) - expected.gain).cwiseAbs().maxCoeff(), 1e-6);
        const Eigen::Matrix3d& M = expected.information;
        EXPECT_LE((symmetricOfLane(one.information, lane) - M).cwiseAbs().maxCoeff(), 1e-5 * M.norm());
      }
    }
  }
  EXPECT_GT(usual, 100 * 4 * kLanes * 9 / 10);
}

TEST(AttitudeKernel, LeavesCellsWithASingleDirectionToTheCarefulWay) {
  std::mt19937 random(2);
  Cells cells = drawCells(3, random);
  for (const std::size_t pose : {1U, 2U}) cells.precision[kLanes * pose + 2] = 0;
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
