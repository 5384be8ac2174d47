#pragma once

#include "hexoderm/solve/result/reconstruction.h"
#include "widgets/coloring/coloring.h"
#include "widgets/coloring/scale_ranges.h"
#include "widgets/controls/arrow_keys.h"
#include "widgets/controls/find_cell_field.h"
#include "widgets/controls/heavy_turn.h"
#include "widgets/controls/panel_parts.h"
#include "widgets/controls/selection.h"
#include "widgets/graph/graph_coloring_button.h"
#include "widgets/graph/graph_fit.h"
#include "widgets/graph/graph_picture.h"
#include "widgets/graph/graph_pointing.h"
#include "widgets/style/dressed_theme.h"
#include "widgets/style/palette.h"

#include <QAction>
#include <QActionGroup>
#include <QApplication>
#include <QClipboard>
#include <QContextMenuEvent>
#include <QHelpEvent>
#include <QKeyEvent>
#include <QList>
#include <QMenu>
#include <QMouseEvent>
#include <QPainter>
#include <QPixmap>
#include <QPoint>
#include <QToolButton>
#include <QToolTip>
#include <QWheelEvent>
#include <QWidget>
#include <algorithm>
#include <cmath>
#include <map>
#include <memory>
#include <optional>
#include <utility>

class QAction;

namespace hexoderm {

/// The live graph: the skin as a flat honeycomb of hexagons with IDs. Every link is drawn in both directions with the
/// colour and line style of its quality, or coloured by another figure; excluded links are grey and crossed. Cuts of
/// closed surfaces, the origin and the shortest paths are marked. A button over the graph chooses the colours and a
/// legend below it explains them; both give way where there is no room for them.
class GraphView : public QWidget {
  Q_OBJECT

 public:
  /// `selection` must outlive the view.
  explicit GraphView(Selection* selection, QWidget* parent = nullptr) : QWidget(parent), selection_(selection) {
    setNames(this, QStringLiteral("graphView"), tr("Skin graph"));
    setFocusPolicy(Qt::StrongFocus);
    setMouseTracking(true);
    setAttribute(Qt::WA_OpaquePaintEvent);
    recolor();
    describe();
    connect(button_, &GraphColoringButton::changed, this, &GraphView::recolor);
    connect(selection, &Selection::changed, this, &GraphView::onSelectionChanged);
    connect(selection, &Selection::brushedChanged, this, qOverload<>(&QWidget::update));
    connect(selection, &Selection::sought, this, &GraphView::showPicked);
    connect(finder_, &FindCellField::found, this, [this](quint32 id) {
      if (const auto cell = scene_->indexOf(CellId(id))) {
        bringIntoView({cell, std::nullopt});
        selection_->seekCell(CellId(id));
      }
    });
    connect(finder_, &FindCellField::closed, this, [this] { setFocus(Qt::OtherFocusReason); });
  }

  /// Null shows an empty view with a hint.
  void setReconstruction(std::shared_ptr<const Reconstruction> reconstruction) {
    auto scene = std::make_shared<const GraphScene>(std::move(reconstruction));
    const bool stays = scene_->hasSamePlacesAs(*scene);
    hover({});
    scene_ = std::move(scene);
    if (!stays) follows_size_ = true;
    recolor();
    describe();
  }

  /// What is going on while there is no skin, in words, which stand in the hint's place; empty: nothing is.
  void setAwaited(const QString& awaited) {
    awaited_ = awaited;
    describe();
    if (scene_->cells().empty()) update();
  }

  void setColoring(Coloring coloring) { button_->setColoring(coloring); }
  [[nodiscard]] Coloring coloring() const { return button_->coloring(); }

  /// Ranges of scales that the operator has fixed; they must outlive the view. Without them all scales are fitted.
  void setScaleRanges(const ScaleRanges* ranges) {
    ranges_ = ranges;
    connect(ranges, &ScaleRanges::changed, this, [this](Coloring changed) {
      if (changed == coloring()) recolor();
    });
    recolor();
  }

  /// Actions that the context menus of a link and of a cell offer first. The link or cell that was clicked is picked
  /// before the menu opens, so the actions are about the picked one. They must outlive the view or be deleted as
  /// QObjects.
  void setLinkActions(const QList<QAction*>& actions) { link_actions_ = actions; }
  void setCellActions(const QList<QAction*>& actions) { cell_actions_ = actions; }

  /// Position of a cell, or of the middle of a link, in the widget's coordinates; absent if it is not shown.
  [[nodiscard]] std::optional<QPoint> positionOf(CellId cell) const {
    const auto middle = middleOf(*scene_, {scene_->indexOf(cell), std::nullopt});
    return middle ? std::optional(camera_.toScreen(*middle).toPoint()) : std::nullopt;
  }

  [[nodiscard]] std::optional<QPoint> positionOf(LinkEnd source, LinkEnd target) const {
    const auto middle = middleOf(*scene_, {std::nullopt, scene_->indexOf(source, target)});
    return middle ? std::optional(camera_.toScreen(*middle).toPoint()) : std::nullopt;
  }

  /// Draws what has changed at once, which takes a while for a large skin and else waits for its turn: for pictures of
  /// the window.
  void drawNow() { static_cast<void>(currentSheet()); }
  /// The graph as it is seen now; another thread may write it.
  [[nodiscard]] GraphPicture picture() const { return {scene_, paint_, camera_, style(), marks(), fit_.legend_area}; }

  [[nodiscard]] QSize sizeHint() const override { return {340, 240}; }
  [[nodiscard]] QSize minimumSizeHint() const override { return {160, 110}; }

 public slots:
  void fit() {
    camera_ = fit_.camera;
    follows_size_ = true;
    repaintSheet();
  }

  /// Shows the figures of what is picked beside it, as a tool tip.
  void showMetrics() {
    const std::optional<QPointF> middle = middleOf(*scene_, picked());
    if (!middle) return;
    bringIntoView(picked());
    QToolTip::showText(mapToGlobal(camera_.toScreen(*middle).toPoint()), toolTipOf(*scene_, picked()), this);
  }

  /// Opens the field in which the ID of a cell is typed.
  void findCell() {
    finder_->move(8, 8);
    finder_->raise();
    finder_->open(QString());
  }

  /// Puts the graph as it is seen on the clipboard.
  void copyPicture() { QApplication::clipboard()->setPixmap(currentSheet()); }

 signals:
  /// The operator wants picture() in a file.
  void pictureWanted();

 protected:
  bool event(QEvent* event) override {
    if (event->type() == QEvent::ToolTip) {
      const auto* help = static_cast<QHelpEvent*>(event);
      const QString text = toolTipOf(*scene_, hitAt(*scene_, camera_, help->pos()));
      if (text.isEmpty()) {
        QToolTip::hideText();
      } else {
        QToolTip::showText(help->globalPos(), text, this);
      }
      return true;
    }
    if (event->type() == QEvent::FontChange || dressed_.isChangedBy(*event)) recolor();
    return QWidget::event(event);
  }

  void paintEvent(QPaintEvent* event) override {
    const QPixmap& sheet = draw_soon_.isActive() ? sheet_ : currentSheet();
    QPainter painter(this);
    const double ratio = sheet.devicePixelRatioF();
    const QRect covered(QPoint(0, 0), (QSizeF(sheet.size()) / ratio).toSize());
    if (!covered.contains(event->rect())) painter.fillRect(event->rect(), Colors::of(palette()).panel);
    // Only the part that is asked for: where the mouse went, that is a few hexagons.
    const QRect changed = event->rect().intersected(covered);
    painter.drawPixmap(changed, sheet,
                       QRectF(QPointF(changed.topLeft()) * ratio, QSizeF(changed.size()) * ratio).toRect());
    painter.setRenderHint(QPainter::Antialiasing);
    if (scene_->cells().empty()) {
      drawHint(painter);
    } else {
      drawHighlights(painter);
    }
    if (shows_focus_) {
      painter.setBrush(Qt::NoBrush);
      painter.setPen(QPen(Colors::of(palette()).accent, 2));
      painter.drawRect(QRectF(rect()).adjusted(1, 1, -1, -1));
    }
  }

  void resizeEvent(QResizeEvent* event) override {
    camera_.size = size();
    arrange();
    QWidget::resizeEvent(event);
  }

  void wheelEvent(QWheelEvent* event) override {
    // One notch is 120: a quarter larger or smaller.
    zoom(std::pow(kKeyZoom, event->angleDelta().y() / 120.0), event->position());
    event->accept();
  }

  void mousePressEvent(QMouseEvent* event) override {
    if (event->button() != Qt::LeftButton && event->button() != Qt::MiddleButton) return;
    pressed_at_ = last_mouse_ = event->pos();
  }

  void mouseMoveEvent(QMouseEvent* event) override {
    const QPoint position = event->pos();
    if (!pressed_at_) {
      hover(hitAt(*scene_, camera_, position));
      return;
    }
    if (!is_panning_) {
      if ((position - *pressed_at_).manhattanLength() < QApplication::startDragDistance()) return;
      if (scene_->cells().empty()) return;
      is_panning_ = true;
      hover({});
      setCursor(Qt::ClosedHandCursor);
    }
    GraphCamera panned = camera_;
    panned.pan(position - last_mouse_);
    moveCamera(panned);
    last_mouse_ = position;
  }

  void mouseReleaseEvent(QMouseEvent* event) override {
    if (!pressed_at_) return;
    if (is_panning_) {
      unsetCursor();
    } else if (event->button() == Qt::LeftButton) {
      pickHit(*scene_, hitAt(*scene_, camera_, event->pos()), *selection_, false);
    }
    pressed_at_.reset();
    is_panning_ = false;
  }

  void mouseDoubleClickEvent(QMouseEvent* event) override {
    if (event->button() != Qt::LeftButton) return;
    const GraphHit hit = hitAt(*scene_, camera_, event->pos());
    if (hit.isNothing()) return fit();
    pickHit(*scene_, hit, *selection_, true);
  }

  void leaveEvent(QEvent* event) override {
    hover({});
    QWidget::leaveEvent(event);
  }

  void keyPressEvent(QKeyEvent* event) override {
    const QPointF middle = QRectF(rect()).center();
    if (event->matches(QKeySequence::Find)) {
      findCell();
    } else if (event->modifiers() & (Qt::ControlModifier | Qt::AltModifier | Qt::MetaModifier)) {
      QWidget::keyPressEvent(event);
    } else if (const auto way = directionOfKey(event->key())) {
      if (const auto next = cellToward(*scene_, picked(), {way->x(), way->y()}))
        selection_->selectCell(scene_->cells()[*next].id);
    } else if (event->key() == Qt::Key_F) {
      fit();
    } else if (event->key() == Qt::Key_Plus || event->key() == Qt::Key_Equal) {
      zoom(kKeyZoom, middle);
    } else if (event->key() == Qt::Key_Minus) {
      zoom(1 / kKeyZoom, middle);
    } else if (event->key() == Qt::Key_Escape && !picked().isNothing()) {
      selection_->clear();
    } else if (event->text().size() == 1 && event->text().at(0).isDigit()) {
      findCell();
      finder_->open(event->text());
    } else {
      QWidget::keyPressEvent(event);
    }
  }

  void focusInEvent(QFocusEvent* event) override {
    shows_focus_ = event->reason() != Qt::MouseFocusReason && event->reason() != Qt::ActiveWindowFocusReason &&
                   event->reason() != Qt::PopupFocusReason;
    update();
    QWidget::focusInEvent(event);
  }

  void focusOutEvent(QFocusEvent* event) override {
    shows_focus_ = false;
    update();
    QWidget::focusOutEvent(event);
  }

  void contextMenuEvent(QContextMenuEvent* event) override {
    if (event->reason() == QContextMenuEvent::Mouse) {
      showMenu(hitAt(*scene_, camera_, event->pos()), event->globalPos());
      return;
    }
    const GraphHit hit = picked();
    const std::optional<QPointF> middle = middleOf(*scene_, hit);
    const QPointF at = middle ? camera_.toScreen(*middle) : QRectF(rect()).center();
    showMenu(hit, mapToGlobal(at.toPoint()));
  }

 private:
  /// Colours anew, after something that the colours depend on has changed.
  void recolor() {
    button_->setBodyPartsKnown(knowsBodyParts(*scene_));
    const auto fixed = ranges_ == nullptr ? std::nullopt : ranges_->fixed(coloring());
    paint_ = std::make_shared<const GraphPaint>(paintOf(*scene_, coloring(), themeOf(palette()), fixed));
    arrange();
  }

  /// Shares the area out anew between skin, button and legend.
  void arrange() {
    const bool has_cells = !scene_->cells().empty();
    button_->setVisible(has_cells && width() >= kMinForButton.width() && height() >= kMinForButton.height());
    button_->adjustSize();
    const GraphLegend legend(*paint_, marks(), themeOf(palette()), font());
    GraphFit::Neighbors neighbors;
    if (!button_->isHidden()) neighbors.button = button_->size();
    if (has_cells) neighbors.legend = &legend;
    if (scene_->patches().size() > 1) neighbors.caption_height_px = fontMetrics().height() + 2.0;
    fit_ = GraphFit(*scene_, size(), neighbors);
    button_->move(fit_.button_place);
    if (follows_size_) {
      fit();
    } else {
      repaintSheet();
    }
  }

  void moveCamera(const GraphCamera& camera) {
    camera_ = camera;
    follows_size_ = false;
    repaintSheet();
  }

  void zoom(double factor, const QPointF& about) {
    if (scene_->cells().empty()) return;
    GraphCamera zoomed = camera_;
    zoomed.zoomTo(std::clamp(camera_.scale * factor, 0.5 * fit_.camera.scale, fit_.largestScale(*scene_)), about);
    moveCamera(zoomed);
  }

  void bringIntoView(const GraphHit& hit) {
    const std::optional<QPointF> middle = middleOf(*scene_, hit);
    if (!middle) return;
    GraphCamera moved = camera_;
    moved.bringIntoView(*middle, 4 * GraphFit::kMargin_px);
    if (moved.center == camera_.center) return;
    const bool followed = follows_size_;
    moveCamera(moved);
    follows_size_ = followed;
  }

  void onSelectionChanged() {
    bringIntoView(picked());
    describe();
    update();
  }

  /// Comes closer, as far as it takes to read what is picked.
  void showPicked() {
    constexpr double kReadable_px = 16;  // centre to corner of a cell
    const GraphHit hit = picked();
    const std::optional<QPointF> middle = middleOf(*scene_, hit);
    if (!middle) return;
    if (scene_->radius_m() * camera_.scale < kReadable_px) {
      GraphCamera closer = camera_;
      closer.center = *middle;
      closer.scale = std::min(kReadable_px / scene_->radius_m(), fit_.largestScale(*scene_));
      moveCamera(closer);
    } else {
      bringIntoView(hit);
    }
  }

  void describe() {
    const bool waits = !scene_->reconstruction() && !awaited_.isEmpty();
    setAccessibleDescription(waits ? awaited_ : describeGraph(*scene_, picked()));
  }

  void hover(const GraphHit& hit) {
    if (hit == hovered_) return;
    update(regionOf(hovered_) | regionOf(hit));
    hovered_ = hit;
    if (hit.isNothing()) {
      unsetCursor();
    } else {
      setCursor(Qt::PointingHandCursor);
    }
  }

  void showMenu(const GraphHit& hit, const QPoint& global_position) {
    if (scene_->cells().empty()) return;
    if (!hit.isNothing()) pickHit(*scene_, hit, *selection_, false);
    auto* menu = named(new QMenu(this), "graphMenu");
    menu->setAttribute(Qt::WA_DeleteOnClose);
    menu->setToolTipsVisible(true);
    if (hit.link) menu->addActions(link_actions_);
    if (hit.cell) menu->addActions(cell_actions_);
    menu->addSeparator();
    QAction* colors = menu->addMenu(button_->menu());
    colors->setText(tr("Colours"));
    menu->addAction(tr("&Fit"), this, &GraphView::fit);
    menu->addAction(tr("Find &cell…"), this, &GraphView::findCell);
    menu->addSeparator();
    menu->addAction(tr("Copy pict&ure"), this, &GraphView::copyPicture);
    menu->addAction(tr("&Save picture…"), this, &GraphView::pictureWanted);
    menu->popup(global_position);
  }

  void repaintSheet() {
    is_sheet_current_ = false;
    if (scene_->cells().size() > kMaxCellsAtOnce && !sheet_.isNull()) {
      draw_soon_.start();
    } else {
      update();
    }
  }

  const QPixmap& currentSheet() {
    const double ratio = devicePixelRatioF();
    const QSize pixels = (QSizeF(size()) * ratio).toSize();
    if (is_sheet_current_ && sheet_.size() == pixels) return sheet_;
    if (sheet_.size() != pixels) sheet_ = QPixmap(pixels);
    sheet_.setDevicePixelRatio(ratio);
    QPainter painter(&sheet_);
    picture().draw(painter);
    is_sheet_current_ = true;
    return sheet_;
  }

  void drawHint(QPainter& painter) const {
    painter.setPen(Colors::of(palette()).text_muted);
    const QString text = scene_->reconstruction() ? tr("This skin has no cells.")
                         : awaited_.isEmpty()     ? tr("The skin graph appears here as soon as a skin is open.")
                                                  : awaited_;
    painter.drawText(QRectF(rect()).adjusted(24, 12, -24, -12), Qt::AlignCenter | Qt::TextWordWrap, text);
  }

  void drawHighlights(QPainter& painter) const {
    const GraphStyle own = style();
    const GraphPainter graph(*scene_, *paint_, camera_, own);
    const Colors& colors = Colors::of(palette());
    for (const CellId brushed : selection_->brushed()) {
      if (const auto cell = scene_->indexOf(brushed)) graph.drawBrushMark(painter, *cell);
    }
    if (hovered_.cell) graph.drawCellOutline(painter, *hovered_.cell, colors.text_muted, 2);
    if (hovered_.link) graph.drawLinkOutline(painter, *hovered_.link, colors.text_muted, 1);
    const GraphHit hit = picked();
    // Light and dark side by side stand out on every colour.
    for (const bool core : {false, true}) {
      const QColor color = core ? colors.selection : textOn(colors.selection);
      if (hit.cell) graph.drawCellOutline(painter, *hit.cell, color, core ? 3.2 : 6.4);
      if (hit.link) graph.drawLinkOutline(painter, *hit.link, color, core ? 2 : 4);
    }
  }

  /// The pixels that the outline of a cell or a link covers.
  [[nodiscard]] QRect regionOf(const GraphHit& hit) const {
    if (hit.isNothing()) return {};
    const GraphStyle own = style();
    const GraphPainter graph(*scene_, *paint_, camera_, own);
    return (hit.cell ? graph.outlineBounds(*hit.cell) : graph.linkOutlineBounds(*hit.link)).toAlignedRect();
  }

  [[nodiscard]] GraphHit picked() const { return pickedIn(*scene_, *selection_); }

  [[nodiscard]] GraphStyle style() const {
    GraphStyle style;
    style.theme = themeOf(palette());
    style.font = font();
    style.marks_tree = button_->marksTree();
    return style;
  }

  [[nodiscard]] GraphMarks marks() const { return {button_->marksTree(), scene_->hasExcludedLinks()}; }

  Selection* selection_;
  DressedTheme dressed_{*this};
  std::shared_ptr<const GraphScene> scene_ = std::make_shared<GraphScene>();
  std::shared_ptr<const GraphPaint> paint_ = std::make_shared<GraphPaint>();
  const ScaleRanges* ranges_ = nullptr;
  QString awaited_;
  FindCellField* finder_ = new FindCellField([this](CellId id) { return scene_->indexOf(id).has_value(); }, this);
  GraphColoringButton* button_ = new GraphColoringButton(this);
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
  HeavyTurn draw_soon_{kDrawAfter_ms, [this] {
                         static_cast<void>(currentSheet());
                         update();
                       }};

  GraphHit hovered_;
  std::optional<QPoint> pressed_at_;
  QPoint last_mouse_;
  bool is_panning_ = false;
  bool shows_focus_ = false;  ///< the keyboard focus came by keyboard

  static constexpr double kKeyZoom = 1.25;
  /// In a smaller view there is no button; the context menu offers the colours, too.
  static constexpr QSize kMinForButton{220, 150};
  /// A larger skin takes long to draw.
  static constexpr std::size_t kMaxCellsAtOnce = 300;
  static constexpr int kDrawAfter_ms = 1;  // 0 may be in the turn in which the window is painted
};

}  // namespace hexoderm
