#include "hexoderm/solve/faults/sensor_turn.h"

#include "hexoderm/base/se3.h"
#include "hexoderm/base/units.h"

#include <Eigen/LU>
#include <array>

namespace hexoderm {

std::vector<SensorTurn> possibleSensorTurns() {
  std::vector<SensorTurn> turns;
  constexpr std::array<std::array<int, 3>, 6> kOrders = {
      {{0, 1, 2}, {1, 0, 2}, {0, 2, 1}, {2, 1, 0}, {1, 2, 0}, {2, 0, 1}}};
  for (const std::array<int, 3>& order : kOrders) {
    for (unsigned signs = 0; signs < 8; ++signs) {
      Eigen::Matrix3d M = Eigen::Matrix3d::Zero();
      for (int row = 0; row < 3; ++row) {
        M(row, order.at(static_cast<std::size_t>(row))) = ((signs >> static_cast<unsigned>(row)) & 1U) != 0 ? -1 : 1;
      }
      const double sign = M.determinant();
      if (!M.isIdentity()) turns.push_back({sign * M, sign});
    }
  }
  for (const double angle : {60, 120, 240, 300}) {
    turns.push_back({expSO3(angle * kDegree * Eigen::Vector3d::UnitZ()), 1});
  }
  return turns;
}

Message turnText(const SensorTurn& turn) {
  const std::array axes = {message("x"), message("y"), message("z")};
  if (turn.sign < 0) {
    const Eigen::Matrix3d M = turn.matrix();
    if (M.isApprox(-Eigen::Matrix3d::Identity())) return message("mirrored along x, y and z");
    for (Eigen::Index axis = 0; axis < 3; ++axis) {
      Eigen::Vector3d diagonal = Eigen::Vector3d::Ones();
      diagonal[axis] = -1;
      if (M.isApprox(Eigen::Matrix3d(diagonal.asDiagonal()))) {
        return message("mirrored along {}", axes.at(static_cast<std::size_t>(axis)));
      }
    }
    for (Eigen::Index axis = 0; axis < 3; ++axis) {
      const auto first = static_cast<std::size_t>(axis == 0 ? 1 : 0);
      const auto second = static_cast<std::size_t>(axis == 2 ? 1 : 2);
      Eigen::Matrix3d exchange = Eigen::Matrix3d::Identity();
      exchange.row(static_cast<Eigen::Index>(first)).swap(exchange.row(static_cast<Eigen::Index>(second)));
      if (M.isApprox(exchange)) return message("mirrored, {} and {} exchanged", axes.at(first), axes.at(second));
    }
    return message("mirrored, with axes exchanged");
  }
  const Eigen::Vector3d w = logSO3(turn.R);
  const Number degrees{toDegrees(w.norm()), 0};
  Eigen::Index axis = 0;
  if (w.cwiseAbs().maxCoeff(&axis) < 0.99 * w.norm()) return message("turned by {} degrees, axes exchanged", degrees);
  return message("turned by {} degrees about {}", degrees, axes.at(static_cast<std::size_t>(axis)));
}

}  // namespace hexoderm
