#pragma once

#include "app/window/settings/theme.h"

#include <QObject>

namespace hexoderm {

class Preferences;
class WindowActions;

/// Dresses the window in the theme that the operator, or the desktop, chose.
class ThemePresenter : public QObject {
  Q_OBJECT

 public:
  /// Both outlive the presenter.
  ThemePresenter(const WindowActions& actions, Preferences& preferences);

  /// `remember`: also for the next start.
  void setChoice(ThemeChoice choice, bool remember);
  /// The choice that is in force.
  [[nodiscard]] ThemeChoice choice() const;

 private:
  const WindowActions& actions_;
  Preferences& preferences_;
};

}  // namespace hexoderm
