#include "widgets/graph/graph_view.h"

#include "widgets/controls/find_cell_field.h"
#include "widgets/controls/selection.h"
#include "widgets/graph/graph_view_parts.h"

#include <QApplication>
#include <QClipboard>
#include <QContextMenuEvent>
#include <QHelpEvent>
#include <QKeyEvent>
#include <QMouseEvent>
#include <QPainter>
#include <QToolTip>
#include <QWheelEvent>
#include <cmath>
#include <utility>

namespace hexoderm {

using graph_view::Hit;
using graph_view::kKeyZoom;

namespace {

QPointF positionIn(const QMouseEvent& event) {
#if QT_VERSION >= QT_VERSION_CHECK(6, 0, 0)
  return event.position();
#else
  return event.localPos();
#endif
}

std::optional<QPointF> arrowDirection(int key) {
  switch (key) {
    case Qt::Key_Left:
      return QPointF(-1, 0);
    case Qt::Key_Right:
      return QPointF(1, 0);
    case Qt::Key_Up:
      return QPointF(0, 1);
    case Qt::Key_Down:
      return QPointF(0, -1);
    default:
      return std::nullopt;
  }
}

}  // namespace

GraphView::GraphView(Selection* selection, QWidget* parent)
    : QWidget(parent), parts_(std::make_unique<Parts>(this, selection)) {
  setObjectName(QStringLiteral("graphView"));
  setAccessibleName(tr("Skin graph"));
  setFocusPolicy(Qt::StrongFocus);
  setMouseTracking(true);
  setAttribute(Qt::WA_OpaquePaintEvent);
  parts_->camera.size = size();
  parts_->recolor();
  parts_->describe();
  connect(parts_->button, &GraphColoringButton::changed, this, [this] { parts_->recolor(); });
  connect(selection, &Selection::changed, this, [this] { parts_->onPicked(); });
  connect(parts_->finder, &FindCellField::found, this, [this](quint32 id) {
    if (const auto cell = parts_->scene->indexOf(CellId(id))) {
      parts_->bringIntoView(parts_->scene->cells()[*cell].center);
      parts_->selection->selectCell(CellId(id));
    }
  });
  connect(parts_->finder, &FindCellField::closed, this, [this] { setFocus(Qt::OtherFocusReason); });
}

GraphView::~GraphView() = default;

void GraphView::setReconstruction(std::shared_ptr<const Reconstruction> reconstruction) {
  Parts& parts = *parts_;
  auto scene = std::make_shared<const GraphScene>(std::move(reconstruction));
  const bool stays = parts.scene->hasSamePlacesAs(*scene);
  parts.hover({});
  parts.scene = std::move(scene);
  if (!stays) parts.follows_size = true;
  parts.recolor();
  parts.describe();
}

void GraphView::setTheme(Theme theme) {
  parts_->theme = theme;
  parts_->recolor();
}

void GraphView::setColoring(GraphColoring coloring) { parts_->button->setColoring(coloring); }

GraphColoring GraphView::coloring() const { return parts_->button->coloring(); }

void GraphView::setLinkActions(const QList<QAction*>& actions) { parts_->link_actions = actions; }

void GraphView::setCellActions(const QList<QAction*>& actions) { parts_->cell_actions = actions; }

GraphPicture GraphView::picture() const { return parts_->picture(); }

void GraphView::copyPicture() {
  parts_->drawSheet();
  QApplication::clipboard()->setPixmap(parts_->sheet);
}

std::optional<QPoint> GraphView::positionOf(CellId cell) const {
  const auto index = parts_->scene->indexOf(cell);
  if (!index) return std::nullopt;
  return parts_->camera.toScreen(parts_->scene->cells()[*index].center).toPoint();
}

std::optional<QPoint> GraphView::positionOf(LinkEnd source, LinkEnd target) const {
  const auto index = parts_->scene->indexOf(source, target);
  if (!index) return std::nullopt;
  return parts_->camera.toScreen(Parts::middleOf(parts_->scene->links()[*index])).toPoint();
}

void GraphView::fit() { parts_->fitCamera(); }

void GraphView::findCell() {
  parts_->finder->move(8, 8);
  parts_->finder->raise();
  parts_->finder->open(QString());
}

bool GraphView::event(QEvent* event) {
  if (event->type() == QEvent::ToolTip) {
    const QPoint position = static_cast<QHelpEvent*>(event)->pos();
    const Hit hit = parts_->hitAt(position);
    const QString text = parts_->toolTipOf(hit);
    if (text.isEmpty()) {
      QToolTip::hideText();
    } else {
      QToolTip::showText(static_cast<QHelpEvent*>(event)->globalPos(), text, this);
    }
    return true;
  }
  if (event->type() == QEvent::FontChange) parts_->recolor();
  return QWidget::event(event);
}

void GraphView::paintEvent(QPaintEvent* event) {
  Parts& parts = *parts_;
  parts.drawSheetUnlessSoon();
  QPainter painter(this);
  const double ratio = parts.sheet.devicePixelRatioF();
  const QRect covered(QPoint(0, 0), (QSizeF(parts.sheet.size()) / ratio).toSize());
  if (!covered.contains(event->rect())) painter.fillRect(event->rect(), Colors::of(parts.theme).panel);
  // Only what is asked for: where the mouse went, a few hexagons.
  const QRect changed = event->rect().intersected(covered);
  painter.drawPixmap(changed, parts.sheet,
                     QRectF(QPointF(changed.topLeft()) * ratio, QSizeF(changed.size()) * ratio).toRect());
  painter.setRenderHint(QPainter::Antialiasing);
  if (parts.scene->cells().empty()) {
    parts.drawHint(painter);
  } else {
    parts.drawHighlights(painter);
  }
  if (parts.shows_focus) {
    painter.setBrush(Qt::NoBrush);
    painter.setPen(QPen(Colors::of(parts.theme).accent, 2));
    painter.drawRect(QRectF(rect()).adjusted(1, 1, -1, -1));
  }
}

void GraphView::resizeEvent(QResizeEvent* event) {
  parts_->camera.size = size();
  parts_->arrange();
  if (parts_->follows_size) {
    parts_->fitCamera();
  } else {
    parts_->repaintSheet();
  }
  QWidget::resizeEvent(event);
}

void GraphView::wheelEvent(QWheelEvent* event) {
  // One notch is 120: a quarter larger or smaller.
  parts_->zoom(std::pow(kKeyZoom, event->angleDelta().y() / 120.0), event->position());
  event->accept();
}

void GraphView::mousePressEvent(QMouseEvent* event) {
  if (event->button() != Qt::LeftButton && event->button() != Qt::MiddleButton) return;
  parts_->pressed_at = positionIn(*event).toPoint();
  parts_->last_mouse = positionIn(*event);
}

void GraphView::mouseMoveEvent(QMouseEvent* event) {
  Parts& parts = *parts_;
  if (!parts.pressed_at) {
    parts.hover(parts.hitAt(positionIn(*event)));
    return;
  }
  if (!parts.panning) {
    if ((positionIn(*event).toPoint() - *parts.pressed_at).manhattanLength() < QApplication::startDragDistance())
      return;
    if (parts.scene->cells().empty()) return;
    parts.panning = true;
    parts.hover({});
    setCursor(Qt::ClosedHandCursor);
  }
  parts.pan(positionIn(*event) - parts.last_mouse);
  parts.last_mouse = positionIn(*event);
}

void GraphView::mouseReleaseEvent(QMouseEvent* event) {
  Parts& parts = *parts_;
  if (!parts.pressed_at) return;
  if (parts.panning) {
    unsetCursor();
  } else if (event->button() == Qt::LeftButton) {
    parts.pick(parts.hitAt(positionIn(*event)));
  }
  parts.pressed_at.reset();
  parts.panning = false;
}

void GraphView::mouseDoubleClickEvent(QMouseEvent* event) {
  if (event->button() == Qt::LeftButton) fit();
}

void GraphView::contextMenuEvent(QContextMenuEvent* event) {
  if (event->reason() == QContextMenuEvent::Mouse) {
    parts_->showMenu(parts_->hitAt(event->pos()), event->globalPos());
    return;
  }
  const Hit hit = parts_->picked();
  QPointF at = QRectF(rect()).center();
  if (hit.cell) at = parts_->camera.toScreen(parts_->scene->cells()[*hit.cell].center);
  if (hit.link) at = parts_->camera.toScreen(Parts::middleOf(parts_->scene->links()[*hit.link]));
  parts_->showMenu(hit, mapToGlobal(at.toPoint()));
}

void GraphView::leaveEvent(QEvent* event) {
  parts_->hover({});
  QWidget::leaveEvent(event);
}

void GraphView::keyPressEvent(QKeyEvent* event) {
  Parts& parts = *parts_;
  const QPointF middle = QRectF(rect()).center();
  if (event->matches(QKeySequence::Find)) {
    findCell();
  } else if (event->modifiers() & (Qt::ControlModifier | Qt::AltModifier | Qt::MetaModifier)) {
    QWidget::keyPressEvent(event);
  } else if (const auto direction = arrowDirection(event->key())) {
    parts.movePicked(*direction);
  } else if (event->key() == Qt::Key_F) {
    fit();
  } else if (event->key() == Qt::Key_Plus || event->key() == Qt::Key_Equal) {
    parts.zoom(kKeyZoom, middle);
  } else if (event->key() == Qt::Key_Minus) {
    parts.zoom(1 / kKeyZoom, middle);
  } else if (event->key() == Qt::Key_Escape && !parts.picked().isNothing()) {
    parts.selection->clear();
  } else if (event->text().size() == 1 && event->text().at(0).isDigit()) {
    findCell();
    parts.finder->open(event->text());
  } else {
    QWidget::keyPressEvent(event);
  }
}

void GraphView::focusInEvent(QFocusEvent* event) {
  parts_->shows_focus = event->reason() != Qt::MouseFocusReason && event->reason() != Qt::ActiveWindowFocusReason &&
                        event->reason() != Qt::PopupFocusReason;
  update();
  QWidget::focusInEvent(event);
}

void GraphView::focusOutEvent(QFocusEvent* event) {
  parts_->shows_focus = false;
  update();
  QWidget::focusOutEvent(event);
}

}  // namespace hexoderm
