#include "hexoderm/reconstruction/reconstructor.h"

#include "hexoderm/geometry/alignment.h"
#include "hexoderm/geometry/covariance.h"
#include "hexoderm/util/error.h"
#include "hexoderm/util/text.h"
#include "hexoderm/util/units.h"

#include "hexoderm/reconstruction/advice/verdict.h"
#include "hexoderm/reconstruction/faults/cell_health.h"
#include "hexoderm/reconstruction/faults/suspects.h"
#include "hexoderm/reconstruction/figures/pose_summary.h"
#include "hexoderm/reconstruction/joint/joint_refinement.h"
#include "hexoderm/reconstruction/links/edge_rotation.h"
#include "hexoderm/reconstruction/links/gravity_table.h"
#include "hexoderm/reconstruction/links/skin_readings.h"
#include "hexoderm/reconstruction/links/tree_placement.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <map>
#include <optional>
#include <set>
#include <stop_token>

namespace hexoderm {
namespace {

/// One patch on its way: placed along the tree, then perhaps jointly.
struct PatchWork {
  std::size_t patch = 0;
  std::size_t origin = 0;
  ShortestPaths paths;
  std::vector<TreePlacement> placements;  ///< per cell of the graph
  std::unique_ptr<JointRefinement> joint;
};

/// Thrown to leave a reconstruction that nobody waits for any more.
Message setAsideInWords(const MutedLink& muted, bool is_reported) {
  const Message link = linkInWords(muted.source, muted.target);
  if (muted.why.empty()) {
    return is_reported ? message("The {} was set aside by hand; it is not used.", link)
                       : message("The {} was set aside by hand, but the skin reports no such link.", link);
  }
  return is_reported
             ? message("The {} was set aside by hand ({}); it is not used.", link, muted.why)
             : message("The {} was set aside by hand ({}), but the skin reports no such link.", link, muted.why);
}

struct Stopped {};

class Reconstructor {
 public:
  Reconstructor(const SessionSnapshot& snapshot, const SolverOptions& options, const Reconstruction* earlier,
                const std::stop_token& stop)
      : snapshot_(snapshot),
        options_(options),
        earlier_(earlier),
        stop_(stop),
        model_(*snapshot.model),
        graph_(model_, *snapshot.neighbors),
        findings_(graph_.findings()),
        table_(snapshot, graph_, findings_),
        readings_(model_, graph_, table_) {}

  std::shared_ptr<const Reconstruction> run() {
    const auto start = std::chrono::steady_clock::now();
    setLinksAside();
    judgeCells(snapshot_, graph_, table_, findings_);
    leaveOutCells();
    estimateEdges();
    findSuspects();
    for (const EdgeRotation& edge : edges_) weights_.push_back(weightOf(edge));

    std::vector<PatchWork> works = placePatches();
    if (options_.solver == Solver::Global) {
      refine(works);
      while (muteOpenLinks(works)) {
        works = placePatches();
        refine(works);
      }
      for (const PatchWork& work : works) findInconsistentPoses(*work.joint);
    }

    leaveIfStopped();
    auto result = std::make_shared<Reconstruction>();
    result->revision = snapshot_.revision;
    result->solver = solverName(options_.solver);
    result->options = options_;
    result->source = snapshot_.source;
    result->model = snapshot_.model;
    for (const PatchWork& work : works) result->patches.push_back(describe(work));
    addLinks(works, *result);
    result->poses = summarisePoses(snapshot_, table_, result->patches);
    judgePoses(result->poses, result->patches, findings_);
    result->findings = std::move(findings_);
    result->layout = computeFlatLayout(model_, result->patches);
    result->verdict = judge(*result);
    result->solve_seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    return result;
  }

 private:
  void leaveIfStopped() const {
    if (stop_.stop_requested()) throw Stopped();
  }

  [[nodiscard]] PoseId poseId(std::size_t pose) const { return snapshot_.poses[pose].capture->id; }
  [[nodiscard]] const Port& sourcePort(const GraphLink& link) const { return model_.port(link.source_port); }
  [[nodiscard]] const Port& targetPort(const GraphLink& link) const { return model_.port(link.target_port); }

  /// What the operator knows to be a cable needs no measurement to be found.
  void setLinksAside() {
    std::vector<std::size_t> links;
    for (const MutedLink& muted : snapshot_.muted_links) {
      const std::optional<std::size_t> link = graph_.indexOf(muted.source, muted.target);
      findings_.push_back(makeFinding(FindingCode::LinkSetAside, setAsideInWords(muted, link.has_value()),
                                      {muted.source.cell, muted.target.cell}, {muted.source.port, muted.target.port}));
      if (link) links.push_back(*link);
    }
    if (!links.empty()) graph_.mute(links, FindingCode::LinkSetAside);
  }

  void leaveOutCells() {
    for (const CellId id : options_.left_out) {
      const std::optional<std::size_t> cell = graph_.indexOf(id);
      if (!cell) throw InvalidArgument(message("there is no cell {} to be left out", id));
      dropReadings(*cell);
      findings_.push_back(makeFinding(FindingCode::LeftOut,
                                      message("Cell {} was left out; it is placed through its links.", id), {id}));
    }
  }

  void dropReadings(std::size_t cell) {
    for (std::size_t pose = 0; pose < table_.poseCount(); ++pose) table_.at(cell, pose).usable = false;
  }

  void estimateEdges() {
    readings_ = SkinReadings(model_, graph_, table_);
    edges_.clear();
    pose_residuals_.clear();
    for (const GraphLink& link : graph_.links()) {
      const EdgeReadings readings = readings_.readingsOf(link);
      EdgeRotation edge = estimateEdgeRotation(model_, sourcePort(link), targetPort(link), readings, options_);
      std::vector<std::optional<double>> residuals(table_.poseCount());
      if (readings_.measured(link)) {
        std::size_t k = 0;
        for (const std::size_t pose : readings_.posesOf(link)) residuals[pose] = edge.pose_residual_rad[k++];
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
    return std::min(kPi, largestDeviation(covariance));
  }

  /// Removes the worst pose or cell and looks again, until what is left to blame are links.
  void findSuspects() {
    for (;;) {
      leaveIfStopped();
      const SuspectSearch search(model_, graph_, table_, readings_, edges_, options_);
      if (const auto pose = search.worstPose()) {
        findings_.push_back(
            makeFinding(FindingCode::InconsistentPose,
                        message("In pose {} most neighbouring cells contradict each other, and without it they don't: "
                                "the part probably moved while it was sampled. The pose is not used; take it again.",
                                poseId(*pose)),
                        {}, {}, {poseId(*pose)}));
        for (std::size_t cell = 0; cell < table_.cellCount(); ++cell) table_.at(cell, *pose).usable = false;
        estimateEdges();
        continue;
      }
      if (const auto cell = search.worstCell()) {
        findings_.push_back(describeBadSensor(graph_, table_, snapshot_, *cell, false));
        dropReadings(*cell);
        estimateEdges();
        continue;
      }
      std::map<FindingCode, std::vector<std::size_t>> bad;
      for (const SuspectSearch::BadLink& link : search.badLinks()) {
        bad[link.findings.front().code].push_back(link.link);
        findings_.insert(findings_.end(), link.findings.begin(), link.findings.end());
      }
      for (const auto& [code, links] : bad) graph_.mute(links, code);
      return;
    }
  }

  [[nodiscard]] double weightOf(const EdgeRotation& edge) const {
    if (options_.weights == LinkWeights::Paper) return paperWeight(edge.quality);
    // In degrees, so that it reads like the figures beside it; never so small that a path of many links costs nothing.
    constexpr double kLeast = 0.1;
    return std::max(kLeast, toDegrees(std::hypot(worstSigma(edge.covariance), edge.residual_rad)));
  }

  /// `link_index`: the link that the cell is placed by; of the origin, one of its own; kNoIndex if it has none.
  [[nodiscard]] Eigen::Matrix3d attitudeCovariance(std::size_t cell, std::size_t link_index) const {
    if (readings_.interpolated(cell) && link_index != kNoIndex) {
      const GraphLink& link = graph_.links()[link_index];
      const auto sides = std::ranges::count_if(graph_.linksAt(cell), [&](std::size_t k) {
        return !graph_.links()[k].muted() && readings_.measured(graph_.links()[k].other(cell));
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

  std::vector<PatchWork> placePatches() {
    in_tree_.assign(edges_.size(), false);
    std::vector<PatchWork> works;
    for (std::size_t patch = 0; patch < graph_.patches().size(); ++patch) works.push_back(placePatch(patch));
    return works;
  }

  PatchWork placePatch(std::size_t patch) {
    PatchWork work;
    work.patch = patch;
    work.origin = findOrigin(graph_, weights_, patch);
    work.paths = findShortestPaths(graph_, weights_, work.origin);
    std::vector<Eigen::Matrix3d> attitude(graph_.cells().size(), Eigen::Matrix3d::Zero());
    std::size_t first_link = kNoIndex;
    for (const std::size_t cell : work.paths.order) {
      if (cell == work.origin) continue;
      if (first_link == kNoIndex) first_link = work.paths.link[cell];
      in_tree_[work.paths.link[cell]] = true;
      attitude[cell] = attitudeCovariance(cell, work.paths.link[cell]);
    }
    attitude[work.origin] = attitudeCovariance(work.origin, first_link);
    work.placements = placeAlongTree(graph_, model_, work.paths, edges_, attitude);
    return work;
  }

  /// The joint estimate of every patch. A cell whose readings fit the gravity of all others in no position is left out
  /// and the rest solved again, the worst cell first.
  void refine(std::vector<PatchWork>& works) {
    std::vector<Finding> found;
    for (PatchWork& work : works) {
      const std::vector<std::size_t>& cells = graph_.patches()[work.patch];
      work.joint = std::make_unique<JointRefinement>(model_, graph_, table_, options_, cells, work.origin,
                                                     startingPlacements(work));
      work.joint->solve(stop_);
      leaveIfStopped();
      bool dropped = false;
      while (const auto cell = worstSensor(*work.joint, cells)) {
        const auto links =
            std::ranges::count_if(graph_.linksAt(*cell), [&](std::size_t k) { return !graph_.links()[k].muted(); });
        findings_.push_back(describeBadSensor(graph_, table_, snapshot_, *cell, links == 1));
        dropReadings(*cell);
        work.joint->leaveOut(*cell);
        work.joint->solve(stop_);
        leaveIfStopped();
        dropped = true;
      }
      if (dropped) estimateEdges();
    }
  }

  /// In every patch the link that leaves its loops open by more than askew cells can: a cable that looks like a skin
  /// link in its angles. One at a time, because the others give way to it. False: there is none.
  bool muteOpenLinks(const std::vector<PatchWork>& works) {
    const double limit_m = options_.max_opening * model_.link_sigma_m;
    std::vector<std::size_t> open;
    for (const PatchWork& work : works) {
      const auto widest = work.joint->widestOpen();
      if (!widest || widest->opening_m <= limit_m) continue;
      open.push_back(widest->link);
      const LinkEnd source = graph_.sourceEnd(graph_.links()[widest->link]);
      const LinkEnd target = graph_.targetEnd(graph_.links()[widest->link]);
      findings_.push_back(makeFinding(
          FindingCode::LinkDoesNotClose,
          message("With all other links the ends of the {} come to lie {} apart, and a skin link leaves no more "
                  "than {}: it is probably a cable, or another link of the loop is. The link is not used.",
                  linkInWords(source, target), Millimetres{widest->opening_m, 0}, Millimetres{limit_m, 0}),
          {source.cell, target.cell}, {source.port, target.port}));
    }
    graph_.mute(open, FindingCode::LinkDoesNotClose);
    return !open.empty();
  }

  /// Where the earlier result had the cells of this patch, if it had just these from the same origin; else the tree's.
  [[nodiscard]] std::vector<SE3> startingPlacements(const PatchWork& work) const {
    const std::vector<std::size_t>& cells = graph_.patches()[work.patch];
    std::vector<SE3> placements(graph_.cells().size());
    for (const std::size_t cell : cells) placements[cell] = work.placements[cell].T_o_u;
    if (earlier_ == nullptr || earlier_->solver != solverName(Solver::Global)) return placements;
    const PatchReconstruction* patch = earlier_->find(graph_.cells()[work.origin].id).patch;
    const bool same =
        patch != nullptr && patch->origin == graph_.cells()[work.origin].id &&
        std::ranges::equal(
            cells, patch->cells, {}, [&](std::size_t cell) { return graph_.cells()[cell].id; }, &CellPlacement::cell);
    for (std::size_t k = 0; same && k < cells.size(); ++k) placements[cells[k]] = patch->cells[k].T_o_u;
    return placements;
  }

  [[nodiscard]] std::optional<std::size_t> worstSensor(const JointRefinement& joint,
                                                       const std::vector<std::size_t>& cells) const {
    // Of two cells neither is the odd one out.
    constexpr std::size_t kFewestForAVote = 3;
    if (cells.size() < kFewestForAVote) return std::nullopt;
    // With hundreds of poses the smallest misfit is significant; only one that also matters makes a sensor useless.
    constexpr double kLeastTimes = 2;
    std::optional<std::size_t> worst;
    double worst_misfit = options_.max_misfit;
    for (const std::size_t cell : cells) {
      if (!readings_.measured(cell) || table_.usablePoses(cell).size() < 2) continue;
      const Misfit found = joint.misfitOf(cell);
      const double misfit = found.deviate();
      if (misfit <= worst_misfit || found.chi_squared < kLeastTimes * found.degrees) continue;
      worst = cell;
      worst_misfit = misfit;
    }
    return worst;
  }

  /// A part that moved while it was sampled leaves contradictions between all cells of that pose.
  void findInconsistentPoses(const JointRefinement& joint) {
    // Tremor leaves a few standard deviations everywhere; one pose far beyond the others is the odd one out.
    constexpr double kLargest = 8;
    constexpr double kTimesOthers = 3;
    if (joint.poses().size() < 3) return;
    std::vector<double> misfits;
    for (const std::size_t pose : joint.poses()) misfits.push_back(joint.poseMisfit(pose));
    std::vector<double> sorted = misfits;
    std::ranges::sort(sorted);
    const double usual = sorted[sorted.size() / 2];
    for (std::size_t k = 0; k < misfits.size(); ++k) {
      if (misfits[k] < std::max(kLargest, kTimesOthers * usual)) continue;
      const PoseId id = poseId(joint.poses()[k]);
      findings_.push_back(
          makeFinding(FindingCode::InconsistentPose,
                      message("In pose {} the cells contradict each other by {} times their noise (other poses {}): "
                              "the part probably moved while it was sampled. Take the pose again.",
                              id, Number{misfits[k], 0}, Number{usual, 1}),
                      {}, {}, {id}));
    }
  }

  PatchReconstruction describe(const PatchWork& work) const {
    PatchReconstruction result;
    result.id = PatchId(static_cast<std::uint32_t>(work.patch));
    result.origin = graph_.cells()[work.origin].id;
    for (const std::size_t cell : graph_.patches()[work.patch]) {
      CellPlacement placement;
      placement.cell = graph_.cells()[cell].id;
      placement.body_part = graph_.cells()[cell].body_part;
      placement.placed_by = readings_.measured(cell) ? PlacedBy::Samples : PlacedBy::Links;
      if (work.joint) {
        placement.T_o_u = work.joint->placementOf(cell);
        placement.cov_t_r = work.joint->covarianceOf(cell);
        if (readings_.measured(cell)) {
          placement.accel_offset_g = work.joint->sensorOf(cell).offset_g;
          placement.accel_scale = work.joint->sensorOf(cell).gain.diagonal();
        }
      } else {
        placement.T_o_u = work.placements[cell].T_o_u;
        placement.cov_t_r = work.placements[cell].covariance;
      }
      for (std::size_t step = cell; step != kNoIndex; step = work.paths.predecessor[step]) {
        placement.path.push_back(graph_.cells()[step].id);
      }
      std::ranges::reverse(placement.path);
      for (const CellSensor& sensor : model_.sensors) {
        placement.sensors.push_back({sensor.name, sensor.type, placement.T_o_u * sensor.T_u_s});
      }
      result.cells.push_back(std::move(placement));
    }
    if (work.joint) {
      const JointSolution& solution = work.joint->solution();
      for (std::size_t k = 0; k < work.joint->poses().size(); ++k) {
        const Eigen::Vector3d& force = solution.state.force_o[k];
        const Eigen::Vector3d up = force.normalized();
        // Across the direction: [up]x takes what lies along it away.
        const Eigen::Matrix3d across = skew(up) * solution.covariance->force(k) * skew(up).transpose();
        const Eigen::Vector3d swing = solution.state.acceleration_o[k] / kStandardGravity;
        result.gravity.push_back({poseId(work.joint->poses()[k]), up, worstSigma(across) / force.norm(),
                                  GravityDirection::Force{force - swing.cross(solution.state.middle_o), swing}});
      }
      result.gap_share = GapShareEstimate{solution.state.gap_share, solution.covariance->gapShareSigma()};
      result.covariance = work.joint->placementCovariance(graph_);
    } else {
      result.gravity = gravityDirections(work);
    }
    return result;
  }

  [[nodiscard]] std::vector<GravityDirection> gravityDirections(const PatchWork& work) const {
    std::vector<GravityDirection> directions;
    for (const std::size_t pose : table_.enabledPoses()) {
      std::vector<Eigen::Vector3d> seen;
      for (const std::size_t cell : graph_.patches()[work.patch]) {
        if (table_.at(cell, pose).usable) {
          seen.push_back(work.placements[cell].T_o_u.R * table_.at(cell, pose).mean_g.normalized());
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

  void addLinks(const std::vector<PatchWork>& works, Reconstruction& result) const {
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
      estimate.centred = edge.centred;
      estimate.supported = edge.supported;
      estimate.used = !link.muted();
      estimate.in_tree = !link.muted() && in_tree_[k];
      estimate.muted_by = link.muted_by;
      estimate.pose_residual_rad = pose_residuals_[k];
      const std::uint32_t patch = graph_.cells()[link.source].patch.value();
      if (const JointRefinement* joint = works[patch].joint.get(); joint != nullptr && !link.muted()) {
        estimateJointly(*joint, k, estimate);
      }
      const LinkAngles angles = linkAngles(estimate.R_c_n, sourcePort(link), targetPort(link));
      estimate.bend_rad = angles.bend_rad;
      estimate.twist_rad = angles.twist_rad;
      estimate.yaw_rad = angles.yaw_rad;
      result.patches[patch].links.push_back(std::move(estimate));
    }
  }

  /// A link's rotation and predicted deviation follow from the placements; its residuals are of readings freed from the
  /// estimated errors of their sensors.
  void estimateJointly(const JointRefinement& joint, std::size_t index, LinkEstimate& estimate) const {
    const GraphLink& link = graph_.links()[index];
    estimate.R_c_n = joint.placementOf(link.source).R.transpose() * joint.placementOf(link.target).R;
    estimate.sigma_rad = worstSigma(joint.linkCovariance(index));
    estimate.centred = false;
    estimate.supported = false;
    if (!readings_.measured(link)) return;
    double sum = 0;
    std::size_t count = 0;
    for (const std::size_t pose : readings_.posesOf(link)) {
      const Eigen::Vector3d c = joint.correctedReading(link.source, table_.at(link.source, pose).mean_g);
      const Eigen::Vector3d n = joint.correctedReading(link.target, table_.at(link.target, pose).mean_g);
      const double angle = angleBetween(c, estimate.R_c_n * n);
      estimate.pose_residual_rad[pose] = angle;
      sum += angle * angle;
      ++count;
    }
    if (count > 0) estimate.residual_rad = std::sqrt(sum / static_cast<double>(count));
  }

  const SessionSnapshot& snapshot_;
  const SolverOptions& options_;
  const Reconstruction* earlier_;
  const std::stop_token& stop_;
  const CellModel& model_;
  SkinGraph graph_;
  std::vector<Finding> findings_;
  GravityTable table_;
  SkinReadings readings_;
  std::vector<EdgeRotation> edges_;  ///< per link of the graph
  std::vector<std::vector<std::optional<double>>> pose_residuals_;
  std::vector<double> weights_;  ///< per link
  std::vector<bool> in_tree_;    ///< per link
};

}  // namespace

std::shared_ptr<const Reconstruction> reconstruct(const SessionSnapshot& snapshot, const SolverOptions& options,
                                                  const Reconstruction* earlier, const std::stop_token& stop) {
  options.validate();
  try {
    return Reconstructor(snapshot, options, earlier, stop).run();
  } catch (const Stopped&) {
    return nullptr;
  }
}

}  // namespace hexoderm
