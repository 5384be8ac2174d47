#pragma once

#include "hexoderm/solve/result/reconstruction.h"

#include <QColor>
#include <QPalette>
#include <QPen>
#include <QString>
#include <array>

class QLineF;
class QPainter;

namespace hexoderm {

enum class Theme { Light, Dark };

/// The theme of a palette. A widget passes its own whenever it paints, and hears of another theme by
/// QEvent::PaletteChange; a model, which belongs to no widget, passes the application's.
Theme themeOf(const QPalette& palette);

/// Line of a link by its quality: hue, style and word go together, so that no meaning hangs on hue alone.
struct LinkStroke {
  QColor color;
  Qt::PenStyle style = Qt::SolidLine;
  bool doubled = false;
};

/// The one place where a theme becomes colours. Hexoderm draws with these and nothing else. Those of the quality of
/// links are core's (hexoderm/solve/result/quality_colors.h), for exported files have them too.
struct Colors {
  QColor window;        ///< behind the panels
  QColor panel;         ///< background of cards, tables, docks
  QColor panel_active;  ///< background of the current step, hovered rows
  QColor border;
  QColor text;
  QColor text_muted;
  QColor accent;       ///< the one action, focus
  QColor accent_text;  ///< on accent
  QColor good;
  QColor caution;
  QColor bad;
  QColor scene_top;  ///< background of the 3D scene
  QColor scene_bottom;
  QColor cell_fill;  ///< hexagons of the graph
  QColor selection;  ///< outline of what is picked: black or white, not a hue
  QColor excluded_link;
  QColor tree_band;            ///< under the links of the shortest paths
  std::array<QColor, 3> axis;  ///< x, y, z: as red, green and blue as who can't tell red from green allows

  static const Colors& of(Theme theme);
  static const Colors& of(const QPalette& palette) { return of(themeOf(palette)); }
};

LinkStroke linkStroke(EdgeQuality quality, Theme theme);
/// Its pen, `width` thick: the same pattern in every view, shorter than Qt's own, as lines of links are.
QPen strokePen(const LinkStroke& stroke, double width);
/// A sample of it, for legends and tables: `width` is that of the single line, and the double one takes 2.2 times that.
void drawStroke(QPainter& painter, const LinkStroke& stroke, const QLineF& line, double width);
/// "fully defined" and so on, for legends and tooltips (translated).
QString qualityWord(EdgeQuality quality);

/// A Qt palette and a style sheet for the whole application.
QPalette qtPalette(Theme theme);
QString styleSheet(Theme theme);

/// Dark or light, whichever is read better on `ground`.
QColor textOn(const QColor& ground);

/// The theme that the system asks for: the desktop portal's setting if there is one, else the palette's lightness.
Theme systemTheme();

}  // namespace hexoderm
