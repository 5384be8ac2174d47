#include "tests/benchmarks/reproduce/trials.h"

#include "hexoderm/base/text.h"
#include "hexoderm/base/units.h"
#include "hexoderm/sim/simulated_session.h"
#include "hexoderm/solve/checks/calibration_check.h"
#include "hexoderm/solve/reconstructor.h"

#include "tests/support/turn_bound.h"

#include <algorithm>
#include <cmath>
#include <iostream>
#include <random>

namespace hexoderm::cli {
namespace {

constexpr double kBarNoticed = 95;  ///< percent
constexpr double kBarBlamed = 0.2;  ///< percent of healthy cells
constexpr double kDrift_g = 0.060;

enum class Change { None, Turn, Dead, Stuck, Drift };

struct CheckCase {
  std::string name;
  Change change = Change::None;
  CellChange expected = CellChange::None;
  std::size_t calibration_poses = 4;
  std::size_t poses = 2;
  bool has_bar = true;
  double turn_rad = 10 * kDegree;
  bool drifts = true;  ///< offsets, between the two sessions and within them
};

Eigen::Vector3d directionFrom(std::mt19937_64& random) {
  std::normal_distribution<double> normal;
  Eigen::Vector3d v;
  for (double& x : v) x = normal(random);
  return v.normalized();
}

/// Directions that up has in the part one day, each 60 to 120 degrees from those before.
std::vector<Eigen::Vector3d> anyPoses(std::size_t count, std::mt19937_64& random) {
  std::vector<Eigen::Vector3d> ups;
  while (ups.size() < count) {
    const Eigen::Vector3d up = directionFrom(random);
    const auto is_near = [&](const Eigen::Vector3d& other) { return std::abs(up.dot(other)) > 0.5; };
    if (std::ranges::none_of(ups, is_near)) ups.push_back(up);
  }
  return ups;
}

bool isNamed(CellChange change) { return change != CellChange::None && change != CellChange::NotTold; }

void runTrial(Tally& tally, const CheckCase& what, std::size_t seed) {
  std::mt19937_64 random(seed);
  // The changed cell is any of the skin, whatever is done to it.
  const CellId changed(static_cast<std::uint32_t>(1 + seed % 17));
  SkinCase skin_case = {.patch = "x17", .surface = "cylinder:r=0.0501", .poses = what.calibration_poses};
  if (what.drifts) skin_case.drifts_after = what.calibration_poses;
  SimulatedSkin skin = makeSkin(skin_case, seed);
  const auto calibration = reconstruct(*measure(skin, skin_case).snapshot());

  if (what.change == Change::Dead) skin.breakCell({SkinFault::Dead, changed});
  if (what.change == Change::Stuck) skin.breakCell({SkinFault::Stuck, changed});
  const Eigen::Vector3d drift_g = kDrift_g * directionFrom(random);
  const Eigen::Vector3d turn_u = what.turn_rad * directionFrom(random);
  const TrueCell& truth = skin.truth()[changed.value() - 1];
  Session today = beginSimulatedSession(skin);
  for (const Eigen::Vector3d& up : anyPoses(what.poses, random)) {
    PoseCapture pose = averageFrames(skin.record(up), today.nextPoseId(), {});
    for (GravitySample& sample : pose.samples) {
      if (sample.cell != changed) continue;
      if (what.change == Change::Drift) sample.mean_g += drift_g;
      if (what.change != Change::Turn) continue;
      const Eigen::Vector3d force_u = truth.gain.inverse() * (sample.mean_g - truth.offset_g);
      sample.mean_g = truth.gain * expSO3(-turn_u) * force_u + truth.offset_g;
    }
    today.addPose({std::make_shared<const PoseCapture>(std::move(pose))});
  }

  bool is_alarm = false;
  const CalibrationCheck check = checkCalibration(*calibration, *today.snapshot());
  for (const CheckedCell& cell : check.cells) {
    if (what.change == Change::None || cell.cell != changed) {
      tally.count("blamed", isNamed(cell.change));
      is_alarm = is_alarm || isNamed(cell.change);
      continue;
    }
    tally.count("found", isNamed(cell.change));
    tally.count("right", cell.change == what.expected);
    tally.count("either", cell.change == CellChange::TurnedOrDrifted);
    if (what.change != Change::Turn) continue;
    const Eigen::Vector3d turn_o = calibration->find(changed).cell->T_o_u.R * turn_u;
    tally.note("allowed", 100 * test::turnFoundByBestTest(check, cell, turn_o));
    if (cell.change == CellChange::Turned) {
      tally.note("deviates squared", std::pow((cell.turn->angle_rad - what.turn_rad) / cell.turn->sigma_rad, 2));
    }
  }
  tally.count("alarms", is_alarm);
}

std::vector<CheckCase> checkCases() {
  std::vector<CheckCase> cases;
  for (const std::size_t calibration_poses : {4, 8}) {
    const std::size_t n = calibration_poses;
    cases.push_back({"turned by 10 deg", Change::Turn, CellChange::Turned, n, 2});
    cases.push_back({"dead", Change::Dead, CellChange::Broken, n, 2});
    cases.push_back({"stuck", Change::Stuck, CellChange::Broken, n, 2});
    cases.push_back({"offset drifted by 60 mg", Change::Drift, CellChange::Drifted, n, 2});
    cases.push_back({"healthy", Change::None, CellChange::None, n, 2});
    cases.push_back({"healthy, no drift", Change::None, CellChange::None, n, 2, true, 0, false});
  }
  for (const std::size_t poses : {1, 2, 3}) {
    cases.push_back({"turned by 3 deg", Change::Turn, CellChange::Turned, 4, poses, false, 3 * kDegree});
    cases.push_back({"turned by 6 deg", Change::Turn, CellChange::Turned, 4, poses, false, 6 * kDegree});
  }
  cases.push_back({"turned by 10 deg", Change::Turn, CellChange::Turned, 3, 2, false});
  cases.push_back({"offset drifted by 60 mg", Change::Drift, CellChange::Drifted, 3, 2, false});
  cases.push_back({"turned by 10 deg", Change::Turn, CellChange::TurnedOrDrifted, 4, 1, false});
  cases.push_back({"turned by 10 deg", Change::Turn, CellChange::Turned, 4, 3, false});
  cases.push_back({"offset drifted by 60 mg", Change::Drift, CellChange::Drifted, 4, 3, false});
  return cases;
}

FigureRow runRow(const Trials& trials, const CheckCase& what) {
  const Tally tally = trials.run(what.name, [&](Tally& found, std::size_t seed) { runTrial(found, what, seed); });
  const auto squared = tally.mean("deviates squared");
  const auto found = tally.percent("found");
  return {
      ofText("change", "change", what.name),
      {"calibrated by", std::to_string(what.calibration_poses) + " poses", "calibration_poses", what.calibration_poses},
      {"checked by", counted(what.poses, "pose"), "poses", what.poses},
      ofShare("found", "found", tally.share("found"), 1),
      ofPercent("allowed", "allowed", tally.mean("allowed"), 1),
      ofShare("right", "right_kind", tally.share("right"), 1),
      ofPercent("either", "", tally.percent("either"), 1),
      ofShare("", "turned_or_drifted", tally.share("either"), 1),
      ofShare("blamed, per cell", "blamed_per_cell", tally.share("blamed"), 2),
      ofShare("", "false_alarms", tally.share("alarms"), 1),
      // The normalised error of what is stated as 1 sigma.
      ofNumber("error / stated", "turn_error_over_stated", squared ? std::optional(std::sqrt(*squared)) : std::nullopt),
      ofBar(what.has_bar, tally.percent("blamed") <= kBarBlamed && (!found || found >= kBarNoticed))};
}

}  // namespace

Json countChanges(const Trials& trials, bool prints) {
  std::vector<FigureRow> rows;
  for (const CheckCase& what : checkCases()) rows.push_back(runRow(trials, what));
  if (prints) {
    std::cout
        << "What changed since a calibration is found by a check, on a simulated X17 in a hand, defaults: "
        << trials.seeds() << " skins per row.\n"
        << "Offsets drift between the sessions and within them as the cell model says, but where a row says "
           "otherwise.\n"
        << "Found: the cell is named as changed. Allowed: as often as the best test would find a turn about an axis "
           "that\n"
        << "it does not know. Right: as what it is; in one pose that is \"turned or drifted\".\n"
        << "Either: as turned or drifted, which the poses can't tell. Blamed: healthy cells named as changed.\n"
        << "Error / stated: rms error of the angle in its stated deviations. With 95 % intervals. Bars, of two poses\n"
        << "and a calibration by four or more: found >= " << formatFixed(kBarNoticed, 0)
        << " %, blamed <= " << formatFixed(kBarBlamed, 1) << " %.\n\n";
    printTable(rows);
  }
  return {{"skins", trials.seeds()}, {"rows", toJson(rows)}};
}

}  // namespace hexoderm::cli
