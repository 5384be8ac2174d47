#pragma once

// The rotations of kLanes usual links at a time, as estimateEdgeRotation() has them.

#include "hexoderm/base/lanes.h"

namespace hexoderm {

/// What all links of a reconstruction have in common.
struct EdgeKernelOptions {
  double offset_variance_g2 = 0;         ///< of the accelerometer's errors
  double shared_offset_variance_g2 = 0;  ///< of what all have in common
  double scale_variance = 0;
  double cross_axis_variance = 0;
  double support = 0;         ///< information that keeps the equations solvable
  double prior_variance = 0;  ///< of an unknown angle, rad^2
  double shortest_g = 0;      ///< a shorter vector has no direction worth comparing
  double least_variance_g2 = 0;
  bool centre = false;         ///< solve centred too, and take what has the smaller variance
  bool always_centre = false;  ///< take the centred solution
};

/// Numbers of kLanes links side by side: value k of lane l is at [kLanes * k + l].
struct EdgeKernelInput {
  int poses = 0;
  const double* c_g = nullptr;          ///< poses x 3, source cell
  const double* n_g = nullptr;          ///< poses x 3, target cell
  const double* variance_g2 = nullptr;  ///< poses
  const double* R_nom = nullptr;        ///< 9, row by row: the nominal alignment
  const double* outward = nullptr;      ///< 3: unit vector of the source's port
};
/// Symmetric matrices are xx, xy, xz, yy, yz, zz.
struct EdgeKernelOutput {
  double R_c_n[9 * kLanes];
  double singular_values[3 * kLanes];
  double covariance[6 * kLanes];
  double prior_part[6 * kLanes];
  double centred[kLanes];  ///< 1 or 0
  double residual_rad[kLanes];
  double expected_residual_rad[kLanes];
  double angles_rad[3 * kLanes];        ///< twist, bend, yaw
  double has_angles[kLanes];            ///< 1, or 0 where they are too large
  double usual[kLanes];                 ///< 1, or 0 where the link needs a more careful look: nothing else counts then
  double* pose_residual_rad = nullptr;  ///< poses x kLanes
};

/// Two at a time, on any machine.
void estimateEdgesByTwo(const EdgeKernelOptions& options, const EdgeKernelInput& in, EdgeKernelOutput& out);
/// All at once; only where hasVectorInstructions().
void estimateEdgesByFour(const EdgeKernelOptions& options, const EdgeKernelInput& in, EdgeKernelOutput& out);

}  // namespace hexoderm
