#include "hexoderm/reconstruction/joint/joint_cost.h"

#include "hexoderm/reconstruction/joint/linearize_lanes.h"
#include "hexoderm/util/units.h"

#include <algorithm>
#include <cmath>

namespace hexoderm {
namespace {

using Matrix3x6d = Eigen::Matrix<double, 3, 6>;

bool linksBend(const JointProblem& problem) { return problem.gap.sigma.has_value() || problem.gap.mean != 0; }

/// The distance between the end points of a link, less the arc's share.
Eigen::Vector3d openingOf_m(const JointProblem& problem, const JointState& state, const JointLink& link) {
  const SE3& T_c = state.cells[link.c];
  const SE3& T_n = state.cells[link.n];
  const Eigen::Vector3d opening_m = T_n * link.p_n - T_c * link.p_c;
  if (!linksBend(problem)) return opening_m;
  const double e_m = (link.p_c.norm() + link.p_n.norm()) / 2;
  return opening_m - state.gap_share * arcOpening_m(T_c.R * link.p_c.normalized(), T_n.R * link.p_n.normalized(), e_m);
}

/// Twice the cost of one link.
double twiceCostOf(const JointProblem& problem, const JointState& state, const JointLink& link) {
  const CellModel& model = *problem.model;
  const Eigen::Vector3d u_c = link.p_c.normalized();
  const Eigen::Matrix3d R_c_n = state.cells[link.c].R.transpose() * state.cells[link.n].R;
  const Eigen::Vector3d w = logSO3(R_c_n * link.R_nom.transpose());
  const Eigen::Vector3d elastomer(w.dot(u_c) / model.twist_sigma_rad,
                                  w.dot(Eigen::Vector3d::UnitZ().cross(u_c)) / model.bend_sigma_rad,
                                  w.z() / model.yaw_sigma_rad);
  const Eigen::Vector3d closure = openingOf_m(problem, state, link) / problem.link_sigma_m;
  return problem.loss.cost(closure.squaredNorm()) + problem.loss.cost(elastomer.squaredNorm());
}

/// Adds what one cell's readings say.
class CellLinearizer {
 public:
  CellLinearizer(const JointProblem& problem, const JointState& state, NormalEquations& equations)
      : problem_(problem),
        state_(state),
        equations_(equations),
        layout_(problem),
        prior_(problem.model->accelerometer),
        R_a_u_(problem.model->accelerometer.T_u_a.R.transpose()) {
    border_root_.resize(12, layout_.size());
    pending_.resize(12 * kBatch, layout_.size());
  }

  /// Must be called after the last cell: the border is complete then.
  void finish() {
    subtractPending();
    equations_.border.triangularView<Eigen::StrictlyUpper>() = equations_.border.transpose();
  }

  void add(std::size_t cell) {
    const std::vector<CellReading>& readings = problem_.readings[cell];
    if (readings.empty()) return;
    fitCell(problem_, prior_, state_, cell, sensor_);
    equations_.cost += sensor_.fit.cost;

    const bool fixed = cell == problem_.origin;
    const SE3& T_o_u = state_.cells[cell];
    const Eigen::Matrix3d R_a_o = R_a_u_ * T_o_u.R.transpose();
    const Eigen::Vector3d lever = T_o_u.t - state_.middle_o;
    const auto at = static_cast<Eigen::Index>(6 * cell);

    Matrix6d own = Matrix6d::Zero();
    Eigen::Matrix<double, 6, 1> own_gradient = Eigen::Matrix<double, 6, 1>::Zero();
    std::array<Eigen::Matrix<double, 4, 6>, 3> own_mixed;  // B^T W J per axis
    for (auto& mixed : own_mixed) mixed.setZero();
    border_root_.setZero();

    for (std::size_t k = 0; k < readings.size(); ++k) {
      const std::size_t pose = readings[k].pose;
      const double precision = sensor_.fit.precision[k];
      const Eigen::Vector3d& v = sensor_.v_g[k];
      const Eigen::Vector4d row(1, v.x(), v.y(), v.z());
      const Eigen::Vector3d weighted = precision * sensor_.fit.residual_g[k];
      const Eigen::Matrix3d G = -sensor_.fit.gain * R_a_o;  // d residual / d f_o

      // The residual's derivatives: to the cell ...
      Matrix3x6d J;
      J.rightCols<3>() = -sensor_.fit.gain * R_a_u_ * skew(T_o_u.R.transpose() * force(pose, lever));
      if (problem_.accelerations) {
        J.leftCols<3>() = G * skew(state_.acceleration_o[pose]) / kStandardGravity;
      } else {
        J.leftCols<3>().setZero();
      }
      if (fixed) J.setZero();
      // ... and to the pose.
      addPose(layout_.force(pose), at, J, G, precision, weighted, row);
      if (problem_.accelerations) {
        const Eigen::Matrix3d Ja = -G * skew(lever) / kStandardGravity;
        addPose(layout_.acceleration(pose), at, J, Ja, precision, weighted, row);
        const Eigen::Matrix3d both = precision * G.transpose() * Ja;
        equations_.border.block<3, 3>(layout_.force(pose), layout_.acceleration(pose)) += both;
        equations_.border.block<3, 3>(layout_.acceleration(pose), layout_.force(pose)) += both.transpose();
      }
      own.noalias() += precision * J.transpose() * J;
      own_gradient.noalias() += J.transpose() * weighted;
      for (int axis = 0; axis < 3; ++axis) {
        own_mixed[static_cast<std::size_t>(axis)].noalias() += precision * row * J.row(axis);
      }
    }

    // Elimination of offset and gains: what they could explain is not known of the rest.
    Eigen::Matrix<double, 12, 6> own_root;
    for (int axis = 0; axis < 3; ++axis) {
      const auto index = static_cast<std::size_t>(axis);
      const Eigen::Matrix4d root = sensor_.fit.covariance_root[index].transpose();
      own_root.middleRows<4>(4 * axis).noalias() = root * own_mixed[index];
      for (Eigen::Index column = 0; column < border_root_.cols(); ++column) {
        const Eigen::Vector4d mixed = border_root_.block<4, 1>(4 * axis, column);
        border_root_.block<4, 1>(4 * axis, column).noalias() = root * mixed;
      }
    }
    subtractLater(border_root_);
    if (fixed) return;
    own.noalias() -= own_root.transpose() * own_root;
    equations_.cells[cell] += own;
    equations_.gradient_cells.segment<6>(at) += own_gradient;
    // Column by column with sizes known to the compiler: a general product would spend its time on packing.
    const Eigen::Matrix<double, 6, 12> own_root_t = own_root.transpose();
    for (Eigen::Index column = 0; column < border_root_.cols(); ++column) {
      equations_.border_cells.block<6, 1>(at, column).noalias() -= own_root_t * border_root_.col(column);
    }
  }

 private:
  [[nodiscard]] Eigen::Vector3d force(std::size_t pose, const Eigen::Vector3d& lever) const {
    if (!problem_.accelerations) return state_.force_o[pose];
    return state_.force_o[pose] + state_.acceleration_o[pose].cross(lever) / kStandardGravity;
  }

  template <typename Jacobian>
  void addPose(Eigen::Index column, Eigen::Index cell_row, const Matrix3x6d& J, const Jacobian& Jp, double precision,
               const Eigen::Vector3d& weighted, const Eigen::Vector4d& row) {
    constexpr int kColumns = Jacobian::ColsAtCompileTime;
    equations_.border.template block<kColumns, kColumns>(column, column).noalias() += precision * Jp.transpose() * Jp;
    equations_.gradient_border.template segment<kColumns>(column).noalias() += Jp.transpose() * weighted;
    equations_.border_cells.template block<6, kColumns>(cell_row, column).noalias() += precision * J.transpose() * Jp;
    for (int axis = 0; axis < 3; ++axis) {
      border_root_.template block<4, kColumns>(4 * axis, column).noalias() += precision * row * Jp.row(axis);
    }
  }

  /// With many poses the border is large: its lower triangle takes the products of several cells at once.
  void subtractLater(const Eigen::Matrix<double, 12, Eigen::Dynamic>& root) {
    pending_.middleRows<12>(pending_rows_) = root;
    pending_rows_ += 12;
    if (pending_rows_ == pending_.rows()) subtractPending();
  }

  void subtractPending() {
    if (pending_rows_ == 0) return;
    equations_.border.selfadjointView<Eigen::Lower>().rankUpdate(pending_.topRows(pending_rows_).transpose(), -1);
    pending_rows_ = 0;
  }

  static constexpr Eigen::Index kBatch = 16;
  const JointProblem& problem_;
  const JointState& state_;
  NormalEquations& equations_;
  BorderLayout layout_;
  AccelerometerPrior prior_;
  Eigen::Matrix3d R_a_u_;
  Eigen::MatrixXd pending_;
  Eigen::Index pending_rows_ = 0;
  Eigen::Matrix<double, 12, Eigen::Dynamic> border_root_;  // B^T W J per axis, then its covariance root applied
  SensorState sensor_;
};

}  // namespace

BorderLayout::BorderLayout(const JointProblem& problem)
    : poses_(problem.poses),
      size_(static_cast<Eigen::Index>((problem.accelerations ? 6 : 3) * problem.poses + (problem.gap.sigma ? 1 : 0))) {}

void fitCell(const JointProblem& problem, const AccelerometerPrior& prior, const JointState& state, std::size_t cell,
             SensorState& sensor) {
  const std::vector<CellReading>& readings = problem.readings[cell];
  const Eigen::Matrix3d R_a_o = problem.model->accelerometer.T_u_a.R.transpose() * state.cells[cell].R.transpose();
  sensor.v_g.resize(readings.size());
  for (std::size_t k = 0; k < readings.size(); ++k) {
    sensor.v_g[k] = R_a_o * specificForce(problem, state, cell, readings[k].pose);
  }
  fitAccelerometer(prior, readings, sensor.v_g, problem.loss, sensor.fit);
}

double priorCost(const JointProblem& problem, const JointState& state) {
  double squared = 0;
  if (problem.gap.sigma) squared += std::pow((state.gap_share - problem.gap.mean) / *problem.gap.sigma, 2);
  for (const Eigen::Vector3d& f : state.force_o) squared += std::pow((f.norm() - 1) / problem.force_sigma_g, 2);
  if (problem.accelerations) {
    for (const Eigen::Vector3d& a : state.acceleration_o) {
      squared += a.squaredNorm() / std::pow(problem.acceleration_sigma, 2);
    }
  }
  return squared / 2;
}

Eigen::Vector3d specificForce(const JointProblem& problem, const JointState& state, std::size_t cell,
                              std::size_t pose) {
  if (!problem.accelerations) return state.force_o[pose];
  const Eigen::Vector3d lever = state.cells[cell].t - state.middle_o;
  return state.force_o[pose] + state.acceleration_o[pose].cross(lever) / kStandardGravity;
}

double jointCost(const JointProblem& problem, const JointState& state) {
  const AccelerometerPrior prior(problem.model->accelerometer);
  SensorState sensor;
  double cost = priorCost(problem, state);
  for (std::size_t cell = 0; cell < problem.cellCount(); ++cell) {
    if (problem.readings[cell].empty()) continue;
    fitCell(problem, prior, state, cell, sensor);
    cost += sensor.fit.cost;
  }
  for (const JointLink& link : problem.links) cost += twiceCostOf(problem, state, link) / 2;
  return cost;
}

double closureCost(const JointProblem& problem, const JointState& state) {
  double cost = 0;
  for (const JointLink& link : problem.links) {
    const Eigen::Vector3d closure = openingOf_m(problem, state, link) / problem.link_sigma_m;
    cost += problem.loss.cost(closure.squaredNorm());
  }
  return cost;
}

double linkOpening_m(const JointProblem& problem, const JointState& state, std::size_t link) {
  return openingOf_m(problem, state, problem.links[link]).norm();
}

void addLinks(const JointProblem& problem, const JointState& state, Eigen::Index share, NormalEquations& equations,
              const LinearizeKernels& kernels) {
  linearizeLinksInLanes(kernels, problem, state, share, equations);
  if (!problem.gap.sigma) return;
  const double precision = 1 / (*problem.gap.sigma * *problem.gap.sigma);
  equations.border(share, share) += precision;
  equations.gradient_border[share] += precision * (state.gap_share - problem.gap.mean);
}

void addForcePrior(const JointProblem& problem, const Eigen::Vector3d& force_o, Eigen::Ref<Eigen::Matrix3d> matrix,
                   Eigen::Ref<Eigen::Vector3d> gradient) {
  // A pose of which the last reading was left out has no direction; a little curvature keeps it where it is.
  constexpr double kLeastCurvature = 1e-3;
  const double precision = 1 / std::pow(problem.force_sigma_g, 2);
  const double norm = force_o.norm();
  const Eigen::Vector3d up = force_o / norm;
  matrix += precision * up * up.transpose() + kLeastCurvature * Eigen::Matrix3d::Identity();
  gradient += precision * (norm - 1) * up;
}

void linearize(const JointProblem& problem, const JointState& state, NormalEquations& equations,
               const LinearizeKernels* kernels) {
  const BorderLayout layout(problem);
  const auto rows = static_cast<Eigen::Index>(6 * problem.cellCount());
  equations.cells.assign(problem.cellCount(), Matrix6d::Zero());
  equations.cells[problem.origin].setIdentity();
  equations.links.assign(problem.links.size(), Matrix6d::Zero());
  equations.border_cells.setZero(rows, layout.size());
  equations.border.setZero(layout.size(), layout.size());
  equations.gradient_cells.setZero(rows);
  equations.gradient_border.setZero(layout.size());
  equations.cost = priorCost(problem, state);

  for (std::size_t pose = 0; pose < problem.poses; ++pose) {
    const Eigen::Index at = layout.force(pose);
    addForcePrior(problem, state.force_o[pose], equations.border.block<3, 3>(at, at),
                  equations.gradient_border.segment<3>(at));
  }

  CellLinearizer cells(problem, state, equations);
  if (kernels == nullptr) {
    for (std::size_t cell = 0; cell < problem.cellCount(); ++cell) cells.add(cell);
  } else {
    for (const std::size_t cell : linearizeCellsInLanes(*kernels, problem, state, equations)) cells.add(cell);
  }
  cells.finish();
  addLinks(problem, state, layout.gapShare(), equations, kernels != nullptr ? *kernels : portableLinearizeKernels());
  if (problem.accelerations) {
    const double precision = 1 / (problem.acceleration_sigma * problem.acceleration_sigma);
    for (std::size_t pose = 0; pose < problem.poses; ++pose) {
      const Eigen::Index at = layout.acceleration(pose);
      equations.border.diagonal().segment<3>(at).array() += precision;
      equations.gradient_border.segment<3>(at) += precision * state.acceleration_o[pose];
    }
  }
}

JointState moved(const JointProblem& problem, const JointState& state, const Eigen::VectorXd& cells,
                 const Eigen::VectorXd& border) {
  const BorderLayout layout(problem);
  JointState next = state;
  for (std::size_t cell = 0; cell < problem.cellCount(); ++cell) {
    if (cell == problem.origin) continue;
    const auto at = static_cast<Eigen::Index>(6 * cell);
    next.cells[cell].t += cells.segment<3>(at);
    // Many small steps must not let the matrix drift from a rotation.
    next.cells[cell].R =
        Eigen::Quaterniond(state.cells[cell].R * expSO3(cells.segment<3>(at + 3))).normalized().toRotationMatrix();
  }
  for (std::size_t pose = 0; pose < problem.poses; ++pose) {
    next.force_o[pose] += border.segment<3>(layout.force(pose));
    if (problem.accelerations) next.acceleration_o[pose] += border.segment<3>(layout.acceleration(pose));
  }
  if (problem.gap.sigma) next.gap_share += border[layout.gapShare()];
  return next;
}

}  // namespace hexoderm
