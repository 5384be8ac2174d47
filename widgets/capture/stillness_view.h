#pragma once

#include "hexoderm/capture/stillness_trace.h"
#include "widgets/controls/elided_label.h"
#include "widgets/controls/panel_parts.h"
#include "widgets/style/of_enum.h"
#include "widgets/style/palette.h"

#include <QLabel>
#include <QLocale>
#include <QPainter>
#include <QPolygonF>
#include <QTimer>
#include <QVBoxLayout>
#include <QWidget>
#include <algorithm>
#include <array>
#include <optional>

namespace hexoderm {

/// A strip chart of the last ten seconds: how far the three axes of the cell that decides, or of the picked one, are
/// off their mean of the last second, each in a lane of its own with the limit as a band; when poses were captured,
/// when the next one was armed, when a motion made it start over; and whether the part was moving, still or being
/// captured.
class StillnessView : public QWidget {
  Q_OBJECT

 public:
  explicit StillnessView(QWidget* parent = nullptr) : QWidget(parent) {
    setNames(this, QStringLiteral("stillnessView"), tr("Stillness of the last ten seconds"));
    header_->setAlignment(Qt::AlignRight | Qt::AlignVCenter);
    // A long text must not widen the window.
    header_->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Fixed);
    nothing_->setText(tr("No readings: when a skin is connected, this shows how still it is held."));
    nothing_->setAlignment(Qt::AlignCenter);
    auto* layout = spaced(new QVBoxLayout(this), {0, 2, 8, 2}, 2);
    layout->addWidget(header_);
    layout->addWidget(strip_, 1);
    layout->addWidget(nothing_, 1);
    strip_->hide();
    setUpOnce(refresh_soon_, kRefreshEvery_ms, this, [this] { refresh(); });
  }

  /// Cheap: at most 20 times a second. Drawn while visible, ten times a second.
  void add(const HoldStatus& hold, const SkinPreview& preview) {
    trace_.add(hold, preview);
    if (!isVisible()) return;
    if (strip_->isHidden()) {
      refresh();  // nothing is drawn yet
    } else if (!refresh_soon_.isActive()) {
      refresh_soon_.start();
    }
  }

  /// `time_s`: device time, CapturedPose::end_s.
  void addCaptured(PoseId pose, double time_s) {
    trace_.addCaptured(pose, time_s);
    refresh();
  }

  /// Clears the view for another source.
  void clear() {
    trace_.clear();
    refresh();
  }

  /// "cell 7 · x y z, deviation from its mean, last 10 s, limit 30 mg".
  [[nodiscard]] QString header() const {
    if (trace_.points().empty() || trace_.cell() == CellId()) return {};
    const QString cell = trace_.isPicked() ? tr("cell %1, picked").arg(trace_.cell().value())
                                           : tr("cell %1, which decides").arg(trace_.cell().value());
    return tr("%1 · x y z, deviation from its mean, last %2 s, limit %3 mg")
        .arg(cell, QLocale().toString(StillnessTrace::kSpan_s, 'f', 0),
             QLocale().toString(1000 * trace_.limit_g(), 'f', 0));
  }

  [[nodiscard]] const StillnessTrace& trace() const { return trace_; }

  QSize sizeHint() const override { return {600, 10 * fontMetrics().height()}; }
  QSize minimumSizeHint() const override { return {200, 6 * fontMetrics().height()}; }

 public slots:
  /// Shows a cell; none: the cell that decides.
  void setCell(std::optional<hexoderm::CellId> cell) {
    trace_.pick(cell);
    refresh();
  }

 protected:
  void showEvent(QShowEvent* event) override {
    QWidget::showEvent(event);
    refresh();
  }

 private:
  class Strip;

  void refresh() {
    refresh_soon_.stop();
    if (!isVisible()) return;
    const bool empty = trace_.points().empty();
    nothing_->setVisible(empty);
    strip_->setVisible(!empty);
    header_->setText(header());
    strip_->update();
  }

  StillnessTrace trace_;
  QLabel* header_ = styledAs(named(new ElidedLabel(1, this), "stillnessHeader"), "muted");
  Strip* strip_ = new Strip(trace_, this);
  QLabel* nothing_ = styledAs(paragraph("stillnessNothing", this), "muted");
  QTimer refresh_soon_;

  // The ordinate counts lanes: x around 2, y around 1, z around 0, the ribbon of states below.
  static constexpr double kHalfLane = 0.48;
  static constexpr double kLimitsInHalfLane = 1.6;
  static constexpr double kRibbon = -0.62;
  static constexpr double kTop = 2.55;
  static constexpr int kRefreshEvery_ms = 100;  // readings come twice as often; a strip of ten seconds does not show it
  static constexpr double kLetters_s = 0.4;     // room on the left for the names of the axes
  static constexpr std::array<const char*, 3> kAxes = {"x", "y", "z"};

  static double laneOf(int axis) { return 2.0 - axis; }

  static QString stateWord(TraceState state) { return ofEnum(state, {tr("moving"), tr("still"), tr("capturing")}); }

  static QString eventWord(const TraceEvent& event) {
    switch (event.kind) {
      case TraceEventKind::Captured:
        return tr("captured %1").arg(event.pose.value());
      case TraceEventKind::ArmedAgain:
        return tr("ready again");
      case TraceEventKind::StartsOver:
        return tr("starts over");
    }
    return {};
  }

  /// Draws a long line piece by piece. Qt's rasterizer looks through all that crosses a row of pixels for each edge
  /// that does, so that a line that swings up and down takes ten times as long in one piece.
  static void drawInPieces(QPainter& painter, const QPolygonF& line) {
    constexpr int kPiece = 12;
    for (int from = 0; from + 1 < line.size(); from += kPiece) {
      painter.drawPolyline(line.constData() + from, std::min(kPiece + 1, static_cast<int>(line.size()) - from));
    }
  }

  class Strip : public QWidget {
   public:
    Strip(const StillnessTrace& trace, QWidget* parent) : QWidget(parent), trace_(trace) {}

   protected:
    void paintEvent(QPaintEvent* /*event*/) override {
      // Over the lanes and under the ribbon their words have room, however high the strip is.
      const double words = fontMetrics().height() + 6;
      room_ = words * (kTop - kRibbon) / std::max(10.0, height() - 2 * words);
      QPainter painter(this);
      drawLimits(painter);
      drawStates(painter);
      drawEvents(painter);
      painter.setRenderHint(QPainter::Antialiasing);
      for (int axis = 0; axis < 3; ++axis) drawCurve(painter, axis);
    }

   private:
    [[nodiscard]] const Colors& colors() const { return Colors::of(palette()); }
    [[nodiscard]] double xOf(double time_s) const {
      return (width() - 1) * (1 + (time_s - trace_.now_s()) / (StillnessTrace::kSpan_s + kLetters_s));
    }
    [[nodiscard]] double yOf(double lane) const {
      return (height() - 1) * (kTop + room_ - lane) / (kTop - kRibbon + 2 * room_);
    }

    void drawLimits(QPainter& painter) const {
      painter.fillRect(rect(), colors().panel);
      for (int axis = 0; axis < 3; ++axis) {
        const double half = kHalfLane / kLimitsInHalfLane;
        const double top = yOf(laneOf(axis) + half);
        painter.fillRect(QRectF(0, top, width(), yOf(laneOf(axis) - half) - top), colors().panel_active);
        painter.setPen(colors().text_muted);
        painter.drawText(QRectF(4, yOf(laneOf(axis)) - 12, 20, 24), Qt::AlignLeft | Qt::AlignVCenter,
                         QLatin1String(kAxes.at(static_cast<std::size_t>(axis))));
      }
    }

    void drawStates(QPainter& painter) const {
      const auto& points = trace_.points();
      for (std::size_t from = 0; from < points.size();) {
        std::size_t to = from;
        while (to + 1 < points.size() && points[to + 1].state == points[from].state) ++to;
        drawState(painter, points[from].state, xOf(points[from].time_s),
                  xOf(points[std::min(to + 1, points.size() - 1)].time_s));
        from = to + 1;
      }
    }

    void drawState(QPainter& painter, TraceState state, double left, double right) const {
      const double y = yOf(kRibbon);
      QPen pen(colors().text_muted, 2, state == TraceState::Still ? Qt::SolidLine : Qt::DotLine, Qt::FlatCap);
      if (state == TraceState::Collecting) pen = QPen(colors().accent, 4, Qt::SolidLine, Qt::FlatCap);
      painter.setPen(pen);
      painter.drawLine(QPointF(left, y), QPointF(right, y));
      const QString word = stateWord(state);
      const QFontMetrics metrics = painter.fontMetrics();
      if (metrics.horizontalAdvance(word) + 8 > right - left) return;
      painter.setPen(colors().text_muted);
      painter.drawText(QRectF(left, y + 2, right - left, metrics.height()), Qt::AlignHCenter | Qt::AlignTop, word);
    }

    void drawEvents(QPainter& painter) const {
      for (const TraceEvent& event : trace_.events()) {
        const double x = xOf(event.time_s);
        const bool captured = event.kind == TraceEventKind::Captured;
        const QColor color = event.kind == TraceEventKind::StartsOver ? colors().caution : colors().good;
        painter.setPen(QPen(color, captured ? 2 : 1.2, captured ? Qt::SolidLine : Qt::DashLine));
        painter.drawLine(QPointF(x, 0), QPointF(x, yOf(kRibbon)));
      }
      // No line through a word.
      const QFontMetrics metrics = painter.fontMetrics();
      double free_from = 0;
      for (const TraceEvent& event : trace_.events()) {
        const double x = xOf(event.time_s);
        const QString word = eventWord(event);
        const double word_width = metrics.horizontalAdvance(word) + 2;
        // On the other side of its line where the strip ends, and not over the word before.
        const double left = x + 4 + word_width > width() ? x - 4 - word_width : x + 4;
        if (left < free_from) continue;
        const QRectF box(left, 0, word_width, metrics.height());
        painter.fillRect(box, colors().panel);
        painter.setPen(event.kind == TraceEventKind::StartsOver ? colors().text : colors().good);
        painter.drawText(box, Qt::AlignLeft | Qt::AlignVCenter, word);
        free_from = left + word_width + 6;
      }
    }

    void drawCurve(QPainter& painter, int axis) const {
      painter.setPen(QPen(colors().axis.at(static_cast<std::size_t>(axis)), 1.5, Qt::SolidLine, Qt::FlatCap));
      QPolygonF line;
      for (const TracePoint& point : trace_.points()) {
        if (point.deviation_g) {
          const double lanes = kHalfLane / kLimitsInHalfLane * (*point.deviation_g)(axis) / trace_.limit_g();
          line.append({xOf(point.time_s), yOf(laneOf(axis) + std::clamp(lanes, -kHalfLane, kHalfLane))});
        } else {
          drawInPieces(painter, line);
          line.clear();
        }
      }
      drawInPieces(painter, line);
    }

    const StillnessTrace& trace_;
    double room_ = 0;  ///< above the lanes and below the ribbon, in lanes
  };
};

}  // namespace hexoderm
