#include "hexoderm/solve/metrics/pose_summary.h"

#include "hexoderm/base/units.h"

#include <algorithm>
#include <cmath>

namespace hexoderm {
namespace {

// Two poses whose gravity lines are closer than this tell little more than one.
constexpr double kRepeatedAngle = 10 * kDegree;

/// Rms over all links of what they say about one pose.
std::optional<double> residualOf(std::size_t pose, const std::vector<PatchReconstruction>& patches) {
  double sum = 0;
  std::size_t count = 0;
  for (const PatchReconstruction& patch : patches) {
    for (const LinkEstimate& link : patch.links) {
      if (pose >= link.pose_residual_rad.size() || !link.pose_residual_rad[pose]) continue;
      sum += *link.pose_residual_rad[pose] * *link.pose_residual_rad[pose];
      ++count;
    }
  }
  if (count == 0) return std::nullopt;
  return std::sqrt(sum / static_cast<double>(count));
}

/// From the third pose on the opposite of an earlier direction helps to separate offsets; a repeated one never does.
void judgeRepetitions(const std::vector<GravityDirection>& gravity, std::vector<Finding>& findings) {
  for (std::size_t later = 1; later < gravity.size(); ++later) {
    for (std::size_t earlier = 0; earlier < later; ++earlier) {
      const double angle = angleBetween(gravity[later].g_o, gravity[earlier].g_o);
      const bool opposite = gravity.size() == 2 && kPi - angle < kRepeatedAngle;
      if (angle >= kRepeatedAngle && !opposite) continue;
      findings.push_back(
          makeFinding(FindingCode::RepeatedPose,
                      opposite ? message("Pose {} is pose {} upside down (within {}), which adds no new direction.",
                                         gravity[later].pose, gravity[earlier].pose, Degrees{kPi - angle, 0})
                               : message("Pose {} shows gravity where pose {} does (within {}), which adds no new "
                                         "direction.",
                                         gravity[later].pose, gravity[earlier].pose, Degrees{angle, 0}),
                      {}, {}, {gravity[earlier].pose, gravity[later].pose}));
      break;
    }
  }
}

}  // namespace

std::vector<PoseSummary> summarisePoses(const SessionSnapshot& snapshot, const GravityTable& table,
                                        const Reconstruction& reconstruction) {
  const PatchReconstruction* largest = largestPatch(reconstruction);
  std::vector<PoseSummary> summaries;
  std::vector<Eigen::Vector3d> earlier;
  std::size_t next_direction = 0;
  for (std::size_t pose = 0; pose < table.poseCount(); ++pose) {
    PoseSummary summary;
    summary.pose = snapshot.poses[pose].capture->id;
    summary.label = snapshot.poses[pose].capture->label;
    summary.enabled = !snapshot.poses[pose].disabled;
    double noise = 0;
    for (std::size_t cell = 0; cell < table.cellCount(); ++cell) {
      const GravityTable::Entry& entry = table.at(cell, pose);
      if (!entry.usable) continue;
      ++summary.cells_measured;
      noise += entry.variance_g2;
    }
    if (summary.cells_measured > 0) summary.noise_g = std::sqrt(noise / static_cast<double>(summary.cells_measured));
    if (summary.enabled && largest != nullptr && next_direction < largest->gravity.size() &&
        largest->gravity[next_direction].pose == summary.pose) {
      const Eigen::Vector3d& g = largest->gravity[next_direction++].g_o;
      // Opposite directions are the same line: no new rank.
      const auto nearest =
          std::ranges::max_element(earlier, {}, [&g](const auto& other) { return std::abs(g.dot(other)); });
      if (nearest != earlier.end()) {
        summary.new_by_rad = std::min(angleBetween(g, *nearest), angleBetween(g, -*nearest));
      }
      earlier.push_back(g);
    }
    summary.residual_rad = residualOf(pose, reconstruction.patches);
    summaries.push_back(std::move(summary));
  }
  return summaries;
}

void judgePoses(const Reconstruction& reconstruction, std::vector<Finding>& findings) {
  const PatchReconstruction* largest = largestPatch(reconstruction);
  if (largest == nullptr) return;
  std::vector<PoseId> enabled;
  for (const PoseSummary& pose : reconstruction.poses) {
    if (pose.enabled) enabled.push_back(pose.pose);
  }
  if (enabled.empty()) {
    findings.push_back(makeFinding(FindingCode::NoPoses,
                                   message("There is no pose yet: the shape shown follows from the ports alone.")));
    return;
  }
  judgeRepetitions(largest->gravity, findings);
}

}  // namespace hexoderm
