#include "hexoderm/solve/checks/evaluation.h"

#include "hexoderm/base/covariance.h"
#include "hexoderm/base/enum_names.h"
#include "hexoderm/base/error.h"
#include "hexoderm/base/limits.h"
#include "hexoderm/base/procrustes.h"
#include "hexoderm/base/units.h"
#include "hexoderm/solve/result/result_graph.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <unordered_map>

namespace hexoderm {
namespace {

/// How cells lie on a surface that is the right one, 1 sigma: centres this far from it, faces tilted by so much about
/// each axis. What mould and glue leave, and that flat cells are not bent.
constexpr double kCellHeight_m = 0.5 * kMillimetre;
constexpr double kCellTilt_rad = 1 * kDegree;
/// The shape of a patch seen from two directions of gravity only errs as a whole; 10 of 450 simulated ones then
/// contradicted their own kind of surface, and none of 1,350 with three to eight.
constexpr std::size_t kFewestDirections = 3;
/// "Very strong evidence" in Kass and Raftery, Bayes Factors, J. Am. Stat. Assoc. 90 (1995).
constexpr double kDecisive = 10;

struct FittedKind {
  SurfaceKind kind;
  double parameters;
  SurfaceFit (*fit)(std::span<const Eigen::Vector3d> points_m);
};
/// The simplest first.
constexpr std::array<FittedKind, 4> kKinds = {{{SurfaceKind::Plane, 3, fitPlane},
                                               {SurfaceKind::Sphere, 4, fitSphere},
                                               {SurfaceKind::Cylinder, 5, fitCylinder},
                                               {SurfaceKind::Cone, 6, fitCone}}};
static_assert(kKinds.size() == enumeratorCount<SurfaceKind>());

const FittedKind& fittedKind(SurfaceKind kind) { return *std::ranges::find(kKinds, kind, &FittedKind::kind); }

/// Fills in tilts and BIC.
void judge(const PatchReconstruction& patch, SurfaceEvaluation& surface) {
  double squares = 0;
  for (std::size_t k = 0; k < patch.cells.size(); ++k) {
    const CellPlacement& cell = patch.cells[k];
    const Eigen::Vector3d normal = surface.normalAt(cell.T_o_u.t);
    const double angle = angleBetween(normal, cell.T_o_u.R.col(2));
    const double tilt = std::min(angle, kPi - angle);
    surface.tilt_rad.push_back(tilt);
    double height_var = kCellHeight_m * kCellHeight_m;
    double tilt_var = kCellTilt_rad * kCellTilt_rad;
    if (cell.cov_t_r) {
      height_var += std::max(0.0, normal.dot(cell.cov_t_r->topLeftCorner<3, 3>() * normal));
      tilt_var += std::max(0.0, ((*cell.cov_t_r)(3, 3) + (*cell.cov_t_r)(4, 4)) / 2);
    }
    squares += surface.distance_m[k] * surface.distance_m[k] / height_var + tilt * tilt / tilt_var;
  }
  surface.tilt_rms_rad = rms(surface.tilt_rad);
  // A height and two tilts per cell.
  const auto observations = static_cast<double>(3 * patch.cells.size());
  surface.misfit = squares / observations;
  surface.bic = squares + fittedKind(surface.kind).parameters * std::log(observations);
}

/// Whether what is stated of the patch can contradict a surface.
bool canContradict(const PatchReconstruction& patch) {
  return patch.gravity.size() >= kFewestDirections &&
         std::ranges::any_of(patch.cells, [](const CellPlacement& cell) { return cell.cov_t_r.has_value(); });
}

constexpr EnumNames<SurfaceKind> kSurfaceNames = {{"plane", "sphere", "cylinder", "cone"}};

/// A caliper that is this many standard deviations off is not a matter of chance.
constexpr double kContradictingSigmas = 4;

/// Upper bound of a distance's standard deviation, from what is stated for the two cells each: how their errors go
/// together is not. None where nothing is stated.
std::optional<double> largestDistanceSigma(const CellPlacement& a, const CellPlacement& b) {
  if (!a.cov_t_r || !b.cov_t_r) return std::nullopt;
  const Eigen::Vector3d along = (b.T_o_u.t - a.T_o_u.t).normalized();
  const auto sigma = [&](const CellPlacement& cell) {
    return std::sqrt(std::max(0.0, along.dot(cell.cov_t_r->topLeftCorner<3, 3>() * along)));
  };
  return sigma(a) + sigma(b);
}

struct ReferenceCell {
  SE3 T_ref_u;
  const CellPlacement* stated = nullptr;  ///< the cell in the reference, if that is a reconstruction
};
using ReferenceCells = std::unordered_map<CellId, ReferenceCell>;

std::optional<double> rootTrace(const CellPlacement& cell, bool rotation) {
  if (!cell.cov_t_r) return std::nullopt;
  const Eigen::Matrix3d block =
      rotation ? cell.cov_t_r->bottomRightCorner<3, 3>() : cell.cov_t_r->topLeftCorner<3, 3>();
  return std::sqrt(std::max(0.0, block.trace()));
}

/// Two measurements of one thing: their stated deviations add in squares.
std::optional<double> combined(std::optional<double> a, std::optional<double> b) {
  return a && b ? std::optional(std::hypot(*a, *b)) : a ? a : b;
}

Comparison compare(const PatchReconstruction& patch, const ReferenceCells& reference) {
  Comparison comparison;
  comparison.patch = patch.id;
  std::vector<Eigen::Vector3d> expected;
  std::vector<Eigen::Vector3d> estimated;
  std::vector<Eigen::Matrix3d> turns;
  std::vector<const CellPlacement*> shared;
  for (const CellPlacement& cell : patch.cells) {
    const auto found = reference.find(cell.cell);
    if (found == reference.end()) continue;
    shared.push_back(&cell);
    expected.push_back(found->second.T_ref_u.t);
    estimated.push_back(cell.T_o_u.t);
    turns.emplace_back(found->second.T_ref_u.R * cell.T_o_u.R.transpose());
  }
  if (shared.empty()) return comparison;
  comparison.T_ref_o = alignPoints(expected, estimated);
  const Eigen::Matrix3d turn = chordalMean(turns);
  double position_sum = 0;
  double orientation_sum = 0;
  for (std::size_t k = 0; k < shared.size(); ++k) {
    CellDifference difference;
    difference.cell = shared[k]->cell;
    difference.position_m = expected[k] - comparison.T_ref_o * estimated[k];
    difference.orientation_rad = rotationAngle(turn.transpose() * turns[k]);
    difference.sigma_t_m = rootTrace(*shared[k], false);
    difference.sigma_r_rad = rootTrace(*shared[k], true);
    if (const CellPlacement* stated = reference.at(difference.cell).stated) {
      difference.sigma_t_m = combined(difference.sigma_t_m, rootTrace(*stated, false));
      difference.sigma_r_rad = combined(difference.sigma_r_rad, rootTrace(*stated, true));
    }
    position_sum += difference.position_m.squaredNorm();
    orientation_sum += difference.orientation_rad * difference.orientation_rad;
    comparison.cells.push_back(difference);
  }
  comparison.position_rms_m = std::sqrt(position_sum / static_cast<double>(shared.size()));
  comparison.orientation_rms_rad = std::sqrt(orientation_sum / static_cast<double>(shared.size()));
  return comparison;
}

std::vector<Comparison> compareAll(const Reconstruction& reconstruction, const ReferenceCells& reference) {
  std::vector<Comparison> comparisons;
  for (const PatchReconstruction& patch : reconstruction.patches) {
    Comparison comparison = compare(patch, reference);
    if (!comparison.cells.empty()) comparisons.push_back(std::move(comparison));
  }
  return comparisons;
}

}  // namespace

SurfaceKind surfaceKindFromName(std::string_view name) {
  if (const auto kind = kSurfaceNames.find(name)) return *kind;
  throw InvalidArgument(message("surface: expected plane, sphere, cylinder or cone, found \"{}\"", name));
}

std::string_view surfaceKindName(SurfaceKind kind) { return kSurfaceNames.of(kind); }

SurfaceEvaluation evaluateSurface(const PatchReconstruction& patch, SurfaceKind kind,
                                  std::optional<double> true_radius_m) {
  if ((kind == SurfaceKind::Plane || kind == SurfaceKind::Cone) && true_radius_m) {
    throw InvalidArgument(message("a {} has no one radius to compare with", surfaceKindName(kind)));
  }
  if (true_radius_m && !(*true_radius_m > 0 && *true_radius_m <= kMaxLength_m)) {
    throw InvalidArgument(message("true radius: expected metres above 0 and at most {}, found {}",
                                  Number{kMaxLength_m, 0}, Number{*true_radius_m}));
  }
  SurfaceEvaluation evaluation;
  evaluation.kind = kind;
  evaluation.patch = patch.id;
  std::vector<Eigen::Vector3d> points;
  for (const CellPlacement& cell : patch.cells) {
    evaluation.cells.push_back(cell.cell);
    points.push_back(cell.T_o_u.t);
  }
  SurfaceFit fit = fittedKind(kind).fit(points);
  evaluation.point = fit.point;
  evaluation.axis = fit.axis;
  if (kind != SurfaceKind::Plane) evaluation.radius_m = fit.radius_m;
  if (kind == SurfaceKind::Cone) evaluation.half_angle_rad = fit.half_angle_rad;
  evaluation.distance_m = std::move(fit.distance_m);
  evaluation.rms_m = rms(evaluation.distance_m);
  judge(patch, evaluation);
  if (true_radius_m) {
    evaluation.delta_m = *evaluation.radius_m - *true_radius_m;
    std::vector<double> from_true_surface;
    for (const double distance : evaluation.distance_m) from_true_surface.push_back(distance + *evaluation.delta_m);
    evaluation.epsilon_m = rms(from_true_surface);
  }
  return evaluation;
}

SurfaceEvaluation checkSurface(const PatchReconstruction& patch, std::optional<SurfaceKind> kind,
                               std::optional<double> true_radius_m) {
  std::shared_ptr<const SurfaceEvaluation> probable;
  std::optional<SurfaceKind> simplest;
  std::optional<InvalidArgument> why_none;
  for (const FittedKind& other : kKinds) {
    try {
      SurfaceEvaluation surface = evaluateSurface(patch, other.kind);
      if (!simplest && surface.misfit <= 1) simplest = other.kind;
      if (!probable || surface.bic < probable->bic) {
        probable = std::make_shared<const SurfaceEvaluation>(std::move(surface));
      }
    } catch (const InvalidArgument& error) {
      // Too few cells, or cells in a plane: then it is another kind.
      why_none = error;
    }
  }
  if (!kind && !probable) throw InvalidArgument(why_none->message());
  const SurfaceKind chosen = kind ? *kind : simplest.value_or(probable->kind);
  const bool has_radius = chosen == SurfaceKind::Sphere || chosen == SurfaceKind::Cylinder;
  SurfaceEvaluation surface = evaluateSurface(patch, chosen, kind || has_radius ? true_radius_m : std::nullopt);
  const bool is_contradicted = surface.misfit > 1 && canContradict(patch);
  if (is_contradicted && probable && surface.bic - probable->bic > kDecisive) surface.better = probable;
  return surface;
}

LoopEvaluation evaluateLoop(const Reconstruction& reconstruction, LinkEnd first, LinkEnd second) {
  const auto located = [&](LinkEnd end) {
    const Reconstruction::Located found = reconstruction.find(end.cell);
    if (found.cell == nullptr) throw InvalidArgument(message("loop: there is no cell {}", end.cell));
    if (reconstruction.model->findPort(end.port) == nullptr) {
      throw InvalidArgument(message("loop: cell model {} has no port {}", reconstruction.model->name, end.port));
    }
    for (const LinkEstimate& link : found.patch->links) {
      if (link.used && (link.source == end || link.target == end)) {
        throw InvalidArgument(message("loop: {} is joined to a neighbour, expected a free port", inWords(end)));
      }
    }
    return found;
  };
  const Reconstruction::Located a = located(first);
  const Reconstruction::Located b = located(second);
  if (a.patch != b.patch) {
    throw InvalidArgument(message("loop: cells {} and {} lie in different patches", first.cell, second.cell));
  }
  if (first == second) throw InvalidArgument(message("loop: expected two different ports"));
  LoopEvaluation loop;
  loop.first = first;
  loop.second = second;
  loop.gap_m = a.cell->T_o_u * reconstruction.model->port(first.port).vector_m -
               b.cell->T_o_u * reconstruction.model->port(second.port).vector_m;
  loop.length_m = loop.gap_m.norm();
  const ResultGraph& graph = reconstruction.graph();
  const std::vector<ResultEdge> chain = ChainSearch(graph).between(*graph.find(first.cell), *graph.find(second.cell));
  if (!chain.empty() || first.cell == second.cell) {
    for (const ResultEdge& edge : chain) loop.loop_length_m += lengthAcross(*reconstruction.model, *edge.link);
    loop.loop_length_m += reconstruction.model->port(first.port).vector_m.norm() +
                          reconstruction.model->port(second.port).vector_m.norm();
  }
  loop.percent = loop.loop_length_m > 0 ? 100 * loop.length_m / loop.loop_length_m : 0;
  return loop;
}

std::optional<CellDistance> distanceBetween(const Reconstruction& reconstruction, CellId a, CellId b) {
  const Reconstruction::Located from = reconstruction.find(a);
  const Reconstruction::Located to = reconstruction.find(b);
  if (from.cell == nullptr || to.cell == nullptr || from.patch != to.patch) return std::nullopt;
  CellDistance distance;
  const SE3 T_a_b = from.cell->T_o_u.inverse() * to.cell->T_o_u;
  distance.length_m = T_a_b.t.norm();
  distance.angle_rad = angleBetween(Eigen::Vector3d::UnitZ(), T_a_b.R.col(2));
  if (from.patch->covariance && distance.length_m > 0) {
    const Eigen::Vector3d along = T_a_b.t / distance.length_m;
    const Eigen::Matrix3d cov = from.patch->covariance->relative(a, b).topLeftCorner<3, 3>();
    distance.sigma_m = std::sqrt(std::max(0.0, along.dot(cov * along)));
  }
  return distance;
}

DistanceCheck checkDistance(const Reconstruction& reconstruction, CellId first, CellId second, double measured_m,
                            double measured_sigma_m) {
  if (!(measured_m > 0 && std::isfinite(measured_m))) {
    throw InvalidArgument(message("measured distance: expected metres above 0"));
  }
  const Reconstruction::Located a = reconstruction.find(first);
  const Reconstruction::Located b = reconstruction.find(second);
  if (a.cell == nullptr) throw InvalidArgument(message("there is no cell {}", first));
  if (b.cell == nullptr) throw InvalidArgument(message("there is no cell {}", second));
  if (first == second) throw InvalidArgument(message("a distance is between two different cells"));
  if (a.patch != b.patch) {
    throw InvalidArgument(
        message("no link joins the patches of cells {} and {}: their distance is not known", first, second));
  }
  const CellDistance estimate = *distanceBetween(reconstruction, first, second);
  DistanceCheck check{first, second, measured_m, estimate.length_m, {}, {}, DistanceAgreement::NotStated, {}};
  const std::optional<double> sigma_m = estimate.sigma_m ? estimate.sigma_m : largestDistanceSigma(*a.cell, *b.cell);
  if (!sigma_m) return check;
  check.sigma_m = std::hypot(*sigma_m, measured_sigma_m);
  check.deviations = (measured_m - estimate.length_m) / *check.sigma_m;
  const double deviations = std::abs(*check.deviations);
  check.agreement = deviations <= kSigmasFor95Percent    ? DistanceAgreement::AsStated
                    : deviations <= kContradictingSigmas ? DistanceAgreement::Doubtful
                                                         : DistanceAgreement::Contradicts;
  check.detectable_scale = kContradictingSigmas * *check.sigma_m / measured_m;
  return check;
}

std::optional<std::pair<CellId, CellId>> farApart(const PatchReconstruction& patch) {
  if (patch.cells.size() < 2) return std::nullopt;
  const auto furthestFrom = [&](const CellPlacement& from) -> const CellPlacement& {
    return *std::ranges::max_element(
        patch.cells, {}, [&](const CellPlacement& cell) { return (cell.T_o_u.t - from.T_o_u.t).squaredNorm(); });
  };
  // Twice the furthest is nearly the longest way of all, and costs two looks at each cell.
  const CellPlacement& one = furthestFrom(patch.cells.front());
  const CellPlacement& other = furthestFrom(one);
  if (one.cell == other.cell) return std::nullopt;
  return std::pair(std::min(one.cell, other.cell), std::max(one.cell, other.cell));
}

Eigen::Vector3d SurfaceEvaluation::normalAt(const Eigen::Vector3d& place) const {
  if (kind == SurfaceKind::Plane) return axis;
  const Eigen::Vector3d from = place - point;
  if (kind == SurfaceKind::Sphere) return from.normalized();
  const Eigen::Vector3d radial = (from - axis * axis.dot(from)).normalized();
  if (kind == SurfaceKind::Cylinder) return radial;
  const double half_angle = half_angle_rad.value_or(0);
  return std::cos(half_angle) * radial - std::sin(half_angle) * axis;
}

std::size_t SurfaceEvaluation::furthest() const {
  const auto worst = std::ranges::max_element(distance_m, {}, [](double distance) { return std::abs(distance); });
  return static_cast<std::size_t>(worst - distance_m.begin());
}

bool SurfaceEvaluation::liesWithin(double position_95_m) const {
  return std::abs(distance_m.at(furthest())) <= position_95_m;
}

bool WithinStated::holds() const {
  // 19 of 20; what is left over of a small number is granted.
  const auto enough = [this](std::size_t count) { return 20 * count + 19 >= 19 * stated; };
  return stated > 0 && enough(position) && enough(orientation);
}

bool isWithinStated(double difference, std::optional<double> sigma) {
  return sigma && difference <= kSigmasFor95Percent * *sigma;
}

WithinStated countWithinStated(const std::vector<Comparison>& comparisons) {
  WithinStated count;
  for (const Comparison& comparison : comparisons) {
    for (const CellDifference& cell : comparison.cells) {
      if (!cell.sigma_t_m || !cell.sigma_r_rad || (*cell.sigma_t_m == 0 && *cell.sigma_r_rad == 0)) continue;
      ++count.stated;
      if (isWithinStated(cell.position_m.norm(), cell.sigma_t_m)) ++count.position;
      if (isWithinStated(cell.orientation_rad, cell.sigma_r_rad)) ++count.orientation;
    }
  }
  return count;
}

ComparisonSummary summariseComparisons(const std::vector<Comparison>& comparisons) {
  ComparisonSummary summary;
  std::vector<Comparison> telling;
  std::ranges::copy_if(comparisons, std::back_inserter(telling),
                       [](const Comparison& comparison) { return comparison.cells.size() > 1; });
  for (const Comparison& comparison : telling) {
    const auto count = static_cast<double>(comparison.cells.size());
    summary.cells += comparison.cells.size();
    summary.position_rms_m += count * comparison.position_rms_m * comparison.position_rms_m;
    summary.orientation_rms_rad += count * comparison.orientation_rms_rad * comparison.orientation_rms_rad;
  }
  if (summary.cells > 0) {
    summary.position_rms_m = std::sqrt(summary.position_rms_m / static_cast<double>(summary.cells));
    summary.orientation_rms_rad = std::sqrt(summary.orientation_rms_rad / static_cast<double>(summary.cells));
  }
  summary.within = countWithinStated(telling);
  return summary;
}

bool isRemarkable(double error, double expected) {
  constexpr double kTimes = 3;
  return std::abs(error) > kTimes * expected;
}

std::vector<Comparison> compareToTruth(const Reconstruction& reconstruction, const GroundTruth& truth) {
  ReferenceCells reference;
  for (const TrueCellPlacement& cell : truth.cells) reference.try_emplace(cell.id, ReferenceCell{cell.T_b_u, nullptr});
  return compareAll(reconstruction, reference);
}

std::vector<Comparison> compareToReconstruction(const Reconstruction& reconstruction, const Reconstruction& reference) {
  // Each patch of the reference has a frame of its own, so cells are compared patch by patch.
  std::vector<Comparison> comparisons;
  for (const PatchReconstruction& patch : reference.patches) {
    ReferenceCells cells;
    for (const CellPlacement& cell : patch.cells) cells.try_emplace(cell.cell, ReferenceCell{cell.T_o_u, &cell});
    for (Comparison& comparison : compareAll(reconstruction, cells)) comparisons.push_back(std::move(comparison));
  }
  return comparisons;
}

}  // namespace hexoderm
