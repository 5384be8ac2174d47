#pragma once

// The panel of checks on the screen, and results to show in it.

#include "hexoderm/base/units.h"
#include "tests/support/hand_made_skins.h"
#include "tests/support/panel_on_screen.h"
#include "widgets/verify/verify_panel.h"

namespace hexoderm::verify_panel_test {

inline HoldOutResult heldOut(HoldOutAgreement agreement, double rms_deg) {
  HoldOutResult result;
  result.outcome = HoldOutOutcome::Evaluated;
  result.pose = PoseId(3);
  result.other_poses = 5;
  for (std::uint32_t id = 1; id <= 17; ++id) {
    result.cells.push_back({CellId(id), (id == 8 ? 3 : 1) * rms_deg * kDegree, 0.5 * kDegree});
  }
  result.links.push_back({{CellId(1), PortNumber(1)}, {CellId(2), PortNumber(4)}, 0.7 * kDegree, 0.6 * kDegree});
  result.rms_rad = rms_deg * kDegree;
  result.expected_rms_rad = 0.5 * kDegree;
  result.agreement = agreement;
  return result;
}

inline FoundLoop loop(bool closed, double length_m) {
  FoundLoop loop;
  loop.closed = closed;
  loop.cells = {CellId(1), CellId(2), CellId(5), CellId(4)};
  loop.closure.first = {CellId(1), PortNumber(3)};
  loop.closure.second = {CellId(4), PortNumber(2)};
  loop.closure.gap_m = {length_m, 0, 0};
  loop.closure.length_m = length_m;
  loop.closure.loop_length_m = 0.2;
  loop.closure.percent = 500 * length_m;
  loop.limit_m = 0.0075;
  return loop;
}

inline SurfaceEvaluation cylinder() {
  SurfaceEvaluation surface;
  surface.kind = SurfaceKind::Cylinder;
  surface.radius_m = 0.0503;
  for (std::uint32_t id = 1; id <= 17; ++id) {
    surface.cells.emplace_back(id);
    surface.distance_m.push_back(id == 12 ? -0.0009 : 0.0003);
    surface.tilt_rad.push_back(1 * kDegree);
  }
  surface.rms_m = 0.00042;
  surface.tilt_rms_rad = 1 * kDegree;
  return surface;
}

inline CheckedCell checked(std::uint32_t id, CellChange change, Message words) {
  CheckedCell cell;
  cell.cell = CellId(id);
  cell.change = change;
  cell.words = std::move(words);
  cell.poses = 2;
  if (change == CellChange::None) cell.noticed_turn_rad = 4 * kDegree;
  return cell;
}

/// Two poses against a calibration of five cells: cell 5 turned, 7 is dead, 9 can't be told, 99 is gone.
inline CalibrationCheck changedSkin() {
  CalibrationCheck check;
  check.poses = {PoseId(4), PoseId(5)};
  check.cells = {
      checked(1, CellChange::None, message("as calibrated")),
      checked(5, CellChange::Turned, message("turned by {} +- {}", Degrees{20 * kDegree}, Degrees{0.5 * kDegree})),
      checked(7, CellChange::Broken, message("dead: it reads no gravity")),
      checked(9, CellChange::NotTold, message("can't be told: its calibration is too uncertain")),
      checked(99, CellChange::Broken, message("gone: it is no longer among the skin's cells"))};
  check.cells[1].turn = {20 * kDegree, 0.5 * kDegree, false};
  check.summary = Message::verbatim("Not as calibrated: cells 5, 7 and 99.");
  check.advice = Message::verbatim("See that it sits firmly.");
  check.remarks = {Message::verbatim("A link is no longer reported.")};
  check.changed = true;
  check.compared = true;
  return check;
}

class VerifyPanelTest : public test::PanelOnScreen<VerifyPanel> {
 protected:
  VerifyPanelTest() : PanelOnScreen({262, 640}) {}
  std::shared_ptr<Reconstruction> skin() {
    auto reconstruction = sampleX17();
    reconstruction->assessment.position_95_m = 0.0012;
    reconstruction->poses.push_back(reconstruction->poses.front());
    reconstruction->poses.back().pose = PoseId(5);
    return reconstruction;
  }
  std::string sentence(const char* section) {
    auto* label = panel_->findChild<QLabel*>(QLatin1String(section) + "Sentence");
    return label->isVisible() ? label->text().toStdString() : "";
  }
};

}  // namespace hexoderm::verify_panel_test
