#include "widgets/style/palette.h"

#include "hexoderm/reconstruction/result/quality_colors.h"
#include "widgets/style/of_enum.h"
#include "widgets/style/scene_colors.h"
#include "widgets/style/system_theme.h"

#include <QApplication>
#include <QCoreApplication>
#include <QLineF>
#include <QPainter>
#include <algorithm>
#include <cmath>

namespace hexoderm {
namespace {

QColor qualityOn(Background background, EdgeQuality quality) {
  return QColor::fromRgb(qualityColor(quality, background));
}
QColor unusedOn(Background background) { return QColor::fromRgb(unusedColor(background)); }

const Colors kLight = {
    .window = QColor(0xF4, 0xF5, 0xF7),
    .panel = QColor(0xFF, 0xFF, 0xFF),
    .panel_active = QColor(0xEE, 0xF1, 0xF5),
    .border = QColor(0xD9, 0xDD, 0xE3),
    .text = QColor(0x1D, 0x23, 0x2B),
    .text_muted = QColor(0x5B, 0x66, 0x73),
    .accent = QColor(0x17, 0x64, 0x9B),
    .accent_text = QColor(0xFF, 0xFF, 0xFF),
    .good = QColor(0x18, 0x78, 0x56),
    .caution = qualityOn(Background::Light, EdgeQuality::Partially),
    .bad = QColor(0xB3, 0x1D, 0x26),
    .scene_top = QColor(0xEE, 0xF1, 0xF5),
    .scene_bottom = QColor(0xDF, 0xE5, 0xEC),
    .cell_fill = QColor(0xFF, 0xFF, 0xFF),
    .selection = QColor(0x00, 0x00, 0x00),
    .muted_link = unusedOn(Background::Light),
    .tree_band = QColor(0xD9, 0xDD, 0xE3),
    .axis = {QColor(0xC2, 0x41, 0x0C), QColor(0x00, 0x80, 0x6F), QColor(0x3B, 0x3F, 0xB0)},
};

const Colors kDark = {
    .window = QColor(0x16, 0x19, 0x1D),
    .panel = QColor(0x1E, 0x22, 0x27),
    .panel_active = QColor(0x14, 0x17, 0x1B),
    .border = QColor(0x32, 0x38, 0x41),
    .text = QColor(0xE7, 0xEA, 0xEE),
    .text_muted = QColor(0x9A, 0xA5, 0xB1),
    .accent = QColor(0x5F, 0xB3, 0xE8),
    .accent_text = QColor(0x0D, 0x11, 0x14),
    .good = QColor(0x57, 0xC7, 0x9A),
    .caution = qualityOn(Background::Dark, EdgeQuality::Partially),
    .bad = QColor(0xF0, 0x80, 0x7A),
    .scene_top = QColor(0x14, 0x17, 0x1B),
    .scene_bottom = QColor(0x1E, 0x24, 0x2B),
    .cell_fill = QColor(0x1E, 0x22, 0x27),
    .selection = QColor(0xFF, 0xFF, 0xFF),
    .muted_link = unusedOn(Background::Dark),
    .tree_band = QColor(0x44, 0x4D, 0x59),
    .axis = {QColor(0xF4, 0x89, 0x4A), QColor(0x7B, 0xE0, 0xC8), QColor(0x6C, 0x9C, 0xFF)},
};

/// Every 17th of the 256 colours of viridis (van der Walt, Smith, Firing; CC0); between them it is nearly linear.
constexpr std::array<std::array<double, 3>, 16> kViridis = {{
    {0.267004, 0.004874, 0.329415},
    {0.282656, 0.100196, 0.422160},
    {0.277134, 0.185228, 0.489898},
    {0.253935, 0.265254, 0.529983},
    {0.221989, 0.339161, 0.548752},
    {0.190631, 0.407061, 0.556089},
    {0.163625, 0.471133, 0.558148},
    {0.139147, 0.533812, 0.555298},
    {0.120565, 0.596422, 0.543611},
    {0.134692, 0.658636, 0.517649},
    {0.208030, 0.718701, 0.472873},
    {0.327796, 0.773980, 0.406640},
    {0.477504, 0.821444, 0.318195},
    {0.647257, 0.858400, 0.209861},
    {0.824940, 0.884720, 0.106217},
    {0.993248, 0.906157, 0.143936},
}};

/// Half way between two colours, for what is there but can't be used.
QColor faded(const QColor& color, const QColor& ground) {
  return {(color.red() + ground.red()) / 2, (color.green() + ground.green()) / 2, (color.blue() + ground.blue()) / 2};
}

}  // namespace

Theme themeOf(const QPalette& palette) {
  return palette.color(QPalette::Base).lightness() < 128 ? Theme::Dark : Theme::Light;
}

const Colors& Colors::of(Theme theme) { return theme == Theme::Dark ? kDark : kLight; }

LinkStroke linkStroke(EdgeQuality quality, Theme theme) {
  const QColor color = qualityOn(theme == Theme::Dark ? Background::Dark : Background::Light, quality);
  switch (quality) {
    case EdgeQuality::Undefined:
      return {color, Qt::DotLine, false};
    case EdgeQuality::Partially:
      return {color, Qt::DashLine, false};
    case EdgeQuality::Fully:
      return {color, Qt::SolidLine, false};
    case EdgeQuality::Over:
      return {color, Qt::SolidLine, true};
  }
  return {};
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
  palette.setColor(QPalette::Window, colors.window);
  palette.setColor(QPalette::WindowText, colors.text);
  palette.setColor(QPalette::Base, colors.panel);
  palette.setColor(QPalette::AlternateBase, colors.panel_active);
  palette.setColor(QPalette::Text, colors.text);
  palette.setColor(QPalette::PlaceholderText, colors.text_muted);
  palette.setColor(QPalette::Button, colors.panel);
  palette.setColor(QPalette::ButtonText, colors.text);
  palette.setColor(QPalette::BrightText, colors.accent_text);
  palette.setColor(QPalette::ToolTipBase, colors.panel);
  palette.setColor(QPalette::ToolTipText, colors.text);
  palette.setColor(QPalette::Highlight, colors.accent);
  palette.setColor(QPalette::HighlightedText, colors.accent_text);
  palette.setColor(QPalette::Link, colors.accent);
  palette.setColor(QPalette::LinkVisited, colors.accent);
  palette.setColor(QPalette::Light, colors.panel);
  palette.setColor(QPalette::Midlight, colors.panel_active);
  palette.setColor(QPalette::Mid, colors.border);
  palette.setColor(QPalette::Dark, colors.border);
  palette.setColor(QPalette::Shadow, colors.border);
  const QColor disabled = faded(colors.text_muted, colors.panel);
  for (const QPalette::ColorRole role : {QPalette::WindowText, QPalette::Text, QPalette::ButtonText}) {
    palette.setColor(QPalette::Disabled, role, disabled);
  }
  palette.setColor(QPalette::Disabled, QPalette::Highlight, colors.border);
  palette.setColor(QPalette::Disabled, QPalette::HighlightedText, colors.text_muted);
  return palette;
}

QColor viridis(double t) {
  constexpr std::size_t kLast = kViridis.size() - 1;
  // Not std::clamp alone: a value that is not a number must still give a colour.
  const double position = std::isfinite(t) ? std::clamp(t, 0.0, 1.0) * static_cast<double>(kLast) : 0.0;
  const std::size_t below = std::min(static_cast<std::size_t>(position), kLast - 1);
  const double part = position - static_cast<double>(below);
  const auto mix = [&](std::size_t channel) {
    return (1 - part) * kViridis.at(below).at(channel) + part * kViridis.at(below + 1).at(channel);
  };
  return QColor::fromRgbF(mix(0), mix(1), mix(2));
}

QColor textOn(const QColor& ground) {
  const Rgb below = {ground.redF(), ground.greenF(), ground.blueF()};
  return contrast(below, {1, 1, 1}) > contrast(below, {0, 0, 0}) ? kDark.selection : kLight.selection;
}

Theme systemTheme() {
  if (const std::optional<Theme> wanted = desktopPortalTheme()) return *wanted;
  const QPalette palette = qApp != nullptr ? QApplication::palette() : QPalette();
  return palette.color(QPalette::Window).lightness() < palette.color(QPalette::WindowText).lightness() ? Theme::Dark
                                                                                                       : Theme::Light;
}

}  // namespace hexoderm
