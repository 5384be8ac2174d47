#include "hexoderm/mounting/place/placement_search.h"

#include "hexoderm/base/procrustes.h"
#include "hexoderm/base/units.h"
#include "hexoderm/mounting/parts/farthest_first.h"

#include <boost/math/distributions/chi_squared.hpp>

#include <Eigen/Dense>
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numeric>
#include <set>
#include <utility>

namespace hexoderm {
namespace {

constexpr std::size_t kCoarseCells = 20;        ///< with so many of a patch places are looked for
constexpr std::size_t kMaxSamples = 4000;       ///< of a surface
constexpr std::size_t kMaxTries = 25000;        ///< laid on the surface, to see how they fit
constexpr std::size_t kMaxStarts = 250;         ///< that are refined
constexpr std::size_t kMaxMinima = 80;          ///< that are refined to the end
constexpr std::size_t kMaxOfPatch = 8;          ///< minima of a patch that are combined with those of others
constexpr std::size_t kMaxTogether = 64;        ///< combinations
constexpr double kSureTurn_rad = 10 * kDegree;  ///< a rotation that is known better is a start by itself
constexpr double kMaxTilt_rad = 35 * kDegree;   ///< of a start's middle cell against the surface
constexpr double kYawStep_rad = 15 * kDegree;
constexpr double kStride_m = 0.010;  ///< of a way between two minima
constexpr double kNear_m = 0.012;
constexpr double kValleyStep_m = 0.004;

// --- where to begin

/// The cell nearest to the patch's middle.
std::size_t middleCell(const FitPatch& patch) {
  std::size_t best = 0;
  for (std::size_t k = 1; k < patch.T_o_u.size(); ++k) {
    if ((patch.T_o_u[k].t - patch.middle_o).norm() < (patch.T_o_u[best].t - patch.middle_o).norm()) best = k;
  }
  return best;
}

/// Cells all over a patch: each the farthest from those before.
std::vector<std::size_t> spreadCells(const FitPatch& patch, std::size_t most) {
  return farthestFirst(patch.T_o_u.size(), most, middleCell(patch),
                       [&](std::size_t a, std::size_t b) { return (patch.T_o_u[a].t - patch.T_o_u[b].t).norm(); });
}

FitProblem coarseProblem(const FitProblem& problem) {
  std::vector<std::vector<std::size_t>> cells;
  for (const FitPatch& patch : problem.patches) cells.push_back(spreadCells(patch, kCoarseCells));
  return onlyCells(problem, cells);
}

bool isSure(const std::optional<KnownRotation>& rotation) {
  return rotation &&
         Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d>(rotation->covariance, Eigen::EigenvaluesOnly).eigenvalues()[2] <
             kSureTurn_rad * kSureTurn_rad;
}

/// Whether a start is turned as is known, as far as starts are from their minima.
bool isPossible(const Eigen::Matrix3d& R_l_o, const std::optional<KnownRotation>& rotation) {
  if (!rotation) return true;
  constexpr double kMaxDeviations = 3.5;
  const Eigen::Vector3d error = logSO3(rotation->R_l_o.transpose() * R_l_o);
  const Eigen::Matrix3d covariance =
      rotation->covariance + kYawStep_rad * kYawStep_rad / 2 * Eigen::Matrix3d::Identity();
  return error.dot(covariance.ldlt().solve(error)) < kMaxDeviations * kMaxDeviations;
}

/// Turns with which a cell, whose z is `z_o` in the patch, can lie on a surface with this normal.
std::vector<Eigen::Matrix3d> turnsOnto(const Eigen::Vector3d& normal, const Eigen::Vector3d& z_o,
                                       const std::optional<KnownRotation>& rotation) {
  if (isSure(rotation)) {
    if (angleBetween(rotation->R_l_o * z_o, normal) > kMaxTilt_rad) return {};
    return {rotation->R_l_o};
  }
  const Eigen::Matrix3d known = rotation ? rotation->R_l_o : Eigen::Matrix3d::Identity();
  const Eigen::Matrix3d onto = shortestRotation((known * z_o).normalized(), normal) * known;
  std::vector<Eigen::Matrix3d> turns;
  for (double yaw = 0; yaw < 2 * kPi - kYawStep_rad / 2; yaw += kYawStep_rad) {
    const Eigen::Matrix3d R = expSO3(yaw * normal) * onto;
    if (isPossible(R, rotation)) turns.push_back(R);
  }
  return turns;
}

/// The directions of a cube's corners, edges and faces from its middle.
std::vector<Eigen::Vector3d> directionsAllAround() {
  std::vector<Eigen::Vector3d> directions;
  for (int k = 0; k < 27; ++k) {
    const Eigen::Vector3d v(k % 3 - 1, k / 3 % 3 - 1, k / 9 - 1);
    if (v.norm() > 0) directions.push_back(v.normalized());
  }
  return directions;
}

/// Turns all around, as far as they are possible.
std::vector<Eigen::Matrix3d> turnsAllAround(const std::optional<KnownRotation>& rotation) {
  if (isSure(rotation)) return {rotation->R_l_o};
  std::vector<Eigen::Matrix3d> turns;
  for (const Eigen::Vector3d& up : directionsAllAround()) {
    for (double yaw = 0; yaw < 2 * kPi - kYawStep_rad; yaw += 2 * kYawStep_rad) {
      const Eigen::Matrix3d R = expSO3(yaw * up) * shortestRotation(Eigen::Vector3d::UnitZ(), up);
      if (isPossible(R, rotation)) turns.push_back(R);
    }
  }
  if (rotation) turns.push_back(rotation->R_l_o);
  return turns;
}

std::vector<FitState> startsAtPoints(const FitProblem& problem) {
  const FitPatch& patch = problem.patches.front();
  std::vector<Eigen::Vector3d> of_link;
  std::vector<Eigen::Vector3d> of_patch;
  for (const FitPoint& point : problem.points) {
    of_link.push_back(point.x_l);
    of_patch.push_back(patch.T_o_u[point.cell].t);
  }
  const auto mean = [](const std::vector<Eigen::Vector3d>& points) -> Eigen::Vector3d {
    return std::accumulate(points.begin(), points.end(), Eigen::Vector3d(Eigen::Vector3d::Zero())) /
           static_cast<double>(points.size());
  };
  std::vector<FitState> starts;
  if (of_link.size() >= 3) starts.push_back({alignPoints(of_link, of_patch)});
  for (const Eigen::Matrix3d& R : turnsAllAround(patch.rotation)) {
    starts.push_back({SE3{R, mean(of_link) - R * mean(of_patch)}});
  }
  return starts;
}

std::vector<FitState> startsOnSurface(const FitProblem& problem, const std::vector<SurfaceSample>& samples) {
  const FitPatch& patch = problem.patches.front();
  const SE3& middle = patch.T_o_u[middleCell(patch)];
  const Eigen::Vector3d back_o = middle * Eigen::Vector3d(0, 0, -problem.back_m);
  // Where any turn is possible there are so many starts that fewer points have to do.
  const std::size_t per_sample = isSure(patch.rotation) ? 1 : static_cast<std::size_t>(2 * kPi / kYawStep_rad);
  const std::size_t stride = 1 + samples.size() * per_sample / kMaxTries;
  std::vector<FitState> starts;
  for (std::size_t k = 0; k < samples.size(); k += stride) {
    const SurfaceSample& sample = samples[k];
    for (const Eigen::Matrix3d& R : turnsOnto(sample.normal, middle.R.col(2), patch.rotation)) {
      starts.push_back({SE3{R, sample.x - R * back_o}});
    }
  }
  return starts;
}

// --- minima

/// The starts from which the fit is best at once.
std::vector<FitState> mostHopeful(const FitProblem& problem, std::vector<FitState> starts, std::size_t most) {
  if (starts.size() <= most) return starts;
  std::vector<std::pair<double, std::size_t>> misfits;
  for (std::size_t k = 0; k < starts.size(); ++k) misfits.emplace_back(roughMisfit(problem, starts[k]), k);
  std::ranges::nth_element(misfits, misfits.begin() + static_cast<std::ptrdiff_t>(most));
  misfits.resize(most);
  std::ranges::sort(misfits);
  std::vector<FitState> chosen;
  for (const auto& [misfit, k] : misfits) chosen.push_back(std::move(starts[k]));
  return chosen;
}

/// The minima that the starts lead to, the best first, each once.
std::vector<FitSolution> minimaFrom(const FitProblem& problem, const std::vector<FitState>& starts) {
  constexpr int kFirstSteps = 6;
  constexpr int kSteps = 30;
  constexpr double kHopeless = 500;
  constexpr double kSame_m = 0.0005;
  std::vector<FitSolution> begun;
  for (const FitState& start : starts) begun.push_back(refine(problem, start, kFirstSteps));
  std::ranges::sort(begun, {}, &FitSolution::chi_squared);
  std::vector<FitSolution> minima;
  std::size_t refined = 0;
  for (const FitSolution& solution : begun) {
    if (refined == kMaxMinima || solution.chi_squared > 4 * begun.front().chi_squared + kHopeless) break;
    const auto is_same = [&](const FitSolution& other) {
      return distanceBetween(problem, other.state, solution.state) < kSame_m;
    };
    if (std::ranges::any_of(minima, is_same)) continue;
    ++refined;
    FitSolution minimum = refine(problem, solution.state, kSteps);
    const auto is_known = [&](const FitSolution& other) {
      return distanceBetween(problem, other.state, minimum.state) < kSame_m;
    };
    if (std::ranges::none_of(minima, is_known)) minima.push_back(std::move(minimum));
  }
  std::ranges::sort(minima, {}, &FitSolution::chi_squared);
  return minima;
}

/// Some minima far from each other, the best among them.
std::vector<FitState> spreadMinima(const FitProblem& problem, const std::vector<FitSolution>& minima, double limit) {
  std::vector<FitState> hopeful;
  for (const FitSolution& minimum : minima) {
    if (hopeful.empty() || minimum.chi_squared <= limit) hopeful.push_back(minimum.state);
  }
  std::vector<FitState> chosen;
  const auto distance = [&](std::size_t a, std::size_t b) { return distanceBetween(problem, hopeful[a], hopeful[b]); };
  for (const std::size_t k : farthestFirst(hopeful.size(), kMaxOfPatch, 0, distance)) chosen.push_back(hopeful[k]);
  return chosen;
}

bool isAnchored(const FitProblem& problem, std::size_t patch) {
  return problem.feet != nullptr ||
         std::ranges::any_of(problem.points, [&](const FitPoint& point) { return point.patch == patch; });
}

/// Where a patch can be by itself.
std::vector<FitSolution> minimaOfPatch(const FitProblem& problem, std::size_t patch,
                                       const std::vector<SurfaceSample>& samples) {
  const FitProblem alone = onlyPatches(problem, {patch});
  std::vector<FitState> starts = alone.points.empty() ? startsOnSurface(alone, samples) : startsAtPoints(alone);
  return minimaFrom(alone, mostHopeful(alone, std::move(starts), kMaxStarts));
}

/// Starts of the last patch of a problem, of which nothing is known but distances, beside those that have a place.
std::vector<FitState> startsByDistances(const FitProblem& problem, const FitState& placed) {
  const std::size_t added = placed.size();
  const FitPatch& patch = problem.patches[added];
  std::vector<FitState> starts;
  for (const FitDistance& distance : problem.distances) {
    if (distance.patch_a != added && distance.patch_b != added) continue;
    const bool is_a = distance.patch_a == added;
    const std::size_t own = is_a ? distance.cell_a : distance.cell_b;
    const std::size_t other_patch = is_a ? distance.patch_b : distance.patch_a;
    const std::size_t other = is_a ? distance.cell_b : distance.cell_a;
    const Eigen::Vector3d from = placed[other_patch] * problem.patches[other_patch].T_o_u[other].t;
    for (const Eigen::Vector3d& way : directionsAllAround()) {
      for (const Eigen::Matrix3d& R : turnsAllAround(patch.rotation)) {
        FitState start = placed;
        start.push_back({R, from + distance.distance_m * way - R * patch.T_o_u[own].t});
        starts.push_back(std::move(start));
      }
    }
    break;
  }
  if (starts.empty()) {
    FitState start = placed;
    start.push_back(SE3{});
    starts.push_back(std::move(start));
  }
  return starts;
}

/// Minima of all patches together, from those of the patches by themselves.
std::vector<FitSolution> minimaTogether(const FitProblem& problem, const std::vector<SurfaceSample>& samples,
                                        double false_alarm) {
  std::vector<std::size_t> order(problem.patches.size());
  std::iota(order.begin(), order.end(), 0U);
  std::stable_partition(order.begin(), order.end(), [&](std::size_t p) { return isAnchored(problem, p); });

  std::vector<FitState> found = {FitState{}};
  std::vector<FitSolution> minima;
  for (std::size_t count = 1; count <= order.size(); ++count) {
    const std::size_t added = order[count - 1];
    const std::vector<std::size_t> so_far(order.begin(), order.begin() + static_cast<std::ptrdiff_t>(count));
    const FitProblem part = onlyPatches(problem, so_far);
    std::vector<FitState> starts;
    if (isAnchored(problem, added)) {
      const FitProblem alone = onlyPatches(problem, {added});
      const std::vector<FitSolution> own = minimaOfPatch(problem, added, samples);
      if (own.empty()) return {};
      const double limit = limitOf(alone, false_alarm).above(own.front().chi_squared);
      for (const FitState& place : spreadMinima(alone, own, limit)) {
        for (const FitState& before : found) {
          FitState start = before;
          start.push_back(place.front());
          starts.push_back(std::move(start));
        }
      }
    } else {
      for (const FitState& before : found) {
        for (FitState& start : startsByDistances(part, before)) starts.push_back(std::move(start));
      }
    }
    minima = minimaFrom(part, mostHopeful(part, std::move(starts), kMaxTogether));
    if (minima.empty()) return {};
    found.clear();
    for (const FitState& state : spreadMinima(part, minima, limitOf(part, false_alarm).above(minima[0].chi_squared))) {
      found.push_back(state);
    }
  }
  for (FitSolution& minimum : minima) {
    FitState sorted(order.size());
    for (std::size_t k = 0; k < order.size(); ++k) sorted[order[k]] = minimum.state[k];
    minimum.state = std::move(sorted);
  }
  return minima;
}

// --- ways between minima

/// Whether all places on a way from one state to another fit. The way is a screw at first, and then where the misfit is
/// least across it.
bool fitsAllTheWay(const FitProblem& problem, const FitState& from, const FitState& to, double most_chi_squared) {
  constexpr int kMaxStrides = 200;
  constexpr int kRefinements = 4;
  FitState at = from;
  double left_m = distanceBetween(problem, at, to);
  if (left_m > kMaxStrides * kStride_m) return false;
  for (int k = 0; k < kMaxStrides; ++k) {
    const bool is_last = left_m < kNear_m;
    const double share = is_last ? 0.5 : kStride_m / left_m;
    const Eigen::VectorXd way = stepBetween(problem, at, wayFrom(at, to, share));
    const FitSolution next = refine(problem, moved(problem, at, way), kRefinements, way.normalized());
    if (next.chi_squared > most_chi_squared) return false;
    if (is_last) return true;
    const double now_left_m = distanceBetween(problem, next.state, to);
    if (now_left_m > left_m - 0.2 * kStride_m) return false;
    at = next.state;
    left_m = now_left_m;
  }
  return false;
}

/// Minima between which ways lead.
struct Basin {
  FitSolution best;
  std::vector<FitState> members;
  [[nodiscard]] std::pair<double, std::size_t> nearest(const FitProblem& problem, const FitState& state) const {
    std::pair<double, std::size_t> nearest{std::numeric_limits<double>::infinity(), 0};
    for (std::size_t k = 0; k < members.size(); ++k) {
      nearest = std::min(nearest, {distanceBetween(problem, members[k], state), k});
    }
    return nearest;
  }
};

/// Grows the basin of the best minimum, then that of the best of those left, and so on. A minimum joins from the member
/// that is nearest to it.
std::vector<FitSolution> basinsOf(const FitProblem& problem, std::vector<FitSolution> minima, double limit) {
  std::vector<FitSolution> best;
  while (!minima.empty()) {
    Basin basin{minima.front(), {minima.front().state}};
    minima.erase(minima.begin());
    std::set<std::pair<std::size_t, std::size_t>> tried;  // number of the minimum, member
    std::vector<std::size_t> left(minima.size());
    std::iota(left.begin(), left.end(), 0U);
    for (bool grows = true; grows;) {
      grows = false;
      std::vector<std::pair<std::pair<double, std::size_t>, std::size_t>> nearest;
      for (const std::size_t k : left) nearest.push_back({basin.nearest(problem, minima[k].state), k});
      std::ranges::sort(nearest);
      for (const auto& [from, k] : nearest) {
        if (!tried.insert({k, from.second}).second) continue;
        if (!fitsAllTheWay(problem, basin.members[from.second], minima[k].state, limit)) continue;
        basin.members.push_back(minima[k].state);
        std::erase(left, k);
        grows = true;
        break;
      }
    }
    std::vector<FitSolution> others;
    for (const std::size_t k : left) others.push_back(std::move(minima[k]));
    minima = std::move(others);
    best.push_back(std::move(basin.best));
  }
  return best;
}

}  // namespace

double spacingOn(const TriangleMesh& mesh, double spacing_m) {
  double area_m2 = 0;
  for (const auto& [a, b, c] : mesh.triangles) {
    area_m2 += (mesh.points[b] - mesh.points[a]).cross(mesh.points[c] - mesh.points[a]).norm() / 2;
  }
  return std::max(spacing_m, std::sqrt(area_m2 / static_cast<double>(kMaxSamples)));
}

std::vector<SurfaceSample> samplesOf(const TriangleMesh& mesh, const MeshFeet& feet, double spacing_m) {
  const double step_m = spacingOn(mesh, spacing_m);
  std::vector<SurfaceSample> samples;
  // One in every cube of a grid and for every side that the surface faces.
  std::set<std::array<std::int64_t, 4>> taken;
  for (const auto& [a, b, c] : mesh.triangles) {
    const Eigen::Vector3d& corner = mesh.points[a];
    const Eigen::Vector3d ab = mesh.points[b] - corner;
    const Eigen::Vector3d ac = mesh.points[c] - corner;
    const double longest_m = std::max({ab.norm(), ac.norm(), (ac - ab).norm()});
    const auto parts = static_cast<int>(std::clamp(std::ceil(2 * longest_m / step_m), 1.0, 500.0));
    for (int i = 0; i < parts; ++i) {
      for (int j = 0; j < parts - i; ++j) {
        const Eigen::Vector3d x = corner + (i + 1.0 / 3) / parts * ab + (j + 1.0 / 3) / parts * ac;
        Eigen::Index side = 0;
        const Eigen::Vector3d way = ab.cross(ac);
        way.cwiseAbs().maxCoeff(&side);
        std::array<std::int64_t, 4> cube{};
        for (std::size_t k = 0; k < 3; ++k) {
          cube[k] = static_cast<std::int64_t>(std::floor(x[static_cast<Eigen::Index>(k)] / step_m));
        }
        cube[3] = 2 * side + (way[side] > 0 ? 1 : 0);
        if (!taken.insert(cube).second) continue;
        const MeshFoot foot = feet.footOf(x);
        samples.push_back({foot.position, foot.normal});
      }
    }
  }
  return samples;
}

double FitLimit::above(double best) const { return best > absolute ? best + worse : std::min(absolute, best + worse); }

int freedomOf(const FitProblem& problem) {
  std::size_t equations = 3 * problem.points.size() + problem.distances.size();
  for (const FitPatch& patch : problem.patches) {
    if (problem.feet != nullptr) equations += 3 * patch.T_o_u.size();
    if (patch.rotation) equations += 3;
  }
  return std::max(1, static_cast<int>(equations) - static_cast<int>(problem.unknowns()));
}

FitLimit limitOf(const FitProblem& problem, double false_alarm) {
  const auto quantile = [&](double freedom) {
    return boost::math::quantile(boost::math::complement(boost::math::chi_squared(freedom), false_alarm));
  };
  return {quantile(freedomOf(problem)), quantile(static_cast<double>(problem.unknowns()))};
}

std::vector<FitSolution> findPlaces(const FitProblem& problem, const std::vector<SurfaceSample>& samples,
                                    double false_alarm) {
  constexpr int kLastSteps = 20;
  const FitProblem coarse = coarseProblem(problem);
  std::vector<FitSolution> minima = coarse.patches.size() == 1 && isAnchored(coarse, 0)
                                        ? minimaOfPatch(coarse, 0, samples)
                                        : minimaTogether(coarse, samples, false_alarm);
  if (minima.empty()) return {};
  // With fewer cells less is improbable.
  const double hopeful = limitOf(coarse, false_alarm).above(minima.front().chi_squared);
  std::erase_if(minima, [&](const FitSolution& minimum) { return minimum.chi_squared > hopeful; });
  std::vector<FitSolution> places = basinsOf(coarse, std::move(minima), hopeful);
  for (FitSolution& place : places) place = refine(problem, place.state, kLastSteps);
  std::ranges::sort(places, {}, &FitSolution::chi_squared);
  const double limit = limitOf(problem, false_alarm).above(places.front().chi_squared);
  std::erase_if(places, [&](const FitSolution& place) { return place.chi_squared > limit; });
  return places;
}

bool isWayBetween(const FitProblem& problem, const FitState& from, const FitState& to, double false_alarm) {
  const FitProblem coarse = coarseProblem(problem);
  return fitsAllTheWay(coarse, from, to, limitOf(coarse, false_alarm).above(refine(coarse, from, 0).chi_squared));
}

UnobservableDirection followUnobservableDirection(const FitProblem& problem, const FitState& from,
                                                  const Eigen::VectorXd& direction, double most_chi_squared,
                                                  std::size_t patch) {
  constexpr int kMaxSteps = 400;
  constexpr int kRefinements = 3;
  constexpr double kTwoDeviations = 4;
  constexpr double kShortest_m = kValleyStep_m / 8;
  const double farthest_m = 3 * problem.link_size_m;
  const FitProblem coarse = coarseProblem(problem);
  const double begun = refine(coarse, from, 0).chi_squared;
  const double most = most_chi_squared + begun - refine(problem, from, 0).chi_squared;
  UnobservableDirection valley;
  FitState before = from;
  FitState at = from;
  double stride_m = kValleyStep_m;
  double last_m = 0;
  double gone_m = 0;
  bool is_near = true;
  for (int k = 0; k < kMaxSteps && gone_m < farthest_m && stride_m >= kShortest_m; ++k) {
    // On as the last step went, as seen from the link.
    const FitState ahead =
        last_m > 0 ? wayFrom(before, at, 1 + stride_m / last_m) : moved(coarse, at, stride_m * direction);
    const Eigen::VectorXd way = stepBetween(coarse, at, ahead);
    const FitSolution next = refine(coarse, ahead, kRefinements, way.normalized());
    if (next.chi_squared > most) {
      stride_m /= 2;
      continue;
    }
    last_m = distanceBetween(coarse, at, next.state);
    if (last_m < 0.1 * stride_m) break;
    gone_m += last_m;
    valley.turn_rad += rotationAngle(at[patch].R.transpose() * next.state[patch].R);
    before = std::exchange(at, next.state);
    valley.states.push_back(at);
    valley.reach_m = std::max(valley.reach_m, distanceBetween(coarse, from, at));
    is_near = is_near && next.chi_squared < begun + kTwoDeviations;
    if (is_near) valley.near_reach_m = valley.reach_m;
    if (valley.turn_rad > kPi && distanceBetween(coarse, from, at) < 2 * kValleyStep_m) {
      valley.all_the_way = true;
      break;
    }
  }
  return valley;
}

}  // namespace hexoderm
