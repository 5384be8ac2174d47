#pragma once

#include <QObject>

class QWidget;

namespace hexoderm {

class EventLog;
class LogView;
class MessageBar;
class SessionController;
class WindowActions;

/// Serves the log to people who report a bug: as a text to be pasted, as a folder to be opened.
class LogPresenter : public QObject {
  Q_OBJECT

 public:
  struct Views {
    QWidget& window;  ///< its graphics are described in the report
    LogView& log;
    MessageBar& messages;
  };
  /// All outlive the presenter.
  LogPresenter(const Views& views, const SessionController& controller, const WindowActions& actions,
               const EventLog& log);

 private:
  void copyReport();
  void openFolder();

  Views views_;
  const SessionController& controller_;
  const EventLog& log_;
};

}  // namespace hexoderm
