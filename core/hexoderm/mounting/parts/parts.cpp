#include "hexoderm/mounting/parts/parts.h"

#include "hexoderm/base/enum_names.h"
#include "hexoderm/base/error.h"
#include "hexoderm/mounting/parts/compared_poses.h"
#include "hexoderm/mounting/parts/rigid_fit.h"

#include <algorithm>
#include <cmath>

namespace hexoderm {
namespace {

/// Patches with what they saw, the largest first.
struct SeeingPatch {
  const PatchReconstruction* patch = nullptr;
  GravitySeen seen;
};

/// A part while it grows: patches as indices, and what they see together in the first one's frame.
struct Group {
  std::vector<std::size_t> members;
  RigidFit fit;
};

/// All tests of one call share its false alarms.
struct MovementLimits {
  double least_probable = 0;
  double least_log_odds = 0;
};

Movement judgeMovement(const MovementTest& test, const MovementLimits& limits) {
  if (test.fit.misfit.probability() < limits.least_probable) return Movement::Apart;
  return !test.on_one_line && test.log_odds >= limits.least_log_odds ? Movement::Together : Movement::CantTell;
}

class PartsFinder {
 public:
  PartsFinder(const Reconstruction& reconstruction, const PartsOptions& options) : options_(options) {
    gather(reconstruction);
    const double pairs = static_cast<double>(patches_.size() * (patches_.size() - 1)) / 2;
    limits_.least_probable = options.false_alarm / std::max(1.0, pairs);
    limits_.least_log_odds = std::log(options.least_odds);
  }

  PartsResult run() {
    for (std::size_t k = 0; k < patches_.size(); ++k) groups_.push_back(groupOf({k}));
    tests_ = testsOfAll();
    describePairs();
    while (mergeBest()) {
    }
    settleSwings();
    describeParts();
    describeRelations();
    judgePairs();
    summarise();
    return std::move(result_);
  }

 private:
  void gather(const Reconstruction& reconstruction) {
    std::vector<const PatchReconstruction*> seeing;
    for (const PatchReconstruction& patch : reconstruction.patches) {
      if (patch.gravity.empty()) {
        result_.not_compared.push_back(patch.id);
        continue;
      }
      if (patch.gravity_covariance == nullptr) {
        throw InvalidArgument(
            message("Which patches move together can be told of a session that was just solved by the global solver, "
                    "not of a calibration file or of the tree: they don't hold how well gravity is known."));
      }
      seeing.push_back(&patch);
    }
    std::ranges::stable_sort(seeing, [](const PatchReconstruction* a, const PatchReconstruction* b) {
      return a->cells.size() > b->cells.size();
    });
    for (; seeing.size() > options_.most_patches; seeing.pop_back()) result_.not_compared.push_back(seeing.back()->id);
    // Of patches with hundreds of poses only those that are compared get their covariance.
    poses_ = differentPoses(seeing, posesOf(seeing), options_.most_poses);
    for (const PatchReconstruction* patch : seeing) {
      patches_.push_back({patch, gravityIn(*patch, poses_, options_.lever_m)});
    }
  }

  [[nodiscard]] Group groupOf(std::vector<std::size_t> members) const {
    std::vector<GravitySeen> bodies;
    for (const std::size_t member : members) bodies.push_back(patches_[member].seen);
    return {std::move(members), fitRigid(bodies)};
  }

  /// The patches of a group, each so far away from the point at which gravity is meant.
  [[nodiscard]] RigidFit fitAgain(const Group& group, double lever_m, double swing_share) const {
    std::vector<GravitySeen> bodies;
    for (const std::size_t member : group.members) {
      bodies.push_back(gravityIn(*patches_[member].patch, poses_, lever_m * std::sqrt(swing_share)));
    }
    return fitRigid(bodies);
  }

  /// Whether patches move together was asked as if a usual hand had swung them. How much a swing really did between
  /// patches shows where several are on one part. With that share the parts are fitted again; without such parts it
  /// stays the usual one.
  void settleSwings() {
    const auto hasSeveral = [](const Group& group) { return group.members.size() > 1; };
    if (std::ranges::none_of(groups_, hasSeveral)) return;
    swing_share_ = meanHandShare([&](double share) {
      double log_evidence = 0;
      for (const Group& group : groups_) {
        if (hasSeveral(group)) log_evidence += fitAgain(group, options_.lever_m, share).log_evidence;
      }
      return log_evidence;
    });
    for (Group& group : groups_) group.fit = fitAgain(group, options_.lever_m, swing_share_);
  }

  using Tests = std::vector<std::vector<MovementTest>>;  // [a][b] for b < a
  [[nodiscard]] std::vector<MovementTest> testsOf(std::size_t a) const {
    std::vector<MovementTest> tests;
    for (std::size_t b = 0; b < a; ++b) tests.push_back(testMovement(groups_[b].fit.gravity, groups_[a].fit.gravity));
    return tests;
  }
  [[nodiscard]] Tests testsOfAll() const {
    Tests tests;
    for (std::size_t a = 0; a < groups_.size(); ++a) tests.push_back(testsOf(a));
    return tests;
  }

  /// Joins the two groups that are most surely one part, if any are.
  bool mergeBest() {
    const MovementTest* best = nullptr;
    std::size_t first = 0;
    std::size_t second = 0;
    for (std::size_t a = 0; a < groups_.size(); ++a) {
      for (std::size_t b = 0; b < a; ++b) {
        const MovementTest& test = tests_[a][b];
        if (judgeMovement(test, limits_) != Movement::Together || (best != nullptr && test.log_odds <= best->log_odds))
          continue;
        best = &test;
        first = b;
        second = a;
      }
    }
    if (best == nullptr) return false;
    std::vector<std::size_t> members = groups_[first].members;
    members.insert(members.end(), groups_[second].members.begin(), groups_[second].members.end());
    std::ranges::sort(members);  // the largest patch first
    groups_[first] = groupOf(std::move(members));
    groups_.erase(groups_.begin() + static_cast<std::ptrdiff_t>(second));
    tests_.erase(tests_.begin() + static_cast<std::ptrdiff_t>(second));
    for (std::vector<MovementTest>& row : tests_) {
      if (row.size() > second) row.erase(row.begin() + static_cast<std::ptrdiff_t>(second));
    }
    tests_[first] = testsOf(first);
    for (std::size_t a = first + 1; a < groups_.size(); ++a) {
      tests_[a][first] = testMovement(groups_[first].fit.gravity, groups_[a].fit.gravity);
    }
    return true;
  }

  void describePairs() {
    for (std::size_t a = 0; a < patches_.size(); ++a) {
      for (std::size_t b = a + 1; b < patches_.size(); ++b) {
        const MovementTest& test = tests_[b][a];
        PatchPair& pair = result_.pairs.emplace_back();
        pair.a = patches_[a].patch->id;
        pair.b = patches_[b].patch->id;
        pair.poses = commonPoses(patches_[a].seen, patches_[b].seen).in_a.size();
        pair.R_a_b = test.fit.R[1];
        pair.covariance = test.fit.covariance.bottomRightCorner<3, 3>();
        pair.chi_squared = test.fit.misfit.chi_squared;
        pair.freedom = test.fit.misfit.freedom;
        pair.probability = test.fit.misfit.probability();
        pair.log10_odds = test.log_odds / std::log(10.0);
        pair.noticeable_rad = test.noticeable_rad;
      }
    }
  }

  void describeParts() {
    for (const Group& group : groups_) {
      Part& part = result_.parts.emplace_back();
      part.chi_squared = group.fit.misfit.chi_squared;
      part.freedom = group.fit.misfit.freedom;
      for (std::size_t k = 0; k < group.members.size(); ++k) {
        const PatchReconstruction& patch = *patches_[group.members[k]].patch;
        const auto at = static_cast<Eigen::Index>(3 * k);
        part.patches.push_back({patch.id, patch.origin, group.fit.R[k], group.fit.covariance.block<3, 3>(at, at)});
      }
      const GravitySeen& seen = group.fit.gravity;
      for (std::size_t k = 0; k < seen.size(); ++k) {
        part.gravity.push_back({seen.poses[k], seen.up[k], seen.worstDeviation(k)});
      }
      std::ranges::sort(part.gravity, {}, &GravityDirection::pose);
    }
  }

  void describeRelations() {
    for (std::size_t a = 0; a < groups_.size(); ++a) {
      for (std::size_t b = a + 1; b < groups_.size(); ++b) {
        const MovementTest& test = tests_[b][a];
        PartRelation& relation = result_.relations.emplace_back();
        relation.a = a;
        relation.b = b;
        relation.movement = judgeMovement(test, limits_);
        relation.probability = test.fit.misfit.probability();
        relation.log10_odds = test.log_odds / std::log(10.0);
        relation.noticeable_rad = test.noticeable_rad;
        if (relation.movement == Movement::Apart) {
          sayApart(a, b, relation);
        } else {
          sayOpen(a, b, test, relation);
        }
      }
    }
  }

  /// A part is called by the cell in whose frame it is.
  [[nodiscard]] CellId nameOf(std::size_t group) const {
    return patches_[groups_[group].members.front()].patch->origin;
  }

  /// What a part sees at a joint, which is further away than its patches are from each other.
  [[nodiscard]] GravitySeen gravityAtJoint(std::size_t group) const {
    return fitAgain(groups_[group], options_.joint_lever_m, swing_share_).gravity;
  }

  void sayApart(std::size_t a, std::size_t b, PartRelation& relation) const {
    relation.hinge = fitHinge(gravityAtJoint(a), gravityAtJoint(b), limits_.least_probable);
    relation.why =
        inRow({message("The part of cell {} and the part of cell {} turned against each other.", nameOf(a), nameOf(b)),
               relation.hinge->why});
    relation.what_would_tell = relation.hinge->what_would_tell;
  }

  void sayOpen(std::size_t a, std::size_t b, const MovementTest& test, PartRelation& relation) const {
    const CommonPoses common = commonPoses(groups_[a].fit.gravity, groups_[b].fit.gravity);
    if (common.in_a.size() < 2) {
      relation.why = message(
          "Whether the part of cell {} and that of cell {} move together can't be told: fewer than two "
          "poses have readings of both.",
          nameOf(a), nameOf(b));
      relation.what_would_tell = message("Take poses in which the cells of both have readings.");
      return;
    }
    if (test.on_one_line) {
      relation.why = message(
          "Whether the part of cell {} and that of cell {} move together can't be told: gravity came "
          "along one line in all poses, and a turn about that line doesn't show.",
          nameOf(a), nameOf(b));
      relation.what_would_tell = message("Take poses in which the parts are tipped over by about 90 degrees.");
      return;
    }
    relation.why = message(
        "Whether the part of cell {} and that of cell {} move together can't be told: in all {} poses "
        "they fit one rotation, but a joint between them could have been moved without showing.",
        nameOf(a), nameOf(b), common.in_a.size());
    relation.what_would_tell = message(
        "Take more poses: move the joint that may be between them by 30 degrees or more from pose to pose, and "
        "tip the parts over in new directions.");
  }

  void judgePairs() {
    std::vector<std::size_t> part_of(patches_.size());
    for (std::size_t part = 0; part < groups_.size(); ++part) {
      for (const std::size_t member : groups_[part].members) part_of[member] = part;
    }
    std::size_t next = 0;
    for (std::size_t a = 0; a < patches_.size(); ++a) {
      for (std::size_t b = a + 1; b < patches_.size(); ++b) {
        PatchPair& pair = result_.pairs[next++];
        if (part_of[a] == part_of[b]) {
          pair.movement = Movement::Together;
          continue;
        }
        const std::size_t first = std::min(part_of[a], part_of[b]);
        const std::size_t second = std::max(part_of[a], part_of[b]);
        pair.movement = judgeMovement(tests_[second][first], limits_);
      }
    }
  }

  void summarise() {
    const std::size_t parts = result_.parts.size();
    if (parts == 0) {
      result_.summary = message("No patch saw gravity: there is nothing to compare.");
    } else if (patches_.size() == 1) {
      result_.summary = message("There is one patch: nothing to compare it with.");
    } else if (parts == 1) {
      result_.summary = message(
          "All {} patches move together, as far as these poses show: a joint that stood still in all of them "
          "can't be seen.",
          patches_.size());
    } else {
      const auto open = std::ranges::count(result_.relations, Movement::CantTell, &PartRelation::movement);
      result_.summary = open == 0
                            ? message("{} patches on {} parts that turned against each other.", patches_.size(), parts)
                            : message(
                                  "{} patches on up to {} parts: of {} of the {} pairs of parts these poses can't tell "
                                  "whether they move together.",
                                  patches_.size(), parts, open, result_.relations.size());
    }
  }

  const PartsOptions& options_;
  MovementLimits limits_;
  std::vector<PoseId> poses_;  ///< that are compared
  std::vector<SeeingPatch> patches_;
  std::vector<Group> groups_;
  Tests tests_;
  double swing_share_ = 1;  ///< of the variance that a usual hand's swings bring about between patches
  PartsResult result_;
};

}  // namespace

std::string_view movementName(Movement movement) {
  constexpr EnumNames<Movement> kNames = {{"together", "apart", "cant_tell"}};
  return kNames.of(movement);
}

void PartsOptions::validate() const {
  if (!(false_alarm > 0 && false_alarm < 1)) throw InvalidArgument(message("false_alarm must be between 0 and 1"));
  if (!(least_odds >= 1) || !std::isfinite(least_odds)) throw InvalidArgument(message("least_odds must be at least 1"));
  if (!(lever_m >= 0) || !std::isfinite(lever_m)) throw InvalidArgument(message("lever_m must not be negative"));
  if (!(joint_lever_m >= 0) || !std::isfinite(joint_lever_m)) {
    throw InvalidArgument(message("joint_lever_m must not be negative"));
  }
  if (most_poses < 2) throw InvalidArgument(message("most_poses must be at least 2"));
  if (most_patches < 1) throw InvalidArgument(message("most_patches must be at least 1"));
}

PartsResult findParts(const Reconstruction& reconstruction, const PartsOptions& options) {
  options.validate();
  return PartsFinder(reconstruction, options).run();
}

}  // namespace hexoderm
