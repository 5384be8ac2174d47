#pragma once

#include "hexoderm/base/ids.h"
#include "hexoderm/base/se3.h"

#include <cstddef>
#include <memory>
#include <optional>

namespace hexoderm {

struct CellPlacement;

/// Relative covariance of any two cells of a patch. Holds the factor of the information matrix, so it exists for a
/// fresh joint reconstruction only, not for one read from a file.
class PlacementCovariance {
 public:
  virtual ~PlacementCovariance() = default;

  /// Covariance of T_a_b, the placement of b in a's frame: order position (m, frame of a) then rotation (rad,
  /// right-multiplied error in the frame of b). Costs a few triangular solves with the sparse factor. Zero for a = b.
  /// Throws InvalidArgument if a cell is not in the patch.
  [[nodiscard]] virtual Matrix6d relative(CellId a, CellId b) const = 0;
  /// Covariance between the errors of two cells as CellPlacement::cov_t_r states them of each: relative to the origin,
  /// whose own are zero; rows a, columns b. Costs and throws as relative().
  [[nodiscard]] virtual Matrix6d together(CellId a, CellId b) const = 0;
};

/// How far off a patch's directions of gravity may be, and how the errors of its poses hang together: the sensors'
/// offsets are the same in all poses, and so is the attitude of the origin, in whose frame all of them are stated.
/// Poses are indices of PatchReconstruction::gravity. Comes with the solver's factor, so it exists for a fresh joint
/// reconstruction only, not for one read from a file.
class GravityCovariance {
 public:
  virtual ~GravityCovariance() = default;

  /// Cross-covariance of the specific forces at the patch's middle (about 1 g, along GravityDirection::g_o) in two
  /// poses, patch frame, g^2; rows a, columns b.
  [[nodiscard]] virtual Eigen::Matrix3d forces(std::size_t a, std::size_t b) const = 0;
  /// Covariance of GravityDirection::Force::swing_o, (g/m)^2; absent where swings are not estimated.
  [[nodiscard]] virtual std::optional<Eigen::Matrix3d> swing(std::size_t pose) const = 0;
  /// As if nothing but the sensors' own noise had disturbed the readings: forces() grants each of them a hand's tremor,
  /// which is not there on a robot that holds still. Null where that is not known. The first call costs about as much
  /// as a step of the solver with its covariance.
  [[nodiscard]] virtual std::shared_ptr<const GravityCovariance> withoutTremor() const { return nullptr; }
};

/// The uncertainty of a cell's placement relative to its origin, as the verdict states it: 1.96 standard deviations
/// (95 %) along the worst axis. The orientation's is at most pi.
struct Uncertainty95 {
  double position_m = 0;
  double orientation_rad = 0;
};

/// Standard deviation of an orientation about its worst axis, rad, from the covariance of its error, rad^2. At most pi:
/// nothing can be turned further.
double rotationSigma(const Eigen::Matrix3d& covariance);

/// By a covariance as in CellPlacement::cov_t_r.
Uncertainty95 uncertaintyBy(const Matrix6d& cov_t_r);

/// Absent where no covariance is stated; zero for the origin.
std::optional<Uncertainty95> uncertaintyOf(const CellPlacement& cell);

/// The same of the cell's place in the shape, relative to the patch as a whole (CellPlacement::shape_cov_t_r). Absent
/// where it is not stated.
std::optional<Uncertainty95> shapeUncertaintyOf(const CellPlacement& cell);

}  // namespace hexoderm
