#pragma once

#include "widgets/style/palette.h"

#include <QApplication>

namespace hexoderm::test {

/// Gives the whole application the palette and the style sheet of a theme; at the end it is light and has no sheet.
class AppTheme {
 public:
  AppTheme() {
    QApplication::setStyle(QStringLiteral("Fusion"));
    set(Theme::Light);
  }
  ~AppTheme() {
    QApplication::setPalette(qtPalette(Theme::Light));
    qApp->setStyleSheet({});
  }
  AppTheme(const AppTheme&) = delete;
  AppTheme& operator=(const AppTheme&) = delete;

  void set(Theme theme) {
    QApplication::setPalette(qtPalette(theme));
    qApp->setStyleSheet(styleSheet(theme));
  }
};

}  // namespace hexoderm::test
