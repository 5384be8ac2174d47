#include "hexoderm/solve/global/poses_first_equations.h"

#include <algorithm>

namespace hexoderm::poses_first {

using Eigen::Index;

namespace {

class Linearizer {
 public:
  Linearizer(const GlobalProblem& problem, const GlobalState& state, Equations& equations)
      : problem_(problem),
        state_(state),
        equations_(equations),
        prior_(problem.model->accelerometer),
        R_a_u_(problem.model->accelerometer.T_u_a.R.transpose()) {}

  void run() {
    startEquations(problem_, state_, problem_.gap.sigma ? 1 : 0, equations_.rest);
    equations_.phi.resize(problem_.poses);
    equations_.pose_information.assign(problem_.poses, Eigen::Matrix3d::Zero());
    equations_.gradient_poses.setZero(static_cast<Index>(3 * problem_.poses));
    for (std::size_t pose = 0; pose < problem_.poses; ++pose) {
      equations_.phi[pose] << 1, state_.force_o[pose];
      addForcePrior(problem_, state_.force_o[pose], equations_.pose_information[pose],
                    equations_.gradient_poses.segment<3>(static_cast<Index>(3 * pose)));
    }
    equations_.diagonal_poses.setZero(equations_.gradient_poses.size());
    equations_.diagonal_cells.setZero(equations_.rest.gradient_cells.size());
    equations_.measured.clear();
    const auto measured =
        std::ranges::count_if(problem_.readings, [](const auto& readings) { return !readings.empty(); });
    equations_.precision.setZero(measured, static_cast<Index>(problem_.poses));
    for (std::size_t cell = 0; cell < problem_.cellCount(); ++cell) add(cell);
    for (std::size_t pose = 0; pose < problem_.poses; ++pose) {
      equations_.diagonal_poses.segment<3>(static_cast<Index>(3 * pose)) +=
          equations_.pose_information[pose].diagonal();
    }
    addLinks(problem_, state_, 0, equations_.rest);
    for (std::size_t cell = 0; cell < problem_.cellCount(); ++cell) {
      equations_.diagonal_cells.segment<6>(static_cast<Index>(6 * cell)) += equations_.rest.cells[cell].diagonal();
    }
  }

 private:
  void add(std::size_t cell) {
    const std::vector<CellReading>& readings = problem_.readings[cell];
    if (readings.empty()) return;
    fitCell(problem_, prior_, state_, cell, sensor_);
    const AccelerometerFit& fit = sensor_.fit;
    equations_.rest.cost += fit.cost;

    const auto part = static_cast<Index>(equations_.measured.size());
    MeasuredCell& measured = equations_.measured.emplace_back();
    const Eigen::Matrix3d R_a_o = R_a_u_ * state_.cells[cell].R.transpose();
    measured.cell = cell;
    measured.moves = cell != problem_.origin;
    measured.G = -fit.gain * R_a_o;
    measured.T.setIdentity();
    measured.T.bottomRightCorner<3, 3>() = R_a_o;
    measured.K.setZero();
    for (int axis = 0; axis < 3 && measured.moves; ++axis) {
      measured.K.middleRows<3>(4 * axis + 1) = -skew(fit.gain.row(axis).transpose()) * R_a_u_;
    }
    measured.information.setZero();

    Eigen::Vector3d turning = Eigen::Vector3d::Zero();
    for (std::size_t k = 0; k < readings.size(); ++k) {
      const std::size_t pose = readings[k].pose;
      const double precision = fit.precision[k];
      const Eigen::Vector3d weighted = precision * fit.residual_g[k];
      const Eigen::Vector4d r = measured.T * equations_.phi[pose];
      equations_.precision(part, static_cast<Index>(pose)) = precision;
      measured.information.noalias() += precision * r * r.transpose();
      turning += sensor_.v_g[k].cross(fit.gain.transpose() * weighted);
      equations_.pose_information[pose].noalias() += precision * measured.G.transpose() * measured.G;
      equations_.gradient_poses.segment<3>(static_cast<Index>(3 * pose)).noalias() += measured.G.transpose() * weighted;
      for (std::size_t axis = 0; axis < 3; ++axis) {
        const double explained = precision * precision * (fit.covariance_root[axis].transpose() * r).squaredNorm();
        equations_.diagonal_poses.segment<3>(static_cast<Index>(3 * pose)) -=
            explained * measured.G.row(static_cast<Index>(axis)).transpose().cwiseAbs2();
      }
    }
    if (measured.moves) {
      const auto at = static_cast<Index>(6 * cell + 3);
      equations_.rest.gradient_cells.segment<3>(at) += R_a_u_.transpose() * turning;
      for (std::size_t axis = 0; axis < 3; ++axis) {
        const Eigen::Matrix<double, 4, 3> K = measured.K.middleRows<4>(static_cast<Index>(4 * axis));
        const Eigen::Matrix<double, 4, 3> mixed = measured.information * K;
        const Eigen::Matrix<double, 4, 3> root = fit.covariance_root[axis].transpose() * mixed;
        equations_.diagonal_cells.segment<3>(at) +=
            (K.cwiseProduct(mixed) - root.cwiseProduct(root)).colwise().sum().transpose();
      }
    }
  }

  const GlobalProblem& problem_;
  const GlobalState& state_;
  Equations& equations_;
  AccelerometerPrior prior_;
  Eigen::Matrix3d R_a_u_;
  SensorState sensor_;
};

}  // namespace

Equations linearize(const GlobalProblem& problem, const GlobalState& state) {
  Equations equations;
  Linearizer(problem, state, equations).run();
  return equations;
}

}  // namespace hexoderm::poses_first
