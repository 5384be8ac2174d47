#pragma once

#include "widgets/style/palette.h"

#include <QString>
#include <optional>

namespace hexoderm {

/// Light, dark, or whatever the system asks for.
enum class ThemeChoice { System, Light, Dark };

QString themeChoiceName(ThemeChoice choice);  ///< "system", "light", "dark", as in settings and on the command line
std::optional<ThemeChoice> themeChoiceFromName(const QString& name);

/// The theme that a choice means now. The system's is asked for once, before our own palette hides it.
Theme resolveTheme(ThemeChoice choice);
/// The system has another theme from now on.
void setSystemTheme(Theme theme);

/// Sets the style in which widgets are drawn, the same on every desktop. Must be called before the first window is
/// made.
void installStyle();

/// Gives the whole application the palette and style sheet of a theme. Windows that are shown are painted with it in
/// the next turns of the event loop, as they were until then.
void applyTheme(Theme theme);
/// Whether every window that is shown can be painted with it.
bool isThemeFinished();
/// Every window that is shown can be painted with it now: for pictures.
void finishTheme();

}  // namespace hexoderm
