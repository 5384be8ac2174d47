#pragma once

// Private to reconstruction: RigidityTest of kLanes links at a time.

#include "hexoderm/reconstruction/accelerometer/turn_kernel.h"

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

  turn_kernel::Turn<L> turn;
  turn_kernel::solve(options.precision, options.least_information, rows, mixed, turn);
  L twice_cost = squares;
  for (int k = 0; k < 12; ++k) twice_cost = twice_cost - turn.errors[k] * mixed[k];

  // gradient^T information^-1 gradient by L D L^T.
  const turn_kernel::Factor<L> of = turn_kernel::factor(turn.information);
  const L* gradient = turn.gradient;
  const L z_1 = gradient[1] - of.l_10 * gradient[0];
  const L z_2 = gradient[2] - of.l_20 * gradient[0] - of.l_21 * z_1;
  const L gained = gradient[0] * gradient[0] / of.d_0 + z_1 * z_1 / of.d_1 + z_2 * z_2 / of.d_2;
  const L chi_squared = twice_cost - gained;
  L::select(chi_squared > zero, chi_squared, zero).store(out.chi_squared + lane);
  L::select(turn_kernel::isUsual(of, turn.information), one, zero).store(out.usual + lane);
}

}  // namespace rigidity_kernel
}  // namespace hexoderm
