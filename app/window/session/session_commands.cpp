#include "app/window/session/session_commands.h"

#include "widgets/words/formatting.h"

#include <algorithm>
#include <utility>

namespace hexoderm {
namespace {

QString nameOf(const SessionPose& pose) { return QString::number(pose.capture->id.value()); }

}  // namespace

AddPoseCommand::AddPoseCommand(EditedSession edited, SessionPose pose, std::optional<std::size_t> index)
    : edited_(std::move(edited)), pose_(std::move(pose)), index_(index.value_or(edited_.session.poses().size())) {
  setText(tr("take pose %1").arg(nameOf(pose_)));
}

void AddPoseCommand::redo() {
  edited_.session.addPose(pose_, index_);
  // A file that keeps the capture already only takes it back.
  if (std::exchange(is_new_, false)) {
    edited_.changed(AddPose{pose_, index_});
  } else {
    edited_.changed(RestorePose{pose_, index_});
  }
}

void AddPoseCommand::undo() {
  edited_.session.removePose(index_);
  edited_.changed(RemovePose{index_});
}

SetPoseDisabledCommand::SetPoseDisabledCommand(EditedSession edited, std::size_t index, bool disabled)
    : edited_(std::move(edited)),
      index_(index),
      disabled_(disabled),
      why_(edited_.session.poses().at(index).why_disabled) {
  const QString pose = nameOf(edited_.session.poses().at(index));
  setText(disabled ? tr("disable pose %1").arg(pose) : tr("enable pose %1").arg(pose));
}

void SetPoseDisabledCommand::redo() { set(disabled_, {}); }

void SetPoseDisabledCommand::undo() { set(!disabled_, why_); }

void SetPoseDisabledCommand::set(bool disabled, const std::string& why) {
  edited_.session.setPoseDisabled(index_, disabled, why);
  edited_.changed(SetPoseDisabled{index_, disabled, why});
}

RemovePoseCommand::RemovePoseCommand(EditedSession edited, std::size_t index)
    : edited_(std::move(edited)), pose_(edited_.session.poses().at(index)), index_(index) {
  setText(tr("delete pose %1").arg(nameOf(pose_)));
}

void RemovePoseCommand::redo() {
  edited_.session.removePose(index_);
  edited_.changed(RemovePose{index_});
}

void RemovePoseCommand::undo() {
  edited_.session.addPose(pose_, index_);
  edited_.changed(RestorePose{pose_, index_});
}

MuteLinkCommand::MuteLinkCommand(EditedSession edited, LinkEnd a, LinkEnd b, bool muted)
    : edited_(std::move(edited)), a_(std::min(a, b)), b_(std::max(a, b)), muted_(muted) {
  if (const MutedLink* before = edited_.session.findMutedLink(a_, b_)) why_ = before->why;
  const QString name = shortLinkName(a_, b_);
  setText(muted ? tr("set link %1 aside").arg(name) : tr("take link %1 back").arg(name));
}

void MuteLinkCommand::redo() { set(muted_, {}); }

void MuteLinkCommand::undo() { set(!muted_, why_); }

void MuteLinkCommand::set(bool muted, const std::string& why) {
  edited_.session.setLinkMuted(a_, b_, muted, why);
  edited_.changed(SetLinkMuted{a_, b_, muted, why});
}

}  // namespace hexoderm
