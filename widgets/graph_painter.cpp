#include "widgets/graph_painter.h"

#include <QCoreApplication>
#include <QFontMetricsF>
#include <QTransform>
#include <algorithm>
#include <array>
#include <cmath>

namespace hexoderm {
namespace {

// From these radii of a hexagon on (pixels), details are drawn.
constexpr double kOutlineRadius = 2.5;
constexpr double kStyleRadius = 4.0;
constexpr double kIdRadius = 8.0;
constexpr double kPortRadius = 26.0;
/// Curves between the ends of cuts help while there are few.
constexpr std::size_t kMostCutCurves = 4;

QPointF normalOf(const QPointF& a, const QPointF& b) {
  const QPointF along = b - a;
  const double length = std::hypot(along.x(), along.y());
  return length > 0 ? QPointF(-along.y(), along.x()) / length : QPointF();
}

}  // namespace

GraphPainter::GraphPainter(const GraphScene& scene, const GraphCamera& camera, Theme theme, const QFont& font)
    : scene_(scene),
      camera_(camera),
      theme_(theme),
      colors_(Colors::of(theme)),
      font_(font),
      radius_px_(scene.radius_m() * camera.scale),
      separation_px_(std::clamp(0.32 * radius_px_, 0.0, 14.0)) {
  const double margin = 3 * radius_px_;
  seen_ = QRectF(QPointF(0, 0), camera.size).adjusted(-margin, -margin, margin, margin);
}

void GraphPainter::drawSheet(QPainter& painter) const {
  // Without smoothing a large skin is drawn several times faster, and at that size nobody sees the difference.
  painter.setRenderHint(QPainter::Antialiasing, radius_px_ >= kOutlineRadius);
  drawLinks(painter);
  painter.setRenderHint(QPainter::Antialiasing, true);
  if (scene_.cutCount() <= kMostCutCurves) drawCutCurves(painter);
  painter.setRenderHint(QPainter::Antialiasing, radius_px_ >= kOutlineRadius);
  drawCells(painter);
  painter.setRenderHint(QPainter::Antialiasing, true);
  if (radius_px_ >= kIdRadius) {
    drawIds(painter);
    drawCutMarks(painter);
  }
  if (radius_px_ >= kPortRadius) drawPorts(painter);
  if (scene_.patches().size() > 1) drawPatchCaptions(painter);
}

bool GraphPainter::isSeen(const QPointF& a, const QPointF& b) const {
  return std::max(a.x(), b.x()) >= seen_.left() && std::min(a.x(), b.x()) <= seen_.right() &&
         std::max(a.y(), b.y()) >= seen_.top() && std::min(a.y(), b.y()) <= seen_.bottom();
}

QPolygonF GraphPainter::hexagon(std::size_t cell) const {
  const GraphScene::Cell& drawn = scene_.cells()[cell];
  const double cosine = std::cos(drawn.angle_rad);
  const double sine = std::sin(drawn.angle_rad);
  QPolygonF polygon;
  polygon.reserve(6);
  for (const QPointF& corner : scene_.outline()) {
    polygon << camera_.toScreen(
        drawn.center + QPointF(cosine * corner.x() - sine * corner.y(), sine * corner.x() + cosine * corner.y()));
  }
  return polygon;
}

QPen GraphPainter::pen(const LinkStroke& stroke, double width) const {
  QPen pen(stroke.color, width);
  pen.setCapStyle(Qt::FlatCap);
  // Patterns in pen widths; those of Qt are too coarse for the short way between two hexagons.
  if (radius_px_ >= kStyleRadius && stroke.style == Qt::DashLine) pen.setDashPattern({2.6, 1.3});
  if (radius_px_ >= kStyleRadius && stroke.style == Qt::DotLine) pen.setDashPattern({1.0, 1.2});
  return pen;
}

/// The two directed edges of a link, or one line where both would fall together.
void GraphPainter::addDirections(const QPointF& a, const QPointF& b, QVector<QLineF>& lines) const {
  if (separation_px_ < 1.6) {
    lines.append(QLineF(a, b));
    return;
  }
  const QPointF aside = 0.5 * separation_px_ * normalOf(a, b);
  lines.append(QLineF(a + aside, b + aside));
  lines.append(QLineF(b - aside, a - aside));
}

void GraphPainter::drawStrokes(QPainter& painter, const QVector<QLineF>& lines, const LinkStroke& stroke,
                               bool in_tree) const {
  if (lines.isEmpty()) return;
  double width = std::clamp(0.14 * radius_px_, 1.0, 4.5);
  if (in_tree) width *= 1.35;
  const bool doubled = stroke.doubled && radius_px_ >= kStyleRadius;
  if (doubled) width *= 1.5;
  painter.setPen(pen(stroke, width));
  painter.drawLines(lines);
  if (doubled) {
    painter.setPen(QPen(colors_.panel, 0.36 * width, Qt::SolidLine, Qt::FlatCap));
    painter.drawLines(lines);
  }
}

void GraphPainter::drawLinks(QPainter& painter) const {
  // One call per kind of line: 8 pens instead of tens of thousands.
  std::array<std::array<QVector<QLineF>, 2>, 4> lines;
  for (const GraphScene::Link& link : scene_.links()) {
    const QPointF source = camera_.toScreen(scene_.cells()[link.source].center);
    const QPointF target = camera_.toScreen(scene_.cells()[link.target].center);
    if (!isSeen(source, target)) continue;
    if (!link.estimate->used) {
      drawMutedLink(painter, link);
      continue;
    }
    QVector<QLineF>& group =
        lines.at(static_cast<std::size_t>(link.estimate->quality)).at(link.estimate->in_tree ? 1 : 0);
    const QPointF from = camera_.toScreen(link.from);
    const QPointF to = camera_.toScreen(link.to);
    if (link.cut) {
      addDirections(source, from, group);
      addDirections(target, to, group);
    } else {
      addDirections(source, target, group);
    }
  }
  for (const EdgeQuality quality :
       {EdgeQuality::Fully, EdgeQuality::Over, EdgeQuality::Partially, EdgeQuality::Undefined}) {
    for (const bool in_tree : {false, true}) {
      drawStrokes(painter, lines.at(static_cast<std::size_t>(quality)).at(in_tree ? 1 : 0), linkStroke(quality, theme_),
                  in_tree);
    }
  }
}

void GraphPainter::drawMutedLink(QPainter& painter, const GraphScene::Link& link) const {
  const QPointF source = camera_.toScreen(scene_.cells()[link.source].center);
  const QPointF target = camera_.toScreen(scene_.cells()[link.target].center);
  const QPointF from = camera_.toScreen(link.from);
  const QPointF to = camera_.toScreen(link.to);
  const double gap = std::hypot(to.x() - from.x(), to.y() - from.y());
  const bool apart = gap > 1.5 * radius_px_;
  QVector<QLineF> lines;
  const QPen solid(colors_.muted_link, std::clamp(0.11 * radius_px_, 1.0, 3.0), Qt::SolidLine, Qt::FlatCap);
  painter.setPen(solid);
  if (apart) {
    addDirections(source, from, lines);
    addDirections(to, target, lines);
    painter.drawLines(lines);
    QPen dashed(colors_.muted_link, 1.0);
    dashed.setDashPattern({4, 4});
    painter.setPen(dashed);
    painter.drawLine(from, to);
  } else {
    addDirections(source, target, lines);
    painter.drawLines(lines);
  }
  if (radius_px_ < kOutlineRadius) return;
  const QPointF middle = 0.5 * (from + to);
  const double arm = std::clamp(0.36 * radius_px_, 2.5, 11.0);
  painter.setPen(QPen(colors_.text_muted, std::clamp(0.13 * radius_px_, 1.2, 3.0), Qt::SolidLine, Qt::RoundCap));
  painter.drawLine(middle + QPointF(-arm, -arm), middle + QPointF(arm, arm));
  painter.drawLine(middle + QPointF(-arm, arm), middle + QPointF(arm, -arm));
}

void GraphPainter::drawCutCurves(QPainter& painter) const {
  QPen dashed(colors_.muted_link, 1.0);
  dashed.setDashPattern({3, 4});
  painter.setPen(dashed);
  painter.setBrush(Qt::NoBrush);
  for (const GraphScene::Link& link : scene_.links()) {
    if (link.cut) painter.drawPath(cutCurve(link));
  }
}

/// From one end of a cut link to the other, around the outside.
QPainterPath GraphPainter::cutCurve(const GraphScene::Link& link) const {
  const QPointF from = camera_.toScreen(link.from);
  const QPointF to = camera_.toScreen(link.to);
  const double bulge = 0.15 * std::hypot(to.x() - from.x(), to.y() - from.y());
  const QPointF start = scene_.directionFrom(link.source, link);
  const QPointF end = scene_.directionFrom(link.target, link);
  QPointF aside = normalOf(from, to);
  const QPointF middle = camera_.toScreen(scene_.bounds().center());
  if (QPointF::dotProduct(aside, 0.5 * (from + to) - middle) < 0) aside = -aside;
  QPainterPath path(from);
  path.cubicTo(from + bulge * (QPointF(start.x(), -start.y()) + aside),
               to + bulge * (QPointF(end.x(), -end.y()) + aside), to);
  return path;
}

void GraphPainter::drawCells(QPainter& painter) const {
  const double width = std::clamp(0.09 * radius_px_, 0.8, 2.0);
  const bool with_outline = radius_px_ >= kOutlineRadius;
  const QPen plain(colors_.text_muted, width);
  const QPen origin(colors_.selection, std::max(1.6, 1.9 * width));
  QPen by_links(colors_.text_muted, width);
  by_links.setDashPattern({2.5, 2});
  const QBrush fill(with_outline ? colors_.cell_fill : colors_.text_muted);
  painter.setPen(with_outline ? plain : QPen(Qt::NoPen));
  painter.setBrush(fill);
  for (std::size_t k = 0; k < scene_.cells().size(); ++k) {
    const GraphScene::Cell& cell = scene_.cells()[k];
    const QPointF center = camera_.toScreen(cell.center);
    if (!seen_.contains(center)) continue;
    const bool special = with_outline && (cell.origin || cell.placed_by_links);
    if (special) painter.setPen(cell.origin ? origin : by_links);
    if (with_outline) {
      painter.drawConvexPolygon(hexagon(k));
    } else if (cell.origin) {
      painter.fillRect(QRectF(center - QPointF(2.5, 2.5), QSizeF(5, 5)), colors_.selection);
    } else {
      const double half = std::max(0.5, 0.85 * radius_px_);
      painter.fillRect(QRectF(center - QPointF(half, half), QSizeF(2 * half, 2 * half)), fill);
    }
    if (special) painter.setPen(plain);
  }
}

void GraphPainter::drawIds(QPainter& painter) const {
  const auto digits = static_cast<double>(scene_.longestId());
  const double pixels = std::min({0.8 * radius_px_, 1.6 * radius_px_ / (0.62 * digits), 24.0});
  if (pixels < 6) return;
  QFont font = font_;
  font.setPixelSize(static_cast<int>(pixels));
  QFont starred = font;  // the star needs room, too
  starred.setPixelSize(static_cast<int>(std::min(pixels, 1.62 * radius_px_ / (0.62 * digits + 1.0))));
  painter.setPen(colors_.text);
  for (const GraphScene::Cell& cell : scene_.cells()) {
    const QPointF center = camera_.toScreen(cell.center);
    if (!seen_.contains(center)) continue;
    const QRectF box(center - QPointF(2 * radius_px_, radius_px_), QSizeF(4 * radius_px_, 2 * radius_px_));
    const QString id = QString::number(cell.id.value());
    painter.setFont(cell.origin ? starred : font);
    painter.drawText(box, Qt::AlignCenter, cell.origin ? id + QStringLiteral("★") : id);
  }
}

/// Port numbers where a link leaves its cell: for those who look closely.
void GraphPainter::drawPorts(QPainter& painter) const {
  QFont font = font_;
  font.setPixelSize(static_cast<int>(std::clamp(0.3 * radius_px_, 9.0, 13.0)));
  painter.setFont(font);
  painter.setPen(colors_.text_muted);
  const auto draw = [&](std::size_t cell, const GraphScene::Link& link, PortNumber port) {
    const QPointF direction = scene_.directionFrom(cell, link);
    const QPointF place =
        camera_.toScreen(scene_.cells()[cell].center) + 0.66 * radius_px_ * QPointF(direction.x(), -direction.y());
    painter.drawText(QRectF(place - QPointF(12, 10), QSizeF(24, 20)), Qt::AlignCenter, QString::number(port.value()));
  };
  for (const GraphScene::Link& link : scene_.links()) {
    if (seen_.contains(camera_.toScreen(link.from))) draw(link.source, link, link.estimate->source.port);
    if (seen_.contains(camera_.toScreen(link.to))) draw(link.target, link, link.estimate->target.port);
  }
}

void GraphPainter::drawCutMarks(QPainter& painter) const {
  QFont font = font_;
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
  QFont font = font_;
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

void GraphPainter::drawCellOutline(QPainter& painter, std::size_t cell, const QColor& color, double width) const {
  const QPointF center = camera_.toScreen(scene_.cells()[cell].center);
  painter.setBrush(Qt::NoBrush);
  painter.setPen(QPen(color, width, Qt::SolidLine, Qt::SquareCap, Qt::MiterJoin));
  if (radius_px_ >= 5) {
    painter.drawPolygon(hexagon(cell));
  } else {
    // A ring around a dot can be found; an outlined dot can't.
    painter.drawEllipse(center, 6.5, 6.5);
  }
}

void GraphPainter::drawLinkOutline(QPainter& painter, std::size_t link, const QColor& color, double width) const {
  const GraphScene::Link& drawn = scene_.links()[link];
  painter.setBrush(Qt::NoBrush);
  painter.setPen(QPen(color, width, Qt::SolidLine, Qt::SquareCap, Qt::MiterJoin));
  const double half = std::max(4.0, 0.5 * separation_px_ + std::clamp(0.3 * radius_px_, 2.5, 10.0));
  const auto outline = [&](const QPointF& a, const QPointF& b) {
    const QPointF aside = half * normalOf(a, b);
    painter.drawPolygon(QPolygonF({a + aside, b + aside, b - aside, a - aside}));
  };
  const auto edgeOf = [&](std::size_t cell) {
    const QPointF direction = scene_.directionFrom(cell, drawn);
    return camera_.toScreen(scene_.cells()[cell].center) + radius_px_ * QPointF(direction.x(), -direction.y());
  };
  const QPointF from = camera_.toScreen(drawn.from);
  const QPointF to = camera_.toScreen(drawn.to);
  const bool apart = std::hypot(to.x() - from.x(), to.y() - from.y()) > 1.5 * radius_px_;
  if (drawn.cut || apart) {
    outline(edgeOf(drawn.source), from);
    outline(edgeOf(drawn.target), to);
    painter.setPen(QPen(color, 1.0, Qt::DashLine));
    if (drawn.cut) {
      painter.drawPath(cutCurve(drawn));
    } else {
      painter.drawLine(from, to);
    }
  } else {
    outline(edgeOf(drawn.source), edgeOf(drawn.target));
  }
}

}  // namespace hexoderm
