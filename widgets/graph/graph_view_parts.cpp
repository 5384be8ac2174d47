#include "widgets/graph/graph_view_parts.h"

#include "widgets/controls/find_cell_field.h"
#include "widgets/controls/selection.h"
#include "widgets/words/formatting.h"
#include "widgets/words/words.h"

#include <QMenu>
#include <QPainter>
#include <algorithm>
#include <cmath>
#include <utility>

namespace hexoderm {

using graph_view::Hit;
using namespace graph_view;

GraphView::Parts::Parts(GraphView* owner, Selection* shared)
    : view(owner),
      selection(shared),
      finder(new FindCellField([this](CellId id) { return scene->indexOf(id).has_value(); }, owner)),
      button(new GraphColoringButton(owner)) {
  draw_soon.setInterval(1);
  draw_soon.setSingleShot(true);
  QObject::connect(&draw_soon, &QTimer::timeout, view, [this] {
    drawSheet();
    view->update();
  });
}

void GraphView::Parts::repaintSheet() {
  sheet_is_current = false;
  // What takes long has a turn of the event loop to itself, rather than the one in which the whole window may be
  // painted.
  if (scene->cells().size() > kMostCellsAtOnce && !sheet.isNull()) {
    draw_soon.start();
  } else {
    view->update();
  }
}

void GraphView::Parts::recolor() {
  button->setBodyPartsKnown(knowsBodyParts(*scene));
  paint = std::make_shared<const GraphPaint>(paintOf(*scene, button->coloring(), theme));
  arrange();
  if (follows_size) {
    fitCamera();
  } else {
    repaintSheet();
  }
}

void GraphView::Parts::arrange() {
  const bool has_cells = !scene->cells().empty();
  button->setVisible(has_cells && view->width() >= kLeastForButton.width() &&
                     view->height() >= kLeastForButton.height());
  button->adjustSize();
  legend_area = QRectF();
  if (has_cells) placeLegend();
  button->move(kButtonEdge_px, kButtonEdge_px);
  if (!button->isHidden()) {
    if (const auto place = freeForButton(fittedInto(fitRoom()))) button->move(*place);
  }
}

void GraphView::Parts::placeLegend() {
  const double width = view->width() - 2 * kFitMargin_px;
  const double height = GraphLegend(*paint, marks(), theme, view->font()).heightFor(width);
  if (height <= 0 || height > kMostForLegend * view->height() || view->height() - height < kLeastForSkin_px) return;
  legend_area = QRectF(kFitMargin_px, view->height() - height - 0.5 * kFitMargin_px, width, height);
}

double GraphView::Parts::captionSpace() const {
  return scene->patches().size() > 1 ? view->fontMetrics().height() + 2.0 : 0.0;
}

GraphCamera GraphView::Parts::fittedInto(const QRectF& room) const {
  GraphCamera fitted = camera;
  const QRectF& bounds = scene->bounds();
  fitted.scale = 1;
  if (!bounds.isEmpty()) {
    fitted.scale =
        std::min({std::max(1.0, room.width()) / bounds.width(), std::max(1.0, room.height()) / bounds.height(),
                  kLargestFittedRadius_px / scene->radius_m()});
  }
  const QPointF off = room.center() - QPointF(0.5 * camera.size.width(), 0.5 * camera.size.height());
  fitted.center = bounds.center() + QPointF(-off.x(), off.y()) / fitted.scale;
  return fitted;
}

QRectF GraphView::Parts::fitRoom() const {
  QRectF room(QPointF(0, 0), camera.size);
  room.adjust(kFitMargin_px, kFitMargin_px + captionSpace(), -kFitMargin_px, -kFitMargin_px);
  if (!legend_area.isEmpty()) room.setBottom(legend_area.top() - 0.5 * kFitMargin_px);
  return room;
}

std::optional<QPoint> GraphView::Parts::freeForButton(const GraphCamera& fitted) const {
  const double reach = 1.3 * scene->radius_m() * fitted.scale;
  const int right = view->width() - button->width() - kButtonEdge_px;
  for (const int x : {kButtonEdge_px, right, (view->width() - button->width()) / 2}) {
    const QPoint place(x, kButtonEdge_px);
    const QRectF covered = QRectF(place, button->size()).adjusted(-reach, -reach, reach, reach + captionSpace());
    const bool is_covering = std::ranges::any_of(
        scene->cells(), [&](const GraphScene::Cell& cell) { return covered.contains(fitted.toScreen(cell.center)); });
    if (!is_covering) return place;
  }
  return std::nullopt;
}

GraphCamera GraphView::Parts::fitted() const {
  QRectF room = fitRoom();
  const GraphCamera whole = fittedInto(room);
  // Beside many a skin there is room for the button; if there is not, the skin goes below it.
  if (button->isHidden() || freeForButton(whole)) return whole;
  room.setTop(button->geometry().bottom() + 4 + captionSpace());
  return fittedInto(room);
}

void GraphView::Parts::fitCamera() {
  camera = fitted();
  follows_size = true;
  repaintSheet();
}

void GraphView::Parts::zoom(double factor, const QPointF& about) {
  if (scene->cells().empty()) return;
  const double fitted_scale = fitted().scale;
  const double scale = std::clamp(camera.scale * factor, 0.5 * fitted_scale,
                                  std::max(fitted_scale, kLargestRadius_px / scene->radius_m()));
  const QPointF fixed = camera.toSheet(about);
  camera.scale = scale;
  camera.center += fixed - camera.toSheet(about);
  follows_size = false;
  repaintSheet();
}

void GraphView::Parts::pan(const QPointF& by_px) {
  camera.center += QPointF(-by_px.x(), by_px.y()) / camera.scale;
  follows_size = false;
  repaintSheet();
}

/// Pans no further than it takes to see the point.
void GraphView::Parts::bringIntoView(const QPointF& sheet_point) {
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

Hit GraphView::Parts::hitAt(const QPointF& position) const {
  const QPointF point = camera.toSheet(position);
  // Nobody can aim at the links between dots that are smaller than a hand is steady.
  const double radius_px = scene->radius_m() * camera.scale;
  if (radius_px < 0.6 * kGrasp_px) return {scene->cellNear(point, kGrasp_px / camera.scale), std::nullopt};
  if (const auto cell = scene->cellAt(point)) return {cell, std::nullopt};
  return {std::nullopt, scene->linkAt(point, kGrasp_px / camera.scale)};
}

void GraphView::Parts::pick(const Hit& hit) {
  if (hit.cell) {
    selection->selectCell(scene->cells()[*hit.cell].id);
  } else if (hit.link) {
    const LinkEstimate& link = *scene->links()[*hit.link].estimate;
    selection->selectLink(link.source, link.target);
  } else {
    selection->clear();
  }
}

Hit GraphView::Parts::picked() const {
  Hit hit;
  if (const auto cell = selection->cell()) hit.cell = scene->indexOf(*cell);
  if (const auto link = selection->link()) hit.link = scene->indexOf(link->first, link->second);
  return hit;
}

void GraphView::Parts::movePicked(const QPointF& direction) {
  const Hit now = picked();
  std::optional<std::size_t> next;
  if (now.cell) {
    next = scene->neighborToward(*now.cell, direction);
  } else if (now.link) {
    const GraphScene::Link& link = scene->links()[*now.link];
    const QPointF along = scene->cells()[link.target].center - scene->cells()[link.source].center;
    next = QPointF::dotProduct(along, direction) >= 0 ? link.target : link.source;
  } else {
    const auto origin = std::ranges::find(scene->cells(), true, &GraphScene::Cell::origin);
    if (origin != scene->cells().end()) next = static_cast<std::size_t>(origin - scene->cells().begin());
  }
  if (next) selection->selectCell(scene->cells()[*next].id);
}

void GraphView::Parts::onPicked() {
  const Hit hit = picked();
  if (hit.cell) bringIntoView(scene->cells()[*hit.cell].center);
  if (hit.link) bringIntoView(middleOf(scene->links()[*hit.link]));
  describe();
  view->update();
}

QPointF GraphView::Parts::middleOf(const GraphScene::Link& link) {
  return link.cut ? link.from : 0.5 * (link.from + link.to);
}

void GraphView::Parts::describe() {
  QString text = GraphView::tr("No skin is open.");
  if (scene->reconstruction()) {
    text = words(sizeInWords(*scene->reconstruction()));
    const Hit hit = picked();
    if (hit.cell) text += QStringLiteral(". ") + GraphView::tr("Picked: cell %1").arg(selection->cell()->value());
    if (hit.link) {
      const LinkEstimate& link = *scene->links()[*hit.link].estimate;
      text += QStringLiteral(". ") + GraphView::tr("Picked: %1, %2").arg(longLinkName(link), qualityWord(link.quality));
      if (!link.used) text += QStringLiteral(", ") + GraphView::tr("not used");
    }
  }
  view->setAccessibleDescription(text);
}

void GraphView::Parts::hover(const Hit& hit) {
  if (hit == hovered) return;
  view->update(regionOf(hovered) | regionOf(hit));
  hovered = hit;
  if (hit.isNothing()) {
    view->unsetCursor();
  } else {
    view->setCursor(Qt::PointingHandCursor);
  }
}

QString GraphView::Parts::toolTipOf(const Hit& hit) const {
  if (hit.cell) return cellToolTip(*scene->reconstruction(), scene->cells()[*hit.cell].id);
  if (hit.link) return linkToolTip(*scene->reconstruction(), *scene->links()[*hit.link].estimate);
  return {};
}

void GraphView::Parts::showMenu(const Hit& hit, const QPoint& global_position) {
  if (scene->cells().empty()) return;
  if (!hit.isNothing()) pick(hit);
  auto* menu = new QMenu(view);
  menu->setObjectName(QStringLiteral("graphMenu"));
  menu->setAttribute(Qt::WA_DeleteOnClose);
  menu->setToolTipsVisible(true);
  if (hit.link) menu->addActions(link_actions);
  if (hit.cell) menu->addActions(cell_actions);
  menu->addSeparator();
  QAction* colors = menu->addMenu(button->menu());
  colors->setText(GraphView::tr("Colours"));
  menu->addAction(GraphView::tr("&Fit"), view, &GraphView::fit);
  menu->addAction(GraphView::tr("Find &cell…"), view, &GraphView::findCell);
  menu->addSeparator();
  menu->addAction(GraphView::tr("Copy pict&ure"), view, &GraphView::copyPicture);
  menu->addAction(GraphView::tr("&Save picture…"), view, &GraphView::pictureWanted);
  menu->popup(global_position);
}

GraphStyle GraphView::Parts::style() const {
  GraphStyle style;
  style.theme = theme;
  style.font = view->font();
  style.marks_tree = button->marksTree();
  return style;
}

GraphMarks GraphView::Parts::marks() const { return {button->marksTree(), scene->hasMutedLinks()}; }

GraphPicture GraphView::Parts::picture() const { return {scene, paint, camera, style(), marks(), legend_area}; }

void GraphView::Parts::drawHint(QPainter& painter) const {
  painter.setPen(Colors::of(theme).text_muted);
  const QString text = scene->reconstruction()
                           ? GraphView::tr("This skin has no cells.")
                           : GraphView::tr("The skin graph appears here as soon as a skin is open.");
  painter.drawText(QRectF(view->rect()).adjusted(24, 12, -24, -12), Qt::AlignCenter | Qt::TextWordWrap, text);
}

void GraphView::Parts::drawSheet() {
  const double ratio = view->devicePixelRatioF();
  const QSize pixels = (QSizeF(view->size()) * ratio).toSize();
  if (sheet_is_current && sheet.size() == pixels) return;
  if (sheet.size() != pixels) sheet = QPixmap(pixels);
  sheet.setDevicePixelRatio(ratio);
  QPainter painter(&sheet);
  picture().draw(painter);
  sheet_is_current = true;
}

void GraphView::Parts::drawSheetUnlessSoon() {
  if (!draw_soon.isActive()) drawSheet();
}

void GraphView::Parts::drawHighlights(QPainter& painter) const {
  const GraphStyle own = style();
  const GraphPainter graph(*scene, *paint, camera, own);
  const Colors& colors = Colors::of(theme);
  if (hovered.cell) graph.drawCellOutline(painter, *hovered.cell, colors.text_muted, 2);
  if (hovered.link) graph.drawLinkOutline(painter, *hovered.link, colors.text_muted, 1);
  const Hit hit = picked();
  if (hit.cell) graph.drawCellOutline(painter, *hit.cell, colors.selection, 3.2);
  if (hit.link) graph.drawLinkOutline(painter, *hit.link, colors.selection, 2);
}

QRect GraphView::Parts::regionOf(const Hit& hit) const {
  if (hit.isNothing()) return {};
  const GraphStyle own = style();
  const GraphPainter graph(*scene, *paint, camera, own);
  return (hit.cell ? graph.outlineBounds(*hit.cell) : graph.linkOutlineBounds(*hit.link)).toAlignedRect();
}

}  // namespace hexoderm
