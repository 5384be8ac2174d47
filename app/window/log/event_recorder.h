#pragma once

#include "widgets/controls/banner.h"

#include <QObject>
#include <QString>

class QAction;

namespace hexoderm {

class EventLog;
class MessageBar;
class SessionController;

/// Writes into the log what the operator asked for, what came of it, what they were told.
class EventRecorder : public QObject {
  Q_OBJECT

 public:
  /// All outlive the recorder. The log begins with the version of the program.
  EventRecorder(EventLog& log, const SessionController& controller, const MessageBar& messages,
                const QList<QAction*>& actions);

 private:
  void recordTold(Tone tone, const QString& text);
  void recordAsked(const QAction& action);
  void recordConnection();

  EventLog& log_;
  const SessionController& controller_;
  QString connection_state_;  ///< last written
};

}  // namespace hexoderm
