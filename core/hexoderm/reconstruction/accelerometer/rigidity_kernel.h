#pragma once

// Private to reconstruction: RigidityTest of kLanes links at a time.

#include "hexoderm/geometry/lanes.h"

namespace hexoderm {

struct RigidityKernelOptions {
  double precision[12];          ///< of the prior: (b_i, D_i0, D_i1, D_i2) of axis i at 4 i
  double R_a_u[9];               ///< row by row: cell to accelerometer axes
  double least_information = 0;  ///< rad^-2: a turn that no reading shows takes nothing away
};

/// Numbers of kLanes links side by side: value k of lane l is at [kLanes * k + l].
struct RigidityKernelInput {
  int poses = 0;
  const double* c_g = nullptr;          ///< poses x 3, source cell, in its frame
  const double* n_g = nullptr;          ///< poses x 3, target cell
  const double* variance_g2 = nullptr;  ///< poses
  const double* R_c_n = nullptr;        ///< 9, row by row
};
struct RigidityKernelOutput {
  double chi_squared[kLanes];
  double usual[kLanes];  ///< 1, or 0 where the link needs a more careful look
};

/// One link after the other, on any computer.
void testRigidityByOne(const RigidityKernelOptions& options, const RigidityKernelInput& in, RigidityKernelOutput& out);
/// All at once; only where hasFourLanes().
void testRigidityByFour(const RigidityKernelOptions& options, const RigidityKernelInput& in, RigidityKernelOutput& out);

namespace rigidity_kernel {

/// Everything for the lanes from `lane` on, as many as L has; the algebra of RigidityTest::misfit().
template <class L>
HEXODERM_LANES_INLINE void test(const RigidityKernelOptions& options, const RigidityKernelInput& in, int lane,
                                RigidityKernelOutput& out) {
  using Mask = typename L::Mask;
  const auto at = [lane](const double* values, int k) { return L::load(values + kLanes * k + lane); };
  const L one(1.0);
  const L zero(0.0);

  L R[9];  // R_a_n
  for (int i = 0; i < 3; ++i) {
    for (int j = 0; j < 3; ++j) {
      R[3 * i + j] = L(options.R_a_u[3 * i]) * at(in.R_c_n, j) + L(options.R_a_u[3 * i + 1]) * at(in.R_c_n, 3 + j) +
                     L(options.R_a_u[3 * i + 2]) * at(in.R_c_n, 6 + j);
    }
  }
  L rows[16];   // sum of r r^T / V, r = (1, v)
  L mixed[12];  // sum of r (y - v)^T / V, row by row
  for (int k = 0; k < 16; ++k) rows[k] = zero;
  for (int k = 0; k < 12; ++k) mixed[k] = zero;
  L squares = zero;
  for (int p = 0; p < in.poses; ++p) {
    const L c[3] = {at(in.c_g, 3 * p), at(in.c_g, 3 * p + 1), at(in.c_g, 3 * p + 2)};
    const L n[3] = {at(in.n_g, 3 * p), at(in.n_g, 3 * p + 1), at(in.n_g, 3 * p + 2)};
    const L precision = one / at(in.variance_g2, p);
    L r[4] = {one, zero, zero, zero};
    L error[3];
    for (int i = 0; i < 3; ++i) {
      r[i + 1] = R[3 * i] * n[0] + R[3 * i + 1] * n[1] + R[3 * i + 2] * n[2];
      error[i] = L(options.R_a_u[3 * i]) * c[0] + L(options.R_a_u[3 * i + 1]) * c[1] +
                 L(options.R_a_u[3 * i + 2]) * c[2] - r[i + 1];
    }
    for (int i = 0; i < 4; ++i) {
      const L weighted = precision * r[i];
      for (int j = i; j < 4; ++j) rows[4 * i + j] = rows[4 * i + j] + weighted * r[j];
      for (int j = 0; j < 3; ++j) mixed[3 * i + j] = mixed[3 * i + j] + weighted * error[j];
    }
    squares = squares + precision * (error[0] * error[0] + error[1] * error[1] + error[2] * error[2]);
  }
  for (int i = 0; i < 4; ++i) {
    for (int j = 0; j < i; ++j) rows[4 * i + j] = rows[4 * j + i];
  }

  // Per axis the factor of rows + prior, G G^T, and the sensor's errors (b_i, D_i).
  L factor[3][16];
  L scale[3][4];  // one over the factor's diagonal
  L errors[12];   // row by row, as mixed
  for (int axis = 0; axis < 3; ++axis) {
    L* G = factor[axis];
    for (int j = 0; j < 4; ++j) {
      L diagonal = rows[5 * j] + L(options.precision[4 * axis + j]);
      for (int k = 0; k < j; ++k) diagonal = diagonal - G[4 * j + k] * G[4 * j + k];
      scale[axis][j] = one / root(diagonal);
      for (int i = j + 1; i < 4; ++i) {
        L value = rows[4 * i + j];
        for (int k = 0; k < j; ++k) value = value - G[4 * i + k] * G[4 * j + k];
        G[4 * i + j] = value * scale[axis][j];
      }
    }
    L x[4];
    for (int i = 0; i < 4; ++i) {
      L value = mixed[3 * i + axis];
      for (int k = 0; k < i; ++k) value = value - G[4 * i + k] * x[k];
      x[i] = value * scale[axis][i];
    }
    for (int i = 3; i >= 0; --i) {
      L value = x[i];
      for (int k = i + 1; k < 4; ++k) value = value - G[4 * k + i] * x[k];
      x[i] = value * scale[axis][i];
    }
    for (int i = 0; i < 4; ++i) errors[3 * i + axis] = x[i];
  }
  L twice_cost = squares;
  for (int k = 0; k < 12; ++k) twice_cost = twice_cost - errors[k] * mixed[k];

  // What a turn of the cell changes beyond them: with g_i row i of the gain, d residual_i / d turn = v^T [g_i]x.
  L gain[9];
  L left[9];  // sum of v e^T / V, e: residuals
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
  const L gradient[3] = {pull(2, 1) - pull(1, 2), pull(0, 2) - pull(2, 0), pull(1, 0) - pull(0, 1)};
  L information[6] = {L(options.least_information), zero, zero,
                      L(options.least_information), zero, L(options.least_information)};
  for (int axis = 0; axis < 3; ++axis) {
    const L* g = gain + 3 * axis;
    const L J[9] = {zero, zero - g[2], g[1], g[2], zero, zero - g[0], zero - g[1], g[0], zero};
    L weighted[12];  // rows times (0; J), row by row
    for (int i = 0; i < 4; ++i) {
      for (int j = 0; j < 3; ++j) {
        weighted[3 * i + j] = rows[4 * i + 1] * J[j] + rows[4 * i + 2] * J[3 + j] + rows[4 * i + 3] * J[6 + j];
      }
    }
    L solved[12];  // G^-1 weighted
    for (int i = 0; i < 4; ++i) {
      for (int j = 0; j < 3; ++j) {
        L value = weighted[3 * i + j];
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

  // gradient^T information^-1 gradient by L D L^T.
  const L trace = information[0] + information[3] + information[5];
  const L d_0 = information[0];
  const L l_10 = information[1] / d_0;
  const L l_20 = information[2] / d_0;
  const L d_1 = information[3] - l_10 * information[1];
  const L below = information[4] - l_20 * information[1];
  const L l_21 = below / d_1;
  const L d_2 = information[5] - l_20 * information[2] - l_21 * below;
  const L z_1 = gradient[1] - l_10 * gradient[0];
  const L z_2 = gradient[2] - l_20 * gradient[0] - l_21 * z_1;
  const L gained = gradient[0] * gradient[0] / d_0 + z_1 * z_1 / d_1 + z_2 * z_2 / d_2;
  const L chi_squared = twice_cost - gained;
  L::select(chi_squared > zero, chi_squared, zero).store(out.chi_squared + lane);
  // Where a turn hardly shows, rounding counts, and pivots should be chosen.
  constexpr double kLeastPivot = 1e-5;
  const Mask first = L::both(d_0 > L(kLeastPivot) * trace, d_1 > L(kLeastPivot) * trace);
  L::select(L::both(first, d_2 > L(kLeastPivot) * trace), one, zero).store(out.usual + lane);
}

}  // namespace rigidity_kernel
}  // namespace hexoderm
