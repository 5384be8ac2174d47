#pragma once

#include "hexoderm/solve/global/global_system.h"

#include <Eigen/Core>
#include <cstddef>
#include <vector>

namespace hexoderm::poses_first {

inline constexpr Eigen::Index kSensor = 12;  // offset and gains of an accelerometer: per axis (b_i, D_i)

using SensorByForce = Eigen::Matrix<double, kSensor, 3>;

/// A cell with readings.
struct MeasuredCell {
  std::size_t cell = 0;
  bool moves = true;            ///< false for the origin
  Eigen::Matrix3d G;            ///< d residual / d force
  Eigen::Matrix4d T;            ///< r = T (1, f)
  SensorByForce K;              ///< change of (b, D) that makes up for a turn of the cell
  Eigen::Matrix4d information;  ///< sum of w r r^T
};

/// The second-order model: links and the gap share as in NormalEquations, readings by their parts.
struct Equations {
  NormalEquations rest;  ///< of the border nothing but the gap share; its gradients are complete
  std::vector<MeasuredCell> measured;
  Eigen::MatrixXd precision;                      ///< w, per measured cell and pose; 0 without a reading
  std::vector<Eigen::Vector4d> phi;               ///< per pose
  std::vector<Eigen::Matrix3d> pose_information;  ///< H_p
  Eigen::VectorXd gradient_poses;
  // Diagonals of the matrix after the sensors' elimination, of which damping adds a share.
  Eigen::VectorXd diagonal_cells;
  Eigen::VectorXd diagonal_poses;
};

/// The model at a state, with the sensors' errors that fit it best.
Equations linearize(const GlobalProblem& problem, const GlobalState& state);

}  // namespace hexoderm::poses_first
