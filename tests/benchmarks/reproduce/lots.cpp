#include "tests/benchmarks/reproduce/trials.h"

#include "hexoderm/base/text.h"
#include "hexoderm/base/units.h"
#include "hexoderm/solve/global/global_solver.h"
#include "hexoderm/solve/reconstructor.h"
#include "hexoderm/solve/solve.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <iostream>
#include <limits>

namespace hexoderm::cli {
namespace {

constexpr double kOffset_mg = 60;          ///< 1 sigma of a chip's offset, the lot's and its own together
constexpr double kBarOrientation = 1.9;    ///< degrees, of X17 with two poses and an offset of 50 + 15 mg
constexpr double kBarLow = 0.7;            ///< of normalised errors squared
constexpr double kBarHigh = 1.5;           ///< the same
constexpr double kBarAccused = 0.1;        ///< percent of cells
constexpr std::size_t kFewerOfTorus = 10;  ///< settling 100 cells on a torus takes the simulator long
constexpr std::size_t kMoreHealthy = 10;   ///< times as many sessions show whether anybody is accused

const std::string kOfBound = "orientation_rms_over_bound";

struct Lot {
  double shared = 0;        ///< share of the offset's variance that is the lot's
  double scale_sigma = 0;   ///< of the lot's scale
  double mounting_deg = 0;  ///< 1 sigma by which chips sit askew
};

std::vector<Lot> lots() {
  std::vector<Lot> all;
  for (const double mounting_deg : {0.0, 0.5}) {
    for (const double scale_sigma : {0.0, 0.1}) {
      for (const double shared : {0.0, 0.5, 0.95}) all.push_back({shared, scale_sigma, mounting_deg});
    }
  }
  return all;
}

SkinCase skinOf(const Lot& lot, const std::string& patch, const std::string& surface, std::size_t poses) {
  return {.patch = patch,
          .surface = surface,
          .poses = poses,
          .offset_sigma_mg = kOffset_mg * std::sqrt(1 - lot.shared),
          .offset_shared_sigma_mg = kOffset_mg * std::sqrt(lot.shared),
          .scale_shared_sigma = lot.scale_sigma,
          .mounting_sigma_rad = lot.mounting_deg * kDegree};
}

FigureRow describe(const Lot& lot) {
  return {{"shared", formatFixed(100 * lot.shared, 0) + " %", "offset_variance_shared_percent", 100 * lot.shared},
          {"scale", formatFixed(100 * lot.scale_sigma, 0) + " %", "scale_shared_sigma_percent", 100 * lot.scale_sigma},
          {"askew", formatFixed(lot.mounting_deg, 1) + " deg", "mounting_sigma_deg", lot.mounting_deg}};
}

/// Of the largest patch, as the other tables have it: rms over the cells, all turned together to fit the truth best.
double orientationError_rad(const Reconstruction& result, const GroundTruth& truth) {
  const std::vector<Comparison> comparisons = compareToTruth(result, truth);
  return std::ranges::find(comparisons, largestPatch(result)->id, &Comparison::patch)->orientation_rms_rad;
}

/// The Cramer-Rao bound of the square of the same, rad^2, with the model's sigmas as priors: by the information matrix
/// of all unknowns at the truth, the sensors' errors, the lot, the forces, the angular accelerations and the gap share
/// among them. `near`: a result of the snapshot.
double orientationBound_rad2(const SimulatedSkin& skin, const SessionSnapshot& snapshot, const Reconstruction& near) {
  const SolverOptions options;
  const auto solved = solveSkin(snapshot, options, &near);
  const PatchSolver& patch =
      *std::ranges::max_element(solved->patches(), {}, [](const PatchSolver& each) { return each.cells().size(); });
  GlobalProblem problem = patch.joint()->problem();
  problem.link_sigma_m = problem.model->link_sigma_m;
  problem.acceleration_sigma = kTremorAcceleration_rad_s2;
  problem.loss.threshold = std::numeric_limits<double>::infinity();
  // Of the lot and the accelerations the estimate serves: the information hardly depends on them.
  GlobalState state = patch.joint()->solution().state;
  state.gap_share = skin.options().link_law == LinkLaw::Bend ? 0 : 1;
  state.middle_o.setZero();
  for (Eigen::Vector3d& force : state.force_o) force.setZero();
  const std::vector<GraphCell>& cells = solved->skin().graph().cells();
  const SE3 T_o_b = truePlacement(skin.groundTruth(), cells[patch.origin()].id).inverse();
  const double count = static_cast<double>(patch.cells().size());
  for (std::size_t k = 0; k < patch.cells().size(); ++k) {
    const TrueCell& cell = *std::ranges::find(skin.truth(), cells[patch.cells()[k]].id, &TrueCell::id);
    state.cells[k] = T_o_b * cell.T_b_u;
    state.middle_o += state.cells[k].t / count;
    const Eigen::Matrix3d R_o_a = state.cells[k].R * cell.R_u_askew * problem.model->accelerometer.T_u_a.R;
    for (const CellReading& reading : problem.readings[k]) {
      state.force_o[reading.pose] += R_o_a * cell.gain.inverse() * (reading.y_g - cell.offset_g);
    }
  }
  for (Eigen::Vector3d& force : state.force_o) force.normalize();

  const auto covariance = GlobalSolver().covarianceAt(problem, state);
  Eigen::MatrixXd together = Eigen::MatrixXd::Zero(static_cast<Eigen::Index>(6 * state.cells.size()), 3);
  double sum_rad2 = 0;
  for (std::size_t k = 0; k < state.cells.size(); ++k) {
    together.middleRows<3>(static_cast<Eigen::Index>(6 * k + 3)) = state.cells[k].R.transpose();
    sum_rad2 += covariance->cell(k).bottomRightCorner<3, 3>().trace();
  }
  // Less what turns all cells together.
  sum_rad2 -= (together.transpose() * covariance->timesCells(together)).trace() / count;
  return sum_rad2 / count;
}

void tryLot(Tally& tally, const SkinCase& skin_case, std::size_t seed) {
  SimulatedSkin skin = makeSkin(skin_case, seed);
  Session session = measure(skin, skin_case);
  const auto snapshot = session.snapshot();
  const auto known = reconstruct(*snapshot);
  const double error_rad = orientationError_rad(*known, *session.truth());
  tally.note("known", toDegrees(error_rad));
  tally.note("known squared", error_rad * error_rad);
  tally.note("bound squared", orientationBound_rad2(skin, *snapshot, *known));
  noteNees(tally, *known, *session.truth());
  countFalseAlarms(tally, *known);
  CellModel independent = session.model();
  independent.accelerometer = independent.accelerometer.ofUnknownLot();
  session.setSkin(std::move(independent), session.neighbors());
  tally.note("independent", toDegrees(orientationError_rad(*reconstruct(*session.snapshot()), *session.truth())));
}

FigureRow runRow(const Trials& trials, const SkinCase& skin_case, FigureRow row) {
  const bool is_torus = skin_case.surface.starts_with("torus");
  const std::size_t skins = is_torus ? std::max<std::size_t>(1, trials.seeds() / kFewerOfTorus) : trials.seeds();
  const Tally tally = trials.run("lots on " + skin_case.patch, skins,
                                 [&](Tally& found, std::size_t seed) { tryLot(found, skin_case, seed); });
  const double known = tally.median("known").value_or(0);
  const double independent = tally.median("independent").value_or(0);
  const double bound = toDegrees(std::sqrt(tally.mean("bound squared").value_or(0)));
  const double position = tally.mean("position").value_or(0);
  const double orientation = tally.mean("orientation").value_or(0);
  const double accused = tally.percent("accused").value_or(0);
  const auto is_honest = [](double squared) { return squared >= kBarLow && squared <= kBarHigh; };
  const bool is_reached = is_honest(position) && is_honest(orientation) && accused <= kBarAccused;
  const auto besides = [](double a, double b, double c) {
    return formatFixed(a, 2) + " / " + formatFixed(b, 2) + " / " + formatFixed(c, 2);
  };
  const FigureRow figures = {
      ofCount("poses", "poses", skin_case.poses),
      ofText("orientation", "", besides(known, independent, bound)),
      ofText("stated", "", besides(position, orientation, accused) + (is_reached ? "" : " NO")),
      ofCount("", "skins", skins),
      ofNumber("", "orientation_deg", known),
      ofNumber("", "orientation_independent_priors_deg", independent),
      ofNumber("", "bound_rms_deg", bound),
      ofNumber("", kOfBound, toDegrees(std::sqrt(tally.mean("known squared").value_or(0))) / bound),
      ofNumber("", "nees_position", position),
      ofNumber("", "nees_orientation", orientation),
      ofShare("", "accused", tally.share("accused"), 3),
      ofShare("", "alarms", tally.share("alarms"), 2),
      {"", "", "reached", is_reached}};
  row.insert(row.end(), figures.begin(), figures.end());
  return row;
}

FigureRow runHealthyRow(const Trials& trials, const Lot& lot, std::size_t poses) {
  const SkinCase skin_case = skinOf(lot, "x17", "cylinder:r=0.0501", poses);
  FigureRow row = describe(lot);
  row.push_back(ofCount("poses", "poses", poses));
  return withFalseAlarms(std::move(row),
                         trials.run("healthy lots", kMoreHealthy * trials.seeds(), [&](Tally& found, std::size_t seed) {
                           SimulatedSkin skin = makeSkin(skin_case, seed);
                           const Session session = measure(skin, skin_case);
                           countFalseAlarms(found, *reconstruct(*session.snapshot()));
                         }));
}

void print(const std::vector<FigureRow>& rows, const FigureRow& few, const std::vector<FigureRow>& healthy,
           std::size_t seeds) {
  std::cout
      << "Chips of one lot, on simulated skins, hand-held, global solver, defaults: " << seeds << " skins per row, "
      << rows.back()[7].text << " of the torus.\nAn offset of " << formatFixed(kOffset_mg, 0)
      << " mg (1 sigma) per axis, of whose variance all chips share the stated part; the scale (1 sigma) that they\n"
      << "share beside 2 % of each chip's own; and chips that sit askew in their cells (1 sigma about each axis).\n\n"
      << "Orientation, degrees: median over the skins where the cell model knows the lot / the same where it states\n"
      << "all errors as the chips' own, of the same size / the Cramer-Rao bound, rms over the skins; medians may lie\n"
      << "below. The bound is that of the joint estimate's information matrix at the true placements and forces, with\n"
      << "the cell model's sigmas as priors and the tremor that the readings show, each cell's own as the estimate has "
         "it,\n"
      << "while cells of one part tremble together. Errors are rms over the cells, all turned together to fit "
         "best.\n\n";
  printTable(besideEachOther(rows, 4, "orientation"));
  const auto ofBound = [](const FigureRow& row) {
    return std::ranges::find(row, kOfBound, &Figure::key)->value.get<double>();
  };
  const auto [least, most] = std::ranges::minmax_element(rows, {}, ofBound);
  std::cout << "\nThe rms errors of the first are " << formatFixed(ofBound(*least), 2) << " to "
            << formatFixed(ofBound(*most), 2) << " times the bound.\n";
  std::cout << "\nStated uncertainty of the first: normalised estimation error squared (mean) of positions / of\n"
            << "orientations / cells accused in vain, %. Bars: " << formatFixed(kBarLow, 1) << " to "
            << formatFixed(kBarHigh, 1) << ", " << formatFixed(kBarAccused, 1) << " %. NO marks what is outside.\n\n";
  printTable(besideEachOther(rows, 4, "stated"));
  std::cout << "\nX17, offset of 50 mg of the lot and 15 mg of each chip, 2 poses; figures as above:\n\n";
  printTable({few});
  std::cout << "\nHealthy X17 (r = 50.1 mm) by a model that knows the lot, " << kMoreHealthy * seeds
            << " sessions per row:\n\n";
  printTable(healthy);
}

}  // namespace

Json tabulateLots(const Trials& trials, bool prints) {
  const std::vector<std::pair<std::string, std::string>> patches = {{"x17", "cylinder:r=0.0501"},
                                                                    {"ring8:closed", ""},
                                                                    {"sheet:5x5", "cylinder:r=0.08"},
                                                                    {"sheet:10x10", "torus:R=0.2,r=0.1"}};
  std::vector<FigureRow> rows;
  for (const auto& [patch, surface] : patches) {
    for (const Lot& lot : lots()) {
      FigureRow row = describe(lot);
      row.insert(row.begin(), ofText("skin", "skin", surface.empty() ? patch : patch + " on " + surface));
      for (const std::size_t poses : {2U, 3U, 4U, 6U}) {
        rows.push_back(runRow(trials, skinOf(lot, patch, surface, poses), row));
      }
    }
  }
  FigureRow few = runRow(
      trials,
      {.patch = "x17", .surface = "cylinder:r=0.0501", .poses = 2, .offset_sigma_mg = 15, .offset_shared_sigma_mg = 50},
      {});
  few.insert(few.end() - 1, {"bar", "<= " + formatFixed(kBarOrientation, 1) + " deg", "bar_deg", kBarOrientation});
  few.back() = ofBar(true, few[4].value.get<double>() <= kBarOrientation);
  std::vector<FigureRow> healthy;
  for (const Lot& lot : lots()) {
    for (const std::size_t poses : {3U, 4U}) healthy.push_back(runHealthyRow(trials, lot, poses));
  }
  if (prints) print(rows, few, healthy, trials.seeds());
  return {{"rows", toJson(rows)}, {"few_poses", toJson({few})}, {"healthy", toJson(healthy)}};
}

}  // namespace hexoderm::cli
