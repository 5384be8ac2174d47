#pragma once

// Matchers that explain themselves: what was off, by how much, in which units.

#include "hexoderm/base/se3.h"
#include "hexoderm/solve/result/reconstruction.h"

#include <gmock/gmock.h>

#include <algorithm>
#include <cmath>

namespace hexoderm {

inline void PrintTo(Solver solver, std::ostream* out) { *out << solverName(solver); }

inline void PrintTo(const Reconstruction& reconstruction, std::ostream* out) {
  *out << "a reconstruction of " << sizeText(reconstruction);
}

MATCHER_P2(RotationNear, expected, tolerance_rad, "") {
  const Eigen::Matrix3d difference = Eigen::Matrix3d(expected).transpose() * Eigen::Matrix3d(arg);
  const double angle = rotationAngle(difference);
  *result_listener << "turned by " << angle << " rad from the expected rotation";
  // Not `angle > tolerance`: that would let NaN through.
  return angle <= tolerance_rad && std::abs(Eigen::Matrix3d(arg).determinant() - 1) < 1e-9;
}

MATCHER_P2(VectorNear, expected, tolerance, "") {
  const double distance = (Eigen::Vector3d(arg) - Eigen::Vector3d(expected)).norm();
  *result_listener << "off by " << distance << " from " << Eigen::Vector3d(expected).transpose() << ": "
                   << Eigen::Vector3d(arg).transpose();
  return distance <= tolerance;
}

MATCHER_P3(SE3Near, expected, tolerance_rad, tolerance_m, "") {
  const SE3 difference = SE3(expected).inverse() * SE3(arg);
  const double angle = rotationAngle(difference.R);
  *result_listener << "turned by " << angle << " rad and " << difference.t.norm() << " m away";
  return angle <= tolerance_rad && difference.t.norm() <= tolerance_m;
}

/// The first finding of a code in a reconstruction, or nullptr.
inline const Finding* findingOf(const Reconstruction& result, FindingCode code) {
  const auto found = std::ranges::find(result.findings, code, &Finding::code);
  return found == result.findings.end() ? nullptr : &*found;
}

/// A reconstruction has findings of a code, and the first of them matches.
MATCHER_P2(HasFinding, code, matcher, "") {
  const Finding* finding = findingOf(arg, code);
  if (finding != nullptr) return ExplainMatchResult(matcher, *finding, result_listener);
  *result_listener << "without a finding " << codeName(code);
  return false;
}
MATCHER_P(HasFinding, code, "") { return ExplainMatchResult(HasFinding(code, ::testing::_), arg, result_listener); }

MATCHER_P3(IsVerdict, level, limit, remedy, "") {
  const Assessment& assessment = arg;
  *result_listener << assessment.reason << " | " << assessment.next_action;
  return assessment.level == level && assessment.limit == limit && assessment.remedy == remedy;
}

/// What matches in English.
MATCHER_P(InEnglish, matcher, "") { return ExplainMatchResult(matcher, arg.english(), result_listener); }

/// No NaN and no infinite value anywhere in a reconstruction.
MATCHER(IsFinite, "") {
  const Reconstruction& r = arg;
  for (const PatchReconstruction& patch : r.patches) {
    for (const CellPlacement& cell : patch.cells) {
      if (!cell.T_o_u.R.allFinite() || !cell.T_o_u.t.allFinite() || (cell.cov_t_r && !cell.cov_t_r->allFinite())) {
        *result_listener << "cell " << cell.cell << " is not finite";
        return false;
      }
    }
    for (const LinkEstimate& link : patch.links) {
      const bool finite = link.R_c_n.allFinite() && link.singular_values.allFinite() && std::isfinite(link.weight) &&
                          std::isfinite(link.residual_rad) && std::isfinite(link.sigma_rad) &&
                          std::isfinite(link.bend_rad) && std::isfinite(link.twist_rad) && std::isfinite(link.yaw_rad);
      if (!finite) {
        *result_listener << "the link of cells " << link.source.cell << " and " << link.target.cell << " is not finite";
        return false;
      }
    }
    for (const GravityDirection& gravity : patch.gravity) {
      if (!gravity.g_o.allFinite() || !std::isfinite(gravity.sigma_rad)) {
        *result_listener << "gravity in pose " << gravity.pose << " is not finite";
        return false;
      }
    }
  }
  return std::isfinite(r.assessment.position_95_m.value_or(0)) &&
         std::isfinite(r.assessment.orientation_95_rad.value_or(0));
}

/// Two reconstructions of one skin: the same placements whatever patch order, cell by cell.
MATCHER_P3(ReconstructionNear, expected, tolerance_rad, tolerance_m, "") {
  const Reconstruction& a = arg;
  const Reconstruction& b = expected;
  if (a.cellCount() != b.cellCount() || a.patches.size() != b.patches.size()) {
    *result_listener << "sizes differ: " << sizeText(a) << " and " << sizeText(b);
    return false;
  }
  for (const PatchReconstruction& patch : b.patches) {
    for (const CellPlacement& cell : patch.cells) {
      const Reconstruction::Located found = a.find(cell.cell);
      if (found.cell == nullptr) {
        *result_listener << "cell " << cell.cell << " is missing";
        return false;
      }
      const SE3 difference = cell.T_o_u.inverse() * found.cell->T_o_u;
      if (!(rotationAngle(difference.R) <= tolerance_rad && difference.t.norm() <= tolerance_m)) {
        *result_listener << "cell " << cell.cell << " is turned by " << rotationAngle(difference.R) << " rad and "
                         << difference.t.norm() << " m away";
        return false;
      }
    }
  }
  return true;
}

}  // namespace hexoderm
