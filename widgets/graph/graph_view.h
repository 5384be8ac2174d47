#pragma once

#include "hexoderm/solve/result/reconstruction.h"
#include "widgets/coloring/coloring.h"
#include "widgets/controls/heavy_turn.h"
#include "widgets/graph/graph_fit.h"
#include "widgets/graph/graph_picture.h"
#include "widgets/graph/graph_pointing.h"
#include "widgets/style/dressed_theme.h"
#include "widgets/style/palette.h"

#include <QList>
#include <QPixmap>
#include <QPoint>
#include <QWidget>
#include <memory>
#include <optional>

class QAction;

namespace hexoderm {

class FindCellField;
class GraphColoringButton;
class ScaleRanges;
class Selection;

/// The live graph: the skin as a flat honeycomb of hexagons with IDs. Every link is drawn in both directions with the
/// colour and line style of its quality, or coloured by another figure; excluded links are grey and crossed. Cuts of
/// closed surfaces, the origin and the shortest paths are marked. A button over the graph chooses the colours and a
/// legend below it explains them; both give way where there is no room for them.
class GraphView : public QWidget {
  Q_OBJECT

 public:
  /// `selection` must outlive the view.
  explicit GraphView(Selection* selection, QWidget* parent = nullptr);
  ~GraphView() override;

  /// Null shows an empty view with a hint.
  void setReconstruction(std::shared_ptr<const Reconstruction> reconstruction);
  /// What is going on while there is no skin, in words, which stand in the hint's place; empty: nothing is.
  void setAwaited(const QString& awaited);
  void setColoring(Coloring coloring);
  [[nodiscard]] Coloring coloring() const;
  /// Ranges of scales that the operator has fixed; they must outlive the view. Without them all scales are fitted.
  void setScaleRanges(const ScaleRanges* ranges);

  /// Actions that the context menus of a link and of a cell offer first. The link or cell that was clicked is picked
  /// before the menu opens, so the actions are about the picked one. They must outlive the view or be deleted as
  /// QObjects.
  void setLinkActions(const QList<QAction*>& actions);
  void setCellActions(const QList<QAction*>& actions);

  /// Position of a cell, or of the middle of a link, in the widget's coordinates; absent if it is not shown.
  [[nodiscard]] std::optional<QPoint> positionOf(CellId cell) const;
  [[nodiscard]] std::optional<QPoint> positionOf(LinkEnd source, LinkEnd target) const;

  /// Draws what has changed at once, which takes a while for a large skin and else waits for its turn: for pictures of
  /// the window.
  void drawNow();
  /// The graph as it is seen now; another thread may write it.
  [[nodiscard]] GraphPicture picture() const;

  [[nodiscard]] QSize sizeHint() const override { return {340, 240}; }
  [[nodiscard]] QSize minimumSizeHint() const override { return {160, 110}; }

 public slots:
  void fit();
  /// Shows the figures of what is picked beside it, as a tool tip.
  void showMetrics();
  /// Opens the field in which the ID of a cell is typed.
  void findCell();
  /// Puts the graph as it is seen on the clipboard.
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
  /// Colours anew, after something that the colours depend on has changed.
  void recolor();
  /// Shares the area out anew between skin, button and legend.
  void arrange();
  void moveCamera(const GraphCamera& camera);
  void zoom(double factor, const QPointF& about);
  void bringIntoView(const GraphHit& hit);
  void onSelectionChanged();
  void showPicked();
  void describe();
  void hover(const GraphHit& hit);
  void showMenu(const GraphHit& hit, const QPoint& global_position);
  void repaintSheet();
  const QPixmap& currentSheet();
  void drawHint(QPainter& painter) const;
  void drawHighlights(QPainter& painter) const;
  /// The pixels that the outline of a cell or a link covers.
  [[nodiscard]] QRect regionOf(const GraphHit& hit) const;
  [[nodiscard]] GraphHit picked() const;
  [[nodiscard]] GraphStyle style() const;
  [[nodiscard]] GraphMarks marks() const;

  Selection* selection_;
  DressedTheme dressed_{*this};
  std::shared_ptr<const GraphScene> scene_ = std::make_shared<GraphScene>();
  std::shared_ptr<const GraphPaint> paint_ = std::make_shared<GraphPaint>();
  const ScaleRanges* ranges_ = nullptr;
  QString awaited_;
  FindCellField* finder_;
  GraphColoringButton* button_;
  QList<QAction*> link_actions_;
  QList<QAction*> cell_actions_;

  GraphFit fit_;
  GraphCamera camera_;
  bool follows_size_ = true;  ///< shows everything, until somebody zooms or pans
  /// The drawn graph without the picked cell or link, so that picking and pointing cost nothing. A drawing that takes
  /// long has a turn of the event loop to itself, apart from the one in which the whole window may be painted; until
  /// then the earlier picture is shown.
  QPixmap sheet_;
  bool is_sheet_current_ = false;
  HeavyTurn draw_soon_;

  GraphHit hovered_;
  std::optional<QPoint> pressed_at_;
  QPoint last_mouse_;
  bool is_panning_ = false;
  bool shows_focus_ = false;  ///< the keyboard focus came by keyboard
};

}  // namespace hexoderm
