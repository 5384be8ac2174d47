#pragma once

#include "hexoderm/base/surface_fit.h"
#include "hexoderm/solve/result/reconstruction.h"

#include <memory>
#include <optional>
#include <utility>
#include <vector>

namespace hexoderm {

/// A surface that can be fitted to a patch.
enum class SurfaceKind { Plane, Sphere, Cylinder, Cone };
/// Throws InvalidArgument listing the kinds there are.
SurfaceKind surfaceKindFromName(std::string_view name);
std::string_view surfaceKindName(SurfaceKind kind);  ///< the surface's name, in files and on the command line

/// A surface through the centres of a patch's cells, in the patch frame, with the paper's metrics where the true radius
/// is known: Delta = r_est - r_real, eq. (20); epsilon = sqrt(1/U sum (d_u + Delta)^2), eq. (21).
struct SurfaceEvaluation {
  SurfaceKind kind{};
  PatchId patch;
  Eigen::Vector3d point = Eigen::Vector3d::Zero();  ///< on plane or axis; the sphere's centre
  Eigen::Vector3d axis = Eigen::Vector3d::UnitZ();  ///< the plane's normal; unused for the sphere
  std::optional<double> radius_m;                   ///< none for the plane; the cone's at `point`
  std::optional<double> half_angle_rad;             ///< the cone's, which widens along `axis`
  std::vector<CellId> cells;
  std::vector<double> distance_m;  ///< signed, per cell
  double rms_m = 0;
  /// Per cell, 0 to pi / 2: between the normal of its face and that of the surface, whichever way they point.
  std::vector<double> tilt_rad;
  double tilt_rms_rad = 0;
  /// Mean of the squared distances and tilts (one and two a cell) over their stated variances: above 1 the cells
  /// contradict the surface. Errors of neighbours go together, so it is no chi-square.
  double misfit = 0;
  /// Bayesian information criterion: the sum of those squares, and what the surface's parameters cost. The least of
  /// those of one patch is the most probable.
  double bic = 0;
  /// The most probable kind, where the cells contradict this one and are decisively better explained by that
  /// (checkSurface()); null: they are not, or nothing is stated that could tell.
  std::shared_ptr<const SurfaceEvaluation> better;
  std::optional<double> delta_m;
  std::optional<double> epsilon_m;

  /// The surface's unit normal at a place near it, to the side where distances are positive.
  [[nodiscard]] Eigen::Vector3d normalAt(const Eigen::Vector3d& place) const;
  /// Index in `cells` of the cell that is furthest from the surface; there must be one.
  [[nodiscard]] std::size_t furthest() const;
  /// No cell is further from the surface than positions are stated to err (95 %, the worst cell's).
  [[nodiscard]] bool liesWithin(double position_95_m) const;
};

/// Throws InvalidArgument if the patch has too few cells for the fit, or `true_radius_m` is given for a plane or a
/// cone, which have no one radius, or is not above 0 and within kMaxLength_m.
SurfaceEvaluation evaluateSurface(const PatchReconstruction& patch, SurfaceKind kind,
                                  std::optional<double> true_radius_m = std::nullopt);

/// evaluateSurface() with a look at the other kinds. Without a kind, the simplest one that the cells do not contradict
/// is taken, or else the most probable one. Where the cells face tells much more about a small patch's surface than
/// where they lie, which a sphere can follow almost as well as a cylinder. Throws as evaluateSurface(); without a kind,
/// if the patch has too few cells for any.
SurfaceEvaluation checkSurface(const PatchReconstruction& patch, std::optional<SurfaceKind> kind,
                               std::optional<double> true_radius_m = std::nullopt);

/// The gap between the link points of two ports (paper, Fig. 9).
struct LoopEvaluation {
  LinkEnd first;
  LinkEnd second;
  Eigen::Vector3d gap_m = Eigen::Vector3d::Zero();  ///< first link point minus second, patch frame
  double length_m = 0;
  double loop_length_m = 0;  ///< accumulated length of the port vectors along the chain, both ends included
  double percent = 0;        ///< percentage of the loop's length
};

/// Throws InvalidArgument if a cell or port does not exist, the ports are joined to something, or the cells lie in
/// different patches.
LoopEvaluation evaluateLoop(const Reconstruction& reconstruction, LinkEnd first, LinkEnd second);

/// The way from one cell to another.
struct CellDistance {
  double length_m = 0;   ///< between the centres of the front faces
  double angle_rad = 0;  ///< between the faces' normals, 0 to pi
  /// Standard deviation of the length, if the result holds the covariance of any two cells (a fresh one does).
  std::optional<double> sigma_m;
};
/// None if a cell is missing, or if the two are in different patches, whose relative placement is not known.
std::optional<CellDistance> distanceBetween(const Reconstruction& reconstruction, CellId a, CellId b);

/// How an estimated distance and a measured one go together.
enum class DistanceAgreement {
  NotStated,   ///< no uncertainty is stated that they could be compared by
  AsStated,    ///< within 95 %
  Doubtful,    ///< measure again
  Contradicts  ///< by more than four standard deviations
};

/// A distance between the centres of two cells' front faces that somebody measured on the skin, beside the estimate. It
/// tells what gravity and ports can't: a wrong size of the cells, and most wrong shapes.
struct DistanceCheck {
  CellId first;
  CellId second;
  double measured_m = 0;
  double estimated_m = 0;
  std::optional<double> sigma_m;     ///< of their difference; the estimate's own where it is not exactly known: at most
  std::optional<double> deviations;  ///< measured less estimated, in standard deviations
  DistanceAgreement agreement = DistanceAgreement::NotStated;
  /// The relative error of the cells' size from which on this distance would contradict it.
  std::optional<double> detectable_scale;
};
/// 1 sigma of a distance measured by caliper: it is read more exactly, but where a cell's centre is, the eye tells.
inline constexpr double kCaliperSigma_m = 0.0005;
/// Throws InvalidArgument if there is no such cell, the two are one, or lie in different patches, or the distance is
/// not positive.
DistanceCheck checkDistance(const Reconstruction& reconstruction, CellId first, CellId second, double measured_m,
                            double measured_sigma_m = kCaliperSigma_m);
/// Two cells far apart, which say most about size and shape; none in a patch of one cell.
std::optional<std::pair<CellId, CellId>> farApart(const PatchReconstruction& patch);

/// Per-cell differences between two placements of the same cells, after alignment: positions after their best rigid
/// fit, orientations after the one rotation that fits all of them best (chordal mean of R_ref R_est^T).
struct CellDifference {
  CellId cell;
  Eigen::Vector3d position_m = Eigen::Vector3d::Zero();  ///< reference frame: reference - aligned estimate
  double orientation_rad = 0;
  std::optional<double> sigma_t_m;  ///< stated: root of the trace of the position covariance
  std::optional<double> sigma_r_rad;
};
/// A cell, compared with where it is elsewhere.
struct Comparison {
  PatchId patch;
  SE3 T_ref_o;  ///< the positions' best fit
  std::vector<CellDifference> cells;
  double position_rms_m = 0;
  double orientation_rms_rad = 0;
};

/// Number of cells that lie within their stated 95 % uncertainty. A difference counts as within if it is not longer
/// than 1.96 times the root of its covariance's trace: at least 95 % of a normal error are, whatever its shape.
struct WithinStated {
  std::size_t stated = 0;  ///< cells that state an uncertainty; the origin, which is exact by definition, does not
  std::size_t position = 0;
  std::size_t orientation = 0;

  /// Whether at least 95 % of them, rounded down to a whole number, are within their stated bounds.
  [[nodiscard]] bool holds() const;
};
bool isWithinStated(double difference, std::optional<double> sigma);  ///< false where nothing is stated
/// The number of cells whose errors lie within what is stated.
WithinStated countWithinStated(const std::vector<Comparison>& comparisons);

/// All cells of several comparisons together; none: zeros. A patch that shares a single cell with the reference fits it
/// wherever that is, which tells nothing: left out.
struct ComparisonSummary {
  std::size_t cells = 0;
  double position_rms_m = 0;
  double orientation_rms_rad = 0;
  WithinStated within;
};
/// Means and largest values of all cells.
ComparisonSummary summariseComparisons(const std::vector<Comparison>& comparisons);

/// Beyond three times what it is expected to be, or is on the whole: worth a look.
bool isRemarkable(double error, double expected);

/// One comparison for each patch that shares a cell with the reference.
std::vector<Comparison> compareToTruth(const Reconstruction& reconstruction, const GroundTruth& truth);
/// Cell by cell, of patches that both have.
std::vector<Comparison> compareToReconstruction(const Reconstruction& reconstruction, const Reconstruction& reference);

}  // namespace hexoderm
