#pragma once

#include <cstddef>

namespace hexoderm {

// What linearize() computes for cells and links, for several at once, on plain numbers. Element e of several cells (or
// links) stands at [e * lanes] to [e * lanes + lanes - 1]; matrices stand row by row.

/// What is the same for all cells and links.
struct LinearizeSetting {
  double R_a_u[9];
  double prior_precision[3][4];  ///< of offset and gains, per axis
  double threshold_squared;      ///< of the Huber losses; may be infinite
  std::size_t poses;
  bool accelerations;
  bool lot;  ///< the lot's errors are unknowns
  double lot_scale;
  const double* force_o;         ///< three per pose
  const double* acceleration_o;  ///< three per pose, divided by standard gravity

  double link_precision;  ///< 1 / sigma, of ends
  double twist_precision;
  double bend_precision;
  double yaw_precision;
  bool bends;  ///< links may be arcs
  double gap_share;
};

/// Columns of the border that a pose has: its force's and its acceleration's.
constexpr std::size_t columnsOfPose(bool accelerations) { return accelerations ? 6 : 3; }

/// Columns of the border that the lot has: its offset's three and its scale's.
constexpr std::size_t kLotColumns = 4;

/// Cells: pose by pose, three readings and their precision, which is 0 where there is no reading.
struct CellLanes {
  const double* R_o_u;    ///< 9
  const double* lever_o;  ///< 3
  const double* y_g;      ///< 3 per pose, without the lot's offset
  const double* precision;

  double* cost;
  double* matrix;    ///< 6 x 6
  double* gradient;  ///< 6
  double* border;    ///< 6 x columns, per pose its columns
  /// To be added to, for all cells: per pair of poses, the first not before the second, columns x columns; and columns
  /// of the gradient per pose.
  double* border_sums;
  double* gradient_sums;

  // Where the lot's errors are unknowns.
  double* lot_border;  ///< 6 x kLotColumns
  /// To be added to: per pose kLotColumns x columns; then kLotColumns x kLotColumns; then of the gradient.
  double* lot_sums;

  double* workspace;  ///< aligned as all lanes of a number are
  static constexpr std::size_t kWorkspaceOfPose = 41;
};

struct LinkLanes {
  const double* R_c;    ///< 9; of both cells in the patch
  const double* R_n;    ///< 9
  const double* t_c_n;  ///< 3; t_n - t_c
  const double* p_c;    ///< 3
  const double* p_n;    ///< 3
  const double* R_nom;  ///< 9

  double* cost;
  double* matrix_c;  ///< 6 x 6
  double* matrix_n;
  double* matrix_c_n;
  double* gradient;  ///< of c, then of n
  double* share;     ///< 6 of c, 6 of n, the share's own, its gradient; where links are arcs
};

struct LinearizeKernels {
  std::size_t lanes;
  /// Bit k: cell k has a reading beyond the loss's threshold. If any has, nothing is computed.
  unsigned (*cells)(const LinearizeSetting& setting, const CellLanes& cells);
  void (*links)(const LinearizeSetting& setting, const LinkLanes& links);
};

/// The same on any machine.
const LinearizeKernels& portableLinearizeKernels();
/// With AVX2 and FMA; only where hasVectorInstructions(). Differs from the portable form by rounding.
const LinearizeKernels& avx2LinearizeKernels();
/// The faster that the machine can run.
const LinearizeKernels& linearizeKernels();

}  // namespace hexoderm
