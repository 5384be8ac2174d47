#pragma once

#include <vtkActor.h>
#include <vtkMatrix4x4.h>
#include <vtkNew.h>
#include <Eigen/Core>

namespace hexoderm {

/// A point or direction as VTK returns it: three doubles that VTK keeps.
inline Eigen::Vector3d toEigen(const double* v) { return {v[0], v[1], v[2]}; }

/// Where an actor's points x are drawn: A x + t.
inline void setPlace(vtkActor* actor, const Eigen::Matrix3d& A, const Eigen::Vector3d& t) {
  Eigen::Matrix<double, 4, 4, Eigen::RowMajor> T = Eigen::Matrix4d::Identity();
  T.topLeftCorner<3, 3>() = A;
  T.topRightCorner<3, 1>() = t;
  const vtkNew<vtkMatrix4x4> matrix;
  matrix->DeepCopy(T.data());
  actor->SetUserMatrix(matrix);
}

}  // namespace hexoderm
