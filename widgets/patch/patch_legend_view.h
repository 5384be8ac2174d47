#pragma once

#include "widgets/patch/patch_legend.h"

#include <QWidget>
#include <optional>

class QToolButton;

namespace hexoderm {

class RangePopup;

/// The legend at the lower edge of its parent, a view. On a scale that is pointed at, by the mouse or by the arrow
/// keys, it says which values lie there and how many cells have them. A click on the bar, or Enter, fixes the range as
/// it is, or lets it be fitted again; a button beside it opens a popup in which a range is chosen or typed. A legend of
/// classes lets the mouse through.
class PatchLegendView : public QWidget {
  Q_OBJECT

 public:
  explicit PatchLegendView(QWidget* parent);

  /// None hides it.
  void setContent(const std::optional<LegendContent>& content);
  /// Points at a value on the scale, and says whose it is ("cell 5: 0.42 mm"); none points at nothing.
  void setMarkedValue(std::optional<double> value, const QString& word = {});
  [[nodiscard]] std::optional<double> markedValue() const { return marked_; }

  /// Paints the legend into a picture of the parent of this size.
  void paintPicture(QPainter& painter, const QSize& area) const;

 signals:
  void rangeFixed(hexoderm::ColorRange range);
  void rangeReleased();
  /// It covers this much of its parent's bottom, in pixels; 0 while it is hidden.
  void heightChanged(int pixels);

 protected:
  bool event(QEvent* event) override;
  bool eventFilter(QObject* watched, QEvent* event) override;
  void paintEvent(QPaintEvent* event) override;
  void mouseMoveEvent(QMouseEvent* event) override;
  void mousePressEvent(QMouseEvent* event) override;
  void leaveEvent(QEvent* event) override;
  void keyPressEvent(QKeyEvent* event) override;
  void focusInEvent(QFocusEvent* event) override;
  void focusOutEvent(QFocusEvent* event) override;

 private:
  void arrange();
  void probe(std::optional<int> bin);
  void toggleFixed();
  void openPopup();
  void describe();

  std::optional<LegendContent> content_;
  std::optional<PatchLegend> legend_;
  QToolButton* button_;
  RangePopup* popup_;
  std::optional<double> marked_;
  QString marked_word_;
  std::optional<int> probed_;
};

}  // namespace hexoderm
