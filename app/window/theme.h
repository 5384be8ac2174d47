#pragma once

#include "widgets/palette.h"

#include <QString>
#include <optional>

namespace hexoderm {

/// Light, dark, or whatever the system asks for.
enum class ThemeChoice { System, Light, Dark };

QString themeChoiceName(ThemeChoice choice);  ///< "system", "light", "dark", as in settings and on the command line
std::optional<ThemeChoice> themeChoiceFromName(const QString& name);

/// The theme that a choice means now.
Theme resolveTheme(ThemeChoice choice);

/// How widgets are drawn, the same on every desktop. Before the first window.
void installStyle();

/// Gives the whole application the palette and style sheet of a theme.
void applyTheme(Theme theme);

}  // namespace hexoderm
