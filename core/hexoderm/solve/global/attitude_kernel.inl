// The text of the kernel in attitude_kernel.h (lanes.inl says what that is).

#include "hexoderm/base/lanes.inl"
#include "hexoderm/solve/global/attitude_kernel.h"

namespace hexoderm {
namespace {

/// Where a turn shows less than so in one direction, against all, rounding counts, and pivots should be chosen.
constexpr double kMinPivot = 1e-5;

/// The most probable errors of a sensor, and what a small turn of its cell changes beyond them.
struct Turn {
  Lanes errors[12];      ///< (b_i, D_i) in column i, row by row
  Lanes gain[9];         ///< row by row
  Lanes gradient[3];     ///< of half the misfit
  Lanes information[6];  ///< upper half, row by row; with the minimum information on its diagonal
};

/// `precision`: of the prior, (b_i, D_i0, D_i1, D_i2) of axis i at 4 i. `rows`: sum of r r^T / V, r = (1, v), row by
/// row. `mixed`: 4 x 3, sum of r (y - v)^T / V, row by row.
HEXODERM_INLINE void solve(const double* prior_precision, double min_information, const Lanes* rows, const Lanes* mixed,
                           Turn& turn) {
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
  information[0] = information[3] = information[5] = all(min_information);
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
  const Lanes least = all(kMinPivot) * (information[0] + information[3] + information[5]);
  return (of.d_0 > least) & (of.d_1 > least) & (of.d_2 > least);
}

/// R exp(-step), to third order in the step: a rotation in any case.
HEXODERM_INLINE void turnBack(Lanes* R, const Lanes* step) {
  // The unit quaternion (1, h) / |(1, h)|.
  const Lanes h[3] = {all(-0.5) * step[0], all(-0.5) * step[1], all(-0.5) * step[2]};
  const Lanes square = h[0] * h[0] + h[1] * h[1] + h[2] * h[2];
  const Lanes s = all(2.0) / (all(1.0) + square);
  Lanes T[9];
  for (int i = 0; i < 3; ++i) {
    for (int j = 0; j < 3; ++j) T[3 * i + j] = s * h[i] * h[j];
    T[4 * i] = T[4 * i] + all(1.0) - s * square;
  }
  const Lanes sh[3] = {s * h[0], s * h[1], s * h[2]};
  T[1] = T[1] - sh[2];
  T[2] = T[2] + sh[1];
  T[3] = T[3] + sh[2];
  T[5] = T[5] - sh[0];
  T[6] = T[6] - sh[1];
  T[7] = T[7] + sh[0];
  for (int i = 0; i < 3; ++i) {
    const Lanes row[3] = {R[3 * i], R[3 * i + 1], R[3 * i + 2]};
    for (int j = 0; j < 3; ++j) R[3 * i + j] = row[0] * T[j] + row[1] * T[3 + j] + row[2] * T[6 + j];
  }
}

/// Everything for kWidth lanes from `lane` on.
HEXODERM_INLINE void find(const AttitudeKernelOptions& options, const OwnAttitudeKernelInput& in, int lane,
                          OwnAttitudeKernelOutput& out) {
  constexpr double kConverged = 1e-9;
  constexpr double kLargestStep = 0.5;
  const auto at = [lane](const double* values, int k) { return load(values + kLanes * k + lane); };
  const Lanes one = all(1.0);
  const Lanes zero = all(0.0);

  // With q = (1, f) and V = 1 / precision: sums of q q^T / V and of q y^T / V. In a cell with the attitude R the forces
  // are v = R^T f, and everything follows from these sums turned, however many readings there are.
  Lanes forces[16] = {};
  Lanes read[12] = {};
  for (int p = 0; p < in.readings; ++p) {
    const Lanes precision = at(in.precision, p);
    const Lanes q[4] = {one, at(in.f_o, 3 * p), at(in.f_o, 3 * p + 1), at(in.f_o, 3 * p + 2)};
    const Lanes y[3] = {at(in.y_g, 3 * p), at(in.y_g, 3 * p + 1), at(in.y_g, 3 * p + 2)};
    for (int i = 0; i < 4; ++i) {
      const Lanes weighted = precision * q[i];
      for (int j = i; j < 4; ++j) forces[4 * i + j] = forces[4 * i + j] + weighted * q[j];
      for (int j = 0; j < 3; ++j) read[3 * i + j] = read[3 * i + j] + weighted * y[j];
    }
  }
  for (int i = 0; i < 4; ++i) {
    for (int j = 0; j < i; ++j) forces[4 * i + j] = forces[4 * j + i];
  }

  Lanes R[9];
  for (int k = 0; k < 9; ++k) R[k] = at(in.R_start, k);
  Turn turn;
  Lanes usual = one;
  for (int k = 0; k < in.most_steps; ++k) {
    Lanes half[12];  // 4 x 3, sum of q v^T / V
    for (int i = 0; i < 4; ++i) {
      for (int j = 0; j < 3; ++j) {
        half[3 * i + j] = forces[4 * i + 1] * R[j] + forces[4 * i + 2] * R[3 + j] + forces[4 * i + 3] * R[6 + j];
      }
    }
    Lanes rows[16];
    Lanes mixed[12];
    rows[0] = forces[0];
    for (int j = 0; j < 3; ++j) {
      rows[1 + j] = rows[4 * (1 + j)] = half[j];
      mixed[j] = read[j] - half[j];
    }
    for (int i = 0; i < 3; ++i) {
      for (int j = 0; j < 3; ++j) {
        const Lanes v_v = R[i] * half[3 + j] + R[3 + i] * half[6 + j] + R[6 + i] * half[9 + j];
        rows[4 * (1 + i) + 1 + j] = v_v;
        mixed[3 * (1 + i) + j] = R[i] * read[3 + j] + R[3 + i] * read[6 + j] + R[6 + i] * read[9 + j] - v_v;
      }
    }
    solve(options.precision, options.min_information, rows, mixed, turn);

    const Factor of = factor(turn.information);
    usual = isUsual(of, turn.information) ? usual : zero;
    const Lanes z_0 = turn.gradient[0];
    const Lanes z_1 = turn.gradient[1] - of.l_10 * z_0;
    const Lanes z_2 = turn.gradient[2] - of.l_20 * z_0 - of.l_21 * z_1;
    Lanes step[3];
    step[2] = z_2 / of.d_2;
    step[1] = z_1 / of.d_1 - of.l_21 * step[2];
    step[0] = z_0 / of.d_0 - of.l_10 * step[1] - of.l_20 * step[2];
    const Lanes size = rootOf(step[0] * step[0] + step[1] * step[1] + step[2] * step[2]);
    const Lanes share = size > all(kLargestStep) ? all(kLargestStep) / size : one;
    for (Lanes& angle : step) angle = share * angle;
    turnBack(R, step);
    const Mask moves = (size > all(kConverged)) & (usual > zero);
    if (!any(moves)) break;
  }

  const auto put = [lane](const Lanes* values, int count, double* to) {
    for (int k = 0; k < count; ++k) store(to + kLanes * k + lane, values[k]);
  };
  const int diagonal[3] = {0, 3, 5};
  for (const int k : diagonal) turn.information[k] = turn.information[k] - all(options.min_information);
  put(R, 9, out.R);
  put(turn.information, 6, out.information);
  put(turn.errors, 3, out.offset_g);
  put(turn.gain, 9, out.gain);
  put(&usual, 1, out.usual);
}

}  // namespace
}  // namespace hexoderm
