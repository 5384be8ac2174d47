#pragma once

// Skins whose cells obey eq. (2) exactly, written down rather than simulated: both extended port vectors of a link end
// in one point. They fix what the method must give on data that fit its model.

#include "hexoderm/session/session.h"
#include "tests/support/independent_chips.h"

#include <array>
#include <map>
#include <random>
#include <vector>

namespace hexoderm {

struct PinJoint {
  std::uint32_t source = 0;
  std::uint32_t source_port = 0;
  std::uint32_t target = 0;
  std::uint32_t target_port = 0;
  double bend_rad = 0;
  double twist_rad = 0;
  double yaw_rad = 0;
};

class PinJointedSkin {
 public:
  /// A tree of joints, each starting at a cell that is already placed; the first joint's source is the root.
  explicit PinJointedSkin(const std::vector<PinJoint>& joints, CellModel cell_model = independentChips())
      : model(std::move(cell_model)) {
    truth[CellId(joints.empty() ? 1 : joints.front().source)] = SE3();
    for (const PinJoint& joint : joints) {
      const Port& source = model.port(PortNumber(joint.source_port));
      const Port& target = model.port(PortNumber(joint.target_port));
      const Eigen::Vector3d angles(joint.twist_rad, joint.bend_rad, joint.yaw_rad);
      const Eigen::Matrix3d R = expSO3(linkAxes(source) * angles) * nominalAlignment(source, target);
      truth[CellId(joint.target)] = truth.at(CellId(joint.source)) * linkTransform(R, source, target);
      connect({CellId(joint.source), source.number}, {CellId(joint.target), target.number});
    }
  }

  void connect(LinkEnd a, LinkEnd b) {
    neighbors[a.cell].push_back({a.port, b.cell, b.port});
    neighbors[b.cell].push_back({b.port, a.cell, a.port});
  }

  /// A session with exact readings of gravity for the given up directions (root's frame).
  [[nodiscard]] Session session(const std::vector<Eigen::Vector3d>& up_directions) const {
    NeighborList list;
    for (const auto& [id, T] : truth) {
      const auto found = neighbors.find(id);
      list.push_back({id, "", found == neighbors.end() ? std::vector<NeighborReport>{} : found->second});
    }
    Session session(model, list);
    for (const Eigen::Vector3d& up : up_directions) {
      PoseCapture pose{session.nextPoseId(), {}, {}};
      for (const auto& [id, T] : truth) {
        pose.samples.push_back({id, T.R.transpose() * up.normalized(), Eigen::Matrix3d::Zero(), 0});
      }
      session.addPose({std::make_shared<const PoseCapture>(std::move(pose)), false});
    }
    return session;
  }

  CellModel model;
  std::map<CellId, SE3> truth;  ///< root's frame
  std::map<CellId, std::vector<NeighborReport>> neighbors;
};

/// Independent chips on cells whose ports 1 to 4 have these heights.
inline CellModel modelOfHeights(const std::array<double, 4>& heights_m) {
  CellModel model = independentChips();
  for (std::size_t k = 0; k < heights_m.size(); ++k) model.ports.at(k).vector_m.z() = heights_m.at(k);
  return model;
}
/// One line of cells forms steps, the other folds by 28 degrees a link.
inline CellModel modelOfStepsAndFolds() { return modelOfHeights({0.004, -0.005, -0.002, -0.004}); }

/// X17 around something like an arm: two lines of nine cells through cell 1, every joint bent, a little twisted.
inline PinJointedSkin bentX17(const CellModel& model = independentChips()) {
  std::vector<PinJoint> joints;
  std::uint32_t next = 2;
  const std::pair<std::uint32_t, std::uint32_t> arms[] = {{1, 4}, {4, 1}, {2, 3}, {3, 2}};
  double variation = 0;
  for (const auto& [out, in] : arms) {
    std::uint32_t from = 1;
    for (int k = 0; k < 4; ++k) {
      variation += 0.37;
      joints.push_back({from, out, next, in, 0.25 + 0.1 * std::sin(variation), 0.05 * std::cos(variation),
                        0.02 * std::sin(3 * variation)});
      from = next++;
    }
  }
  return PinJointedSkin(joints, model);
}

/// A straight line of eight cells, bent into an open or nearly closed ring, whose free ends these are.
inline PinJointedSkin ringOfEight(double bend_rad, const CellModel& model = independentChips()) {
  std::vector<PinJoint> joints;
  for (std::uint32_t k = 1; k < 8; ++k) joints.push_back({k, 2, k + 1, 3, bend_rad, 0, 0});
  return PinJointedSkin(joints, model);
}
inline constexpr LinkEnd kRingFirst{CellId(1), PortNumber(3)};
inline constexpr LinkEnd kRingLast{CellId(8), PortNumber(2)};

/// Two orthogonal poses, the paper's recipe.
inline std::vector<Eigen::Vector3d> orthogonalUps(std::size_t count) {
  const std::vector<Eigen::Vector3d> all = {{0, 0, 1}, {1, 0, 0}, {0, 1, 0}, {0, 0, -1}, {-1, 0, 0}, {0, -1, 0}};
  return {all.begin(), all.begin() + static_cast<std::ptrdiff_t>(count)};
}

}  // namespace hexoderm
