#pragma once

#include "hexoderm/base/ids.h"
#include "hexoderm/base/se3.h"
#include "hexoderm/base/units.h"
#include "hexoderm/skin/cell_model.h"
#include "hexoderm/solve/global/accelerometer_fit.h"
#include "hexoderm/solve/global/rigidity.h"
#include "hexoderm/solve/result/reconstruction.h"

#include <Eigen/Core>
#include <array>
#include <cstddef>
#include <optional>
#include <span>
#include <vector>

namespace hexoderm {

/// The unknowns of one cell: a small turn of its attitude (accelerometer axes), then per axis offset and gains.
inline constexpr int kCellUnknowns = 15;
using CellErrors = Eigen::Matrix<double, kCellUnknowns, kCellUnknowns>;  ///< information or covariance
using CellJacobian = Eigen::Matrix<double, 3, kCellUnknowns>;
inline constexpr std::array<int, 3> kOffsets = {3, 7, 11};  ///< among them

/// Derivative of a reading gain v + offset of the specific force v by the unknowns.
CellJacobian readingJacobian(const Eigen::Matrix3d& gain, const Eigen::Vector3d& v);

/// Information of the links' elastomer about a cell's attitude, rad^-2, accelerometer axes. `ports`: where the cell has
/// links. A turn about an axis along which every neighbour lets the cell go is still not free: it is known to within a
/// turn.
Eigen::Matrix3d elastomerInformation(const CellModel& model, std::span<const PortNumber> ports);

/// What is known of a patch's chips beside its lot, which is known where the patch states it; where it does not, each
/// chip has the lot's errors as its own.
AccelerometerPrior priorOfChips(const CellModel& model, const PatchReconstruction& patch);
/// 1 sigma of what the patch's offsets have in common and its lot does not say, per axis, g.
double unknownOfLot_g(const PatchReconstruction& patch);

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

/// What all cells share in a pose: the specific force at the patch's origin, the swing (g/m), and what the offsets of
/// all sensors changed by together (g, accelerometer axes).
inline constexpr int kShared = 9;
using SharedByCells = Eigen::Matrix<double, kShared, 1>;
using SharedJacobian = Eigen::Matrix<double, 3, kShared>;
/// Derivative by it of the specific force that a cell sees at a place of the patch, m. `drift_o`: by the sensor's
/// offset.
SharedJacobian sharedJacobian(const Eigen::Vector3d& at_o, const Eigen::Matrix3d& drift_o);

/// 1 sigma, g per axis, of what the offsets of all sensors change by together: alike in all poses, and from pose to
/// pose.
struct SharedDrift {
  double of_session_g = 0;
  double of_poses_g = 0;
};
/// Information about what cells share in each of some poses before they are read: the force is whatever it is, the
/// swing is little (kAngularAccelerationSigma). Where cells are parallel, a common drift is part of the force.
Eigen::MatrixXd sharedPrior(std::size_t poses, const SharedDrift& drift);

/// What a calibrated cell sees in some poses: in each the specific force there, by its calibration, in the patch frame.
struct CellView {
  CellId cell;
  std::vector<std::size_t> poses;  ///< indices, ascending
  Eigen::Vector3d at_o;            ///< position of the cell, m
  Eigen::VectorXd force_o_g;       ///< 3 per pose
  /// Of all of them together: what is wrong with the calibration is wrong in all poses.
  Eigen::MatrixXd covariance_g2;
  Eigen::Matrix3d drift_o;  ///< derivative of a force by the sensor's offset (accelerometer axes)
};

/// A cell beside what other cells foretell.
struct ViewComparison {
  Eigen::VectorXd foretold_o_g;   ///< 3 per pose of the view, without the drift that all sensors share
  Eigen::VectorXd residual_g;     ///< what the cell sees less that and the drift
  Eigen::MatrixXd covariance_g2;  ///< of the residual, if the cell is as calibrated
  Misfit misfit;

  /// By how much the cell misses: the deviate of the whole misfit, or of the part that a small turn explains if that is
  /// larger. A turn has three numbers however many poses there are, so that it stands out of less.
  [[nodiscard]] double deviate() const;
  /// What the residual says about a small turn of the cell: information, patch frame, rad^-2.
  [[nodiscard]] Eigen::Matrix3d turnInformation() const;
};

/// The cells of a patch that agree about how the part was held and moved, and so are as calibrated.
///
/// Model: all cells see one motion of a rigid part by sensors whose offsets drift together, s_kp = f_p + w_p x t_k +
/// D_k b_p + error, with the force f_p free in each pose, the swing w_p known to be small (kAngularAccelerationSigma),
/// and the drift b_p as large as SharedDrift has it; D_k is the view's drift_o. The errors of a cell in all poses have
/// one covariance, and but for what they share, cells err independently. Motions and drifts are those that fit best by
/// generalised least squares. A cell is compared with what the others of the consensus foretell. From all cells, those
/// that fit worst beyond `limit` (ViewComparison::deviate()) are taken out, until none is; those that agree with the
/// rest after all come back.
///
/// Noise may be larger than its samples say, where they follow each other closely (a robot's motors shake slowly): then
/// the consensus misses by more than it should as a whole, and all covariances grow by as much. They never shrink.
///
/// Nothing here tells the consensus from the rest but their number: a turn of all cells is one of the part.
class Consensus {
 public:
  Consensus(std::span<const CellView> views, std::size_t poses, double limit, const SharedDrift& drift = {});

  [[nodiscard]] bool holds(std::size_t view) const { return holds_[view]; }
  [[nodiscard]] std::size_t size() const;
  /// By how much all variances are larger than stated.
  [[nodiscard]] double varianceFactor() const { return variance_factor_; }
  /// The view beside what the consensus, without it, foretells.
  [[nodiscard]] ViewComparison compare(std::size_t view) const;
  /// What the offsets of all sensors changed by together, the mean over the poses; nothing where that may be nothing.
  struct CommonDrift {
    Eigen::Vector3d offset_g = Eigen::Vector3d::Zero();  ///< accelerometer axes
    double sigma_g = 0;                                  ///< of its length
  };
  [[nodiscard]] std::optional<CommonDrift> commonDrift() const;

 private:
  void count(const CellView& view, double sign);
  void solve();
  void exclude();
  void readmit();
  void findVarianceFactor();

  std::span<const CellView> views_;
  double limit_;
  double variance_factor_ = 1;
  std::vector<bool> holds_;
  Eigen::MatrixXd information_;  ///< of what the cells share, kShared per pose
  Eigen::VectorXd weighted_;
  Eigen::MatrixXd covariance_;
  Eigen::VectorXd shared_;
};

/// The turn of a cell that explains best why it does not see what it should.
struct TurnFit {
  Eigen::Vector3d turn_o = Eigen::Vector3d::Zero();  ///< rotation vector of the cell, patch frame
  double sigma_rad = 0;                              ///< of its angle
  double blind_sigma_rad = 0;  ///< of the component that the poses show least: a turn about gravity of a single pose
  Misfit left;                 ///< what it does not explain
};
/// The same for a jump of the sensor's offset.
struct DriftFit {
  Eigen::Vector3d offset_g = Eigen::Vector3d::Zero();  ///< accelerometer axes
  double sigma_g = 0;                                  ///< of its length
  Misfit left;
};

/// Both fits are by generalised least squares under a weak prior (a radian, and 1 g, per axis), which only keeps what
/// the readings don't show at bay.
TurnFit fitTurn(const ViewComparison& comparison);
DriftFit fitDrift(const CellView& view, const ViewComparison& comparison);

/// The smallest turn that would be found with 95 % probability whatever its axis, and whatever its axis among the two
/// that the poses show best; a cell is found beyond the deviate `limit`. Nothing for one that any turn could go
/// unnoticed about.
struct NoticedTurn {
  std::optional<double> any_axis_rad;
  std::optional<double> two_axes_rad;
};
NoticedTurn noticedTurn(const ViewComparison& comparison, double limit);

}  // namespace hexoderm
