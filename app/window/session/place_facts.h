#pragma once

#include "app/window/session/hand_place.h"
#include "app/window/session/placing.h"
#include "widgets/tables/joint_table.h"

#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace hexoderm {

class SessionController;

/// Whether two places of a patch can't be told apart: 0.1 mm and 0.06 degrees.
[[nodiscard]] bool isSamePlace(const PatchOnLink& a, const PatchOnLink& b);

/// What is known of the patches on the robot while the step "Place on the robot" is worked on: what was read and found,
/// beside what the session says was decided; and of which patch and pose the step speaks. The questions change nothing.
struct PlaceFacts {
  /// Nothing is known yet. The controller outlives this.
  explicit PlaceFacts(const SessionController& of) : controller(of) {}

  const SessionController& controller;
  std::shared_ptr<const Reconstruction> solved;
  std::shared_ptr<const LoadedRobot> robot;
  std::shared_ptr<const LinksResult> links;
  std::shared_ptr<const PlaceResult> places;  ///< of the patch that is spoken of
  CellId spoken_of{0};                        ///< the origin cell of the patch that the step is about
  quint32 pose = 0;                           ///< in which the robot is drawn
  int preview = -1;                           ///< the row of the place that is pointed at
  std::optional<PutPlace> put;                ///< where a patch was put by hand; the fit begins there too
  bool lays = false;                          ///< what the fit makes of where it was put becomes its place

  /// The patch that the step is about; null: there is none.
  [[nodiscard]] const PatchReconstruction* patch() const;
  [[nodiscard]] const PatchReconstruction* patchOf(CellId cell) const;
  [[nodiscard]] const PatchLinks* linksOf(const PatchReconstruction& patch) const;
  /// What is decided about a patch, as far as anything is.
  [[nodiscard]] PatchPlacement decided(const PatchReconstruction& patch) const;
  /// The link that it is taken to be on: the decided one, or the only one that fits. Empty where it is open.
  [[nodiscard]] std::string linkOf(const PatchReconstruction& patch) const;
  /// Of the poses that have any of a joint of this robot.
  [[nodiscard]] std::map<PoseId, JointAngles> angles() const;
  [[nodiscard]] JointAngles shownAngles() const;
  [[nodiscard]] JointSheet sheet() const;
  /// The patches that are placed together with one, because distances join them: itself first.
  [[nodiscard]] std::vector<const PatchReconstruction*> placedWith(const PatchReconstruction& patch) const;
  /// What a place is looked for with; nullopt: nothing is known that could hold the patch.
  [[nodiscard]] std::optional<PlaceTask> taskFor(const PatchReconstruction& patch) const;
  /// The row of the place that was chosen; -1: the patch is at none of the places that were found.
  [[nodiscard]] int rowOfPlace() const;
  [[nodiscard]] bool isPut(const PatchReconstruction& patch) const;
};

}  // namespace hexoderm
