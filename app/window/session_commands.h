#pragma once

#include "hexoderm/session/session.h"

#include <QCoreApplication>
#include <QUndoCommand>

namespace hexoderm {

// Everything that changes a session goes through one of these, so everything can be undone. The session must outlive
// the stack that holds the commands.

class AddPoseCommand : public QUndoCommand {
  Q_DECLARE_TR_FUNCTIONS(hexoderm::AddPoseCommand)

 public:
  AddPoseCommand(Session& session, SessionPose pose);
  void redo() override;
  void undo() override;

 private:
  Session& session_;
  SessionPose pose_;
  std::size_t index_;
};

class SetPoseDisabledCommand : public QUndoCommand {
  Q_DECLARE_TR_FUNCTIONS(hexoderm::SetPoseDisabledCommand)

 public:
  SetPoseDisabledCommand(Session& session, std::size_t index, bool disabled);
  void redo() override;
  void undo() override;

 private:
  Session& session_;
  std::size_t index_;
  bool disabled_;
};

class RemovePoseCommand : public QUndoCommand {
  Q_DECLARE_TR_FUNCTIONS(hexoderm::RemovePoseCommand)

 public:
  RemovePoseCommand(Session& session, std::size_t index);
  void redo() override;
  void undo() override;

 private:
  Session& session_;
  SessionPose pose_;
  std::size_t index_;
};

}  // namespace hexoderm
