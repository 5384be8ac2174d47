#include "hexoderm/reconstruction/faults/link_plausibility.h"

#include "hexoderm/geometry/se3.h"
#include "hexoderm/graph/skin_graph.h"
#include "hexoderm/util/text.h"
#include "hexoderm/util/units.h"

#include <algorithm>
#include <cmath>
#include <string>

namespace hexoderm {
namespace {

/// The same rotation as a yaw about z followed by a tilt about an axis in the surface, with twist and bend as its
/// parts. Small angles stay the same. The parts of one large rotation vector no longer tell which angle was turned how
/// far: cells folded by 84 degrees and yawed by -141 would come out as bent by 45 and twisted by 94.
LinkAngles separated(const LinkAngles& angles) {
  // In the basis u_c, z x u_c, z.
  const Eigen::Quaterniond whole(expSO3({angles.twist_rad, angles.bend_rad, angles.yaw_rad}));
  const double yaw_rad = std::remainder(2 * std::atan2(whole.z(), whole.w()), 2 * kPi);
  const Eigen::Quaterniond yaw(Eigen::AngleAxisd(yaw_rad, Eigen::Vector3d::UnitZ()));
  const Eigen::Vector3d tilt = logSO3((whole * yaw.conjugate()).toRotationMatrix());
  return {tilt.x(), tilt.y(), yaw_rad};
}

}  // namespace

std::vector<Finding> judgeLinkAngles(const LinkAngles& angles, LinkEnd source, LinkEnd target,
                                     const SolverOptions& options, double sigma_rad) {
  constexpr double kSigmas = 3;
  // No part of a rotation is larger than the whole.
  const double whole = std::hypot(angles.bend_rad, angles.twist_rad, angles.yaw_rad);
  if (whole <= std::min({options.max_bend_rad, options.max_twist_rad, options.max_yaw_rad})) return {};
  const LinkAngles judged = separated(angles);
  std::vector<Finding> findings;
  const Message link = linkInWords(source, target);
  const auto judge = [&](double angle_rad, double limit_rad, FindingCode code, const auto& inWords) {
    if (std::abs(angle_rad) <= limit_rad + kSigmas * sigma_rad) return;
    Message words = inWords(Number{toDegrees(std::abs(angle_rad)), 0}, Number{toDegrees(limit_rad), 0});
    findings.push_back(makeFinding(code, std::move(words), {source.cell, target.cell}, {source.port, target.port}));
  };
  judge(judged.bend_rad, options.max_bend_rad, FindingCode::ImplausibleBend, [&](Number angle, Number limit) {
    return message(
        "The {} bends by {} degrees, and a skin link by no more than {}. It is probably a cable or crosses a joint.",
        link, angle, limit);
  });
  judge(judged.twist_rad, options.max_twist_rad, FindingCode::ImplausibleTwist, [&](Number angle, Number limit) {
    return message(
        "The {} is twisted by {} degrees, and a skin link by no more than {}. It is probably a cable, or a port number "
        "is wrong.",
        link, angle, limit);
  });
  judge(judged.yaw_rad, options.max_yaw_rad, FindingCode::ImplausibleYaw, [&](Number angle, Number limit) {
    return message(
        "The {} is turned in the surface by {} degrees, and a skin link by no more than {}. A port number is probably "
        "wrong, or it is a cable.",
        link, angle, limit);
  });
  return findings;
}

}  // namespace hexoderm
