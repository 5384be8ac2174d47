#include "tests/benchmarks/reproduce/trials.h"

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

/// A figure that the paper has of one trial, of a real skin.
struct PublishedFigure {
  std::string name;
  std::string unit;
  double paper = 0;
};

struct Experiment {
  std::string name;
  std::string patch;
  std::string surface;
  std::array<PublishedFigure, 2> figures;
};

/// Paper III.1: X17 on an aluminium cylinder. III.2: a line of eight cells around a cup, the gap between its two free
/// ends.
const std::array<Experiment, 2> kExperiments = {
    {{"X17",
      "x17",
      "cylinder:r=0.0501",
      {{{"X17 on r = 50.1 mm: Delta, eq. (20)", "mm", -0.30}, {"X17 on r = 50.1 mm: eps, eq. (21)", "mm", 1.62}}}},
     {"ring of 8",
      "ring8",
      "",
      {{{"ring of 8: loop gap", "mm", 10.46}, {"ring of 8: loop gap, share of loop", "%", 4.71}}}}}};

/// Notes both figures of an experiment, where the result has them.
void evaluate(Tally& tally, const std::string& method, const Experiment& experiment, const SimulatedSkin& skin,
              const Reconstruction& result) {
  const auto note = [&](double first, double second) {
    tally.note(method + experiment.figures[0].name, first);
    tally.note(method + experiment.figures[1].name, second);
  };
  if (skin.loop()) {
    if (const auto loop = measureLoop(skin, result)) note(toMillimetres(loop->length_m), loop->percent);
  } else if (const auto surface = fitCylinder(result, kPapersRadius_m)) {
    note(toMillimetres(*surface->delta_m), toMillimetres(*surface->epsilon_m));
  }
}

/// Median and range of a method's values.
Figure ofSpread(const std::string& title, const std::string& key, const Tally& tally, const std::string& name) {
  const auto at = [&](double fraction) { return tally.quantile(name, fraction).value_or(0); };
  return {title,
          formatFixed(at(0.5), 2) + " (" + formatFixed(at(0.05), 2) + " to " + formatFixed(at(0.95), 2) + ")",
          key,
          {{"skins", tally.of(name).size()}, {"p5", at(0.05)}, {"median", at(0.5)}, {"p95", at(0.95)}}};
}

void addRows(const Trials& trials, const Experiment& experiment, double sigma_mg, std::vector<FigureRow>& rows) {
  const SkinCase skin_case = {
      .patch = experiment.patch, .surface = experiment.surface, .poses = kPapersPoses, .offset_sigma_mg = sigma_mg};
  const std::string offsets = formatFixed(sigma_mg, 0) + " mg";
  const Tally tally = trials.run(experiment.name + ", " + offsets, [&](Tally& found, std::size_t seed) {
    SimulatedSkin skin = makeSkin(skin_case, seed);
    const auto snapshot = measure(skin, skin_case).snapshot();
    evaluate(found, "paper", experiment, skin, *reconstruct(*snapshot, papersMethod()));
    evaluate(found, "global", experiment, skin, *reconstruct(*snapshot));
  });
  for (const PublishedFigure& figure : experiment.figures) {
    rows.push_back({ofText("figure", "figure", figure.name),
                    {"offsets", offsets, "offset_sigma_mg", sigma_mg},
                    ofNumber("paper", "paper", figure.paper),
                    ofSpread("paper's method", "papers_method", tally, "paper" + figure.name),
                    ofSpread("global solver", "global", tally, "global" + figure.name),
                    ofText(" ", "unit", figure.unit)});
  }
}

}  // namespace

Json reproducePaper(const Trials& trials, bool prints) {
  std::vector<FigureRow> rows;
  for (const Experiment& experiment : kExperiments) {
    for (const double sigma_mg : kOffsetSigmas_mg) addRows(trials, experiment, sigma_mg, rows);
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
