#pragma once

// Private to links: the rotations of kLanes usual links at a time, as estimateEdgeRotation() has them.

#include "hexoderm/geometry/lanes.h"

namespace hexoderm {

/// What all links of a reconstruction have in common.
struct EdgeKernelOptions {
  double offset_variance_g2 = 0;  ///< of the accelerometer's errors
  double scale_variance = 0;
  double cross_axis_variance = 0;
  double support = 0;         ///< information that keeps the equations solvable
  double prior_variance = 0;  ///< of an unknown angle, rad^2
  double shortest_g = 0;      ///< a shorter vector has no direction worth comparing
  double least_variance_g2 = 0;
  bool centre = false;         ///< solve centred too, and take what has the smaller variance
  bool always_centre = false;  ///< take the centred solution
};

/// Numbers of kLanes links side by side: value k of lane l is at [kLanes * k + l].
struct EdgeKernelInput {
  int poses = 0;
  const double* c_g = nullptr;          ///< poses x 3, source cell
  const double* n_g = nullptr;          ///< poses x 3, target cell
  const double* variance_g2 = nullptr;  ///< poses
  const double* R_nom = nullptr;        ///< 9, row by row: the nominal alignment
  const double* outward = nullptr;      ///< 3: unit vector of the source's port
};
/// Symmetric matrices are xx, xy, xz, yy, yz, zz.
struct EdgeKernelOutput {
  double R_c_n[9 * kLanes];
  double singular_values[3 * kLanes];
  double covariance[6 * kLanes];
  double prior_part[6 * kLanes];
  double centred[kLanes];  ///< 1 or 0
  double residual_rad[kLanes];
  double expected_residual_rad[kLanes];
  double angles_rad[3 * kLanes];        ///< twist, bend, yaw
  double has_angles[kLanes];            ///< 1, or 0 where they are too large
  double usual[kLanes];                 ///< 1, or 0 where the link needs a more careful look: nothing else counts then
  double* pose_residual_rad = nullptr;  ///< poses x kLanes
};

/// One link after the other, on any computer.
void estimateEdgesByOne(const EdgeKernelOptions& options, const EdgeKernelInput& in, EdgeKernelOutput& out);
/// All at once; only where hasFourLanes().
void estimateEdgesByFour(const EdgeKernelOptions& options, const EdgeKernelInput& in, EdgeKernelOutput& out);

namespace edge_kernel {

/// Sums over the poses of one way of solving an edge: v are the source's vectors, unit or less their mean.
template <class L>
struct Sums {
  L H[9];       ///< of n v^T
  L square[6];  ///< of v v^T
  L noise[6];   ///< of variance v v^T
  L squares;    ///< traces of these
  L noises;
  L v[3];
  L by_c[9];  ///< of v c^T, with c as it was read
  L by_n[9];

  HEXODERM_LANES_INLINE void clear() {
    for (int k = 0; k < 9; ++k) H[k] = by_c[k] = by_n[k] = L(0.0);
    for (int k = 0; k < 6; ++k) square[k] = noise[k] = L(0.0);
    for (int k = 0; k < 3; ++k) v[k] = L(0.0);
    squares = noises = L(0.0);
  }

  HEXODERM_LANES_INLINE void add(const L* n_fit, const L* v_fit, const L* c, const L* n, L variance) {
    for (int i = 0; i < 3; ++i) {
      for (int j = 0; j < 3; ++j) {
        H[3 * i + j] = H[3 * i + j] + n_fit[i] * v_fit[j];
        by_c[3 * i + j] = by_c[3 * i + j] + v_fit[i] * c[j];
        by_n[3 * i + j] = by_n[3 * i + j] + v_fit[i] * n[j];
      }
      v[i] = v[i] + v_fit[i];
    }
    int k = 0;
    for (int i = 0; i < 3; ++i) {
      for (int j = i; j < 3; ++j, ++k) {
        const L product = v_fit[i] * v_fit[j];
        square[k] = square[k] + product;
        noise[k] = noise[k] + variance * product;
      }
    }
    const L length = v_fit[0] * v_fit[0] + v_fit[1] * v_fit[1] + v_fit[2] * v_fit[2];
    squares = squares + length;
    noises = noises + variance * length;
  }
};

template <class L>
HEXODERM_LANES_INLINE L dot(const L* a, const L* b) {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

template <class L>
HEXODERM_LANES_INLINE void cross(const L* a, const L* b, L* to) {
  to[0] = a[1] * b[2] - a[2] * b[1];
  to[1] = a[2] * b[0] - a[0] * b[2];
  to[2] = a[0] * b[1] - a[1] * b[0];
}

template <class L>
HEXODERM_LANES_INLINE void turnColumns(L* p, L* q, L c, L s) {
  for (int k = 0; k < 3; ++k) {
    const L at_p = p[k];
    p[k] = c * at_p - s * q[k];
    q[k] = s * at_p + c * q[k];
  }
}

/// Columns stand one after the other here. The two at right angles, by one rotation from the right of both A and V, as
/// in solveProcrustes(); false where they are.
template <class L>
HEXODERM_LANES_INLINE bool makeOrthogonal(L* A, L* V, int p, int q) {
  constexpr double kRounding = 1e-15;
  constexpr double kNothing = 1e-16;  // beside the longer column the shorter one is rounding
  const L pp = dot(A + 3 * p, A + 3 * p);
  const L qq = dot(A + 3 * q, A + 3 * q);
  const L pq = dot(A + 3 * p, A + 3 * q);
  const L size = absolute(pq);
  const typename L::Mask turns = L::both(size > L(kRounding) * root(pp * qq), size > L(kNothing) * (pp + qq));
  if (!L::any(turns)) return false;
  // tan(2 angle) = w / d, without a quotient.
  const L d = qq - pp;
  const L w = pq + pq;
  const L h = root(d * d + w * w);
  const L g = absolute(d) + h;
  const L r = L(1.0) / root((h + h) * g);
  const L c = L::select(turns, g * r, L(1.0));
  const L s = L::select(turns, withSignOf(L(1.0), d) * w * r, L(0.0));
  turnColumns(A + 3 * p, A + 3 * q, c, s);
  turnColumns(V + 3 * p, V + 3 * q, c, s);
  return true;
}

template <class L>
HEXODERM_LANES_INLINE void swapColumns(typename L::Mask swap, L* p, L* q) {
  for (int k = 0; k < 3; ++k) {
    const L first = L::select(swap, q[k], p[k]);
    q[k] = L::select(swap, p[k], q[k]);
    p[k] = first;
  }
}

template <class L>
HEXODERM_LANES_INLINE void putLonger(L* A, L* V, L* square, int p, int q) {
  const typename L::Mask swap = square[q] > square[p];
  const L larger = L::select(swap, square[q], square[p]);
  square[q] = L::select(swap, square[p], square[q]);
  square[p] = larger;
  swapColumns(swap, A + 3 * p, A + 3 * q);
  swapColumns(swap, V + 3 * p, V + 3 * q);
}

/// What makeOrthogonal() left of H = U S V^T: R (row by row), the singular values, and whether two of them are well
/// above 0 and no other rotation is nearly as good.
template <class L>
HEXODERM_LANES_INLINE typename L::Mask rotationOf(L* A, L* V, L* R, L* singular_values) {
  constexpr double kLeastRatio = 1e-3;
  L square[3] = {dot(A, A), dot(A + 3, A + 3), dot(A + 6, A + 6)};
  putLonger(A, V, square, 0, 1);
  putLonger(A, V, square, 1, 2);
  putLonger(A, V, square, 0, 1);
  for (int k = 0; k < 3; ++k) singular_values[k] = root(square[k]);
  L u[6];
  for (int k = 0; k < 2; ++k) {
    const L scale = L(1.0) / singular_values[k];
    for (int i = 0; i < 3; ++i) u[3 * k + i] = A[3 * k + i] * scale;
  }
  L u_3[3];
  L v_3[3];
  cross(u, u + 3, u_3);
  cross(V, V + 3, v_3);
  for (int i = 0; i < 3; ++i) {
    for (int j = 0; j < 3; ++j) R[3 * i + j] = V[i] * u[j] + V[3 + i] * u[3 + j] + v_3[i] * u_3[j];
  }
  const L third = withSignOf(singular_values[2], dot(u_3, A + 6) * dot(v_3, V + 6));
  const L gap = singular_values[1] + third;
  return L::both(singular_values[1] > L(kLeastRatio) * singular_values[0], gap > L(kLeastRatio) * singular_values[0]);
}

/// Adds the scatter of sum_p v_p x e_p for one cell's sensor errors but the offset; `T`: sum_p v_p x_p^T, row by row,
/// `basis`: the cell's axes in the columns.
template <class L>
HEXODERM_LANES_INLINE void addSensor(const EdgeKernelOptions& options, const L* T, const L* basis, L* scatter) {
  L square(0.0);
  for (int k = 0; k < 9; ++k) square = square + T[k] * T[k];
  const L cross_axis(options.cross_axis_variance);
  const L beyond(options.scale_variance - options.cross_axis_variance);
  L moment[9];
  for (int i = 0; i < 3; ++i) {
    const L column[3] = {T[i], T[3 + i], T[6 + i]};
    const L axis[3] = {basis[i], basis[3 + i], basis[6 + i]};
    cross(column, axis, moment + 3 * i);
  }
  int k = 0;
  for (int i = 0; i < 3; ++i) {
    for (int j = i; j < 3; ++j, ++k) {
      const L product = T[3 * i] * T[3 * j] + T[3 * i + 1] * T[3 * j + 1] + T[3 * i + 2] * T[3 * j + 2];
      const L moments = moment[i] * moment[j] + moment[3 + i] * moment[3 + j] + moment[6 + i] * moment[6 + j];
      scatter[k] =
          scatter[k] + (i == j ? cross_axis * (square - product) : L(0.0) - cross_axis * product) + beyond * moments;
    }
  }
}

/// The inverse of the information that vectors hold about a rotation. False where they hold hardly any about some axis.
template <class L>
HEXODERM_LANES_INLINE typename L::Mask invertInformation(double support, L squares, const L* square, L* inverse) {
  const L zero(0.0);
  const L trace = squares + L(support);
  const L a = trace - square[0];
  const L b = zero - square[1];
  const L c = zero - square[2];
  const L d = trace - square[3];
  const L e = zero - square[4];
  const L f = trace - square[5];
  const L minors[6] = {d * f - e * e, c * e - b * f, b * e - c * d, a * f - c * c, b * c - a * e, a * d - b * b};
  const L determinant = a * minors[0] + b * minors[1] + c * minors[2];
  const L scale = L(1.0) / determinant;
  for (int k = 0; k < 6; ++k) inverse[k] = minors[k] * scale;
  constexpr double kLeastDeterminant = 1e-9;
  return determinant > L(kLeastDeterminant) * trace * trace * trace;
}

/// Scatter of sum_p v_p x e_p by noise, and by the offsets of sensors with this variance together.
template <class L>
HEXODERM_LANES_INLINE void startScatter(double offset_variance_g2, L noises, const L* noise, const L* v, L* scatter) {
  const L offset(offset_variance_g2);
  const L diagonal = noises + offset * dot(v, v);
  int k = 0;
  for (int i = 0; i < 3; ++i) {
    for (int j = i; j < 3; ++j, ++k) {
      scatter[k] = (i == j ? diagonal : L(0.0)) - noise[k] - offset * v[i] * v[j];
    }
  }
}

/// A S A of two symmetric matrices.
template <class L>
HEXODERM_LANES_INLINE void multiplyBothSides(const L* A, const L* S, L* product) {
  constexpr int at[9] = {0, 1, 2, 1, 3, 4, 2, 4, 5};
  L half[9];  // S A
  for (int i = 0; i < 3; ++i) {
    for (int j = 0; j < 3; ++j) {
      half[3 * i + j] = S[at[3 * i]] * A[at[j]] + S[at[3 * i + 1]] * A[at[3 + j]] + S[at[3 * i + 2]] * A[at[6 + j]];
    }
  }
  int k = 0;
  for (int i = 0; i < 3; ++i) {
    for (int j = i; j < 3; ++j, ++k) {
      product[k] = A[at[3 * i]] * half[j] + A[at[3 * i + 1]] * half[3 + j] + A[at[3 * i + 2]] * half[6 + j];
    }
  }
}

/// First-order covariance of the rotation, and the part of it that the prior stands for. False where nothing determines
/// it.
template <class L>
HEXODERM_LANES_INLINE typename L::Mask predict(const EdgeKernelOptions& options, const Sums<L>& sums, const L* R,
                                               L* covariance, L* prior_part) {
  const L one(1.0);
  const L zero(0.0);
  L inverse[6];
  const typename L::Mask is_known = invertInformation(options.support, sums.squares, sums.square, inverse);
  const L identity[9] = {one, zero, zero, zero, one, zero, zero, zero, one};
  L scatter[6];
  startScatter(2 * options.offset_variance_g2, sums.noises, sums.noise, sums.v, scatter);  // of both cells
  addSensor(options, sums.by_c, identity, scatter);
  addSensor(options, sums.by_n, R, scatter);
  multiplyBothSides(inverse, scatter, covariance);
  const L prior(options.support * options.support * options.prior_variance);
  const L unit[6] = {prior, zero, zero, prior, zero, prior};
  multiplyBothSides(inverse, unit, prior_part);
  for (int k = 0; k < 6; ++k) covariance[k] = covariance[k] + prior_part[k];
  return is_known;
}

/// atan(t) / t, for 0 <= t <= kMostTangent.
constexpr double kMostTangent = 0.25;
template <class L>
HEXODERM_LANES_INLINE L arcTangentShare(L t) {
  constexpr int kTerms = 13;
  const L minus_square = L(0.0) - t * t;
  L sum(1.0 / (2 * kTerms + 1));
  for (int k = kTerms - 1; k >= 0; --k) sum = L(1.0 / (2 * k + 1)) + minus_square * sum;
  return sum;
}

/// Everything for the lanes from `lane` on, as many as L has.
template <class L>
HEXODERM_LANES_INLINE void estimate(const EdgeKernelOptions& options, const EdgeKernelInput& in, int lane,
                                    EdgeKernelOutput& out) {
  using Mask = typename L::Mask;
  const auto at = [lane](const double* values, int k) { return L::load(values + kLanes * k + lane); };
  const L one(1.0);
  const L zero(0.0);
  constexpr double kLeastSquare = 1e-12;

  // Both ways of solving the edge: 0 by unit vectors, 1 less the mean.
  Sums<L> sums[2];
  sums[0].clear();
  sums[1].clear();
  L mean_c[3] = {zero, zero, zero};
  L mean_n[3] = {zero, zero, zero};
  L shortest = one;
  for (int p = 0; p < in.poses; ++p) {
    const L c[3] = {at(in.c_g, 3 * p), at(in.c_g, 3 * p + 1), at(in.c_g, 3 * p + 2)};
    const L n[3] = {at(in.n_g, 3 * p), at(in.n_g, 3 * p + 1), at(in.n_g, 3 * p + 2)};
    const L square_c = dot(c, c);
    const L square_n = dot(n, n);
    shortest = L::select(square_c > shortest, shortest, square_c);
    shortest = L::select(square_n > shortest, shortest, square_n);
    const L scale_c = one / root(square_c);
    const L scale_n = one / root(square_n);
    const L unit_c[3] = {c[0] * scale_c, c[1] * scale_c, c[2] * scale_c};
    const L unit_n[3] = {n[0] * scale_n, n[1] * scale_n, n[2] * scale_n};
    sums[0].add(unit_n, unit_c, c, n, at(in.variance_g2, p));
    for (int k = 0; k < 3; ++k) {
      mean_c[k] = mean_c[k] + c[k];
      mean_n[k] = mean_n[k] + n[k];
    }
  }
  const L share(1.0 / in.poses);
  for (int k = 0; k < 3; ++k) {
    mean_c[k] = mean_c[k] * share;
    mean_n[k] = mean_n[k] * share;
  }
  if (options.centre) {
    for (int p = 0; p < in.poses; ++p) {
      const L c[3] = {at(in.c_g, 3 * p), at(in.c_g, 3 * p + 1), at(in.c_g, 3 * p + 2)};
      const L n[3] = {at(in.n_g, 3 * p), at(in.n_g, 3 * p + 1), at(in.n_g, 3 * p + 2)};
      const L own_c[3] = {c[0] - mean_c[0], c[1] - mean_c[1], c[2] - mean_c[2]};
      const L own_n[3] = {n[0] - mean_n[0], n[1] - mean_n[1], n[2] - mean_n[2]};
      sums[1].add(own_n, own_c, c, n, at(in.variance_g2, p));
    }
  }

  // H stands row by row, and its columns are wanted. Both at once, for each alone waits for its own roots.
  const int ways = options.centre ? 2 : 1;
  L A[2][9];
  L V[2][9];
  for (int way = 0; way < 2; ++way) {
    for (int i = 0; i < 3; ++i) {
      for (int j = 0; j < 3; ++j) {
        A[way][3 * j + i] = sums[way].H[3 * i + j];
        V[way][3 * j + i] = i == j ? one : zero;
      }
    }
  }
  constexpr int kSweeps = 6;
  for (int sweep = 0; sweep < kSweeps; ++sweep) {
    bool turned = false;
    for (int pair = 0; pair < 3; ++pair) {
      const int p = pair == 2 ? 1 : 0;
      const int q = pair == 0 ? 1 : 2;
      for (int way = 0; way < ways; ++way) turned = makeOrthogonal(A[way], V[way], p, q) || turned;
    }
    if (!turned) break;
  }
  L R[9];
  L singular_values[3];
  L covariance[6];
  L prior_part[6];
  Mask usual = L::both(rotationOf(A[0], V[0], R, singular_values), shortest > L(kLeastSquare));
  usual = L::both(usual, predict(options, sums[0], R, covariance, prior_part));
  L centred = zero;
  if (options.centre) {
    L R_centred[9];
    L unused[3];
    L covariance_centred[6];
    L prior_centred[6];
    usual = L::both(usual, rotationOf(A[1], V[1], R_centred, unused));
    usual = L::both(usual, predict(options, sums[1], R_centred, covariance_centred, prior_centred));
    const L trace = covariance[0] + covariance[3] + covariance[5];
    const L trace_centred = covariance_centred[0] + covariance_centred[3] + covariance_centred[5];
    const Mask better = options.always_centre ? one > zero : trace > trace_centred;
    centred = L::select(better, one, zero);
    for (int k = 0; k < 9; ++k) R[k] = L::select(better, R_centred[k], R[k]);
    for (int k = 0; k < 6; ++k) {
      covariance[k] = L::select(better, covariance_centred[k], covariance[k]);
      prior_part[k] = L::select(better, prior_centred[k], prior_part[k]);
    }
  }

  L sum = zero;
  L expected = zero;
  L weights = zero;
  const L offset = (one - centred) * L(options.offset_variance_g2);
  const L sensors = L(2.0) * (offset + L(options.scale_variance + options.cross_axis_variance));
  for (int p = 0; p < in.poses; ++p) {
    L c[3];
    L n[3];
    L turned[3];
    for (int k = 0; k < 3; ++k) {
      c[k] = at(in.c_g, 3 * p + k) - centred * mean_c[k];
      n[k] = at(in.n_g, 3 * p + k) - centred * mean_n[k];
    }
    for (int k = 0; k < 3; ++k) turned[k] = R[3 * k] * n[0] + R[3 * k + 1] * n[1] + R[3 * k + 2] * n[2];
    const L square_c = dot(c, c);
    const L square_n = dot(n, n);
    const L square = L::select(square_c > square_n, square_n, square_c);
    const Mask long_enough = root(square) > L(options.shortest_g);
    L across[3];
    cross(c, turned, across);
    const L cosine = dot(c, turned);
    const L sine_square = dot(across, across);
    const L sine = root(sine_square);
    // tan of half the angle, so that right angles are nothing special.
    const L tangent = sine / (root(sine_square + cosine * cosine) + cosine);
    L angle = L(2.0) * tangent * arcTangentShare(tangent);
    angle = L::select(long_enough, angle, zero);
    const L checked = L::select(long_enough, tangent, zero);
    usual = L::both(usual, L(kMostTangent) > checked);
    const L per_axis = at(in.variance_g2, p) + sensors;
    const L least(options.least_variance_g2);
    const L weight = L::select(long_enough, one / L::select(per_axis > least, per_axis, least), zero);
    sum = sum + weight * angle * angle;
    expected = expected + L::select(long_enough, weight * L(2.0) * per_axis / square, zero);
    weights = weights + weight;
    angle.store(out.pose_residual_rad + kLanes * p + lane);
  }
  const Mask weighed = weights > zero;
  L::select(weighed, root(sum / weights), zero).store(out.residual_rad + lane);
  L::select(weighed, root(expected / weights), zero).store(out.expected_residual_rad + lane);

  // The rotation vector of D = R_c_n R_nom^T: its antisymmetric part is 2 sin(angle) times the axis.
  L D[9];
  for (int i = 0; i < 3; ++i) {
    for (int j = 0; j < 3; ++j) {
      D[3 * i + j] = R[3 * i] * at(in.R_nom, 3 * j) + R[3 * i + 1] * at(in.R_nom, 3 * j + 1) +
                     R[3 * i + 2] * at(in.R_nom, 3 * j + 2);
    }
  }
  L w[3] = {D[7] - D[5], D[2] - D[6], D[3] - D[1]};
  const L trace_and_one = one + D[0] + D[4] + D[8];
  const L tangent = root(dot(w, w)) / trace_and_one;
  const L stretch = L(0.5) * (one + tangent * tangent) * arcTangentShare(tangent);
  for (int k = 0; k < 3; ++k) w[k] = w[k] * stretch;
  const L u[3] = {at(in.outward, 0), at(in.outward, 1), at(in.outward, 2)};
  dot(w, u).store(out.angles_rad + lane);
  (w[1] * u[0] - w[0] * u[1]).store(out.angles_rad + kLanes + lane);
  w[2].store(out.angles_rad + 2 * kLanes + lane);
  L::select(L::both(trace_and_one > one, L(kMostTangent) > tangent), one, zero).store(out.has_angles + lane);

  for (int k = 0; k < 9; ++k) R[k].store(out.R_c_n + kLanes * k + lane);
  for (int k = 0; k < 3; ++k) singular_values[k].store(out.singular_values + kLanes * k + lane);
  for (int k = 0; k < 6; ++k) {
    covariance[k].store(out.covariance + kLanes * k + lane);
    prior_part[k].store(out.prior_part + kLanes * k + lane);
  }
  centred.store(out.centred + lane);
  L::select(usual, one, zero).store(out.usual + lane);
}

}  // namespace edge_kernel
}  // namespace hexoderm
