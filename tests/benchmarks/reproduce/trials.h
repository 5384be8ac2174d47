#pragma once

#include "hexoderm/base/parallel.h"
#include "hexoderm/session/session.h"
#include "hexoderm/sim/simulated_skin.h"
#include "hexoderm/solve/checks/evaluation.h"
#include "hexoderm/solve/result/reconstruction.h"

#include "app/cli/command.h"
#include "app/cli/json.h"
#include "tests/support/independent_chips.h"

#include <atomic>
#include <map>
#include <optional>
#include <string>
#include <thread>
#include <utility>
#include <vector>

namespace hexoderm::cli {

/// A simulated skin and how it is measured; what is not named here is the simulator's default.
struct SkinCase {
  std::string patch;
  std::string surface = {};
  LinkLaw law = LinkLaw::Bend;
  std::size_t poses = 3;
  double offset_sigma_mg = 60;
  double offset_shared_sigma_mg = 0;  ///< of the chips' lot; the offsets above are the chips' own
  double scale_shared_sigma = 0;      ///< of the lot
  double mounting_sigma_rad = 0;      ///< chips sit askew in their cells
  bool jitter = true;                 ///< cells lie where a mould puts them: a little off, a little askew
  std::vector<CellFault> faults = {};
  std::vector<LinkFault> link_faults = {};
  std::vector<WholeSkinFault> whole_skin_faults = {};
  std::optional<std::size_t> drifts_after = {};
};

SimulatedSkin makeSkin(const SkinCase& skin_case, std::size_t seed);
/// A calibration session of the skin, with the truth.
Session measure(SimulatedSkin& skin, const SkinCase& skin_case);

/// --solver tree --centre off, and as in the paper no link is judged and muted: every skin counts.
SolverOptions papersMethod();

SE3 truePlacement(const GroundTruth& truth, CellId cell);
/// The reports of a cell that name a neighbour.
std::vector<NeighborReport> linksOf(const SimulatedSkin& skin, CellId cell);
/// Nothing where links taken for broken left too little of the skin.
std::optional<SurfaceEvaluation> fitCylinder(const Reconstruction& reconstruction, double true_radius_m);
std::optional<LoopEvaluation> measureLoop(const SimulatedSkin& skin, const Reconstruction& reconstruction);

struct Share {
  std::size_t part = 0;
  std::size_t whole = 0;
  [[nodiscard]] double percent() const;
  /// Wilson's 95 % interval, in percent.
  [[nodiscard]] std::pair<double, double> interval() const;
};

/// What trials found, by name: shares, and numbers, which need not be there in every trial.
struct Tally {
  std::map<std::string, Share> shares;
  std::map<std::string, std::vector<double>> values;

  void add(const std::string& name, std::size_t part, std::size_t whole);
  /// One more of a share.
  void count(const std::string& name, bool is_part) { add(name, is_part ? 1 : 0, 1); }
  void note(const std::string& name, double value) { values[name].push_back(value); }
  void operator+=(const Tally& other);

  /// Nothing of what was never counted or noted.
  [[nodiscard]] std::optional<Share> share(const std::string& name) const;
  [[nodiscard]] std::optional<double> percent(const std::string& name) const;
  [[nodiscard]] const std::vector<double>& of(const std::string& name) const;
  [[nodiscard]] std::optional<double> mean(const std::string& name) const;
  /// An order statistic, linearly interpolated.
  [[nodiscard]] std::optional<double> quantile(const std::string& name, double fraction) const;
  [[nodiscard]] std::optional<double> median(const std::string& name) const { return quantile(name, 0.5); }
};

/// Notes the normalised estimation error squared, per degree of freedom, as "position" and "orientation"; 1 is honest,
/// less is too cautious. The truth is moved so that the origin cells coincide, no best fit; mean over the other cells
/// of e^T C^-1 e / 3.
void noteNees(Tally& tally, const Reconstruction& result, const GroundTruth& truth);

/// A warning of any kind, but for poses that are too few.
bool isAlarm(const Finding& finding);
/// Counts what is said against a healthy skin: as "alarms" of sessions, cells "accused" and "suspicious", links
/// "muted".
void countFalseAlarms(Tally& tally, const Reconstruction& result);

/// Repeats trials over seeds on all processors. Every trial depends on its seed alone, so the outcome depends on
/// neither their number nor their order.
class Trials {
 public:
  Trials(std::size_t seeds, const Common& common) : seeds_(seeds), common_(common) {}
  [[nodiscard]] std::size_t seeds() const { return seeds_; }

  /// What trial(tally, seed) says of the seeds 1 to `count`, in their order.
  template <class Trial>
  Tally run(const std::string& what, std::size_t count, const Trial& trial) const {
    std::vector<Tally> results(count);
    const std::thread::id reporter = std::this_thread::get_id();
    std::atomic<bool> has_failed = false;
    inParallel(count, [&](std::size_t k) {
      if (has_failed) return;  // what has failed is not worth the wait for the rest
      if (std::this_thread::get_id() == reporter) report(what, k + 1, count);
      try {
        trial(results[k], k + 1);
      } catch (...) {
        has_failed = true;
        throw;
      }
    });
    Tally sum;
    for (const Tally& result : results) sum += result;
    return sum;
  }
  template <class Trial>
  Tally run(const std::string& what, const Trial& trial) const {
    return run(what, seeds_, trial);
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
/// With its interval: "97.5 % (95.1 to 99.0)".
Figure ofShare(const std::string& title, const std::string& key, const std::optional<Share>& share, int decimals);
/// Whether a row reaches its bar, if it has one.
Figure ofBar(bool has_bar, bool is_reached);

/// The figures of countFalseAlarms() and their bars after those of a row.
FigureRow withFalseAlarms(FigureRow row, const Tally& tally);

/// Makes one row of successive rows that begin with the same `leading` figures: these, and then figure `which` of each
/// under its number of "poses".
std::vector<FigureRow> besideEachOther(const std::vector<FigureRow>& rows, std::size_t leading,
                                       const std::string& which);

/// Columns as wide as their widest entry.
void printTable(const std::vector<FigureRow>& rows);
Json toJson(const std::vector<FigureRow>& rows);

// The parts of `reproduce`. Each runs its trials, prints its tables unless --json is given, and returns the same as
// JSON.

/// The paper's two experiments: its published single trials, its method and ours.
Json reproducePaper(const Trials& trials, bool prints);
/// Accuracy of each method on simulated skins, with the bars that Hexoderm set itself.
Json tabulateAccuracy(const Trials& trials, bool prints);
/// Whether the stated uncertainties are as large as the errors.
Json checkUncertainty(const Trials& trials, bool prints);
/// Rates at which broken links and sensors are found, and sound ones blamed.
Json countDetections(const Trials& trials, bool prints);
/// The same for sessions that make no sense as a whole or in part, and for healthy ones of all patches; part of
/// countDetections().
Json countGarbage(const Trials& trials, bool prints);
/// What is said of sessions with one of many kinds of fault, on several shapes: found, named, wrongly accused, silently
/// wrong, and how long it takes.
Json countFaults(const Trials& trials, bool prints);
/// How often `check` finds what changed since a calibration, and blames healthy cells.
Json countChanges(const Trials& trials, bool prints);
/// Accuracy, stated uncertainty and false alarms where chips are of one lot and sit askew.
Json tabulateLots(const Trials& trials, bool prints);
/// How often the true place on a link is found by the link's surface, and how far off.
Json placeOnLinks(const Trials& trials, bool prints);

}  // namespace hexoderm::cli
