#include "hexoderm/mounting/place/place.h"
#include "hexoderm/mounting/attachment/links.h"

#include "hexoderm/base/covariance.h"
#include "hexoderm/base/enum_names.h"
#include "hexoderm/base/error.h"
#include "hexoderm/base/is_rotation.h"
#include "hexoderm/base/units.h"
#include "hexoderm/mounting/parts/farthest_first.h"
#include "hexoderm/mounting/place/by_hand.h"
#include "hexoderm/mounting/place/placement_fit.h"
#include "hexoderm/mounting/place/placement_search.h"

#include <boost/math/distributions/chi_squared.hpp>

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <map>

namespace hexoderm {
namespace {

constexpr double kSampleSpacing_m = 0.010;
constexpr std::size_t kMaxPlacedCells = 150;

// --- what was given

void requireLength(double value_m, double least_m, const Message& what) {
  if (value_m >= least_m && value_m <= kMaxPlaceLength_m) return;
  throw InvalidArgument(message("{} must be from {} to {} m, found {} m", what, Number{least_m},
                                Number{kMaxPlaceLength_m}, Number{value_m}));
}

/// Which patch and which of its cells a cell is.
struct CellAt {
  std::size_t patch = 0;
  std::size_t cell = 0;
};

CellAt indexOf(const std::map<CellId, CellAt>& cells, CellId cell) {
  const auto found = cells.find(cell);
  if (found == cells.end()) throw InvalidArgument(message("none of the patches to place holds a cell {}", cell));
  return found->second;
}

/// isCovariance() of any size.
bool isJointCovariance(const Eigen::MatrixXd& C) {
  constexpr double kRounding = 1e-9;
  if (!C.allFinite()) return false;
  const double largest = C.diagonal().maxCoeff();
  if (!(largest > 0)) return C.isZero(0);
  if (!(C - C.transpose()).isZero(kRounding * largest)) return false;
  Eigen::MatrixXd raised = C;
  raised.diagonal().array() += kRounding * largest;
  return raised.llt().info() == Eigen::Success;
}

Eigen::MatrixXd covarianceOf(const PatchToPlace& patch) {
  const auto size = static_cast<Eigen::Index>(6 * patch.cells.size());
  if (patch.covariance.size() != static_cast<std::size_t>(size * size)) {
    throw InvalidArgument(message("the patch of cell {} needs a covariance of {} x {}, found {} numbers", patch.origin,
                                  size, size, patch.covariance.size()));
  }
  using RowMajor = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;
  Eigen::MatrixXd C = Eigen::Map<const RowMajor>(patch.covariance.data(), size, size);
  if (!isJointCovariance(C)) {
    throw InvalidArgument(
        message("the covariance of the patch of cell {} is none: it must be symmetric and positive semidefinite",
                patch.origin));
  }
  return C;
}

FitPatch fitPatchOf(const PatchToPlace& given, double least_radius_m) {
  FitPatch patch;
  patch.T_o_u = given.T_o_u;
  const auto origin = std::ranges::find(given.cells, given.origin);
  if (given.cells.size() != given.T_o_u.size() || origin == given.cells.end()) {
    throw InvalidArgument(
        message("the patch of cell {} must hold that cell, and a placement of every cell", given.origin));
  }
  patch.origin = static_cast<std::size_t>(origin - given.cells.begin());
  patch.C = covarianceOf(given);
  patch.rotation = given.rotation;
  if (patch.rotation) {
    const bool is_sure = patch.rotation->covariance.allFinite() && isCovariance(patch.rotation->covariance) &&
                         patch.rotation->covariance.llt().info() == Eigen::Success;
    if (!isRotation(patch.rotation->R_l_o) || !is_sure) {
      throw InvalidArgument(message(
          "the rotation of the patch of cell {} must be a rotation with a positive definite covariance", given.origin));
    }
  }
  if (given.start && !(isRotation(given.start->R) && given.start->t.allFinite())) {
    throw InvalidArgument(message("the place at which the patch of cell {} was put is none", given.origin));
  }
  const auto count = static_cast<double>(patch.T_o_u.size());
  for (const SE3& T_o_u : patch.T_o_u) {
    if (!T_o_u.R.allFinite() || !T_o_u.t.allFinite()) {
      throw InvalidArgument(message("a placement in the patch of cell {} is not finite", given.origin));
    }
    patch.middle_o += T_o_u.t / count;
  }
  double sum_m2 = 0;
  for (const SE3& T_o_u : patch.T_o_u) sum_m2 += (T_o_u.t - patch.middle_o).squaredNorm() / count;
  patch.radius_m = std::max(least_radius_m, std::sqrt(sum_m2));
  return patch;
}

double extentOf(const FitPatch& patch) {
  double extent_m = 0;
  for (const SE3& a : patch.T_o_u) {
    for (const SE3& b : patch.T_o_u) extent_m = std::max(extent_m, (a.t - b.t).norm());
  }
  return extent_m;
}

class Placement {
 public:
  Placement(const PlaceTask& task, const PlaceOptions& options) : task_(task), options_(options) {
    options.validate();
    if (task.patches.empty()) throw InvalidArgument(message("there is no patch to place"));
    if (!task.surface && task.points.empty() && task.distances.empty()) {
      throw InvalidArgument(
          message("nothing says where on the link the patch lies: it takes the link's surface, or "
                  "points, or distances to another patch"));
    }
    requireLength(task.thickness_m, 0, message("the cells' thickness"));
    if (task.surface) takeSurface(*task.surface);
    takePatches();
    takePoints();
    takeDistances();
  }

  PlaceResult place() {
    PlaceResult result;
    result.remarks = remarks_;
    for (const PatchToPlace& patch : task_.patches) {
      if (!patch.covariance_assumed) continue;
      result.remarks.push_back(
          message("How certain the cells of the patch of cell {} are is not stated; 2 mm and 3° were taken for each.",
                  patch.origin));
    }
    for (const std::optional<Message>& too_large : {patchLargerThanLink(), linkTooLargeToSearch()}) {
      if (!too_large) continue;
      result.verdict = PlaceVerdict::TooLarge;
      result.summary = *too_large;
      return result;
    }
    const std::vector<SurfaceSample> samples =
        feet_ ? samplesOf(surface_, *feet_, kSampleSpacing_m) : std::vector<SurfaceSample>();
    std::vector<FitSolution> places = findPlaces(problem_, samples, options_.false_alarm);
    if (places.size() > options_.most_candidates) {
      result.remarks.push_back(
          message("{} places fit; the best {} are given.", places.size(), options_.most_candidates));
      places.resize(options_.most_candidates);
    }
    const FitLimit limit = limitOf(problem_, options_.false_alarm);
    for (const FitSolution& place : places) {
      result.candidates.push_back(candidateOf(place, limit.absolute, limit.above(places.front().chi_squared)));
    }
    judge(result);
    addStart(places, result);
    return result;
  }

 private:
  void takeSurface(const TriangleMesh& mesh) {
    surface_ = mesh;
    for (const Eigen::Vector3d& point : mesh.points) {
      if (!point.allFinite())
        throw InvalidArgument(message("the mesh of link {} holds points that are not finite", task_.link));
    }
    if (isInsideOut(mesh)) {
      turnInsideOut(surface_);
      remarks_.push_back(
          message("The mesh of link {} is inside out: its triangles are clockwise as seen from outside, "
                  "and the volume inside is negative. It was taken the other way round.",
                  task_.link));
    }
    feet_.emplace(surface_);
    if (feet_->empty()) {
      throw InvalidArgument(
          message("the mesh of link {} has no triangle with an area, on which a patch could lie", task_.link));
    }
    link_size_m_ = boundingBox(mesh).size().norm();
    problem_.feet = &*feet_;
    problem_.link_size_m = link_size_m_;
  }

  void takePatches() {
    constexpr double kMinRadius_m = 0.005;
    problem_.back_m = task_.thickness_m + options_.gap_m;
    problem_.surface_sigma_m = options_.surface_sigma_m;
    problem_.normal_sigma_rad = options_.normal_sigma_rad;
    for (const PatchToPlace& patch : task_.patches) {
      for (std::size_t k = 0; k < patch.cells.size(); ++k) {
        if (!cells_.try_emplace(patch.cells[k], CellAt{problem_.patches.size(), k}).second) {
          throw InvalidArgument(message("cell {} is there twice", patch.cells[k]));
        }
      }
      problem_.patches.push_back(fitPatchOf(patch, kMinRadius_m));
    }
  }

  void takePoints() {
    for (const KnownPoint& point : task_.points) {
      const CellAt at = indexOf(cells_, point.cell);
      requirePlaceable(point);
      problem_.points.push_back({at.patch, at.cell, point.x_l, point.sigma_m});
    }
  }

  void takeDistances() {
    for (const KnownDistance& distance : task_.distances) {
      const CellAt a = indexOf(cells_, distance.a);
      const CellAt b = indexOf(cells_, distance.b);
      if (a.patch == b.patch) {
        throw InvalidArgument(message("cells {} and {} are of one patch: their distance says nothing of its place",
                                      distance.a, distance.b));
      }
      requirePlaceable(distance);
      problem_.distances.push_back({a.patch, a.cell, b.patch, b.cell, distance.distance_m, distance.sigma_m});
    }
  }

  [[nodiscard]] std::optional<Message> patchLargerThanLink() const {
    if (!feet_) return std::nullopt;
    for (std::size_t p = 0; p < problem_.patches.size(); ++p) {
      const double extent_m = extentOf(problem_.patches[p]);
      if (extent_m <= link_size_m_) continue;
      return message(
          "The patch of cell {} is larger than link {}: {} from cell to cell, where the link's box measures "
          "{} from corner to corner. It belongs on another link, or the mesh is not in metres.",
          task_.patches[p].origin, task_.link, Millimetres{extent_m, 0}, Millimetres{link_size_m_, 0});
    }
    return std::nullopt;
  }

  /// The search would begin at points that lie farther apart than the patch is long, and find no place but by chance.
  [[nodiscard]] std::optional<Message> linkTooLargeToSearch() const {
    constexpr double kShortestPatch_m = 0.1;
    if (!feet_) return std::nullopt;
    const double spacing_m = spacingOn(surface_, kSampleSpacing_m);
    for (std::size_t p = 0; p < problem_.patches.size(); ++p) {
      const bool begins_at_points =
          std::ranges::any_of(problem_.points, [&](const FitPoint& point) { return point.patch == p; });
      const double extent_m = extentOf(problem_.patches[p]);
      if (begins_at_points || spacing_m <= std::max(extent_m, kShortestPatch_m)) continue;
      return message(
          "Link {} is too large to look for the patch of cell {} all over it: {} m from corner to corner, where the "
          "patch measures {} from cell to cell. A URDF counts in metres: a mesh in millimetres needs "
          "scale=\"0.001 0.001 0.001\" there, with which the link would measure {}.",
          task_.link, task_.patches[p].origin, Number{link_size_m_, 1}, Millimetres{extent_m, 0},
          Millimetres{link_size_m_ / 1000, 0});
    }
    return std::nullopt;
  }

  /// The patches as they were put by hand, and those that nobody put anywhere at their best place. nullopt: none was
  /// put, or one has no place.
  [[nodiscard]] std::optional<FitState> start(const std::vector<FitSolution>& places) const {
    if (std::ranges::none_of(task_.patches, [](const PatchToPlace& patch) { return patch.start.has_value(); })) {
      return std::nullopt;
    }
    FitState state;
    for (std::size_t p = 0; p < task_.patches.size(); ++p) {
      const std::optional<SE3>& put = task_.patches[p].start;
      if (!put && places.empty()) return std::nullopt;
      state.push_back(put ? *put : places.front().state[p]);
    }
    return state;
  }

  /// The fit from where the patches were put is a candidate whatever it is worth: somebody put them there. It goes only
  /// where something holds them, so that what is open stays as it was decided by hand.
  void addStart(const std::vector<FitSolution>& places, PlaceResult& result) const {
    constexpr int kSteps = 40;
    constexpr double kSame_m = 0.0005;
    const std::optional<FitState> begun = start(places);
    if (!begun) return;
    const FitSolution put = refine(problem_, *begun, kSteps, Eigen::VectorXd::Zero(problem_.unknowns()));
    objectToTurn(*begun, put.state, result);
    for (std::size_t k = 0; k < places.size(); ++k) {
      if (distanceBetween(problem_, places[k].state, put.state) > kSame_m) continue;
      result.candidates[k].by_hand = true;
      return;
    }
    const FitLimit limit = limitOf(problem_, options_.false_alarm);
    const double best = places.empty() ? put.chi_squared : std::min(put.chi_squared, places.front().chi_squared);
    PlaceCandidate candidate = candidateOf(put, limit.absolute, limit.above(best));
    candidate.by_hand = true;
    const bool is_another = candidate.fits && std::ranges::none_of(places, [&](const FitSolution& place) {
                              return isWayBetween(problem_, place.state, put.state, options_.false_alarm);
                            });
    const auto after =
        std::ranges::upper_bound(result.candidates, candidate.chi_squared, {}, &PlaceCandidate::chi_squared);
    result.candidates.insert(after, std::move(candidate));
    // What is said stays that of the places that were found, unless this is one more.
    if (is_another) judge(result);
  }

  /// Says where patches were put against what gravity says.
  void objectToTurn(const FitState& begun, const FitState& fitted, PlaceResult& result) const {
    for (std::size_t p = 0; p < task_.patches.size(); ++p) {
      const PatchToPlace& patch = task_.patches[p];
      if (!patch.start || !patch.rotation) continue;
      const auto against = againstGravity(*patch.rotation, begun[p].R, kTurnByHand_rad);
      if (!against) continue;
      double sum_m2 = 0;
      for (const SE3& T_o_u : patch.T_o_u) sum_m2 += (begun[p] * T_o_u.t - fitted[p] * T_o_u.t).squaredNorm();
      result.remarks.push_back(
          message("Where the patch of cell {} was put by hand, it is turned by {} against what gravity says, which is "
                  "certain to {} (1 sigma); the fit moved it by {}.",
                  patch.origin, Degrees{against->angle_rad, 0}, Degrees{against->sigma_rad},
                  Millimetres{std::sqrt(sum_m2 / static_cast<double>(patch.T_o_u.size())), 0}));
    }
  }

  [[nodiscard]] PlaceCandidate candidateOf(const FitSolution& place, double most_absolute, double most) const {
    PlaceCandidate candidate;
    const FitEquations equations = equationsAt(problem_, place.state);
    candidate.chi_squared = place.chi_squared;
    candidate.freedom = freedomOf(problem_);
    candidate.probability = boost::math::cdf(
        boost::math::complement(boost::math::chi_squared(candidate.freedom), std::max(0.0, place.chi_squared)));
    candidate.rms_m = rmsOf(equations);
    candidate.fits = place.chi_squared <= most_absolute;
    FitExtent extent = noExtent(problem_);
    for (std::size_t p = 0; p < problem_.patches.size(); ++p) {
      PlacedPatch& placed = candidate.patches.emplace_back();
      if (!candidate.fits) continue;
      placed.free = freeDirections(problem_, place, equations, p, options_.free_m, most, extent);
    }
    for (std::size_t p = 0; p < problem_.patches.size(); ++p) {
      const PatchToPlace& given = task_.patches[p];
      PlacedPatch& placed = candidate.patches[p];
      placed.place = {given.origin, task_.link, place.state[p], std::nullopt};
      placed.cells = cellsOnLink(problem_, place.state, equations, extent, p);
      for (std::size_t k = 0; k < placed.cells.size(); ++k) placed.cells[k].cell = given.cells[k];
      placed.place.cov_t_r = placed.cells[problem_.patches[p].origin].cov_t_r;
    }
    return candidate;
  }

  // --- in words

  [[nodiscard]] Message patchesText() const {
    if (task_.patches.size() == 1) return message("The patch of cell {}", task_.patches.front().origin);
    std::vector<CellId> origins;
    for (const PatchToPlace& patch : task_.patches) origins.push_back(patch.origin);
    return message("The patches of cells {}", origins);
  }

  void judge(PlaceResult& result) const {
    if (result.candidates.empty()) {
      result.verdict = PlaceVerdict::NoneFits;
      result.summary = message(
          "{}: nowhere on link {} does the surface face as it would have to. Is it the right link, "
          "and is the rotation right?",
          patchesText(), task_.link);
      return;
    }
    const PlaceCandidate& best = result.candidates.front();
    if (!best.fits) {
      result.verdict = PlaceVerdict::NoneFits;
      result.summary = message(
          "{}: no place on link {} fits. At the best one the misfit is {} rms, chi-squared {} with "
          "{} degrees of freedom. Is it the right link, are all lengths in metres, and do the "
          "cells lie on the surface that the mesh describes?",
          patchesText(), task_.link, Millimetres{best.rms_m, 1}, Number{best.chi_squared, 0}, best.freedom);
      return;
    }
    if (result.candidates.size() > 1) {
      result.verdict = PlaceVerdict::Several;
      result.summary =
          message("{}: {} places on link {} fit. A point whose place on the link is known would tell them apart.",
                  patchesText(), result.candidates.size(), task_.link);
      return;
    }
    std::vector<Message> sentences;
    double worst_m = 0;
    bool is_free = false;
    for (const PlacedPatch& patch : best.patches) {
      for (const CellOnLink& cell : patch.cells) {
        worst_m = std::max(worst_m, kSigmasFor95Percent * largestDeviation(cell.cov_t_r.topLeftCorner<3, 3>()));
      }
      for (const FreeDirection& free : patch.free) is_free = is_free || !free.held_by_rotation;
    }
    if (!is_free) {
      result.verdict = PlaceVerdict::Placed;
      result.summary = message("{}: one place on link {} fits, certain to {} (95 %, the worst cell).", patchesText(),
                               task_.link, Millimetres{worst_m, 1});
      return;
    }
    result.verdict = PlaceVerdict::Open;
    sentences.push_back(
        message("{}: one place on link {} fits, but not all of it is determined.", patchesText(), task_.link));
    for (const PlacedPatch& patch : best.patches) {
      for (const FreeDirection& free : patch.free) {
        if (free.held_by_rotation) continue;
        sentences.push_back(best.patches.size() == 1 ? free.words
                                                     : message("Cell {}'s patch: {}", patch.place.origin, free.words));
      }
    }
    result.summary = inRow(std::move(sentences));
  }

  const PlaceTask& task_;
  const PlaceOptions& options_;
  TriangleMesh surface_;
  std::optional<MeshFeet> feet_;
  double link_size_m_ = 1;
  std::map<CellId, CellAt> cells_;
  FitProblem problem_;
  std::vector<Message> remarks_;
};

/// Indices of cells all over a patch, ascending, the origin among them.
std::vector<std::size_t> chosenCells(const PatchReconstruction& patch) {
  std::size_t origin = 0;
  while (origin + 1 < patch.cells.size() && patch.cells[origin].cell != patch.origin) ++origin;
  if (patch.cells.empty()) return {};
  std::vector<std::size_t> chosen = farthestFirst(
      patch.cells.size(), kMaxPlacedCells, origin,
      [&](std::size_t a, std::size_t b) { return (patch.cells[a].T_o_u.t - patch.cells[b].T_o_u.t).norm(); });
  std::ranges::sort(chosen);
  return chosen;
}

/// Of all cells together from the solver's factor, else of each by itself.
Eigen::MatrixXd covarianceOf(const PatchReconstruction& patch, const std::vector<std::size_t>& cells, bool& assumed) {
  constexpr double kPosition_m = 0.002;
  constexpr double kAttitude_rad = 3 * kDegree;
  const auto row = [](std::size_t k) { return static_cast<Eigen::Index>(6 * k); };
  Eigen::MatrixXd C = Eigen::MatrixXd::Zero(row(cells.size()), row(cells.size()));
  assumed = false;
  for (std::size_t i = 0; i < cells.size(); ++i) {
    const CellPlacement& cell = patch.cells[cells[i]];
    if (patch.covariance != nullptr) {
      for (std::size_t j = 0; j <= i; ++j) {
        const Matrix6d between = patch.covariance->together(cell.cell, patch.cells[cells[j]].cell);
        C.block<6, 6>(row(i), row(j)) = between;
        C.block<6, 6>(row(j), row(i)) = between.transpose();
      }
    } else if (cell.shape_cov_t_r) {
      C.block<6, 6>(row(i), row(i)) = *cell.shape_cov_t_r;
    } else if (cell.cov_t_r) {
      C.block<6, 6>(row(i), row(i)) = *cell.cov_t_r;
    } else {
      assumed = true;
      C.diagonal().segment<3>(row(i)).setConstant(kPosition_m * kPosition_m);
      C.diagonal().segment<3>(row(i) + 3).setConstant(kAttitude_rad * kAttitude_rad);
    }
  }
  return 0.5 * (C + C.transpose());
}

}  // namespace

void requirePlaceable(const KnownPoint& point) {
  for (const double coordinate : point.x_l) {
    requireLength(coordinate, -kMaxPlaceLength_m, message("each coordinate of the point of cell {}", point.cell));
  }
  requireLength(point.sigma_m, kMinPlaceSigma_m, message("the sigma of the point of cell {}", point.cell));
}

void requirePlaceable(const KnownDistance& distance) {
  requireLength(distance.distance_m, kMinPlaceSigma_m,
                message("the distance between cells {} and {}", distance.a, distance.b));
  requireLength(distance.sigma_m, kMinPlaceSigma_m,
                message("the sigma of the distance between cells {} and {}", distance.a, distance.b));
}

PlaceOptions::PlaceOptions() : normal_sigma_rad(3 * kDegree) {}

void PlaceOptions::validate() const {
  constexpr double kMinNormalSigma_rad = 1e-3 * kDegree;
  constexpr double kMaxNormalSigma_rad = 2 * kPi;
  requireLength(surface_sigma_m, kMinPlaceSigma_m, message("the sigma of the surface"));
  if (!(normal_sigma_rad >= kMinNormalSigma_rad && normal_sigma_rad <= kMaxNormalSigma_rad)) {
    throw InvalidArgument(message("the sigma of the normals must be from {} to {}, found {}°",
                                  Degrees{kMinNormalSigma_rad, 3}, Degrees{kMaxNormalSigma_rad, 0},
                                  Number{toDegrees(normal_sigma_rad)}));
  }
  requireLength(free_m, kMinPlaceSigma_m, message("the length beyond which a direction is free"));
  requireLength(gap_m, 0, message("the gap"));
  if (!(false_alarm > 0 && false_alarm < 1)) {
    throw InvalidArgument(message("the probability of a false alarm must be between 0 and 1"));
  }
  if (most_candidates == 0) throw InvalidArgument(message("there must be room for at least one candidate"));
}

std::string_view placeVerdictName(PlaceVerdict verdict) {
  constexpr EnumNames<PlaceVerdict> kNames = {{"placed", "open", "several", "none_fits", "too_large"}};
  return kNames.of(verdict);
}

PatchToPlace patchToPlace(const PatchReconstruction& patch) {
  PatchToPlace result;
  result.origin = patch.origin;
  const std::vector<std::size_t> chosen = chosenCells(patch);
  for (const std::size_t k : chosen) {
    result.cells.push_back(patch.cells[k].cell);
    result.T_o_u.push_back(patch.cells[k].T_o_u);
  }
  const Eigen::MatrixXd C = covarianceOf(patch, chosen, result.covariance_assumed);
  result.covariance.assign(C.data(), C.data() + C.size());  // symmetric: rows are columns
  return result;
}

PlaceResult placePatches(const PlaceTask& task, const PlaceOptions& options) {
  return Placement(task, options).place();
}

}  // namespace hexoderm
