#include "widgets/plot/plot_data.h"

#include "widgets/coloring/coloring.h"
#include "widgets/words/formatting.h"

#include <QCoreApplication>
#include <QLocale>
#include <algorithm>
#include <cmath>

namespace hexoderm {
namespace {

struct PlotWords {
  Q_DECLARE_TR_FUNCTIONS(hexoderm::PlotData)
};

bool isPlotted(PlotSubject subject, const ColoringRow& row) {
  return subject == PlotSubject::Links ? row.of_link != nullptr : row.of_cell != nullptr;
}

std::optional<double> valueOf(const PlotFigure& figure, const CellMetrics& figures, const CellReadings& readings,
                              std::size_t cell) {
  if (!figure) return static_cast<double>(figures.cells[cell].value());
  return coloringRow(*figure).of_cell(figures, readings, cell);
}

std::optional<double> valueOf(const PlotFigure& figure, const LinkEstimate& link) {
  if (!figure) return static_cast<double>(std::min(link.source.cell, link.target.cell).value());
  return coloringRow(*figure).of_link(link);
}

/// Adds the point if its figures are known and finite.
void addPoint(PlotData& data, PlotPoint point, std::optional<double> x, std::optional<double> y) {
  if (!x || !y || !std::isfinite(*x) || !std::isfinite(*y)) {
    ++data.unknown;
    return;
  }
  point.x = *x;
  point.y = *y;
  data.points.push_back(point);
}

void addCells(const CellMetrics& figures, const CellReadings& readings, PlotData& data) {
  for (std::size_t k = 0; k < figures.cells.size(); ++k) {
    const auto y = data.choice.is_histogram ? 0 : valueOf(data.choice.y, figures, readings, k);
    addPoint(data, {figures.cells[k], std::nullopt}, valueOf(data.choice.x, figures, readings, k), y);
  }
}

void addLinks(const Reconstruction& reconstruction, PlotData& data) {
  for (const PatchReconstruction& patch : reconstruction.patches) {
    for (const LinkEstimate& link : patch.links) {
      if (!link.used) continue;
      const auto y = data.choice.is_histogram ? 0 : valueOf(data.choice.y, link);
      addPoint(data, {link.source.cell, Selection::linkOf(link.source, link.target)}, valueOf(data.choice.x, link), y);
    }
  }
}

}  // namespace

std::vector<PlotFigure> plotMetrics(PlotSubject subject) {
  std::vector<PlotFigure> figures = {std::nullopt};
  for (const ColoringRow& row : coloringTable()) {
    if (isPlotted(subject, row)) figures.emplace_back(row.coloring);
  }
  return figures;
}

QString plotFigureName(PlotSubject subject, PlotFigure figure) {
  if (!figure) return PlotWords::tr("number of the cell");
  const ColoringRow& row = coloringRow(*figure);
  const char* title = subject == PlotSubject::Links ? row.graph_title : row.patch_title;
  return QCoreApplication::translate("hexoderm::Coloring", title != nullptr ? title : row.name);
}

QString plotAxisTitle(PlotSubject subject, PlotFigure figure) {
  if (!figure) return plotFigureName(subject, figure);
  return subject == PlotSubject::Links ? graphTitle(*figure) : patchTitle(*figure);
}

QString plotValueText(PlotFigure figure, double value) {
  if (!figure) return QLocale().toString(value, 'f', 0);
  constexpr int kDigits = 3;
  const int before = value == 0 ? 1 : static_cast<int>(std::floor(std::log10(std::abs(value)))) + 1;
  const QString number = figureText(value, std::clamp(kDigits - before, 0, kDigits));
  const QString unit = QString::fromUtf8(coloringRow(*figure).unit);
  return unit == QStringLiteral("°") || unit.isEmpty() ? number + unit : number + QChar(QChar::Nbsp) + unit;
}

std::vector<PlotLimit> plotLimits(PlotFigure figure) {
  if (!figure) return {};
  if (const auto goal = coloringRow(*figure).goal) return {{*goal, PlotWords::tr("goal")}};
  if (*figure == Coloring::ReadingNorm) return {{1, PlotWords::tr("at rest")}};
  if (*figure == Coloring::SurfaceDistance) return {{0, PlotWords::tr("the surface")}};
  return {};
}

std::vector<CellId> PlotData::cellsOf(const PlotPoint& point) const {
  if (!point.link) return {point.cell};
  return {point.link->first.cell, point.link->second.cell};
}

std::optional<std::size_t> PlotData::pickedIn(const Selection& selection) const {
  const auto found = std::ranges::find_if(points, [&](const PlotPoint& point) {
    return point.link ? selection.link() == point.link : selection.cell() == point.cell;
  });
  return found == points.end() ? std::nullopt : std::optional<std::size_t>(found - points.begin());
}

ColorRange PlotData::bounds(bool along_y) const {
  if (points.empty()) return {};
  const auto value = along_y ? &PlotPoint::y : &PlotPoint::x;
  const auto [least, largest] = std::ranges::minmax_element(points, {}, value);
  return {(*least).*value, (*largest).*value};
}

PlotData makePlotData(const Reconstruction* reconstruction, const CellMetrics& figures, const CellReadings& readings,
                      const PlotChoice& choice) {
  PlotData data;
  data.choice = choice;
  if (reconstruction == nullptr) return data;
  if (choice.subject == PlotSubject::Cells) {
    addCells(figures, readings, data);
  } else {
    addLinks(*reconstruction, data);
  }
  if (choice.is_histogram) {
    std::vector<double> values;
    values.reserve(data.points.size());
    for (const PlotPoint& point : data.points) values.push_back(point.x);
    data.bins = binValues(values);
  }
  return data;
}

}  // namespace hexoderm
