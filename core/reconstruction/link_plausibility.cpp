#include "hexoderm/reconstruction/link_plausibility.h"

#include "hexoderm/graph/skin_graph.h"
#include "hexoderm/util/text.h"
#include "hexoderm/util/units.h"

#include <cmath>
#include <string>

namespace hexoderm {

std::vector<Finding> judgeLinkAngles(const LinkAngles& angles, LinkEnd source, LinkEnd target,
                                     const SolverOptions& options, double sigma_rad) {
  constexpr double kSigmas = 3;
  std::vector<Finding> findings;
  const auto judge = [&](double angle_rad, double limit_rad, FindingCode code, const std::string& does,
                         const std::string& cause) {
    if (std::abs(angle_rad) <= limit_rad + kSigmas * sigma_rad) return;
    findings.push_back(makeFinding(
        code,
        "The " + linkInWords(source, target) + " " + does + " by " + formatFixed(toDegrees(std::abs(angle_rad)), 0) +
            " degrees, and a skin link by no more than " + formatFixed(toDegrees(limit_rad), 0) + ". " + cause,
        {source.cell, target.cell}, {source.port, target.port}));
  };
  judge(angles.bend_rad, options.max_bend_rad, FindingCode::ImplausibleBend, "bends",
        "It is probably a cable or crosses a joint.");
  judge(angles.twist_rad, options.max_twist_rad, FindingCode::ImplausibleTwist, "is twisted",
        "It is probably a cable, or a port number is wrong.");
  judge(angles.yaw_rad, options.max_yaw_rad, FindingCode::ImplausibleYaw, "is turned in the surface",
        "A port number is probably wrong, or it is a cable.");
  return findings;
}

}  // namespace hexoderm
