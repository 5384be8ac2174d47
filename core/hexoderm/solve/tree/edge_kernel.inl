// The text of the kernel in edge_kernel.h (lanes.inl says what that is).

#include "hexoderm/base/lanes.inl"
#include "hexoderm/solve/tree/edge_kernel.h"

namespace hexoderm {
namespace {

/// Sums over the poses of one way of solving an edge: v are the source's vectors, unit or less their mean.
struct Sums {
  Lanes H[9];       ///< of n v^T
  Lanes square[6];  ///< of v v^T
  Lanes noise[6];   ///< of variance v v^T
  Lanes squares;    ///< traces of these
  Lanes noises;
  Lanes v[3];
  Lanes by_c[9];  ///< of v c^T, with c as it was read
  Lanes by_n[9];

  HEXODERM_INLINE void add(const Lanes* n_fit, const Lanes* v_fit, const Lanes* c, const Lanes* n, Lanes variance) {
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
        const Lanes product = v_fit[i] * v_fit[j];
        square[k] = square[k] + product;
        noise[k] = noise[k] + variance * product;
      }
    }
    const Lanes length = v_fit[0] * v_fit[0] + v_fit[1] * v_fit[1] + v_fit[2] * v_fit[2];
    squares = squares + length;
    noises = noises + variance * length;
  }
};

HEXODERM_INLINE Lanes dot(const Lanes* a, const Lanes* b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }

HEXODERM_INLINE void cross(const Lanes* a, const Lanes* b, Lanes* to) {
  to[0] = a[1] * b[2] - a[2] * b[1];
  to[1] = a[2] * b[0] - a[0] * b[2];
  to[2] = a[0] * b[1] - a[1] * b[0];
}

HEXODERM_INLINE void turnColumns(Lanes* p, Lanes* q, Lanes c, Lanes s) {
  for (int k = 0; k < 3; ++k) {
    const Lanes at_p = p[k];
    p[k] = c * at_p - s * q[k];
    q[k] = s * at_p + c * q[k];
  }
}

/// Columns stand one after the other here. The two at right angles, by one rotation from the right of both A and V, as
/// in solveProcrustes(); false where they are.
HEXODERM_INLINE bool makeOrthogonal(Lanes* A, Lanes* V, int p, int q) {
  constexpr double kRounding = 1e-15;
  constexpr double kNothing = 1e-16;  // beside the longer column the shorter one is rounding
  const Lanes pp = dot(A + 3 * p, A + 3 * p);
  const Lanes qq = dot(A + 3 * q, A + 3 * q);
  const Lanes pq = dot(A + 3 * p, A + 3 * q);
  const Lanes size = absolute(pq);
  const Mask turns = (size > all(kRounding) * rootOf(pp * qq)) & (size > all(kNothing) * (pp + qq));
  if (!any(turns)) return false;
  // tan(2 angle) = w / d, without a quotient.
  const Lanes d = qq - pp;
  const Lanes w = pq + pq;
  const Lanes h = rootOf(d * d + w * w);
  const Lanes g = absolute(d) + h;
  const Lanes r = all(1.0) / rootOf((h + h) * g);
  const Lanes c = turns ? g * r : all(1.0);
  const Lanes s = turns ? withSignOf(all(1.0), d) * w * r : all(0.0);
  turnColumns(A + 3 * p, A + 3 * q, c, s);
  turnColumns(V + 3 * p, V + 3 * q, c, s);
  return true;
}

HEXODERM_INLINE void swapColumns(Mask swap, Lanes* p, Lanes* q) {
  for (int k = 0; k < 3; ++k) {
    const Lanes first = swap ? q[k] : p[k];
    q[k] = swap ? p[k] : q[k];
    p[k] = first;
  }
}

HEXODERM_INLINE void putLonger(Lanes* A, Lanes* V, Lanes* square, int p, int q) {
  const Mask swap = square[q] > square[p];
  const Lanes larger = swap ? square[q] : square[p];
  square[q] = swap ? square[p] : square[q];
  square[p] = larger;
  swapColumns(swap, A + 3 * p, A + 3 * q);
  swapColumns(swap, V + 3 * p, V + 3 * q);
}

/// What makeOrthogonal() left of H = U S V^T: R (row by row), the singular values, and whether two of them are well
/// above 0 and no other rotation is nearly as good.
HEXODERM_INLINE Mask rotationOf(Lanes* A, Lanes* V, Lanes* R, Lanes* singular_values) {
  constexpr double kMinRatio = 1e-3;
  Lanes square[3] = {dot(A, A), dot(A + 3, A + 3), dot(A + 6, A + 6)};
  putLonger(A, V, square, 0, 1);
  putLonger(A, V, square, 1, 2);
  putLonger(A, V, square, 0, 1);
  for (int k = 0; k < 3; ++k) singular_values[k] = rootOf(square[k]);
  Lanes u[6];
  for (int k = 0; k < 2; ++k) {
    const Lanes scale = all(1.0) / singular_values[k];
    for (int i = 0; i < 3; ++i) u[3 * k + i] = A[3 * k + i] * scale;
  }
  Lanes u_3[3];
  Lanes v_3[3];
  cross(u, u + 3, u_3);
  cross(V, V + 3, v_3);
  for (int i = 0; i < 3; ++i) {
    for (int j = 0; j < 3; ++j) R[3 * i + j] = V[i] * u[j] + V[3 + i] * u[3 + j] + v_3[i] * u_3[j];
  }
  const Lanes third = withSignOf(singular_values[2], dot(u_3, A + 6) * dot(v_3, V + 6));
  const Lanes gap = singular_values[1] + third;
  return (singular_values[1] > all(kMinRatio) * singular_values[0]) & (gap > all(kMinRatio) * singular_values[0]);
}

/// Adds the scatter of sum_p v_p x e_p for one cell's sensor errors but the offset; `T`: sum_p v_p x_p^T, row by row,
/// `basis`: the cell's axes in the columns.
HEXODERM_INLINE void addSensor(const EdgeKernelOptions& options, const Lanes* T, const Lanes* basis, Lanes* scatter) {
  Lanes square = all(0.0);
  for (int k = 0; k < 9; ++k) square = square + T[k] * T[k];
  const Lanes cross_axis = all(options.cross_axis_variance);
  const Lanes beyond = all(options.scale_variance - options.cross_axis_variance);
  Lanes moment[9];
  for (int i = 0; i < 3; ++i) {
    const Lanes column[3] = {T[i], T[3 + i], T[6 + i]};
    const Lanes axis[3] = {basis[i], basis[3 + i], basis[6 + i]};
    cross(column, axis, moment + 3 * i);
  }
  int k = 0;
  for (int i = 0; i < 3; ++i) {
    for (int j = i; j < 3; ++j, ++k) {
      const Lanes product = T[3 * i] * T[3 * j] + T[3 * i + 1] * T[3 * j + 1] + T[3 * i + 2] * T[3 * j + 2];
      const Lanes moments = moment[i] * moment[j] + moment[3 + i] * moment[3 + j] + moment[6 + i] * moment[6 + j];
      scatter[k] =
          scatter[k] + (i == j ? cross_axis * (square - product) : all(0.0) - cross_axis * product) + beyond * moments;
    }
  }
}

/// The inverse of the information that vectors hold about a rotation. False where they hold hardly any about some axis.
HEXODERM_INLINE Mask invertInformation(double support, Lanes squares, const Lanes* square, Lanes* inverse) {
  const Lanes zero = all(0.0);
  const Lanes trace = squares + all(support);
  const Lanes a = trace - square[0];
  const Lanes b = zero - square[1];
  const Lanes c = zero - square[2];
  const Lanes d = trace - square[3];
  const Lanes e = zero - square[4];
  const Lanes f = trace - square[5];
  const Lanes minors[6] = {d * f - e * e, c * e - b * f, b * e - c * d, a * f - c * c, b * c - a * e, a * d - b * b};
  const Lanes determinant = a * minors[0] + b * minors[1] + c * minors[2];
  const Lanes scale = all(1.0) / determinant;
  for (int k = 0; k < 6; ++k) inverse[k] = minors[k] * scale;
  constexpr double kMinDeterminant = 1e-9;
  return determinant > all(kMinDeterminant) * trace * trace * trace;
}

/// Scatter of sum_p v_p x e_p by noise, and by the offsets of sensors with this variance together.
HEXODERM_INLINE void startScatter(double offset_variance_g2, Lanes noises, const Lanes* noise, const Lanes* v,
                                  Lanes* scatter) {
  const Lanes offset = all(offset_variance_g2);
  const Lanes diagonal = noises + offset * dot(v, v);
  int k = 0;
  for (int i = 0; i < 3; ++i) {
    for (int j = i; j < 3; ++j, ++k) {
      scatter[k] = (i == j ? diagonal : all(0.0)) - noise[k] - offset * v[i] * v[j];
    }
  }
}

/// Adds the scatter of sum_p v_p x (I - R) b by an offset b that both cells have; (I - R)(I - R)^T = 2 I - R - R^T.
HEXODERM_INLINE void addSharedOffset(double variance_g2, const Lanes* v, const Lanes* R, Lanes* scatter) {
  const Lanes variance = all(variance_g2);
  Lanes left[9];  // [v]x (I - R)(I - R)^T, column by column
  for (int j = 0; j < 3; ++j) {
    Lanes column[3];
    for (int i = 0; i < 3; ++i) {
      column[i] = variance * (all(i == j ? 2.0 : 0.0) - R[3 * i + j] - R[3 * j + i]);
    }
    cross(v, column, left + 3 * j);
  }
  int k = 0;
  for (int i = 0; i < 3; ++i) {
    const Lanes row[3] = {left[i], left[3 + i], left[6 + i]};
    Lanes product[3];  // row i of left [v]x^T: v x row
    cross(v, row, product);
    for (int j = i; j < 3; ++j, ++k) scatter[k] = scatter[k] + product[j];
  }
}

/// A S A of two symmetric matrices.
HEXODERM_INLINE void multiplyBothSides(const Lanes* A, const Lanes* S, Lanes* product) {
  constexpr int at[9] = {0, 1, 2, 1, 3, 4, 2, 4, 5};
  Lanes half[9];  // S A
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
HEXODERM_INLINE Mask predict(const EdgeKernelOptions& options, const Sums& sums, const Lanes* R, Lanes* covariance,
                             Lanes* prior_part) {
  const Lanes one = all(1.0);
  const Lanes zero = all(0.0);
  Lanes inverse[6];
  const Mask is_known = invertInformation(options.support, sums.squares, sums.square, inverse);
  const Lanes identity[9] = {one, zero, zero, zero, one, zero, zero, zero, one};
  Lanes scatter[6];
  startScatter(2 * options.offset_variance_g2, sums.noises, sums.noise, sums.v, scatter);  // of both cells
  addSensor(options, sums.by_c, identity, scatter);
  addSensor(options, sums.by_n, R, scatter);
  if (options.shared_offset_variance_g2 > 0) addSharedOffset(options.shared_offset_variance_g2, sums.v, R, scatter);
  multiplyBothSides(inverse, scatter, covariance);
  const Lanes prior = all(options.support * options.support * options.prior_variance);
  const Lanes unit[6] = {prior, zero, zero, prior, zero, prior};
  multiplyBothSides(inverse, unit, prior_part);
  for (int k = 0; k < 6; ++k) covariance[k] = covariance[k] + prior_part[k];
  return is_known;
}

/// atan(t) / t, for 0 <= t <= kMaxTangent.
constexpr double kMaxTangent = 0.25;
HEXODERM_INLINE Lanes arcTangentShare(Lanes t) {
  constexpr int kTerms = 13;
  const Lanes minus_square = all(0.0) - t * t;
  Lanes sum = all(1.0 / (2 * kTerms + 1));
  for (int k = kTerms - 1; k >= 0; --k) sum = all(1.0 / (2 * k + 1)) + minus_square * sum;
  return sum;
}

/// Everything for kWidth lanes from `lane` on.
HEXODERM_INLINE void estimate(const EdgeKernelOptions& options, const EdgeKernelInput& in, int lane,
                              EdgeKernelOutput& out) {
  const auto at = [lane](const double* values, int k) { return load(values + kLanes * k + lane); };
  const Lanes one = all(1.0);
  const Lanes zero = all(0.0);
  constexpr double kMinSquare = 1e-12;

  // Both ways of solving the edge: 0 by unit vectors, 1 less the mean.
  Sums sums[2] = {};
  Lanes mean_c[3] = {zero, zero, zero};
  Lanes mean_n[3] = {zero, zero, zero};
  Lanes shortest = one;
  for (int p = 0; p < in.poses; ++p) {
    const Lanes c[3] = {at(in.c_g, 3 * p), at(in.c_g, 3 * p + 1), at(in.c_g, 3 * p + 2)};
    const Lanes n[3] = {at(in.n_g, 3 * p), at(in.n_g, 3 * p + 1), at(in.n_g, 3 * p + 2)};
    const Lanes square_c = dot(c, c);
    const Lanes square_n = dot(n, n);
    shortest = square_c > shortest ? shortest : square_c;
    shortest = square_n > shortest ? shortest : square_n;
    const Lanes scale_c = one / rootOf(square_c);
    const Lanes scale_n = one / rootOf(square_n);
    const Lanes unit_c[3] = {c[0] * scale_c, c[1] * scale_c, c[2] * scale_c};
    const Lanes unit_n[3] = {n[0] * scale_n, n[1] * scale_n, n[2] * scale_n};
    sums[0].add(unit_n, unit_c, c, n, at(in.variance_g2, p));
    for (int k = 0; k < 3; ++k) {
      mean_c[k] = mean_c[k] + c[k];
      mean_n[k] = mean_n[k] + n[k];
    }
  }
  const Lanes share = all(1.0 / in.poses);
  for (int k = 0; k < 3; ++k) {
    mean_c[k] = mean_c[k] * share;
    mean_n[k] = mean_n[k] * share;
  }
  if (options.centre) {
    for (int p = 0; p < in.poses; ++p) {
      const Lanes c[3] = {at(in.c_g, 3 * p), at(in.c_g, 3 * p + 1), at(in.c_g, 3 * p + 2)};
      const Lanes n[3] = {at(in.n_g, 3 * p), at(in.n_g, 3 * p + 1), at(in.n_g, 3 * p + 2)};
      const Lanes own_c[3] = {c[0] - mean_c[0], c[1] - mean_c[1], c[2] - mean_c[2]};
      const Lanes own_n[3] = {n[0] - mean_n[0], n[1] - mean_n[1], n[2] - mean_n[2]};
      sums[1].add(own_n, own_c, c, n, at(in.variance_g2, p));
    }
  }

  // H stands row by row, and its columns are wanted. Both at once, for each alone waits for its own roots.
  const int ways = options.centre ? 2 : 1;
  Lanes A[2][9];
  Lanes V[2][9];
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
  Lanes R[9];
  Lanes singular_values[3];
  Lanes covariance[6];
  Lanes prior_part[6];
  Mask usual = rotationOf(A[0], V[0], R, singular_values) & (shortest > all(kMinSquare));
  usual = usual & predict(options, sums[0], R, covariance, prior_part);
  Lanes centred = zero;
  if (options.centre) {
    Lanes R_centred[9];
    Lanes unused[3];
    Lanes covariance_centred[6];
    Lanes prior_centred[6];
    usual = usual & rotationOf(A[1], V[1], R_centred, unused);
    usual = usual & predict(options, sums[1], R_centred, covariance_centred, prior_centred);
    const Lanes trace = covariance[0] + covariance[3] + covariance[5];
    const Lanes trace_centred = covariance_centred[0] + covariance_centred[3] + covariance_centred[5];
    const Mask better = options.always_centre ? one > zero : trace > trace_centred;
    centred = better ? one : zero;
    for (int k = 0; k < 9; ++k) R[k] = better ? R_centred[k] : R[k];
    for (int k = 0; k < 6; ++k) {
      covariance[k] = better ? covariance_centred[k] : covariance[k];
      prior_part[k] = better ? prior_centred[k] : prior_part[k];
    }
  }

  Lanes sum = zero;
  Lanes expected = zero;
  Lanes weights = zero;
  const Lanes offset = (one - centred) * all(options.offset_variance_g2);
  const Lanes shared =
      (one - centred) * all(options.shared_offset_variance_g2) * (all(2.0) - all(2.0 / 3.0) * (R[0] + R[4] + R[8]));
  const Lanes sensors = all(2.0) * (offset + all(options.scale_variance + options.cross_axis_variance)) + shared;
  for (int p = 0; p < in.poses; ++p) {
    Lanes c[3];
    Lanes n[3];
    Lanes turned[3];
    for (int k = 0; k < 3; ++k) {
      c[k] = at(in.c_g, 3 * p + k) - centred * mean_c[k];
      n[k] = at(in.n_g, 3 * p + k) - centred * mean_n[k];
    }
    for (int k = 0; k < 3; ++k) turned[k] = R[3 * k] * n[0] + R[3 * k + 1] * n[1] + R[3 * k + 2] * n[2];
    const Lanes square_c = dot(c, c);
    const Lanes square_n = dot(n, n);
    const Lanes square = square_c > square_n ? square_n : square_c;
    const Mask long_enough = rootOf(square) > all(options.shortest_g);
    Lanes across[3];
    cross(c, turned, across);
    const Lanes cosine = dot(c, turned);
    const Lanes sine_square = dot(across, across);
    const Lanes sine = rootOf(sine_square);
    // tan of half the angle, so that right angles are nothing special.
    const Lanes tangent = sine / (rootOf(sine_square + cosine * cosine) + cosine);
    Lanes angle = all(2.0) * tangent * arcTangentShare(tangent);
    angle = long_enough ? angle : zero;
    const Lanes checked = long_enough ? tangent : zero;
    usual = usual & (all(kMaxTangent) > checked);
    const Lanes per_axis = at(in.variance_g2, p) + sensors;
    const Lanes least = all(options.least_variance_g2);
    const Lanes weight = long_enough ? one / (per_axis > least ? per_axis : least) : zero;
    sum = sum + weight * angle * angle;
    expected = expected + (long_enough ? weight * all(2.0) * per_axis / square : zero);
    weights = weights + weight;
    store(out.pose_residual_rad + kLanes * p + lane, angle);
  }
  const Mask weighed = weights > zero;
  store(out.residual_rad + lane, weighed ? rootOf(sum / weights) : zero);
  store(out.expected_residual_rad + lane, weighed ? rootOf(expected / weights) : zero);

  // The rotation vector of D = R_c_n R_nom^T: its antisymmetric part is 2 sin(angle) times the axis.
  Lanes D[9];
  for (int i = 0; i < 3; ++i) {
    for (int j = 0; j < 3; ++j) {
      D[3 * i + j] = R[3 * i] * at(in.R_nom, 3 * j) + R[3 * i + 1] * at(in.R_nom, 3 * j + 1) +
                     R[3 * i + 2] * at(in.R_nom, 3 * j + 2);
    }
  }
  Lanes w[3] = {D[7] - D[5], D[2] - D[6], D[3] - D[1]};
  const Lanes trace_and_one = one + D[0] + D[4] + D[8];
  const Lanes tangent = rootOf(dot(w, w)) / trace_and_one;
  const Lanes stretch = all(0.5) * (one + tangent * tangent) * arcTangentShare(tangent);
  for (int k = 0; k < 3; ++k) w[k] = w[k] * stretch;
  const Lanes u[3] = {at(in.outward, 0), at(in.outward, 1), at(in.outward, 2)};
  const Lanes level = levelPart(u[0], u[1], u[2]);  // the axes are those of linkAxes()
  store(out.angles_rad + lane, dot(w, u));
  store(out.angles_rad + kLanes + lane, (w[1] * u[0] - w[0] * u[1]) / level);
  store(out.angles_rad + 2 * kLanes + lane, level * w[2] - u[2] / level * (w[0] * u[0] + w[1] * u[1]));
  const Mask has_angles = (trace_and_one > one) & (all(kMaxTangent) > tangent);
  store(out.has_angles + lane, has_angles ? one : zero);

  for (int k = 0; k < 9; ++k) store(out.R_c_n + kLanes * k + lane, R[k]);
  for (int k = 0; k < 3; ++k) store(out.singular_values + kLanes * k + lane, singular_values[k]);
  for (int k = 0; k < 6; ++k) {
    store(out.covariance + kLanes * k + lane, covariance[k]);
    store(out.prior_part + kLanes * k + lane, prior_part[k]);
  }
  store(out.centred + lane, centred);
  store(out.usual + lane, usual ? one : zero);
}

}  // namespace
}  // namespace hexoderm
