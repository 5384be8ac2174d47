#pragma once

#include <QObject>

class QMenuBar;
class QWidget;

namespace hexoderm {

class SessionController;
class WindowActions;

/// Shows what the menu Help offers: the guide, the list of keys, the version.
class HelpPresenter : public QObject {
  Q_OBJECT

 public:
  /// All outlive the presenter. The list of keys is made of `menus`; dialogs belong to `window`.
  HelpPresenter(QWidget& window, const QMenuBar& menus, const SessionController& controller,
                const WindowActions& actions);

 private:
  void showGuide();
  void showAbout();

  QWidget& window_;
  const QMenuBar& menus_;
  const SessionController& controller_;
};

}  // namespace hexoderm
