#include "hexoderm/mounting/attachment/links.h"

#include "hexoderm/base/covariance.h"
#include "hexoderm/base/error.h"
#include "hexoderm/base/limits.h"
#include "hexoderm/base/message.h"
#include "hexoderm/base/units.h"
#include "hexoderm/mounting/attachment/explanations.h"
#include "hexoderm/mounting/attachment/link_fit.h"
#include "hexoderm/mounting/attachment/robot_fit.h"
#include "hexoderm/mounting/parts/compared_poses.h"
#include "hexoderm/robots/joint_check.h"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <set>
#include <utility>

namespace hexoderm {
namespace {

/// A zero whose variance the poses make smaller by this factor is called shown.
constexpr double kShownShare = 0.5;
/// Sigmas, and sigmas of the prior, at which a zero or a tilt is worth saying.
constexpr double kNoteworthy = 3;

/// `patches`: those that were fitted, in the order of the fit; `poses`: those that were compared, by place.
RobotEstimate estimateOf(const RobotFit& fit, std::vector<PatchId> patches, const std::vector<PoseId>& poses,
                         const RobotModel& robot, const LinksOptions& options) {
  RobotEstimate estimate;
  estimate.patches = std::move(patches);
  const auto zero_at = static_cast<Eigen::Index>(3 * estimate.patches.size());
  for (std::size_t j = 0; j < fit.joints.size(); ++j) {
    JointZero& zero = estimate.zeros.emplace_back();
    const auto at = zero_at + static_cast<Eigen::Index>(j);
    zero.joint = robot.joints()[fit.joints[j]].name;
    if (!options.joint_zeros) continue;
    zero.zero_rad = fit.zeros[j];
    zero.prior_sigma_rad = fit.zero_sigma_rad;
    zero.sigma_rad = std::sqrt(std::max(0.0, fit.covariance(at, at)));
    zero.shown = fit.covariance(at, at) < kShownShare * fit.zero_sigma_rad * fit.zero_sigma_rad;
  }
  estimate.up_w = fit.up_w;
  estimate.up_covariance = fit.covariance.bottomRightCorner<3, 3>();
  estimate.tilt_rad = angleBetween(fit.up_w, options.up_w.normalized());
  estimate.tilt_sigma_rad = largestDeviation(estimate.up_covariance);
  estimate.chi_squared = fit.misfit.chi_squared;
  estimate.freedom = fit.misfit.freedom;
  estimate.probability = fit.misfit.probability();
  for (const RobotFit::PoseTurn& turn : fit.pose_turns) {
    estimate.residuals.push_back({poses[turn.place], robot.joints()[turn.joint].name, turn.turn_rad, turn.sigma_rad});
  }
  for (Eigen::Index row = 0; row < fit.covariance.rows(); ++row) {
    for (Eigen::Index column = 0; column < fit.covariance.cols(); ++column) {
      estimate.covariance.push_back(fit.covariance(row, column));
    }
  }
  return estimate;
}

/// Zeros and a tilt that are worth saying, and a fit that is a bad one; a sentence each.
std::vector<Message> findingsOf(const RobotEstimate& estimate, const LinksOptions& options) {
  std::vector<Message> findings;
  for (const JointZero& zero : estimate.zeros) {
    const double size = std::abs(zero.zero_rad);
    if (!zero.shown || size < kNoteworthy * zero.sigma_rad || size < kNoteworthy * options.zero_sigma_rad) continue;
    findings.push_back(
        message("The zero of joint {} seems to be off: {} has to be added to the angle that it reports (1 sigma: {}).",
                zero.joint, Degrees{zero.zero_rad}, Degrees{zero.sigma_rad}));
  }
  if (estimate.tilt_rad > kNoteworthy * std::max(estimate.tilt_sigma_rad, options.tilt_sigma_rad)) {
    findings.push_back(message("The robot's base seems to be tilted by {} (1 sigma: {}).", Degrees{estimate.tilt_rad},
                               Degrees{estimate.tilt_sigma_rad}));
  }
  if (estimate.probability < options.false_alarm) {
    findings.push_back(
        message("Taken together, the patches fit the joint angles badly: a chi-squared of {} at {} degrees of freedom.",
                Number{estimate.chi_squared, 1}, estimate.freedom));
  }
  return findings;
}

/// The poses that can be compared, and what joints and poses have to be left out.
struct UsablePoses {
  std::vector<PoseId> poses;             ///< ascending
  std::set<std::size_t> unknown_joints;  ///< links beyond them can't be compared
  std::vector<Message> findings;         ///< what is left out, a sentence each
};

bool turnsLinks(const RobotJoint& joint) { return joint.isFree() && joint.turns(); }

/// Joints that fewer than half of the poses name are not known; poses that lack one of the others are left out.
UsablePoses usablePoses(const std::vector<PoseId>& seen, const RobotModel& robot,
                        const std::map<PoseId, JointAngles>& angles) {
  const std::vector<RobotJoint>& joints = robot.joints();
  const auto names = [&](PoseId pose, std::size_t joint) {
    return angles.at(pose).positions.contains(joints[joint].name);
  };
  UsablePoses usable;
  std::vector<PoseId> with_angles;
  std::vector<PoseId> without;
  for (const PoseId pose : seen) {
    const auto found = angles.find(pose);
    const bool has = found != angles.end() && !found->second.positions.empty();
    (has ? with_angles : without).push_back(pose);
  }
  if (!without.empty() && !with_angles.empty()) {
    usable.findings.push_back(
        message("No joint angles are known of these poses, which are not compared: {}.", without));
  }
  std::vector<std::string> unknown;
  for (std::size_t joint = 0; joint < joints.size(); ++joint) {
    if (!turnsLinks(joints[joint])) continue;
    const auto named = std::ranges::count_if(with_angles, [&](PoseId pose) { return names(pose, joint); });
    if (2 * static_cast<std::size_t>(named) >= with_angles.size()) continue;
    usable.unknown_joints.insert(joint);
    unknown.push_back(joints[joint].name);
  }
  if (!with_angles.empty() && !unknown.empty()) {
    usable.findings.push_back(
        message("The angles of these joints are not known, and links beyond them are not compared: {}.", unknown));
  }
  for (const PoseId pose : with_angles) {
    std::vector<std::string> missing;
    for (std::size_t joint = 0; joint < joints.size(); ++joint) {
      if (turnsLinks(joints[joint]) && !usable.unknown_joints.contains(joint) && !names(pose, joint)) {
        missing.push_back(joints[joint].name);
      }
    }
    if (missing.empty()) {
      usable.poses.push_back(pose);
    } else {
      usable.findings.push_back(
          message("Pose {} is not compared, because it lacks the angles of these joints: {}.", pose, missing));
    }
  }
  return usable;
}

/// Links are tested as if zeros and tilt were so much more uncertain: a large zero must not reject the right link.
constexpr double kPriorsInTest = 4;
/// A turn that is known to less is called open.
constexpr double kOpenTurn_rad = 0.35;

class LinksFinder {
 public:
  LinksFinder(const Reconstruction& reconstruction, const RobotModel& robot,
              const std::map<PoseId, JointAngles>& angles, const LinksOptions& options)
      : options_(options), robot_(robot), angles_(angles), up_w_(options.up_w.normalized()) {
    gather(reconstruction);
    readChoices(reconstruction);
  }

  LinksResult run() {
    if (!patches_.empty()) {
      testAll();
      placeAll();
      describeAll();
      explainMisfits();
    }
    summarise();
    return std::move(result_);
  }

 private:
  /// A patch that is compared.
  struct Compared {
    const PatchReconstruction* patch = nullptr;
    SeenByPatch seen;       ///< for the estimate
    SeenByPatch test_seen;  ///< for the test of links
    std::vector<TestedGroup> groups{};
    std::optional<std::size_t> link{};  ///< on which it is placed
    bool chosen = false;
    /// How it is turned on the part of that link, with all patches taken together.
    std::optional<PatchTurn> turn{};
  };

  // --- what is compared

  void gather(const Reconstruction& reconstruction) {
    std::vector<const PatchReconstruction*> seeing;
    for (const PatchReconstruction& patch : reconstruction.patches) {
      if (patch.gravity.empty()) continue;
      if (patch.gravity_covariance == nullptr) {
        throw InvalidArgument(
            message("On which link a patch is can be told of a session that was just solved by the global solver, not "
                    "of a calibration file or of the tree: they don't hold how well gravity is known."));
      }
      seeing.push_back(&patch);
    }
    UsablePoses usable = usablePoses(posesOf(seeing), robot_, angles_);
    result_.findings = std::move(usable.findings);
    result_.poses = differentPoses(seeing, usable.poses, options_.most_poses);
    for (const PoseId pose : result_.poses) {
      compared_angles_.push_back(angles_.at(pose));
      T_w_l_.push_back(robot_.forward(compared_angles_.back()));
    }
    addDoubts();
    for (const PatchReconstruction& patch : reconstruction.patches) {
      GravitySeen seen;
      if (!patch.gravity.empty()) seen = gravityIn(patch, result_.poses, options_.lever_m);
      if (seen.size() == 0) {
        result_.not_compared.push_back(patch.id);
        continue;
      }
      std::vector<std::size_t> places;
      for (const PoseId pose : seen.poses) {
        places.push_back(
            static_cast<std::size_t>(std::ranges::lower_bound(result_.poses, pose) - result_.poses.begin()));
      }
      GravitySeen test_seen = gravityIn(patch, result_.poses, options_.test_lever_m);
      patches_.push_back({&patch, SeenByPatch(std::move(seen), places), SeenByPatch(std::move(test_seen), places)});
    }
    test_.priors = {options_.joint_zeros ? kPriorsInTest * options_.zero_sigma_rad : 0,
                    kPriorsInTest * options_.tilt_sigma_rad};
    test_.least_probable = options_.false_alarm / std::max(1.0, static_cast<double>(patches_.size()));
    test_.parts = partsToTest(usable.unknown_joints);
  }

  void addDoubts() {
    const JointDoubts doubts = doubtsOf(robot_, compared_angles_);
    if (doubts.probably_degrees) {
      result_.findings.push_back(*doubts.probably_degrees);
      return;
    }
    for (const BeyondLimits& beyond : doubts.beyond_limits) result_.findings.push_back(beyond.message);
  }

  [[nodiscard]] std::vector<std::size_t> partsToTest(const std::set<std::size_t>& unknown_joints) const {
    std::vector<std::size_t> parts;
    for (std::size_t link = 0; link < robot_.links().size(); ++link) {
      if (robot_.partOf(link) == link && !isBeyond(link, unknown_joints)) parts.push_back(link);
    }
    return parts;
  }
  [[nodiscard]] bool isBeyond(std::size_t link, const std::set<std::size_t>& joints) const {
    return std::ranges::any_of(robot_.freeJointsTo(link), [&](std::size_t joint) { return joints.contains(joint); });
  }

  void readChoices(const Reconstruction& reconstruction) {
    for (const auto& [cell, name] : options_.chosen) {
      const std::size_t link = robot_.linkNamed(name);
      const Reconstruction::Located located = reconstruction.find(cell);
      if (located.patch == nullptr)
        throw InvalidArgument(message("There is no cell {} to put on link {}.", cell, name));
      if (std::ranges::find(test_.parts, robot_.partOf(link)) == test_.parts.end()) {
        throw InvalidArgument(
            message("Cell {} can't be put on link {}: the angle of a joint that carries it is not known.", cell, name));
      }
      for (Compared& compared : patches_) {
        if (compared.patch->id != located.patch->id) continue;
        if (compared.chosen && compared.link != link) {
          throw InvalidArgument(message("The patch of cell {} can't be on two links, {} and {}.", cell,
                                        robot_.links()[*compared.link].name, name));
        }
        compared.link = link;
        compared.chosen = true;
      }
    }
  }

  // --- which links

  void testAll() {
    const LinkGravity gravity(robot_, compared_angles_, up_w_);
    for (Compared& compared : patches_) {
      compared.groups = testLinks(compared.test_seen, robot_, gravity, test_);
      const auto fit = std::ranges::count_if(compared.groups, &TestedGroup::fits);
      if (compared.chosen || fit != 1 || compared.seen.size() < 2) continue;
      const TestedGroup& only = *std::ranges::find_if(compared.groups, &TestedGroup::fits);
      const std::size_t first = only.links.front().link;
      const bool is_one = std::ranges::all_of(
          only.links, [&](const TestedLink& tested) { return turnAsOne(gravity, first, tested.link); });
      if (is_one) compared.link = first;
    }
  }

  /// Whether two links are turned by the same joints, so that they see the same: they are fixed to each other, or
  /// slide.
  [[nodiscard]] bool turnAsOne(const LinkGravity& gravity, std::size_t a, std::size_t b) const {
    if (gravity.jointsTo(a) != gravity.jointsTo(b)) return false;
    const Eigen::Matrix3d R_a_b = T_w_l_.front()[a].R.transpose() * T_w_l_.front()[b].R;
    return std::ranges::all_of(T_w_l_, [&](const std::vector<SE3>& T_w_l) {
      constexpr double kRounding_rad = 1e-6;
      return rotationAngle(T_w_l[a].R.transpose() * T_w_l[b].R * R_a_b.transpose()) < kRounding_rad;
    });
  }

  // --- all patches together

  [[nodiscard]] RobotPriors priors() const {
    return {options_.joint_zeros ? options_.zero_sigma_rad : 0, options_.tilt_sigma_rad};
  }

  void placeAll() {
    const LinkGravity gravity(robot_, compared_angles_, up_w_);
    std::vector<PatchOnKnownLink> placed;
    std::vector<Compared*> whose;
    for (Compared& compared : patches_) {
      if (!compared.link) continue;
      const LinkTurn about = turnOn(compared.seen, gravity, *compared.link, test_.priors);
      placed.push_back({&compared.seen, *compared.link, about.R_l_o});
      whose.push_back(&compared);
    }
    if (placed.empty()) return;
    const auto fitWith = [&](double hand_share) {
      seeWith(hand_share);
      return fitRobot(placed, robot_, compared_angles_, up_w_, priors());
    };
    const double hand_share = meanHandShare([&](double share) { return fitWith(share).log_evidence; });
    const RobotFit fit = fitWith(hand_share);
    std::vector<PatchId> patches;
    for (std::size_t k = 0; k < placed.size(); ++k) {
      const auto at = static_cast<Eigen::Index>(3 * k);
      patches.push_back(whose[k]->patch->id);
      whose[k]->turn = {robot_.links()[placed[k].link].name, fit.R_l_o[k], fit.covariance.block<3, 3>(at, at)};
    }
    result_.robot = estimateOf(fit, std::move(patches), result_.poses, robot_, options_);
    addResidualsOf(fit);
  }

  /// Links are tested as if a usual hand held the robot. How much of it there was shows on links that are known, and
  /// what is stated goes by that.
  void seeWith(double hand_share) {
    for (Compared& compared : patches_) {
      const double lever_m = options_.lever_m * std::sqrt(hand_share);
      compared.seen = {gravityIn(*compared.patch, result_.poses, lever_m, hand_share), compared.seen.places()};
    }
  }

  void addResidualsOf(const RobotFit& fit) {
    std::vector<double> zeros(robot_.joints().size(), 0.0);
    for (std::size_t j = 0; j < fit.joints.size(); ++j) zeros[fit.joints[j]] = fit.zeros[j];
    fitted_.emplace(robot_, compared_angles_, fit.up_w, zeros);
  }

  // --- each patch

  void describeAll() {
    const LinkGravity gravity(robot_, compared_angles_, up_w_);
    for (const Compared& compared : patches_) {
      PatchLinks& patch = result_.patches.emplace_back();
      patch.patch = compared.patch->id;
      patch.origin = compared.patch->origin;
      patch.poses = compared.seen.size();
      patch.chosen = compared.chosen;
      patch.placed = compared.turn;
      for (const TestedGroup& group : compared.groups) {
        if (group.fits) patch.candidates.push_back(candidateOf(compared, group, gravity));
      }
      if (patch.candidates.empty() || (compared.chosen && !groupWith(compared, *compared.link)->fits)) {
        patch.nearest = candidateOf(compared, compared.groups.front(), gravity);
      }
      addOdds(compared, patch);
      findOpenAxis(patch);
      addResiduals(compared, patch);
      putIntoWords(patch, robot_);
    }
  }

  [[nodiscard]] const TestedGroup* groupWith(const Compared& compared, std::size_t link) const {
    const std::size_t part = robot_.partOf(link);
    for (const TestedGroup& group : compared.groups) {
      if (std::ranges::find(group.links, part, &TestedLink::link) != group.links.end()) return &group;
    }
    return nullptr;
  }

  [[nodiscard]] LinkCandidate candidateOf(const Compared& compared, const TestedGroup& group,
                                          const LinkGravity& gravity) const {
    LinkCandidate candidate;
    const GravityMisfit& misfit = group.links[group.best].turn.misfit;
    candidate.chi_squared = misfit.chi_squared;
    candidate.freedom = misfit.freedom;
    candidate.probability = misfit.probability();
    for (const TestedLink& tested : group.links) {
      PatchTurn turn = turnOnPart(compared, tested.link, gravity);
      const Eigen::Matrix3d R_part_o = turn.R_l_o;
      for (std::size_t link = 0; link < robot_.links().size(); ++link) {
        if (robot_.partOf(link) != tested.link) continue;
        turn.link = robot_.links()[link].name;
        turn.R_l_o = T_w_l_.front()[link].R.transpose() * T_w_l_.front()[tested.link].R * R_part_o;
        candidate.links.push_back(turn);
      }
    }
    sortLinks(candidate.links);
    return candidate;
  }

  void sortLinks(std::vector<PatchTurn>& links) const {
    const auto steps = [&](const PatchTurn& turn) {
      const std::size_t link = robot_.linkNamed(turn.link);
      const bool is_part = robot_.partOf(link) == link;
      return std::tuple(jointsBelow(robot_, link), !is_part, turn.link);
    };
    std::ranges::sort(links, {}, steps);
  }

  /// As all patches together have it, if the patch is placed on this part, or one that sees the same.
  [[nodiscard]] PatchTurn turnOnPart(const Compared& compared, std::size_t part, const LinkGravity& gravity) const {
    if (compared.turn && turnAsOne(gravity, part, *compared.link)) {
      PatchTurn turn = *compared.turn;
      turn.R_l_o = T_w_l_.front()[part].R.transpose() * T_w_l_.front()[*compared.link].R * turn.R_l_o;
      return turn;
    }
    const LinkTurn turn = turnOn(compared.seen, gravity, part, priors());
    return {robot_.links()[part].name, turn.R_l_o, turn.covariance};
  }

  void addOdds(const Compared& compared, PatchLinks& patch) const {
    const auto evidence = [](const TestedGroup& group) { return group.links[group.best].turn.log_evidence; };
    std::optional<double> best;
    std::size_t next = 0;
    for (const TestedGroup& group : compared.groups) {
      if (!group.fits) continue;
      if (!best) best = evidence(group);
      patch.candidates[next++].log10_odds = (evidence(group) - *best) / std::log(10.0);
    }
  }

  static void findOpenAxis(PatchLinks& patch) {
    const PatchTurn* turn = patch.placed                ? &*patch.placed
                            : !patch.candidates.empty() ? &patch.candidates.front().links.front()
                                                        : nullptr;
    if (turn == nullptr) return;
    const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver(turn->covariance);
    if (solver.eigenvalues()[2] < kOpenTurn_rad * kOpenTurn_rad) return;
    patch.open_axis_l = (turn->R_l_o * solver.eigenvectors().col(2)).normalized();
  }

  void addResiduals(const Compared& compared, PatchLinks& patch) const {
    if (!compared.turn) return;
    for (std::size_t k = 0; k < compared.seen.size(); ++k) {
      const Eigen::Vector3d expected =
          compared.turn->R_l_o.transpose() * fitted_->up(*compared.link, compared.seen.placeOf(k));
      const GravitySeen& seen = compared.seen.seen();
      patch.residuals.push_back({seen.poses[k], angleBetween(seen.up[k], expected), seen.worstDeviation(k)});
    }
  }

  // --- findings

  void explainMisfits() {
    std::vector<const SeenByPatch*> without_link;
    std::vector<const Compared*> largest;
    for (std::size_t k = 0; k < patches_.size(); ++k) {
      const PatchLinks& patch = result_.patches[k];
      if (patch.candidates.empty()) largest.push_back(&patches_[k]);
      if (patch.candidates.empty() || contradictsChoice(patch)) result_.findings.push_back(patch.why);
    }
    std::ranges::stable_sort(
        largest, [](const Compared* a, const Compared* b) { return a->patch->cells.size() > b->patch->cells.size(); });
    for (const Compared* compared : largest) without_link.push_back(&compared->test_seen);
    if (!without_link.empty()) {
      const std::optional<Message> why = explain(without_link, {robot_, compared_angles_, result_.poses, up_w_, test_});
      if (why) {
        result_.findings.push_back(*why);
      } else if (without_link.size() == patches_.size()) {
        result_.findings.push_back(
            message("No patch fits any link: perhaps the robot's base did not stand still in all poses, or joint "
                    "angles and URDF are those of another robot."));
      }
    }
    if (!result_.robot) return;
    for (Message& finding : findingsOf(*result_.robot, options_)) result_.findings.push_back(std::move(finding));
  }

  void summarise() {
    if (angles_.empty()) {
      result_.summary = message("No pose has joint angles: on which links the patches are can't be told.");
    } else if (patches_.empty()) {
      result_.summary = message(
          "No pose has both readings and the angles of the joints: on which links the patches are can't be told.");
    } else {
      result_.summary = summaryOf(result_.patches);
    }
  }

  const LinksOptions& options_;
  const RobotModel& robot_;
  const std::map<PoseId, JointAngles>& angles_;
  Eigen::Vector3d up_w_;
  std::vector<JointAngles> compared_angles_;  // by place in LinksResult::poses
  std::vector<std::vector<SE3>> T_w_l_;       // by place and link, as the joints report
  LinkTest test_;
  std::vector<Compared> patches_;
  std::optional<LinkGravity> fitted_;
  LinksResult result_;
};

}  // namespace

LinksOptions::LinksOptions() : zero_sigma_rad(0.5 * kDegree), tilt_sigma_rad(1 * kDegree) {}

void LinksOptions::validate() const {
  constexpr double kMaxUp = 1e6;
  if (!isWithin(up_w, kMaxUp) || !(up_w.norm() > 1 / kMaxUp)) {
    throw InvalidArgument(message("up_w must be a direction"));
  }
  if (!(false_alarm > 0 && false_alarm < 1)) throw InvalidArgument(message("false_alarm must be between 0 and 1"));
  const auto isSigma = [](double value) { return value >= 0 && value <= kPi; };
  if (!(zero_sigma_rad > 0 && isSigma(zero_sigma_rad))) {
    throw InvalidArgument(message("zero_sigma_rad must be above 0 and at most pi"));
  }
  if (!isSigma(tilt_sigma_rad)) throw InvalidArgument(message("tilt_sigma_rad must be from 0 to pi"));
  if (!(lever_m >= 0) || !std::isfinite(lever_m)) throw InvalidArgument(message("lever_m must not be negative"));
  if (!(test_lever_m >= 0) || !std::isfinite(test_lever_m)) {
    throw InvalidArgument(message("test_lever_m must not be negative"));
  }
  if (most_poses < 2) throw InvalidArgument(message("most_poses must be at least 2"));
}

LinksResult findLinks(const Reconstruction& reconstruction, const RobotModel& robot,
                      const std::map<PoseId, JointAngles>& angles, const LinksOptions& options) {
  options.validate();
  return LinksFinder(reconstruction, robot, angles, options).run();
}

}  // namespace hexoderm
