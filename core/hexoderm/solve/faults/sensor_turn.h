#pragma once

#include "hexoderm/base/message.h"

#include <Eigen/Core>
#include <vector>

namespace hexoderm {

/// How the accelerometers of some cells are turned against the others: they read sign * R f of a specific force f, cell
/// frame.
struct SensorTurn {
  Eigen::Matrix3d R = Eigen::Matrix3d::Identity();
  double sign = 1;  ///< -1: reflected

  [[nodiscard]] Eigen::Matrix3d matrix() const { return sign * R; }
  [[nodiscard]] SensorTurn inverse() const { return {R.transpose(), sign}; }
  [[nodiscard]] bool isAboutZ() const { return R(2, 2) > 0.9; }
  [[nodiscard]] bool isHalfTurn() const { return R.trace() < -0.9; }
};

/// All ways to exchange and negate axes but none at all (47), and the turns about z by one or two sides of a cell.
std::vector<SensorTurn> possibleSensorTurns();

/// "turned by 180 degrees about y", "mirrored along x".
Message turnText(const SensorTurn& turn);

}  // namespace hexoderm
