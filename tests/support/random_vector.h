#pragma once

#include <Eigen/Core>

namespace hexoderm::test {

/// Three numbers of a generator, drawn in an order that no compiler chooses: z, y, x.
template <typename Draw>
Eigen::Vector3d randomVector(Draw draw) {
  Eigen::Vector3d v;
  for (Eigen::Index axis = 2; axis >= 0; --axis) v[axis] = draw();
  return v;
}

}  // namespace hexoderm::test
