#pragma once

// Sessions whose readings are wrong in ways that the simulator has no fault for. The neighbours stay as they are; the
// truth is not carried over.

#include "tests/support/changed_session.h"
#include "tests/support/normal_draw.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <map>
#include <set>
#include <vector>

namespace hexoderm::test {

/// Up to `count` cells that are joined to each other: those nearest to `start` by links, `start` first.
inline std::vector<CellId> cellsAround(const NeighborList& neighbors, CellId start, std::size_t count) {
  std::vector<CellId> cells = {start};
  for (std::size_t k = 0; k < cells.size() && cells.size() < count; ++k) {
    for (const NeighborReport& link : std::ranges::find(neighbors, cells[k], &CellReport::id)->neighbors) {
      if (link.cell.value() == 0 || cells.size() == count || std::ranges::find(cells, link.cell) != cells.end())
        continue;
      cells.push_back(link.cell);
    }
  }
  return cells;
}

/// Multiplies the readings of some cells by a matrix in cell axes; of all cells if none are named.
inline Session multiplied(const Session& session, const Eigen::Matrix3d& by, const std::set<CellId>& cells = {}) {
  return changed(session, [&](std::size_t /*pose*/, GravitySample& sample) {
    if (!cells.empty() && !cells.contains(sample.cell)) return;
    sample.mean_g = by * sample.mean_g;
    sample.cov_g2 = by * sample.cov_g2 * by.transpose();
  });
}

/// Every cell has `share` of the reading of the cell before it in the order of the captures, cyclically: 1 shifts all
/// IDs by one.
inline Session mixedWithPrevious(const Session& session, double share) {
  return withCaptures(session, [share](std::size_t /*pose*/, PoseCapture& capture) {
    const std::vector<GravitySample> sent = capture.samples;
    for (std::size_t k = 0; k < sent.size(); ++k) {
      const GravitySample& other = sent[(k + sent.size() - 1) % sent.size()];
      capture.samples[k].mean_g = (1 - share) * sent[k].mean_g + share * other.mean_g;
      if (share == 1) capture.samples[k].cov_g2 = other.cov_g2;
    }
  });
}

inline Session exchanged(const Session& session, CellId one, CellId other) {
  return changed(session, [&](std::size_t /*pose*/, GravitySample& sample) {
    if (sample.cell == one) {
      sample.cell = other;
    } else if (sample.cell == other) {
      sample.cell = one;
    }
  });
}

/// The offset of the cell was set so that its first reading is 1 g along z.
inline Session tared(const Session& session, CellId cell) {
  const Eigen::Vector3d first_g =
      std::ranges::find(session.poses().front().capture->samples, cell, &GravitySample::cell)->mean_g;
  return changed(session, [&](std::size_t /*pose*/, GravitySample& sample) {
    if (sample.cell == cell) sample.mean_g += Eigen::Vector3d::UnitZ() - first_g;
  });
}

/// The cell lies a little otherwise in every pose: turned by a normal deviate of so much about each axis.
inline Session rattling(const Session& session, CellId cell, double sigma_rad, NormalDraw& random) {
  return changed(session, [&](std::size_t /*pose*/, GravitySample& sample) {
    if (sample.cell == cell) sample.mean_g = expSO3(sigma_rad * random.vector()) * sample.mean_g;
  });
}

/// Every axis of every cell is shaken independently in one pose, by noise with a correlation time of 40 ms in readings
/// at `rate_hz`. The covariance of the mean is that of independent readings, as a recorder computes it.
inline Session shaken(const Session& session, std::size_t shaken_pose, double rms_g, double rate_hz,
                      NormalDraw& random) {
  constexpr double kCorrelation_s = 0.04;
  const double kept = std::exp(-1 / (kCorrelation_s * rate_hz));
  return changed(session, [&](std::size_t pose, GravitySample& sample) {
    if (pose != shaken_pose) return;
    Eigen::Vector3d now_g = rms_g * random.vector();
    Eigen::Vector3d sum_g = Eigen::Vector3d::Zero();
    for (std::uint32_t k = 0; k < sample.count; ++k) {
      sum_g += now_g;
      now_g = kept * now_g + rms_g * std::sqrt(1 - kept * kept) * random.vector();
    }
    sample.mean_g += sum_g / sample.count;
    sample.cov_g2.diagonal().array() += rms_g * rms_g / sample.count;
  });
}

/// Adds a specific force, g, body frame, that depends on the pose and on where a cell is in the body frame. The session
/// must have the truth.
inline Session withForce(const Session& session,
                         const std::function<Eigen::Vector3d(std::size_t pose, const Eigen::Vector3d& p_b)>& force_b) {
  std::map<CellId, SE3> truth;
  for (const TrueCellPlacement& cell : session.truth()->cells) truth.emplace(cell.id, cell.T_b_u);
  return changed(session, [&](std::size_t pose, GravitySample& sample) {
    const SE3& T_b_u = truth.at(sample.cell);
    sample.mean_g += T_b_u.R.transpose() * force_b(pose, T_b_u.t);
  });
}

/// Direction of the mean reading of a pose, body frame. The session must have the truth.
inline Eigen::Vector3d upIn(const Session& session, std::size_t pose) {
  Eigen::Vector3d sum_b = Eigen::Vector3d::Zero();
  for (const GravitySample& sample : session.poses()[pose].capture->samples) {
    sum_b += std::ranges::find(session.truth()->cells, sample.cell, &TrueCellPlacement::id)->T_b_u.R * sample.mean_g;
  }
  return sum_b.normalized();
}

/// Mean of the cells' places, body frame. The session must have the truth.
inline Eigen::Vector3d middleOf(const Session& session) {
  Eigen::Vector3d sum_b = Eigen::Vector3d::Zero();
  for (const TrueCellPlacement& cell : session.truth()->cells) sum_b += cell.T_b_u.t;
  return sum_b / static_cast<double>(session.truth()->cells.size());
}

/// The part spins about the vertical through its middle while it is read, in all poses.
inline Session spinning(const Session& session, double rate_rad_s) {
  constexpr double kGravity_m_s2 = 9.80665;
  const Eigen::Vector3d middle_b = middleOf(session);
  std::vector<Eigen::Matrix3d> field_b;
  for (std::size_t pose = 0; pose < session.poses().size(); ++pose) {
    const Eigen::Matrix3d rate = skew(rate_rad_s * upIn(session, pose));
    field_b.emplace_back(rate * rate / kGravity_m_s2);
  }
  return withForce(session, [&](std::size_t pose, const Eigen::Vector3d& p_b) -> Eigen::Vector3d {
    return field_b[pose] * (p_b - middle_b);
  });
}

/// The part is hit while it is read in one pose: on the average over the readings it is accelerated by a normal deviate
/// of so much along each axis, and about each.
inline Session hit(const Session& session, std::size_t hit_pose, double sigma_g, double sigma_g_per_m,
                   NormalDraw& random) {
  const Eigen::Vector3d middle_b = middleOf(session);
  const Eigen::Vector3d force_b = sigma_g * random.vector();
  const Eigen::Vector3d turn_b = sigma_g_per_m * random.vector();
  return withForce(session, [&](std::size_t pose, const Eigen::Vector3d& p_b) -> Eigen::Vector3d {
    if (pose != hit_pose) return Eigen::Vector3d::Zero();
    return force_b + turn_b.cross(p_b - middle_b);
  });
}

}  // namespace hexoderm::test
