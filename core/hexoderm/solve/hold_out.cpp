#include "hexoderm/solve/hold_out.h"

#include "hexoderm/base/error.h"
#include "hexoderm/base/median.h"
#include "hexoderm/base/units.h"
#include "hexoderm/solve/reconstructor.h"

#include "hexoderm/solve/checks/cell_change.h"
#include "hexoderm/solve/global/accelerometer_fit.h"
#include "hexoderm/solve/tree/gravity_table.h"

#include <Eigen/Cholesky>
#include <Eigen/LU>
#include <algorithm>
#include <array>
#include <cmath>
#include <unordered_map>
#include <utility>

namespace hexoderm {
namespace {

/// Multiples of the expected error that still count as stated, and that are beyond doubt.
struct Limits {
  double worse;
  double far_worse;
};
constexpr Limits kRms{1.5, 3};
constexpr Limits kCell{4, 8};
constexpr Limits kTurning{2, 3};  // hands tremble differently
constexpr double kCoarse_rad = 2.5 * kDegree;
constexpr double kDetectable = 4;  // multiple of the expected rms, from simulated skins of 17 and 100 cells

/// A corrected reading shorter than this shows no direction worth a comparison.
constexpr double kShortest_g = 0.5;

/// A cell's view of the left-out pose: the specific force there, patch frame.
struct Seen {
  CellId cell;
  Eigen::Vector3d at_o;  ///< position of the cell, m
  Eigen::Vector3d force_o_g;
  Eigen::Matrix3d covariance_g2;  ///< covariance of force_o_g
  Eigen::Matrix3d drift_o;        ///< derivative of force_o_g by the sensor's offset
};

/// What the cells most probably share given what some of them see, and its covariance.
struct SharedFit {
  Eigen::Matrix<double, kShared, kShared> information;
  SharedByCells right = SharedByCells::Zero();

  explicit SharedFit(const SharedDrift& drift) : information(sharedPrior(1, drift)) {}
  void add(const Seen& seen, double sign) {
    const SharedJacobian X = sharedJacobian(seen.at_o, seen.drift_o);
    const SharedJacobian weighted = seen.covariance_g2.llt().solve(X);
    information += sign * X.transpose() * weighted;
    right += sign * weighted.transpose() * seen.force_o_g;
  }
};

class HoldOut {
 public:
  HoldOut(const SessionSnapshot& snapshot, PoseId pose, const SolverOptions& options)
      : model_(*snapshot.model),
        joint_(options.solver == Solver::Global),
        graph_(model_, *snapshot.neighbors),
        everything_(allEnabled(snapshot)),
        table_(everything_, graph_, ignored_) {
    for (std::size_t k = 0; k < snapshot.poses.size(); ++k) place_of_.emplace(snapshot.poses[k].capture->id, k);
    left_out_ = place_of_.at(pose);
    noise_g2_ = noiseOfCells();
  }

  /// Nothing is foretold of these cells: what they read is not what the result is made of.
  void leaveOut(std::span<const CellId> cells) {
    for (const CellId cell : cells) table_.at(graph_.indexOf(cell).value(), left_out_).usable = false;
  }

  void evaluate(const PatchReconstruction& patch, HoldOutResult& result) const {
    std::vector<Seen> seen;
    for (const CellPlacement& cell : patch.cells) {
      if (const std::optional<Seen> view = look(patch, cell)) seen.push_back(*view);
    }
    if (seen.size() < 2) return;
    // The pose's common offset less the mean of the others'.
    const double drift_g = model_.accelerometer.offset_instability_shared_sigma_g *
                           std::sqrt(1 + 1 / static_cast<double>(result.other_poses));
    SharedFit all({0, std::hypot(drift_g, unknownOfLot_g(patch))});
    for (const Seen& view : seen) all.add(view, 1);
    std::unordered_map<CellId, const Seen*> by_cell;
    for (const Seen& view : seen) {
      by_cell.emplace(view.cell, &view);
      SharedFit others = all;
      others.add(view, -1);
      const Eigen::LDLT<Eigen::Matrix<double, kShared, kShared>> factor(others.information);
      const SharedJacobian X = sharedJacobian(view.at_o, view.drift_o);
      const Eigen::Vector3d foretold = X * factor.solve(others.right);
      const Eigen::Matrix3d covariance = view.covariance_g2 + X * factor.solve(X.transpose());
      result.cells.push_back(
          {view.cell, angleBetween(view.force_o_g, foretold), std::sqrt(squareAcross(covariance, view.force_o_g))});
    }
    const SharedByCells shared = all.information.ldlt().solve(all.right);
    result.turning_rad_s2 = std::max(result.turning_rad_s2, shared.segment<3>(3).norm() * kStandardGravity);
    for (const LinkEstimate& link : patch.links) {
      const auto c = by_cell.find(link.source.cell);
      const auto n = by_cell.find(link.target.cell);
      if (!link.used || c == by_cell.end() || n == by_cell.end()) continue;
      addLink(link, *c->second, *n->second, shared, result);
    }
  }

 private:
  static SessionSnapshot allEnabled(const SessionSnapshot& snapshot) {
    SessionSnapshot copy = snapshot;
    for (SessionPose& pose : copy.poses) pose.disabled = false;
    return copy;
  }

  /// Expected square of the angle between a vector about v and v itself.
  static double squareAcross(const Eigen::Matrix3d& covariance, const Eigen::Vector3d& v) {
    const Eigen::Vector3d along = v.normalized();
    return (covariance.trace() - along.dot(covariance * along)) / v.squaredNorm();
  }

  static void addLink(const LinkEstimate& link, const Seen& c, const Seen& n, const SharedByCells& shared,
                      HoldOutResult& result) {
    const Eigen::Vector3d at_c =
        n.force_o_g + (sharedJacobian(c.at_o, c.drift_o) - sharedJacobian(n.at_o, n.drift_o)) * shared;
    result.links.push_back({link.source, link.target, angleBetween(c.force_o_g, at_c),
                            std::sqrt(squareAcross(c.covariance_g2 + n.covariance_g2, c.force_o_g))});
  }

  [[nodiscard]] std::optional<Seen> look(const PatchReconstruction& patch, const CellPlacement& cell) const {
    const std::optional<std::size_t> index = graph_.indexOf(cell.cell);
    if (!index || cell.placed_by != PlacedBy::Samples) return std::nullopt;
    const GravityTable::Entry& entry = table_.at(*index, left_out_);
    if (!entry.usable) return std::nullopt;
    const Eigen::Matrix3d R_a_u = model_.accelerometer.T_u_a.R.transpose();
    const Eigen::Matrix3d R_a_o = R_a_u * cell.T_o_u.R.transpose();

    const SensorLot lot = patch.lot ? SensorLot{patch.lot->offset_g, patch.lot->scale} : SensorLot{};
    const AccelerometerPrior prior = priorOfChips(model_, patch);
    std::vector<CellReading> readings;
    std::vector<Eigen::Vector3d> forces;
    std::vector<PlacingReading> placing;
    for (const GravityDirection& gravity : patch.gravity) {
      const auto place = place_of_.find(gravity.pose);
      if (place == place_of_.end() || !table_.at(*index, place->second).usable) continue;
      const GravityTable::Entry& reading = table_.at(*index, place->second);
      const Eigen::Vector3d force_o =
          gravity.force ? Eigen::Vector3d(gravity.force->at_origin_o_g + gravity.force->swing_o.cross(cell.T_o_u.t))
                        : gravity.g_o;
      forces.emplace_back(R_a_o * force_o);
      readings.push_back(lot.without({readings.size(), R_a_u * reading.mean_g, reading.variance_g2}, forces.back()));
      placing.push_back({forces.back(), reading.variance_g2, ownVariance(*index, place->second)});
    }
    if (readings.empty()) return std::nullopt;
    AccelerometerFit fit;
    if (joint_) fitAccelerometer(prior, readings, forces, {}, fit);

    const Eigen::Matrix3d gain = lot.gain(fit.gain);
    const Eigen::Matrix3d inverse = gain.inverse();
    const Eigen::Vector3d v = inverse * (R_a_u * entry.mean_g - lot.offset_g - fit.offset_g);
    if (!v.allFinite() || v.norm() < kShortest_g) return std::nullopt;
    const CellJacobian J = readingJacobian(gain, v.normalized());
    const CellErrors priors = priorInformation(prior, elastomerInformation(model_, linkedPorts(*index)));
    Eigen::Matrix3d covariance =
        J * errorsOfCell(priors, placing, gain, joint_ ? CellEstimate::Joint : CellEstimate::Tree) * J.transpose();
    covariance.diagonal().array() += ownVariance(*index, left_out_);
    const Eigen::Matrix3d to_o = R_a_o.transpose() * inverse;
    return Seen{cell.cell, cell.T_o_u.t, R_a_o.transpose() * v, to_o * covariance * to_o.transpose(), to_o};
  }

  /// A pose's scatter of single samples: the median over its cells, and its standard error as a share of it.
  struct PoseScatter {
    std::size_t pose = 0;
    double median_g2 = 0;
    double error = 0;
  };
  [[nodiscard]] std::vector<PoseScatter> scatterOfPoses() const {
    constexpr double kMedianError = 1.25;  // of a median over that of a mean
    std::vector<PoseScatter> poses;
    for (std::size_t pose = 0; pose < table_.poseCount(); ++pose) {
      std::vector<double> scatter;
      double freedom = 0;
      for (std::size_t cell = 0; cell < table_.cellCount(); ++cell) {
        const GravityTable::Entry& entry = table_.at(cell, pose);
        if (!entry.usable || !(entry.own_variance_g2 > 0)) continue;
        scatter.push_back(entry.own_variance_g2 * entry.count);
        freedom += 3 * std::max(1.0, entry.count - 1);
      }
      if (!scatter.empty()) poses.push_back({pose, median(std::move(scatter)), kMedianError * std::sqrt(2 / freedom)});
    }
    return poses;
  }

  /// Variance of one sample per cell in the poses in which the skin as a whole scattered least: a cell's scatter holds
  /// a hand's tremor as well as the sensor's own noise, and these are the poses with the least of it. Poses that differ
  /// from the stillest one only by chance count too: a short one alone would say little. 0 for a cell without readings
  /// there.
  [[nodiscard]] std::vector<double> noiseOfCells() const {
    constexpr double kByChance = 3;  // standard errors
    std::vector<double> noise_g2(table_.cellCount(), 0);
    std::vector<double> freedom(table_.cellCount(), 0);
    const std::vector<PoseScatter> poses = scatterOfPoses();
    const auto stillest = std::ranges::min_element(poses, {}, &PoseScatter::median_g2);
    for (const PoseScatter& pose : poses) {
      const double chance = 1 + kByChance * std::hypot(pose.error, stillest->error);
      if (pose.median_g2 > chance * stillest->median_g2) continue;
      for (std::size_t cell = 0; cell < table_.cellCount(); ++cell) {
        const GravityTable::Entry& entry = table_.at(cell, pose.pose);
        if (!entry.usable) continue;
        const double weight = std::max(1.0, entry.count - 1);
        noise_g2[cell] += weight * entry.own_variance_g2 * entry.count;
        freedom[cell] += weight;
      }
    }
    for (std::size_t cell = 0; cell < noise_g2.size(); ++cell) {
      if (freedom[cell] > 0) noise_g2[cell] /= freedom[cell];
    }
    return noise_g2;
  }

  /// Variance that the sensor's own noise leaves in a mean of a cell, per axis, without tremor: it falls with the
  /// length of the window, down to that of the offset's instability.
  [[nodiscard]] double ownVariance(std::size_t cell, std::size_t pose) const {
    constexpr double kMin_g2 = 1e-12;  // a model may have neither noise nor steps
    const GravityTable::Entry& entry = table_.at(cell, pose);
    const double own_g2 = noise_g2_[cell] > 0 ? noise_g2_[cell] / entry.count : entry.own_variance_g2;
    const double unstable_g = model_.accelerometer.offset_instability_sigma_g;
    return std::max(own_g2, kMin_g2) + unstable_g * unstable_g;
  }

  /// Ports at which the cell has links that are not muted.
  [[nodiscard]] std::vector<PortNumber> linkedPorts(std::size_t cell) const {
    std::vector<PortNumber> ports;
    for (const std::size_t k : graph_.linksAt(cell)) {
      const GraphLink& link = graph_.links()[k];
      if (!link.muted()) ports.push_back(link.source == cell ? link.source_port : link.target_port);
    }
    return ports;
  }

  const CellModel& model_;
  bool joint_;
  SkinGraph graph_;
  SessionSnapshot everything_;
  std::vector<Finding> ignored_;  ///< the reconstruction has them
  GravityTable table_;
  std::unordered_map<PoseId, std::size_t> place_of_;  ///< the first of each ID
  std::size_t left_out_ = 0;
  std::vector<double> noise_g2_;  ///< per cell, of one sample
};

double rootMeanSquare(const std::vector<HoldOutCell>& cells, double HoldOutCell::*value) {
  double sum = 0;
  for (const HoldOutCell& cell : cells) sum += cell.*value * (cell.*value);
  return std::sqrt(sum / static_cast<double>(cells.size()));
}

void judge(HoldOutResult& result) {
  double worst = 0;
  for (const HoldOutCell& cell : result.cells) worst = std::max(worst, cell.error_rad / cell.expected_rad);
  const std::array<std::pair<double, Limits>, 3> ratios = {
      {{result.rms_rad / result.expected_rms_rad, kRms},
       {worst, kCell},
       {result.turning_rad_s2 / result.expected_turning_rad_s2, kTurning}}};
  result.agreement = HoldOutAgreement::AsStated;
  for (const auto& [ratio, limits] : ratios) {
    const HoldOutAgreement found = ratio > limits.far_worse ? HoldOutAgreement::FarWorse
                                   : ratio > limits.worse   ? HoldOutAgreement::Worse
                                                            : HoldOutAgreement::AsStated;
    result.agreement = std::max(result.agreement, found);
  }
}

}  // namespace

HoldOutResult evaluateHoldOut(const SessionSnapshot& snapshot, PoseId pose, const SolverOptions& options,
                              const std::stop_token& stop) {
  options.validate();
  SessionSnapshot others = snapshot;
  if (std::erase_if(others.poses, [pose](const SessionPose& p) { return p.capture->id == pose; }) == 0) {
    throw InvalidArgument(message("hold-out: there is no pose {}", pose));
  }
  HoldOutResult result;
  result.pose = pose;
  result.other_poses = static_cast<std::size_t>(std::ranges::count(others.poses, false, &SessionPose::disabled));
  if (result.other_poses < kFewestOtherPoses) return result;
  result.outcome = HoldOutOutcome::Stopped;
  if (stop.stop_requested()) return result;
  const auto reconstruction = reconstruct(others, options, nullptr, stop);
  if (!reconstruction) return result;
  HoldOut hold_out(snapshot, pose, options);
  for (const Finding& finding : reconstruction->findings) {
    if (finding.code == FindingCode::TurnedGroup) hold_out.leaveOut(finding.cells);
  }
  for (const PatchReconstruction& patch : reconstruction->patches) {
    if (stop.stop_requested()) return result;
    hold_out.evaluate(patch, result);
  }
  result.outcome = result.cells.empty() ? HoldOutOutcome::NothingToCompare : HoldOutOutcome::Evaluated;
  if (result.cells.empty()) return result;
  result.rms_rad = rootMeanSquare(result.cells, &HoldOutCell::error_rad);
  result.expected_rms_rad = rootMeanSquare(result.cells, &HoldOutCell::expected_rad);
  result.expected_turning_rad_s2 = std::sqrt(3.0) * kAngularAccelerationSigma * kStandardGravity;
  result.detectable_rad = kDetectable * result.expected_rms_rad;
  result.coarse = result.detectable_rad > kCoarse_rad;
  result.turned = result.turning_rad_s2 > kTurning.worse * result.expected_turning_rad_s2;
  judge(result);
  return result;
}

}  // namespace hexoderm
