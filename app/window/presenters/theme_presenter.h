#pragma once

#include "app/window/presenters/presenter.h"
#include "app/window/settings/theme.h"

namespace hexoderm {

/// Dresses the window in the theme that the operator, or the desktop, chose.
class ThemePresenter : public Presenter {
  Q_OBJECT

 public:
  explicit ThemePresenter(const WindowParts& parts);

  /// `remember`: also for the next start.
  void setChoice(ThemeChoice choice, bool remember);
  /// The choice that is in force.
  [[nodiscard]] ThemeChoice choice() const;
};

}  // namespace hexoderm
