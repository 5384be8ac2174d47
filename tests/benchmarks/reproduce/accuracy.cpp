#include "tests/benchmarks/reproduce/trials.h"

#include "hexoderm/base/text.h"
#include "hexoderm/base/units.h"
#include "hexoderm/solve/reconstructor.h"

#include <algorithm>
#include <cmath>
#include <deque>
#include <iostream>
#include <map>

namespace hexoderm::cli {
namespace {

/// A figure of a case by all methods, and what was aimed at.
struct Line {
  std::string figure;
  std::string unit = "mm";
  std::optional<double> bar_matching = {};
  std::optional<double> bar_fit = {};
  std::optional<double> bound = {};
};

struct AccuracyCase {
  std::string name;
  SkinCase skin;
  std::vector<Line> lines;
};

const std::string kOrientation = "orientation";
const std::string kPosition = "position";
const std::string kEpsilon = "cylinder error, eq. (21)";
const std::string kGap = "loop gap, vector";  ///< length of (estimated - true) gap
const std::string kChainedGap = "the same, orientations known (d)";
const std::string kGapLength = "loop gap, length";  ///< difference of the lengths of estimated and true gap
const std::string kShareOff = "s off the law's";
const std::string kShareSigma = "stated sigma of s";

std::vector<AccuracyCase> accuracyCases() {
  constexpr const char* kCylinder = "cylinder:r=0.0501";
  std::vector<AccuracyCase> cases;
  const auto x17 = [&](std::size_t poses, double bar, std::optional<double> bound) {
    cases.push_back(
        {"X17", {.patch = "x17", .surface = kCylinder, .poses = poses}, {{kOrientation, "deg", bar, bar, bound}}});
  };
  x17(2, 2.8, {});
  x17(3, 0.70, 0.71);
  x17(6, 0.36, 0.37);
  cases.push_back({"100 cells (b)",
                   {.patch = "sheet:10x10", .surface = "cylinder:r=0.08", .poses = 2},
                   {{kOrientation, "deg", 1.8, 1.8}}});
  const auto laws = {LinkLaw::Bend, LinkLaw::Surface};
  for (const LinkLaw law : laws) {
    cases.push_back({"X17",
                     {.patch = "x17", .surface = kCylinder, .law = law},
                     {{kPosition, "mm", 0.90, 1.05, 0.80}, {kEpsilon, "mm", 0.40, 0.75}}});
  }
  for (const LinkLaw law : laws) {
    cases.push_back({"ring of 8", {.patch = "ring8", .law = law}, {{kGap, "mm", 0.6}, {kChainedGap}, {kGapLength}}});
    cases.push_back({"ring of 8, no jitter",
                     {.patch = "ring8", .law = law, .jitter = false},
                     {{kGap}, {kChainedGap}, {kGapLength}}});
    cases.push_back({"ring of 8, closed (c)",
                     {.patch = "ring8:closed", .law = law},
                     {{kShareOff, "", {}, 0.25}, {kShareSigma, ""}}});
  }
  for (const LinkLaw law : laws) {
    cases.push_back({"1,000 cells (a)",
                     {.patch = "sheet:25x40", .surface = "cylinder:r=0.2", .law = law},
                     {{kPosition, "mm", 0.70, {}, 0.62}}});
  }
  return cases;
}

/// The link points of the loop's ends, apart, in the frame that `T` maps cells to.
template <class Placement>
Eigen::Vector3d gapOf(const SimulatedSkin& skin, const Placement& T) {
  const auto at = [&](LinkEnd end) -> Eigen::Vector3d { return T(end.cell) * skin.model().port(end.port).vector_m; };
  return at(skin.loop()->first) - at(skin.loop()->second);
}

/// The neighbour's centre if it is turned by R_c_n: eq. (2), or the same with a share of the arc's stretch
/// (core/hexoderm/solve/README.md, gap share).
Eigen::Vector3d neighborCentre(const Port& c, const Port& n, const Eigen::Matrix3d& R_c_n, LinkLaw law) {
  const Eigen::Vector3d pivot = c.vector_m - R_c_n * n.vector_m;
  if (law == LinkLaw::Bend) return pivot;
  const Eigen::Vector3d u_c = c.vector_m.normalized();
  const Eigen::Vector3d u_n = R_c_n * n.vector_m.normalized();
  const double half_bend = angleBetween(u_c, -u_n) / 2;
  return pivot + 2.0 / 3.0 * c.vector_m.norm() * half_bend * half_bend * (u_c - u_n).normalized();
}

/// Error of the loop gap, mm, if all orientations are known exactly: cells askew in the mould still lead the chain
/// astray.
double chainedGapError(const SimulatedSkin& skin, const GroundTruth& truth) {
  std::map<CellId, SE3> placed;
  placed[skin.neighbors().front().id] = truePlacement(truth, skin.neighbors().front().id);
  std::deque<CellId> next = {skin.neighbors().front().id};
  while (!next.empty()) {
    const CellId id = next.front();
    next.pop_front();
    const SE3 T_b_c = placed[id];
    for (const NeighborReport& link : linksOf(skin, id)) {
      if (placed.contains(link.cell)) continue;
      const SE3 T_b_n = truePlacement(truth, link.cell);
      const Eigen::Vector3d t_c_n = neighborCentre(skin.model().port(link.port), skin.model().port(*link.cell_port),
                                                   T_b_c.R.transpose() * T_b_n.R, skin.options().link_law);
      placed[link.cell] = {T_b_n.R, T_b_c * t_c_n};
      next.push_back(link.cell);
    }
  }
  const auto chained = gapOf(skin, [&](CellId id) { return placed.at(id); });
  return toMillimetres((chained - gapOf(skin, [&](CellId id) { return truePlacement(truth, id); })).norm());
}

/// Notes the errors of one reconstruction against the truth, of the figures that it has.
void judge(Tally& tally, const std::string& method, const SimulatedSkin& skin, const GroundTruth& truth,
           const Reconstruction& result) {
  const auto note = [&](const std::string& figure, double error) { tally.note(method + figure, error); };
  const PatchReconstruction& patch = *largestPatch(result);
  for (const Comparison& comparison : compareToTruth(result, truth)) {
    if (comparison.patch != patch.id) continue;
    note(kOrientation, toDegrees(comparison.orientation_rms_rad));
    note(kPosition, toMillimetres(comparison.position_rms_m));
  }
  if (skin.options().patch == "x17") {
    constexpr double kRadius_m = 0.0501;
    if (const auto cylinder = fitCylinder(result, kRadius_m)) note(kEpsilon, toMillimetres(*cylinder->epsilon_m));
  }
  if (skin.loop()) {
    if (const auto loop = measureLoop(skin, result)) {
      const SE3 T_o_b = truePlacement(truth, patch.origin).inverse();
      const Eigen::Vector3d true_gap = gapOf(skin, [&](CellId id) { return T_o_b * truePlacement(truth, id); });
      note(kGap, toMillimetres((loop->gap_m - true_gap).norm()));
      note(kGapLength, toMillimetres(std::abs(loop->length_m - true_gap.norm())));
    }
  }
  if (patch.gap_share && patch.gap_share->sigma > 0) {
    note(kShareOff, std::abs(patch.gap_share->share - (skin.options().link_law == LinkLaw::Bend ? 0 : 1)));
    note(kShareSigma, patch.gap_share->sigma);
  }
}

/// One skin by all methods.
void runTrial(Tally& tally, const SkinCase& skin_case, std::size_t seed) {
  SimulatedSkin skin = makeSkin(skin_case, seed);
  const Session session = measure(skin, skin_case);
  const auto snapshot = session.snapshot();
  const auto judgeBy = [&](const std::string& method, const SolverOptions& options) {
    judge(tally, method, skin, *session.truth(), *reconstruct(*snapshot, options));
  };
  SolverOptions matching;
  SolverOptions other;
  matching.gap_model = skin_case.law == LinkLaw::Bend ? GapModel::Pivot : GapModel::Arc;
  other.gap_model = skin_case.law == LinkLaw::Bend ? GapModel::Arc : GapModel::Pivot;
  judgeBy("paper", papersMethod());
  judgeBy("match", matching);
  judgeBy("other", other);
  judgeBy("fit", {});
  if (skin.loop()) tally.note("match" + kChainedGap, chainedGapError(skin, *session.truth()));
}

/// Rms of (d) over skins, by hand. Yaw leads the chain sideways and tilt out of the surface, by a pitch per cell askew
/// and half of one at either end; both ends themselves lie beside their places.
double jitterBound_m() {
  const SimulatedSkinOptions jitter;
  const double pitch_m = 2 * builtInCellModel("hex-bma150").reach_m();
  constexpr double kCells = 6 + 2 * 0.25;
  return std::sqrt(kCells * pitch_m * pitch_m *
                       (std::pow(jitter.yaw_jitter_rad, 2) + std::pow(jitter.tilt_jitter_rad, 2)) +
                   2 * 3 * jitter.position_jitter_m * jitter.position_jitter_m);
}

/// Medians over the skins that have the figure.
FigureRow figuresOf(const AccuracyCase& what, const Line& line, const Tally& tally, std::size_t seeds) {
  std::size_t skins = seeds;  // with a result by every method that is shown
  for (const char* method : {"paper", "match", "other", "fit"}) {
    const std::size_t of_method = tally.of(method + line.figure).size();
    if (of_method > 0) skins = std::min(skins, of_method);
  }
  const auto orDash = [](const std::optional<double>& bar) { return bar ? formatFixed(*bar, 2) : "-"; };
  const auto within = [](const auto& value, const auto& bar) { return !bar || (value && *value <= *bar); };
  const auto matching = tally.median("match" + line.figure);
  const auto fit = tally.median("fit" + line.figure);
  const bool has_bar = line.bar_matching || line.bar_fit;
  const int decimals = line.bar_matching == line.bar_fit && line.bar_fit ? 3 : 2;
  return {ofText("figure", "figure", what.name + ": " + line.figure),
          ofText("law", "link_law", std::string(linkLawName(what.skin.law))),
          ofCount("poses", "poses", what.skin.poses),
          ofCount("", "skins", skins),
          ofNumber("paper", "papers_method", tally.median("paper" + line.figure)),
          ofNumber("match", "matching", matching, decimals),
          ofNumber("other", "mismatching", tally.median("other" + line.figure), decimals),
          ofNumber("fit", "fit", fit, decimals),
          ofText("unit", "unit", line.unit),
          ofText("bars", "", has_bar ? orDash(line.bar_matching) + " / " + orDash(line.bar_fit) : "-"),
          ofNumber("", "bar_matching", line.bar_matching),
          ofNumber("", "bar_fit", line.bar_fit),
          ofNumber("bound", "bound", line.bound),
          ofBar(has_bar, within(matching, line.bar_matching) && within(fit, line.bar_fit))};
}

void print(const std::vector<FigureRow>& rows, std::size_t seeds) {
  std::cout
      << "Accuracy on simulated skins, offsets of 60 mg, hand-held: medians over " << seeds << " skins.\n"
      << "Paper: --solver tree --centre off, no link judged. The others: the global solver with the gap model that\n"
      << "the simulator's link law obeys, with the other one, and with fit (default). Bars: for the matching model\n"
      << "and for fit. Bound: Cramer-Rao, rms, from an earlier study, not computed here; medians may lie below.\n\n";
  printTable(rows);
  std::cout
      << "\n(a) sheet:25x40 on cylinder:r=0.2. (b) sheet:10x10 on cylinder:r=0.08.\n"
      << "(c) The law's s is 0 for bend and 1 for surface. A ring whose links all bend alike does not reveal s: the\n"
      << "    closing condition of a regular polygon holds for any pitch. fit must stay at its prior, 0.5 +- 0.5,\n"
      << "    and say so; a median of |s - law's| near 0.5 is the right answer, whatever the bar.\n"
      << "(d) Every orientation known exactly, positions chained by the matching model. Cells that sit askew in\n"
      << "    the mould lead the chain astray: 1 degree of yaw and 0.5 of tilt times a pitch of "
      << millimetres(2 * builtInCellModel("hex-bma150").reach_m(), 1) << " per\n"
      << "    cell (half at both ends), and both ends 0.2 mm beside their places. By hand "
      << millimetres(jitterBound_m()) << " rms for 8 cells.\n"
      << "    Gravity says nothing about it. Without jitter the same figure shows what orientations leave.\n";
}

}  // namespace

Json tabulateAccuracy(const Trials& trials, bool prints) {
  std::vector<FigureRow> rows;
  for (const AccuracyCase& what : accuracyCases()) {
    const Tally tally = trials.run(what.name + ", " + std::string(linkLawName(what.skin.law)),
                                   [&](Tally& found, std::size_t seed) { runTrial(found, what.skin, seed); });
    for (const Line& line : what.lines) rows.push_back(figuresOf(what, line, tally, trials.seeds()));
  }
  if (prints) print(rows, trials.seeds());
  return {{"jitter_bound_rms_mm", toMillimetres(jitterBound_m())}, {"rows", toJson(rows)}};
}

}  // namespace hexoderm::cli
