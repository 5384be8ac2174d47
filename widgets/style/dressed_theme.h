#pragma once

#include "widgets/style/palette.h"

#include <QEvent>
#include <QWidget>
#include <utility>

namespace hexoderm {

/// The theme that a widget is dressed in. One change of theme changes its palette several times, and dressing a scene
/// or a plot anew takes long.
class DressedTheme {
 public:
  /// For a widget that is dressed in the theme of its palette from the beginning.
  explicit DressedTheme(const QWidget& widget) : widget_(widget), theme_(themeOf(widget.palette())) {}

  /// Whether the event brings another theme. The widget is taken to be dressed in that one from then on.
  bool isChangedBy(const QEvent& event) {
    if (event.type() != QEvent::PaletteChange) return false;
    const Theme theme = themeOf(widget_.palette());
    return std::exchange(theme_, theme) != theme;
  }

 private:
  const QWidget& widget_;
  Theme theme_;
};

}  // namespace hexoderm
