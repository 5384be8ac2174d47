#include "widgets/tables/table_cells.h"

#include "hexoderm/base/units.h"
#include "widgets/style/palette.h"

#include <QApplication>
#include <QBrush>
#include <QPainter>
#include <QPixmap>

namespace hexoderm {
namespace {

constexpr int kMark = 16;  ///< side of the marks before words, in device-independent pixels

const Colors& colors() { return Colors::of(QApplication::palette()); }

/// A mark drawn at twice its size, so that it is sharp on fine screens, too.
template <class Draw>
QIcon drawMark(Draw&& draw) {
  constexpr int kFine = 2;
  QPixmap mark(kFine * kMark, kFine * kMark);
  mark.setDevicePixelRatio(kFine);
  mark.fill(Qt::transparent);
  QPainter painter(&mark);
  painter.setRenderHint(QPainter::Antialiasing);
  draw(painter);
  painter.end();
  QIcon icon(mark);
  icon.addPixmap(mark, QIcon::Selected);  // or the style tints it, and colours here have a meaning
  return icon;
}

}  // namespace

QVariant alignment(bool figure) {
  return QVariant::fromValue(static_cast<int>((figure ? Qt::AlignRight : Qt::AlignLeft) | Qt::AlignVCenter));
}

QVariant rawDegrees(std::optional<double> angle_rad) {
  return angle_rad ? QVariant(toDegrees(*angle_rad)) : QVariant();
}

QVariant excludedForeground() { return QBrush(colors().text_muted); }

QIcon usedMark(bool used) {
  return drawMark([used](QPainter& painter) {
    painter.setPen(QPen(used ? colors().good : colors().text_muted, 2, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin));
    if (used) {
      painter.drawPolyline(QPolygonF({QPointF(3.5, 8.5), QPointF(6.5, 11.5), QPointF(12.5, 4.5)}));
    } else {
      painter.drawLine(QPointF(4, 8), QPointF(12, 8));
    }
  });
}

QIcon strokeMark(EdgeQuality quality) {
  return drawMark([quality](QPainter& painter) {
    drawStroke(painter, linkStroke(quality, themeOf(QApplication::palette())), QLineF(0.5, 8, kMark - 0.5, 8), 2.8);
  });
}

QIcon severityMark(Severity severity) {
  return drawMark([severity](QPainter& painter) {
    switch (severity) {
      case Severity::Error:
        painter.setPen(QPen(colors().bad, 2.4, Qt::SolidLine, Qt::RoundCap));
        painter.drawLine(QPointF(4, 4), QPointF(12, 12));
        painter.drawLine(QPointF(4, 12), QPointF(12, 4));
        return;
      case Severity::Warning:
        painter.setPen(Qt::NoPen);
        painter.setBrush(colors().caution);
        painter.drawPolygon(QPolygonF({QPointF(8, 2.5), QPointF(14, 13), QPointF(2, 13)}));
        return;
      case Severity::Info:
        painter.setPen(QPen(colors().text_muted, 1.6));
        painter.setBrush(Qt::NoBrush);
        painter.drawEllipse(QPointF(8, 8), 4.2, 4.2);
        return;
    }
  });
}

}  // namespace hexoderm
