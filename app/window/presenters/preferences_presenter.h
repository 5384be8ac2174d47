#pragma once

#include <QObject>

class QWidget;

namespace hexoderm {

class MessageBar;
class Preferences;
class PreferencesDialog;
class SessionController;
class ThemePresenter;
class WindowActions;

/// Lets the operator change the preferences, which act at once.
class PreferencesPresenter : public QObject {
  Q_OBJECT

 public:
  struct Views {
    QWidget& window;  ///< the dialog belongs to it
    MessageBar& messages;
  };
  /// All outlive the presenter.
  PreferencesPresenter(const Views& views, SessionController& controller, const WindowActions& actions,
                       Preferences& preferences, ThemePresenter& themes);

 signals:
  void dialogMade(hexoderm::PreferencesDialog* dialog);

 private:
  void showDialog();
  /// Where the 3D view found no OpenGL, offers to draw it by the processor.
  void offerSoftwareOpenGl();

  Views views_;
  const WindowActions& actions_;
  Preferences& preferences_;
  ThemePresenter& themes_;
};

}  // namespace hexoderm
