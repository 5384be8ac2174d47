#include "widgets/scene_overlay.h"

#include "widgets/scene_corners.h"

#include <QLinearGradient>
#include <QPainter>
#include <QPen>
#include <algorithm>
#include <array>
#include <numeric>
#include <utility>
#include <vector>

namespace hexoderm {
namespace {

constexpr int kSample = 26;   // length of a line or swatch in the legend
constexpr int kSpace = 7;     // between it and its word
constexpr int kBetween = 22;  // between two entries
constexpr int kBottomMargin = 8;
constexpr std::size_t kMaxPatchEntries = 6;

QColor toQColor(const Rgb& color) { return QColor::fromRgbF(color[0], color[1], color[2]); }

/// The line of a quality class exactly as the graph draws it.
void drawSample(QPainter& painter, const LinkStroke& stroke, double x, double y) {
  QPen pen(stroke.color, stroke.doubled ? 2.0 : 3.0, stroke.style, Qt::FlatCap);
  painter.setPen(pen);
  const double apart = stroke.doubled ? 2.0 : 0.0;
  painter.drawLine(QPointF(x, y - apart), QPointF(x + kSample, y - apart));
  if (stroke.doubled) painter.drawLine(QPointF(x, y + apart), QPointF(x + kSample, y + apart));
}

int entryWidth(const QFontMetrics& metrics, const QString& word) {
  return kSample + kSpace + metrics.horizontalAdvance(word);
}

}  // namespace

SceneOverlay::SceneOverlay(QWidget* parent) : QWidget(parent) {
  setAttribute(Qt::WA_TransparentForMouseEvents);
  setAttribute(Qt::WA_NoSystemBackground);
  setFocusPolicy(Qt::NoFocus);
}

void SceneOverlay::setContent(const Content& content) {
  content_ = content;
  setAccessibleName(content.hint);
  update();
}

void SceneOverlay::setTheme(Theme theme, const SceneColors& colors) {
  theme_ = theme;
  colors_ = colors;
  update();
}

void SceneOverlay::paintEvent(QPaintEvent*) {
  QPainter painter(this);
  paint(painter, size());
}

void SceneOverlay::paint(QPainter& painter, const QSize& area) const {
  const Colors& colors = Colors::of(theme_);
  painter.setRenderHint(QPainter::Antialiasing);
  painter.setFont(font());
  if (!content_.hint.isEmpty()) {
    painter.setPen(colors.text_muted);
    painter.drawText(QRect(QPoint(0, 0), area).adjusted(24, 24, -24, -24), Qt::AlignCenter | Qt::TextWordWrap,
                     content_.hint);
    return;
  }
  if (content_.gravity) {
    painter.setPen(colors.text_muted);
    const QString word = tr("gravity");
    const int right = area.width() - 12;
    const int middle = area.height() - SceneCorners::kBottom - SceneCorners::kSize / 2;
    painter.drawText(QRect(right - 120, middle - 12, 120, 24), Qt::AlignRight | Qt::AlignVCenter, word);
  }
  switch (content_.coloring) {
    case CellColoring::LinkQuality:
      return paintQualityLegend(painter, area);
    case CellColoring::Deviation:
      return paintDeviationLegend(painter, area);
    case CellColoring::Patch:
      return paintPatchLegend(painter, area);
  }
}

void SceneOverlay::paintQualityLegend(QPainter& painter, const QSize& area) const {
  const QFontMetrics metrics = painter.fontMetrics();
  constexpr std::array kClasses = {EdgeQuality::Undefined, EdgeQuality::Partially, EdgeQuality::Fully,
                                   EdgeQuality::Over};
  std::array<int, 4> widths{};
  for (std::size_t k = 0; k < 4; ++k) widths.at(k) = entryWidth(metrics, qualityWord(kClasses.at(k)));
  const int total = std::accumulate(widths.begin(), widths.end(), 3 * kBetween);
  const bool one_row = total + 24 <= area.width();
  // In two rows the columns have one width.
  const int column = *std::ranges::max_element(widths) + kBetween;
  const int row_height = metrics.height() + 2;
  const double left = 0.5 * (area.width() - (one_row ? total : 2 * column - kBetween));
  double x = left;
  for (std::size_t k = 0; k < 4; ++k) {
    if (!one_row) x = left + static_cast<double>(k % 2) * column;
    const double rows_below = one_row || k >= 2 ? 0.5 : 1.5;
    const double middle = area.height() - kBottomMargin - rows_below * row_height;
    drawSample(painter, linkStroke(kClasses.at(k), theme_), x, middle);
    painter.setPen(Colors::of(theme_).text);
    painter.drawText(QRectF(x + kSample + kSpace, middle - 0.5 * row_height, widths.at(k), row_height),
                     Qt::AlignLeft | Qt::AlignVCenter, qualityWord(kClasses.at(k)));
    x += widths.at(k) + kBetween;
  }
}

void SceneOverlay::paintDeviationLegend(QPainter& painter, const QSize& area) const {
  constexpr int kBar = 150;
  constexpr int kSteps = 16;
  const QFontMetrics metrics = painter.fontMetrics();
  const QString title = tr("worst link's predicted deviation");
  const QString low = tr("0°");
  const QString high = tr("%1° or more").arg(kDeviationScaleEnd_deg);
  const int height = metrics.height() + 2;
  const int total = metrics.horizontalAdvance(title) + metrics.horizontalAdvance(low) +
                    metrics.horizontalAdvance(high) + kBar + 4 * kSpace;
  double x = std::max(8, (area.width() - total) / 2);
  const double top = area.height() - kBottomMargin - height;
  const auto write = [&](const QString& text, const QColor& color) {
    painter.setPen(color);
    const double width = metrics.horizontalAdvance(text) + 2;
    painter.drawText(QRectF(x, top, width, height), Qt::AlignLeft | Qt::AlignVCenter, text);
    x += width;
  };
  write(title, Colors::of(theme_).text);
  x += 2 * kSpace;
  write(low, Colors::of(theme_).text_muted);
  x += kSpace;
  QLinearGradient gradient(x, 0, x + kBar, 0);
  for (int k = 0; k <= kSteps; ++k) {
    const double t = static_cast<double>(k) / kSteps;
    gradient.setColorAt(t, toQColor(onScale(colors_.scale, t)));
  }
  painter.fillRect(QRectF(x, top + 0.5 * height - 5, kBar, 10), gradient);
  x += kBar + kSpace;
  write(high, Colors::of(theme_).text_muted);
}

void SceneOverlay::paintPatchLegend(QPainter& painter, const QSize& area) const {
  const QFontMetrics metrics = painter.fontMetrics();
  std::vector<std::pair<QString, QColor>> entries;
  for (std::size_t k = 0; k < std::min(content_.patches, kMaxPatchEntries); ++k) {
    entries.emplace_back(tr("patch %1").arg(k), toQColor(patchColor(colors_, k, content_.patches)));
  }
  if (content_.patches > kMaxPatchEntries) entries.emplace_back(tr("and so on"), QColor(Qt::transparent));
  int total = -kBetween;
  for (const auto& entry : entries) total += entryWidth(metrics, entry.first) + kBetween;
  const int height = metrics.height() + 2;
  const double top = area.height() - kBottomMargin - height;
  double x = (area.width() - total) / 2.0;
  for (const auto& [word, color] : entries) {
    painter.fillRect(QRectF(x, top + 0.5 * height - 5, kSample, 10), color);
    painter.setPen(Colors::of(theme_).text);
    painter.drawText(QRectF(x + kSample + kSpace, top, entryWidth(metrics, word), height),
                     Qt::AlignLeft | Qt::AlignVCenter, word);
    x += entryWidth(metrics, word) + kBetween;
  }
}

}  // namespace hexoderm
