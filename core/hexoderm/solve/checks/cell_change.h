#pragma once

#include "hexoderm/base/ids.h"
#include "hexoderm/solve/checks/cell_errors.h"
#include "hexoderm/solve/global/rigidity.h"

#include <Eigen/Core>
#include <cstddef>
#include <optional>
#include <span>
#include <vector>

namespace hexoderm {

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
  Eigen::VectorXd foretold_o_g;   ///< 3 per pose of the view
  Eigen::VectorXd residual_g;     ///< what the cell sees less that
  Eigen::MatrixXd covariance_g2;  ///< of the residual, if the cell is as calibrated
  Misfit misfit;
};

/// The cells of a patch that agree about how the part was held and moved, and so are as calibrated.
///
/// Model: all cells see one motion of a rigid part, s_kp = f_p + w_p x t_k + error, with the force f_p free in each
/// pose and the swing w_p known to be small (kAngularAccelerationSigma); the errors of a cell in all poses have one
/// covariance, and cells err independently. The motions are those that fit best by generalised least squares. A cell is
/// compared with what the others of the consensus foretell. From all cells, those that fit worst beyond `limit` (a
/// standard normal deviate) are taken out, until none is; those that agree with the rest after all come back.
///
/// Noise may be larger than its samples say, where they follow each other closely (a robot's motors shake slowly): then
/// the consensus misses by more than it should as a whole, and all covariances grow by as much. They never shrink.
///
/// Nothing here tells the consensus from the rest but their number: a turn of all cells is one of the part.
class Consensus {
 public:
  Consensus(std::span<const CellView> views, std::size_t poses, double limit);

  [[nodiscard]] bool holds(std::size_t view) const { return holds_[view]; }
  [[nodiscard]] std::size_t size() const;
  /// By how much all variances are larger than stated.
  [[nodiscard]] double varianceFactor() const { return variance_factor_; }
  /// The view beside what the consensus, without it, foretells.
  [[nodiscard]] ViewComparison compare(std::size_t view) const;

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
  Eigen::MatrixXd information_;  ///< of the motions, 6 per pose
  Eigen::VectorXd weighted_;
  Eigen::MatrixXd covariance_;
  Eigen::VectorXd motion_;
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
