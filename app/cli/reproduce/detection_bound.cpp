#include "app/cli/reproduce/detection_bound.h"

#include "hexoderm/util/units.h"

#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>

namespace hexoderm::cli {
namespace {

constexpr double kDeviateOfFalseAlarm = 2.878;  // exceeded with a probability of 0.2 %
constexpr double kSamples = 100;                // simulateSession()
constexpr double kTremor_g = 0.003;

std::size_t indexOf(const SimulatedSkin& skin, CellId cell) {
  return static_cast<std::size_t>(std::ranges::find(skin.truth(), cell, &TrueCell::id) - skin.truth().begin());
}

/// What a sensor without errors reads in all poses, one below the other. `turn`: of the cell, in poses from `first` on.
Eigen::VectorXd idealReadings(const Eigen::Matrix3d& R_b_u, const std::vector<Eigen::Vector3d>& ups,
                              const Eigen::Matrix3d& turn = Eigen::Matrix3d::Identity(), std::size_t first = 0) {
  Eigen::VectorXd readings(static_cast<Eigen::Index>(3 * ups.size()));
  for (std::size_t p = 0; p < ups.size(); ++p) {
    const Eigen::Vector3d v = R_b_u.transpose() * ups[p];
    readings.segment<3>(static_cast<Eigen::Index>(3 * p)) = p >= first ? Eigen::Vector3d(turn.transpose() * v) : v;
  }
  return readings;
}

Eigen::Matrix3d jitterOf(const SimulatedSkin& skin) {
  const SimulatedSkinOptions& options = skin.options();
  return Eigen::Vector3d(options.tilt_jitter_rad, options.tilt_jitter_rad, options.yaw_jitter_rad)
      .cwiseAbs2()
      .asDiagonal();
}

/// Covariance of a cell's attitude as its links leave it, cell frame.
Eigen::Matrix3d elastomerOf(const SimulatedSkin& skin, std::size_t cell) {
  const CellModel& model = skin.model();
  Eigen::Matrix3d information = Eigen::Matrix3d::Zero();
  for (const NeighborReport& link : skin.neighbors()[cell].neighbors) {
    if (link.cell.value() == 0) continue;
    const Eigen::Vector3d u = model.port(link.port).vector_m.normalized();
    Eigen::Matrix3d axes;
    axes << u / model.twist_sigma_rad, Eigen::Vector3d::UnitZ().cross(u) / model.bend_sigma_rad,
        Eigen::Vector3d::UnitZ() / model.yaw_sigma_rad;
    information += axes * axes.transpose();
  }
  return information.inverse();
}

/// Covariance of a healthy cell's readings: of the sensor's errors, its attitude (`of_attitude`) and the noise of means.
Eigen::MatrixXd covarianceOf(const SimulatedSkin& skin, const Eigen::VectorXd& ideal,
                             const Eigen::Matrix3d& of_attitude) {
  const Accelerometer& a = skin.model().accelerometer;
  const double noise_g2 =
      kTremor_g * kTremor_g +
      (a.noise_g_per_sqrt_hz * a.noise_g_per_sqrt_hz * a.rate_hz / 2 + a.lsb_g * a.lsb_g / 12) / kSamples;
  Eigen::MatrixXd covariance = noise_g2 * Eigen::MatrixXd::Identity(ideal.size(), ideal.size());
  for (Eigen::Index p = 0; p < ideal.size(); p += 3) {
    const Eigen::Vector3d v = ideal.segment<3>(p);
    for (Eigen::Index q = 0; q < ideal.size(); q += 3) {
      const Eigen::Vector3d w = ideal.segment<3>(q);
      Eigen::Matrix3d block = a.cross_axis_sigma * a.cross_axis_sigma * v.dot(w) * Eigen::Matrix3d::Identity();
      block.diagonal().array() += a.offset_sigma_g * a.offset_sigma_g;
      block.diagonal() += (a.scale_sigma * a.scale_sigma - a.cross_axis_sigma * a.cross_axis_sigma) * v.cwiseProduct(w);
      block += skew(v) * of_attitude * skew(w).transpose();
      covariance.block<3, 3>(p, q) += block;
    }
  }
  return covariance;
}

double squaredShift(const SimulatedSkin& skin, const Eigen::VectorXd& ideal, const Eigen::VectorXd& faulty,
                    const Eigen::Matrix3d& of_attitude) {
  const Eigen::VectorXd change = faulty - ideal;
  return change.dot(covarianceOf(skin, ideal, of_attitude).ldlt().solve(change));
}

}  // namespace

double bestDetection(const SimulatedSkin& skin, const CellFault& fault, std::size_t poses) {
  const std::vector<Eigen::Vector3d> ups = scriptedUpDirections(poses);
  const std::size_t cell = indexOf(skin, fault.cell);
  const Eigen::Matrix3d R_b_u = skin.truth()[cell].T_b_u.R;
  const Eigen::VectorXd ideal = idealReadings(R_b_u, ups);
  double squared = 0;
  if (fault.kind == SkinFault::Swapped) {
    const auto& links = skin.neighbors()[cell].neighbors;
    const auto first = std::ranges::find_if(links, [](const NeighborReport& n) { return n.cell.value() != 0; });
    const Eigen::VectorXd other = idealReadings(skin.truth()[indexOf(skin, first->cell)].T_b_u.R, ups);
    squared = squaredShift(skin, ideal, other, jitterOf(skin)) + squaredShift(skin, other, ideal, jitterOf(skin));
  } else {
    const std::size_t from = fault.kind == SkinFault::Reglued ? skin.options().reglued_before : 0;
    squared = squaredShift(skin, ideal, idealReadings(R_b_u, ups, skin.turnOf(fault.cell), from),
                           elastomerOf(skin, cell));
  }
  return 50 * std::erfc(-(std::sqrt(squared) - kDeviateOfFalseAlarm) / std::sqrt(2.0));
}

}  // namespace hexoderm::cli
