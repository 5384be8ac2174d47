#pragma once

#include "hexoderm/skin/cell_model.h"
#include "hexoderm/solve/result/reconstruction.h"

#include <vector>

namespace hexoderm {

/// Readings of the two cells of a link in the poses both have usable ones in.
struct EdgeReadings {
  Eigen::Matrix3Xd n_g;             ///< 3 x P: target cell, in its frame, not normalised
  Eigen::Matrix3Xd c_g;             ///< 3 x P: source cell, in its frame
  std::vector<double> variance_g2;  ///< per pose: sum of both means' variances, per axis
};

/// A rotation estimated from gravity, eqs. (13) to (15), with its class, eq. (17), its residual and its uncertainty.
struct EdgeRotation {
  Eigen::Matrix3d R_c_n = Eigen::Matrix3d::Identity();
  Eigen::Vector3d singular_values = Eigen::Vector3d::Zero();  ///< of the unit vectors, neither centred nor supported
  EdgeQuality quality = EdgeQuality::Undefined;
  bool centred = false;
  bool supported = false;
  Eigen::Matrix3d covariance =
      Eigen::Matrix3d::Zero();  ///< covariance of the left error d, R_true = exp(d) R, source frame, rad^2
  Eigen::Matrix3d prior_part = Eigen::Matrix3d::Zero();  ///< share of `covariance` that the elastomer prior stands for
  double deviation_rad = 0;                              ///< about the worst axis, by `covariance`
  LinkAngles angles;                                     ///< of R_c_n
  double residual_rad = 0;
  double expected_residual_rad = 0;       ///< residual expected from noise and the sensors' priors
  std::vector<double> pose_residual_rad;  ///< filled by estimateEdgeRotation() only; SkinLinks keeps those of all links
};

/// Class of an edge from its singular values in descending order, eq. (17) with the given threshold.
EdgeQuality classifyEdge(const Eigen::Vector3d& singular_values, double threshold);

/// The paper's weight of a class: 3, 2, 1, 1.
double paperWeight(EdgeQuality quality);

/// Whether support axes belong to an edge that was estimated without. They pull towards the nominal alignment, also
/// where the poses know better: they are for links of which the poses tell less than the elastomer does.
bool needsSupport(const EdgeRotation& unsupported, SupportAxes axes, const CellModel& model);

/// Estimates R_c_n by the constrained orthogonal Procrustes solution, eqs. (13) to (15), of unit vectors or, where
/// centring applies, of raw vectors less their mean; with the gap's axes appended where support axes apply.
/// `centring` Auto takes whichever has the smaller predicted deviation; `support_axes` Auto appends them to an edge
/// that is not fully defined, and that the poses leave more uncertain than the elastomer does. No readings at all: the
/// nominal alignment if support axes apply, else the identity. Never NaN.
EdgeRotation estimateEdgeRotation(const CellModel& model, const Port& source, const Port& target,
                                  const EdgeReadings& readings, const SolverOptions& options);

/// Error of a cell's own attitude due to its noise, offset and gains: R_true = exp(e) R in the cell frame. Errors of
/// edges are differences of these, which is why offsets telescope along a chain instead of adding up.
/// `g_g`: 3 x P raw readings; `variance_g2` per pose; empty: zero (what is missing is the links' to say). A direction
/// that the poses leave open is left to the edges (EdgeRotation::prior_part).
Eigen::Matrix3d cellAttitudeCovariance(const Accelerometer& accelerometer, const Eigen::Matrix3Xd& g_g,
                                       const std::vector<double>& variance_g2, bool centred, bool supported);

}  // namespace hexoderm
