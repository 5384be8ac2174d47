#pragma once

#include "hexoderm/base/se3.h"
#include "hexoderm/solve/checks/consensus.h"

#include <optional>

namespace hexoderm {

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
