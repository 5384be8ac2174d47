#pragma once

#include "hexoderm/reconstruction/reconstruction.h"
#include "widgets/palette.h"

#include <QPoint>
#include <QWidget>
#include <memory>
#include <optional>

namespace hexoderm {

class Selection;

/// The live graph: the skin as a flat honeycomb, hexagons with IDs, every link in both directions with the colour and
/// line style of its quality, muted links grey and crossed, cuts of closed surfaces drawn, origin starred.
class GraphView : public QWidget {
  Q_OBJECT

 public:
  /// `selection` must outlive the view.
  explicit GraphView(Selection* selection, QWidget* parent = nullptr);
  ~GraphView() override;

  /// Null shows an empty view with a hint.
  void setReconstruction(std::shared_ptr<const Reconstruction> reconstruction);
  void setTheme(Theme theme);

  /// Where a cell, or the middle of a link, is drawn, in the widget's coordinates; absent if it is not shown.
  [[nodiscard]] std::optional<QPoint> positionOf(CellId cell) const;
  [[nodiscard]] std::optional<QPoint> positionOf(LinkEnd source, LinkEnd target) const;

  [[nodiscard]] QSize sizeHint() const override { return {340, 240}; }
  [[nodiscard]] QSize minimumSizeHint() const override { return {160, 110}; }

 public slots:
  void fit();
  /// Opens the field in which the ID of a cell is typed.
  void findCell();

 protected:
  bool event(QEvent* event) override;
  void paintEvent(QPaintEvent* event) override;
  void resizeEvent(QResizeEvent* event) override;
  void wheelEvent(QWheelEvent* event) override;
  void mousePressEvent(QMouseEvent* event) override;
  void mouseMoveEvent(QMouseEvent* event) override;
  void mouseReleaseEvent(QMouseEvent* event) override;
  void mouseDoubleClickEvent(QMouseEvent* event) override;
  void leaveEvent(QEvent* event) override;
  void keyPressEvent(QKeyEvent* event) override;
  void focusInEvent(QFocusEvent* event) override;
  void focusOutEvent(QFocusEvent* event) override;

 private:
  struct Parts;
  std::unique_ptr<Parts> parts_;
};

}  // namespace hexoderm
