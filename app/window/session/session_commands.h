#pragma once

#include "hexoderm/session/session_edit.h"
#include "widgets/words/formatting.h"

#include <QCoreApplication>
#include <QUndoCommand>
#include <algorithm>
#include <functional>
#include <utility>

namespace hexoderm {

/// A session that is edited, and whoever keeps it. Both outlive the commands that refer to them.
struct EditedSession {
  Session& session;
  std::function<void(const SessionEdit&)> changed;  ///< told about every edit after it was made
};

/// An edit of a session as a step of the undo stack.
class EditCommand : public QUndoCommand {
  Q_DECLARE_TR_FUNCTIONS(hexoderm::EditCommand)

 public:
  EditCommand(EditedSession edited, SessionEdit edit) : edited_(std::move(edited)), next_(std::move(edit)) {
    const std::vector<SessionPose>& poses = edited_.session.poses();
    if (const auto* add = std::get_if<AddPose>(&next_)) {
      setText(tr("take pose %1").arg(idOf(add->pose)));
    } else if (const auto* remove = std::get_if<RemovePose>(&next_)) {
      setText(tr("delete pose %1").arg(idOf(poses.at(remove->index))));
    } else if (const auto* set = std::get_if<SetPoseDisabled>(&next_)) {
      const QString pose = idOf(poses.at(set->index));
      setText(set->disabled ? tr("disable pose %1").arg(pose) : tr("enable pose %1").arg(pose));
    } else if (const auto* joints = std::get_if<SetJointAngles>(&next_)) {
      setText(tr("set the joint angles of pose %1").arg(idOf(poses.at(joints->index))));
    } else if (const auto* robot = std::get_if<SetRobot>(&next_)) {
      setText(robot->robot ? tr("choose the robot") : tr("remove the robot"));
    } else if (const auto* placed = std::get_if<SetPatchPlacement>(&next_)) {
      const QString cell = QString::number(placed->placement.origin.value());
      setText(tr("place the patch of cell %1").arg(cell));
    } else if (const auto* excluded = std::get_if<SetLinkMuted>(&next_)) {
      const QString link = shortLinkName(std::min(excluded->a, excluded->b), std::max(excluded->a, excluded->b));
      setText(excluded->muted ? tr("set link %1 aside").arg(link) : tr("take link %1 back").arg(link));
    }
  }

  void redo() override { step(); }
  void undo() override { step(); }

 private:
  static QString idOf(const SessionPose& pose) { return QString::number(pose.capture->id.value()); }

  /// Applies the next edit; its inverse is the next one then.
  void step() {
    const SessionEdit edit = std::exchange(next_, inverse(next_, edited_.session));
    apply(edit, edited_.session);
    edited_.changed(edit);
  }

  EditedSession edited_;
  SessionEdit next_;
};

}  // namespace hexoderm
