#pragma once

#include "hexoderm/reconstruction/result/reconstruction.h"
#include "widgets/coloring/graph_coloring.h"
#include "widgets/graph/graph_picture.h"
#include "widgets/style/palette.h"

#include <QList>
#include <QPoint>
#include <QWidget>
#include <memory>
#include <optional>

class QAction;

namespace hexoderm {

class Selection;

/// The live graph: the skin as a flat honeycomb, hexagons with IDs, every link in both directions with the colour and
/// line style of its quality or by any other figure, muted links grey and crossed, cuts of closed surfaces drawn,
/// origin starred, shortest paths marked. A button over it chooses the colours, a legend below it says what they mean;
/// both give way where there is no room for them.
class GraphView : public QWidget {
  Q_OBJECT

 public:
  /// `selection` must outlive the view.
  explicit GraphView(Selection* selection, QWidget* parent = nullptr);
  ~GraphView() override;

  /// Null shows an empty view with a hint.
  void setReconstruction(std::shared_ptr<const Reconstruction> reconstruction);
  void setTheme(Theme theme);
  void setColoring(GraphColoring coloring);
  [[nodiscard]] GraphColoring coloring() const;

  /// Sets the first actions in the context menus of a link and of a cell. The clicked one is picked before the menu
  /// opens, so the actions apply to the picked one. They must outlive the view or be deleted as QObjects.
  void setLinkActions(const QList<QAction*>& actions);
  void setCellActions(const QList<QAction*>& actions);

  /// Position of a cell, or of the middle of a link, in the widget's coordinates; absent if it is not shown.
  [[nodiscard]] std::optional<QPoint> positionOf(CellId cell) const;
  [[nodiscard]] std::optional<QPoint> positionOf(LinkEnd source, LinkEnd target) const;

  /// The present picture, to be written on another thread.
  [[nodiscard]] GraphPicture picture() const;

  [[nodiscard]] QSize sizeHint() const override { return {340, 240}; }
  [[nodiscard]] QSize minimumSizeHint() const override { return {160, 110}; }

 public slots:
  void fit();
  /// Opens the field in which the ID of a cell is typed.
  void findCell();
  /// Puts what is seen on the clipboard.
  void copyPicture();

 signals:
  /// The operator wants picture() in a file.
  void pictureWanted();

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
  void contextMenuEvent(QContextMenuEvent* event) override;

 private:
  struct Parts;
  std::unique_ptr<Parts> parts_;
};

}  // namespace hexoderm
