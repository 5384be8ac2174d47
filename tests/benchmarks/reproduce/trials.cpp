#include "tests/benchmarks/reproduce/trials.h"

#include "hexoderm/base/text.h"
#include "hexoderm/base/units.h"
#include "hexoderm/sim/simulated_session.h"

#include "tests/support/nees.h"

#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>
#include <iostream>
#include <numeric>
#include <set>

namespace hexoderm::cli {

SimulatedSkin makeSkin(const SkinCase& skin_case, std::size_t seed) {
  CellModel model = independentChips(skin_case.offset_sigma_mg);
  model.accelerometer.offset_shared_sigma_g = skin_case.offset_shared_sigma_mg / 1000;
  model.accelerometer.scale_shared_sigma = skin_case.scale_shared_sigma;
  model.mounting_sigma_rad = skin_case.mounting_sigma_rad;
  SimulatedSkinOptions options;
  options.patch = skin_case.patch;
  options.surface = skin_case.surface;
  options.link_law = skin_case.law;
  options.seed = seed;
  options.faults = skin_case.faults;
  options.link_faults = skin_case.link_faults;
  options.whole_skin_faults = skin_case.whole_skin_faults;
  options.drifts_after = skin_case.drifts_after;
  options.reglued_before = skin_case.poses == 0 ? 0 : skin_case.poses - 1;
  if (!skin_case.jitter) options.position_jitter_m = options.yaw_jitter_rad = options.tilt_jitter_rad = 0;
  return {std::move(model), options};
}

Session measure(SimulatedSkin& skin, const SkinCase& skin_case) { return simulateSession(skin, skin_case.poses); }

SolverOptions papersMethod() {
  SolverOptions options;
  options.solver = Solver::Tree;
  options.centring = Centring::Off;
  options.max_bend_rad = kPi;
  options.max_twist_rad = kPi;
  options.max_yaw_rad = kPi;
  options.max_misfit = 1e6;
  return options;
}

SE3 truePlacement(const GroundTruth& truth, CellId cell) {
  return std::ranges::find(truth.cells, cell, &TrueCellPlacement::id)->T_b_u;
}

std::vector<NeighborReport> linksOf(const SimulatedSkin& skin, CellId cell) {
  std::vector<NeighborReport> links = std::ranges::find(skin.neighbors(), cell, &CellReport::id)->neighbors;
  std::erase_if(links, [](const NeighborReport& link) { return link.cell.value() == 0; });
  return links;
}

std::optional<SurfaceEvaluation> fitCylinder(const Reconstruction& reconstruction, double true_radius_m) {
  try {
    return evaluateSurface(*largestPatch(reconstruction), SurfaceKind::Cylinder, true_radius_m);
  } catch (const InvalidArgument&) {
    return std::nullopt;
  }
}

std::optional<LoopEvaluation> measureLoop(const SimulatedSkin& skin, const Reconstruction& reconstruction) {
  try {
    return evaluateLoop(reconstruction, skin.loop()->first, skin.loop()->second);
  } catch (const InvalidArgument&) {
    return std::nullopt;
  }
}

double Share::percent() const {
  return whole == 0 ? 0 : 100.0 * static_cast<double>(part) / static_cast<double>(whole);
}

std::pair<double, double> Share::interval() const {
  if (whole == 0) return {0, 100};
  constexpr double kZ = 1.96;
  const auto n = static_cast<double>(whole);
  const double p = static_cast<double>(part) / n;
  const double middle = (p + kZ * kZ / (2 * n)) / (1 + kZ * kZ / n);
  const double half = kZ * std::sqrt(p * (1 - p) / n + kZ * kZ / (4 * n * n)) / (1 + kZ * kZ / n);
  return {100 * std::max(0.0, middle - half), 100 * std::min(1.0, middle + half)};
}

void Tally::add(const std::string& name, std::size_t part, std::size_t whole) {
  Share& share = shares[name];
  share.part += part;
  share.whole += whole;
}

void Tally::operator+=(const Tally& other) {
  for (const auto& [name, share] : other.shares) add(name, share.part, share.whole);
  for (const auto& [name, noted] : other.values) {
    std::vector<double>& all = values[name];
    all.insert(all.end(), noted.begin(), noted.end());
  }
}

std::optional<Share> Tally::share(const std::string& name) const {
  const auto found = shares.find(name);
  return found == shares.end() ? std::nullopt : std::optional(found->second);
}

std::optional<double> Tally::percent(const std::string& name) const {
  const std::optional<Share> counted = share(name);
  return counted ? std::optional(counted->percent()) : std::nullopt;
}

const std::vector<double>& Tally::of(const std::string& name) const {
  static const std::vector<double> kNone;
  const auto found = values.find(name);
  return found == values.end() ? kNone : found->second;
}

std::optional<double> Tally::mean(const std::string& name) const {
  const std::vector<double>& noted = of(name);
  if (noted.empty()) return std::nullopt;
  return std::accumulate(noted.begin(), noted.end(), 0.0) / static_cast<double>(noted.size());
}

std::optional<double> Tally::quantile(const std::string& name, double fraction) const {
  std::vector<double> sorted = of(name);
  if (sorted.empty()) return std::nullopt;
  std::ranges::sort(sorted);
  const double place = fraction * static_cast<double>(sorted.size() - 1);
  const auto below = static_cast<std::size_t>(place);
  const std::size_t above = std::min(below + 1, sorted.size() - 1);
  return sorted[below] + (place - static_cast<double>(below)) * (sorted[above] - sorted[below]);
}

void noteNees(Tally& tally, const Reconstruction& result, const GroundTruth& truth) {
  test::Nees nees;
  nees.addPatch(*largestPatch(result), [&](CellId cell) { return truePlacement(truth, cell); });
  if (nees.count == 0) return;
  tally.note("position", nees.position);
  tally.note("orientation", nees.orientation);
}

bool isAlarm(const Finding& finding) {
  return finding.severity != Severity::Info && finding.code != FindingCode::TooFewDirections;
}

void countFalseAlarms(Tally& tally, const Reconstruction& result) {
  std::set<CellId> accused;
  std::set<CellId> suspicious;
  for (const Finding& finding : result.findings) {
    if (!isAlarm(finding)) continue;
    if (finding.code == FindingCode::SuspiciousSensor) {
      suspicious.insert(finding.cells.begin(), finding.cells.end());
    } else if (finding.ports.empty()) {
      accused.insert(finding.cells.begin(), finding.cells.end());
    }
  }
  tally.count("alarms", std::ranges::any_of(result.findings, isAlarm));
  tally.add("accused", accused.size(), result.cellCount());
  tally.add("suspicious", suspicious.size(), result.cellCount());
  for (const PatchReconstruction& patch : result.patches) {
    for (const LinkEstimate& link : patch.links) tally.count("muted", link.muted_by.has_value());
  }
}

void Trials::report(const std::string& what, std::size_t seed, std::size_t count) const {
  common_.progress(what + ": seed " + std::to_string(seed) + " of " + std::to_string(count));
}

Figure ofText(const std::string& title, const std::string& key, const std::string& text) {
  return {title, text, key, text};
}

Figure ofCount(const std::string& title, const std::string& key, std::size_t count) {
  return {title, std::to_string(count), key, count};
}

Figure ofNumber(const std::string& title, const std::string& key, const std::optional<double>& value, int decimals) {
  return {title, value ? formatFixed(*value, decimals) : "-", key, orNull(value)};
}

Figure ofPercent(const std::string& title, const std::string& key, const std::optional<double>& percent, int decimals) {
  return {title, percent ? formatFixed(*percent, decimals) + " %" : "-", key, orNull(percent)};
}

Figure ofShare(const std::string& title, const std::string& key, const std::optional<Share>& share, int decimals) {
  if (!share) return {title, "-", key, Json()};
  const auto [low, high] = share->interval();
  const double percent = share->percent();
  return {
      title,
      formatFixed(percent, decimals) + " % (" + formatFixed(low, decimals) + " to " + formatFixed(high, decimals) + ")",
      key,
      {{"count", share->part},
       {"of", share->whole},
       {"percent", percent},
       {"low_percent", low},
       {"high_percent", high}}};
}

Figure ofBar(bool has_bar, bool is_reached) {
  if (!has_bar) return {"reached", "-", "reached", Json()};
  return {"reached", is_reached ? "yes" : "NO", "reached", is_reached};
}

FigureRow withFalseAlarms(FigureRow row, const Tally& tally) {
  constexpr double kBarSessions = 0.2;  // percent
  constexpr double kBarCells = 0.1;     // percent
  row.insert(
      row.end(),
      {ofShare("sessions with a false alarm (95 %)", "alarms", tally.share("alarms"), 2),
       ofShare("cells accused (95 %)", "accused", tally.share("accused"), 3),
       ofPercent("cells suspicious", "", tally.percent("suspicious"), 3),
       ofShare("", "suspicious", tally.share("suspicious"), 3), ofPercent("links muted", "", tally.percent("muted"), 3),
       ofShare("", "muted", tally.share("muted"), 3), ofText("bars", "", "<= 0.2 %, <= 0.1 %"),
       ofBar(true, tally.percent("alarms") <= kBarSessions && tally.percent("accused") <= kBarCells)});
  return row;
}

std::vector<FigureRow> besideEachOther(const std::vector<FigureRow>& rows, std::size_t leading,
                                       const std::string& which) {
  std::vector<FigureRow> table;
  for (const FigureRow& row : rows) {
    const auto head = row.begin() + static_cast<std::ptrdiff_t>(leading);
    if (table.empty() || !std::equal(row.begin(), head, table.back().begin(),
                                     [](const Figure& a, const Figure& b) { return a.text == b.text; })) {
      table.emplace_back(row.begin(), head);
    }
    const auto text = [&](const std::string& title) { return std::ranges::find(row, title, &Figure::title)->text; };
    table.back().push_back(ofText(text("poses") + " poses", "", text(which)));
  }
  return table;
}

void printTable(const std::vector<FigureRow>& rows) {
  std::vector<std::vector<std::string>> lines;
  const auto addLine = [&](const FigureRow& row, std::string Figure::*part) {
    lines.emplace_back();
    for (const Figure& figure : row) {
      if (!figure.title.empty()) lines.back().push_back(figure.*part);
    }
  };
  addLine(rows.front(), &Figure::title);
  for (const FigureRow& row : rows) addLine(row, &Figure::text);
  std::vector<std::size_t> width(lines.front().size(), 0);
  for (const auto& line : lines) {
    for (std::size_t k = 0; k < line.size(); ++k) width[k] = std::max(width[k], line[k].size());
  }
  for (const auto& line : lines) {
    std::string text;
    for (std::size_t k = 0; k < line.size(); ++k) text += line[k] + std::string(width[k] - line[k].size() + 2, ' ');
    text.erase(text.find_last_not_of(' ') + 1);
    std::cout << text << '\n';
  }
}

Json toJson(const std::vector<FigureRow>& rows) {
  return arrayOf(rows, [](const FigureRow& row) {
    Json object = Json::object();
    for (const Figure& figure : row) {
      if (!figure.key.empty()) object[figure.key] = figure.value;
    }
    return object;
  });
}

}  // namespace hexoderm::cli
