#include "tests/benchmarks/reproduce/experiments.h"

#include "hexoderm/base/text.h"
#include "hexoderm/base/units.h"
#include "hexoderm/solve/reconstructor.h"

#include <array>
#include <iostream>

namespace hexoderm::cli {
namespace {

constexpr std::array kOffsetSigmas_mg = {20.0, 60.0, 100.0};
constexpr double kPapersRadius_m = 0.0501;
constexpr std::size_t kPapersPoses = 2;

/// One figure of the paper, measured over all seeds.
struct PaperRow {
  std::string figure;
  std::string unit;
  double offset_sigma_mg = 0;
  double paper = 0;  ///< one trial, of a real skin
  std::vector<double> papers_method;
  std::vector<double> global;
};

struct TwoMetrics {
  std::optional<double> first;
  std::optional<double> second;
};

struct BothMethods {
  TwoMetrics papers_method;
  TwoMetrics global;
};

std::string spread(const std::vector<double>& values) {
  return formatFixed(median(values), 2) + " (" + formatFixed(quantile(values, 0.05), 2) + " to " +
         formatFixed(quantile(values, 0.95), 2) + ")";
}

Json summaryOf(const std::vector<double>& values) {
  return {{"skins", values.size()},
          {"p5", quantile(values, 0.05)},
          {"median", median(values)},
          {"p95", quantile(values, 0.95)}};
}

FigureRow figuresOf(const PaperRow& row) {
  return {ofText("figure", "figure", row.figure),
          {"offsets", formatFixed(row.offset_sigma_mg, 0) + " mg", "offset_sigma_mg", row.offset_sigma_mg},
          ofNumber("paper", "paper", row.paper),
          {"paper's method", spread(row.papers_method), "papers_method", summaryOf(row.papers_method)},
          {"global solver", spread(row.global), "global", summaryOf(row.global)},
          ofText(" ", "unit", row.unit)};
}

template <class Evaluate>
void addRows(const Trials& trials, const std::string& what, const SkinCase& skin_case, PaperRow first, PaperRow second,
             const Evaluate& evaluate, std::vector<FigureRow>& rows) {
  const auto results = trials.run(what, trials.seeds(), [&](std::size_t seed) {
    SimulatedSkin skin = makeSkin(skin_case, seed);
    const auto snapshot = measure(skin, skin_case).snapshot();
    return BothMethods{evaluate(skin, *reconstruct(*snapshot, papersMethod())),
                       evaluate(skin, *reconstruct(*snapshot, globalSolver()))};
  });
  first.offset_sigma_mg = second.offset_sigma_mg = skin_case.offset_sigma_mg;
  for (const BothMethods& result : results) {
    const auto keep = [](const std::optional<double>& value, std::vector<double>& values) {
      if (value) values.push_back(*value);
    };
    keep(result.papers_method.first, first.papers_method);
    keep(result.papers_method.second, second.papers_method);
    keep(result.global.first, first.global);
    keep(result.global.second, second.global);
  }
  for (const PaperRow* row : {&first, &second}) rows.push_back(figuresOf(*row));
}

/// Paper III.1: X17 on an aluminium cylinder.
TwoMetrics evaluateShape(const SimulatedSkin& /*skin*/, const Reconstruction& result) {
  const auto surface = fitCylinder(result, kPapersRadius_m);
  if (!surface) return {};
  return {toMillimetres(*surface->delta_m), toMillimetres(*surface->epsilon_m)};
}

/// Paper III.2: a line of eight cells around a cup, the gap between its two free ends.
TwoMetrics evaluateGap(const SimulatedSkin& skin, const Reconstruction& result) {
  const auto loop = measureLoop(skin, result);
  if (!loop) return {};
  return {toMillimetres(loop->length_m), loop->percent};
}

}  // namespace

nlohmann::ordered_json reproducePaper(const Trials& trials, bool prints) {
  std::vector<FigureRow> rows;
  for (const double sigma : kOffsetSigmas_mg) {
    addRows(trials, "X17, " + formatFixed(sigma, 0) + " mg",
            {.patch = "x17", .surface = "cylinder:r=0.0501", .poses = kPapersPoses, .offset_sigma_mg = sigma},
            {"X17 on r = 50.1 mm: Delta, eq. (20)", "mm", 0, -0.30, {}, {}},
            {"X17 on r = 50.1 mm: eps, eq. (21)", "mm", 0, 1.62, {}, {}}, evaluateShape, rows);
  }
  for (const double sigma : kOffsetSigmas_mg) {
    addRows(trials, "ring of 8, " + formatFixed(sigma, 0) + " mg",
            {.patch = "ring8", .surface = "", .poses = kPapersPoses, .offset_sigma_mg = sigma},
            {"ring of 8: loop gap", "mm", 0, 10.46, {}, {}},
            {"ring of 8: loop gap, share of loop", "%", 0, 4.71, {}, {}}, evaluateGap, rows);
  }
  if (prints) {
    std::cout << "The paper's two experiments, simulated: " << trials.seeds() << " skins and hands per row, "
              << kPapersPoses
              << " poses.\nMedian (5 % to 95 %). The paper's figures are one trial each, of real skins.\n"
              << "The simulated cup closes the ring but for what the cells lie beside their places.\n"
              << "Paper's method: --solver tree --centre off, no link judged. Ours: the global solver, defaults.\n\n";
    printTable(rows);
  }
  return {{"poses", kPapersPoses}, {"rows", toJson(rows)}};
}

}  // namespace hexoderm::cli
