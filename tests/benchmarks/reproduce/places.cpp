#include "tests/benchmarks/reproduce/trials.h"

#include "hexoderm/base/mesh_feet.h"
#include "hexoderm/base/text.h"
#include "hexoderm/base/units.h"
#include "hexoderm/mounting/place/place.h"
#include "hexoderm/robots/demo_robot.h"
#include "hexoderm/robots/robot_model.h"
#include "hexoderm/sim/simulated_session.h"
#include "hexoderm/solve/reconstructor.h"

#include "tests/support/nearest_place.h"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <iostream>
#include <limits>
#include <random>

namespace hexoderm::cli {
namespace {

constexpr double kBarAmong = 95;  ///< percent
constexpr double kBarError_m = 0.003;
constexpr double kBarNees = 3;
/// 99.9 % of chi-squared with six degrees of freedom.
constexpr double kMaxSquaredDeviates = 22.46;

/// A link's body and where a patch is laid on it.
struct PlaceBody {
  std::string name;
  TriangleMesh mesh;
  double from_m = 0;  ///< of the patch's middle along z
  double to_m = 0;
};

struct PlaceCase {
  const PlaceBody* body = nullptr;
  std::size_t poses = 4;
  std::optional<double> turn_sigma_rad;  ///< of the rotation about the link's z; absent: as about the others
};

Eigen::Vector3d normalVector(std::mt19937_64& random) {
  std::normal_distribution<double> normal;
  const double x = normal(random);
  const double y = normal(random);
  return {x, y, normal(random)};
}

/// Rms distance of the cells from where they are, less what a motion along what is left open does.
double errorAcross(const test::NearestPlace& nearest, const PatchToPlace& patch, const GroundTruth& truth) {
  const auto rows = static_cast<Eigen::Index>(3 * patch.cells.size());
  Eigen::VectorXd error(rows);
  Eigen::MatrixXd open = Eigen::MatrixXd::Zero(rows, 6);
  for (std::size_t k = 0; k < patch.cells.size(); ++k) {
    const auto at = static_cast<Eigen::Index>(3 * k);
    const Eigen::Vector3d x = nearest.T_l_o * patch.T_o_u[k].t;
    error.segment<3>(at) = truePlacement(truth, patch.cells[k]).t - x;
    Eigen::Index column = 0;
    for (const FreeDirection& free : nearest.patch->free) {
      if (!free.held_by_rotation) open.block<3, 1>(at, column++) = free.shift_m + free.turn_rad.cross(x);
    }
  }
  const Eigen::VectorXd across = error - open * open.completeOrthogonalDecomposition().solve(error);
  return std::sqrt(across.squaredNorm() / static_cast<double>(patch.cells.size()));
}

void runTrial(Tally& tally, const PlaceCase& what, std::size_t seed) {
  std::mt19937_64 random(seed);
  std::uniform_real_distribution<double> share(0, 1);
  const CellModel model = independentChips();
  const double around = 2 * kPi * share(random);
  const double along = what.body->from_m + (what.body->to_m - what.body->from_m) * share(random);
  const SE3 T_l_near{rotationFromRpy({0, 0, around + kPi / 2}),
                     {0.1 * std::cos(around), 0.1 * std::sin(around), along}};
  SimulatedSkinOptions options;
  options.seed = seed;
  options.laid_on = std::make_shared<MeshSurface>(what.body->mesh, T_l_near, model.thickness_m);
  SimulatedSkin skin(model, options);
  const GroundTruth truth = skin.groundTruth();
  const auto solved = reconstruct(*simulateSession(skin, what.poses).snapshot());
  const PatchReconstruction* patch = largestPatch(*solved);
  if (patch == nullptr) {
    tally.count("among", false);
    return;
  }
  const SE3 T_l_o = truePlacement(truth, patch->origin);

  PlaceTask task;
  task.link = what.body->name;
  task.surface = what.body->mesh;
  task.thickness_m = model.thickness_m;
  task.patches = {patchToPlace(*patch)};
  Eigen::Matrix3d sigma_l = kDegree * Eigen::Matrix3d::Identity();
  if (what.turn_sigma_rad) sigma_l(2, 2) = *what.turn_sigma_rad;
  // Where it is not known, any turn about the link's z is as good as the true one.
  Eigen::Vector3d error_l = sigma_l * normalVector(random);
  if (what.turn_sigma_rad) error_l.z() = *what.turn_sigma_rad * (2 * share(random) - 1);
  const Eigen::Matrix3d R = expSO3(error_l) * T_l_o.R;
  task.patches.front().rotation = KnownRotation{R, R.transpose() * sigma_l * sigma_l * R};

  const PlaceResult result = placePatches(task);
  const test::NearestPlace nearest = test::nearestPlace(result, T_l_o);
  const bool is_among = nearest.squared_deviates <= kMaxSquaredDeviates;
  tally.note("candidates", static_cast<double>(result.candidates.size()));
  tally.count("among", is_among);
  tally.count("alone", is_among && result.candidates.size() == 1);
  if (nearest.patch == nullptr) return;
  const auto leavesOpen = [&](FreeDirection::Kind kind) {
    return std::ranges::find(nearest.patch->free, kind, &FreeDirection::kind) != nearest.patch->free.end();
  };
  tally.count("slide named", leavesOpen(FreeDirection::Kind::Slide));
  tally.count("turn named", leavesOpen(FreeDirection::Kind::Turn));
  tally.count("determined", std::ranges::all_of(nearest.patch->free, &FreeDirection::held_by_rotation));
  tally.note("error",
             errorAcross(nearest, task.patches.front(), truth));  // of the cells, rms, across what is left open
  tally.note("NEES", nearest.squared_deviates / 6);
}

std::vector<PlaceBody> placeBodies() {
  const RobotModel robot = RobotModel::read(demoRobotFile());
  const auto body = [&](const std::string& link) { return robot.bodyOf(robot.linkNamed(link)); };
  return {{"box-like", body("upper_arm"), 0.12, 0.16},
          {"forearm", body("forearm"), 0.11, 0.15},
          {"cylinder", meshOfCylinder(0.0501, 0.5), -0.1, 0.1}};
}

FigureRow runRow(const Trials& trials, const PlaceCase& what) {
  const Tally tally =
      trials.run("place on " + what.body->name, [&](Tally& found, std::size_t seed) { runTrial(found, what, seed); });
  const bool is_known = !what.turn_sigma_rad;
  const double error_m = tally.median("error").value_or(0);
  const double worst_m = tally.quantile("error", 0.95).value_or(0);
  const auto rounded = [&](const char* title, const char* key) -> Figure {
    return {title, ofPercent("", "", tally.percent(title), 0).text, key, ofShare("", "", tally.share(title), 0).value};
  };
  return {ofText("link", "body", what.body->name),
          ofCount("poses", "poses", what.poses),
          {"turn", is_known ? "known" : "unknown", "turn_known", is_known},
          ofShare("among", "among", tally.share("among"), 1),
          rounded("alone", "alone"),
          ofNumber("places", "candidates_mean", tally.mean("candidates"), 1),
          rounded("slide named", "slide_named"),
          rounded("turn named", "turn_named"),
          rounded("determined", "determined"),
          {"error", millimetres(error_m), "error_median_mm", toMillimetres(error_m)},
          {"95 %", millimetres(worst_m), "error_95_mm", toMillimetres(worst_m)},
          ofNumber("NEES", "nees", tally.mean("NEES")),
          ofBar(true, tally.percent("among") >= kBarAmong && error_m <= kBarError_m &&
                          tally.mean("NEES").value_or(0) <= kBarNees)};
}

}  // namespace

Json placeOnLinks(const Trials& trials, bool prints) {
  const std::vector<PlaceBody> bodies = placeBodies();
  std::vector<PlaceCase> cases;
  for (const PlaceBody& body : bodies) {
    for (const std::size_t poses : {4, 8}) cases.push_back({&body, poses, std::nullopt});
  }
  cases.push_back({&bodies.back(), 4, kPi});
  std::vector<FigureRow> rows;
  for (const PlaceCase& what : cases) rows.push_back(runRow(trials, what));
  if (prints) {
    std::cout
        << "Where on a link a patch lies, by the link's surface: a simulated X17 in a hand, defaults, and the "
           "rotation\nknown to 1 deg (1 sigma) an axis, or but for the turn about the link's axis: "
        << trials.seeds()
        << " skins per row.\nAmong: the true place is among the candidates and the ways that they leave open. "
           "Error: of the cells, rms,\nacross what is left open, median and 95 %. With 95 % intervals. Bars: among >= "
        << formatFixed(kBarAmong, 0) << " %, error <= " << millimetres(kBarError_m, 0)
        << " in the median, NEES <= " << formatFixed(kBarNees, 0) << ".\n\n";
    printTable(rows);
  }
  return {{"skins", trials.seeds()}, {"rows", toJson(rows)}};
}

}  // namespace hexoderm::cli
