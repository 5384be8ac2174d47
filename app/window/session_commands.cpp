#include "app/window/session_commands.h"

#include <utility>

namespace hexoderm {
namespace {

QString nameOf(const SessionPose& pose) { return QString::number(pose.capture->id.value()); }

}  // namespace

AddPoseCommand::AddPoseCommand(Session& session, SessionPose pose)
    : session_(session), pose_(std::move(pose)), index_(session.poses().size()) {
  setText(tr("take pose %1").arg(nameOf(pose_)));
}

void AddPoseCommand::redo() { session_.addPose(pose_, index_); }

void AddPoseCommand::undo() { session_.removePose(index_); }

SetPoseDisabledCommand::SetPoseDisabledCommand(Session& session, std::size_t index, bool disabled)
    : session_(session), index_(index), disabled_(disabled) {
  const QString pose = nameOf(session.poses().at(index));
  setText(disabled ? tr("disable pose %1").arg(pose) : tr("enable pose %1").arg(pose));
}

void SetPoseDisabledCommand::redo() { session_.setPoseDisabled(index_, disabled_); }

void SetPoseDisabledCommand::undo() { session_.setPoseDisabled(index_, !disabled_); }

RemovePoseCommand::RemovePoseCommand(Session& session, std::size_t index)
    : session_(session), pose_(session.poses().at(index)), index_(index) {
  setText(tr("delete pose %1").arg(nameOf(pose_)));
}

void RemovePoseCommand::redo() { session_.removePose(index_); }

void RemovePoseCommand::undo() { session_.addPose(pose_, index_); }

}  // namespace hexoderm
