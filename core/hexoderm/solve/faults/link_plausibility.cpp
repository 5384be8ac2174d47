#include "hexoderm/solve/faults/link_plausibility.h"

#include "hexoderm/base/se3.h"
#include "hexoderm/base/units.h"
#include "hexoderm/skin/skin_graph.h"

#include <algorithm>
#include <cmath>

namespace hexoderm {
namespace {

/// The same rotation as a yaw about z followed by a tilt about an axis in the surface, with twist and bend as its
/// parts. Small angles stay the same. The parts of one large rotation vector no longer tell which angle was turned how
/// far: cells folded by 84 degrees and yawed by -141 would come out as bent by 45 and twisted by 94.
LinkAngles separated(const LinkAngles& angles) {
  // In the basis of linkAxes().
  const Eigen::Quaterniond whole(expSO3({angles.twist_rad, angles.bend_rad, angles.yaw_rad}));
  const double yaw_rad = std::remainder(2 * std::atan2(whole.z(), whole.w()), 2 * kPi);
  const Eigen::Quaterniond yaw(Eigen::AngleAxisd(yaw_rad, Eigen::Vector3d::UnitZ()));
  const Eigen::Vector3d tilt = logSO3((whole * yaw.conjugate()).toRotationMatrix());
  return {tilt.x(), tilt.y(), yaw_rad};
}

}  // namespace

std::vector<Finding> judgeLinkAngles(const LinkAngles& angles, LinkEnd source, LinkEnd target, const CellModel& model,
                                     const SolverOptions& options, const LinkAngles& sigma_rad) {
  constexpr double kSigmas = 3;
  constexpr double kSigmasOfModel = 6;  // real skins twist by 50 degrees where the model has 10
  const double worst_rad = std::max({sigma_rad.twist_rad, sigma_rad.bend_rad, sigma_rad.yaw_rad});
  const auto limitOf = [&](double elastomer_rad, double largest_rad, double of_rotation_rad) {
    return std::min(largest_rad + kSigmas * worst_rad, kSigmasOfModel * std::hypot(elastomer_rad, of_rotation_rad));
  };
  const LinkAngles limits = {limitOf(model.twist_sigma_rad, options.max_twist_rad, sigma_rad.twist_rad),
                             limitOf(model.bend_sigma_rad, options.max_bend_rad, sigma_rad.bend_rad),
                             limitOf(model.yaw_sigma_rad, options.max_yaw_rad, sigma_rad.yaw_rad)};
  // No part of a rotation is larger than the whole.
  const double whole = std::hypot(angles.bend_rad, angles.twist_rad, angles.yaw_rad);
  if (whole <= std::min({limits.bend_rad, limits.twist_rad, limits.yaw_rad})) return {};
  const LinkAngles judged = separated(angles);
  std::vector<Finding> findings;
  const Message link = linkText(source, target);
  const auto judge = [&](double angle_rad, double limit_rad, FindingCode code, const auto& inWords) {
    if (std::abs(angle_rad) <= limit_rad) return;
    Message words = inWords(Number{toDegrees(std::abs(angle_rad)), 0}, Number{toDegrees(limit_rad), 0});
    findings.push_back(makeFinding(code, std::move(words), {source.cell, target.cell}, {source.port, target.port}));
  };
  judge(judged.bend_rad, limits.bend_rad, FindingCode::ImplausibleBend, [&](Number angle, Number limit) {
    return message(
        "The {} bends by {} degrees, and a skin link by no more than {}. It is probably a cable or crosses a joint, or "
        "the axes of the accelerometers are not as the cell model says.",
        link, angle, limit);
  });
  judge(judged.twist_rad, limits.twist_rad, FindingCode::ImplausibleTwist, [&](Number angle, Number limit) {
    return message(
        "The {} is twisted by {} degrees, and a skin link by no more than {}. It is probably a cable, or a port number "
        "or the axes of the accelerometers are wrong.",
        link, angle, limit);
  });
  judge(judged.yaw_rad, limits.yaw_rad, FindingCode::ImplausibleYaw, [&](Number angle, Number limit) {
    return message(
        "The {} is turned in the surface by {} degrees, and a skin link by no more than {}. A port number is probably "
        "wrong, or it is a cable, or the axes of the accelerometers are not as the cell model says.",
        link, angle, limit);
  });
  return findings;
}

Finding describeUnexpectedAngle(FindingCode code, LinkEnd source, LinkEnd target, double angle_rad, double lowest_rad,
                                double highest_rad) {
  const Message link = linkText(source, target);
  const Number angle{toDegrees(angle_rad), 0};
  const Number lowest{toDegrees(lowest_rad), 0};
  const Number highest{toDegrees(highest_rad), 0};
  const auto inWords = [&] {
    switch (code) {
      case FindingCode::ImplausibleBend:
        return message(
            "The {} bends by {} degrees, where the links around it let expect {} to {}. It is probably a cable or "
            "crosses a joint, or one of its cells is mounted otherwise.",
            link, angle, lowest, highest);
      case FindingCode::ImplausibleTwist:
        return message(
            "The {} is twisted by {} degrees, where the links around it let expect {} to {}. It is probably a cable, a "
            "port number is wrong, or one of its cells is mounted otherwise.",
            link, angle, lowest, highest);
      default:
        return message(
            "The {} is turned in the surface by {} degrees, where {} to {} are to be expected. A port number is "
            "probably wrong, it is a cable, or one of its cells is mounted otherwise.",
            link, angle, lowest, highest);
    }
  };
  return makeFinding(code, inWords(), {source.cell, target.cell}, {source.port, target.port});
}

}  // namespace hexoderm
