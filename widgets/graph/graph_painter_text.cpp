// GraphPainter's texts on the sheet: IDs, ports, the letters at cuts, the names of patches.

#include "widgets/graph/graph_painter.h"

#include <QCoreApplication>
#include <QFontMetricsF>
#include <algorithm>

namespace hexoderm {

void GraphPainter::drawIds(QPainter& painter) const {
  const auto digits = static_cast<double>(scene_.longestId());
  const double pixels = std::min({0.8 * radius_px_, 1.6 * radius_px_ / (0.62 * digits), 24.0});
  if (pixels < 6) return;
  QFont font = style_.font;
  font.setPixelSize(static_cast<int>(pixels));
  QFont starred = font;  // the star needs room, too
  starred.setPixelSize(static_cast<int>(std::min(pixels, 1.62 * radius_px_ / (0.62 * digits + 1.0))));
  const bool filled = !coloringRow(paint_.coloring).colors_links;
  painter.setPen(colors_.text);
  for (std::size_t k = 0; k < scene_.cells().size(); ++k) {
    const GraphScene::Cell& cell = scene_.cells()[k];
    const QPointF center = camera_.toScreen(cell.center);
    if (!seen_.contains(center)) continue;
    const QRectF box(center - QPointF(2 * radius_px_, radius_px_), QSizeF(4 * radius_px_, 2 * radius_px_));
    const QString id = QString::number(cell.id.value());
    if (filled) painter.setPen(textOn(fillOf(k)));
    painter.setFont(cell.origin ? starred : font);
    painter.drawText(box, Qt::AlignCenter, cell.origin ? id + QStringLiteral("★") : id);
  }
}

/// Port numbers where a link leaves its cell: for those who look closely.
void GraphPainter::drawPorts(QPainter& painter) const {
  QFont font = style_.font;
  font.setPixelSize(static_cast<int>(std::clamp(0.3 * radius_px_, 9.0, 13.0)));
  painter.setFont(font);
  painter.setPen(colors_.text_muted);
  const bool filled = !coloringRow(paint_.coloring).colors_links;
  const auto draw = [&](std::size_t cell, const GraphScene::Link& link, PortNumber port) {
    const QPointF direction = scene_.directionFrom(cell, link);
    const QPointF place =
        camera_.toScreen(scene_.cells()[cell].center) + 0.66 * radius_px_ * QPointF(direction.x(), -direction.y());
    if (filled) painter.setPen(textOn(fillOf(cell)));
    painter.drawText(QRectF(place - QPointF(12, 10), QSizeF(24, 20)), Qt::AlignCenter, QString::number(port.value()));
  };
  for (const GraphScene::Link& link : scene_.links()) {
    if (seen_.contains(camera_.toScreen(link.from))) draw(link.source, link, link.estimate->source.port);
    if (seen_.contains(camera_.toScreen(link.to))) draw(link.target, link, link.estimate->target.port);
  }
}

void GraphPainter::drawCutMarks(QPainter& painter) const {
  QFont font = style_.font;
  font.setPixelSize(static_cast<int>(std::clamp(0.62 * radius_px_, 8.0, 14.0)));
  font.setItalic(true);
  painter.setFont(font);
  painter.setPen(colors_.text);
  const auto draw = [&](std::size_t cell, const GraphScene::Link& link, const QPointF& port) {
    const QPointF direction = scene_.directionFrom(cell, link);
    const double out = 0.75 * font.pixelSize();
    const QPointF place = camera_.toScreen(port) + out * QPointF(direction.x(), -direction.y());
    if (!seen_.contains(place)) return;
    painter.drawText(QRectF(place - QPointF(20, 10), QSizeF(40, 20)), Qt::AlignCenter, link.mark);
  };
  for (const GraphScene::Link& link : scene_.links()) {
    if (!link.cut) continue;
    draw(link.source, link, link.from);
    draw(link.target, link, link.to);
  }
}

void GraphPainter::drawPatchCaptions(QPainter& painter) const {
  QFont font = style_.font;
  font.setPointSizeF(std::max(7.0, 0.88 * (font.pointSizeF() > 0 ? font.pointSizeF() : 10.0)));
  painter.setFont(font);
  painter.setPen(colors_.text_muted);
  const QFontMetricsF metrics(font);
  for (const GraphScene::Patch& patch : scene_.patches()) {
    if (patch.patch->cells.empty()) continue;
    const QRectF box = camera_.toScreen(patch.bounds);
    QString text = QCoreApplication::translate("hexoderm::GraphView", "Patch %1").arg(patch.patch->id.value() + 1);
    const double least = metrics.horizontalAdvance(text);
    if (!box.intersects(seen_) || (box.width() < least && scene_.patches().size() > 6)) continue;
    const std::size_t count = patch.patch->cells.size();
    const QString cells = count == 1 ? QCoreApplication::translate("hexoderm::GraphView", "1 cell")
                                     : QCoreApplication::translate("hexoderm::GraphView", "%1 cells").arg(count);
    const QString longer = text + QStringLiteral(" · ") + cells;
    if (metrics.horizontalAdvance(longer) <= std::max(box.width(), 1.6 * least)) text = longer;
    painter.drawText(QPointF(std::max(6.0, box.left()), std::max(metrics.ascent() + 4, box.top() - 2)), text);
  }
}

}  // namespace hexoderm
