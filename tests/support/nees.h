#pragma once

#include "hexoderm/solve/result/reconstruction.h"

#include <Eigen/Cholesky>

namespace hexoderm::test {

/// Normalised estimation errors squared per degree of freedom, e^T C^-1 e / 3, in the mean over cells: 1 if errors are
/// as large as stated, more if they are larger.
struct Nees {
  double position = 0;
  double orientation = 0;
  double count = 0;

  /// Of the error from one placement to another.
  void add(const SE3& T, const SE3& other, const Matrix6d& C) {
    const Eigen::Vector3d e_t = other.t - T.t;
    const Eigen::Vector3d e_r = logSO3(T.R.transpose() * other.R);
    const Eigen::Matrix3d C_t = C.topLeftCorner<3, 3>();
    const Eigen::Matrix3d C_r = C.bottomRightCorner<3, 3>();
    ++count;
    position += (e_t.dot(C_t.ldlt().solve(e_t)) / 3 - position) / count;
    orientation += (e_r.dot(C_r.ldlt().solve(e_r)) / 3 - orientation) / count;
  }
  /// Of all cells but the origin against true placements, moved so that the origin cells coincide.
  template <class TruePlacement>
  void addPatch(const PatchReconstruction& patch, const TruePlacement& T_b_u) {
    const SE3 T_o_b = T_b_u(patch.origin).inverse();
    for (const CellPlacement& cell : patch.cells) {
      if (cell.cell == patch.origin || !cell.cov_t_r) continue;
      add(cell.T_o_u, T_o_b * T_b_u(cell.cell), *cell.cov_t_r);
    }
  }
};

}  // namespace hexoderm::test
