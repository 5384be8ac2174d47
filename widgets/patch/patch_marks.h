#pragma once

#include "hexoderm/base/finding.h"
#include "widgets/controls/panel_parts.h"
#include "widgets/style/palette.h"

#include <QPainter>
#include <QPainterPath>
#include <QPolygonF>
#include <QString>
#include <QWidget>
#include <algorithm>
#include <array>
#include <optional>
#include <vector>

namespace hexoderm {

/// A cell or a link in the picture, as it is marked: in pixels of the view. Not there: empty.
struct SceneMark {
  QPolygonF line;                ///< outline of a cell, or the way of a link
  bool closed = true;            ///< an outline
  bool hidden = false;           ///< the cell is behind others, or seen from behind
  QString tag;                   ///< written beside it; may be empty
  std::optional<Severity> sign;  ///< drawn before the tag: what was found there
  [[nodiscard]] bool isThere() const { return !line.isEmpty(); }
};

/// The outlines over the 3D scene: of what is picked, of what is under the mouse, of the cell that an instruction
/// speaks of, and of where something was found. Each is light and dark side by side, so that it stands out on every
/// colour, and is seen through cells in front of it, then dashed. Painted over the picture, so that nothing of the
/// scene is drawn anew for them. Lets the mouse through.
class PatchMarks : public QWidget {
  Q_OBJECT

 public:
  struct Content {
    SceneMark picked;
    SceneMark hovered;
    SceneMark told;
    std::vector<SceneMark> found;
  };

  explicit PatchMarks(QWidget* parent) : QWidget(parent) { letThrough(this); }

  void setContent(const Content& content) {
    content_ = content;
    update();
  }

  [[nodiscard]] const Content& content() const { return content_; }
  /// Buttons lie there, under which a tag would not be read.
  void setTopMargin(int pixels) {
    top_margin_ = pixels;
    update();
  }

  /// A frame that shows that the view has the keyboard.
  void setFocusShown(bool shown) {
    shows_focus_ = shown;
    update();
  }

  /// Paints what stays when the mouse has gone, for a picture of the view.
  void paintLasting(QPainter& painter) const {
    painter.setRenderHint(QPainter::Antialiasing);
    const Colors& colors = Colors::of(palette());
    std::vector<QRectF> tags;
    for (const SceneMark& mark : content_.found) {
      if (!mark.isThere()) continue;
      const QColor& color = mark.sign == Severity::Error ? colors.bad : colors.caution;
      paintOutline(painter, mark, color, colors.panel, kFoundWidth);
      paintTag(painter, mark, color, textOn(color), tags);
    }
    if (content_.told.isThere()) {
      QColor light = colors.accent;
      light.setAlphaF(0.45);
      painter.fillPath(pathOf(content_.told), light);
      paintOutline(painter, content_.told, colors.accent, colors.panel, kToldWidth);
      paintTag(painter, content_.told, colors.accent, colors.accent_text, tags);
    }
    if (content_.picked.isThere()) {
      paintOutline(painter, content_.picked, colors.selection, textOn(colors.selection), kPickedWidth);
      paintTag(painter, content_.picked, colors.selection, textOn(colors.selection), tags);
    }
  }

 protected:
  void paintEvent(QPaintEvent* /*event*/) override {
    QPainter painter(this);
    paintLasting(painter);
    const Colors& colors = Colors::of(palette());
    if (content_.hovered.isThere()) {
      paintOutline(painter, content_.hovered, colors.selection, textOn(colors.selection), kHoverWidth);
    }
    if (!shows_focus_) return;
    painter.setBrush(Qt::NoBrush);
    painter.setPen(QPen(colors.accent, 2));
    painter.drawRect(QRectF(rect()).adjusted(1, 1, -1, -1));
  }

 private:
  static constexpr double kPickedWidth = 3;
  static constexpr double kHoverWidth = 1.4;
  static constexpr double kToldWidth = 4;
  static constexpr double kFoundWidth = 2.4;
  static constexpr double kHalo = 2;  // on either side
  static QPainterPath pathOf(const SceneMark& mark) {
    QPainterPath path;
    path.addPolygon(mark.line);
    if (mark.closed) path.closeSubpath();
    return path;
  }

  /// As on the faces of the cells and in the table of findings.
  static void paintSign(QPainter& painter, Severity severity, const QPointF& center, double radius) {
    const auto at = [&](double x, double y) { return center + radius * QPointF(x, y); };
    if (severity == Severity::Error) {
      painter.drawLine(at(-1, -1), at(1, 1));
      painter.drawLine(at(-1, 1), at(1, -1));
    } else {
      painter.drawPolygon(QPolygonF({at(0, -1), at(1.1, 0.9), at(-1.1, 0.9)}));
    }
  }

  /// From a tag to the outline that it belongs to, so that it is not taken for that of the cell under it.
  static void paintLeader(QPainter& painter, const QRectF& plate, const QPolygonF& outline, const QColor& color) {
    constexpr double kLeaderWidth = 3;
    const auto distance = [&](const QPointF& corner) { return QLineF(plate.center(), corner).length(); };
    const QPointF to = *std::ranges::min_element(outline, {}, distance);
    painter.setPen(QPen(textOn(color), kLeaderWidth + 2, Qt::SolidLine, Qt::RoundCap));
    painter.drawLine(plate.center(), to);
    painter.setPen(QPen(color, kLeaderWidth, Qt::SolidLine, Qt::RoundCap));
    painter.drawLine(plate.center(), to);
  }

  void paintOutline(QPainter& painter, const SceneMark& mark, const QColor& core, const QColor& halo,
                    double width) const {
    painter.save();
    painter.setBrush(Qt::NoBrush);
    QPen pen(halo, width + 2 * kHalo, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin);
    painter.setPen(pen);
    painter.drawPath(pathOf(mark));
    pen.setColor(core);
    pen.setWidthF(width);
    if (mark.hidden) {
      pen.setCapStyle(Qt::FlatCap);
      pen.setDashPattern({2.5, 1.8});
    }
    painter.setPen(pen);
    painter.drawPath(pathOf(mark));
    painter.restore();
  }

  /// On the side of the mark where there is room for it, where it covers none of `taken`, to which it is added.
  void paintTag(QPainter& painter, const SceneMark& mark, const QColor& ground, const QColor& ink,
                std::vector<QRectF>& taken) const {
    if (mark.tag.isEmpty()) return;
    constexpr double kAside = 6;
    painter.save();
    QFont bold = font();
    bold.setBold(true);
    painter.setFont(bold);
    const QSizeF text = painter.fontMetrics().size(0, mark.tag);
    const double sign = mark.sign ? text.height() : 0;
    const QSizeF size = text + QSizeF(10 + sign, 4);
    // Of a link, its middle.
    const QRectF around = mark.closed ? mark.line.boundingRect()
                                      : QRectF(pathOf(mark).pointAtPercent(0.5) - QPointF(kAside, kAside),
                                               QSizeF(2 * kAside, 2 * kAside));
    const QRectF inside = QRectF(rect()).adjusted(kAside, kAside + top_margin_, -kAside, -kAside);
    const double above = around.top() - kAside - size.height();
    const double below = around.bottom() + kAside;
    const double to_right = around.right() - 2;
    const double to_left = around.left() + 2 - size.width();
    const double beside = around.center().y() - size.height() / 2;
    const std::array<QPointF, 5> corners = {QPointF(to_right, above), QPointF(to_left, above), QPointF(to_right, below),
                                            QPointF(to_left, below), QPointF(to_right + kAside, beside)};
    const auto found = std::ranges::find_if(corners, [&](const QPointF& corner) {
      const QRectF place(corner, size);
      return inside.contains(place) &&
             std::ranges::none_of(taken, [&](const QRectF& other) { return other.intersects(place); });
    });
    // Many lie close together: a tag over another would hide both.
    if (found == corners.end() && mark.sign && !taken.empty()) return painter.restore();
    QRectF plate(found == corners.end() ? corners.front() : *found, size);
    if (found == corners.end()) {
      if (plate.top() < inside.top()) plate.moveTop(below);
      plate.moveLeft(std::clamp(plate.left(), kAside, std::max(kAside, width() - kAside - plate.width())));
    }
    taken.push_back(plate);
    if (mark.closed) paintLeader(painter, plate, mark.line, ground);
    painter.setPen(QPen(textOn(ground), 1));
    painter.setBrush(ground);
    painter.drawRoundedRect(plate, 4, 4);
    painter.setPen(QPen(ink, 2, Qt::SolidLine, Qt::RoundCap));
    if (mark.sign) {
      painter.setBrush(ink);
      paintSign(painter, *mark.sign, {plate.left() + 4 + sign / 2, plate.center().y()}, 0.24 * sign);
    }
    painter.drawText(plate.adjusted(sign, 0, 0, 0), Qt::AlignCenter, mark.tag);
    painter.restore();
  }

  Content content_;
  bool shows_focus_ = false;
  int top_margin_ = 0;
};

}  // namespace hexoderm
