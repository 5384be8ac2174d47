#include "hexoderm/reconstruction/hold_out.h"

#include "hexoderm/reconstruction/reconstructor.h"
#include "hexoderm/util/error.h"

#include "accelerometer_fit.h"
#include "gravity_table.h"

#include <Eigen/Cholesky>
#include <Eigen/LU>
#include <algorithm>
#include <array>
#include <cmath>
#include <unordered_map>

namespace hexoderm {
namespace {

constexpr double kWorse = 1.5;
constexpr double kFarWorse = 3;
/// A corrected reading shorter than this shows no direction worth a comparison.
constexpr double kShortest_g = 0.5;

/// The unknowns of one cell: a small turn of its attitude (accelerometer axes), then per axis offset and gains.
constexpr int kUnknowns = 15;
using Information = Eigen::Matrix<double, kUnknowns, kUnknowns>;
using Jacobian = Eigen::Matrix<double, 3, kUnknowns>;

/// Derivative of a reading gain v + offset of the specific force v by the unknowns.
Jacobian readingJacobian(const Eigen::Matrix3d& gain, const Eigen::Vector3d& v) {
  Jacobian J = Jacobian::Zero();
  J.leftCols<3>() = gain * skew(v);
  for (int axis = 0; axis < 3; ++axis) {
    J(axis, 3 + 4 * axis) = 1;
    J.block<1, 3>(axis, 4 + 4 * axis) = v.transpose();
  }
  return J;
}

/// A cell's view of the left-out pose.
struct Seen {
  CellId cell;
  Eigen::Vector3d direction_o;  ///< unit, patch frame
  double expected_sq = 0;       ///< P_u
};

class HoldOut {
 public:
  HoldOut(const SessionSnapshot& snapshot, PoseId pose, const SolverOptions& options)
      : model_(*snapshot.model),
        prior_(model_.accelerometer),
        joint_(options.solver == Solver::Global),
        graph_(model_, *snapshot.neighbors),
        everything_(allEnabled(snapshot)),
        table_(everything_, graph_, ignored_) {
    for (std::size_t k = 0; k < snapshot.poses.size(); ++k) place_of_.emplace(snapshot.poses[k].capture->id, k);
    left_out_ = place_of_.at(pose);
  }

  void evaluate(const PatchReconstruction& patch, HoldOutResult& result) const {
    std::vector<Seen> seen;
    for (const CellPlacement& cell : patch.cells) {
      if (const std::optional<Seen> view = look(patch, cell)) seen.push_back(*view);
    }
    if (seen.size() < 2) return;
    Eigen::Vector3d sum = Eigen::Vector3d::Zero();
    double expected_sum = 0;
    std::unordered_map<CellId, const Seen*> by_cell;
    for (const Seen& view : seen) {
      sum += view.direction_o;
      expected_sum += view.expected_sq;
      by_cell.emplace(view.cell, &view);
    }
    const auto others = static_cast<double>(seen.size() - 1);
    for (const Seen& view : seen) {
      const double expected_sq = view.expected_sq + (expected_sum - view.expected_sq) / (others * others);
      result.cells.push_back(
          {view.cell, angleBetween(view.direction_o, sum - view.direction_o), std::sqrt(expected_sq)});
    }
    for (const LinkEstimate& link : patch.links) {
      const auto c = by_cell.find(link.source.cell);
      const auto n = by_cell.find(link.target.cell);
      if (!link.used || c == by_cell.end() || n == by_cell.end()) continue;
      result.links.push_back({link.source, link.target, angleBetween(c->second->direction_o, n->second->direction_o),
                              std::sqrt(c->second->expected_sq + n->second->expected_sq)});
    }
    result.degrees_of_freedom += 2 * (seen.size() - 1);
  }

 private:
  static SessionSnapshot allEnabled(const SessionSnapshot& snapshot) {
    SessionSnapshot copy = snapshot;
    for (SessionPose& pose : copy.poses) pose.disabled = false;
    return copy;
  }

  [[nodiscard]] std::optional<Seen> look(const PatchReconstruction& patch, const CellPlacement& cell) const {
    const std::optional<std::size_t> index = graph_.indexOf(cell.cell);
    if (!index || cell.placed_by != PlacedBy::Samples) return std::nullopt;
    const GravityTable::Entry& entry = table_.at(*index, left_out_);
    if (!entry.usable) return std::nullopt;
    const Eigen::Matrix3d R_a_u = model_.accelerometer.T_u_a.R.transpose();
    const Eigen::Matrix3d R_a_o = R_a_u * cell.T_o_u.R.transpose();

    std::vector<CellReading> readings;
    std::vector<Eigen::Vector3d> forces;
    for (const GravityDirection& gravity : patch.gravity) {
      const auto place = place_of_.find(gravity.pose);
      if (place == place_of_.end() || !table_.at(*index, place->second).usable) continue;
      const GravityTable::Entry& reading = table_.at(*index, place->second);
      forces.emplace_back(R_a_o * gravity.g_o);
      readings.push_back({readings.size(), R_a_u * reading.mean_g, reading.variance_g2});
    }
    if (readings.empty()) return std::nullopt;
    AccelerometerFit fit;
    if (joint_) fitAccelerometer(prior_, readings, forces, {}, fit);

    const Eigen::Matrix3d inverse = fit.gain.inverse();
    const Eigen::Vector3d v = inverse * (R_a_u * entry.mean_g - fit.offset_g);
    if (!v.allFinite() || v.norm() < kShortest_g) return std::nullopt;
    const Eigen::Vector3d towards = v.normalized();
    const Jacobian J = readingJacobian(fit.gain, towards);
    Eigen::Matrix3d scatter = J * unknownsCovariance(cell, readings, forces, fit.gain) * J.transpose();
    scatter.diagonal().array() += entry.variance_g2;
    const Eigen::Matrix3d across = (Eigen::Matrix3d::Identity() - towards * towards.transpose()) * inverse;
    return Seen{cell.cell, R_a_o.transpose() * towards,
                (across * scatter * across.transpose()).trace() / v.squaredNorm()};
  }

  [[nodiscard]] Information unknownsCovariance(const CellPlacement& cell, const std::vector<CellReading>& readings,
                                               const std::vector<Eigen::Vector3d>& forces,
                                               const Eigen::Matrix3d& gain) const {
    Information information = Information::Zero();
    information.topLeftCorner<3, 3>() = elastomerInformation(cell.cell);
    for (int axis = 0; axis < 3; ++axis) information.diagonal().segment<4>(3 + 4 * axis) = prior_.precision(axis);
    Information normal = Information::Zero();
    for (std::size_t k = 0; k < readings.size(); ++k) {
      const Jacobian J = readingJacobian(gain, forces[k]);
      normal.noalias() += J.transpose() * J / readings[k].variance_g2;
    }
    if (joint_) return (information + normal).ldlt().solve(Information::Identity());
    // The tree turns the cell so that its raw readings fit and takes the sensor's errors for part of gravity.
    const Eigen::Matrix3d attitude = (normal + information).topLeftCorner<3, 3>().inverse();
    const Information priors = information.diagonal().cwiseInverse().asDiagonal();
    Eigen::Matrix<double, kUnknowns, kUnknowns> carried = Information::Identity();
    carried.topLeftCorner<3, 3>().setZero();
    carried.topRightCorner<3, 12>() = -attitude * normal.topRightCorner<3, 12>();
    Information covariance = carried * priors * carried.transpose();
    covariance.topLeftCorner<3, 3>() += attitude;
    return covariance;
  }

  /// What the links' elastomer says about a cell's attitude, accelerometer axes. A turn about an axis along which every
  /// neighbour lets the cell go is still not free: it is known to a turn.
  [[nodiscard]] Eigen::Matrix3d elastomerInformation(CellId id) const {
    Eigen::Matrix3d information = Eigen::Matrix3d::Identity();
    const std::size_t cell = *graph_.indexOf(id);
    for (const std::size_t k : graph_.linksAt(cell)) {
      const GraphLink& link = graph_.links()[k];
      if (link.muted()) continue;
      const PortNumber port = link.source == cell ? link.source_port : link.target_port;
      const Eigen::Vector3d u = model_.port(port).vector_m.normalized();
      const Eigen::Vector3d z = Eigen::Vector3d::UnitZ();
      const auto add = [&information](const Eigen::Vector3d& axis, double sigma) {
        if (sigma > 0) information += axis * axis.transpose() / (sigma * sigma);
      };
      add(u, model_.twist_sigma_rad);
      add(z.cross(u), model_.bend_sigma_rad);
      add(z, model_.yaw_sigma_rad);
    }
    const Eigen::Matrix3d& R_u_a = model_.accelerometer.T_u_a.R;
    return R_u_a.transpose() * information * R_u_a;
  }

  const CellModel& model_;
  AccelerometerPrior prior_;
  bool joint_;
  SkinGraph graph_;
  SessionSnapshot everything_;
  std::vector<Finding> ignored_;  ///< the reconstruction has them
  GravityTable table_;
  std::unordered_map<PoseId, std::size_t> place_of_;  ///< the first of each ID
  std::size_t left_out_ = 0;
};

double rootMeanSquare(const std::vector<HoldOutCell>& cells, double HoldOutCell::*value) {
  double sum = 0;
  for (const HoldOutCell& cell : cells) sum += cell.*value * (cell.*value);
  return std::sqrt(sum / static_cast<double>(cells.size()));
}

}  // namespace

std::string_view holdOutAgreementName(HoldOutAgreement agreement) {
  constexpr std::array<std::string_view, 3> kNames = {"as_stated", "worse", "far_worse"};
  return kNames.at(static_cast<std::size_t>(agreement));
}

HoldOutResult evaluateHoldOut(const SessionSnapshot& snapshot, PoseId pose, const SolverOptions& options,
                              const std::stop_token& stop) {
  options.validate();
  SessionSnapshot others = snapshot;
  if (std::erase_if(others.poses, [pose](const SessionPose& p) { return p.capture->id == pose; }) == 0) {
    throw InvalidArgument("hold-out: there is no pose " + toString(pose));
  }
  HoldOutResult result;
  result.pose = pose;
  result.other_poses = static_cast<std::size_t>(std::ranges::count(others.poses, false, &SessionPose::disabled));
  if (result.other_poses < kFewestOtherPoses) return result;
  result.outcome = HoldOutOutcome::Stopped;
  if (stop.stop_requested()) return result;
  const auto reconstruction = reconstruct(others, options);
  const HoldOut hold_out(snapshot, pose, options);
  for (const PatchReconstruction& patch : reconstruction->patches) {
    if (stop.stop_requested()) return result;
    hold_out.evaluate(patch, result);
  }
  result.outcome = result.cells.empty() ? HoldOutOutcome::NothingToCompare : HoldOutOutcome::Evaluated;
  if (result.cells.empty()) return result;
  result.rms_rad = rootMeanSquare(result.cells, &HoldOutCell::error_rad);
  result.expected_rms_rad = rootMeanSquare(result.cells, &HoldOutCell::expected_rad);
  if (result.rms_rad > kFarWorse * result.expected_rms_rad) {
    result.agreement = HoldOutAgreement::FarWorse;
  } else if (result.rms_rad > kWorse * result.expected_rms_rad) {
    result.agreement = HoldOutAgreement::Worse;
  }
  return result;
}

}  // namespace hexoderm
