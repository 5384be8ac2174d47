#pragma once

// How wrong a calibrated cell can be, and how a part moves while it is read. The hold-out
// and the check of a calibration share it.

#include "hexoderm/base/se3.h"
#include "hexoderm/base/units.h"
#include "hexoderm/skin/cell_model.h"
#include "hexoderm/solve/global/accelerometer_fit.h"

#include <Eigen/Core>
#include <span>

namespace hexoderm {

/// The unknowns of one cell: a small turn of its attitude (accelerometer axes), then per axis offset and gains.
inline constexpr int kCellUnknowns = 15;
using CellErrors = Eigen::Matrix<double, kCellUnknowns, kCellUnknowns>;  ///< information or covariance
using CellJacobian = Eigen::Matrix<double, 3, kCellUnknowns>;

/// Derivative of a reading gain v + offset of the specific force v by the unknowns.
CellJacobian readingJacobian(const Eigen::Matrix3d& gain, const Eigen::Vector3d& v);

/// Information of the links' elastomer about a cell's attitude, rad^-2, accelerometer axes. `ports`: where the cell has
/// links. A turn about an axis along which every neighbour lets the cell go is still not free: it is known to within a
/// turn.
Eigen::Matrix3d elastomerInformation(const CellModel& model, std::span<const PortNumber> ports);

/// What is known of a cell without its readings: information of the attitude, and the cell model's about its sensor.
CellErrors priorInformation(const AccelerometerPrior& sensor, const Eigen::Matrix3d& attitude);

/// One of the readings that a cell was placed by.
struct PlacingReading {
  Eigen::Vector3d v_g;     ///< specific force, accelerometer axes
  double variance_g2 = 0;  ///< as the solver weighed it, a tremor of its own granted to each reading
  double scatter_g2 = 0;   ///< of the sensor alone about the motion that all cells share
};

/// What became of the estimate of a cell's unknowns.
enum class CellEstimate {
  Joint,              ///< attitude and sensor, by the joint solver
  GlobalNoCrossAxis,  ///< the same, but the cross-axis sensitivities were dropped, as a calibration file does: 0 is
                      ///< left
  Tree,               ///< attitude only, by raw readings
};

/// Covariance of the errors of an estimate of a cell's unknowns by `readings`. The joint solver weighs readings as if
/// each had a hand's tremor to itself (GravityTable), and each scatters by its `scatter_g2` about the motion that all
/// cells share: with the solver's information A, its priors' L and the readings' N = A - L, the errors are
/// A^-1 (L + sum scatter N / variance) A^-1. An unknown x that was dropped errs by -x, which goes with the errors that
/// it left in the others. The tree turns the cell so that its raw readings fit and takes the sensor's errors for part
/// of gravity.
CellErrors errorsOfCell(const CellErrors& priors, std::span<const PlacingReading> readings, const Eigen::Matrix3d& gain,
                        CellEstimate estimate);

/// 1 sigma per axis, g/m, of the swing that is left when the other poses foretell one: the mean over 0.1 s of a
/// tremor of 0.05 degrees at 4 to 12 Hz is 0.6 rad/s^2, and what it did to the others comes on top.
inline constexpr double kAngularAccelerationSigma = 1 / kStandardGravity;

/// The motion that all cells share in a pose: the specific force at the patch's origin, then the swing (g/m).
using PartMotion = Eigen::Matrix<double, 6, 1>;
using PartMotionJacobian = Eigen::Matrix<double, 3, 6>;
/// Derivative by the motion of the specific force at a place of the patch, m.
PartMotionJacobian motionJacobian(const Eigen::Vector3d& at_o);

}  // namespace hexoderm
