#pragma once

#include "widgets/coloring/cell_colors.h"
#include "widgets/coloring/coloring.h"
#include "widgets/coloring/legend_rows.h"
#include "widgets/coloring/scale_strip.h"
#include "widgets/scene/scene_corners.h"
#include "widgets/style/color_maps.h"
#include "widgets/style/palette.h"
#include "widgets/style/scene_colors.h"

#include <QCoreApplication>
#include <QFont>
#include <QFontMetrics>
#include <QLineF>
#include <QPainter>
#include <QPen>
#include <QRectF>
#include <QSize>
#include <QString>
#include <QStringList>
#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <utility>
#include <vector>

namespace hexoderm {

/// The meaning of the cells' colours and of the signs on them, for the legend.
struct LegendContent {
  Coloring coloring = Coloring::LinkQuality;
  std::optional<ScaleLegend> scale;  ///< of a quantity
  bool some_unknown = false;         ///< some cells have no value or class
  std::size_t patches = 0;
  std::vector<QString> body_parts;
  // Signs that some cells or links have.
  bool some_by_links = false;
  bool some_faulty = false;
  bool some_doubtful = false;
  bool some_links = false;
};

struct PatchLegendWords {
  Q_DECLARE_TR_FUNCTIONS(hexoderm::PatchLegend)
};

/// "fitted", "fixed" or "usual": how the ends of the scale came about.
inline QString scaleStateWord(const ScaleLegend& scale) {
  if (scale.is_fixed) return PatchLegendWords::tr("fixed range");
  return coloringRow(scale.coloring).is_fitted ? PatchLegendWords::tr("fitted range")
                                               : PatchLegendWords::tr("usual range");
}

/// The legend in a few sentences, for screen readers.
inline QString legendText(const LegendContent& content) {
  QStringList words;
  if (content.scale) {
    words << PatchLegendWords::tr("Cells are coloured by: %1; %2")
                 .arg(patchTitle(content.coloring), scaleText(*content.scale));
  } else {
    words << PatchLegendWords::tr("Cells are coloured by: %1").arg(coloringName(content.coloring));
  }
  if (content.some_faulty) words << PatchLegendWords::tr("crossed cells: an error was found in their readings");
  if (content.some_doubtful) words << PatchLegendWords::tr("cells with a triangle: a warning about their readings");
  if (content.some_by_links) words << PatchLegendWords::tr("hatched cells: placed through their links alone");
  if (content.some_links) words << PatchLegendWords::tr("crossed ports: a link with a finding");
  return words.join(QStringLiteral(". "));
}

/// The legend on a plate at the lower edge of a view, in as many rows as its width requires: line samples of the
/// classes, swatches of categories, or a scale with its name, unit, ticks and counts; and the signs. Painted alike in
/// the view and in its pictures.
class PatchLegend {
 public:
  /// `button`: the size of the button that stands beside the title of a scale; empty: the state of the scale is written
  /// there.
  PatchLegend(const LegendContent& content, Theme theme, const QFont& font, const QSize& area, const QSize& button)
      : content_(content),
        theme_(theme),
        colors_(sceneColors(theme)),
        font_(font),
        area_(area),
        row_height_(QFontMetrics(font).height() + 2),
        has_button_(!button.isEmpty()) {
    if (content_.scale) {
      strip_.emplace(*content_.scale, mapOf(content_.coloring, colors_), theme_, font_, ScaleStrip::Histogram::Shown);
      title_ = patchTitle(content_.coloring);
      const QString beyond = limitBeyondText(*content_.scale);
      if (!beyond.isEmpty()) title_ += QStringLiteral(" · ") + beyond;
      state_ = scaleStateWord(*content_.scale);
      if (content_.some_unknown) addSwatch(notKnownWord(), colors_.no_data);
    } else {
      addClasses();
    }
    addSigns();
    layOut(button);
  }

  /// Of the plate, in the area; empty without anything to explain.
  [[nodiscard]] const QRectF& place() const { return place_; }
  [[nodiscard]] const QRectF& buttonPlace() const { return button_place_; }
  /// Null for classes.
  [[nodiscard]] const ScaleStrip* strip() const { return strip_ ? &*strip_ : nullptr; }

  /// `marked`: a value that is pointed at on the scale, and in words. `probed`: see ScaleStrip.
  void paint(QPainter& painter, std::optional<double> marked, const QString& marked_word,
             std::optional<int> probed) const {
    if (place_.isEmpty()) return;
    const Colors& colors = Colors::of(theme_);
    painter.save();
    painter.setFont(font_);
    painter.setRenderHint(QPainter::Antialiasing);
    QColor plate = colors.panel;
    plate.setAlphaF(kPlateOpacity);
    painter.setPen(QPen(colors.border, 1));
    painter.setBrush(plate);
    painter.drawRoundedRect(place_.adjusted(0.5, 0.5, -0.5, -0.5), 5, 5);
    if (strip_) {
      const QFontMetrics metrics(font_);
      QString title = title_;
      if (probed) {
        title = binText(strip_->legend(), *probed);
      } else if (marked && !marked_word.isEmpty()) {
        title = patchTitle(content_.coloring) + QStringLiteral(" · ") + marked_word;
      }
      painter.setPen(colors.text);
      const int room = static_cast<int>(title_place_.width());
      const bool is_wrapped = title == title_ && metrics.horizontalAdvance(title) > room;
      int how = Qt::AlignLeft | Qt::AlignVCenter;
      if (is_wrapped) how |= Qt::TextWordWrap;
      painter.drawText(title_place_, how, is_wrapped ? title : metrics.elidedText(title, Qt::ElideRight, room));
      if (!has_button_) {
        painter.setPen(colors.text_muted);
        painter.drawText(button_place_, Qt::AlignCenter, state_);
      }
      strip_->paint(painter, marked, probed);
    }
    const double middle = place_.center().x();
    class_rows_.paint(painter, {middle, signs_top_}, row_height_, kSample + kBeforeWord, colors.text);
    sign_rows_.paint(painter, {middle, signs_top_ + class_rows_.count() * row_height_}, row_height_,
                     kSample + kBeforeWord, colors.text);
    painter.restore();
  }

 private:
  static constexpr int kSample = 26;          // length of a line or swatch
  static constexpr int kBeforeWord = 7;       // between it and its word
  static constexpr int kBetweenEntries = 22;  // between two entries
  static constexpr int kMargin = 8;           // below the plate and at the sides
  static constexpr int kPlatePadding = 8;     // within the plate
  static constexpr int kMinBar = 176;
  static constexpr int kUsualBar = 380;
  static constexpr double kPlateOpacity = 0.84;  // how little is seen through it
  static constexpr std::size_t kMaxCategories = 12;
  static constexpr std::array kClasses = {EdgeQuality::Undefined, EdgeQuality::Partially, EdgeQuality::Fully,
                                          EdgeQuality::Over};

  /// A sign on a cell, or in a disc at a port, as makeSigns() draws them.
  static void drawSignSample(QPainter& painter, const QColor& ground, const QColor& mark, double x, double y,
                             const QVector<QLineF>& lines, double width, bool is_disc) {
    const QRectF box(x + 0.5 * (kSample - 16), y - 8, 16, 16);
    painter.save();
    painter.setPen(Qt::NoPen);
    painter.setBrush(ground);
    if (is_disc) {
      painter.drawEllipse(box.adjusted(1, 1, -1, -1));
    } else {
      painter.drawRect(box);
    }
    painter.setPen(QPen(mark, width, Qt::SolidLine, Qt::FlatCap));
    for (const QLineF& line : lines) painter.drawLine(line.translated(box.center()));
    painter.restore();
  }

  void addSwatch(const QString& word, const Rgb& color) {
    classes_.push_back({word, [color = toQColor(color)](QPainter& painter, double x, double y) {
                          painter.fillRect(QRectF(x, y - 5, kSample, 10), color);
                        }});
  }

  void addClasses() {
    if (isQuantity(content_.coloring)) {
      addSwatch(QStringLiteral("%1: %2").arg(patchTitle(content_.coloring), notKnownWord()), colors_.no_data);
      return;
    }
    if (content_.coloring == Coloring::LinkQuality) {
      for (const EdgeQuality quality : kClasses) {
        classes_.push_back(
            {qualityWord(quality), [stroke = linkStroke(quality, theme_)](QPainter& painter, double x, double y) {
               drawStroke(painter, stroke, QLineF(x, y, x + kSample, y), 3);
             }});
      }
      if (content_.some_unknown) addSwatch(PatchLegendWords::tr("no link"), colors_.no_data);
      return;
    }
    const bool by_part = content_.coloring == Coloring::BodyPart;
    const std::size_t count = by_part ? content_.body_parts.size() : content_.patches;
    for (std::size_t k = 0; k < std::min(count, kMaxCategories); ++k) {
      addSwatch(by_part ? content_.body_parts[k] : patchWord(k), categoryColor(colors_, k, count));
    }
    if (count > kMaxCategories) {
      classes_.push_back(
          {PatchLegendWords::tr("and %1 more").arg(count - kMaxCategories), [](QPainter&, double, double) {}});
    }
    if (by_part && content_.some_unknown) addSwatch(notKnownWord(), colors_.no_data);
  }

  void addSigns() {
    const QColor face = Colors::of(theme_).border;
    const QColor mark = Colors::of(theme_).text;
    const auto add = [&](const QString& word, const QVector<QLineF>& lines, double width, bool is_disc = false) {
      signs_.push_back({word, [=](QPainter& painter, double x, double y) {
                          drawSignSample(painter, is_disc ? mark : face, is_disc ? face : mark, x, y, lines, width,
                                         is_disc);
                        }});
    };
    if (content_.some_faulty) {
      add(PatchLegendWords::tr("error found"), {QLineF(-7, -7, 7, 7), QLineF(-7, 7, 7, -7)}, 3);
    }
    if (content_.some_doubtful) {
      add(PatchLegendWords::tr("warning"), {QLineF(0, -6, -6, 5), QLineF(-6, 5, 6, 5), QLineF(6, 5, 0, -6)}, 2);
    }
    if (content_.some_by_links) {
      add(PatchLegendWords::tr("placed through its links"),
          {QLineF(-8, -5, 8, -5), QLineF(-8, 0, 8, 0), QLineF(-8, 5, 8, 5)}, 1.4);
    }
    if (content_.some_links) {
      add(PatchLegendWords::tr("link with a finding"), {QLineF(-3.5, -3.5, 3.5, 3.5), QLineF(-3.5, 3.5, 3.5, -3.5)}, 2,
          true);
    }
  }

  [[nodiscard]] LegendRows arranged(std::vector<LegendRows::Entry> entries, int room) const {
    const QFontMetrics metrics(font_);
    for (LegendRows::Entry& entry : entries) {
      entry.width = std::min(kSample + kBeforeWord + metrics.horizontalAdvance(entry.word), room);
    }
    return {std::move(entries), 1.0 * room, 1.0 * kBetweenEntries};
  }

  void layOut(const QSize& button) {
    const QFontMetrics metrics(font_);
    const QSizeF state = button.isEmpty() ? QSizeF(metrics.horizontalAdvance(state_) + 2, row_height_) : QSizeF(button);
    // One row lies below the pictures in the corners; more than that finds room between them.
    const int full = area_.width() - 2 * (kMargin + kPlatePadding);
    const int between = area_.width() - 2 * (SceneCorners::kLeft + SceneCorners::kSize + kPlatePadding);
    // Or above them, in a narrow view that is high enough.
    constexpr int kHigh = 450;
    const int least = strip_ ? std::max(kMinBar, static_cast<int>(std::ceil(state.width()))) : kMinBar;
    const bool has_room_above = between < least && area_.height() > kHigh;
    const int narrow = has_room_above ? full : std::min(full, std::max(between, least));
    class_rows_ = arranged(classes_, strip_ || !signs_.empty() ? narrow : full);
    if (class_rows_.count() > 1) class_rows_ = arranged(classes_, narrow);
    sign_rows_ = arranged(signs_, narrow);
    const bool is_one_row = class_rows_.count() == 1 && !strip_ && signs_.empty();
    const int room = is_one_row ? full : narrow;
    double width = std::max(class_rows_.width(), sign_rows_.width());
    double height = (class_rows_.count() + sign_rows_.count()) * row_height_;
    const double wanted = metrics.horizontalAdvance(title_) + 2 * kBeforeWord + state.width() + 2;
    // In a small view the title has lines of its own, or its unit would be cut off.
    const bool is_stacked = wanted > room;
    const double lines =
        is_stacked ? metrics.boundingRect(QRect(0, 0, room, area_.height()), Qt::TextWordWrap, title_).height() : 0;
    const double head = std::max<double>(row_height_, state.height()) + lines;
    if (strip_) {
      width = std::max({width, wanted, static_cast<double>(kUsualBar)});
      height += head + strip_->height() + 2;
    }
    if (height == 0) return;
    width = std::min(width, static_cast<double>(room)) + 2 * kPlatePadding;
    height += kPlatePadding;
    // The word above the arrow of gravity, too.
    const int below = has_room_above && !is_one_row ? SceneCorners::kBottom + SceneCorners::kSize + 2 * row_height_ : 0;
    place_ = QRectF(0.5 * (area_.width() - width), area_.height() - below - kMargin - height, width, height);
    double top = place_.top() + 0.5 * kPlatePadding;
    const double left = place_.left() + kPlatePadding;
    const double inner = width - 2 * kPlatePadding;
    if (strip_) {
      const double title_height = is_stacked ? lines : head;
      const double button_top = top + lines;
      const double button_room = head - lines;
      button_place_ = QRectF(left + inner - state.width(), button_top + 0.5 * (button_room - state.height()),
                             state.width(), state.height());
      title_place_ = QRectF(left, top, is_stacked ? inner : inner - state.width() - 2 * kBeforeWord, title_height);
      top += head;
      strip_->setPlace(QPointF(left, top), inner);
      top += strip_->height() + 2;
    }
    signs_top_ = top;
  }

  LegendContent content_;
  Theme theme_;
  SceneColors colors_;
  QFont font_;
  QSize area_;
  int row_height_;
  std::vector<LegendRows::Entry> classes_;
  std::vector<LegendRows::Entry> signs_;
  LegendRows class_rows_;
  LegendRows sign_rows_;
  std::optional<ScaleStrip> strip_;
  QString title_;
  QString state_;
  QRectF place_;
  QRectF title_place_;
  QRectF button_place_;
  bool has_button_ = false;
  double signs_top_ = 0;
};

}  // namespace hexoderm
