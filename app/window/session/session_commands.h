#pragma once

#include "hexoderm/session/session_edit.h"

#include <QCoreApplication>
#include <QUndoCommand>
#include <functional>

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
  EditCommand(EditedSession edited, SessionEdit edit);
  void redo() override { step(); }
  void undo() override { step(); }

 private:
  /// Applies the next edit; its inverse is the next one then.
  void step();

  EditedSession edited_;
  SessionEdit next_;
};

}  // namespace hexoderm
