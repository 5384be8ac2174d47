#include "widgets/verify/residual_plots.h"

#include "hexoderm/base/units.h"
#include "widgets/controls/panel_parts.h"
#include "widgets/controls/selection.h"
#include "widgets/style/dressed_theme.h"
#include "widgets/style/palette.h"
#include "widgets/words/formatting.h"

#include <qwt_picker_machine.h>
#include <qwt_plot.h>
#include <qwt_plot_canvas.h>
#include <qwt_plot_grid.h>
#include <qwt_plot_item.h>
#include <qwt_plot_marker.h>
#include <qwt_plot_picker.h>
#include <qwt_scale_draw.h>
#include <qwt_scale_engine.h>
#include <qwt_scale_map.h>
#include <QEvent>
#include <QHBoxLayout>
#include <QLabel>
#include <QLocale>
#include <QPainter>
#include <QVBoxLayout>
#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <utility>

namespace hexoderm {
namespace {

/// A residual of nothing at all has to stand somewhere on a log scale.
constexpr double kMin_deg = 0.001;

/// Numbers of poses instead of places in a list.
class PoseScale : public QwtScaleDraw {
 public:
  void setPoses(std::vector<PoseResiduals> poses) {
    poses_ = std::move(poses);
    invalidateCache();
  }
  [[nodiscard]] QwtText label(double value) const override {
    const auto place = std::llround(value);
    if (place < 1 || place > static_cast<long long>(poses_.size()) || std::abs(value - std::round(value)) > 1e-6) {
      return {};
    }
    return QString::number(poses_[static_cast<std::size_t>(place - 1)].pose.value());
  }

 private:
  std::vector<PoseResiduals> poses_;
};

/// Figures in the user's locale, without digits that say nothing.
class FigureScale : public QwtScaleDraw {
 public:
  [[nodiscard]] QwtText label(double value) const override { return QLocale().toString(value, 'g', 3); }
};

/// Something drawn in a plot's coordinates. Qwt 6.1's own curves are no valid C++20.
class DrawnItem : public QwtPlotItem {
 public:
  using Draw = std::function<void(QPainter&, const QwtScaleMap& x, const QwtScaleMap& y, const Colors&)>;

  DrawnItem(QwtPlot* plot, Draw draw) : draw_(std::move(draw)) {
    setItemAttribute(AutoScale);
    setRenderHint(RenderAntialiased);
    setZ(10);
    attach(plot);
  }
  /// What the scales have to show, y upwards.
  void setBounds(const QRectF& bounds) {
    bounds_ = bounds;
    itemChanged();
  }
  void draw(QPainter* painter, const QwtScaleMap& x, const QwtScaleMap& y, const QRectF&) const override {
    draw_(*painter, x, y, Colors::of(plot()->palette()));
  }
  [[nodiscard]] QRectF boundingRect() const override { return bounds_; }

 private:
  QRectF bounds_;
  Draw draw_;
};

void drawBoxes(const std::vector<PoseResiduals>& poses, QPainter& painter, const QwtScaleMap& x, const QwtScaleMap& y,
               const Colors& colors) {
  constexpr double kWidest = 26;
  const double half_width = std::max(1.0, std::min(kWidest, 0.6 * std::abs(x.transform(2) - x.transform(1))) / 2);
  painter.setPen(QPen(colors.accent, 1.4));
  painter.setBrush(colors.panel_active);
  for (std::size_t k = 0; k < poses.size(); ++k) {
    const double middle = x.transform(static_cast<double>(k + 1));
    const auto at = [&](double angle_rad) { return y.transform(toDegrees(angle_rad)); };
    const PoseResiduals& pose = poses[k];
    painter.drawLine(QPointF(middle, at(pose.least)), QPointF(middle, at(pose.largest)));
    painter.drawRect(QRectF(QPointF(middle - half_width, at(pose.upper_quartile)),
                            QPointF(middle + half_width, at(pose.lower_quartile))));
    painter.drawLine(QPointF(middle - half_width, at(pose.median)), QPointF(middle + half_width, at(pose.median)));
  }
}

void drawRanks(const std::vector<RankedLink>& links, QPainter& painter, const QwtScaleMap& x, const QwtScaleMap& y,
               const Colors& colors) {
  const auto pointOf = [&](std::size_t k, double angle_rad) {
    return QPointF(x.transform(static_cast<double>(k + 1)), y.transform(std::max(kMin_deg, toDegrees(angle_rad))));
  };
  painter.setBrush(Qt::NoBrush);
  painter.setPen(QPen(colors.text_muted, 1));
  for (std::size_t k = 0; k < links.size(); ++k) {
    if (links[k].sigma_rad) painter.drawEllipse(pointOf(k, *links[k].sigma_rad), 2.5, 2.5);
  }
  QPolygonF line;
  for (std::size_t k = 0; k < links.size(); ++k) line << pointOf(k, links[k].residual_rad);
  painter.setPen(QPen(colors.accent, 1.6));
  painter.drawPolyline(line);
  constexpr int kFewEnoughForDots = 100;
  if (line.size() > kFewEnoughForDots) return;
  painter.setBrush(colors.accent);
  for (const QPointF& point : line) painter.drawRect(QRectF(point - QPointF(1.5, 1.5), QSizeF(3, 3)));
}

void drawBins(const std::vector<ValueBin>& bins, QPainter& painter, const QwtScaleMap& x, const QwtScaleMap& y,
              const Colors& colors) {
  painter.setPen(QPen(colors.panel, 1));
  painter.setBrush(colors.accent);
  for (const ValueBin& bin : bins) {
    if (bin.count == 0) continue;
    painter.drawRect(QRectF(QPointF(x.transform(bin.lower), y.transform(static_cast<double>(bin.count))),
                            QPointF(x.transform(bin.upper), y.transform(0))));
  }
}

QWidget* titled(const QString& title, QwtPlot* plot) {
  auto* box = new QWidget;
  auto* layout = spaced(new QVBoxLayout(box), {0, 0, 0, 0}, 2);
  auto* label = styledAs(new QLabel(title), "muted");
  label->setWordWrap(true);
  layout->addWidget(label);
  layout->addWidget(plot, 1);
  return box;
}

}  // namespace

struct ResidualPlots::Parts {
  Parts(const QWidget& view, Selection* shared) : dressed(view), selection(shared) {
    for (QwtPlot* plot : plots) {
      plot->setMinimumSize(140, 70);
      static_cast<QwtPlotCanvas*>(plot->canvas())->setFrameStyle(QFrame::NoFrame);
      plot->canvas()->setFocusPolicy(Qt::StrongFocus);
      plot->canvas()->setBackgroundRole(QPalette::Base);
      plot->setAxisScaleDraw(QwtPlot::yLeft, new FigureScale);
      for (const int axis : {QwtPlot::xBottom, QwtPlot::yLeft}) plot->setAxisMaxMinor(axis, 0);
      auto* grid = new QwtPlotGrid;
      grid->enableX(false);
      grid->attach(plot);
      grids.push_back(grid);
    }
    pose_plot->setAxisScaleDraw(QwtPlot::xBottom, pose_scale);
    link_plot->setAxisScaleEngine(QwtPlot::yLeft, new QwtLogScaleEngine);
    ratio_plot->setAxisScaleDraw(QwtPlot::xBottom, new FigureScale);
    picked->setLineStyle(QwtPlotMarker::VLine);
    picked->attach(link_plot);
    as_predicted->setLineStyle(QwtPlotMarker::VLine);
    as_predicted->setXValue(1);
    as_predicted->setLabelAlignment(Qt::AlignRight | Qt::AlignTop);
    as_predicted->attach(ratio_plot);
  }

  DressedTheme dressed;
  Selection* selection;
  std::shared_ptr<const Reconstruction> reconstruction;
  ResidualSummary summary;
  bool stale = false;

  // Plots are owned by the widget, items by their plots.
  QwtPlot* pose_plot = named(new QwtPlot, "posePlot", ResidualPlots::tr("Residuals of each pose"));
  QwtPlot* link_plot = named(new QwtPlot, "linkPlot", ResidualPlots::tr("Residuals of the links, the worst first"));
  QwtPlot* ratio_plot =
      named(new QwtPlot, "ratioPlot", ResidualPlots::tr("Links by their residual beside the predicted deviation"));
  std::array<QwtPlot*, 3> plots = {pose_plot, link_plot, ratio_plot};
  PoseScale* pose_scale = new PoseScale;
  DrawnItem* boxes = new DrawnItem(pose_plot, std::bind_front(drawBoxes, std::cref(summary.poses)));
  DrawnItem* ranked = new DrawnItem(link_plot, std::bind_front(drawRanks, std::cref(summary.links)));
  QwtPlotMarker* picked = new QwtPlotMarker;
  DrawnItem* ratios = new DrawnItem(ratio_plot, std::bind_front(drawBins, std::cref(summary.ratios)));
  QwtPlotMarker* as_predicted = new QwtPlotMarker;
  std::vector<QwtPlotGrid*> grids;

  [[nodiscard]] const LinkEstimate& linkOf(const RankedLink& link) const {
    return reconstruction->patches[link.patch].links[link.link];
  }
};

ResidualPlots::ResidualPlots(Selection* selection, QWidget* parent)
    : QWidget(parent), parts_(std::make_unique<Parts>(*this, selection)) {
  Parts& parts = *parts_;
  auto* layout = spaced(new QHBoxLayout(this), {8, 2, 8, 4}, 14);
  layout->addWidget(titled(tr("By pose, ° (box: half the links)"), parts.pose_plot), 1);
  layout->addWidget(titled(tr("By link, ° (○ predicted)"), parts.link_plot), 1);
  layout->addWidget(titled(tr("Links by residual ÷ predicted"), parts.ratio_plot), 1);
  parts.as_predicted->setLabel(QwtText(tr("as predicted")));

  const auto whenClicked = [](QwtPlot* plot, auto&& act) {
    auto* picker = new QwtPlotPicker(plot->canvas());
    picker->setStateMachine(new QwtPickerClickPointMachine);
    connect(picker, qOverload<const QPointF&>(&QwtPlotPicker::selected), plot, act);
  };
  whenClicked(parts.link_plot, [this](const QPointF& at) {
    const std::vector<RankedLink>& links = parts_->summary.links;
    if (links.empty()) return;
    const auto rank = std::clamp<long long>(std::llround(at.x()) - 1, 0, static_cast<long long>(links.size()) - 1);
    const LinkEstimate& link = parts_->linkOf(links[static_cast<std::size_t>(rank)]);
    parts_->selection->selectLink(link.source, link.target);
  });
  whenClicked(parts.pose_plot, [this](const QPointF& at) {
    const std::vector<PoseResiduals>& poses = parts_->summary.poses;
    const auto place = std::llround(at.x()) - 1;
    if (place < 0 || place >= static_cast<long long>(poses.size())) return;
    emit posePicked(poses[static_cast<std::size_t>(place)].pose);
  });
  connect(selection, &Selection::changed, this, &ResidualPlots::showPicked);
  dress();
}

ResidualPlots::~ResidualPlots() = default;

QwtPlot* ResidualPlots::linkPlot() const { return parts_->link_plot; }

QPoint ResidualPlots::positionOfRank(std::size_t rank) const {
  const double x = parts_->link_plot->transform(QwtPlot::xBottom, static_cast<double>(rank + 1));
  return {static_cast<int>(std::lround(x)), parts_->link_plot->canvas()->height() / 2};
}

void ResidualPlots::setReconstruction(std::shared_ptr<const Reconstruction> reconstruction) {
  parts_->reconstruction = std::move(reconstruction);
  parts_->stale = true;
  if (isVisible()) refresh();
}

void ResidualPlots::showEvent(QShowEvent* event) {
  if (parts_->stale) refresh();
  QWidget::showEvent(event);
}

void ResidualPlots::resizeEvent(QResizeEvent* event) {
  QWidget::resizeEvent(event);
  // As many numbers as fit above each other; headings and the lower axis take about four lines.
  constexpr int kMax = 6;
  const int line = fontMetrics().height();
  const int steps = std::clamp((height() - 4 * line) / (2 * line), 1, kMax);
  for (QwtPlot* plot : parts_->plots) {
    plot->setAxisMaxMajor(QwtPlot::yLeft, steps);
    plot->replot();
  }
}

void ResidualPlots::refresh() {
  Parts& parts = *parts_;
  parts.stale = false;
  parts.summary = parts.reconstruction ? summariseResiduals(*parts.reconstruction) : ResidualSummary();

  const std::vector<PoseResiduals>& poses = parts.summary.poses;
  const double pose_count = std::max(1.0, static_cast<double>(poses.size()));
  const auto highest = std::ranges::max_element(poses, {}, &PoseResiduals::largest);
  parts.boxes->setBounds({0.5, 0, pose_count, highest == poses.end() ? 1 : toDegrees(highest->largest)});
  parts.pose_scale->setPoses(poses);
  parts.pose_plot->setAxisScale(QwtPlot::xBottom, 0.5, pose_count + 0.5, std::ceil(pose_count / 12));

  const std::vector<RankedLink>& links = parts.summary.links;
  const double link_count = std::max(1.0, static_cast<double>(links.size()));
  double lowest_deg = links.empty() ? 0.1 : toDegrees(links.back().residual_rad);
  double highest_deg = links.empty() ? 1 : toDegrees(links.front().residual_rad);
  for (const RankedLink& link : links) {
    const double predicted_deg = toDegrees(link.sigma_rad.value_or(link.residual_rad));
    lowest_deg = std::min(lowest_deg, predicted_deg);
    highest_deg = std::max(highest_deg, predicted_deg);
  }
  lowest_deg = std::max(kMin_deg, lowest_deg);
  parts.ranked->setBounds({0.5, lowest_deg, link_count, std::max(lowest_deg, highest_deg) - lowest_deg});
  parts.link_plot->setAxisScale(QwtPlot::xBottom, 0.5, link_count + 0.5);

  const std::vector<ValueBin>& bins = parts.summary.ratios;
  const double widest = bins.empty() ? 2 : std::max(2.0, bins.back().upper);
  const auto fullest = std::ranges::max_element(bins, {}, &ValueBin::count);
  parts.ratios->setBounds({0, 0, widest, fullest == bins.end() ? 1 : static_cast<double>(fullest->count)});
  parts.ratio_plot->setAxisScale(QwtPlot::xBottom, 0, widest);
  parts.pose_plot->replot();
  parts.ratio_plot->replot();
  showPicked();
}

void ResidualPlots::showPicked() {
  Parts& parts = *parts_;
  if (parts.stale) return;
  const auto& links = parts.summary.links;
  const auto found = std::ranges::find_if(links, [&](const RankedLink& ranked) {
    const LinkEstimate& link = parts.linkOf(ranked);
    return parts.selection->link() == Selection::Link(link.source, link.target);
  });
  const bool is_shown = found != links.end();
  parts.picked->setVisible(is_shown);
  parts.picked->setXValue(static_cast<double>(found - links.begin() + 1));
  parts.link_plot->setToolTip(is_shown ? linkToolTip(*parts.reconstruction, parts.linkOf(*found))
                                       : tr("Click a link to pick it."));
  parts.link_plot->replot();
}

void ResidualPlots::changeEvent(QEvent* event) {
  QWidget::changeEvent(event);
  if (event->type() == QEvent::FontChange || parts_->dressed.isChangedBy(*event)) dress();
}

void ResidualPlots::dress() {
  Parts& parts = *parts_;
  const Colors& colors = Colors::of(palette());
  for (QwtPlot* plot : parts.plots) {
    for (const int axis : {QwtPlot::xBottom, QwtPlot::yLeft}) plot->setAxisFont(axis, font());
  }
  for (QwtPlotGrid* grid : parts.grids) grid->setPen(QPen(colors.border, 1));
  parts.picked->setLinePen(QPen(colors.selection, 2));
  parts.as_predicted->setLinePen(QPen(colors.text, 1.4, Qt::DashLine));
  QwtText label = parts.as_predicted->label();
  label.setColor(colors.text);
  parts.as_predicted->setLabel(label);
  for (QwtPlot* plot : parts.plots) plot->replot();
}

}  // namespace hexoderm
