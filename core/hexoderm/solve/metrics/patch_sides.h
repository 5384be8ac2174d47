#pragma once

#include "hexoderm/solve/result/reconstruction.h"

#include <Eigen/Core>
#include <array>

namespace hexoderm {

/// The directions from which a patch is drawn on paper: four turns by 90 degrees about the direction that its faces
/// look along least, which is the axis of an arm that it is wrapped about, so that every face is seen. Of a flat patch
/// it is the longest one. From the front most faces are seen. Rows are right, up and towards the viewer, in the patch's
/// frame: x_view = R_v_o x_o.
struct PatchSides {
  /// A side of a patch that is looked at from above.
  enum Side { Front, Right, Back, Left };
  std::array<Eigen::Matrix3d, 4> R_v_o;
};

/// Of a patch without cells, the patch frame's z is the front and y is up.
PatchSides patchSides(const PatchReconstruction& patch);

}  // namespace hexoderm
