#pragma once

#include "app/window/log/event_log.h"
#include "app/window/session/session_controller.h"
#include "widgets/capture/live_strip.h"
#include "widgets/controls/banner.h"
#include "widgets/controls/message_bar.h"
#include "widgets/style/of_enum.h"
#include "widgets/words/formatting.h"
#include "widgets/words/words.h"

#include <QAction>
#include <QObject>
#include <QString>

namespace hexoderm {

/// Writes into the log what the operator asked for, what came of it, what they were told.
class EventRecorder : public QObject {
  Q_OBJECT

 public:
  /// All outlive the recorder. The log begins with the version of the program.
  EventRecorder(EventLog& log, const SessionController& controller, const MessageBar& messages,
                const QList<QAction*>& actions)
      : log_(log), controller_(controller) {
    log_.add(Severity::Info, tr("Hexoderm %1 starts").arg(QLatin1String(HEXODERM_VERSION)));
    connect(&messages, &MessageBar::shown, this, &EventRecorder::recordTold);
    for (const QAction* action : actions) {
      connect(action, &QAction::triggered, this, [this, action] { recordAsked(*action); });
    }
    connect(&controller_, &SessionController::opened, this,
            [this](const QString& name) { log_.add(Severity::Info, tr("Opened %1").arg(name)); });
    connect(&controller_, &SessionController::reconstructionChanged, this,
            [this](const std::shared_ptr<const Reconstruction>& result) {
              if (result) log_.add(Severity::Info, lineOf(*result));
            });
    connect(&controller_.liveSession().source(), &LiveSource::statusChanged, this, &EventRecorder::recordConnection);
  }

 private:
  /// A result in one line: its size, its solver, the time it took, its verdict.
  static QString lineOf(const Reconstruction& result) {
    return EventRecorder::tr("Solved: %1, %2, %3, %4 ms. %5")
        .arg(words(sizeText(result)), posesText(result.poses.size()), QString::fromStdString(result.solver),
             figureText(1e3 * result.solve_seconds, 1), words(result.assessment.reason));
  }

  void recordTold(Tone tone, const QString& text) {
    log_.add(ofEnum(tone, {Severity::Info, Severity::Info, Severity::Warning, Severity::Error}), text);
  }
  void recordAsked(const QAction& action) {
    log_.add(Severity::Info, tr("Asked for: %1").arg(action.text().remove(QLatin1Char('&'))));
  }

  void recordConnection() {
    const LiveSource& live = controller_.liveSession().source();
    const QString state = sourceStateWord(live.status().state);
    // The text counts readings; only what becomes of the connection is news.
    if (state == connection_state_) return;
    connection_state_ = state;
    const bool is_bad = live.status().state == SourceState::Silent || live.status().state == SourceState::Incompatible;
    log_.add(is_bad ? Severity::Warning : Severity::Info,
             tr("Skin at %1: %2. %3").arg(live.address(), state, words(live.status().message)));
  }

  EventLog& log_;
  const SessionController& controller_;
  QString connection_state_;  ///< last written
};

}  // namespace hexoderm
