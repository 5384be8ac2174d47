#include "tests/benchmarks/reproduce/experiments.h"

#include "hexoderm/base/text.h"
#include "hexoderm/base/units.h"
#include "hexoderm/solve/reconstructor.h"

#include <array>
#include <cmath>
#include <deque>
#include <functional>
#include <iostream>
#include <map>

namespace hexoderm::cli {
namespace {

constexpr double kRadius_m = 0.0501;

/// Errors of one reconstruction against the truth. Figures that it does not have stay empty.
struct Errors {
  std::optional<double> orientation_deg;
  std::optional<double> position_mm;
  std::optional<double> epsilon_mm;
  std::optional<double> gap_mm;         ///< length of (estimated - true) loop gap
  std::optional<double> gap_length_mm;  ///< difference of the lengths of estimated and true loop gap
  std::optional<double> share_off;      ///< |s - the law's s|
  std::optional<double> share_sigma;
};

using ErrorOf = std::optional<double> Errors::*;

/// One skin by all methods.
struct Methods {
  Errors papers;
  Errors matching;
  Errors other;
  Errors fit;
  /// The loop gap if every orientation were known exactly and the cells sat straight in their links.
  std::optional<double> chained_gap_mm;
};

/// One line of the table of a case.
struct Line {
  std::string figure;
  std::string unit;
  ErrorOf value = nullptr;
  std::optional<double> bar_matching = {};
  std::optional<double> bar_fit = {};
  std::optional<double> bound = {};
};

struct AccuracyRow {
  Line line;
  LinkLaw law{};
  std::size_t poses = 0;
  std::size_t skins = 0;  ///< with a result by every method that is shown
  std::optional<double> papers = {};
  std::optional<double> matching = {};
  std::optional<double> other = {};
  std::optional<double> fit = {};

  [[nodiscard]] bool hasBar() const { return line.bar_matching || line.bar_fit; }
  [[nodiscard]] bool reached() const {
    const auto within = [](const auto& value, const auto& bar) { return !bar || (value && *value <= *bar); };
    return within(matching, line.bar_matching) && within(fit, line.bar_fit);
  }
};

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
    for (const NeighborReport& link : std::ranges::find(skin.neighbors(), id, &CellReport::id)->neighbors) {
      if (link.cell.value() == 0 || placed.contains(link.cell)) continue;
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

Errors judge(const SimulatedSkin& skin, const GroundTruth& truth, const Reconstruction& result, double true_share) {
  Errors errors;
  const PatchReconstruction& patch = *largestPatch(result);
  for (const Comparison& comparison : compareToTruth(result, truth)) {
    if (comparison.patch != patch.id) continue;
    errors.orientation_deg = toDegrees(comparison.orientation_rms_rad);
    errors.position_mm = toMillimetres(comparison.position_rms_m);
  }
  if (skin.options().patch == "x17") {
    if (const auto cylinder = fitCylinder(result, kRadius_m)) errors.epsilon_mm = toMillimetres(*cylinder->epsilon_m);
  }
  if (skin.loop()) {
    if (const auto loop = measureLoop(skin, result)) {
      const SE3 T_o_b = truePlacement(truth, patch.origin).inverse();
      const Eigen::Vector3d true_gap = gapOf(skin, [&](CellId id) { return T_o_b * truePlacement(truth, id); });
      errors.gap_mm = toMillimetres((loop->gap_m - true_gap).norm());
      errors.gap_length_mm = toMillimetres(std::abs(loop->length_m - true_gap.norm()));
    }
  }
  if (patch.gap_share && patch.gap_share->sigma > 0) {
    errors.share_off = std::abs(patch.gap_share->share - true_share);
    errors.share_sigma = patch.gap_share->sigma;
  }
  return errors;
}

class AccuracyTable {
 public:
  explicit AccuracyTable(const Trials& trials) : trials_(trials) {}

  std::vector<AccuracyRow> run() {
    orientations();
    for (const LinkLaw law : {LinkLaw::Bend, LinkLaw::Surface}) {
      addCase("X17", {.patch = "x17", .surface = kCylinder, .law = law, .poses = 3},
              {{"position", "mm", &Errors::position_mm, 0.90, 1.05, 0.80},
               {"cylinder error, eq. (21)", "mm", &Errors::epsilon_mm, 0.40, 0.75, {}}});
    }
    for (const LinkLaw law : {LinkLaw::Bend, LinkLaw::Surface}) rings(law);
    for (const LinkLaw law : {LinkLaw::Bend, LinkLaw::Surface}) {
      addCase("1,000 cells (a)", {.patch = "sheet:25x40", .surface = "cylinder:r=0.2", .law = law, .poses = 3},
              {{"position", "mm", &Errors::position_mm, 0.70, {}, 0.62}});
    }
    return std::move(rows_);
  }

 private:
  static constexpr const char* kCylinder = "cylinder:r=0.0501";

  void orientations() {
    const auto x17 = [&](std::size_t poses, double bar, std::optional<double> bound) {
      addCase("X17", {.patch = "x17", .surface = kCylinder, .poses = poses},
              {{"orientation", "deg", &Errors::orientation_deg, bar, bar, bound}});
    };
    x17(2, 2.8, {});
    x17(3, 0.70, 0.71);
    x17(6, 0.36, 0.37);
    addCase("100 cells (b)", {.patch = "sheet:10x10", .surface = "cylinder:r=0.08", .poses = 2},
            {{"orientation", "deg", &Errors::orientation_deg, 1.8, 1.8, {}}});
  }

  void rings(LinkLaw law) {
    const Line gap = {"loop gap, vector", "mm", &Errors::gap_mm, 0.6, {}, {}};
    const Line length = {"loop gap, length", "mm", &Errors::gap_length_mm, {}, {}, {}};
    SkinCase ring = {.patch = "ring8", .surface = "", .law = law, .poses = 3};
    addCase("ring of 8", ring, {gap, length});
    ring.jitter = false;
    Line without = gap;
    without.bar_matching.reset();
    addCase("ring of 8, no jitter", ring, {without, length});
    addCase(
        "ring of 8, closed (c)", {.patch = "ring8:closed", .surface = "", .law = law, .poses = 3},
        {{"s off the law's", "", &Errors::share_off, {}, 0.25, {}}, {"stated sigma of s", "", &Errors::share_sigma}});
  }

  void addCase(const std::string& name, const SkinCase& skin_case, const std::vector<Line>& lines) {
    const auto results =
        trials_.run(name + ", " + std::string(linkLawName(skin_case.law)), trials_.seeds(), [&](std::size_t seed) {
          SimulatedSkin skin = makeSkin(skin_case, seed);
          const Session session = measure(skin, skin_case);
          const auto snapshot = session.snapshot();
          const double share = skin_case.law == LinkLaw::Bend ? 0 : 1;
          const auto by = [&](const SolverOptions& options) {
            return judge(skin, *session.truth(), *reconstruct(*snapshot, options), share);
          };
          Methods methods{by(papersMethod()),
                          by(globalSolver(matchingModel(skin_case.law))),
                          by(globalSolver(otherModel(skin_case.law))),
                          by(globalSolver()),
                          {}};
          if (skin.loop()) methods.chained_gap_mm = chainedGapError(skin, *session.truth());
          return methods;
        });
    const auto add = [&](const Line& line, const auto& of_papers, const auto& of_matching, const auto& of_other,
                         const auto& of_fit) {
      AccuracyRow row{.line = line, .law = skin_case.law, .poses = skin_case.poses, .skins = results.size()};
      row.line.figure = name + ": " + line.figure;
      row.papers = medianOf(results, of_papers, row.skins);
      row.matching = medianOf(results, of_matching, row.skins);
      row.other = medianOf(results, of_other, row.skins);
      row.fit = medianOf(results, of_fit, row.skins);
      rows_.push_back(std::move(row));
    };
    for (const Line& line : lines) {
      add(
          line, [&](const Methods& m) { return m.papers.*line.value; },
          [&](const Methods& m) { return m.matching.*line.value; },
          [&](const Methods& m) { return m.other.*line.value; }, [&](const Methods& m) { return m.fit.*line.value; });
      if (line.value != &Errors::gap_mm) continue;
      const auto none = [](const Methods&) { return std::optional<double>(); };
      const Line exact = {"the same, orientations known (d)", "mm", nullptr, {}, {}, {}};
      add(
          exact, none, [](const Methods& m) { return m.chained_gap_mm; }, none, none);
    }
  }

  /// Nothing if no skin has the figure. `skins`: lowered to how many have it.
  template <class Get>
  static std::optional<double> medianOf(const std::vector<Methods>& results, const Get& get, std::size_t& skins) {
    std::vector<double> values;
    for (const Methods& result : results) {
      if (const std::optional<double> value = get(result)) values.push_back(*value);
    }
    if (values.empty()) return std::nullopt;
    skins = std::min(skins, values.size());
    return median(values);
  }

  const Trials& trials_;
  std::vector<AccuracyRow> rows_;
};

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

FigureRow figuresOf(const AccuracyRow& row) {
  const int decimals = row.line.bar_matching == row.line.bar_fit && row.line.bar_fit ? 3 : 2;
  const std::string bars = numberOrDash(row.line.bar_matching) + " / " + numberOrDash(row.line.bar_fit);
  return {ofText("figure", "figure", row.line.figure),
          ofText("law", "link_law", std::string(linkLawName(row.law))),
          ofCount("poses", "poses", row.poses),
          ofCount("", "skins", row.skins),
          ofNumber("paper", "papers_method", row.papers),
          ofNumber("match", "matching", row.matching, decimals),
          ofNumber("other", "mismatching", row.other, decimals),
          ofNumber("fit", "fit", row.fit, decimals),
          ofText("unit", "unit", row.line.unit),
          ofText("bars", "", row.hasBar() ? bars : "-"),
          ofNumber("", "bar_matching", row.line.bar_matching),
          ofNumber("", "bar_fit", row.line.bar_fit),
          ofNumber("bound", "bound", row.line.bound),
          ofBar(row.hasBar(), row.reached())};
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

nlohmann::ordered_json tabulateAccuracy(const Trials& trials, bool prints) {
  std::vector<FigureRow> rows;
  for (const AccuracyRow& row : AccuracyTable(trials).run()) rows.push_back(figuresOf(row));
  if (prints) print(rows, trials.seeds());
  return {{"jitter_bound_rms_mm", toMillimetres(jitterBound_m())}, {"rows", toJson(rows)}};
}

}  // namespace hexoderm::cli
