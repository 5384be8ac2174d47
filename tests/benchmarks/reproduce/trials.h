#pragma once

#include "hexoderm/base/parallel.h"
#include "hexoderm/session/session.h"
#include "hexoderm/sim/simulated_skin.h"
#include "hexoderm/solve/checks/evaluation.h"
#include "hexoderm/solve/result/reconstruction.h"

#include "app/cli/command.h"
#include "app/cli/json.h"

#include <atomic>
#include <optional>
#include <string>
#include <thread>
#include <utility>
#include <vector>

namespace hexoderm::cli {

/// A simulated skin and how it is measured; what is not named here is the simulator's default.
struct SkinCase {
  std::string patch;
  std::string surface;
  LinkLaw law = LinkLaw::Bend;
  std::size_t poses = 3;
  double offset_sigma_mg = 60;
  bool jitter = true;  ///< cells lie where a mould puts them: a little off, a little askew
  std::vector<CellFault> faults = {};
  std::vector<LinkFault> link_faults = {};
  std::vector<WholeSkinFault> whole_skin_faults = {};
};

SimulatedSkin makeSkin(const SkinCase& skin_case, std::size_t seed);
/// A calibration session of the skin, with the truth.
Session measure(SimulatedSkin& skin, const SkinCase& skin_case);

/// --solver tree --centre off, and as in the paper no link is judged and muted: every skin counts.
SolverOptions papersMethod();
SolverOptions globalSolver(GapModel gap_model = GapModel::Fit);
/// The gap model that the simulator's law obeys, and the one it doesn't.
GapModel matchingModel(LinkLaw law);
GapModel otherModel(LinkLaw law);

SE3 truePlacement(const GroundTruth& truth, CellId cell);
/// Nothing where links taken for broken left too little of the skin.
std::optional<SurfaceEvaluation> fitCylinder(const Reconstruction& reconstruction, double true_radius_m);
std::optional<LoopEvaluation> measureLoop(const SimulatedSkin& skin, const Reconstruction& reconstruction);

/// Order statistics, linearly interpolated; of nothing 0.
double quantile(std::vector<double> values, double fraction);
double median(std::vector<double> values);
double mean(const std::vector<double>& values);

/// Wilson's 95 % interval of a share, in percent.
struct Share {
  std::size_t part = 0;
  std::size_t whole = 0;
  [[nodiscard]] double percent() const;
  [[nodiscard]] std::pair<double, double> interval() const;
  void operator+=(const Share& other);
};

/// "97.5 % (95.1 to 99.0)".
std::string inWords(const Share& share, int decimals);
nlohmann::ordered_json toJson(const Share& share);

/// Repeats trials over seeds on all processors. Every trial depends on its seed alone, so the outcome depends on
/// neither their number nor their order.
class Trials {
 public:
  Trials(std::size_t seeds, const Common& common) : seeds_(seeds), common_(common) {}
  [[nodiscard]] std::size_t seeds() const { return seeds_; }

  /// trial(seed) for the seeds 1 to `count`, in their order.
  template <class Trial>
  auto run(const std::string& what, std::size_t count, const Trial& trial) const {
    std::vector<decltype(trial(std::size_t{}))> results(count);
    const std::thread::id reporter = std::this_thread::get_id();
    std::atomic<bool> has_failed = false;
    inParallel(count, [&](std::size_t k) {
      if (has_failed) return;  // what has failed is not worth the wait for the rest
      if (std::this_thread::get_id() == reporter) report(what, k + 1, count);
      try {
        results[k] = trial(k + 1);
      } catch (...) {
        has_failed = true;
        throw;
      }
    });
    return results;
  }

 private:
  void report(const std::string& what, std::size_t seed, std::size_t count) const;

  std::size_t seeds_;
  const Common& common_;
};

/// A figure of a row: its title and text in a table, its key and value in JSON. Without a title, or without a key, it
/// is in one of the two only.
struct Figure {
  std::string title;
  std::string text;
  std::string key;
  Json value;
};

using FigureRow = std::vector<Figure>;

Figure ofText(const std::string& title, const std::string& key, const std::string& text);
Figure ofCount(const std::string& title, const std::string& key, std::size_t count);
/// "-" and null for what does not exist.
Figure ofNumber(const std::string& title, const std::string& key, const std::optional<double>& value, int decimals = 2);
Figure ofPercent(const std::string& title, const std::string& key, const std::optional<double>& percent, int decimals);
/// With its interval.
Figure ofShare(const std::string& title, const std::string& key, const std::optional<Share>& share, int decimals);
/// Whether a row reaches its bar, if it has one.
Figure ofBar(bool has_bar, bool is_reached);

/// Columns as wide as their widest entry.
void printTable(const std::vector<FigureRow>& rows);
Json toJson(const std::vector<FigureRow>& rows);
/// "-" for what does not exist.
std::string numberOrDash(const std::optional<double>& value, int decimals = 2);

}  // namespace hexoderm::cli
