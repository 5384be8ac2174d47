#pragma once

// Private to reconstruction: findAttitude() (rigidity.h) of kLanes cells at a time.

#include "hexoderm/reconstruction/accelerometer/turn_kernel.h"

namespace hexoderm {

struct AttitudeKernelOptions {
  double precision[12];          ///< of the prior: (b_i, D_i0, D_i1, D_i2) of axis i at 4 i
  double least_information = 0;  ///< rad^-2: a turn that no reading shows takes nothing away
  int most_steps = 15;           ///< of Gauss-Newton
};

/// Numbers of kLanes cells side by side: value k of lane l is at [kLanes * k + l].
struct OwnAttitudeKernelInput {
  int readings = 0;
  const double* f_o = nullptr;        ///< readings x 3, specific forces in the patch's frame
  const double* y_g = nullptr;        ///< readings x 3, accelerometer axes
  const double* precision = nullptr;  ///< readings, 1/g^2; 0 for one that a cell doesn't have
  const double* R_start = nullptr;    ///< 9, row by row, accelerometer to patch
};
struct OwnAttitudeKernelOutput {
  double R[9 * kLanes];            ///< row by row, accelerometer to patch
  double information[6 * kLanes];  ///< upper half, row by row, rad^-2
  double offset_g[3 * kLanes];
  double gain[9 * kLanes];  ///< row by row
  double usual[kLanes];     ///< 1, or 0 where the cell needs a more careful look
};

/// One cell after the other, on any computer.
void findAttitudesByOne(const AttitudeKernelOptions& options, const OwnAttitudeKernelInput& in,
                        OwnAttitudeKernelOutput& out);
/// All at once; only where hasFourLanes().
void findAttitudesByFour(const AttitudeKernelOptions& options, const OwnAttitudeKernelInput& in,
                         OwnAttitudeKernelOutput& out);

namespace attitude_kernel {

/// R exp(-step), to third order in the step: a rotation in any case.
template <class L>
HEXODERM_LANES_INLINE void turnBack(L* R, const L* step) {
  // The unit quaternion (1, h) / |(1, h)|.
  const L h[3] = {L(-0.5) * step[0], L(-0.5) * step[1], L(-0.5) * step[2]};
  const L square = h[0] * h[0] + h[1] * h[1] + h[2] * h[2];
  const L s = L(2.0) / (L(1.0) + square);
  L T[9];
  for (int i = 0; i < 3; ++i) {
    for (int j = 0; j < 3; ++j) T[3 * i + j] = s * h[i] * h[j];
    T[4 * i] = T[4 * i] + L(1.0) - s * square;
  }
  const L sh[3] = {s * h[0], s * h[1], s * h[2]};
  T[1] = T[1] - sh[2];
  T[2] = T[2] + sh[1];
  T[3] = T[3] + sh[2];
  T[5] = T[5] - sh[0];
  T[6] = T[6] - sh[1];
  T[7] = T[7] + sh[0];
  for (int i = 0; i < 3; ++i) {
    const L row[3] = {R[3 * i], R[3 * i + 1], R[3 * i + 2]};
    for (int j = 0; j < 3; ++j) R[3 * i + j] = row[0] * T[j] + row[1] * T[3 + j] + row[2] * T[6 + j];
  }
}

/// Everything for the lanes from `lane` on, as many as L has.
template <class L>
HEXODERM_LANES_INLINE void find(const AttitudeKernelOptions& options, const OwnAttitudeKernelInput& in, int lane,
                                OwnAttitudeKernelOutput& out) {
  constexpr double kConverged = 1e-9;
  constexpr double kLargestStep = 0.5;
  using Mask = typename L::Mask;
  const auto at = [lane](const double* values, int k) { return L::load(values + kLanes * k + lane); };
  const L one(1.0);
  const L zero(0.0);

  // With q = (1, f) and V = 1 / precision: sums of q q^T / V and of q y^T / V. In a cell with the attitude R the forces
  // are v = R^T f, and everything follows from these sums turned, however many readings there are.
  L forces[16];
  L read[12];
  for (int k = 0; k < 16; ++k) forces[k] = zero;
  for (int k = 0; k < 12; ++k) read[k] = zero;
  for (int p = 0; p < in.readings; ++p) {
    const L precision = at(in.precision, p);
    const L q[4] = {one, at(in.f_o, 3 * p), at(in.f_o, 3 * p + 1), at(in.f_o, 3 * p + 2)};
    const L y[3] = {at(in.y_g, 3 * p), at(in.y_g, 3 * p + 1), at(in.y_g, 3 * p + 2)};
    for (int i = 0; i < 4; ++i) {
      const L weighted = precision * q[i];
      for (int j = i; j < 4; ++j) forces[4 * i + j] = forces[4 * i + j] + weighted * q[j];
      for (int j = 0; j < 3; ++j) read[3 * i + j] = read[3 * i + j] + weighted * y[j];
    }
  }
  for (int i = 0; i < 4; ++i) {
    for (int j = 0; j < i; ++j) forces[4 * i + j] = forces[4 * j + i];
  }

  L R[9];
  for (int k = 0; k < 9; ++k) R[k] = at(in.R_start, k);
  turn_kernel::Turn<L> turn;
  L usual = one;
  for (int k = 0; k < options.most_steps; ++k) {
    L half[12];  // 4 x 3, sum of q v^T / V
    for (int i = 0; i < 4; ++i) {
      for (int j = 0; j < 3; ++j) {
        half[3 * i + j] = forces[4 * i + 1] * R[j] + forces[4 * i + 2] * R[3 + j] + forces[4 * i + 3] * R[6 + j];
      }
    }
    L rows[16];
    L mixed[12];
    rows[0] = forces[0];
    for (int j = 0; j < 3; ++j) {
      rows[1 + j] = rows[4 * (1 + j)] = half[j];
      mixed[j] = read[j] - half[j];
    }
    for (int i = 0; i < 3; ++i) {
      for (int j = 0; j < 3; ++j) {
        const L v_v = R[i] * half[3 + j] + R[3 + i] * half[6 + j] + R[6 + i] * half[9 + j];
        rows[4 * (1 + i) + 1 + j] = v_v;
        mixed[3 * (1 + i) + j] = R[i] * read[3 + j] + R[3 + i] * read[6 + j] + R[6 + i] * read[9 + j] - v_v;
      }
    }
    turn_kernel::solve(options.precision, options.least_information, rows, mixed, turn);

    const turn_kernel::Factor<L> of = turn_kernel::factor(turn.information);
    usual = L::select(turn_kernel::isUsual(of, turn.information), usual, zero);
    const L z_0 = turn.gradient[0];
    const L z_1 = turn.gradient[1] - of.l_10 * z_0;
    const L z_2 = turn.gradient[2] - of.l_20 * z_0 - of.l_21 * z_1;
    L step[3];
    step[2] = z_2 / of.d_2;
    step[1] = z_1 / of.d_1 - of.l_21 * step[2];
    step[0] = z_0 / of.d_0 - of.l_10 * step[1] - of.l_20 * step[2];
    const L size = root(step[0] * step[0] + step[1] * step[1] + step[2] * step[2]);
    const L share = L::select(size > L(kLargestStep), L(kLargestStep) / size, one);
    for (L& angle : step) angle = share * angle;
    turnBack(R, step);
    const Mask moves = L::both(size > L(kConverged), usual > zero);
    if (!L::any(moves)) break;
  }

  const auto put = [lane](const L* values, int count, double* to) {
    for (int k = 0; k < count; ++k) values[k].store(to + kLanes * k + lane);
  };
  const int diagonal[3] = {0, 3, 5};
  for (const int k : diagonal) turn.information[k] = turn.information[k] - L(options.least_information);
  put(R, 9, out.R);
  put(turn.information, 6, out.information);
  put(turn.errors, 3, out.offset_g);
  put(turn.gain, 9, out.gain);
  put(&usual, 1, out.usual);
}

}  // namespace attitude_kernel
}  // namespace hexoderm
