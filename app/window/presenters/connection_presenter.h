#pragma once

#include <QObject>
#include <QString>
#include <cstdint>

class QWidget;

namespace hexoderm {

class EventLog;
class FilePresenter;
class LiveStrip;
class MessageBar;
class SessionController;
class StatusBar;
class WindowActions;
struct ConnectRequest;

/// Shows the connection to a skin, from the dialog that asks for its address to the words on what it captured.
class ConnectionPresenter : public QObject {
  Q_OBJECT

 public:
  struct Views {
    QWidget& window;  ///< the dialog belongs to it
    LiveStrip& strip;
    StatusBar& status;
    MessageBar& messages;
  };
  /// All outlive the presenter.
  ConnectionPresenter(const Views& views, SessionController& controller, const WindowActions& actions,
                      FilePresenter& files, EventLog& log);

  /// Asks first if poses would be lost.
  void connectTo(const ConnectRequest& request);
  /// Shows where the connection stands. Cheap: may be called 20 times a second.
  void refresh();

 private:
  void showDialog();
  void showCaptured(const QString& text, bool remarkable);
  void showOffences();

  Views views_;
  SessionController& controller_;
  FilePresenter& files_;
  EventLog& log_;
  std::size_t offences_shown_ = 0;       ///< of those of the running source
  std::uint64_t late_frames_shown_ = 0;  ///< of the recorder
};

}  // namespace hexoderm
