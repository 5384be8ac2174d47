#include "widgets/patch/patch_legend.h"

#include "widgets/coloring/coloring_words.h"

#include <QCoreApplication>
#include <QLinearGradient>
#include <QPainter>
#include <QPen>
#include <QSize>
#include <QStringList>
#include <algorithm>
#include <array>
#include <functional>

namespace hexoderm {
namespace {

constexpr int kSample = 26;   // length of a line or swatch
constexpr int kSpace = 7;     // between it and its word
constexpr int kBetween = 22;  // between two entries
constexpr int kMargin = 8;    // below and at the sides
constexpr std::size_t kMaxCategories = 12;
constexpr std::array kClasses = {EdgeQuality::Undefined, EdgeQuality::Partially, EdgeQuality::Fully, EdgeQuality::Over};

struct PatchLegend {
  Q_DECLARE_TR_FUNCTIONS(hexoderm::PatchLegend)
};

QColor toQColor(const Rgb& color) { return QColor::fromRgbF(color[0], color[1], color[2]); }

/// A sample and its word.
struct Entry {
  QString word;
  std::function<void(QPainter&, double x, double y)> draw;
};

Entry classEntry(EdgeQuality quality, Theme theme) {
  return {qualityWord(quality), [stroke = linkStroke(quality, theme)](QPainter& painter, double x, double y) {
            drawStroke(painter, stroke, QLineF(x, y, x + kSample, y), 3);
          }};
}

Entry swatch(const QString& word, const QColor& color) {
  return {word,
          [color](QPainter& painter, double x, double y) { painter.fillRect(QRectF(x, y - 5, kSample, 10), color); }};
}

std::vector<Entry> categoryEntries(const LegendContent& content, Theme theme, const SceneColors& colors) {
  std::vector<Entry> entries;
  if (content.coloring == Coloring::LinkQuality) {
    for (const EdgeQuality quality : kClasses) entries.push_back(classEntry(quality, theme));
    if (content.some_unknown) entries.push_back(swatch(PatchLegend::tr("no link"), toQColor(colors.neutral)));
    return entries;
  }
  const bool by_part = content.coloring == Coloring::BodyPart;
  const std::size_t count = by_part ? content.body_parts.size() : content.patches;
  for (std::size_t k = 0; k < std::min(count, kMaxCategories); ++k) {
    entries.push_back(
        swatch(by_part ? content.body_parts[k] : patchWord(k), toQColor(categoryColor(colors, k, count))));
  }
  if (count > kMaxCategories) {
    entries.push_back({PatchLegend::tr("and %1 more").arg(count - kMaxCategories), [](QPainter&, double, double) {}});
  }
  if (by_part && content.some_unknown) entries.push_back(swatch(notKnownWord(), toQColor(colors.neutral)));
  return entries;
}

/// Rows of entries, each row in the middle; columns have one width where there are several rows.
int paintEntries(QPainter& painter, const QSize& area, const std::vector<Entry>& entries, Theme theme) {
  if (entries.empty()) return 0;
  const QFontMetrics metrics = painter.fontMetrics();
  const int room = area.width() - 2 * kMargin;
  std::vector<int> widths;
  int total = -kBetween;
  int widest = 0;
  for (const Entry& entry : entries) {
    widths.push_back(std::min(kSample + kSpace + metrics.horizontalAdvance(entry.word), room));
    total += widths.back() + kBetween;
    widest = std::max(widest, widths.back());
  }
  const int count = static_cast<int>(entries.size());
  int columns = count;
  if (total > room) {
    columns = std::clamp((room + kBetween) / (widest + kBetween), 1, count);
    const int rows = (count + columns - 1) / columns;
    columns = (count + rows - 1) / rows;
  }
  const bool one_row = columns == count;
  const int rows = (count + columns - 1) / columns;
  const int row_height = metrics.height() + 2;
  const double left = 0.5 * (area.width() - (one_row ? total : columns * (widest + kBetween) - kBetween));
  double x = left;
  for (int k = 0; k < count; ++k) {
    if (k % columns == 0) x = left;
    const double middle = area.height() - kMargin - (rows - k / columns - 0.5) * row_height;
    const auto index = static_cast<std::size_t>(k);
    entries[index].draw(painter, x, middle);
    painter.setPen(Colors::of(theme).text);
    const int text_width = widths[index] - kSample - kSpace;
    painter.drawText(QRectF(x + kSample + kSpace, middle - 0.5 * row_height, text_width + 2, row_height),
                     Qt::AlignLeft | Qt::AlignVCenter,
                     metrics.elidedText(entries[index].word, Qt::ElideRight, text_width + 2));
    x += (one_row ? widths[index] : widest) + kBetween;
  }
  return rows * row_height + kMargin;
}

int paintScale(QPainter& painter, const QSize& area, const LegendContent& content, Theme theme,
               const SceneColors& colors) {
  constexpr int kSteps = 32;
  const QFontMetrics metrics = painter.fontMetrics();
  const auto [title, low, high] = patchScaleInWords(content.coloring, content.range);
  const QString unknown = content.some_unknown ? notKnownWord() : QString();
  const int row_height = metrics.height() + 2;
  const int unknown_width = unknown.isEmpty() ? 0 : kBetween + kSample + kSpace + metrics.horizontalAdvance(unknown);
  const int ends = metrics.horizontalAdvance(low) + metrics.horizontalAdvance(high) + 2 * kSpace + unknown_width + 6;
  const int room = area.width() - 2 * kMargin;
  const int title_width = metrics.horizontalAdvance(title) + 2;
  const bool one_row = title_width + 2 * kSpace + ends + 120 <= room;
  const int bar = std::clamp(room - ends - (one_row ? title_width + 2 * kSpace : 0), 40, 150);
  const int scale_width = ends + bar;
  const double top = area.height() - kMargin - row_height;
  double x = 0.5 * (area.width() - scale_width - (one_row ? title_width + 2 * kSpace : 0));
  const auto write = [&](const QString& text, const QColor& color) {
    painter.setPen(color);
    const double width = metrics.horizontalAdvance(text) + 2;
    painter.drawText(QRectF(x, top, width, row_height), Qt::AlignLeft | Qt::AlignVCenter, text);
    x += width;
  };
  if (one_row) {
    write(title, Colors::of(theme).text);
    x += 2 * kSpace;
  } else {
    painter.setPen(Colors::of(theme).text);
    painter.drawText(QRectF(kMargin, top - row_height, room, row_height), Qt::AlignCenter,
                     metrics.elidedText(title, Qt::ElideRight, room));
  }
  write(low, Colors::of(theme).text_muted);
  x += kSpace;
  QLinearGradient gradient(x, 0, x + bar, 0);
  for (int k = 0; k <= kSteps; ++k) {
    const double t = static_cast<double>(k) / kSteps;
    gradient.setColorAt(t, toQColor(onScale(colors.scale, t)));
  }
  painter.fillRect(QRectF(x, top + 0.5 * row_height - 5, bar, 10), gradient);
  x += bar + kSpace;
  write(high, Colors::of(theme).text_muted);
  if (!unknown.isEmpty()) {
    x += kBetween;
    painter.fillRect(QRectF(x, top + 0.5 * row_height - 5, kSample, 10), toQColor(colors.neutral));
    x += kSample + kSpace;
    write(unknown, Colors::of(theme).text_muted);
  }
  return (one_row ? 1 : 2) * row_height + kMargin;
}

}  // namespace

int paintLegend(QPainter& painter, const QSize& area, const LegendContent& content, Theme theme,
                const SceneColors& colors) {
  if (isQuantity(content.coloring)) return paintScale(painter, area, content, theme, colors);
  return paintEntries(painter, area, categoryEntries(content, theme, colors), theme);
}

QString legendInWords(const LegendContent& content) {
  if (isQuantity(content.coloring)) {
    const ScaleWords words = patchScaleInWords(content.coloring, content.range);
    return PatchLegend::tr("Cells are coloured by: %1; from %2 (dark) to %3 (bright)")
        .arg(words.title, words.low, words.high);
  }
  return PatchLegend::tr("Cells are coloured by: %1").arg(coloringName(content.coloring));
}

}  // namespace hexoderm
