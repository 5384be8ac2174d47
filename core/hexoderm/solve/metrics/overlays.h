#pragma once

#include "hexoderm/solve/checks/evaluation.h"

#include <span>
#include <vector>

namespace hexoderm {

// Figures drawn over a patch, in the patch's own frame. Metres and radians.

/// The truth where it would lie on the reconstruction if that were perfect: moved, patch by patch, by the rigid
/// transform that fits the centres best. Centres on a line or fewer than three leave a turn open; there the rotation
/// that fits the orientations best is taken. Patch by patch, cells in the order of the reconstruction; cells that the
/// truth does not know are left out.
struct AlignedCell {
  std::size_t patch = 0;  ///< index into Reconstruction::patches
  CellId cell;
  SE3 T_o_u;
};
/// The true cells, moved to where they fit the reconstructed ones best.
std::vector<AlignedCell> alignTruth(const Reconstruction& reconstruction, const GroundTruth& truth);

/// The placement of a cell in the reference of a comparison, and its placement now.
struct CellShift {
  std::size_t patch = 0;
  CellId cell;
  Eigen::Vector3d before_o;
  Eigen::Vector3d now_o;
};
/// Shifts from comparisons of this reconstruction (compareToReconstruction, compareToTruth); cells and patches that it
/// does not have are left out.
std::vector<CellShift> shiftsOf(const Reconstruction& reconstruction, std::span<const Comparison> comparisons);

/// Factor by which small figures are enlarged to be seen: the largest of 1, 2, 5, 10, 20, 50 ... 1,000 with which
/// `largest` stays within `room`.
double enlargement(double largest, double room);

}  // namespace hexoderm
