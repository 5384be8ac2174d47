#include "command.h"

#include "hexoderm/device/simulated_skin.h"
#include "hexoderm/reconstruction/evaluation.h"
#include "hexoderm/reconstruction/reconstructor.h"
#include "hexoderm/session/simulated_session.h"
#include "hexoderm/util/text.h"
#include "hexoderm/util/units.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <iostream>

namespace hexoderm::cli {
namespace {

struct ReproduceOptions {
  std::size_t seeds = 200;
};

constexpr std::array kOffsetSigmas_mg = {20.0, 60.0, 100.0};
constexpr double kRadius_m = 0.0501;
constexpr std::size_t kPoses = 2;

struct Percentiles {
  double p5 = 0;
  double median = 0;
  double p95 = 0;
};

/// By linear interpolation between order statistics.
Percentiles percentilesOf(std::vector<double> values) {
  std::ranges::sort(values);
  const auto at = [&](double fraction) {
    const double place = fraction * static_cast<double>(values.size() - 1);
    const auto below = static_cast<std::size_t>(place);
    const std::size_t above = std::min(below + 1, values.size() - 1);
    return values[below] + (place - static_cast<double>(below)) * (values[above] - values[below]);
  };
  return {at(0.05), at(0.5), at(0.95)};
}

/// What one figure of the paper came out as, over all seeds.
struct Row {
  std::string figure;
  std::string unit;
  double offset_sigma_mg = 0;
  std::string paper;
  std::vector<double> values;
};

/// --solver tree --centre off, and as in the paper no link is judged and muted: every skin counts.
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

SimulatedSkin makeSkin(const std::string& patch, const std::string& surface, double offset_sigma_mg,
                       std::uint64_t seed) {
  CellModel model = builtInCellModel("hex-bma150");
  model.accelerometer.offset_sigma_g = offset_sigma_mg / 1000;
  SimulatedSkinOptions options;
  options.patch = patch;
  options.surface = surface;
  options.seed = seed;
  return {std::move(model), options};
}

class Experiments {
 public:
  Experiments(std::size_t seeds, const Common& common) : seeds_(seeds), common_(common) {}

  std::vector<Row> run() {
    for (const double sigma : kOffsetSigmas_mg) shape(sigma);
    for (const double sigma : kOffsetSigmas_mg) closedLoop(sigma);
    common_.endProgress();
    return std::move(rows_);
  }

 private:
  /// Paper III.1: X17 on an aluminium cylinder, two poses.
  void shape(double offset_sigma_mg) {
    Row delta{"X17 on r = 50.1 mm: Delta, eq. (20)", "mm", offset_sigma_mg, "-0.30", {}};
    Row epsilon{"X17 on r = 50.1 mm: eps, eq. (21)", "mm", offset_sigma_mg, "1.62", {}};
    for (std::size_t seed = 1; seed <= seeds_; ++seed) {
      report("X17", offset_sigma_mg, seed);
      SimulatedSkin skin = makeSkin("x17", "cylinder:r=" + formatExact(kRadius_m), offset_sigma_mg, seed);
      const auto result = reconstruct(*simulateSession(skin, kPoses).snapshot(), papersMethod());
      const SurfaceEvaluation surface = evaluateSurface(result->patches.front(), SurfaceKind::Cylinder, kRadius_m);
      delta.values.push_back(toMillimetres(*surface.delta_m));
      epsilon.values.push_back(toMillimetres(*surface.epsilon_m));
    }
    rows_.push_back(std::move(delta));
    rows_.push_back(std::move(epsilon));
  }

  /// Paper III.2: a line of eight cells around a cup, two poses, gap between the two free ends.
  void closedLoop(double offset_sigma_mg) {
    Row gap{"Ring of 8: loop gap", "mm", offset_sigma_mg, "10.46", {}};
    Row percent{"Ring of 8: loop gap, share of the loop", "%", offset_sigma_mg, "4.71", {}};
    for (std::size_t seed = 1; seed <= seeds_; ++seed) {
      report("ring of 8", offset_sigma_mg, seed);
      SimulatedSkin skin = makeSkin("ring8", "", offset_sigma_mg, seed);
      const auto result = reconstruct(*simulateSession(skin, kPoses).snapshot(), papersMethod());
      const auto ends = skin.loop();
      const LoopEvaluation loop = evaluateLoop(*result, ends->first, ends->second);
      gap.values.push_back(toMillimetres(loop.length_m));
      percent.values.push_back(loop.percent);
    }
    rows_.push_back(std::move(gap));
    rows_.push_back(std::move(percent));
  }

  void report(const std::string& what, double offset_sigma_mg, std::size_t seed) const {
    if (seed % 20 != 1) return;
    common_.progress(what + ", offsets " + formatFixed(offset_sigma_mg, 0) + " mg: seed " + std::to_string(seed) +
                     " of " + std::to_string(seeds_));
  }

  std::size_t seeds_;
  const Common& common_;
  std::vector<Row> rows_;
};

std::string padded(std::string text, std::size_t width) {
  if (text.size() < width) text.append(width - text.size(), ' ');
  return text;
}

void printTable(const std::vector<Row>& rows, std::size_t seeds) {
  std::cout << "The paper's two experiments, simulated: " << seeds << " skins and hands each, " << kPoses
            << " poses, the paper's method (--solver tree --centre off).\n"
            << "The paper's figures are one trial each, of real skins.\n\n"
            << padded("figure", 42) << padded("offsets", 10) << padded("5 %", 10) << padded("median", 10)
            << padded("95 %", 10) << "paper\n";
  for (const Row& row : rows) {
    std::cout << padded(row.figure, 42) << padded(formatFixed(row.offset_sigma_mg, 0) + " mg", 10);
    const Percentiles p = percentilesOf(row.values);
    std::cout << padded(formatFixed(p.p5, 2), 10) << padded(formatFixed(p.median, 2), 10)
              << padded(formatFixed(p.p95, 2), 10) << row.paper << ' ' << row.unit << '\n';
  }
}

int run(const ReproduceOptions& options, const Common& common) {
  Experiments experiments(options.seeds, common);
  const std::vector<Row> rows = experiments.run();
  if (common.json) {
    nlohmann::ordered_json json;
    json["seeds"] = options.seeds;
    json["poses"] = kPoses;
    json["method"] = "--solver tree --centre off";
    json["simulated"] = true;
    json["rows"] = nlohmann::ordered_json::array();
    for (const Row& row : rows) {
      nlohmann::ordered_json entry = {{"figure", row.figure},
                                      {"unit", row.unit},
                                      {"offset_sigma_mg", row.offset_sigma_mg},
                                      {"skins", row.values.size()},
                                      {"paper", parseNumber(row.paper, "paper")}};
      const Percentiles p = percentilesOf(row.values);
      entry["p5"] = p.p5;
      entry["median"] = p.median;
      entry["p95"] = p.p95;
      json["rows"].push_back(std::move(entry));
    }
    printJson(json);
  } else {
    printTable(rows, options.seeds);
  }
  return kDone;
}

}  // namespace

void addReproduce(CLI::App& app, Common& common) {
  const auto options = std::make_shared<ReproduceOptions>();
  CLI::App* command =
      app.add_subcommand("reproduce", "Repeat the paper's two experiments on simulated skins, its figures beside ours");
  command->add_option("--seeds", options->seeds, "Skins per row")->check(CLI::Range(1, 100000))->capture_default_str();
  common.addTo(*command);
  command->footer("Example:\n  hexoderm-cli reproduce --seeds 200");
  command->callback([options, &common] { common.exit_code = run(*options, common); });
}

}  // namespace hexoderm::cli
