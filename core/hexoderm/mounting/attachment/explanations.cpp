#include "hexoderm/mounting/attachment/explanations.h"

#include "hexoderm/base/units.h"

#include <algorithm>
#include <cstddef>
#include <functional>
#include <string>
#include <utility>

namespace hexoderm {
namespace {

std::vector<std::string> linkNames(const LinkCandidate& candidate) {
  std::vector<std::string> names;
  for (const PatchTurn& turn : candidate.links) names.push_back(turn.link);
  return names;
}

/// The joints between the links of a candidate.
std::vector<std::string> jointsBetween(const LinkCandidate& candidate, const RobotModel& robot) {
  std::vector<std::string> joints;
  for (const PatchTurn& turn : candidate.links) {
    const std::size_t link = robot.linkNamed(turn.link);
    const std::size_t part = robot.partOf(link);
    const std::optional<std::size_t> joint = robot.links()[part].joint;
    if (part != link || !joint || robot.joints()[*joint].type == JointType::Prismatic) continue;
    const std::size_t carrier = robot.partOf(robot.joints()[*joint].parent);
    const bool within = std::ranges::any_of(
        candidate.links, [&](const PatchTurn& other) { return robot.partOf(robot.linkNamed(other.link)) == carrier; });
    if (within) joints.push_back(robot.joints()[*joint].name);
  }
  return joints;
}

/// Whether one candidate is left, whose links turn as one.
bool isOnePart(const PatchLinks& patch, const RobotModel& robot) {
  return patch.candidates.size() == 1 && jointsBetween(patch.candidates.front(), robot).empty();
}

Message sayLink(const PatchLinks& patch, const RobotModel& robot) {
  if (patch.chosen) {
    const std::string& link = patch.placed->link;
    if (contradictsChoice(patch)) {
      return message(
          "The patch of cell {} was put on link {}, which doesn't fit: what the patch saw of gravity is not what that "
          "link would see.",
          patch.origin, link);
    }
    return patch.candidates.size() == 1 && patch.candidates.front().links.size() == 1
               ? message("The patch of cell {} was put on link {}, the only one that fits.", patch.origin, link)
               : message("The patch of cell {} was put on link {}, which fits.", patch.origin, link);
  }
  if (patch.candidates.empty()) {
    const LinkCandidate& nearest = *patch.nearest;
    return message(
        "The patch of cell {} fits no link: link {} comes nearest, with a chi-squared of {} at {} degrees of freedom.",
        patch.origin, nearest.links.front().link, Number{nearest.chi_squared, 1}, nearest.freedom);
  }
  const LinkCandidate& first = patch.candidates.front();
  if (patch.poses < 2) {
    return message("On which link the patch of cell {} is can't be told from one pose, which any link fits.",
                   patch.origin);
  }
  if (patch.candidates.size() > 1) {
    std::vector<std::string> names;
    for (const LinkCandidate& candidate : patch.candidates) {
      for (const std::string& name : linkNames(candidate)) names.push_back(name);
    }
    return message("The patch of cell {} fits several links, the best first: {}.", patch.origin, names);
  }
  if (first.links.size() == 1) {
    return message("The patch of cell {} is on link {}: no other link fits.", patch.origin, first.links.front().link);
  }
  return jointsBetween(first, robot).empty()
             ? message("The patch of cell {} is on one of these links, which turn as one: {}.", patch.origin,
                       linkNames(first))
             : message("The patch of cell {} is on one of these links, which these poses can't tell apart: {}.",
                       patch.origin, linkNames(first));
}

Message sayWhatTellsLinks(const PatchLinks& patch, const RobotModel& robot) {
  if (patch.chosen || patch.candidates.empty()) return {};
  if (patch.candidates.size() > 1) {
    return message(
        "Take more poses, in which the joints that carry these links stand in other angles and the links in new "
        "directions.");
  }
  const std::vector<std::string> joints = jointsBetween(patch.candidates.front(), robot);
  if (joints.empty()) return {};
  return message("Move these joints by 30 degrees or more from pose to pose, with their axes level: {}.", joints);
}

Message sayWhatTellsTurn(const PatchLinks& patch, const RobotModel& robot) {
  const std::string& link = patch.placed ? patch.placed->link : patch.candidates.front().links.front().link;
  return robot.freeJointsTo(robot.linkNamed(link)).empty()
             ? message("No joint moves link {}: only tipping the whole robot over would show it.", link)
             : message("Take poses in which link {} is tipped over by about 90 degrees.", link);
}

/// A mistake that explains fewer degrees of freedom than this explains nothing.
constexpr int kMinFreedom = 3;
/// Patches beyond so many, the smallest, are not looked at: one mistake explains all.
constexpr std::size_t kMaxExplained = 4;
constexpr double kZeroStep_rad = 5 * kDegree;

using ChangeAngle = std::function<double(double)>;

class MismatchSearch {
 public:
  MismatchSearch(const std::vector<const SeenByPatch*>& without_link, const ComparedRobot& compared)
      : patches_(without_link.begin(),
                 without_link.begin() + static_cast<std::ptrdiff_t>(std::min(kMaxExplained, without_link.size()))),
        compared_(compared) {
    const std::vector<RobotJoint>& joints = compared.robot.joints();
    for (std::size_t joint = 0; joint < joints.size(); ++joint) {
      if (joints[joint].turns()) turning_.push_back(joint);
    }
  }

  std::optional<Message> explain() const {
    for (const auto& kind : {&MismatchSearch::otherUnit, &MismatchSearch::otherUp, &MismatchSearch::otherRow,
                             &MismatchSearch::onePose, &MismatchSearch::otherSign, &MismatchSearch::otherZero}) {
      if (std::optional<Message> words = std::invoke(kind, *this)) return words;
    }
    return std::nullopt;
  }

 private:
  [[nodiscard]] std::vector<JointAngles> changed(const std::vector<std::size_t>& joints,
                                                 const ChangeAngle& change) const {
    std::vector<JointAngles> angles = compared_.angles;
    for (JointAngles& pose : angles) {
      for (const std::size_t joint : joints) {
        const auto found = pose.positions.find(compared_.robot.joints()[joint].name);
        if (found != pose.positions.end()) found->second = change(found->second);
      }
    }
    return angles;
  }

  /// The log-evidence of the patches on the best of the links, where each fits one; `links`: that are tried.
  [[nodiscard]] std::optional<double> evidenceOf(const std::vector<SeenByPatch>& patches,
                                                 const std::vector<JointAngles>& angles,
                                                 const std::vector<std::size_t>& links) const {
    return evidenceOf(patches, LinkGravity(compared_.robot, angles, compared_.up_w), links);
  }
  [[nodiscard]] std::optional<double> evidenceOf(const std::vector<SeenByPatch>& patches, const LinkGravity& gravity,
                                                 const std::vector<std::size_t>& links) const {
    double sum = 0;
    for (const SeenByPatch& patch : patches) {
      std::optional<double> best;
      for (const std::size_t link : links) {
        const LinkTurn turn = turnOn(patch, gravity, link, compared_.test.priors);
        const bool fits =
            turn.misfit.freedom >= kMinFreedom && turn.misfit.probability() >= compared_.test.least_probable;
        if (fits) best = std::max(best.value_or(turn.log_evidence), turn.log_evidence);
      }
      if (!best) return std::nullopt;
      sum += *best;
    }
    return sum;
  }
  [[nodiscard]] std::vector<SeenByPatch> all() const {
    std::vector<SeenByPatch> patches;
    for (const SeenByPatch* patch : patches_) patches.push_back(*patch);
    return patches;
  }

  [[nodiscard]] std::optional<Message> otherUnit() const {
    const auto as = [&](double factor) {
      return evidenceOf(all(), changed(turning_, [factor](double angle) { return factor * angle; }),
                        compared_.test.parts);
    };
    const std::optional<double> as_degrees = as(kDegree);
    const std::optional<double> as_radians = as(1 / kDegree);
    if (as_degrees && (!as_radians || *as_degrees > *as_radians)) {
      return message(
          "The joint angles are probably degrees that were read as rad: as degrees they fit what the patches see, as "
          "rad they don't.");
    }
    if (as_radians) {
      return message(
          "The joint angles are probably rad that were read as degrees: as rad they fit what the patches see, as "
          "degrees they don't.");
    }
    return std::nullopt;
  }

  /// The base lies on its side or hangs.
  [[nodiscard]] std::optional<Message> otherUp() const {
    std::optional<double> best;
    std::string name;
    for (Eigen::Index axis = 0; axis < 3; ++axis) {
      for (const double sign : {1.0, -1.0}) {
        const Eigen::Vector3d up_w = sign * Eigen::Vector3d::Unit(axis);
        const auto evidence =
            evidenceOf(all(), LinkGravity(compared_.robot, compared_.angles, up_w), compared_.test.parts);
        if (!evidence || (best && *evidence <= *best)) continue;
        best = evidence;
        name = std::string(sign > 0 ? "+" : "-") + "xyz"[axis];
      }
    }
    if (!best) return std::nullopt;
    return message(
        "The robot's base seems to stand otherwise than was said: the patches fit with {} of its frame upwards.", name);
  }

  /// Each pose has the angles of the one after it, or before it: a table that counts its poses from 0.
  [[nodiscard]] std::optional<Message> otherRow() const {
    const std::size_t places = compared_.poses.size();
    if (places < 3) return std::nullopt;
    const auto shifted = [&](bool to_next) {
      std::vector<JointAngles> angles = compared_.angles;
      if (to_next) {
        std::copy(compared_.angles.begin() + 1, compared_.angles.end(), angles.begin());
      } else {
        std::copy(compared_.angles.begin(), compared_.angles.end() - 1, angles.begin() + 1);
      }
      std::vector<SeenByPatch> patches;
      for (const SeenByPatch* patch : patches_) patches.push_back(withoutPlace(*patch, to_next ? places - 1 : 0));
      return evidenceOf(patches, angles, compared_.test.parts);
    };
    const std::optional<double> next = shifted(true);
    const std::optional<double> previous = shifted(false);
    if (next && (!previous || *next > *previous)) {
      return message(
          "The joint angles are probably off by one pose: with those of the pose after it, each pose fits what the "
          "patches see.");
    }
    if (previous) {
      return message(
          "The joint angles are probably off by one pose: with those of the pose before it, each pose fits what the "
          "patches see.");
    }
    return std::nullopt;
  }

  [[nodiscard]] std::optional<Message> onePose() const {
    std::vector<PoseId> found;
    for (std::size_t place = 0; place < compared_.poses.size(); ++place) {
      std::vector<SeenByPatch> without;
      for (const SeenByPatch* patch : patches_) without.push_back(withoutPlace(*patch, place));
      if (evidenceOf(without, compared_.angles, compared_.test.parts)) found.push_back(compared_.poses[place]);
    }
    if (found.size() != 1) return std::nullopt;
    return message(
        "Pose {} doesn't go with the others: without it every patch fits a link. Its joint angles are probably those "
        "of another moment.",
        found.front());
  }

  static SeenByPatch withoutPlace(const SeenByPatch& patch, std::size_t place) {
    std::vector<std::size_t> kept;
    std::vector<std::size_t> places;
    for (std::size_t k = 0; k < patch.size(); ++k) {
      if (patch.placeOf(k) == place) continue;
      kept.push_back(k);
      places.push_back(patch.placeOf(k));
    }
    return {onlyPoses(patch.seen(), kept), places};
  }

  /// Of the tested links those that a joint turns.
  [[nodiscard]] std::vector<std::size_t> linksBeyond(std::size_t joint) const {
    std::vector<std::size_t> links;
    for (const std::size_t link : compared_.test.parts) {
      const std::vector<std::size_t> to = compared_.robot.freeJointsTo(link);
      if (std::ranges::find(to, joint) != to.end()) links.push_back(link);
    }
    return links;
  }
  [[nodiscard]] std::vector<std::size_t> freeTurning() const {
    std::vector<std::size_t> joints;
    std::ranges::copy_if(turning_, std::back_inserter(joints),
                         [&](std::size_t joint) { return compared_.robot.joints()[joint].isFree(); });
    return joints;
  }

  [[nodiscard]] std::optional<Message> otherSign() const {
    std::vector<std::string> found;
    for (const std::size_t joint : freeTurning()) {
      const auto evidence =
          evidenceOf(all(), changed({joint}, [](double angle) { return -angle; }), linksBeyond(joint));
      if (evidence) found.push_back(compared_.robot.joints()[joint].name);
    }
    if (found.empty()) return std::nullopt;
    if (found.size() == 1) {
      return message(
          "Joint {} seems to count its angle the other way round: with its sign turned the angles fit what the patches "
          "see.",
          found.front());
    }
    return message(
        "One of the joints {} seems to count its angle the other way round: with its sign turned the angles fit what "
        "the patches see.",
        found);
  }

  [[nodiscard]] std::optional<Message> otherZero() const {
    struct Zero {
      std::size_t joint = 0;
      double zero_rad = 0;
      double evidence = 0;
    };
    std::vector<Zero> found;
    for (const std::size_t joint : freeTurning()) {
      const std::vector<std::size_t> links = linksBeyond(joint);
      std::optional<Zero> best;
      for (double zero = kZeroStep_rad - kPi; zero < kPi + kZeroStep_rad / 2; zero += kZeroStep_rad) {
        const auto evidence = evidenceOf(all(), changed({joint}, [&](double angle) { return angle + zero; }), links);
        if (evidence && (!best || *evidence > best->evidence)) best = Zero{joint, zero, *evidence};
      }
      if (best) found.push_back(*best);
    }
    if (found.empty()) return std::nullopt;
    const Zero& best = *std::ranges::max_element(found, {}, &Zero::evidence);
    return message(
        "The zero of joint {} seems to be off by about {}: if so much is added to its angle, the angles fit what the "
        "patches see.",
        compared_.robot.joints()[best.joint].name, Degrees{best.zero_rad, 0});
  }

  std::vector<const SeenByPatch*> patches_;
  const ComparedRobot& compared_;
  std::vector<std::size_t> turning_;
};

}  // namespace

bool contradictsChoice(const PatchLinks& patch) { return patch.chosen && patch.nearest; }

void putIntoWords(PatchLinks& patch, const RobotModel& robot) {
  std::vector<Message> why = {sayLink(patch, robot)};
  std::vector<Message> next = {sayWhatTellsLinks(patch, robot)};
  if (patch.open_axis_l) {
    why.push_back(
        message("How it is turned there about one axis is not determined: gravity came along one line in all poses."));
    if (patch.placed || isOnePart(patch, robot)) next.push_back(sayWhatTellsTurn(patch, robot));
  }
  patch.why = inRow(std::move(why));
  patch.what_would_tell = inRow(std::move(next));
}

Message summaryOf(const std::vector<PatchLinks>& patches) {
  if (patches.size() == 1) return patches.front().why;
  const auto placed = std::ranges::count_if(patches, [](const PatchLinks& patch) { return !!patch.placed; });
  const auto none =
      std::ranges::count_if(patches, [](const PatchLinks& patch) { return patch.candidates.empty() && !patch.placed; });
  if (static_cast<std::size_t>(placed) == patches.size()) {
    return message("Each of {} patches is on a link that is known.", placed);
  }
  return message(
      "Of {} patches {} are on a link that is known; of {} these poses leave open which it is, and {} fit none.",
      patches.size(), placed, static_cast<std::ptrdiff_t>(patches.size()) - placed - none, none);
}

std::optional<Message> explain(const std::vector<const SeenByPatch*>& without_link, const ComparedRobot& compared) {
  return MismatchSearch(without_link, compared).explain();
}

}  // namespace hexoderm
