#pragma once

#include "app/window/settings/theme.h"

#include <QObject>
#include <functional>
#include <vector>

namespace hexoderm {

class Preferences;
class WindowActions;

/// Dresses the window in the theme that the operator, or the desktop, chose.
class ThemePresenter : public QObject {
  Q_OBJECT

 public:
  /// All outlive the presenter, as every view that is added does.
  ThemePresenter(const WindowActions& actions, Preferences& preferences);

  /// The view is dressed from the next setChoice() on.
  template <class View>
  void add(View* view) {
    dress_.push_back([view](Theme theme) { view->setTheme(theme); });
  }

  /// `remember`: also for the next start.
  void setChoice(ThemeChoice choice, bool remember);
  /// The choice that is in force.
  [[nodiscard]] ThemeChoice choice() const;
  [[nodiscard]] Theme theme() const { return theme_; }

 private:
  const WindowActions& actions_;
  Preferences& preferences_;
  std::vector<std::function<void(Theme)>> dress_;
  Theme theme_ = Theme::Light;
};

}  // namespace hexoderm
