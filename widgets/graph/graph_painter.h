#pragma once

#include "hexoderm/base/units.h"
#include "widgets/graph/graph_paint.h"
#include "widgets/graph/graph_scene.h"
#include "widgets/style/palette.h"

#include <QCoreApplication>
#include <QFont>
#include <QFontMetricsF>
#include <QImage>
#include <QPainter>
#include <QPainterPath>
#include <QPolygonF>
#include <algorithm>
#include <cmath>
#include <map>
#include <tuple>

namespace hexoderm {

/// The style that a graph is drawn in, on the screen and in files.
struct GraphStyle {
  Theme theme = Theme::Light;
  QFont font;
  bool marks_tree = true;
  bool has_text = true;    ///< IDs, ports, captions; pictures that are compared go without
  bool is_vector = false;  ///< everything is a shape of its own, as files that can be enlarged want it
};

/// Draws a GraphScene with a level of detail that follows the size of the hexagons on the screen, and how many of them
/// there are: thousands are drawn from one stamp, without smoothing.
class GraphPainter {
 public:
  /// All must outlive the painter.
  GraphPainter(const GraphScene& scene, const GraphPaint& paint, const GraphCamera& camera, const GraphStyle& style)
      : scene_(scene),
        paint_(paint),
        camera_(camera),
        style_(style),
        colors_(Colors::of(style.theme)),
        radius_px_(scene.radius_m() * camera.scale),
        separation_px_(std::clamp(0.32 * radius_px_, 0.0, 14.0)) {
    const double margin = 3 * radius_px_;
    seen_ = QRectF(QPointF(0, 0), camera.size).adjusted(-margin, -margin, margin, margin);
    const auto seen = std::ranges::count_if(
        scene.cells(), [this](const GraphScene::Cell& cell) { return seen_.contains(camera_.toScreen(cell.center)); });
    is_crowded_ = !style.is_vector && static_cast<std::size_t>(seen) > kCrowd;
  }

  /// Everything but what is picked and pointed at.
  void drawSheet(QPainter& painter) const {
    // Without smoothing a large skin is drawn several times faster, and at that size nobody sees the difference.
    const bool smooth = radius_px_ >= kOutlineRadius && !is_crowded_;
    painter.setRenderHint(QPainter::Antialiasing, smooth);
    if (style_.marks_tree && smooth) drawTree(painter);
    if (dotsAreUnderLinks()) drawDots(painter);
    drawLinks(painter);
    drawExcludedLinks(painter);
    painter.setRenderHint(QPainter::Antialiasing, true);
    if (scene_.cutCount() <= kMaxCutCurves) drawCutCurves(painter);
    painter.setRenderHint(QPainter::Antialiasing, smooth);
    drawCells(painter);
    painter.setRenderHint(QPainter::Antialiasing, true);
    if (!style_.has_text) return;
    if (radius_px_ >= kIdRadius) {
      drawIds(painter);
      drawCutMarks(painter);
    }
    if (radius_px_ >= kPortRadius) drawPorts(painter);
    if (scene_.patches().size() > 1) drawPatchCaptions(painter);
  }

  void drawCellOutline(QPainter& painter, std::size_t cell, const QColor& color, double width) const {
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

  void drawLinkOutline(QPainter& painter, std::size_t link, const QColor& color, double width) const {
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

  /// A hexagon inside the cell's own, in black or white, whichever is seen on its colour.
  void drawBrushMark(QPainter& painter, std::size_t cell) const {
    const GraphScene::Cell& drawn = scene_.cells()[cell];
    const QPointF center = camera_.toScreen(drawn.center);
    if (!seen_.contains(center)) return;
    if (radius_px_ < 5) {
      painter.fillRect(QRectF(center - QPointF(2, 2), QSizeF(4, 4)), colors_.selection);
      return;
    }
    constexpr double kInside = 0.68;  // around an ID
    QPolygonF ring = hexagon(cell);
    for (QPointF& corner : ring) corner = center + kInside * (corner - center);
    painter.setBrush(Qt::NoBrush);
    painter.setPen(QPen(textOn(fillOf(cell)), std::clamp(0.12 * radius_px_, 1.2, 3.0), Qt::SolidLine, Qt::SquareCap,
                        Qt::MiterJoin));
    painter.drawPolygon(ring);
  }

  /// The area of these outlines, so that nothing else needs to be drawn anew.
  [[nodiscard]] QRectF outlineBounds(std::size_t cell) const {
    const double reach = std::max(radius_px_, 7.0) + 5;
    return QRectF(camera_.toScreen(scene_.cells()[cell].center) - QPointF(reach, reach), QSizeF(2 * reach, 2 * reach));
  }

  [[nodiscard]] QRectF linkOutlineBounds(std::size_t link) const {
    const GraphScene::Link& drawn = scene_.links()[link];
    if (drawn.cut) return {QPointF(0, 0), camera_.size};  // its curve swings wide
    return outlineBounds(drawn.source) | outlineBounds(drawn.target) |
           QRectF(camera_.toScreen(drawn.from), camera_.toScreen(drawn.to)).normalized().adjusted(-12, -12, 12, 12);
  }

 private:
  /// A cell's looks: its fill and whether it is the origin or was placed by its links.
  struct CellKind {
    std::int16_t fill = GraphPaint::kPlain;
    bool origin = false;
    bool by_links = false;
  };

  [[nodiscard]] bool isSeen(const QPointF& a, const QPointF& b) const {
    return std::max(a.x(), b.x()) >= seen_.left() && std::min(a.x(), b.x()) <= seen_.right() &&
           std::max(a.y(), b.y()) >= seen_.top() && std::min(a.y(), b.y()) <= seen_.bottom();
  }

  /// The lines that a link is drawn as, if it is seen: one, or of a cut one a stub at each end.
  template <class Draw>
  void forEachPiece(const GraphScene::Link& link, Draw draw) const {
    const QPointF source = camera_.toScreen(scene_.cells()[link.source].center);
    const QPointF target = camera_.toScreen(scene_.cells()[link.target].center);
    if (!isSeen(source, target)) return;
    if (!link.cut) return draw(source, target);
    draw(source, camera_.toScreen(link.from));
    draw(target, camera_.toScreen(link.to));
  }

  [[nodiscard]] QPolygonF hexagon(const QPointF& center, double angle_rad) const {
    const double cosine = camera_.scale * std::cos(angle_rad);
    const double sine = camera_.scale * std::sin(angle_rad);
    QPolygonF polygon;
    polygon.reserve(6);
    for (const QPointF& corner : scene_.outline()) {
      polygon << center + QPointF(cosine * corner.x() - sine * corner.y(), -sine * corner.x() - cosine * corner.y());
    }
    return polygon;
  }

  [[nodiscard]] QPolygonF hexagon(std::size_t cell) const {
    const GraphScene::Cell& drawn = scene_.cells()[cell];
    return hexagon(camera_.toScreen(drawn.center), drawn.angle_rad);
  }

  [[nodiscard]] CellKind kindOf(std::size_t cell) const {
    const GraphScene::Cell& drawn = scene_.cells()[cell];
    return {paint_.of_cell[cell], drawn.origin, drawn.placed_by_links};
  }

  [[nodiscard]] QColor fillColor(std::int16_t fill) const {
    return fill == GraphPaint::kPlain ? colors_.cell_fill : paint_.fills[static_cast<std::size_t>(fill)];
  }

  [[nodiscard]] QColor fillOf(std::size_t cell) const { return fillColor(paint_.of_cell[cell]); }

  void choosePens(QPainter& painter, const CellKind& kind) const {
    const double width = std::clamp(0.09 * radius_px_, 0.8, 2.0);
    QPen pen(colors_.text_muted, width);
    if (kind.origin) {
      pen = QPen(colors_.selection, std::max(1.6, 1.9 * width));
    } else if (kind.by_links) {
      pen.setDashPattern({2.5, 2});
    }
    painter.setPen(pen);
    painter.setBrush(fillColor(kind.fill));
  }

  void drawLinks(QPainter& painter) const {
    // One call per kind of line: a few pens instead of tens of thousands.
    std::vector<QVector<QLineF>> lines(paint_.strokes.size());
    QVector<QLineF> plain;
    const bool thin = radius_px_ < kOutlineRadius || is_crowded_;
    const auto add = [&](const QPointF& a, const QPointF& b, bool in_tree, QVector<QLineF>& group) {
      if (!thin) {
        addDirections(a, b, group);
        return;
      }
      group.append(QLineF(a, b));
      // If no band fits, the tree's links are a pixel wider.
      if (in_tree && style_.marks_tree && radius_px_ >= kOutlineRadius) {
        group.append(QLineF(a, b).translated(0, 1));
      }
    };
    for (std::size_t k = 0; k < scene_.links().size(); ++k) {
      const GraphScene::Link& link = scene_.links()[k];
      if (!link.estimate->used) continue;
      const std::int16_t kind = paint_.of_link[k];
      QVector<QLineF>& group = kind == GraphPaint::kPlain ? plain : lines[static_cast<std::size_t>(kind)];
      forEachPiece(link, [&](const QPointF& a, const QPointF& b) { add(a, b, link.estimate->in_tree, group); });
    }
    if (!plain.isEmpty()) {
      const double width = std::clamp(0.1 * radius_px_, 1.0, 3.0);
      painter.setPen(QPen(colors_.excluded_link, thin ? 1.0 : width, Qt::SolidLine, Qt::FlatCap));
      painter.drawLines(plain);
    }
    for (std::size_t k = 0; k < lines.size(); ++k) drawStrokes(painter, lines[k], paint_.strokes[k]);
  }

  /// A pale band under both directions of a link that is on the shortest-path tree.
  void drawTree(QPainter& painter) const {
    if (radius_px_ < kStyleRadius) return;
    QVector<QLineF> lines;
    for (const GraphScene::Link& link : scene_.links()) {
      if (!link.estimate->used || !link.estimate->in_tree) continue;
      forEachPiece(link, [&](const QPointF& a, const QPointF& b) { lines.append(QLineF(a, b)); });
    }
    painter.setPen(QPen(colors_.tree_band, 0.98 * radius_px_, Qt::SolidLine, Qt::FlatCap));
    painter.drawLines(lines);
  }

  void drawStrokes(QPainter& painter, const QVector<QLineF>& lines, const LinkStroke& stroke) const {
    if (lines.isEmpty()) return;
    if (radius_px_ < kOutlineRadius || is_crowded_) {
      // Lines without smoothing, one pixel wide: Qt has a way of its own for these, many times as fast as any other.
      painter.setPen(QPen(stroke.color, 1, Qt::SolidLine, Qt::FlatCap));
      painter.drawLines(lines);
      return;
    }
    double width = std::clamp(0.16 * radius_px_, 1.0, 5.0);
    const bool styled = radius_px_ >= kStyleRadius;
    if (paint_.scale && styled) {
      // One end of the scale is hardly seen on a light ground, the other on a dark one.
      width *= 1.2;
      painter.setPen(QPen(colors_.text_muted, width + 1.2, Qt::SolidLine, Qt::FlatCap));
      painter.drawLines(lines);
    }
    const bool doubled = stroke.doubled && styled;
    if (doubled) width *= 1.5;
    painter.setPen(styled ? strokePen(stroke, width) : QPen(stroke.color, width, Qt::SolidLine, Qt::FlatCap));
    painter.drawLines(lines);
    if (doubled) {
      painter.setPen(QPen(colors_.panel, 0.36 * width, Qt::SolidLine, Qt::FlatCap));
      painter.drawLines(lines);
    }
  }

  /// Grey and crossed. Between cells that lie far apart, a thin line says what belongs together.
  void drawExcludedLinks(QPainter& painter) const {
    if (!scene_.hasExcludedLinks()) return;
    QVector<QLineF> links;
    QVector<QLineF> between;
    QVector<QLineF> crosses;
    const double arm = std::clamp(0.36 * radius_px_, 2.5, 11.0);
    for (const GraphScene::Link& link : scene_.links()) {
      if (link.estimate->used) continue;
      const QPointF source = camera_.toScreen(scene_.cells()[link.source].center);
      const QPointF target = camera_.toScreen(scene_.cells()[link.target].center);
      if (!isSeen(source, target)) continue;
      const QPointF from = camera_.toScreen(link.from);
      const QPointF to = camera_.toScreen(link.to);
      if (std::hypot(to.x() - from.x(), to.y() - from.y()) > 1.5 * radius_px_) {
        addDirections(source, from, links);
        addDirections(to, target, links);
        between.append(QLineF(from, to));
      } else {
        addDirections(source, target, links);
      }
      const QPointF middle = 0.5 * (from + to);
      crosses.append(QLineF(middle + QPointF(-arm, -arm), middle + QPointF(arm, arm)));
      crosses.append(QLineF(middle + QPointF(-arm, arm), middle + QPointF(arm, -arm)));
    }
    const bool thin = radius_px_ < kOutlineRadius || is_crowded_;
    const auto width = [thin](double pixels) { return thin ? 1.0 : pixels; };
    painter.setPen(
        QPen(colors_.excluded_link, width(std::clamp(0.11 * radius_px_, 1.0, 3.0)), Qt::SolidLine, Qt::FlatCap));
    painter.drawLines(links);
    QPen dashed(colors_.excluded_link, 1.0);
    dashed.setDashPattern({4, 4});
    painter.setPen(dashed);
    painter.drawLines(between);
    if (radius_px_ < kOutlineRadius) return;
    painter.setPen(
        QPen(colors_.text_muted, width(std::clamp(0.13 * radius_px_, 1.2, 3.0)), Qt::SolidLine, Qt::RoundCap));
    painter.drawLines(crosses);
  }

  void drawCutCurves(QPainter& painter) const {
    QPen dashed(colors_.excluded_link, 1.0);
    dashed.setDashPattern({3, 4});
    painter.setPen(dashed);
    painter.setBrush(Qt::NoBrush);
    for (const GraphScene::Link& link : scene_.links()) {
      if (link.cut) painter.drawPath(cutCurve(link));
    }
  }

  /// From one end of a cut link to the other, around the outside.
  [[nodiscard]] QPainterPath cutCurve(const GraphScene::Link& link) const {
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

  void drawCells(QPainter& painter) const {
    if (radius_px_ < kOutlineRadius) {
      if (!dotsAreUnderLinks()) drawDots(painter);
      drawOriginsAsDots(painter);
    } else if (is_crowded_) {
      drawStamps(painter);
    } else {
      for (std::size_t k = 0; k < scene_.cells().size(); ++k) {
        if (!seen_.contains(camera_.toScreen(scene_.cells()[k].center))) continue;
        choosePens(painter, kindOf(k));
        painter.drawConvexPolygon(hexagon(k));
      }
    }
  }

  /// Where links have the colours, and there is no room beside the cells.
  [[nodiscard]] bool dotsAreUnderLinks() const {
    return radius_px_ < kDotRadius && coloringRow(paint_.coloring).colors_links;
  }

  void drawDots(QPainter& painter) const {
    const bool filled = !coloringRow(paint_.coloring).colors_links;
    // Colours of cells want to be seen, those of links between the cells, too.
    const double half = std::max(0.5, (filled ? 1.3 : 0.85) * radius_px_);
    for (std::size_t k = 0; k < scene_.cells().size(); ++k) {
      const QPointF center = camera_.toScreen(scene_.cells()[k].center);
      if (!seen_.contains(center)) continue;
      const QRectF dot(center - QPointF(half, half), QSizeF(2 * half, 2 * half));
      painter.fillRect(dot, filled && paint_.of_cell[k] != GraphPaint::kPlain ? fillOf(k) : colors_.text_muted);
    }
  }

  void drawOriginsAsDots(QPainter& painter) const {
    for (const GraphScene::Cell& cell : scene_.cells()) {
      if (!cell.origin) continue;
      painter.fillRect(QRectF(camera_.toScreen(cell.center) - QPointF(2.5, 2.5), QSizeF(5, 5)), colors_.selection);
    }
  }

  void drawStamps(QPainter& painter) const {
    // A hexagon looks the same after a sixth of a turn, and nobody sees a degree.
    constexpr double kSixth_deg = 60;
    const double ratio = painter.device() != nullptr ? painter.device()->devicePixelRatioF() : 1.0;
    std::map<std::tuple<int, int, bool, bool>, QImage> stamps;
    for (std::size_t k = 0; k < scene_.cells().size(); ++k) {
      const GraphScene::Cell& cell = scene_.cells()[k];
      const QPointF center = camera_.toScreen(cell.center);
      if (!seen_.contains(center)) continue;
      const CellKind kind = kindOf(k);
      const int angle_deg =
          static_cast<int>(std::lround(std::remainder(cell.angle_rad / kDegree, kSixth_deg) + kSixth_deg)) %
          static_cast<int>(kSixth_deg);
      QImage& image = stamps[{kind.fill, angle_deg, kind.origin, kind.by_links}];
      if (image.isNull()) image = stamp(kind, angle_deg * kDegree, ratio);
      const double half = 0.5 * image.width() / ratio;
      painter.drawImage(center - QPointF(half, half), image);
    }
  }

  [[nodiscard]] QImage stamp(const CellKind& kind, double angle_rad, double pixel_ratio) const {
    const int side = 2 * static_cast<int>(std::ceil((radius_px_ + 2) * pixel_ratio)) + 1;
    QImage image(side, side, QImage::Format_ARGB32_Premultiplied);
    image.setDevicePixelRatio(pixel_ratio);
    image.fill(Qt::transparent);
    QPainter painter(&image);
    painter.setRenderHint(QPainter::Antialiasing);
    choosePens(painter, kind);
    const double middle = 0.5 * side / pixel_ratio;
    painter.drawConvexPolygon(hexagon(QPointF(middle, middle), angle_rad));
    return image;
  }

  void drawIds(QPainter& painter) const {
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
  void drawPorts(QPainter& painter) const {
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

  void drawCutMarks(QPainter& painter) const {
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

  void drawPatchCaptions(QPainter& painter) const {
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

  /// The two directed edges of a link, or one line where both would fall together.
  void addDirections(const QPointF& a, const QPointF& b, QVector<QLineF>& lines) const {
    if (separation_px_ < 1.6) {
      lines.append(QLineF(a, b));
      return;
    }
    const QPointF aside = 0.5 * separation_px_ * normalOf(a, b);
    lines.append(QLineF(a + aside, b + aside));
    lines.append(QLineF(b - aside, a - aside));
  }

  const GraphScene& scene_;
  const GraphPaint& paint_;
  const GraphCamera& camera_;
  const GraphStyle& style_;
  const Colors& colors_;
  double radius_px_;      ///< radius of a drawn hexagon
  double separation_px_;  ///< between the two directions of a link
  QRectF seen_;           ///< the widget with a margin
  bool is_crowded_;       ///< so many are seen that each must be cheap

  // From these radii of a hexagon on (pixels), details are drawn.
  /// Below, dots would hide the links between them.
  static constexpr double kDotRadius = 1.5;
  static constexpr double kOutlineRadius = 2.5;
  static constexpr double kStyleRadius = 4.0;
  static constexpr double kIdRadius = 8.0;
  static constexpr double kPortRadius = 26.0;
  /// More cells than this in view are drawn by simpler means.
  static constexpr std::size_t kCrowd = 1500;

  /// Curves between the ends of cuts help while there are few.
  static constexpr std::size_t kMaxCutCurves = 4;

  static QPointF normalOf(const QPointF& a, const QPointF& b) {
    const QPointF along = b - a;
    const double length = std::hypot(along.x(), along.y());
    return length > 0 ? QPointF(-along.y(), along.x()) / length : QPointF();
  }
};

}  // namespace hexoderm
