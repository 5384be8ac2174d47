#pragma once

#include "app/window/presenters/presenter.h"
#include "app/window/settings/theme.h"
#include "widgets/style/system_theme.h"

#include <QTimer>

namespace hexoderm {

/// Dresses the window in the theme that the operator, or the desktop, chose.
class ThemePresenter : public Presenter {
  Q_OBJECT

 public:
  explicit ThemePresenter(const WindowParts& parts) : Presenter(parts) {
    connect(actions.themes, &QActionGroup::triggered, this, [this] { setChoice(choice(), true); });
    connect(&preferences, &Preferences::textFactorChanged, this, [this](double factor) {
      applyTextFactor(factor);
      // The style sheet's sizes follow the application's; in a turn of the event loop of their own.
      QTimer::singleShot(1, this, [this] { setChoice(choice(), true); });
    });
    connect(new SystemThemeWatch(this), &SystemThemeWatch::changed, this, [this](Theme theme) {
      setSystemTheme(theme);
      if (choice() == ThemeChoice::System) setChoice(ThemeChoice::System, false);
    });
  }

  /// `remember`: also for the next start.
  void setChoice(ThemeChoice choice, bool remember) {
    applyTheme(resolveTheme(choice));
    actions.theme[static_cast<std::size_t>(choice)]->setChecked(true);
    if (remember) preferences.setTheme(choice);
  }

  /// The choice that is in force.
  [[nodiscard]] ThemeChoice choice() const {
    return static_cast<ThemeChoice>(actions.themes->actions().indexOf(actions.themes->checkedAction()));
  }
};

}  // namespace hexoderm
