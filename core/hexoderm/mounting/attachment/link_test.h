#pragma once

// Which links a patch may be on (the rule is in the room's README).

#include "hexoderm/mounting/attachment/link_fit.h"

#include <cstddef>
#include <vector>

namespace hexoderm {

/// How links are tested, the same for all patches.
struct LinkTest {
  RobotPriors priors;
  double least_probable = 0;  ///< misfits less probable than this reject a link
  /// The links that are tested: of links that are fixed to each other only RobotModel::partOf().
  std::vector<std::size_t> parts;
};

struct TestedLink {
  std::size_t link = 0;
  LinkTurn turn;
};

/// Links that the poses of a patch can't tell apart.
struct TestedGroup {
  std::vector<TestedLink> links;  ///< those nearest to the base first
  std::size_t best = 0;           ///< index of the most probable
  bool fits = false;              ///< at least one of them is not rejected
};

/// How many joints that are not fixed carry a link, one on the other.
std::size_t jointsBelow(const RobotModel& robot, std::size_t link);

/// All groups, the most probable first. Needs at least one pose.
std::vector<TestedGroup> testLinks(const SeenByPatch& patch, const RobotModel& robot, const LinkGravity& gravity,
                                   const LinkTest& test);

}  // namespace hexoderm
