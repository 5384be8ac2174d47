#include "app/window/theme.h"

#include <QApplication>

namespace hexoderm {
namespace {

/// What the panels of the main window add to the application's sheet.
QString panelSheet(const Colors& colors) {
  return QStringLiteral(
             "QFrame[cardHead=\"true\"] { background: %1; border: 1px solid %2; border-bottom: 0;"
             " border-top-left-radius: 6px; border-top-right-radius: 6px; }"
             "QFrame[cardBody=\"true\"] { background: %1; border: 1px solid %2; border-top: 0;"
             " border-bottom-left-radius: 6px; border-bottom-right-radius: 6px; }"
             "QScrollArea#stepPanel, QWidget#stepContent { background: %1; border: 0; }"
             "QFrame[stepBody=\"true\"] { background: %3; border: 0; }"
             "QLabel[stepWhat=\"true\"] { font-weight: 600; }"
             "QWidget#topBar { background: %1; border-bottom: 1px solid %2; }"
             "QWidget#topBar QMenuBar { border: 0; }"
             "QLabel#appName { color: %4; font-weight: 700; padding: 0 4px 0 16px; }"
             "QLabel#sessionName { color: %5; padding: 0 16px; }"
             "QStatusBar QLabel { padding: 4px 8px; }"
             "QLabel[hint=\"true\"] { color: %5; padding: 12px 14px; background: %1; }")
      .arg(colors.panel.name(), colors.border.name(), colors.panel_active.name(), colors.text.name(),
           colors.text_muted.name());
}

}  // namespace

QString themeChoiceName(ThemeChoice choice) {
  switch (choice) {
    case ThemeChoice::System:
      return QStringLiteral("system");
    case ThemeChoice::Light:
      return QStringLiteral("light");
    case ThemeChoice::Dark:
      return QStringLiteral("dark");
  }
  return {};
}

std::optional<ThemeChoice> themeChoiceFromName(const QString& name) {
  for (const ThemeChoice choice : {ThemeChoice::System, ThemeChoice::Light, ThemeChoice::Dark}) {
    if (themeChoiceName(choice) == name) return choice;
  }
  return std::nullopt;
}

Theme resolveTheme(ThemeChoice choice) {
  // Asked once, before our own palette hides the system's.
  static const Theme kSystem = systemTheme();
  switch (choice) {
    case ThemeChoice::System:
      return kSystem;
    case ThemeChoice::Light:
      return Theme::Light;
    case ThemeChoice::Dark:
      return Theme::Dark;
  }
  return kSystem;
}

void applyTheme(Theme theme) {
  QApplication::setPalette(qtPalette(theme));
  qApp->setStyleSheet(styleSheet(theme) + panelSheet(Colors::of(theme)));
}

}  // namespace hexoderm
