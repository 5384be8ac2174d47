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
    connect(actions_.themes, &QActionGroup::triggered, this, [this] { setChoice(choice(), true); });
    connect(&preferences_, &Preferences::textFactorChanged, this, [this](double factor) {
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
    actions_.theme[static_cast<std::size_t>(choice)]->setChecked(true);
    if (remember) preferences_.setTheme(choice);
  }

  /// The choice that is in force.
  [[nodiscard]] ThemeChoice choice() const {
    return static_cast<ThemeChoice>(actions_.themes->actions().indexOf(actions_.themes->checkedAction()));
  }
};

}  // namespace hexoderm
