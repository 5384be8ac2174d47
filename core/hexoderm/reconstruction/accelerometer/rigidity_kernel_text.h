// The text of the kernel in rigidity_kernel.h (lanes_text.h says what that is).

#include "hexoderm/reconstruction/accelerometer/rigidity_kernel.h"
#include "hexoderm/reconstruction/accelerometer/turn_kernel_text.h"

namespace hexoderm {
namespace {

/// Everything for kWidth lanes from `lane` on; the algebra of testRigidity().
HEXODERM_INLINE void test(const RigidityKernelOptions& options, const RigidityKernelInput& in, int lane,
                          RigidityKernelOutput& out) {
  const auto at = [lane](const double* values, int k) { return load(values + kLanes * k + lane); };
  const Lanes one = all(1.0);
  const Lanes zero = all(0.0);

  Lanes R[9];  // R_a_n
  for (int i = 0; i < 3; ++i) {
    for (int j = 0; j < 3; ++j) {
      R[3 * i + j] = all(options.R_a_u[3 * i]) * at(in.R_c_n, j) + all(options.R_a_u[3 * i + 1]) * at(in.R_c_n, 3 + j) +
                     all(options.R_a_u[3 * i + 2]) * at(in.R_c_n, 6 + j);
    }
  }
  Lanes rows[16] = {};   // sum of r r^T / V, r = (1, v)
  Lanes mixed[12] = {};  // sum of r (y - v)^T / V, row by row
  Lanes squares = zero;
  for (int p = 0; p < in.poses; ++p) {
    const Lanes c[3] = {at(in.c_g, 3 * p), at(in.c_g, 3 * p + 1), at(in.c_g, 3 * p + 2)};
    const Lanes n[3] = {at(in.n_g, 3 * p), at(in.n_g, 3 * p + 1), at(in.n_g, 3 * p + 2)};
    const Lanes precision = one / at(in.variance_g2, p);
    Lanes r[4] = {one, zero, zero, zero};
    Lanes error[3];
    for (int i = 0; i < 3; ++i) {
      r[i + 1] = R[3 * i] * n[0] + R[3 * i + 1] * n[1] + R[3 * i + 2] * n[2];
      error[i] = all(options.R_a_u[3 * i]) * c[0] + all(options.R_a_u[3 * i + 1]) * c[1] +
                 all(options.R_a_u[3 * i + 2]) * c[2] - r[i + 1];
    }
    for (int i = 0; i < 4; ++i) {
      const Lanes weighted = precision * r[i];
      for (int j = i; j < 4; ++j) rows[4 * i + j] = rows[4 * i + j] + weighted * r[j];
      for (int j = 0; j < 3; ++j) mixed[3 * i + j] = mixed[3 * i + j] + weighted * error[j];
    }
    squares = squares + precision * (error[0] * error[0] + error[1] * error[1] + error[2] * error[2]);
  }
  for (int i = 0; i < 4; ++i) {
    for (int j = 0; j < i; ++j) rows[4 * i + j] = rows[4 * j + i];
  }

  Turn turn;
  solve(options.precision, options.least_information, rows, mixed, turn);
  Lanes twice_cost = squares;
  for (int k = 0; k < 12; ++k) twice_cost = twice_cost - turn.errors[k] * mixed[k];

  // gradient^T information^-1 gradient by L D L^T.
  const Factor of = factor(turn.information);
  const Lanes* gradient = turn.gradient;
  const Lanes z_1 = gradient[1] - of.l_10 * gradient[0];
  const Lanes z_2 = gradient[2] - of.l_20 * gradient[0] - of.l_21 * z_1;
  const Lanes gained = gradient[0] * gradient[0] / of.d_0 + z_1 * z_1 / of.d_1 + z_2 * z_2 / of.d_2;
  const Lanes chi_squared = twice_cost - gained;
  store(out.chi_squared + lane, chi_squared > zero ? chi_squared : zero);
  store(out.usual + lane, isUsual(of, turn.information) ? one : zero);
}

}  // namespace
}  // namespace hexoderm
