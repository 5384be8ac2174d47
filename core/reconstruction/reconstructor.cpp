#include "hexoderm/reconstruction/reconstructor.h"

#include "hexoderm/geometry/alignment.h"
#include "hexoderm/reconstruction/link_plausibility.h"
#include "hexoderm/util/text.h"
#include "hexoderm/util/units.h"

#include "cell_health.h"
#include "edge_rotation.h"
#include "gravity_table.h"
#include "tree_placement.h"
#include "verdict.h"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <chrono>
#include <cmath>
#include <map>
#include <optional>

namespace hexoderm {
namespace {

// A link is judged by its angles only where the poses fix them.
constexpr double kJudgeableSigma = 15 * kDegree;
// Two poses whose gravity lines are closer than this tell little more than one.
constexpr double kRepeatedAngle = 10 * kDegree;

class TreeReconstructor {
 public:
  TreeReconstructor(const SessionSnapshot& snapshot, const SolverOptions& options)
      : snapshot_(snapshot),
        options_(options),
        model_(*snapshot.model),
        graph_(model_, *snapshot.neighbors),
        findings_(graph_.findings()),
        table_(snapshot, graph_, findings_) {}

  std::shared_ptr<const Reconstruction> run() {
    const auto start = std::chrono::steady_clock::now();
    judgeCells(snapshot_, graph_, table_, findings_);
    fillMissingReadings();
    estimateEdges();
    muteBadLinks();

    auto result = std::make_shared<Reconstruction>();
    result->revision = snapshot_.revision;
    result->solver = solverName(options_.solver);
    result->options = options_;
    result->source = snapshot_.source;
    result->model = snapshot_.model;
    for (const EdgeRotation& edge : edges_) weights_.push_back(weightOf(edge));
    in_tree_.resize(edges_.size(), false);
    for (std::size_t patch = 0; patch < graph_.patches().size(); ++patch) result->patches.push_back(solvePatch(patch));
    addLinks(*result);
    result->poses = summarisePoses(*result);
    judgePoses(*result);
    result->findings = std::move(findings_);
    result->layout = computeFlatLayout(model_, result->patches);
    result->verdict = judge(*result);
    result->solve_seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    return result;
  }

 private:
  [[nodiscard]] PoseId poseId(std::size_t pose) const { return snapshot_.poses[pose].capture->id; }
  [[nodiscard]] const Port& sourcePort(const GraphLink& link) const { return model_.port(link.source_port); }
  [[nodiscard]] const Port& targetPort(const GraphLink& link) const { return model_.port(link.target_port); }

  /// A cell without any usable reading would cut its chain: its gravity is taken half way between its neighbours', as
  /// their nominal alignment brings it over. Such a cell is placed by its links and says so.
  void fillMissingReadings() {
    const std::size_t cells = graph_.cells().size();
    measured_.assign(cells, false);
    gravity_.assign(cells, {});
    std::vector<std::size_t> blind;
    for (std::size_t cell = 0; cell < cells; ++cell) {
      const std::vector<std::size_t> poses = table_.usablePoses(cell);
      measured_[cell] = !poses.empty();
      gravity_[cell].assign(table_.poseCount(), Eigen::Vector3d::Zero());
      for (const std::size_t pose : poses) gravity_[cell][pose] = table_.at(cell, pose).mean_g;
      if (!measured_[cell]) blind.push_back(cell);
    }
    if (blind.empty() || table_.enabledPoses().empty()) return;

    // First outwards from the cells that read, then a few rounds for chains of several blind ones.
    constexpr int kRounds = 20;
    for (int round = 0; round < kRounds; ++round) {
      for (const std::size_t cell : blind) {
        for (const std::size_t pose : table_.enabledPoses()) {
          Eigen::Vector3d sum = Eigen::Vector3d::Zero();
          for (const std::size_t link_index : graph_.linksAt(cell)) {
            const GraphLink& link = graph_.links()[link_index];
            if (link.muted()) continue;
            const Eigen::Vector3d& g = gravity_[link.other(cell)][pose];
            if (g.isZero()) continue;
            Eigen::Matrix3d R_nom = nominalAlignment(sourcePort(link), targetPort(link));
            if (link.source != cell) R_nom.transposeInPlace();
            sum += R_nom * g.normalized();
          }
          if (sum.norm() > 1e-6) gravity_[cell][pose] = sum.normalized();
        }
      }
    }
  }

  [[nodiscard]] EdgeReadings readingsOf(const GraphLink& link) const {
    std::vector<std::size_t> poses;
    for (const std::size_t pose : table_.enabledPoses()) {
      if (!gravity_[link.source][pose].isZero() && !gravity_[link.target][pose].isZero()) poses.push_back(pose);
    }
    EdgeReadings readings;
    const auto count = static_cast<Eigen::Index>(poses.size());
    readings.c_g.resize(3, count);
    readings.n_g.resize(3, count);
    for (Eigen::Index k = 0; k < count; ++k) {
      const std::size_t pose = poses[static_cast<std::size_t>(k)];
      readings.c_g.col(k) = gravity_[link.source][pose];
      readings.n_g.col(k) = gravity_[link.target][pose];
      readings.variance_g2.push_back(table_.at(link.source, pose).variance_g2 +
                                     table_.at(link.target, pose).variance_g2);
    }
    return readings;
  }

  void estimateEdges() {
    edges_.clear();
    pose_residuals_.clear();
    for (const GraphLink& link : graph_.links()) {
      const EdgeReadings readings = readingsOf(link);
      EdgeRotation edge = estimateEdgeRotation(model_, sourcePort(link), targetPort(link), readings, options_);
      std::vector<std::optional<double>> residuals(table_.poseCount());
      if (measured_[link.source] && measured_[link.target]) {
        std::size_t k = 0;
        for (const std::size_t pose : table_.enabledPoses()) {
          if (gravity_[link.source][pose].isZero() || gravity_[link.target][pose].isZero()) continue;
          residuals[pose] = edge.pose_residual_rad[k++];
        }
      } else if (readings.n_g.cols() > 0) {
        markAsGuessed(edge, link);
      }
      edges_.push_back(std::move(edge));
      pose_residuals_.push_back(std::move(residuals));
    }
  }

  /// One end does not measure: the rotation is interpolated, and nothing but the elastomer prior speaks for it.
  void markAsGuessed(EdgeRotation& edge, const GraphLink& link) const {
    edge.quality = EdgeQuality::Undefined;
    edge.singular_values.setZero();
    edge.residual_rad = 0;
    edge.expected_residual_rad = 0;
    edge.prior_part.setZero();  // it is the blind cell that may lie otherwise, not what comes after it
    edge.covariance = elastomerPrior(sourcePort(link));
  }

  /// How far a link may bend, twist and yaw, as a covariance in the frame of the cell that the port belongs to.
  [[nodiscard]] Eigen::Matrix3d elastomerPrior(const Port& port) const {
    const Eigen::Vector3d u = port.vector_m.normalized();
    const Eigen::Vector3d z = Eigen::Vector3d::UnitZ();
    Eigen::Matrix3d axes;
    axes << u, z.cross(u), z;
    const Eigen::Vector3d prior(model_.twist_sigma_rad, model_.bend_sigma_rad, model_.yaw_sigma_rad);
    return axes * prior.cwiseAbs2().asDiagonal() * axes.transpose();
  }

  [[nodiscard]] static double worstSigma(const Eigen::Matrix3d& covariance) {
    const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver(covariance, Eigen::EigenvaluesOnly);
    return std::min(kPi, std::sqrt(std::max(0.0, solver.eigenvalues().maxCoeff())));
  }

  /// Links that no skin link can be: their angles, or cells that moved against each other between poses.
  void muteBadLinks() {
    std::map<FindingCode, std::vector<std::size_t>> bad;
    for (std::size_t k = 0; k < edges_.size(); ++k) {
      const GraphLink& link = graph_.links()[k];
      const EdgeRotation& edge = edges_[k];
      if (link.muted() || !measured_[link.source] || !measured_[link.target]) continue;
      const LinkEnd source = graph_.sourceEnd(link);
      const LinkEnd target = graph_.targetEnd(link);
      const double sigma = worstSigma(edge.covariance);
      if (sigma < kJudgeableSigma && !edge.supported) {
        const std::vector<Finding> implausible = judgeLinkAngles(
            linkAngles(edge.R_c_n, sourcePort(link), targetPort(link)), source, target, options_, sigma);
        if (!implausible.empty()) bad[implausible.front().code].push_back(k);
        findings_.insert(findings_.end(), implausible.begin(), implausible.end());
        if (!implausible.empty()) continue;
      }
      if (edge.residual_rad > options_.max_residual_ratio * edge.expected_residual_rad &&
          edge.expected_residual_rad > 0) {
        bad[FindingCode::LinkNotRigid].push_back(k);
        findings_.push_back(
            makeFinding(FindingCode::LinkNotRigid,
                        "The cells of the " + linkInWords(source, target) + " moved against each other by about " +
                            formatFixed(toDegrees(edge.residual_rad), 1) + "° between poses (limit " +
                            formatFixed(toDegrees(options_.max_residual_ratio * edge.expected_residual_rad), 1) +
                            "°): probably a joint or a cable, or one of the two sensors is bad. The link is not used.",
                        {source.cell, target.cell}, {source.port, target.port}));
      }
    }
    for (const auto& [code, links] : bad) graph_.mute(links, code);
  }

  [[nodiscard]] double weightOf(const EdgeRotation& edge) const {
    if (options_.weights == LinkWeights::Paper) return paperWeight(edge.quality);
    // In degrees, so that it reads like the figures beside it; never so small that a path of many links costs nothing.
    constexpr double kLeast = 0.1;
    return std::max(kLeast, toDegrees(std::hypot(worstSigma(edge.covariance), edge.residual_rad)));
  }

  /// `link_index`: the link that the cell is placed by; of the origin, one of its own; kNoIndex if it has none.
  [[nodiscard]] Eigen::Matrix3d attitudeCovariance(std::size_t cell, std::size_t link_index) const {
    const bool interpolated =
        !measured_[cell] && std::ranges::any_of(gravity_[cell], [](const Eigen::Vector3d& g) { return !g.isZero(); });
    if (interpolated && link_index != kNoIndex) {
      const GraphLink& link = graph_.links()[link_index];
      const auto sides = std::ranges::count_if(graph_.linksAt(cell), [&](std::size_t k) {
        return !graph_.links()[k].muted() && measured_[graph_.links()[k].other(cell)];
      });
      // Half way between two neighbours, half of each link's bend is what may be wrong.
      return elastomerPrior(link.source == cell ? sourcePort(link) : targetPort(link)) / (sides >= 2 ? 2 : 1);
    }
    const EdgeRotation* edge = link_index == kNoIndex ? nullptr : &edges_[link_index];
    const std::vector<std::size_t> poses = table_.usablePoses(cell);
    Eigen::Matrix3Xd g(3, static_cast<Eigen::Index>(poses.size()));
    std::vector<double> variance;
    for (std::size_t k = 0; k < poses.size(); ++k) {
      g.col(static_cast<Eigen::Index>(k)) = table_.at(cell, poses[k]).mean_g;
      variance.push_back(table_.at(cell, poses[k]).variance_g2);
    }
    const bool centred = edge != nullptr && edge->centred && poses.size() >= 3;
    const bool supported = edge == nullptr || edge->supported || poses.size() < 2;
    return cellAttitudeCovariance(model_.accelerometer, g, variance, centred, supported);
  }

  PatchReconstruction solvePatch(std::size_t patch) {
    const std::size_t origin = findOrigin(graph_, weights_, patch);
    const ShortestPaths paths = findShortestPaths(graph_, weights_, origin);

    std::vector<Eigen::Matrix3d> attitude(graph_.cells().size(), Eigen::Matrix3d::Zero());
    std::size_t first_link = kNoIndex;
    for (const std::size_t cell : paths.order) {
      if (cell == origin) continue;
      if (first_link == kNoIndex) first_link = paths.link[cell];
      in_tree_[paths.link[cell]] = true;
      attitude[cell] = attitudeCovariance(cell, paths.link[cell]);
    }
    attitude[origin] = attitudeCovariance(origin, first_link);
    const std::vector<TreePlacement> placements = placeAlongTree(graph_, model_, paths, edges_, attitude);

    PatchReconstruction result;
    result.id = PatchId(static_cast<std::uint32_t>(patch));
    result.origin = graph_.cells()[origin].id;
    for (const std::size_t cell : graph_.patches()[patch]) {
      CellPlacement placement;
      placement.cell = graph_.cells()[cell].id;
      placement.body_part = graph_.cells()[cell].body_part;
      placement.placed_by = measured_[cell] ? PlacedBy::Samples : PlacedBy::Links;
      placement.T_o_u = placements[cell].T_o_u;
      placement.cov_t_r = placements[cell].covariance;
      for (std::size_t step = cell; step != kNoIndex; step = paths.predecessor[step]) {
        placement.path.push_back(graph_.cells()[step].id);
      }
      std::ranges::reverse(placement.path);
      for (const CellSensor& sensor : model_.sensors) {
        placement.sensors.push_back({sensor.name, sensor.type, placement.T_o_u * sensor.T_u_s});
      }
      result.cells.push_back(std::move(placement));
    }
    result.gravity = gravityDirections(patch, placements);
    return result;
  }

  [[nodiscard]] std::vector<GravityDirection> gravityDirections(std::size_t patch,
                                                                const std::vector<TreePlacement>& placements) const {
    std::vector<GravityDirection> directions;
    for (const std::size_t pose : table_.enabledPoses()) {
      std::vector<Eigen::Vector3d> seen;
      for (const std::size_t cell : graph_.patches()[patch]) {
        if (table_.at(cell, pose).usable) {
          seen.push_back(placements[cell].T_o_u.R * table_.at(cell, pose).mean_g.normalized());
        }
      }
      Eigen::Vector3d sum = Eigen::Vector3d::Zero();
      for (const Eigen::Vector3d& g : seen) sum += g;
      if (sum.norm() < 1e-6) continue;
      GravityDirection direction{poseId(pose), sum.normalized(), 0};
      double scatter = 0;
      for (const Eigen::Vector3d& g : seen) scatter += std::pow(angleBetween(g, direction.g_o), 2);
      direction.sigma_rad = std::sqrt(scatter) / static_cast<double>(seen.size());
      directions.push_back(direction);
    }
    return directions;
  }

  void addLinks(Reconstruction& result) const {
    for (std::size_t k = 0; k < edges_.size(); ++k) {
      const GraphLink& link = graph_.links()[k];
      const EdgeRotation& edge = edges_[k];
      LinkEstimate estimate;
      estimate.source = graph_.sourceEnd(link);
      estimate.target = graph_.targetEnd(link);
      estimate.R_c_n = edge.R_c_n;
      estimate.quality = edge.quality;
      estimate.singular_values = edge.singular_values;
      estimate.weight = weights_[k];
      estimate.residual_rad = edge.residual_rad;
      estimate.sigma_rad = worstSigma(edge.covariance);
      const LinkAngles angles = linkAngles(edge.R_c_n, sourcePort(link), targetPort(link));
      estimate.bend_rad = angles.bend_rad;
      estimate.twist_rad = angles.twist_rad;
      estimate.yaw_rad = angles.yaw_rad;
      estimate.centred = edge.centred;
      estimate.supported = edge.supported;
      estimate.used = !link.muted();
      estimate.in_tree = !link.muted() && in_tree_[k];
      estimate.muted_by = link.muted_by;
      estimate.pose_residual_rad = pose_residuals_[k];
      result.patches[graph_.cells()[link.source].patch.value()].links.push_back(std::move(estimate));
    }
  }

  [[nodiscard]] std::vector<PoseSummary> summarisePoses(const Reconstruction& result) const {
    const PatchReconstruction* largest = largestPatch(result);
    std::vector<PoseSummary> summaries;
    std::vector<Eigen::Vector3d> earlier;
    std::size_t next_direction = 0;
    for (std::size_t pose = 0; pose < table_.poseCount(); ++pose) {
      PoseSummary summary;
      summary.pose = poseId(pose);
      summary.label = snapshot_.poses[pose].capture->label;
      summary.enabled = !snapshot_.poses[pose].disabled;
      double noise = 0;
      for (std::size_t cell = 0; cell < table_.cellCount(); ++cell) {
        const GravityTable::Entry& entry = table_.at(cell, pose);
        if (!entry.usable) continue;
        ++summary.cells_measured;
        noise += entry.variance_g2;
      }
      if (summary.cells_measured > 0) summary.noise_g = std::sqrt(noise / static_cast<double>(summary.cells_measured));
      if (summary.enabled && largest != nullptr && next_direction < largest->gravity.size() &&
          largest->gravity[next_direction].pose == summary.pose) {
        const Eigen::Vector3d& g = largest->gravity[next_direction++].g_o;
        for (const Eigen::Vector3d& other : earlier) {
          // Opposite directions are the same line: no new rank.
          const double angle = std::min(angleBetween(g, other), angleBetween(g, -other));
          summary.new_by_rad = std::min(angle, summary.new_by_rad.value_or(angle));
        }
        earlier.push_back(g);
      }
      double residual = 0;
      std::size_t links = 0;
      for (const auto& residuals : pose_residuals_) {
        if (!residuals[pose]) continue;
        residual += *residuals[pose] * *residuals[pose];
        ++links;
      }
      if (links > 0) summary.residual_rad = std::sqrt(residual / static_cast<double>(links));
      summaries.push_back(std::move(summary));
    }
    return summaries;
  }

  void judgePoses(const Reconstruction& result) {
    if (result.cellCount() == 0) return;
    if (table_.enabledPoses().empty()) {
      findings_.push_back(makeFinding(FindingCode::NoPoses,
                                      "There is no pose yet: the surface shown follows from ports and priors alone."));
      return;
    }
    std::size_t open = 0;
    std::size_t used = 0;
    for (std::size_t k = 0; k < edges_.size(); ++k) {
      const GraphLink& link = graph_.links()[k];
      if (link.muted() || !measured_[link.source] || !measured_[link.target]) continue;
      ++used;
      if (edges_[k].quality == EdgeQuality::Undefined || edges_[k].quality == EdgeQuality::Partially) ++open;
    }
    if (2 * open > used) {
      findings_.push_back(makeFinding(FindingCode::TooFewDirections,
                                      "Gravity was seen along one line only, so the turn about it is a guess: take a "
                                      "pose in which the part is turned by about 90 degrees about a horizontal axis.",
                                      {}, {}, enabledIds()));
    }
    judgeRepetitions(largestPatch(result)->gravity);
  }

  /// From the third pose on the opposite of an earlier direction helps to separate offsets; a repeated one never does.
  void judgeRepetitions(const std::vector<GravityDirection>& gravity) {
    for (std::size_t later = 1; later < gravity.size(); ++later) {
      for (std::size_t earlier = 0; earlier < later; ++earlier) {
        const double angle = angleBetween(gravity[later].g_o, gravity[earlier].g_o);
        const bool opposite = gravity.size() == 2 && kPi - angle < kRepeatedAngle;
        if (angle >= kRepeatedAngle && !opposite) continue;
        findings_.push_back(
            makeFinding(FindingCode::RepeatedPose,
                        "Pose " + toString(gravity[later].pose) +
                            (opposite ? " is pose " + toString(gravity[earlier].pose) + " upside down"
                                      : " shows gravity where pose " + toString(gravity[earlier].pose) + " does") +
                            " (within " + formatFixed(toDegrees(opposite ? kPi - angle : angle), 0) +
                            "°), which adds no new direction.",
                        {}, {}, {gravity[earlier].pose, gravity[later].pose}));
        break;
      }
    }
  }

  [[nodiscard]] static const PatchReconstruction* largestPatch(const Reconstruction& result) {
    const PatchReconstruction* largest = nullptr;
    for (const PatchReconstruction& patch : result.patches) {
      if (largest == nullptr || patch.cells.size() > largest->cells.size()) largest = &patch;
    }
    return largest;
  }

  [[nodiscard]] std::vector<PoseId> enabledIds() const {
    std::vector<PoseId> ids;
    for (const std::size_t pose : table_.enabledPoses()) ids.push_back(poseId(pose));
    return ids;
  }

  const SessionSnapshot& snapshot_;
  const SolverOptions& options_;
  const CellModel& model_;
  SkinGraph graph_;
  std::vector<Finding> findings_;
  GravityTable table_;
  std::vector<bool> measured_;                         ///< per cell: has usable readings of its own
  std::vector<std::vector<Eigen::Vector3d>> gravity_;  ///< per cell and pose; zero: none; blind cells interpolated
  std::vector<EdgeRotation> edges_;                    ///< per link of the graph
  std::vector<std::vector<std::optional<double>>> pose_residuals_;
  std::vector<double> weights_;  ///< per link
  std::vector<bool> in_tree_;    ///< per link
};

}  // namespace

std::shared_ptr<const Reconstruction> reconstruct(const SessionSnapshot& snapshot, const SolverOptions& options) {
  options.validate();
  return TreeReconstructor(snapshot, options).run();
}

}  // namespace hexoderm
