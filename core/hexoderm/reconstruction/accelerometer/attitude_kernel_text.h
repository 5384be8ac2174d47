// The text of the kernel in attitude_kernel.h (lanes_text.h says what that is).

#include "hexoderm/reconstruction/accelerometer/attitude_kernel.h"
#include "hexoderm/reconstruction/accelerometer/turn_kernel_text.h"

namespace hexoderm {
namespace {

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
  for (int k = 0; k < options.most_steps; ++k) {
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
    solve(options.precision, options.least_information, rows, mixed, turn);

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
  for (const int k : diagonal) turn.information[k] = turn.information[k] - all(options.least_information);
  put(R, 9, out.R);
  put(turn.information, 6, out.information);
  put(turn.errors, 3, out.offset_g);
  put(turn.gain, 9, out.gain);
  put(&usual, 1, out.usual);
}

}  // namespace
}  // namespace hexoderm
