#include "widgets/graph_view.h"

#include "widgets/core_words.h"
#include "widgets/find_cell_field.h"
#include "widgets/graph_painter.h"
#include "widgets/graph_scene.h"
#include "widgets/selection.h"
#include "widgets/words.h"

#include <QApplication>
#include <QHelpEvent>
#include <QKeyEvent>
#include <QMouseEvent>
#include <QPainter>
#include <QPixmap>
#include <QToolTip>
#include <QWheelEvent>
#include <algorithm>
#include <cmath>
#include <utility>

namespace hexoderm {
namespace {

constexpr double kFitMargin_px = 12;
/// A skin of one cell need not fill the window.
constexpr double kLargestFittedRadius_px = 40;
constexpr double kLargestRadius_px = 150;
constexpr double kGrasp_px = 7;
constexpr double kKeyZoom = 1.25;

/// A cell or a link under the mouse.
struct Hit {
  std::optional<std::size_t> cell;
  std::optional<std::size_t> link;
  friend bool operator==(const Hit&, const Hit&) = default;
  [[nodiscard]] bool isNothing() const { return !cell && !link; }
};

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

struct GraphView::Parts {
  Parts(GraphView* owner, Selection* shared)
      : view(owner),
        selection(shared),
        finder(new FindCellField([this](CellId id) { return scene.indexOf(id).has_value(); }, owner)) {}

  GraphView* view;
  Selection* selection;
  GraphScene scene;
  GraphCamera camera;
  FindCellField* finder;  ///< a child of the view
  Theme theme = Theme::Light;
  bool follows_size = true;  ///< until somebody zooms or pans
  bool shows_focus = false;  ///< for those who came by keyboard
  Hit hovered;
  std::optional<QPoint> pressed_at;
  bool panning = false;
  QPointF last_mouse;
  QPixmap sheet;  ///< all but what is picked, so that picking and pointing cost nothing
  bool sheet_is_current = false;

  void repaintSheet() {
    sheet_is_current = false;
    view->update();
  }

  [[nodiscard]] double fittedScale() const {
    const double width = std::max(1.0, camera.size.width() - 2 * kFitMargin_px);
    const double height = std::max(1.0, camera.size.height() - 2 * kFitMargin_px - captionSpace());
    const QRectF& bounds = scene.bounds();
    if (bounds.isEmpty()) return 1;
    return std::min({width / bounds.width(), height / bounds.height(), kLargestFittedRadius_px / scene.radius_m()});
  }

  [[nodiscard]] double captionSpace() const {
    return scene.patches().size() > 1 ? view->fontMetrics().height() + 2.0 : 0.0;
  }

  void fitCamera() {
    camera.scale = fittedScale();
    camera.center = scene.bounds().center() + QPointF(0, 0.5 * captionSpace() / camera.scale);
    follows_size = true;
    repaintSheet();
  }

  void zoom(double factor, const QPointF& about) {
    if (scene.cells().empty()) return;
    const double fitted = fittedScale();
    const double scale =
        std::clamp(camera.scale * factor, 0.5 * fitted, std::max(fitted, kLargestRadius_px / scene.radius_m()));
    const QPointF fixed = camera.toSheet(about);
    camera.scale = scale;
    camera.center += fixed - camera.toSheet(about);
    follows_size = false;
    repaintSheet();
  }

  void pan(const QPointF& by_px) {
    camera.center += QPointF(-by_px.x(), by_px.y()) / camera.scale;
    follows_size = false;
    repaintSheet();
  }

  /// Pans no further than it takes to see the point.
  void bringIntoView(const QPointF& sheet_point) {
    const double margin = std::min({4 * kFitMargin_px, camera.size.width() / 4, camera.size.height() / 4});
    const QPointF at = camera.toScreen(sheet_point);
    const QPointF inside(std::clamp(at.x(), margin, camera.size.width() - margin),
                         std::clamp(at.y(), margin, camera.size.height() - margin));
    // What the fitted view shows is in view already, also near its edge.
    if (QRectF(QPointF(0, 0), camera.size).contains(at)) return;
    const bool followed = follows_size;
    pan(inside - at);
    follows_size = followed;
  }

  [[nodiscard]] Hit hitAt(const QPointF& position) const {
    const QPointF point = camera.toSheet(position);
    // Nobody can aim at the links between dots that are smaller than a hand is steady.
    const double radius_px = scene.radius_m() * camera.scale;
    if (radius_px < 0.6 * kGrasp_px) return {scene.cellNear(point, kGrasp_px / camera.scale), std::nullopt};
    if (const auto cell = scene.cellAt(point)) return {cell, std::nullopt};
    return {std::nullopt, scene.linkAt(point, kGrasp_px / camera.scale)};
  }

  void pick(const Hit& hit) {
    if (hit.cell) {
      selection->selectCell(scene.cells()[*hit.cell].id);
    } else if (hit.link) {
      const LinkEstimate& link = *scene.links()[*hit.link].estimate;
      selection->selectLink(link.source, link.target);
    } else {
      selection->clear();
    }
  }

  [[nodiscard]] Hit picked() const {
    Hit hit;
    if (const auto cell = selection->cell()) hit.cell = scene.indexOf(*cell);
    if (const auto link = selection->link()) hit.link = scene.indexOf(link->first, link->second);
    return hit;
  }

  void movePicked(const QPointF& direction) {
    const Hit now = picked();
    std::optional<std::size_t> next;
    if (now.cell) {
      next = scene.neighborToward(*now.cell, direction);
    } else if (now.link) {
      const GraphScene::Link& link = scene.links()[*now.link];
      const QPointF along = scene.cells()[link.target].center - scene.cells()[link.source].center;
      next = QPointF::dotProduct(along, direction) >= 0 ? link.target : link.source;
    } else {
      const auto origin = std::ranges::find(scene.cells(), true, &GraphScene::Cell::origin);
      if (origin != scene.cells().end()) next = static_cast<std::size_t>(origin - scene.cells().begin());
    }
    if (next) selection->selectCell(scene.cells()[*next].id);
  }

  void onPicked() {
    const Hit hit = picked();
    if (hit.cell) bringIntoView(scene.cells()[*hit.cell].center);
    if (hit.link) bringIntoView(middleOf(scene.links()[*hit.link]));
    describe();
    view->update();
  }

  [[nodiscard]] static QPointF middleOf(const GraphScene::Link& link) {
    return link.cut ? link.from : 0.5 * (link.from + link.to);
  }

  void describe() {
    QString text = GraphView::tr("No skin is open.");
    if (scene.reconstruction()) {
      text = coreWords(sizeInWords(*scene.reconstruction()));
      const Hit hit = picked();
      if (hit.cell) text += QStringLiteral(". ") + GraphView::tr("Picked: cell %1").arg(selection->cell()->value());
      if (hit.link) {
        const LinkEstimate& link = *scene.links()[*hit.link].estimate;
        text +=
            QStringLiteral(". ") + GraphView::tr("Picked: %1, %2").arg(longLinkName(link), qualityWord(link.quality));
      }
    }
    view->setAccessibleDescription(text);
  }

  void hover(const Hit& hit) {
    if (hit == hovered) return;
    hovered = hit;
    if (hit.isNothing()) {
      view->unsetCursor();
    } else {
      view->setCursor(Qt::PointingHandCursor);
    }
    view->update();
  }

  void drawHint(QPainter& painter) const {
    painter.setPen(Colors::of(theme).text_muted);
    const QString text = scene.reconstruction()
                             ? GraphView::tr("This skin has no cells.")
                             : GraphView::tr("The skin graph appears here as soon as a skin is open.");
    painter.drawText(QRectF(view->rect()).adjusted(24, 12, -24, -12), Qt::AlignCenter | Qt::TextWordWrap, text);
  }

  void drawSheet() {
    const double ratio = view->devicePixelRatioF();
    const QSize pixels = (QSizeF(view->size()) * ratio).toSize();
    if (sheet_is_current && sheet.size() == pixels) return;
    sheet = QPixmap(pixels);
    sheet.setDevicePixelRatio(ratio);
    sheet.fill(Colors::of(theme).panel);
    QPainter painter(&sheet);
    GraphPainter(scene, camera, theme, view->font()).drawSheet(painter);
    sheet_is_current = true;
  }

  void drawHighlights(QPainter& painter) const {
    const GraphPainter graph(scene, camera, theme, view->font());
    const Colors& colors = Colors::of(theme);
    if (hovered.cell) graph.drawCellOutline(painter, *hovered.cell, colors.text_muted, 2);
    if (hovered.link) graph.drawLinkOutline(painter, *hovered.link, colors.text_muted, 1);
    const Hit hit = picked();
    if (hit.cell) graph.drawCellOutline(painter, *hit.cell, colors.selection, 3.2);
    if (hit.link) graph.drawLinkOutline(painter, *hit.link, colors.selection, 2);
  }
};

GraphView::GraphView(Selection* selection, QWidget* parent)
    : QWidget(parent), parts_(std::make_unique<Parts>(this, selection)) {
  setObjectName(QStringLiteral("graphView"));
  setAccessibleName(tr("Skin graph"));
  setFocusPolicy(Qt::StrongFocus);
  setMouseTracking(true);
  setAttribute(Qt::WA_OpaquePaintEvent);
  parts_->camera.size = size();
  parts_->describe();
  connect(selection, &Selection::changed, this, [this] { parts_->onPicked(); });
  connect(parts_->finder, &FindCellField::found, this, [this](quint32 id) {
    if (const auto cell = parts_->scene.indexOf(CellId(id))) {
      parts_->bringIntoView(parts_->scene.cells()[*cell].center);
      parts_->selection->selectCell(CellId(id));
    }
  });
  connect(parts_->finder, &FindCellField::closed, this, [this] { setFocus(Qt::OtherFocusReason); });
}

GraphView::~GraphView() = default;

void GraphView::setReconstruction(std::shared_ptr<const Reconstruction> reconstruction) {
  Parts& parts = *parts_;
  GraphScene scene(std::move(reconstruction));
  const bool stays = parts.scene.hasSamePlacesAs(scene);
  parts.scene = std::move(scene);
  parts.hover({});
  if (!stays) parts.fitCamera();
  parts.describe();
  parts.repaintSheet();
}

void GraphView::setTheme(Theme theme) {
  parts_->theme = theme;
  parts_->repaintSheet();
}

std::optional<QPoint> GraphView::positionOf(CellId cell) const {
  const auto index = parts_->scene.indexOf(cell);
  if (!index) return std::nullopt;
  return parts_->camera.toScreen(parts_->scene.cells()[*index].center).toPoint();
}

std::optional<QPoint> GraphView::positionOf(LinkEnd source, LinkEnd target) const {
  const auto index = parts_->scene.indexOf(source, target);
  if (!index) return std::nullopt;
  return parts_->camera.toScreen(Parts::middleOf(parts_->scene.links()[*index])).toPoint();
}

void GraphView::fit() { parts_->fitCamera(); }

void GraphView::findCell() {
  parts_->finder->move(8, 8);
  parts_->finder->open(QString());
}

bool GraphView::event(QEvent* event) {
  if (event->type() == QEvent::ToolTip) {
    const QPoint position = static_cast<QHelpEvent*>(event)->pos();
    const Hit hit = parts_->hitAt(position);
    QString text;
    if (hit.cell) text = cellToolTip(*parts_->scene.reconstruction(), parts_->scene.cells()[*hit.cell].id);
    if (hit.link) text = linkToolTip(*parts_->scene.links()[*hit.link].estimate);
    if (text.isEmpty()) {
      QToolTip::hideText();
    } else {
      QToolTip::showText(static_cast<QHelpEvent*>(event)->globalPos(), text, this);
    }
    return true;
  }
  if (event->type() == QEvent::FontChange) parts_->repaintSheet();
  return QWidget::event(event);
}

void GraphView::paintEvent(QPaintEvent* /*event*/) {
  Parts& parts = *parts_;
  parts.drawSheet();
  QPainter painter(this);
  painter.drawPixmap(0, 0, parts.sheet);
  painter.setRenderHint(QPainter::Antialiasing);
  if (parts.scene.cells().empty()) {
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
    if (parts.scene.cells().empty()) return;
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
  parts_->shows_focus = event->reason() != Qt::MouseFocusReason && event->reason() != Qt::ActiveWindowFocusReason;
  update();
  QWidget::focusInEvent(event);
}

void GraphView::focusOutEvent(QFocusEvent* event) {
  parts_->shows_focus = false;
  update();
  QWidget::focusOutEvent(event);
}

}  // namespace hexoderm
