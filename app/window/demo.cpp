#include "app/window/demo.h"

#include <set>

namespace hexoderm {

DemoSkin::DemoSkin() : skin_(builtInCellModel("hex-bma150"), SimulatedSkinOptions()) {}

Session DemoSkin::makeSession() const {
  Session session(skin_.model(), skin_.neighbors(), {skin_.description(), {}, {}});
  GroundTruth truth;
  for (const TrueCell& cell : skin_.truth()) truth.cells.push_back({cell.id, cell.T_b_u});
  session.setTruth(std::move(truth));
  return session;
}

DemoSkin::Hold DemoSkin::nextHold(const Session& session) const {
  std::set<std::size_t> seen;
  for (const SessionPose& pose : session.poses()) {
    const auto hold = hold_of_.find(pose.capture->id);
    if (!pose.disabled && hold != hold_of_.end()) seen.insert(hold->second);
  }
  Hold hold;
  while (seen.contains(hold.index)) ++hold.index;
  // The script depends on how many poses are meant; six, the faces of a cube, is what the demo aims at.
  constexpr std::size_t kAim = 6;
  hold.up_b = scriptedUpDirections(std::max(kAim, hold.index + 1))[hold.index];
  if (hold.index == 0) {
    hold.label = tr("standing");
  } else if (hold.index == 1) {
    hold.label = tr("on its side");
  } else {
    hold.label = tr("pose %1").arg(hold.index + 1);
  }
  return hold;
}

void DemoSkin::remember(PoseId pose, const Hold& hold) { hold_of_[pose] = hold.index; }

PoseCapture DemoSkin::record(PoseId pose, const Hold& hold) {
  return averageFrames(skin_.record(hold.up_b), pose, hold.label.toStdString());
}

}  // namespace hexoderm
