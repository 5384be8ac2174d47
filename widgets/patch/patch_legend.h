#pragma once

#include "widgets/coloring/coloring.h"
#include "widgets/coloring/legend_rows.h"
#include "widgets/coloring/scale_strip.h"
#include "widgets/style/palette.h"
#include "widgets/style/scene_colors.h"

#include <QFont>
#include <QRectF>
#include <QSize>
#include <QString>
#include <optional>
#include <vector>

class QPainter;

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

/// The legend on a plate at the lower edge of a view, in as many rows as its width requires: line samples of the
/// classes, swatches of categories, or a scale with its name, unit, ticks and counts; and the signs. Painted alike in
/// the view and in its pictures.
class PatchLegend {
 public:
  /// `button`: the size of the button that stands beside the title of a scale; empty: the state of the scale is written
  /// there.
  PatchLegend(const LegendContent& content, Theme theme, const QFont& font, const QSize& area, const QSize& button);

  /// Of the plate, in the area; empty without anything to explain.
  [[nodiscard]] const QRectF& place() const { return place_; }
  [[nodiscard]] const QRectF& buttonPlace() const { return button_place_; }
  /// Null for classes.
  [[nodiscard]] const ScaleStrip* strip() const { return strip_ ? &*strip_ : nullptr; }

  /// `marked`: a value that is pointed at on the scale, and in words. `probed`: see ScaleStrip.
  void paint(QPainter& painter, std::optional<double> marked, const QString& marked_word,
             std::optional<int> probed) const;

 private:
  void addSwatch(const QString& word, const Rgb& color);
  void addClasses();
  void addSigns();
  [[nodiscard]] LegendRows arranged(std::vector<LegendRows::Entry> entries, int room) const;
  void layOut(const QSize& button);

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

/// "fitted", "fixed" or "usual": how the ends of the scale came about.
QString scaleStateWord(const ScaleLegend& scale);

/// The legend in a few sentences, for screen readers.
QString legendText(const LegendContent& content);

}  // namespace hexoderm
