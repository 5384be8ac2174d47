#include "widgets/capture/stillness_view.h"

#include "widgets/controls/elided_label.h"
#include "widgets/controls/panel_parts.h"
#include "widgets/style/of_enum.h"
#include "widgets/style/palette.h"

#include <qwt_plot.h>
#include <qwt_plot_canvas.h>
#include <qwt_plot_item.h>
#include <qwt_plot_layout.h>
#include <qwt_scale_map.h>
#include <QLabel>
#include <QLocale>
#include <QPainter>
#include <QPolygonF>
#include <QTimer>
#include <QVBoxLayout>
#include <algorithm>
#include <array>

namespace hexoderm {
namespace {

// The ordinate counts lanes: x around 2, y around 1, z around 0, the ribbon of states below.
constexpr double kHalfLane = 0.48;
constexpr double kLimitsInHalfLane = 1.6;
constexpr double kRibbon = -0.62;
constexpr double kTop = 2.55;
constexpr int kRefreshEvery_ms = 100;  // readings come twice as often; a strip of ten seconds does not show it
constexpr double kLetters_s = 0.4;     // room on the left for the names of the axes
constexpr std::array<const char*, 3> kAxes = {"x", "y", "z"};

double laneOf(int axis) { return 2.0 - axis; }

QString stateWord(TraceState state) {
  return ofEnum(state, {StillnessView::tr("moving"), StillnessView::tr("still"), StillnessView::tr("capturing")});
}

QString eventWord(const TraceEvent& event) {
  switch (event.kind) {
    case TraceEventKind::Captured:
      return StillnessView::tr("captured %1").arg(event.pose.value());
    case TraceEventKind::ArmedAgain:
      return StillnessView::tr("ready again");
    case TraceEventKind::StartsOver:
      return StillnessView::tr("starts over");
  }
  return {};
}

/// Everything but the curves: the bands of the limit, the states below, and the events as lines.
class Ground : public QwtPlotItem {
 public:
  explicit Ground(const StillnessTrace& trace) : trace_(&trace) { setZ(-1); }

  void draw(QPainter* painter, const QwtScaleMap& across, const QwtScaleMap& up, const QRectF& canvas) const override {
    const Colors& colors = Colors::of(plot()->palette());
    painter->setRenderHint(QPainter::Antialiasing, false);
    // Under a style sheet the canvas has a ground of its own.
    painter->fillRect(canvas, colors.panel);
    for (int axis = 0; axis < 3; ++axis) {
      const double half = kHalfLane / kLimitsInHalfLane;
      const double top = up.transform(laneOf(axis) + half);
      painter->fillRect(QRectF(canvas.left(), top, canvas.width(), up.transform(laneOf(axis) - half) - top),
                        colors.panel_active);
      painter->setPen(colors.text_muted);
      painter->drawText(QRectF(canvas.left() + 4, up.transform(laneOf(axis)) - 12, 20, 24),
                        Qt::AlignLeft | Qt::AlignVCenter, QLatin1String(kAxes.at(static_cast<std::size_t>(axis))));
    }
    drawStates(*painter, across, up);
    drawEvents(*painter, across, up, canvas);
  }

 private:
  void drawStates(QPainter& painter, const QwtScaleMap& across, const QwtScaleMap& up) const {
    const auto& points = trace_->points();
    const double y = up.transform(kRibbon);
    for (std::size_t from = 0; from < points.size();) {
      std::size_t to = from;
      while (to + 1 < points.size() && points[to + 1].state == points[from].state) ++to;
      const double end_s = to + 1 < points.size() ? points[to + 1].time_s : points[to].time_s;
      const double left = across.transform(points[from].time_s - trace_->now_s());
      const double right = across.transform(end_s - trace_->now_s());
      drawState(painter, points[from].state, left, right, y);
      from = to + 1;
    }
  }

  void drawState(QPainter& painter, TraceState state, double left, double right, double y) const {
    const Colors& colors = Colors::of(plot()->palette());
    QPen pen(colors.text_muted, 2, Qt::DotLine, Qt::FlatCap);
    if (state == TraceState::Still) pen = QPen(colors.text_muted, 2, Qt::SolidLine, Qt::FlatCap);
    if (state == TraceState::Collecting) pen = QPen(colors.accent, 4, Qt::SolidLine, Qt::FlatCap);
    painter.setPen(pen);
    painter.drawLine(QPointF(left, y), QPointF(right, y));
    const QString word = stateWord(state);
    const QFontMetrics metrics = painter.fontMetrics();
    if (metrics.horizontalAdvance(word) + 8 > right - left) return;
    painter.setPen(colors.text_muted);
    painter.drawText(QRectF(left, y + 2, right - left, metrics.height()), Qt::AlignHCenter | Qt::AlignTop, word);
  }

  void drawEvents(QPainter& painter, const QwtScaleMap& across, const QwtScaleMap& up, const QRectF& canvas) const {
    const Colors& colors = Colors::of(plot()->palette());
    const QFontMetrics metrics = painter.fontMetrics();
    const auto place = [&](const TraceEvent& event) { return across.transform(event.time_s - trace_->now_s()); };
    for (const TraceEvent& event : trace_->events()) {
      const double x = place(event);
      const bool captured = event.kind == TraceEventKind::Captured;
      const QColor color = event.kind == TraceEventKind::StartsOver ? colors.caution : colors.good;
      painter.setPen(QPen(color, captured ? 2 : 1.2, captured ? Qt::SolidLine : Qt::DashLine));
      painter.drawLine(QPointF(x, canvas.top()), QPointF(x, up.transform(kRibbon)));
    }
    // No line through a word.
    double free_from = canvas.left();
    for (const TraceEvent& event : trace_->events()) {
      const double x = place(event);
      const QString word = eventWord(event);
      const double width = metrics.horizontalAdvance(word) + 2;
      // On the other side of its line where the strip ends, and not over the word before.
      double left = x + 4 + width > canvas.right() ? x - 4 - width : x + 4;
      if (left < free_from) continue;
      const QRectF box(left, canvas.top(), width, metrics.height());
      painter.fillRect(box, colors.panel);
      painter.setPen(event.kind == TraceEventKind::StartsOver ? colors.text : colors.good);
      painter.drawText(box, Qt::AlignLeft | Qt::AlignVCenter, word);
      free_from = left + width + 6;
    }
  }

  const StillnessTrace* trace_;
};

/// Draws a long line piece by piece. Qt's rasterizer looks through all that crosses a row of pixels for each edge that
/// does, so that a line that swings up and down takes ten times as long in one piece.
void drawInPieces(QPainter& painter, const QPolygonF& line) {
  constexpr int kPiece = 12;
  for (int from = 0; from + 1 < line.size(); from += kPiece) {
    painter.drawPolyline(line.constData() + from, std::min(kPiece + 1, static_cast<int>(line.size()) - from));
  }
}

/// The three axes in their lanes. Not Qwt's own curve: its header is no C++20 (destructors with template arguments).
class Curves : public QwtPlotItem {
 public:
  explicit Curves(const StillnessTrace& trace) : trace_(&trace) {}

  void draw(QPainter* painter, const QwtScaleMap& across, const QwtScaleMap& up,
            const QRectF& /*canvas*/) const override {
    painter->setRenderHint(QPainter::Antialiasing);
    for (int axis = 0; axis < 3; ++axis) {
      painter->setPen(
          QPen(Colors::of(plot()->palette()).axis.at(static_cast<std::size_t>(axis)), 1.5, Qt::SolidLine, Qt::FlatCap));
      QPolygonF line;
      for (const TracePoint& point : trace_->points()) {
        if (point.deviation_g) {
          const double lanes = kHalfLane / kLimitsInHalfLane * (*point.deviation_g)(axis) / trace_->limit_g();
          line.append({across.transform(point.time_s - trace_->now_s()),
                       up.transform(laneOf(axis) + std::clamp(lanes, -kHalfLane, kHalfLane))});
        } else {
          drawInPieces(*painter, line);
          line.clear();
        }
      }
      drawInPieces(*painter, line);
    }
  }

 private:
  const StillnessTrace* trace_;
};

}  // namespace

struct StillnessView::Parts {
  explicit Parts(StillnessView* owner) : view(owner) {}

  StillnessView* view;
  StillnessTrace trace;
  QLabel* header = nullptr;
  QwtPlot* plot = nullptr;
  QLabel* nothing = nullptr;
  QTimer refresh_soon;

  void refresh() {
    refresh_soon.stop();
    if (!view->isVisible()) return;
    const bool empty = trace.points().empty();
    if (nothing->isHidden() == empty) {
      nothing->setVisible(empty);
      plot->setVisible(!empty);
    }
    const QString text = view->header();
    if (header->text() != text) {
      header->setText(text);
      header->setAccessibleName(text);
    }
    if (empty) return;
    // Over the lanes and under the ribbon their words have room, however high the strip is.
    const double words = view->fontMetrics().height() + 6;
    const double lanes = std::max(10.0, plot->canvas()->height() - 2 * words);
    const double room = words * (kTop - kRibbon) / lanes;
    plot->setAxisScale(QwtPlot::yLeft, kRibbon - room, kTop + room);
    plot->replot();
  }

  /// At once if nothing is drawn yet.
  void refreshSoon() {
    if (!view->isVisible()) return;
    if (plot->isHidden()) {
      refresh();
    } else if (!refresh_soon.isActive()) {
      refresh_soon.start();
    }
  }
};

StillnessView::StillnessView(QWidget* parent) : QWidget(parent), parts_(std::make_unique<Parts>(this)) {
  setNames(this, QStringLiteral("stillnessView"), tr("Stillness of the last ten seconds"));
  parts_->header = new ElidedLabel(1, this);
  parts_->header->setObjectName(QStringLiteral("stillnessHeader"));
  parts_->header->setProperty("muted", true);
  parts_->header->setAlignment(Qt::AlignRight | Qt::AlignVCenter);
  // A long text must not widen the window.
  parts_->header->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Fixed);
  parts_->nothing = new QLabel(tr("No readings: when a skin is connected, this shows how still it is held."), this);
  parts_->nothing->setObjectName(QStringLiteral("stillnessNothing"));
  parts_->nothing->setProperty("muted", true);
  parts_->nothing->setAlignment(Qt::AlignCenter);
  parts_->nothing->setWordWrap(true);

  parts_->plot = new QwtPlot(this);
  QwtPlot* plot = parts_->plot;
  plot->setFocusPolicy(Qt::NoFocus);
  plot->setAutoReplot(false);
  plot->enableAxis(QwtPlot::xBottom, false);
  plot->enableAxis(QwtPlot::yLeft, false);
  plot->setAxisScale(QwtPlot::xBottom, -StillnessTrace::kSpan_s - kLetters_s, 0);
  plot->plotLayout()->setCanvasMargin(0);
  auto* canvas = new QwtPlotCanvas(plot);
  canvas->setFrameStyle(QFrame::NoFrame);
  canvas->setPaintAttribute(QwtPlotCanvas::BackingStore, false);
  canvas->setFocusPolicy(Qt::NoFocus);
  plot->setCanvas(canvas);
  (new Ground(parts_->trace))->attach(plot);
  (new Curves(parts_->trace))->attach(plot);

  auto* layout = spaced(new QVBoxLayout(this), {0, 2, 8, 2}, 2);
  layout->addWidget(parts_->header);
  layout->addWidget(plot, 1);
  layout->addWidget(parts_->nothing, 1);
  plot->hide();
  parts_->refresh_soon.setSingleShot(true);
  parts_->refresh_soon.setInterval(kRefreshEvery_ms);
  connect(&parts_->refresh_soon, &QTimer::timeout, this, [this] { parts_->refresh(); });
}

StillnessView::~StillnessView() {
  // The plot's items look at the trace.
  delete parts_->plot;
}

void StillnessView::add(const HoldStatus& hold, const SkinPreview& preview) {
  parts_->trace.add(hold, preview);
  parts_->refreshSoon();
}

void StillnessView::addCaptured(PoseId pose, double time_s) {
  parts_->trace.addCaptured(pose, time_s);
  parts_->refresh();
}

void StillnessView::setCell(std::optional<CellId> cell) {
  parts_->trace.pick(cell);
  parts_->refresh();
}

void StillnessView::clear() {
  parts_->trace.clear();
  parts_->refresh();
}

QString StillnessView::header() const {
  const StillnessTrace& trace = parts_->trace;
  if (trace.points().empty() || trace.cell() == CellId()) return {};
  const QString cell = trace.isPicked() ? tr("cell %1, picked").arg(trace.cell().value())
                                        : tr("cell %1, which decides").arg(trace.cell().value());
  return tr("%1 · x y z, deviation from its mean, last %2 s, limit %3 mg")
      .arg(cell, QLocale().toString(StillnessTrace::kSpan_s, 'f', 0),
           QLocale().toString(1000 * trace.limit_g(), 'f', 0));
}

const StillnessTrace& StillnessView::trace() const { return parts_->trace; }

QSize StillnessView::sizeHint() const { return {600, 10 * fontMetrics().height()}; }
QSize StillnessView::minimumSizeHint() const { return {200, 6 * fontMetrics().height()}; }

void StillnessView::showEvent(QShowEvent* event) {
  QWidget::showEvent(event);
  parts_->refresh();
}

}  // namespace hexoderm
