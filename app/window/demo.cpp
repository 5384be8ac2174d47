#include "app/window/demo.h"

#include "hexoderm/capture/pose_capture.h"
#include "hexoderm/reconstruction/pose_advisor.h"
#include "hexoderm/session/simulated_session.h"

#include <algorithm>
#include <vector>

namespace hexoderm {

DemoSkin::DemoSkin() : skin_(builtInCellModel("hex-bma150"), SimulatedSkinOptions()) {}

Session DemoSkin::makeSession() const { return beginSimulatedSession(skin_); }

QString DemoSkin::nextLabel(const Session& session) {
  const auto enabled = std::count_if(session.poses().begin(), session.poses().end(),
                                     [](const SessionPose& pose) { return !pose.disabled; });
  if (enabled == 0) return tr("standing");
  // The second direction advised is always about square to the first.
  if (enabled == 1) return tr("on its side");
  return tr("pose %1").arg(session.nextPoseId().value());
}

PoseCapture DemoSkin::takePose(PoseId id, const QString& label, const Reconstruction& seen) {
  Eigen::Vector3d up_b = scriptedUpDirections(1).front();
  // The demo is one patch.
  if (!seen.patches.empty() && !seen.patches.front().gravity.empty()) {
    const PatchReconstruction& patch = seen.patches.front();
    std::vector<Eigen::Vector3d> directions_o;
    for (const GravityDirection& gravity : patch.gravity) directions_o.push_back(gravity.g_o);
    const auto origin = std::find_if(skin_.truth().begin(), skin_.truth().end(),
                                     [&](const TrueCell& cell) { return cell.id == patch.origin; });
    // Who holds a real part sees where its cells are; the simulated hand has to be told.
    up_b = origin->T_b_u.R * adviseNextPose(skin_.model(), directions_o).up;
  }
  return averageFrames(skin_.record(up_b), id, label.toStdString());
}

}  // namespace hexoderm
