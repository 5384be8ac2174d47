// What the texts of the kernels of this folder share, the algebra of solveSensorAndTurn() (rigidity.cpp).

#include "hexoderm/geometry/lanes_text.h"

namespace hexoderm {
namespace {

/// Where a turn shows less than so in one direction, against all, rounding counts, and pivots should be chosen.
constexpr double kLeastPivot = 1e-5;

/// The most probable errors of a sensor, and what a small turn of its cell changes beyond them.
struct Turn {
  Lanes errors[12];      ///< (b_i, D_i) in column i, row by row
  Lanes gain[9];         ///< row by row
  Lanes gradient[3];     ///< of half the misfit
  Lanes information[6];  ///< upper half, row by row; with the least information on its diagonal
};

/// `precision`: of the prior, (b_i, D_i0, D_i1, D_i2) of axis i at 4 i. `rows`: sum of r r^T / V, r = (1, v), row by
/// row. `mixed`: 4 x 3, sum of r (y - v)^T / V, row by row.
HEXODERM_INLINE void solve(const double* prior_precision, double least_information, const Lanes* rows,
                           const Lanes* mixed, Turn& turn) {
  const Lanes one = all(1.0);
  const Lanes zero = all(0.0);
  Lanes* errors = turn.errors;
  Lanes* gain = turn.gain;
  Lanes* information = turn.information;

  // Per axis the factor of rows + prior, G G^T, and the sensor's errors (b_i, D_i).
  Lanes factor[3][16];
  Lanes scale[3][4];  // one over the factor's diagonal
  for (int axis = 0; axis < 3; ++axis) {
    Lanes* G = factor[axis];
    for (int j = 0; j < 4; ++j) {
      Lanes diagonal = rows[5 * j] + all(prior_precision[4 * axis + j]);
      for (int k = 0; k < j; ++k) diagonal = diagonal - G[4 * j + k] * G[4 * j + k];
      scale[axis][j] = one / rootOf(diagonal);
      for (int i = j + 1; i < 4; ++i) {
        Lanes value = rows[4 * i + j];
        for (int k = 0; k < j; ++k) value = value - G[4 * i + k] * G[4 * j + k];
        G[4 * i + j] = value * scale[axis][j];
      }
    }
    Lanes x[4];
    for (int i = 0; i < 4; ++i) {
      Lanes value = mixed[3 * i + axis];
      for (int k = 0; k < i; ++k) value = value - G[4 * i + k] * x[k];
      x[i] = value * scale[axis][i];
    }
    for (int i = 3; i >= 0; --i) {
      Lanes value = x[i];
      for (int k = i + 1; k < 4; ++k) value = value - G[4 * k + i] * x[k];
      x[i] = value * scale[axis][i];
    }
    for (int i = 0; i < 4; ++i) errors[3 * i + axis] = x[i];
  }

  // What a turn of the cell changes beyond them: with g_i row i of the gain, d residual_i / d turn = v^T [g_i]x.
  Lanes left[9];  // sum of v e^T / V, e: residuals
  for (int i = 0; i < 3; ++i) {
    for (int j = 0; j < 3; ++j) {
      gain[3 * i + j] = (i == j ? one : zero) + errors[3 * (j + 1) + i];
      left[3 * i + j] = mixed[3 * (i + 1) + j] - rows[4 * (i + 1)] * errors[j] - rows[4 * (i + 1) + 1] * errors[3 + j] -
                        rows[4 * (i + 1) + 2] * errors[6 + j] - rows[4 * (i + 1) + 3] * errors[9 + j];
    }
  }
  const auto pull = [&](int i, int j) {
    return left[3 * i] * gain[j] + left[3 * i + 1] * gain[3 + j] + left[3 * i + 2] * gain[6 + j];
  };
  turn.gradient[0] = pull(1, 2) - pull(2, 1);
  turn.gradient[1] = pull(2, 0) - pull(0, 2);
  turn.gradient[2] = pull(0, 1) - pull(1, 0);
  for (int k = 0; k < 6; ++k) information[k] = zero;
  information[0] = information[3] = information[5] = all(least_information);
  for (int axis = 0; axis < 3; ++axis) {
    const Lanes* g = gain + 3 * axis;
    const Lanes J[9] = {zero, zero - g[2], g[1], g[2], zero, zero - g[0], zero - g[1], g[0], zero};
    Lanes weighted[12];  // rows times (0; J), row by row
    for (int i = 0; i < 4; ++i) {
      for (int j = 0; j < 3; ++j) {
        weighted[3 * i + j] = rows[4 * i + 1] * J[j] + rows[4 * i + 2] * J[3 + j] + rows[4 * i + 3] * J[6 + j];
      }
    }
    Lanes solved[12];  // G^-1 weighted
    for (int i = 0; i < 4; ++i) {
      for (int j = 0; j < 3; ++j) {
        Lanes value = weighted[3 * i + j];
        for (int k = 0; k < i; ++k) value = value - factor[axis][4 * i + k] * solved[3 * k + j];
        solved[3 * i + j] = value * scale[axis][i];
      }
    }
    int k = 0;
    for (int i = 0; i < 3; ++i) {
      for (int j = i; j < 3; ++j, ++k) {
        information[k] = information[k] + J[i] * weighted[3 + j] + J[3 + i] * weighted[6 + j] +
                         J[6 + i] * weighted[9 + j] - solved[i] * solved[j] - solved[3 + i] * solved[3 + j] -
                         solved[6 + i] * solved[6 + j] - solved[9 + i] * solved[9 + j];
      }
    }
  }
}

/// information = (1; l_10 1; l_20 l_21 1) diag(d_0, d_1, d_2) times its transpose.
struct Factor {
  Lanes d_0, d_1, d_2;
  Lanes l_10, l_20, l_21;
};

HEXODERM_INLINE Factor factor(const Lanes* information) {
  Factor of;
  of.d_0 = information[0];
  of.l_10 = information[1] / of.d_0;
  of.l_20 = information[2] / of.d_0;
  of.d_1 = information[3] - of.l_10 * information[1];
  const Lanes below = information[4] - of.l_20 * information[1];
  of.l_21 = below / of.d_1;
  of.d_2 = information[5] - of.l_20 * information[2] - of.l_21 * below;
  return of;
}

/// All three angles show.
HEXODERM_INLINE Mask isUsual(const Factor& of, const Lanes* information) {
  const Lanes least = all(kLeastPivot) * (information[0] + information[3] + information[5]);
  return (of.d_0 > least) & (of.d_1 > least) & (of.d_2 > least);
}

}  // namespace
}  // namespace hexoderm
