#include "hexoderm/mounting/attachment/link_words.h"

#include <algorithm>
#include <cstddef>
#include <optional>
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

}  // namespace hexoderm
