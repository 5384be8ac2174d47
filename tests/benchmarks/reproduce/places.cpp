#include "tests/benchmarks/reproduce/experiments.h"

#include "hexoderm/base/mesh_surface.h"
#include "hexoderm/base/text.h"
#include "hexoderm/base/units.h"
#include "hexoderm/mounting/place/place.h"
#include "hexoderm/robots/demo_robot.h"
#include "hexoderm/robots/robot_model.h"
#include "hexoderm/sim/simulated_session.h"
#include "hexoderm/solve/reconstructor.h"

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

struct PlaceRow {
  PlaceCase what;
  Share among;        ///< the true place is among the candidates
  Share alone;        ///< ... and is the only one
  Share slide_named;  ///< of what is left open, a slide and a turn
  Share turn_named;
  Share determined;  ///< nothing is left open
  std::vector<double> candidates;
  std::vector<double> error_m;  ///< of the cells, rms, across what is left open
  std::vector<double> nees;     ///< of T_l_o, per degree of freedom
  void operator+=(const PlaceRow& other) {
    among += other.among;
    alone += other.alone;
    slide_named += other.slide_named;
    turn_named += other.turn_named;
    determined += other.determined;
    const auto append = [](std::vector<double>& to, const std::vector<double>& from) {
      to.insert(to.end(), from.begin(), from.end());
    };
    append(candidates, other.candidates);
    append(error_m, other.error_m);
    append(nees, other.nees);
  }
  [[nodiscard]] bool reached() const {
    return among.percent() >= kBarAmong && median(error_m) <= kBarError_m && mean(nees) <= kBarNees;
  }
};

Eigen::Vector3d normalVector(std::mt19937_64& random) {
  std::normal_distribution<double> normal;
  const double x = normal(random);
  const double y = normal(random);
  return {x, y, normal(random)};
}

/// The error of a place in its covariance, both in the patch's frame, which goes with it.
double squaredDeviates(const PlacedPatch& placed, const SE3& T_l_o, const SE3& truth) {
  Eigen::Matrix<double, 6, 6> into = Eigen::Matrix<double, 6, 6>::Identity();
  into.topLeftCorner<3, 3>() = placed.place.T_l_o.R.transpose();
  const Eigen::Matrix<double, 6, 6> C = into * *placed.place.cov_t_r * into.transpose();
  Eigen::Matrix<double, 6, 1> e;
  e << T_l_o.R.transpose() * (truth.t - T_l_o.t), logSO3(T_l_o.R.transpose() * truth.R);
  return e.dot(C.ldlt().solve(e));
}

/// A candidate, or the place on the ways that it leaves open, where the truth deviates least.
struct NearestPlace {
  double squared_deviates = std::numeric_limits<double>::infinity();
  const PlacedPatch* patch = nullptr;
  SE3 T_l_o;
};

NearestPlace nearestPlace(const PlaceResult& result, const SE3& truth) {
  NearestPlace nearest;
  for (const PlaceCandidate& candidate : result.candidates) {
    const PlacedPatch& patch = candidate.patches.front();
    const auto look = [&](const SE3& T_l_o) {
      const double squared = squaredDeviates(patch, T_l_o, truth);
      if (squared < nearest.squared_deviates) nearest = {squared, &patch, T_l_o};
    };
    look(patch.place.T_l_o);
    for (const FreeDirection& free : patch.free) std::ranges::for_each(free.way, look);
  }
  return nearest;
}

/// Rms distance of the cells from where they are, less what a motion along what is left open does.
double errorAcross(const NearestPlace& nearest, const PatchToPlace& patch, const GroundTruth& truth) {
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

PlaceRow runTrial(const PlaceCase& what, std::size_t seed) {
  PlaceRow row{what, {}, {}, {}, {}, {}, {}, {}, {}};
  std::mt19937_64 random(seed);
  std::uniform_real_distribution<double> share(0, 1);
  const CellModel model = builtInCellModel("hex-bma150");
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
    row.among += {0, 1};
    return row;
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
  const NearestPlace nearest = nearestPlace(result, T_l_o);
  const bool is_among = nearest.squared_deviates <= kMaxSquaredDeviates;
  row.candidates.push_back(static_cast<double>(result.candidates.size()));
  row.among += {is_among ? 1U : 0U, 1};
  row.alone += {is_among && result.candidates.size() == 1 ? 1U : 0U, 1};
  if (nearest.patch == nullptr) return row;
  bool slides = false;
  bool turns = false;
  bool is_free = false;
  for (const FreeDirection& free : nearest.patch->free) {
    slides = slides || free.kind == FreeDirection::Kind::Slide;
    turns = turns || free.kind == FreeDirection::Kind::Turn;
    is_free = is_free || !free.held_by_rotation;
  }
  row.slide_named += {slides ? 1U : 0U, 1};
  row.turn_named += {turns ? 1U : 0U, 1};
  row.determined += {is_free ? 0U : 1U, 1};
  row.error_m.push_back(errorAcross(nearest, task.patches.front(), truth));
  row.nees.push_back(nearest.squared_deviates / 6);
  return row;
}

std::vector<PlaceBody> placeBodies() {
  const RobotModel robot = RobotModel::read(demoRobotFile());
  const auto body = [&](const std::string& link) { return robot.bodyOf(robot.linkNamed(link)); };
  return {{"box-like", body("upper_arm"), 0.12, 0.16},
          {"forearm", body("forearm"), 0.11, 0.15},
          {"cylinder", meshOfCylinder(0.0501, 0.5), -0.1, 0.1}};
}

FigureRow figuresOf(const PlaceRow& row) {
  const bool is_known = !row.what.turn_sigma_rad;
  const double error_m = median(row.error_m);
  const double worst_m = quantile(row.error_m, 0.95);
  const auto rounded = [](const char* title, const char* key, const Share& share) -> Figure {
    return {title, formatFixed(share.percent(), 0) + " %", key, cli::toJson(share)};
  };
  return {ofText("link", "body", row.what.body->name),
          ofCount("poses", "poses", row.what.poses),
          {"turn", is_known ? "known" : "unknown", "turn_known", is_known},
          ofShare("among", "among", row.among, 1),
          rounded("alone", "alone", row.alone),
          ofNumber("places", "candidates_mean", mean(row.candidates), 1),
          rounded("slide named", "slide_named", row.slide_named),
          rounded("turn named", "turn_named", row.turn_named),
          rounded("determined", "determined", row.determined),
          {"error", millimetres(error_m), "error_median_mm", toMillimetres(error_m)},
          {"95 %", millimetres(worst_m), "error_95_mm", toMillimetres(worst_m)},
          ofNumber("NEES", "nees", mean(row.nees)),
          ofBar(true, row.reached())};
}

}  // namespace

nlohmann::ordered_json placeOnLinks(const Trials& trials, bool prints) {
  const std::vector<PlaceBody> bodies = placeBodies();
  std::vector<PlaceCase> cases;
  for (const PlaceBody& body : bodies) {
    for (const std::size_t poses : {4, 8}) cases.push_back({&body, poses, std::nullopt});
  }
  cases.push_back({&bodies.back(), 4, kPi});
  std::vector<FigureRow> rows;
  for (const PlaceCase& what : cases) {
    PlaceRow row{what, {}, {}, {}, {}, {}, {}, {}, {}};
    for (const PlaceRow& trial : trials.run("place on " + what.body->name, trials.seeds(),
                                            [&](std::size_t seed) { return runTrial(what, seed); })) {
      row += trial;
    }
    rows.push_back(figuresOf(row));
  }
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
