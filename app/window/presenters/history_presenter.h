#pragma once

#include <QObject>
#include <QString>

class QWidget;

namespace hexoderm {

class EarlierPanel;
class EventLog;
class FilePresenter;
class MessageBar;
class RecentFiles;
class SessionController;
class UnsavedSessions;
class WelcomePanel;
class WindowActions;

/// Offers the sessions of earlier times: the recent ones, the ones that were not saved.
class HistoryPresenter : public QObject {
  Q_OBJECT

 public:
  struct Views {
    QWidget& window;
    WelcomePanel& welcome;
    EarlierPanel& earlier;  ///< shown where the welcome is not
    MessageBar& messages;
  };
  struct Lists {
    RecentFiles& recent;
    UnsavedSessions& unsaved;
  };
  /// All outlive the presenter.
  HistoryPresenter(const Views& views, const Lists& lists, const SessionController& controller,
                   const WindowActions& actions, FilePresenter& files, EventLog& log);

  /// The welcome is shown as long as nothing is open.
  void refresh();
  /// Looks for files that are gone, and for sessions that were not saved.
  void search();

 private:
  void connectRecent(const WindowActions& actions);
  void connectUnsaved();
  void noteOpened();
  void noteSaved(const QString& path);
  void notePoses();
  void offerUnsaved(int count);

  Views views_;
  Lists lists_;
  const SessionController& controller_;
  FilePresenter& files_;
  EventLog& log_;
};

}  // namespace hexoderm
