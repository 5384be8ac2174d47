#include "widgets/style/palette.h"

#include "hexoderm/solve/result/quality_colors.h"
#include "widgets/style/of_enum.h"
#include "widgets/style/scene_colors.h"
#include "widgets/style/system_theme.h"

#include <QApplication>
#include <QCoreApplication>
#include <QLineF>
#include <QPainter>
#include <utility>
#include <vector>

namespace hexoderm {
namespace {

Colors makeColors(Theme theme) {
  const bool is_dark = theme == Theme::Dark;
  const Background background = is_dark ? Background::Dark : Background::Light;
  const auto either = [is_dark](QRgb on_light, QRgb on_dark) { return QColor(is_dark ? on_dark : on_light); };
  return {
      .window = either(0xF4F5F7, 0x16191D),
      .panel = either(0xFFFFFF, 0x1E2227),
      .panel_active = either(0xEEF1F5, 0x14171B),
      .border = either(0xD9DDE3, 0x323841),
      .text = either(0x1D232B, 0xE7EAEE),
      .text_muted = either(0x5B6673, 0x9AA5B1),
      .accent = either(0x17649B, 0x5FB3E8),
      .accent_text = either(0xFFFFFF, 0x0D1114),
      .good = either(0x187856, 0x57C79A),
      .caution = QColor(qualityColor(EdgeQuality::Partially, background)),
      .bad = either(0xB31D26, 0xF0807A),
      .scene_top = either(0xEEF1F5, 0x14171B),
      .scene_bottom = either(0xDFE5EC, 0x1E242B),
      .cell_fill = either(0xFFFFFF, 0x1E2227),
      .selection = either(0x000000, 0xFFFFFF),
      .excluded_link = QColor(unusedColor(background)),
      .tree_band = either(0xD9DDE3, 0x444D59),
      .axis = {either(0xC2410C, 0xF4894A), either(0x00806F, 0x7BE0C8), either(0x3B3FB0, 0x6C9CFF)},
  };
}

/// Half way between two colours, for what is there but can't be used.
QColor faded(const QColor& color, const QColor& ground) {
  return {(color.red() + ground.red()) / 2, (color.green() + ground.green()) / 2, (color.blue() + ground.blue()) / 2};
}

}  // namespace

Theme themeOf(const QPalette& palette) {
  return palette.color(QPalette::Base).lightness() < 128 ? Theme::Dark : Theme::Light;
}

const Colors& Colors::of(Theme theme) {
  static const Colors on_light = makeColors(Theme::Light);
  static const Colors on_dark = makeColors(Theme::Dark);
  return theme == Theme::Dark ? on_dark : on_light;
}

LinkStroke linkStroke(EdgeQuality quality, Theme theme) {
  return {QColor(qualityColor(quality, theme == Theme::Dark ? Background::Dark : Background::Light)),
          ofEnum(quality, {Qt::DotLine, Qt::DashLine, Qt::SolidLine, Qt::SolidLine}), quality == EdgeQuality::Over};
}

QPen strokePen(const LinkStroke& stroke, double width) {
  QPen pen(stroke.color, width, Qt::SolidLine, Qt::FlatCap);
  // The pattern is in pen widths.
  if (stroke.style == Qt::DashLine) pen.setDashPattern({2.6, 1.3});
  if (stroke.style == Qt::DotLine) pen.setDashPattern({1.0, 1.2});
  return pen;
}

void drawStroke(QPainter& painter, const LinkStroke& stroke, const QLineF& line, double width) {
  if (!stroke.doubled) {
    painter.setPen(strokePen(stroke, width));
    painter.drawLine(line);
    return;
  }
  painter.setPen(strokePen(stroke, 0.7 * width));
  const QLineF normal = line.normalVector().unitVector();
  const QPointF aside = 0.75 * width * QPointF(normal.dx(), normal.dy());
  painter.drawLine(line.translated(aside));
  painter.drawLine(line.translated(-aside));
}

QString qualityWord(EdgeQuality quality) {
  return ofEnum(quality, {QCoreApplication::translate("hexoderm::Palette", "un-defined"),
                          QCoreApplication::translate("hexoderm::Palette", "partially defined"),
                          QCoreApplication::translate("hexoderm::Palette", "fully defined"),
                          QCoreApplication::translate("hexoderm::Palette", "over-defined")});
}

QPalette qtPalette(Theme theme) {
  const Colors& colors = Colors::of(theme);
  QPalette palette;
  const std::vector<std::pair<QColor, std::vector<QPalette::ColorRole>>> roles = {
      {colors.window, {QPalette::Window}},
      {colors.panel, {QPalette::Base, QPalette::Button, QPalette::ToolTipBase, QPalette::Light}},
      {colors.panel_active, {QPalette::AlternateBase, QPalette::Midlight}},
      {colors.border, {QPalette::Mid, QPalette::Dark, QPalette::Shadow}},
      {colors.text, {QPalette::WindowText, QPalette::Text, QPalette::ButtonText, QPalette::ToolTipText}},
      {colors.text_muted, {QPalette::PlaceholderText}},
      {colors.accent, {QPalette::Highlight, QPalette::Link, QPalette::LinkVisited}},
      {colors.accent_text, {QPalette::BrightText, QPalette::HighlightedText}}};
  for (const auto& [color, colored] : roles) {
    for (const QPalette::ColorRole role : colored) palette.setColor(role, color);
  }
  const QColor disabled = faded(colors.text_muted, colors.panel);
  for (const QPalette::ColorRole role : {QPalette::WindowText, QPalette::Text, QPalette::ButtonText}) {
    palette.setColor(QPalette::Disabled, role, disabled);
  }
  palette.setColor(QPalette::Disabled, QPalette::Highlight, colors.border);
  palette.setColor(QPalette::Disabled, QPalette::HighlightedText, colors.text_muted);
  return palette;
}

QColor textOn(const QColor& ground) {
  const Rgb below = {ground.redF(), ground.greenF(), ground.blueF()};
  return contrast(below, {1, 1, 1}) > contrast(below, {0, 0, 0}) ? Qt::white : Qt::black;
}

Theme systemTheme() {
  if (const std::optional<Theme> wanted = desktopPortalTheme()) return *wanted;
  const QPalette palette = qApp != nullptr ? QApplication::palette() : QPalette();
  return palette.color(QPalette::Window).lightness() < palette.color(QPalette::WindowText).lightness() ? Theme::Dark
                                                                                                       : Theme::Light;
}

}  // namespace hexoderm
