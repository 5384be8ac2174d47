#include "hexoderm/solve/global/global_cost.h"

#include "hexoderm/base/units.h"
#include "hexoderm/solve/global/linearize_lanes.h"

#include <algorithm>
#include <cmath>

namespace hexoderm {
namespace {

bool linksBend(const GlobalProblem& problem) { return problem.gap.sigma.has_value() || problem.gap.mean != 0; }

/// The distance between the end points of a link, less the arc's share.
Eigen::Vector3d openingOf_m(const GlobalProblem& problem, const GlobalState& state, const GlobalLink& link) {
  const SE3& T_c = state.cells[link.c];
  const SE3& T_n = state.cells[link.n];
  const Eigen::Vector3d opening_m = T_n * link.p_n - T_c * link.p_c;
  if (!linksBend(problem)) return opening_m;
  const double e_m = (link.p_c.norm() + link.p_n.norm()) / 2;
  return opening_m - state.gap_share * arcOpening_m(T_c.R * link.p_c.normalized(), T_n.R * link.p_n.normalized(), e_m);
}

/// Twice the cost of one link.
double twiceCostOf(const GlobalProblem& problem, const GlobalState& state, const GlobalLink& link) {
  const CellModel& model = *problem.model;
  const Eigen::Matrix3d axes = linkAxes({PortNumber(), link.p_c});
  const Eigen::Matrix3d R_c_n = state.cells[link.c].R.transpose() * state.cells[link.n].R;
  const Eigen::Vector3d w = logSO3(R_c_n * link.R_nom.transpose());
  const Eigen::Vector3d elastomer(w.dot(axes.col(0)) / model.twist_sigma_rad, w.dot(axes.col(1)) / model.bend_sigma_rad,
                                  w.dot(axes.col(2)) / model.yaw_sigma_rad);
  const Eigen::Vector3d closure = openingOf_m(problem, state, link) / problem.link_sigma_m;
  return problem.loss.cost(closure.squaredNorm()) + problem.loss.cost(elastomer.squaredNorm());
}

/// Precisions of the lot's offset, per axis, and of its scale. One that is known has a finite
/// precision too, which keeps the algebra the same.
struct LotPrecision {
  double offset = 0;
  double scale = 0;
  explicit LotPrecision(const Accelerometer& accelerometer) {
    constexpr double kMinSigma = 1e-6;
    offset = std::pow(std::max(kMinSigma, accelerometer.offset_shared_sigma_g), -2);
    scale = std::pow(std::max(kMinSigma, accelerometer.scale_shared_sigma), -2);
  }
};

double priorCost(const GlobalProblem& problem, const GlobalState& state) {
  double squared = 0;
  if (problem.estimatesLot()) {
    const LotPrecision precision(problem.model->accelerometer);
    squared += precision.offset * state.lot.offset_g.squaredNorm();
    squared += precision.scale * std::pow(state.lot.scale - 1, 2);
  }
  if (problem.gap.sigma) squared += std::pow((state.gap_share - problem.gap.mean) / *problem.gap.sigma, 2);
  for (const Eigen::Vector3d& f : state.force_o) squared += std::pow((f.norm() - 1) / problem.force_sigma_g, 2);
  if (problem.accelerations) {
    for (const Eigen::Vector3d& a : state.acceleration_o) {
      squared += a.squaredNorm() / std::pow(problem.acceleration_sigma, 2);
    }
  }
  return squared / 2;
}

/// Makes room, with the priorCost() and the priors of the forces and of the lot.
void startEquations(const GlobalProblem& problem, const GlobalState& state, NormalEquations& equations) {
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
  // A pose of which the last reading was left out has no direction; a little curvature keeps it where it is.
  constexpr double kMinCurvature = 1e-3;
  const double precision = 1 / std::pow(problem.force_sigma_g, 2);
  for (std::size_t pose = 0; pose < problem.poses; ++pose) {
    const Eigen::Index at = layout.force(pose);
    const double norm = state.force_o[pose].norm();
    const Eigen::Vector3d up = state.force_o[pose] / norm;
    equations.border.block<3, 3>(at, at) +=
        precision * up * up.transpose() + kMinCurvature * Eigen::Matrix3d::Identity();
    equations.gradient_border.segment<3>(at) += precision * (norm - 1) * up;
  }
  if (!problem.estimatesLot()) return;
  const LotPrecision of_lot(problem.model->accelerometer);
  const Eigen::Index at = layout.lot();
  equations.border.diagonal().segment<3>(at).array() += of_lot.offset;
  equations.gradient_border.segment<3>(at) += of_lot.offset * state.lot.offset_g;
  equations.border(at + 3, at + 3) += of_lot.scale;
  equations.gradient_border[at + 3] += of_lot.scale * (state.lot.scale - 1);
}

}  // namespace

BorderLayout::BorderLayout(const GlobalProblem& problem)
    : poses_(problem.poses),
      lot_(static_cast<Eigen::Index>((problem.accelerations ? 6 : 3) * problem.poses)),
      size_(lot_ + (problem.estimatesLot() ? kLotUnknowns : 0) + (problem.gap.sigma ? 1 : 0)) {}

bool GlobalProblem::estimatesLot() const { return model->accelerometer.sharesErrors(); }

AccelerometerPrior priorOfChips(const GlobalProblem& problem, const GlobalState& state) {
  return AccelerometerPrior(state.lot.chips(problem.model->accelerometer));
}

void fitCell(const GlobalProblem& problem, const AccelerometerPrior& prior, const GlobalState& state, std::size_t cell,
             SensorState& sensor) {
  const std::vector<CellReading>& readings = problem.readings[cell];
  const Eigen::Matrix3d R_a_o = problem.model->accelerometer.T_u_a.R.transpose() * state.cells[cell].R.transpose();
  sensor.readings.clear();
  sensor.v_g.resize(readings.size());
  for (std::size_t k = 0; k < readings.size(); ++k) {
    sensor.v_g[k] = R_a_o * specificForce(problem, state, cell, readings[k].pose);
    sensor.readings.push_back(state.lot.without(readings[k], sensor.v_g[k]));
  }
  fitAccelerometer(prior, sensor.readings, sensor.v_g, problem.loss, sensor.fit);
}

Eigen::Vector3d specificForce(const GlobalProblem& problem, const GlobalState& state, std::size_t cell,
                              std::size_t pose) {
  if (!problem.accelerations) return state.force_o[pose];
  const Eigen::Vector3d lever = state.cells[cell].t - state.middle_o;
  return state.force_o[pose] + state.acceleration_o[pose].cross(lever) / kStandardGravity;
}

double jointCost(const GlobalProblem& problem, const GlobalState& state) {
  const AccelerometerPrior prior = priorOfChips(problem, state);
  SensorState sensor;
  double cost = priorCost(problem, state);
  for (std::size_t cell = 0; cell < problem.cellCount(); ++cell) {
    if (problem.readings[cell].empty()) continue;
    fitCell(problem, prior, state, cell, sensor);
    cost += sensor.fit.cost;
  }
  for (const GlobalLink& link : problem.links) cost += twiceCostOf(problem, state, link) / 2;
  return cost;
}

double closureCost(const GlobalProblem& problem, const GlobalState& state) {
  double cost = 0;
  for (const GlobalLink& link : problem.links) {
    const Eigen::Vector3d closure = openingOf_m(problem, state, link) / problem.link_sigma_m;
    cost += problem.loss.cost(closure.squaredNorm());
  }
  return cost;
}

double linkOpening_m(const GlobalProblem& problem, const GlobalState& state, std::size_t link) {
  return openingOf_m(problem, state, problem.links[link]).norm();
}

void linearize(const GlobalProblem& problem, const GlobalState& state, NormalEquations& equations,
               const LinearizeKernels& kernels) {
  const BorderLayout layout(problem);
  startEquations(problem, state, equations);
  linearizeCellsInLanes(kernels, problem, state, equations);
  equations.border.triangularView<Eigen::StrictlyUpper>() = equations.border.transpose();
  linearizeLinksInLanes(kernels, problem, state, equations);
  if (problem.gap.sigma) {
    const double precision = 1 / (*problem.gap.sigma * *problem.gap.sigma);
    equations.border(layout.gapShare(), layout.gapShare()) += precision;
    equations.gradient_border[layout.gapShare()] += precision * (state.gap_share - problem.gap.mean);
  }
  if (problem.accelerations) {
    const double precision = 1 / (problem.acceleration_sigma * problem.acceleration_sigma);
    for (std::size_t pose = 0; pose < problem.poses; ++pose) {
      const Eigen::Index at = layout.acceleration(pose);
      equations.border.diagonal().segment<3>(at).array() += precision;
      equations.gradient_border.segment<3>(at) += precision * state.acceleration_o[pose];
    }
  }
}

Eigen::MatrixXd denseMatrix(const GlobalProblem& problem, const NormalEquations& equations) {
  const auto cells = static_cast<Eigen::Index>(6 * problem.cellCount());
  const Eigen::Index border = equations.border.rows();
  Eigen::MatrixXd matrix = Eigen::MatrixXd::Zero(cells + border, cells + border);
  for (std::size_t cell = 0; cell < problem.cellCount(); ++cell) {
    const auto at = static_cast<Eigen::Index>(6 * cell);
    matrix.block<6, 6>(at, at) = equations.cells[cell];
  }
  for (std::size_t k = 0; k < problem.links.size(); ++k) {
    const auto c = static_cast<Eigen::Index>(6 * problem.links[k].c);
    const auto n = static_cast<Eigen::Index>(6 * problem.links[k].n);
    matrix.block<6, 6>(c, n) += equations.links[k];
    matrix.block<6, 6>(n, c) += equations.links[k].transpose();
  }
  matrix.topRightCorner(cells, border) = equations.border_cells;
  matrix.bottomLeftCorner(border, cells) = equations.border_cells.transpose();
  matrix.bottomRightCorner(border, border) = equations.border;
  return matrix;
}

GlobalState moved(const GlobalProblem& problem, const GlobalState& state, const Eigen::VectorXd& cells,
                  const Eigen::VectorXd& border) {
  const BorderLayout layout(problem);
  GlobalState next = state;
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
  if (problem.estimatesLot()) {
    next.lot.offset_g += border.segment<3>(layout.lot());
    constexpr double kLeast = 0.1;  // of the scale before: it stays above 0
    next.lot.scale = std::max(kLeast * next.lot.scale, next.lot.scale + border[layout.lot() + 3]);
  }
  if (problem.gap.sigma) next.gap_share += border[layout.gapShare()];
  return next;
}

}  // namespace hexoderm
