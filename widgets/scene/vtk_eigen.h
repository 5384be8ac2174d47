#pragma once

#include <Eigen/Core>

namespace hexoderm {

/// A point or direction as VTK returns it: three doubles that VTK keeps.
inline Eigen::Vector3d toEigen(const double* v) { return {v[0], v[1], v[2]}; }

}  // namespace hexoderm
