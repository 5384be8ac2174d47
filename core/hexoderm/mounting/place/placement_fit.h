#pragma once

// The least squares of a placement.

#include "hexoderm/base/mesh_feet.h"
#include "hexoderm/base/se3.h"
#include "hexoderm/mounting/place/place.h"

#include <Eigen/Cholesky>
#include <Eigen/Core>
#include <optional>
#include <vector>

namespace hexoderm {

/// A patch as the fit takes it.
struct FitPatch {
  std::vector<SE3> T_o_u;
  Eigen::MatrixXd C;       ///< 6 N x 6 N, as PatchToPlace::covariance
  std::size_t origin = 0;  ///< its index
  std::optional<KnownRotation> rotation;
  Eigen::Vector3d middle_o = Eigen::Vector3d::Zero();
  /// Of the cells about the middle, rms: what a turn by 1 rad moves them. Of a single cell half its width.
  double radius_m = 0;
};
struct FitPoint {
  std::size_t patch = 0;
  std::size_t cell = 0;
  Eigen::Vector3d x_l;
  double sigma_m = 0;
};
struct FitDistance {
  std::size_t patch_a = 0;
  std::size_t cell_a = 0;
  std::size_t patch_b = 0;
  std::size_t cell_b = 0;
  double distance_m = 0;
  double sigma_m = 0;
};

struct FitProblem {
  std::vector<FitPatch> patches;
  const MeshFeet* feet = nullptr;  ///< none: the surface is not used
  double back_m = 0;               ///< from a cell's front to the surface
  double surface_sigma_m = 0;
  double normal_sigma_rad = 0;
  std::vector<FitPoint> points;
  std::vector<FitDistance> distances;
  double link_size_m = 1;  ///< no place is less certain than this

  [[nodiscard]] Eigen::Index unknowns() const { return static_cast<Eigen::Index>(6 * patches.size()); }
};

/// Some cells of each patch, and those that points, distances and rotations are about.
FitProblem onlyCells(const FitProblem& problem, const std::vector<std::vector<std::size_t>>& cells);
/// Some patches, in this order, with what is known of them alone.
FitProblem onlyPatches(const FitProblem& problem, const std::vector<std::size_t>& patches);

/// T_l_o of every patch, but for the errors of the patch's own shape.
using FitState = std::vector<SE3>;

/// Six unknowns a patch: a shift of its middle (m, link frame), then a turn about it (rad, link frame) times the
/// patch's radius, so that all are metres by which the cells move.
FitState moved(const FitProblem& problem, const FitState& state, const Eigen::VectorXd& step_m);
/// The step from one state to another, to first order in the turn's path: a straight shift and one turn.
Eigen::VectorXd stepBetween(const FitProblem& problem, const FitState& from, const FitState& to);
/// A share of the way from one state to another, on a screw for each patch; beyond 1 the screw goes on.
FitState wayFrom(const FitState& from, const FitState& to, double share);
/// Rms motion of the cells of all patches.
double distanceBetween(const FitProblem& problem, const FitState& a, const FitState& b);

/// The equations about a state: r + J step + H d = noise, with the errors d of the patches' shapes.
struct FitEquations {
  enum class Kind { Surface, Normal, Point, Distance, Rotation };
  Eigen::VectorXd r;
  Eigen::MatrixXd J;
  Eigen::MatrixXd HC;  ///< covariance of H d with the errors of all patches' cells
  Eigen::MatrixXd S;   ///< of H d + noise
  std::vector<Kind> kind;
};
FitEquations equationsAt(const FitProblem& problem, const FitState& state);

struct FitSolution {
  FitState state;
  double chi_squared = 0;
};
/// Levenberg and Marquardt's method from `start`, at most so many steps. `along` (unit, in the unknowns), where it is
/// not empty: no step goes along it, nor where chi-squared changes by less than 1 over 10 mm.
FitSolution refine(const FitProblem& problem, const FitState& start, int steps, const Eigen::VectorXd& along = {});

/// What is known of the unknowns beside the equations about one place: from how far one can go from it.
struct FitExtent {
  Eigen::MatrixXd information;  ///< where it ends sooner than the equations say
  Eigen::MatrixXd covariance;   ///< where it goes on farther
};
FitExtent noExtent(const FitProblem& problem);

/// Covariance of the unknowns at a solution; what nothing determines is as uncertain as the link is large, or half a
/// turn. `with_rotation` false: as if nothing were known of the rotations.
Eigen::MatrixXd covarianceAt(const FitProblem& problem, const FitEquations& equations, bool with_rotation = true);

/// Cells in the link's frame with covariances of shape and place together.
std::vector<CellOnLink> cellsOnLink(const FitProblem& problem, const FitState& state, const FitEquations& equations,
                                    const FitExtent& extent, std::size_t patch);

/// How badly a state fits, for choosing where to begin.
double roughMisfit(const FitProblem& problem, const FitState& state);

/// Rms of the residuals that are lengths.
double rmsOf(const FitEquations& equations);

}  // namespace hexoderm
