#pragma once

// findLinks() on simulated robots with truth, counted over seeds: for the tests, and for the figures in the room's
// README.

#include "hexoderm/device/simulation/simulated_robot.h"
#include "hexoderm/geometry/se3.h"
#include "hexoderm/kinematics/demo_robot.h"
#include "hexoderm/reconstruction/reconstructor.h"
#include "hexoderm/robot/links/links.h"
#include "hexoderm/session/simulated_session.h"
#include "hexoderm/util/units.h"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

namespace hexoderm {

struct SimulatedLinksOptions {
  std::size_t poses = 8;
  bool motors = false;
  double zero_sigma_rad = 0.5 * kDegree;  ///< of the simulated joints
  LinksOptions find{};
};

/// Angles of a session's poses, as findLinks() takes them.
inline std::map<PoseId, JointAngles> anglesOf(const Session& session) {
  std::map<PoseId, JointAngles> angles;
  for (const SessionPose& pose : session.poses()) angles.emplace(pose.capture->id, pose.joint_angles);
  return angles;
}

/// Patches on the upper arm, the forearm and the hand of the demo robot.
inline SimulatedRobot simulatedArm(std::uint64_t seed, const SimulatedLinksOptions& options) {
  SimulatedRobotOptions robot;
  if (options.motors) robot.skin = SimulatedSkinOptions::robot();
  robot.seed = seed;
  robot.zero_offset_sigma_rad = options.zero_sigma_rad;
  robot.mounts = demoMounts();
  PatchMount hand{"hand", {rotationFromRpy({0.2, 0.4, 1}), {0, 0.04, 0.05}}, "sheet:2x3", "plane"};
  robot.mounts.push_back(hand);
  return {builtInCellModel("hex-bma150"), RobotModel::read(demoRobotFile()), robot};
}

struct LinksTally {
  int patches = 0;
  int alone = 0;       ///< on the right link, or on links that turn with it, and no other candidate
  int equivalent = 0;  ///< the right link is in the only candidate, with others that can't be told from it
  int among = 0;       ///< the right link is in one of several candidates
  int wrong = 0;       ///< candidates without the right link
  int none = 0;        ///< no candidate
  std::map<std::string, std::vector<double>> nees_on;  ///< turn_nees by link
  std::vector<double> turn_nees;                       ///< of the turns on the right links, each by 3
  std::vector<double> errors_rad;
  std::vector<double> stated_rad;
  std::vector<double> zero_nees;  ///< of the zeros that are shown
  std::vector<double> zero_errors_rad;
  std::vector<double> all_zero_nees;  ///< of all zeros
  std::vector<double> tilt_nees;      ///< by 2
  std::vector<double> chi_per_freedom;

  void add(SimulatedRobot& robot, const SimulatedLinksOptions& options) {
    const SimulatedRobotSession simulated = simulateRobotSession(robot, options.poses);
    const auto solved = reconstruct(*simulated.session.snapshot());
    const LinksResult result = findLinks(*solved, robot.robot(), anglesOf(simulated.session), options.find);
    for (const PatchLinks& patch : result.patches) addPatch(robot, patch);
    if (!result.robot) return;
    addZeros(robot, *result.robot);
    addTilt(simulated.poses.front().up_w, *result.robot);
    chi_per_freedom.push_back(result.robot->chi_squared / std::max(1, result.robot->freedom));
  }

 private:
  void addPatch(const SimulatedRobot& robot, const PatchLinks& found) {
    ++patches;
    for (const MountedPatch& patch : robot.patches()) {
      const auto at = std::ranges::find(patch.cells, found.origin);
      if (at == patch.cells.end()) continue;
      const Eigen::Matrix3d& truth = patch.T_l_u[static_cast<std::size_t>(at - patch.cells.begin())].R;
      const PatchTurn* right = nullptr;
      for (const LinkCandidate& candidate : found.candidates) {
        for (const PatchTurn& turn : candidate.links) right = turn.link == patch.link ? &turn : right;
      }
      if (found.candidates.empty()) {
        ++none;
      } else if (right == nullptr) {
        ++wrong;
      } else if (found.placed) {
        ++alone;
      } else {
        ++(found.candidates.size() == 1 ? equivalent : among);
      }
      if (right == nullptr) return;
      const Eigen::Vector3d e = logSO3(right->R_l_o.transpose() * truth);
      turn_nees.push_back(e.dot(right->covariance.llt().solve(e)) / 3);
      nees_on[patch.link].push_back(turn_nees.back());
      errors_rad.push_back(e.norm());
      stated_rad.push_back(std::sqrt(right->covariance.trace()));
    }
  }

  void addZeros(const SimulatedRobot& robot, const RobotEstimate& estimate) {
    for (const JointZero& zero : estimate.zeros) {
      const double error = zero.zero_rad - robot.zeroOffsets().positions.at(zero.joint);
      all_zero_nees.push_back(std::pow(error / zero.sigma_rad, 2));
      if (!zero.shown) continue;
      zero_nees.push_back(std::pow(error / zero.sigma_rad, 2));
      zero_errors_rad.push_back(std::abs(error));
    }
  }

  void addTilt(const Eigen::Vector3d& up_w, const RobotEstimate& estimate) {
    Eigen::Matrix<double, 3, 2> across;
    across.col(0) = estimate.up_w.cross(Eigen::Vector3d::UnitX()).normalized();
    across.col(1) = estimate.up_w.cross(across.col(0));
    const Eigen::Vector2d e = across.transpose() * up_w;
    const Eigen::Matrix2d C = across.transpose() * estimate.up_covariance * across;
    tilt_nees.push_back(e.dot(C.llt().solve(e)) / 2);
  }
};

inline double medianOf(std::vector<double> values) {
  std::ranges::sort(values);
  return values.empty() ? 0 : values[values.size() / 2];
}
inline double meanOf(const std::vector<double>& values) {
  double sum = 0;
  for (const double value : values) sum += value;
  return values.empty() ? 0 : sum / static_cast<double>(values.size());
}
/// 1 sigma of meanOf().
inline double meanSigmaOf(const std::vector<double>& values) {
  if (values.size() < 2) return 0;
  double squares = 0;
  for (const double value : values) squares += std::pow(value - meanOf(values), 2);
  const auto count = static_cast<double>(values.size());
  return std::sqrt(squares / (count - 1) / count);
}

inline std::string inWords(const LinksTally& tally) {
  std::string by_link;
  for (const auto& [link, nees] : tally.nees_on) by_link += ", " + link + " " + std::to_string(meanOf(nees));

  const auto mean = [](const std::vector<double>& values) {
    return std::to_string(meanOf(values)) + " +- " + std::to_string(1.96 * meanSigmaOf(values)) + " of " +
           std::to_string(values.size());
  };
  return "patches " + std::to_string(tally.patches) + ": alone " + std::to_string(tally.alone) + ", equivalent " +
         std::to_string(tally.equivalent) + ", among several " + std::to_string(tally.among) + ", wrong " +
         std::to_string(tally.wrong) + ", none " + std::to_string(tally.none) + "; turn error, median " +
         std::to_string(toDegrees(medianOf(tally.errors_rad))) + " deg, stated " +
         std::to_string(toDegrees(medianOf(tally.stated_rad))) + ", NEES " + mean(tally.turn_nees) + by_link +
         "; zeros NEES " + mean(tally.zero_nees) + ", error, median " +
         std::to_string(toDegrees(medianOf(tally.zero_errors_rad))) + " deg, all zeros NEES " +
         mean(tally.all_zero_nees) + "; tilt NEES " + mean(tally.tilt_nees) + "; chi-squared per freedom " +
         mean(tally.chi_per_freedom);
}

}  // namespace hexoderm
