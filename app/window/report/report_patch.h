#pragma once

#include "app/window/report/report_blocks.h"
#include "app/window/report/report_plots.h"
#include "hexoderm/base/units.h"
#include "hexoderm/solve/metrics/distribution.h"
#include "hexoderm/solve/metrics/patch_mesh.h"
#include "hexoderm/solve/metrics/patch_sides.h"
#include "hexoderm/solve/result/reconstruction.h"
#include "widgets/style/palette.h"

#include <QCoreApplication>
#include <QFontMetricsF>
#include <QLocale>
#include <QPainter>
#include <QPainterPath>
#include <QPolygonF>
#include <QString>
#include <algorithm>
#include <array>
#include <cmath>
#include <memory>
#include <optional>
#include <utility>
#include <vector>

namespace hexoderm {

/// The values that the cells of a patch are coloured by, in the unit of the axis, in the order of its cells.
struct PatchColoring {
  QString axis;                               ///< "uncertainty of the shape (95 %), mm"
  bool is_of_shape = false;                   ///< else relative to the origin
  std::vector<std::optional<double>> values;  ///< absent where none is stated
  Distribution distribution;                  ///< of those that are; its ends are those of the scale
  std::optional<std::size_t> worst;           ///< the cell with the largest
};

struct ReportPatch {
  Q_DECLARE_TR_FUNCTIONS(hexoderm::ReportPatch)
};

inline constexpr double kSideAspect = 0.68;
// In points.
inline constexpr double kPadding = 6;
inline constexpr double kFooting = 20;  ///< room for the scale bar
inline constexpr double kSmallestId = 4.2;
inline constexpr double kLargestId = 8;
/// A larger patch is drawn without the walls of its cells, which nobody would see.
inline constexpr std::size_t kMaxPrisms = 1500;
/// A still larger one as pixels: a document of so many shapes opens slowly.
inline constexpr std::size_t kMaxShapes = 4000;
inline constexpr double kPictureDpi = 300;
/// A face that is seen more from the side than this has no ID.
inline constexpr double kFacing = 0.3;
inline constexpr std::size_t kCorners = 6;

/// A cell as it is seen from one side, in metres on the paper.
struct PrintedCell {
  std::size_t index = 0;
  std::array<QPointF, 2 * kCorners> corners;  ///< front, then back, y down
  QPointF middle;
  double depth = 0;   ///< towards the viewer
  double facing = 0;  ///< cosine of the angle between the face's normal and the viewer's direction
};

using PrintedSide = std::vector<PrintedCell>;

inline PrintedSide seenFrom(const PatchReconstruction& patch, const CellModel& model, const Eigen::Matrix3d& R_v_o) {
  PrintedSide seen(patch.cells.size());
  for (std::size_t k = 0; k < seen.size(); ++k) {
    const SE3& T = patch.cells[k].T_o_u;
    const auto flat = [&](const Eigen::Vector3d& x_o) {
      const Eigen::Vector3d x = R_v_o * x_o;
      return QPointF(x.x(), -x.y());
    };
    const std::array<Eigen::Vector3d, 2 * kCorners> corners = prismCorners(model, T);
    for (std::size_t c = 0; c < corners.size(); ++c) seen[k].corners.at(c) = flat(corners.at(c));
    seen[k].index = k;
    seen[k].middle = flat(T.t);
    seen[k].depth = (R_v_o * T.t).z();
    seen[k].facing = (R_v_o * T.R.col(2)).z();
  }
  std::ranges::stable_sort(seen, {}, &PrintedCell::depth);
  return seen;
}

inline QRectF boundsOf(const PrintedSide& side) {
  QRectF bounds;
  for (const PrintedCell& cell : side) {
    for (const QPointF& corner : cell.corners) {
      if (bounds.isNull()) bounds = QRectF(corner, QSizeF(1e-9, 1e-9));
      bounds.setLeft(std::min(bounds.left(), corner.x()));
      bounds.setRight(std::max(bounds.right(), corner.x()));
      bounds.setTop(std::min(bounds.top(), corner.y()));
      bounds.setBottom(std::max(bounds.bottom(), corner.y()));
    }
  }
  return bounds;
}

/// Signed area: of a polygon that is seen from its front it is negative, as y goes down.
inline bool isSeenFromFront(const QPolygonF& polygon) {
  double twice = 0;
  for (int k = 0; k < polygon.size(); ++k) {
    const QPointF& a = polygon[k];
    const QPointF& b = polygon[(k + 1) % polygon.size()];
    twice += a.x() * b.y() - b.x() * a.y();
  }
  return twice < 0;
}

/// The longest of 1, 2, 5, 10 ... mm that is no longer.
inline double barLength(double most_m) {
  double length = kMillimetre;
  for (double decade = kMillimetre;; decade *= 10) {
    for (const double step : {1.0, 2.0, 5.0}) {
      if (step * decade > most_m) return length;
      length = step * decade;
    }
  }
}

/// What all four drawings have in common.
struct PatchPicture {
  std::shared_ptr<const Reconstruction> reconstruction;
  std::size_t patch = 0;
  PatchColoring coloring;
  std::array<Eigen::Matrix3d, 4> R_v_o;
  std::array<PrintedSide, 4> sides;
  QSizeF extent;  ///< of the largest side, metres

  [[nodiscard]] const PatchReconstruction& shown() const { return reconstruction->patches[patch]; }
};

class SidePainter {
 public:
  SidePainter(const PatchPicture& picture, std::size_t side, QPainter& painter, const QRectF& area, double point)
      : picture_(picture),
        side_(picture.sides.at(side)),
        R_v_o_(picture.R_v_o.at(side)),
        painter_(painter),
        area_(area),
        point_(point),
        colors_(Colors::of(Theme::Light)) {
    const QRectF room = area.adjusted(kPadding * point, kPadding * point, -kPadding * point, -kFooting * point);
    scale_ = std::min(room.width() / picture.extent.width(), room.height() / picture.extent.height());
    shift_ = room.center() - scale_ * boundsOf(side_).center();
    apothem_ = picture.reconstruction->model->side_m * std::sqrt(3.0) / 2 * scale_;
  }

  void draw() {
    painter_.setPen(QPen(colors_.border, 0.5 * point_));
    painter_.setBrush(Qt::NoBrush);
    painter_.drawRect(area_);
    painter_.save();
    painter_.setClipRect(area_);
    for (const PrintedCell& cell : side_) drawCell(cell);
    for (const PrintedCell& cell : side_) markCell(cell);
    painter_.restore();
    drawScaleBar();
    drawAxes();
  }

 private:
  [[nodiscard]] QPointF at(const QPointF& flat_m) const { return scale_ * flat_m + shift_; }
  [[nodiscard]] bool isWorst(const PrintedCell& cell) const {
    return picture_.coloring.worst && *picture_.coloring.worst == cell.index && picture_.shown().cells.size() > 1;
  }
  [[nodiscard]] const CellPlacement& placement(const PrintedCell& cell) const {
    return picture_.shown().cells[cell.index];
  }
  [[nodiscard]] bool isOrigin(const PrintedCell& cell) const { return placement(cell).cell == picture_.shown().origin; }

  [[nodiscard]] QColor faceColor(const PrintedCell& cell) const {
    const std::optional<double>& value = picture_.coloring.values[cell.index];
    if (!value) return Qt::white;
    const Distribution& scale = picture_.coloring.distribution;
    return reportScale((*value - scale.lower()) / (scale.upper() - scale.lower()));
  }

  [[nodiscard]] QPolygonF frontOf(const PrintedCell& cell) const {
    QPolygonF polygon;
    for (std::size_t k = 0; k < kCorners; ++k) polygon << at(cell.corners.at(k));
    return polygon;
  }

  void drawCell(const PrintedCell& cell) {
    const QColor edge = colors_.text_muted;
    painter_.setPen(QPen(edge, std::clamp(apothem_ * 0.05, 0.1 * point_, 0.5 * point_), Qt::SolidLine, Qt::RoundCap,
                         Qt::RoundJoin));
    const bool walls = side_.size() <= kMaxPrisms;
    const QColor grey(214, 214, 216);
    for (std::size_t k = 0; walls && k < kCorners; ++k) {
      const std::size_t next = (k + 1) % kCorners;
      const QPolygonF wall = QPolygonF() << at(cell.corners.at(k)) << at(cell.corners.at(k + kCorners))
                                         << at(cell.corners.at(next + kCorners)) << at(cell.corners.at(next));
      if (!isSeenFromFront(wall)) continue;
      painter_.setBrush(grey.darker(118));
      painter_.drawPolygon(wall);
    }
    if (cell.facing > 0) {
      const QPolygonF front = frontOf(cell);
      painter_.setBrush(faceColor(cell));
      painter_.drawPolygon(front);
      if (placement(cell).placed_by == PlacedBy::Links) hatch(front);
      drawId(cell);
      return;
    }
    QPolygonF back;
    for (std::size_t k = kCorners; k < 2 * kCorners; ++k) back << at(cell.corners.at(k));
    painter_.setBrush(grey);
    painter_.drawPolygon(back);
  }

  void hatch(const QPolygonF& face) {
    QPainterPath clip;
    clip.addPolygon(face);
    clip.closeSubpath();
    painter_.save();
    painter_.setClipPath(clip, Qt::IntersectClip);
    const QRectF box = face.boundingRect();
    const double step = std::max(apothem_ / 3, 1.5 * point_);
    for (double x = box.left() - box.height(); x < box.right(); x += step) {
      for (const auto& [color, width] : {std::pair(QColor(Qt::white), 0.9), std::pair(QColor(Qt::black), 0.4)}) {
        painter_.setPen(QPen(color, width * point_));
        painter_.drawLine(QPointF(x, box.bottom()), QPointF(x + box.height(), box.top()));
      }
    }
    painter_.restore();
  }

  [[nodiscard]] double idSize(const PrintedCell& cell) const {
    const double letters = static_cast<double>(QString::number(placement(cell).cell.value()).size());
    return std::min({1.1 * apothem_, 2.2 * apothem_ * cell.facing / letters, kLargestId * point_});
  }

  void drawId(const PrintedCell& cell) {
    const double size = idSize(cell);
    if (cell.facing < kFacing || size < kSmallestId * point_) return;
    painter_.setFont(reportFont(size, true));
    const bool plain = placement(cell).placed_by != PlacedBy::Links;
    const QString id = QString::number(placement(cell).cell.value());
    const QRectF box(at(cell.middle) - QPointF(4 * size, size), QSizeF(8 * size, 2 * size));
    if (plain) {
      painter_.setPen(textOn(faceColor(cell)));
      painter_.drawText(box, Qt::AlignCenter, id);
    } else {
      labelOnWhite(at(cell.middle), id, size);
    }
  }

  void labelOnWhite(const QPointF& middle, const QString& text, double size) {
    const QFont font = reportFont(size, true);
    const QFontMetricsF metrics(font);
    QRectF box(0, 0, metrics.horizontalAdvance(text) + 0.5 * size, 1.2 * size);
    box.moveCenter(middle);
    const QRectF room = area_.adjusted(point_, point_, -point_, -point_);
    box.moveLeft(std::clamp(box.left(), room.left(), std::max(room.left(), room.right() - box.width())));
    box.moveTop(std::clamp(box.top(), room.top(), std::max(room.top(), room.bottom() - box.height())));
    painter_.setPen(Qt::NoPen);
    painter_.setBrush(Qt::white);
    painter_.drawRoundedRect(box, 0.25 * size, 0.25 * size);
    painter_.setPen(Qt::black);
    painter_.setFont(font);
    painter_.drawText(box, Qt::AlignCenter, text);
  }

  /// A nearer cell hides it.
  [[nodiscard]] bool isHidden(const PrintedCell& cell) const {
    return std::ranges::any_of(side_, [&](const PrintedCell& other) {
      if (other.index == cell.index || other.depth <= cell.depth) return false;
      QPolygonF polygon;
      for (std::size_t k = 0; k < kCorners; ++k) polygon << other.corners.at(k);
      return polygon.containsPoint(cell.middle, Qt::OddEvenFill);
    });
  }

  /// The cells that the texts speak of: the worst and the origin.
  void markCell(const PrintedCell& cell) {
    if (cell.facing < kFacing || (!isWorst(cell) && !isOrigin(cell)) || isHidden(cell)) return;
    const QPolygonF face = frontOf(cell);
    painter_.setBrush(Qt::NoBrush);
    const double width = cell.facing * std::clamp(0.2 * apothem_, 1.2 * point_, 2.4 * point_);
    if (isWorst(cell)) {
      painter_.setPen(QPen(Qt::white, 1.7 * width, Qt::SolidLine, Qt::SquareCap, Qt::MiterJoin));
      painter_.drawPolygon(face);
      painter_.setPen(QPen(Qt::black, width, Qt::SolidLine, Qt::SquareCap, Qt::MiterJoin));
      painter_.drawPolygon(face);
    } else {
      QPolygonF ring;
      for (const QPointF& corner : face) ring << at(cell.middle) + 0.78 * (corner - at(cell.middle));
      painter_.setPen(QPen(textOn(faceColor(cell)), std::max(0.5 * point_, 0.06 * apothem_)));
      painter_.drawPolygon(ring);
    }
    if (idSize(cell) >= kSmallestId * point_) return;
    const QString id = QString::number(placement(cell).cell.value());
    labelOnWhite(at(cell.middle) - QPointF(0, apothem_ + 5 * point_), id, 6.5 * point_);
  }

  void drawScaleBar() {
    const double length = barLength(0.3 * area_.width() / scale_);
    const QPointF left(area_.left() + kPadding * point_, area_.bottom() - kPadding * point_);
    const QPointF right = left + QPointF(length * scale_, 0);
    const QPointF tick(0, 2 * point_);
    painter_.setPen(QPen(colors_.text, 0.9 * point_, Qt::SolidLine, Qt::FlatCap));
    painter_.drawLine(left, right);
    painter_.drawLine(left - tick, left + tick);
    painter_.drawLine(right - tick, right + tick);
    const QFont font = reportFont(7 * point_);
    painter_.setFont(font);
    painter_.drawText(QRectF(left - QPointF(0, 12 * point_), QSizeF(area_.width() / 2, 10 * point_)),
                      Qt::AlignLeft | Qt::AlignVCenter,
                      ReportPatch::tr("%1 mm").arg(QLocale().toString(toMillimetres(length), 'f', 0)));
  }

  void drawAxes() {
    const double length = 11 * point_;
    const QPointF origin = area_.bottomRight() - QPointF(22 * point_, 21 * point_);
    painter_.setFont(reportFont(6.5 * point_));
    constexpr std::array<char, 3> kNames = {'x', 'y', 'z'};
    for (std::size_t k = 0; k < kNames.size(); ++k) {
      const Eigen::Vector3d axis = R_v_o_.col(static_cast<Eigen::Index>(k));
      const QPointF end = origin + length * QPointF(axis.x(), -axis.y());
      painter_.setPen(QPen(colors_.axis.at(k), 1.1 * point_, Qt::SolidLine, Qt::RoundCap));
      if (std::hypot(axis.x(), axis.y()) < 0.25) {
        // Along the view: a ring, with a dot if it comes out of the paper.
        painter_.setBrush(Qt::white);
        painter_.drawEllipse(origin, 2 * point_, 2 * point_);
        painter_.setBrush(colors_.axis.at(k));
        if (axis.z() > 0) painter_.drawEllipse(origin, 0.5 * point_, 0.5 * point_);
        painter_.drawText(QRectF(origin - QPointF(10 * point_, -1 * point_), QSizeF(8 * point_, 8 * point_)),
                          Qt::AlignRight | Qt::AlignTop, QString(QLatin1Char(kNames.at(k))));
        continue;
      }
      painter_.drawLine(origin, end);
      const QPointF word = origin + (length + 4.5 * point_) * QPointF(axis.x(), -axis.y());
      painter_.drawText(QRectF(word - QPointF(6 * point_, 5 * point_), QSizeF(12 * point_, 10 * point_)),
                        Qt::AlignCenter, QString(QLatin1Char(kNames.at(k))));
    }
  }

  const PatchPicture& picture_;
  const PrintedSide& side_;
  const Eigen::Matrix3d& R_v_o_;
  QPainter& painter_;
  QRectF area_;
  double point_;
  const Colors& colors_;
  double scale_ = 1;
  QPointF shift_;
  double apothem_ = 1;
};

inline void drawSide(const PatchPicture& picture, std::size_t side, QPainter& painter, const QRectF& area,
                     double point) {
  if (picture.shown().cells.size() <= kMaxShapes) {
    SidePainter(picture, side, painter, area, point).draw();
    return;
  }
  constexpr double kPointsPerInch = 72;
  const double fineness = kPictureDpi / kPointsPerInch / point;
  const QSize size = (area.size() * fineness).toSize();
  painter.drawImage(area, reportImage(size, [&](QPainter& on_image) {
                      SidePainter(picture, side, on_image, QRectF(QPointF(0, 0), size), point * fineness).draw();
                    }));
}

/// By the uncertainty of the shape, or where none is stated by that of the position relative to the origin.
inline PatchColoring patchColoring(const PatchReconstruction& patch) {
  PatchColoring coloring;
  coloring.is_of_shape =
      std::ranges::any_of(patch.cells, [](const CellPlacement& cell) { return shapeUncertaintyOf(cell).has_value(); });
  coloring.axis = coloring.is_of_shape ? ReportPatch::tr("uncertainty of the place in the shape (95 %), mm")
                                       : ReportPatch::tr("uncertainty of the position from the origin (95 %), mm");
  std::vector<double> known;
  for (const CellPlacement& cell : patch.cells) {
    const std::optional<Uncertainty95> stated = coloring.is_of_shape ? shapeUncertaintyOf(cell) : uncertaintyOf(cell);
    coloring.values.push_back(stated ? std::optional(toMillimetres(stated->position_m)) : std::nullopt);
    if (!stated) continue;
    known.push_back(*coloring.values.back());
    if (!coloring.worst || *coloring.values.back() > *coloring.values[*coloring.worst]) {
      coloring.worst = coloring.values.size() - 1;
    }
  }
  constexpr std::size_t kBins = 16;
  coloring.distribution = distributionOf(std::move(known), kBins);
  return coloring;
}

/// The patch from its four sides (see PatchSides), drawn as shapes: prisms in parallel projection, all to one scale,
/// with a bar of a length that is said, the axes of the patch's frame, and the IDs of cells that are large enough for
/// them. Cells that face away are grey, those without a reading of their own hatched; the one that is known least well
/// has a thick outline, and its ID and the origin's are there in any case.
inline std::vector<ReportDrawing> patchDrawings(const std::shared_ptr<const Reconstruction>& reconstruction,
                                                std::size_t patch, const PatchColoring& coloring) {
  auto picture = std::make_shared<PatchPicture>();
  picture->reconstruction = reconstruction;
  picture->patch = patch;
  picture->coloring = coloring;
  picture->R_v_o = patchSides(picture->shown()).R_v_o;
  for (std::size_t side = 0; side < picture->sides.size(); ++side) {
    picture->sides.at(side) = seenFrom(picture->shown(), *reconstruction->model, picture->R_v_o.at(side));
    picture->extent = picture->extent.expandedTo(boundsOf(picture->sides.at(side)).size());
  }
  const std::array<QString, 4> names = {ReportPatch::tr("Front"), ReportPatch::tr("Right side"),
                                        ReportPatch::tr("Back"), ReportPatch::tr("Left side")};
  std::vector<ReportDrawing> drawings;
  for (std::size_t side = 0; side < names.size(); ++side) {
    drawings.push_back(
        {names.at(side), kSideAspect, [picture, side](QPainter& painter, const QRectF& area, double point) {
           drawSide(*picture, side, painter, area, point);
         }});
  }
  return drawings;
}

}  // namespace hexoderm
