#include "widgets/plot/plot_view.h"

#include "widgets/coloring/coloring.h"
#include "widgets/controls/panel_parts.h"
#include "widgets/plot/plot_pointing.h"
#include "widgets/style/dressed_theme.h"
#include "widgets/style/palette.h"
#include "widgets/words/formatting.h"

#include <qwt_plot.h>
#include <qwt_plot_canvas.h>
#include <qwt_plot_grid.h>
#include <qwt_scale_draw.h>
#include <qwt_text.h>
#include <QComboBox>
#include <QEvent>
#include <QHBoxLayout>
#include <QLabel>
#include <QLocale>
#include <QStandardItemModel>
#include <QTimer>
#include <QVBoxLayout>
#include <algorithm>
#include <cmath>
#include <initializer_list>
#include <utility>

namespace hexoderm {
namespace {

constexpr int kReadingsEvery_ms = 250;
constexpr int kHistogram = -2;  // what the box for the upward axis holds in place of a colouring
constexpr int kCellNumber = -1;

int codeOf(const PlotFigure& figure) { return figure ? static_cast<int>(*figure) : kCellNumber; }

PlotFigure figureOf(int code) { return code < 0 ? PlotFigure() : PlotFigure(static_cast<Coloring>(code)); }

/// Figures in the user's locale.
class PlotScale : public QwtScaleDraw {
 public:
  [[nodiscard]] QwtText label(double value) const override { return QLocale().toString(value, 'g', 6); }
};

QComboBox* figureBox(const char* name, const QString& accessible_name) {
  auto* box = new QComboBox;
  setNames(box, QLatin1String(name), accessible_name);
  box->setToolTip(accessible_name);
  makeNarrow(box);
  constexpr int kShown = 16;
  box->setMinimumContentsLength(kShown);
  return box;
}

/// A row of its own, which is as narrow as the boxes in it may be.
QHBoxLayout* rowOf(std::initializer_list<std::pair<QWidget*, int>> widgets) {
  auto* row = spaced(new QHBoxLayout, 6);
  for (const auto& [widget, stretch] : widgets) row->addWidget(widget, stretch);
  return row;
}

/// A little room beside the outermost points, so that none lies on the frame.
void setScale(QwtPlot* plot, int axis, ColorRange values, bool from_zero) {
  constexpr double kRoom = 0.06;
  if (from_zero && values.low >= 0) values.low = 0;
  double room = kRoom * (values.high - values.low);
  if (room <= 0) room = values.high == 0 ? 1 : kRoom * std::abs(values.high);
  plot->setAxisScale(axis, from_zero && values.low == 0 ? 0 : values.low - room, values.high + room);
}

}  // namespace

struct PlotView::Parts : public QObject {
  Parts(PlotView* owner, Selection* shared) : view(owner), selection(shared) {}

  PlotView* view;
  DressedTheme dressed{*view};
  Selection* selection;
  std::shared_ptr<const Reconstruction> reconstruction;
  CellMetrics figures;  ///< of its cells, once they are needed
  bool has_figures = false;
  CellReadings readings;
  /// At first what tells most at a glance: how well cells are known, farther and farther from the origin.
  PlotChoice choice{PlotSubject::Cells, Coloring::PathDistance, Coloring::PositionUncertainty, false};
  PlotData data;
  PlotPicture::Marks marks;
  bool is_stale = true;
  bool is_filling = false;  ///< boxes are being set, not changed by the operator

  QComboBox* subject_box = figureBox("plotSubject", PlotView::tr("What is plotted"));
  QComboBox* x_box = figureBox("plotAcross", PlotView::tr("Figure along the plot"));
  QComboBox* y_box = figureBox("plotUp", PlotView::tr("Figure up the plot"));
  QwtPlot* plot = named(new QwtPlot, "figurePlot");
  QwtPlotGrid* grid = new QwtPlotGrid;
  PlotPicture* picture = new PlotPicture;
  QLabel* summary = styledAs(paragraph("plotSummary"), "muted");
  PlotPointing pointing{plot, data, marks, *selection};
  QTimer readings_soon;

  void build() {
    plot->setAutoReplot(false);
    plot->setMinimumSize(120, 60);
    auto* canvas = static_cast<QwtPlotCanvas*>(plot->canvas());
    canvas->setFrameStyle(QFrame::NoFrame);
    canvas->setFocusIndicator(QwtPlotCanvas::CanvasFocusIndicator);
    canvas->setFocusPolicy(Qt::StrongFocus);
    setNames(canvas, QStringLiteral("figurePlotCanvas"), PlotView::tr("Plot"));
    canvas->setBackgroundRole(QPalette::Base);
    plot->setToolTip(PlotView::tr("Drag a rectangle to mark cells in all views, or use the arrow keys with Shift"));
    canvas->setMouseTracking(true);
    view->setFocusProxy(canvas);
    for (const int axis : {QwtPlot::xBottom, QwtPlot::yLeft}) {
      plot->setAxisScaleDraw(axis, new PlotScale);
      plot->setAxisMaxMinor(axis, 0);
    }
    grid->attach(plot);
    picture->attach(plot);
    picture->show(&data, &marks);

    // The boxes are the titles of the axes, and stand where these would.
    auto* layout = spaced(new QVBoxLayout(view), {10, 4, 10, 6}, 3);
    layout->addLayout(rowOf({{new QLabel(QStringLiteral("\u2191")), 0}, {y_box, 1}}));
    layout->addWidget(plot, 1);
    layout->addLayout(rowOf({{x_box, 1}, {new QLabel(QStringLiteral("\u2192")), 0}}));
    layout->addLayout(rowOf({{summary, 1}, {subject_box, 0}}));

    subject_box->addItem(PlotView::tr("cells"), static_cast<int>(PlotSubject::Cells));
    subject_box->addItem(PlotView::tr("links"), static_cast<int>(PlotSubject::Links));
    subject_box->setMinimumContentsLength(6);
    for (QComboBox* box : {subject_box, x_box, y_box}) {
      connect(box, qOverload<int>(&QComboBox::currentIndexChanged), this, [this] { takeBoxes(); });
    }
    setUpOnce(readings_soon, kReadingsEvery_ms, this, [this] {
      if (view->isVisible()) refresh();
    });
    connect(selection, &Selection::changed, this, [this] { markAnew(); });
    connect(selection, &Selection::brushedChanged, this, [this] { markAnew(); });
    dress();
  }

  void fillBoxes() {
    is_filling = true;
    subject_box->setCurrentIndex(subject_box->findData(static_cast<int>(choice.subject)));
    fillMetrics(x_box, false, codeOf(choice.x));
    fillMetrics(y_box, true, choice.is_histogram ? kHistogram : codeOf(choice.y));
    is_filling = false;
  }

  void fillMetrics(QComboBox* box, bool with_histogram, int code) {
    box->clear();
    if (with_histogram) box->addItem(PlotView::tr("how many (histogram)"), kHistogram);
    for (const PlotFigure& figure : plotMetrics(choice.subject)) {
      box->addItem(plotAxisTitle(choice.subject, figure), codeOf(figure));
      const QString why_not = whyNot(figure);
      if (why_not.isEmpty()) continue;
      const int row = box->count() - 1;
      box->setItemData(row, why_not, Qt::ToolTipRole);
      qobject_cast<QStandardItemModel*>(box->model())->item(row)->setEnabled(false);
    }
    box->setCurrentIndex(std::max(0, box->findData(code)));
  }

  /// Empty if at least one cell or link has the figure.
  QString whyNot(const PlotFigure& figure) const {
    if (!figure || !reconstruction) return {};
    if (choice.subject == PlotSubject::Cells) {
      return whyNoColoring(*figure, hasValues(*figure, figures, readings));
    }
    const auto of_link = coloringRow(*figure).of_link;
    for (const PatchReconstruction& patch : reconstruction->patches) {
      if (std::ranges::any_of(patch.links, [&](const LinkEstimate& link) { return link.used && of_link(link); }))
        return {};
    }
    return whyNoColoring(Coloring::Residual, false);
  }

  void takeBoxes() {
    if (is_filling) return;
    PlotChoice chosen;
    chosen.subject = static_cast<PlotSubject>(subject_box->currentData().toInt());
    const bool is_other_subject = chosen.subject != choice.subject;
    if (is_other_subject) {
      // Links have other figures than cells.
      const bool links = chosen.subject == PlotSubject::Links;
      chosen.x = links ? Coloring::Deviation : Coloring::PathDistance;
      chosen.y = links ? Coloring::Residual : Coloring::PositionUncertainty;
    } else {
      chosen.x = figureOf(x_box->currentData().toInt());
      const int y_code = y_box->currentData().toInt();
      chosen.is_histogram = y_code == kHistogram;
      chosen.y = chosen.is_histogram ? choice.y : figureOf(y_code);
    }
    view->setChoice(chosen);
  }

  void refresh() {
    is_stale = false;
    readings_soon.stop();
    if (!std::exchange(has_figures, true)) figures = reconstruction ? makeCellMetrics(*reconstruction) : CellMetrics();
    fillBoxes();
    data = makePlotData(reconstruction.get(), figures, readings, choice);
    pointing.restart();
    if (choice.is_histogram) {
      const auto fullest = std::ranges::max_element(data.bins, {}, &ValueBin::count);
      const double most = fullest == data.bins.end() ? 1 : static_cast<double>(fullest->count);
      setScale(plot, QwtPlot::yLeft, {0, most}, true);
      const bool any = !data.bins.empty();
      setScale(plot, QwtPlot::xBottom, any ? ColorRange{data.bins.front().lower, data.bins.back().upper} : ColorRange(),
               false);
    } else {
      setScale(plot, QwtPlot::xBottom, data.bounds(false), choice.x.has_value());
      setScale(plot, QwtPlot::yLeft, data.bounds(true), choice.y.has_value());
    }
    const QString reason = whyNot(choice.is_histogram || !whyNot(choice.x).isEmpty() ? choice.x : choice.y);
    picture->setHint(!reconstruction    ? PlotView::tr("The plot appears here as soon as a skin is open.")
                     : reason.isEmpty() ? PlotView::tr("Nothing has both figures.")
                                        : reason + QLatin1Char('.'));
    markAnew();
  }

  void markAnew() {
    if (is_stale) return;
    const auto isBrushed = [this](CellId cell) { return selection->isBrushed(cell); };
    marks.brushed.assign(data.points.size(), false);
    for (std::size_t k = 0; k < data.points.size(); ++k) {
      marks.brushed[k] = std::ranges::all_of(data.cellsOf(data.points[k]), isBrushed);
    }
    marks.picked = data.pickedIn(*selection);
    if (marks.picked) marks.picked_word = pointing.nameOf(*marks.picked);
    summarise();
    plot->replot();
  }

  void summarise() {
    QString text;
    if (reconstruction && !data.points.empty()) {
      const bool cells = choice.subject == PlotSubject::Cells;
      const auto count = static_cast<int>(data.points.size());
      const auto brushed = std::ranges::count(marks.brushed, true);
      text = cells ? PlotView::tr("%1 cells").arg(count) : PlotView::tr("%1 links").arg(count);
      if (brushed > 0) text += QStringLiteral(" · ") + PlotView::tr("%1 marked (Esc: none)").arg(brushed);
      if (data.unknown > 0) text += QStringLiteral(" · ") + PlotView::tr("%1 without a value").arg(data.unknown);
    }
    summary->setText(text);
    plot->canvas()->setAccessibleDescription(marks.picked ? pointing.describe(*marks.picked) : text);
  }

  /// Gathers the data anew, now or when the plot is shown.
  void renew() {
    is_stale = true;
    if (view->isVisible()) refresh();
  }

  void dress() {
    for (const int axis : {QwtPlot::xBottom, QwtPlot::yLeft}) plot->setAxisFont(axis, view->font());
    grid->setPen(QPen(Colors::of(view->palette()).border, 1));
    plot->replot();
  }
};

PlotView::PlotView(Selection* selection, QWidget* parent)
    : QWidget(parent), parts_(std::make_unique<Parts>(this, selection)) {
  setNames(this, QStringLiteral("plotView"), tr("Plot of the figures of cells and links"));
  parts_->build();
}

PlotView::~PlotView() {
  // The plot's items look at the data.
  delete parts_->plot;
}

void PlotView::setReconstruction(std::shared_ptr<const Reconstruction> reconstruction) {
  parts_->reconstruction = std::move(reconstruction);
  parts_->has_figures = false;
  parts_->renew();
}

void PlotView::setSurface(const std::shared_ptr<const SurfaceEvaluation>& surface) {
  parts_->readings.surface_distance_m.clear();
  if (surface) {
    for (std::size_t k = 0; k < surface->cells.size(); ++k) {
      parts_->readings.surface_distance_m[surface->cells[k]] = surface->distance_m[k];
    }
  }
  parts_->renew();
}

void PlotView::setReadings(const std::shared_ptr<const CellReadings>& readings) {
  const bool came = parts_->readings.acceleration_g.empty() && readings != nullptr;
  static const CellReadings kNone;
  const CellReadings& now = readings ? *readings : kNone;
  parts_->readings.acceleration_g = now.acceleration_g;
  parts_->readings.temperature_c = now.temperature_c;
  const PlotChoice& choice = parts_->choice;
  const bool is_shown =
      (choice.x && isReading(*choice.x)) || (!choice.is_histogram && choice.y && isReading(*choice.y));
  if (!is_shown && !came && readings) return;
  parts_->is_stale = true;
  if (isVisible() && !parts_->readings_soon.isActive()) parts_->readings_soon.start();
}

const PlotChoice& PlotView::choice() const { return parts_->choice; }

void PlotView::setChoice(const PlotChoice& choice) {
  parts_->choice = choice;
  parts_->renew();
}

const PlotData& PlotView::data() const { return parts_->data; }

QwtPlot* PlotView::plot() const { return parts_->plot; }

QPoint PlotView::positionOf(std::size_t point) const { return parts_->pointing.positionOf(point).toPoint(); }

QSize PlotView::sizeHint() const { return {36 * fontMetrics().averageCharWidth(), 16 * fontMetrics().height()}; }
QSize PlotView::minimumSizeHint() const { return {24 * fontMetrics().averageCharWidth(), 10 * fontMetrics().height()}; }

void PlotView::showEvent(QShowEvent* event) {
  if (parts_->is_stale) parts_->refresh();
  QWidget::showEvent(event);
}

void PlotView::changeEvent(QEvent* event) {
  QWidget::changeEvent(event);
  if (event->type() == QEvent::FontChange || parts_->dressed.isChangedBy(*event)) parts_->dress();
}

}  // namespace hexoderm
