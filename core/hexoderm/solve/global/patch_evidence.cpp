#include "hexoderm/solve/global/patch_evidence.h"

#include "hexoderm/base/error.h"
#include "hexoderm/base/units.h"

#include <Eigen/Cholesky>

namespace hexoderm {
namespace {

/// The same patch with sensors that are known to have no errors, neither their own nor the lot's, and read just that,
/// each as precise as `sensors` has it: its equations are J^T W J + K.
GlobalProblem withPerfectSensors(const GlobalProblem& problem, std::span<const SensorState> sensors,
                                 const CellModel& perfect) {
  GlobalProblem with = problem;
  with.model = &perfect;
  with.with_mounting = false;
  for (std::size_t cell = 0; cell < with.cellCount(); ++cell) {
    for (std::size_t k = 0; k < with.readings[cell].size(); ++k) {
      with.readings[cell][k].y_g = sensors[cell].v_g[k];
      with.readings[cell][k].variance_g2 = 1 / sensors[cell].fit.precision[k];
    }
  }
  return with;
}

/// B^T W B of a cell's readings, the same for all axes, and J^T W B, a row per unknown.
class CellRows {
 public:
  CellRows(const GlobalProblem& problem, const GlobalState& state, std::size_t cell, const SensorState& sensor,
           Eigen::Ref<Eigen::MatrixXd> mixed) {
    const SE3& T_o_u = state.cells[cell];
    const Eigen::Matrix3d R_a_o = problem.model->accelerometer.T_u_a.R.transpose() * T_o_u.R.transpose();
    const Eigen::Matrix3d R_a_u = problem.model->accelerometer.T_u_a.R.transpose();
    const Eigen::Vector3d lever = T_o_u.t - state.middle_o;
    const BorderLayout layout(problem);
    const auto border = static_cast<Eigen::Index>(6 * problem.cellCount());
    const auto at = static_cast<Eigen::Index>(6 * cell);
    for (std::size_t k = 0; k < problem.readings[cell].size(); ++k) {
      const std::size_t pose = problem.readings[cell][k].pose;
      const double precision = sensor.fit.precision[k];
      const Eigen::Vector3d& v = sensor.v_g[k];
      const Eigen::Vector4d row(1, v.x(), v.y(), v.z());
      rows_.noalias() += precision * row * row.transpose();
      // Of y - v: the force in the cell is R^T f, with f + a x lever / g where the part swings.
      const auto add = [&](Eigen::Index unknown, const Eigen::Matrix3d& J) {
        for (Eigen::Index axis = 0; axis < 3; ++axis) {
          mixed.block<3, 4>(unknown, 4 * axis).noalias() += precision * J.row(axis).transpose() * row.transpose();
        }
      };
      add(border + layout.force(pose), -R_a_o);
      if (problem.accelerations) add(border + layout.acceleration(pose), R_a_o * skew(lever) / kStandardGravity);
      if (cell == problem.origin) continue;
      const Eigen::Vector3d force_o = specificForce(problem, state, cell, pose);
      add(at + 3, -R_a_u * skew(T_o_u.R.transpose() * force_o));
      if (problem.accelerations) add(at, -R_a_o * skew(state.acceleration_o[pose]) / kStandardGravity);
    }
  }

  [[nodiscard]] const Eigen::Matrix4d& rows() const { return rows_; }

 private:
  Eigen::Matrix4d rows_ = Eigen::Matrix4d::Zero();
};

}  // namespace

SensorEvidence evidenceOfPatch(const GlobalProblem& problem, const GlobalState& state,
                               std::span<const SensorState> sensors) {
  std::vector<std::size_t> measured;
  for (std::size_t cell = 0; cell < problem.cellCount(); ++cell) {
    if (!problem.readings[cell].empty()) measured.push_back(cell);
  }
  CellModel perfect = *problem.model;
  Accelerometer& sensor = perfect.accelerometer;
  sensor.offset_sigma_g.setZero();
  sensor.scale_sigma = sensor.cross_axis_sigma = 0;
  sensor.offset_shared_sigma_g = sensor.scale_shared_sigma = 0;
  const SensorLot& lot = state.lot;
  const GlobalProblem with_perfect = withPerfectSensors(problem, sensors, perfect);
  GlobalState without_lot = state;
  without_lot.lot = {};
  NormalEquations equations;
  linearize(with_perfect, without_lot, equations);
  const Eigen::LLT<Eigen::MatrixXd> factor(denseMatrix(with_perfect, equations));
  if (factor.info() != Eigen::Success) throw Error("the information matrix is not positive definite");

  const auto parameters = static_cast<Eigen::Index>(measured.size()) * kSensorParameters;
  Eigen::MatrixXd mixed = Eigen::MatrixXd::Zero(factor.rows(), parameters);
  SensorEvidence evidence{Eigen::MatrixXd::Zero(parameters, parameters), Eigen::VectorXd::Zero(parameters)};
  Eigen::VectorXd errors(parameters);  // a sensor's own and the lot's
  Eigen::VectorXd own(parameters);
  for (std::size_t k = 0; k < measured.size(); ++k) {
    const Eigen::Index at = static_cast<Eigen::Index>(k) * kSensorParameters;
    const SensorState& seen = sensors[measured[k]];
    const CellRows cell(with_perfect, state, measured[k], seen, mixed.middleCols(at, kSensorParameters));
    for (Eigen::Index axis = 0; axis < 3; ++axis) {
      evidence.information.block<4, 4>(at + 4 * axis, at + 4 * axis) = cell.rows();
      const Eigen::Vector3d gain = seen.fit.gain.row(axis);
      own[at + 4 * axis] = seen.fit.offset_g[axis];
      own.segment<3>(at + 4 * axis + 1) = gain - Eigen::Vector3d::Unit(axis);
      errors[at + 4 * axis] = lot.offset_g[axis] + seen.fit.offset_g[axis];
      errors.segment<3>(at + 4 * axis + 1) = gain + (lot.scale - 2) * Eigen::Vector3d::Unit(axis);
    }
  }
  factor.matrixL().solveInPlace(mixed);
  evidence.information.noalias() -= mixed.transpose() * mixed;
  const AccelerometerPrior prior = priorOfChips(problem, state);
  evidence.weighted = evidence.information * errors;
  for (Eigen::Index k = 0; k < parameters; ++k) {
    const auto axis = static_cast<int>((k % kSensorParameters) / 4);
    evidence.weighted[k] += prior.precision(axis)[k % 4] * own[k];
  }
  return evidence;
}

}  // namespace hexoderm
