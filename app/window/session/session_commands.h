#pragma once

#include "hexoderm/session/session_store.h"

#include <QCoreApplication>
#include <QUndoCommand>
#include <functional>
#include <string>

namespace hexoderm {

/// A session that is edited, and whoever keeps it. Outlives the commands that refer to it.
struct EditedSession {
  Session& session;
  /// Told about every change after it was made.
  std::function<void(StoreOperation)> changed;
};

// Everything that changes a session goes through one of these, so everything can be undone. The session must outlive
// the stack that holds the commands.

class AddPoseCommand : public QUndoCommand {
  Q_DECLARE_TR_FUNCTIONS(hexoderm::AddPoseCommand)

 public:
  /// `index`: among the poses then; none: at the end.
  AddPoseCommand(EditedSession edited, SessionPose pose, std::optional<std::size_t> index = std::nullopt);
  void redo() override;
  void undo() override;

 private:
  EditedSession edited_;
  SessionPose pose_;
  std::size_t index_;
  bool is_new_ = true;
};

/// Disables a pose, or enables it again. A reason that it was disabled for is kept for undo.
class SetPoseDisabledCommand : public QUndoCommand {
  Q_DECLARE_TR_FUNCTIONS(hexoderm::SetPoseDisabledCommand)

 public:
  SetPoseDisabledCommand(EditedSession edited, std::size_t index, bool disabled);
  void redo() override;
  void undo() override;

 private:
  void set(bool disabled, const std::string& why);

  EditedSession edited_;
  std::size_t index_;
  bool disabled_;
  std::string why_;
};

class RemovePoseCommand : public QUndoCommand {
  Q_DECLARE_TR_FUNCTIONS(hexoderm::RemovePoseCommand)

 public:
  RemovePoseCommand(EditedSession edited, std::size_t index);
  void redo() override;
  void undo() override;

 private:
  EditedSession edited_;
  SessionPose pose_;
  std::size_t index_;
};

/// Sets a link aside, or takes it back. A reason that it was set aside for is kept for undo.
class MuteLinkCommand : public QUndoCommand {
  Q_DECLARE_TR_FUNCTIONS(hexoderm::MuteLinkCommand)

 public:
  MuteLinkCommand(EditedSession edited, LinkEnd a, LinkEnd b, bool muted);
  void redo() override;
  void undo() override;

 private:
  void set(bool muted, const std::string& why);

  EditedSession edited_;
  LinkEnd a_;
  LinkEnd b_;
  bool muted_;
  std::string why_;
};

}  // namespace hexoderm
