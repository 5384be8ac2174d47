#pragma once

#include "hexoderm/solve/global/accelerometer_fit.h"
#include "hexoderm/solve/global/attitude_kernel.h"

#include <span>

namespace hexoderm {

/// Deviation of readings from their expected values, as a chi-squared.
struct Misfit {
  double chi_squared = 0;
  double degrees = 0;  ///< degrees of freedom

  /// The misfit as a standard normal deviate (Wilson and Hilferty's transformation): comparable between cells and links
  /// with different numbers of poses. 0 without degrees of freedom.
  [[nodiscard]] double deviate() const;
};

/// Sums over readings y of specific forces v (accelerometer axes), with r = (1, v) and the readings' variances V: all
/// that the errors of a sensor and a small turn of its cell follow from.
struct ReadingSums {
  double readings = 0;
  Eigen::Matrix4d rows = Eigen::Matrix4d::Zero();                           ///< of r r^T / V
  Eigen::Matrix<double, 4, 3> mixed = Eigen::Matrix<double, 4, 3>::Zero();  ///< of r (y - v)^T / V
  double errors = 0;                                                        ///< of |y - v|^2 / V

  /// `sign` -1 takes the reading away again.
  void add(const CellReading& reading, const Eigen::Vector3d& v_g, double sign = 1);
};

/// Do a cell's readings move as one rigid body with the specific forces (accelerometer axes)? The misfit that is left
/// when the cell may turn freely, and its offset, gains and cross-axis sensitivity are whatever fits best under their
/// priors; none of fewer than two readings. Losses are quadratic. One Gauss-Newton step from the given attitude: good
/// to a few degrees from the best one.
Misfit testRigidity(const AccelerometerPrior& prior, const ReadingSums& sums);
Misfit testRigidity(const AccelerometerPrior& prior, std::span<const CellReading> readings,
                    std::span<const Eigen::Vector3d> v_g);

/// A turn of a cell between two of its poses, as far as its readings show one.
struct TurnBetweenPoses {
  std::size_t first_after = 0;  ///< index of the first reading after the turn
  double angle_rad = 0;         ///< as far as gravity shows it
  Misfit gain;                  ///< by how much the turn lowers the misfit, for so many parameters
};

/// What others say about a cell's attitude: the information of the error e in R_true = R exp(e), accelerometer axes,
/// rad^-2, and that times the most probable e. Nothing by default.
struct AttitudePrior {
  Eigen::Matrix3d information = Eigen::Matrix3d::Zero();
  Eigen::Vector3d weighted = Eigen::Vector3d::Zero();
};

/// The turn between two poses that explains the readings best, with all that testRigidity() grants as well and the
/// attitude before the turn as likely as `attitude` has it. Readings are in the order in which they were taken; two at
/// least. To first order in the turn. `least_gain`: a chi-squared; where no turn can gain as much, TurnBetweenPoses's
/// first_after may be 0, and nothing is looked for.
TurnBetweenPoses findTurn(const AccelerometerPrior& prior, std::span<const CellReading> readings,
                          std::span<const Eigen::Vector3d> v_g, const AttitudePrior& attitude = {},
                          double least_gain = 0);

/// A cell's attitude as its own readings have it.
struct OwnAttitude {
  Eigen::Matrix3d R = Eigen::Matrix3d::Identity();        ///< accelerometer to patch
  Eigen::Matrix3d information = Eigen::Matrix3d::Zero();  ///< of the error e in R_true = R exp(e), rad^-2
  Eigen::Vector3d offset_g = Eigen::Vector3d::Zero();     ///< of the sensor, as in AccelerometerFit
  Eigen::Matrix3d gain = Eigen::Matrix3d::Identity();
};

/// The attitude at which the readings of the specific forces `f_o` (patch frame, per reading) are most probable,
/// offset, gains and cross-axis sensitivity being whatever fits best under their priors. Found by Gauss-Newton from
/// `R_start` (accelerometer to patch); where the readings show nothing it stays there, and the information is 0.
OwnAttitude findAttitude(const AccelerometerPrior& prior, std::span<const CellReading> readings,
                         std::span<const Eigen::Vector3d> f_o, const Eigen::Matrix3d& R_start,
                         int most_steps = kMaxAttitudeSteps);

/// findAttitude() for the kernel.
AttitudeKernelOptions attitudeKernelOptions(const AccelerometerPrior& prior);

/// The information, rad^-2 in the accelerometer's axes, that readings of the specific forces `v_g` (accelerometer
/// axes), each as uncertain as `readings` has it, hold about a small turn of a cell whose offset, gains and cross-axis
/// sensitivity are not known. `fit` must belong to these readings.
Eigen::Matrix3d attitudeInformation(const AccelerometerFit& fit, std::span<const Eigen::Vector3d> v_g);

/// The errors of two cells' accelerometers together, as one accelerometer's prior: for testing a cell's readings
/// against its neighbour's, turned by their relative rotation `R_a_b` (accelerometer axes, the neighbour's to the
/// cell's).
AccelerometerPrior pairPrior(const Accelerometer& accelerometer, const Eigen::Matrix3d& R_a_b);

}  // namespace hexoderm
