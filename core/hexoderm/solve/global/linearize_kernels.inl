// The text of the kernels in linearize_kernels.h (lanes.inl says what that is), with kWidth cells or links in a
// vector.

#include "hexoderm/base/lanes.inl"
#include "hexoderm/solve/global/linearize_kernels.h"

namespace hexoderm {
namespace {

inline Lanes load(const double* numbers, std::size_t element) { return load(numbers + element * kWidth); }
inline void store(double* numbers, std::size_t element, Lanes values) { store(numbers + element * kWidth, values); }
inline void add(double* numbers, std::size_t element, Lanes values) {
  store(numbers, element, load(numbers, element) + values);
}
inline Lanes angleOf(Lanes y, Lanes x) {
  Lanes angles;
  for (int k = 0; k < kWidth; ++k) angles[k] = __builtin_atan2(y[k], x[k]);
  return angles;
}
/// The bits of the lanes in which the first is not at most the second.
inline unsigned notAtMost(Lanes values, double most) {
  unsigned bits = 0;
  for (int k = 0; k < kWidth; ++k) bits |= (values[k] <= most ? 0U : 1U) << k;
  return bits;
}

struct Vector {
  Lanes x[3];
};
struct Matrix {
  Lanes m[3][3];
};

inline Vector loadVector(const double* numbers) { return {{load(numbers, 0), load(numbers, 1), load(numbers, 2)}}; }
inline Matrix loadMatrix(const double* numbers) {
  Matrix M;
  HEXODERM_UNROLL
  for (int i = 0; i < 3; ++i) {
    HEXODERM_UNROLL
    for (int j = 0; j < 3; ++j) M.m[i][j] = load(numbers, static_cast<std::size_t>(3 * i + j));
  }
  return M;
}
inline Lanes dot(const Vector& a, const Vector& b) { return a.x[0] * b.x[0] + a.x[1] * b.x[1] + a.x[2] * b.x[2]; }
inline Vector operator*(Lanes s, const Vector& a) { return {{s * a.x[0], s * a.x[1], s * a.x[2]}}; }
inline Vector operator+(const Vector& a, const Vector& b) {
  return {{a.x[0] + b.x[0], a.x[1] + b.x[1], a.x[2] + b.x[2]}};
}
inline Vector operator-(const Vector& a, const Vector& b) {
  return {{a.x[0] - b.x[0], a.x[1] - b.x[1], a.x[2] - b.x[2]}};
}
inline Vector operator*(const Matrix& M, const Vector& a) {
  Vector product;
  HEXODERM_UNROLL
  for (int i = 0; i < 3; ++i) product.x[i] = M.m[i][0] * a.x[0] + M.m[i][1] * a.x[1] + M.m[i][2] * a.x[2];
  return product;
}
/// M^T a.
inline Vector transposedTimes(const Matrix& M, const Vector& a) {
  Vector product;
  HEXODERM_UNROLL
  for (int i = 0; i < 3; ++i) product.x[i] = M.m[0][i] * a.x[0] + M.m[1][i] * a.x[1] + M.m[2][i] * a.x[2];
  return product;
}
inline Matrix operator*(const Matrix& A, const Matrix& B) {
  Matrix C;
  HEXODERM_UNROLL
  for (int i = 0; i < 3; ++i) {
    HEXODERM_UNROLL
    for (int j = 0; j < 3; ++j) {
      C.m[i][j] = A.m[i][0] * B.m[0][j] + A.m[i][1] * B.m[1][j] + A.m[i][2] * B.m[2][j];
    }
  }
  return C;
}
inline Matrix operator*(Lanes s, const Matrix& A) {
  Matrix C;
  for (int i = 0; i < 3; ++i) {
    for (int j = 0; j < 3; ++j) C.m[i][j] = s * A.m[i][j];
  }
  return C;
}
inline Matrix operator+(const Matrix& A, const Matrix& B) {
  Matrix C;
  for (int i = 0; i < 3; ++i) {
    for (int j = 0; j < 3; ++j) C.m[i][j] = A.m[i][j] + B.m[i][j];
  }
  return C;
}
inline Matrix transposed(const Matrix& A) {
  Matrix C;
  for (int i = 0; i < 3; ++i) {
    for (int j = 0; j < 3; ++j) C.m[i][j] = A.m[j][i];
  }
  return C;
}
/// A^T B.
inline Matrix transposedTimes(const Matrix& A, const Matrix& B) { return transposed(A) * B; }
/// A [w]x.
inline Matrix timesSkew(const Matrix& A, const Vector& w) {
  Matrix C;
  HEXODERM_UNROLL
  for (int i = 0; i < 3; ++i) {
    C.m[i][0] = A.m[i][1] * w.x[2] - A.m[i][2] * w.x[1];
    C.m[i][1] = A.m[i][2] * w.x[0] - A.m[i][0] * w.x[2];
    C.m[i][2] = A.m[i][0] * w.x[1] - A.m[i][1] * w.x[0];
  }
  return C;
}

// --- Cells ---

/// F^-1, with F F^T = A: lower triangles.
inline void invertFactor(const Lanes (&A)[4][4], Lanes (&inverse)[4][4]) {
  Lanes F[4][4];
  HEXODERM_UNROLL
  for (int j = 0; j < 4; ++j) {
    Lanes pivot = A[j][j];
    for (int k = 0; k < j; ++k) pivot -= F[j][k] * F[j][k];
    inverse[j][j] = 1.0 / rootOf(pivot);
    HEXODERM_UNROLL
    for (int i = j + 1; i < 4; ++i) {
      Lanes element = A[i][j];
      for (int k = 0; k < j; ++k) element -= F[i][k] * F[j][k];
      F[i][j] = element * inverse[j][j];
    }
    HEXODERM_UNROLL
    for (int i = 0; i < j; ++i) {
      Lanes sum = F[j][i] * inverse[i][i];
      for (int k = i + 1; k < j; ++k) sum += F[j][k] * inverse[k][i];
      inverse[j][i] = -sum * inverse[j][j];
    }
  }
}

/// What a pose says of a cell.
struct PoseOfCell {
  Vector turned_force;  // in the cell's frame
  Lanes row[4];         // 1 and the force in the sensor's axes
  Vector weighted;      // residual times precision
  Lanes precision;
  Lanes explained[3][4];  // per axis: precision * row, in the units of what the sensor's errors explain
  Lanes J[3][6];          // of the residual, to the cell
};
static_assert(sizeof(PoseOfCell) == CellLanes::kWorkspaceOfPose * sizeof(Lanes));

/// What the sensor's errors c of an axis would change if their prior's mean moved along them: with L the prior's
/// precision, N the readings' and F F^T = L + N, F^-1 L c, F^-1 N c and L c. The cost curves along two such moves by
/// (F^-1 L c)^T F^-1 N c', in which nothing cancels where a prior is far more precise than the readings.
struct MeanMoves {
  Lanes explained[3][4];
  Lanes read[3][4];
  Lanes weighted[3][4];
};
inline MeanMoves moveMean(const double (&precision)[3][4], const Lanes (&normal)[4][4],
                          const Lanes (&explains)[3][4][4], const Lanes (&c)[3][4]) {
  MeanMoves moves;
  for (int axis = 0; axis < 3; ++axis) {
    Lanes read[4];
    for (int i = 0; i < 4; ++i) {
      moves.weighted[axis][i] = precision[axis][i] * c[axis][i];
      read[i] = normal[i][0] * c[axis][0];
      for (int j = 1; j < 4; ++j) read[i] += (j <= i ? normal[i][j] : normal[j][i]) * c[axis][j];
    }
    for (int i = 0; i < 4; ++i) {
      moves.explained[axis][i] = explains[axis][i][0] * moves.weighted[axis][0];
      moves.read[axis][i] = explains[axis][i][0] * read[0];
      for (int j = 1; j <= i; ++j) {
        moves.explained[axis][i] += explains[axis][i][j] * moves.weighted[axis][j];
        moves.read[axis][i] += explains[axis][i][j] * read[j];
      }
    }
  }
  return moves;
}

template <int kColumns>
unsigned cellsWith(const LinearizeSetting& setting, const CellLanes& cells) {
  constexpr bool kAccelerations = kColumns == 6;
  const std::size_t poses = setting.poses;
  const Matrix R = loadMatrix(cells.R_o_u);
  const Vector lever = loadVector(cells.lever_o);
  Matrix R_a_u;
  for (int i = 0; i < 3; ++i) {
    for (int j = 0; j < 3; ++j) R_a_u.m[i][j] = all(setting.R_a_u[3 * i + j]);
  }

  // The sensor's most probable errors.
  const double scale = setting.lot_scale;
  PoseOfCell* __restrict const seen = reinterpret_cast<PoseOfCell*>(cells.workspace);
  Lanes normal[4][4] = {};
  Lanes right[3][4] = {};
  for (std::size_t k = 0; k < poses; ++k) {
    PoseOfCell& pose = seen[k];
    const double* f = setting.force_o + 3 * k;
    Vector force = {{all(f[0]), all(f[1]), all(f[2])}};
    if (kAccelerations) {
      const double* a = setting.acceleration_o + 3 * k;
      force.x[0] += a[1] * lever.x[2] - a[2] * lever.x[1];
      force.x[1] += a[2] * lever.x[0] - a[0] * lever.x[2];
      force.x[2] += a[0] * lever.x[1] - a[1] * lever.x[0];
    }
    pose.turned_force = transposedTimes(R, force);
    const Vector v = R_a_u * pose.turned_force;
    pose.row[0] = all(1);
    for (int i = 0; i < 3; ++i) pose.row[i + 1] = v.x[i];
    pose.precision = load(cells.precision, k);
    for (int i = 0; i < 4; ++i) {
      const Lanes weighted = pose.precision * pose.row[i];
      for (int j = 0; j <= i; ++j) normal[i][j] += weighted * pose.row[j];
      for (int axis = 0; axis < 3; ++axis) {
        right[axis][i] += weighted * (load(cells.y_g, 3 * k + static_cast<std::size_t>(axis)) - scale * v.x[axis]);
      }
    }
  }
  Lanes explains[3][4][4];  // per axis F^-1, with F F^T = the information about its errors
  Matrix gain;
  Vector offset;
  Lanes twice_cost = all(0);
  for (int axis = 0; axis < 3; ++axis) {
    Lanes information[4][4];
    for (int i = 0; i < 4; ++i) {
      for (int j = 0; j <= i; ++j) information[i][j] = normal[i][j];
      information[i][i] += setting.prior_precision[axis][i];
    }
    Lanes(&inverse)[4][4] = explains[axis];
    invertFactor(information, inverse);
    Lanes half[4];
    for (int i = 0; i < 4; ++i) {
      half[i] = inverse[i][0] * right[axis][0];
      for (int j = 1; j <= i; ++j) half[i] += inverse[i][j] * right[axis][j];
    }
    Lanes errors[4];
    for (int j = 0; j < 4; ++j) {
      errors[j] = inverse[3][j] * half[3];
      for (int i = j; i < 3; ++i) errors[j] += inverse[i][j] * half[i];
      twice_cost += setting.prior_precision[axis][j] * errors[j] * errors[j];
    }
    offset.x[axis] = errors[0];
    for (int j = 0; j < 3; ++j) gain.m[axis][j] = errors[j + 1] + (axis == j ? scale : 0.0);
  }
  unsigned beyond = 0;
  for (std::size_t k = 0; k < poses; ++k) {
    PoseOfCell& pose = seen[k];
    Vector residual;
    for (int axis = 0; axis < 3; ++axis) {
      residual.x[axis] = load(cells.y_g, 3 * k + static_cast<std::size_t>(axis)) - offset.x[axis];
      for (int j = 0; j < 3; ++j) residual.x[axis] -= gain.m[axis][j] * pose.row[j + 1];
    }
    pose.weighted = pose.precision * residual;
    const Lanes squared = dot(residual, pose.weighted);
    twice_cost += squared;
    beyond |= notAtMost(squared, setting.threshold_squared);
  }
  if (beyond != 0) return beyond;
  store(cells.cost, 0, 0.5 * twice_cost);

  // The residuals' derivatives: G to the force, Q to force and acceleration, J to the cell.
  const Matrix gain_a_u = all(-1) * (gain * R_a_u);
  const Matrix G = gain_a_u * transposed(R);
  Lanes Q[3][kColumns];
  Matrix by_lever;
  if (kAccelerations) by_lever = timesSkew(G, lever);
  for (int axis = 0; axis < 3; ++axis) {
    for (int j = 0; j < 3; ++j) {
      Q[axis][j] = G.m[axis][j];
      if (kAccelerations) Q[axis][(3 + j) % kColumns] = all(-1 / 9.80665) * by_lever.m[axis][j];
    }
  }
  Lanes matrix[6][6] = {};
  Lanes gradient[6] = {};
  Lanes mixed[3][4][6] = {};
  for (std::size_t k = 0; k < poses; ++k) {
    PoseOfCell& pose = seen[k];
    Lanes(&J)[3][6] = pose.J;
    const Matrix turning = timesSkew(gain_a_u, pose.turned_force);
    Matrix moving = {};
    if (kAccelerations) {
      const double* a = setting.acceleration_o + 3 * k;
      moving = timesSkew(G, {{all(a[0]), all(a[1]), all(a[2])}});
    }
    for (int axis = 0; axis < 3; ++axis) {
      for (int j = 0; j < 3; ++j) {
        J[axis][j] = moving.m[axis][j];
        J[axis][3 + j] = turning.m[axis][j];
      }
    }
    for (int axis = 0; axis < 3; ++axis) {
      for (int i = 0; i < 4; ++i) {
        Lanes sum = explains[axis][i][0] * pose.row[0];
        for (int j = 1; j <= i; ++j) sum += explains[axis][i][j] * pose.row[j];
        pose.explained[axis][i] = pose.precision * sum;
      }
      for (int j = kAccelerations ? 0 : 3; j < 6; ++j) {
        gradient[j] += J[axis][j] * pose.weighted.x[axis];
        const Lanes weighted = pose.precision * J[axis][j];
        for (int i = kAccelerations ? 0 : 3; i <= j; ++i) matrix[j][i] += weighted * J[axis][i];
        for (int i = 0; i < 4; ++i) mixed[axis][i][j] += pose.explained[axis][i] * J[axis][j];
      }
    }
  }
  // What the sensor's errors could explain is not known of the rest.
  for (int axis = 0; axis < 3; ++axis) {
    for (int i = 0; i < 4; ++i) {
      for (int j = 0; j < 6; ++j) {
        for (int d = 0; d <= j; ++d) matrix[j][d] -= mixed[axis][i][j] * mixed[axis][i][d];
      }
    }
  }
  for (std::size_t j = 0; j < 6; ++j) {
    store(cells.gradient, j, gradient[j]);
    for (std::size_t i = 0; i <= j; ++i) {
      store(cells.matrix, 6 * i + j, matrix[j][i]);
      store(cells.matrix, 6 * j + i, matrix[j][i]);
    }
  }

  // The lot's errors are the mean of the prior of the sensor's offset and gains, whose sigmas grow with its scale.
  if (setting.lot) {
    Lanes c[kLotColumns][3][4] = {};
    for (int axis = 0; axis < 3; ++axis) {
      c[axis][axis][0] = all(1);
      for (int j = 0; j < 3; ++j) c[3][axis][j + 1] = gain.m[axis][j] / scale;
    }
    double* const pairs = cells.lot_sums + poses * kLotColumns * kColumns * kWidth;
    double* const slopes = pairs + kLotColumns * kLotColumns * kWidth;
    MeanMoves moves[kLotColumns];
    for (std::size_t l = 0; l < kLotColumns; ++l) {
      moves[l] = moveMean(setting.prior_precision, normal, explains, c[l]);
      Lanes slope = all(0);
      Lanes to_cell[6] = {};
      for (int axis = 0; axis < 3; ++axis) {
        slope -= moves[l].weighted[axis][0] * offset.x[axis];
        for (int j = 0; j < 3; ++j)
          slope -= moves[l].weighted[axis][j + 1] * (gain.m[axis][j] - (axis == j ? scale : 0.0));
        for (int i = 0; i < 4; ++i) {
          for (int j = 0; j < 6; ++j) to_cell[j] -= moves[l].explained[axis][i] * mixed[axis][i][j];
        }
      }
      add(slopes, l, slope);
      for (std::size_t j = 0; j < 6; ++j) store(cells.lot_border, j * kLotColumns + l, to_cell[j]);
      for (std::size_t m = 0; m <= l; ++m) {
        Lanes curvature = all(0);
        for (int axis = 0; axis < 3; ++axis) {
          for (int i = 0; i < 4; ++i) curvature += moves[l].explained[axis][i] * moves[m].read[axis][i];
        }
        add(pairs, l * kLotColumns + m, curvature);
      }
      for (std::size_t k = 0; k < poses; ++k) {
        Lanes of_axis[3] = {};
        for (int axis = 0; axis < 3; ++axis) {
          for (int i = 0; i < 4; ++i) of_axis[axis] -= moves[l].explained[axis][i] * seen[k].explained[axis][i];
        }
        for (std::size_t column = 0; column < kColumns; ++column) {
          add(cells.lot_sums, (k * kLotColumns + l) * kColumns + column,
              of_axis[0] * Q[0][column] + of_axis[1] * Q[1][column] + of_axis[2] * Q[2][column]);
        }
      }
    }
  }

  Lanes squares[3][kColumns][kColumns];
  for (int axis = 0; axis < 3; ++axis) {
    for (int i = 0; i < kColumns; ++i) {
      for (int j = 0; j < kColumns; ++j) squares[axis][i][j] = Q[axis][i] * Q[axis][j];
    }
  }
  const std::size_t columns = poses * kColumns;
  double* pair = cells.border_sums;
  for (std::size_t k = 0; k < poses; ++k) {
    const PoseOfCell& pose = seen[k];
    Lanes left[3][6];
    for (int axis = 0; axis < 3; ++axis) {
      for (int j = 0; j < 6; ++j) {
        left[axis][j] = pose.precision * pose.J[axis][j];
        for (int i = 0; i < 4; ++i) left[axis][j] -= mixed[axis][i][j] * pose.explained[axis][i];
      }
    }
    for (std::size_t j = 0; j < 6; ++j) {
      for (std::size_t c = 0; c < kColumns; ++c) {
        store(cells.border, j * columns + k * kColumns + c,
              left[0][j] * Q[0][c] + left[1][j] * Q[1][c] + left[2][j] * Q[2][c]);
      }
    }
    for (std::size_t c = 0; c < kColumns; ++c) {
      add(cells.gradient_sums, k * kColumns + c,
          Q[0][c] * pose.weighted.x[0] + Q[1][c] * pose.weighted.x[1] + Q[2][c] * pose.weighted.x[2]);
    }
    for (std::size_t earlier = 0; earlier <= k; ++earlier) {
      Lanes share[3];
      for (int axis = 0; axis < 3; ++axis) {
        share[axis] = earlier == k ? pose.precision : all(0);
        for (int i = 0; i < 4; ++i) share[axis] -= pose.explained[axis][i] * seen[earlier].explained[axis][i];
      }
      for (std::size_t i = 0; i < kColumns; ++i) {
        for (std::size_t j = 0; j < kColumns; ++j) {
          add(pair, i * kColumns + j,
              share[0] * squares[0][i][j] + share[1] * squares[1][i][j] + share[2] * squares[2][i][j]);
        }
      }
      pair += kColumns * kColumns * kWidth;
    }
  }
  return 0;
}

unsigned cells(const LinearizeSetting& setting, const CellLanes& lanes) {
  return setting.accelerations ? cellsWith<6>(setting, lanes) : cellsWith<3>(setting, lanes);
}

// --- Links ---

/// A whitened residual of three numbers, as its loss weighs it.
struct Weighed {
  Lanes cost;  // twice
  Vector force;
  Matrix hessian;
};

/// Beyond the threshold a Huber loss rises linearly, so it has no curvature along the residual; a little is kept.
inline Weighed weigh(const Vector& residual, double threshold_squared) {
  constexpr double kKeptCurvature = 0.05;
  const double threshold = __builtin_sqrt(threshold_squared);
  const Lanes squared = dot(residual, residual);
  const auto inside = squared <= all(threshold_squared);
  const Lanes root = rootOf(squared);
  const Lanes weight = inside ? all(1) : threshold / root;
  const Lanes along = inside ? all(0) : (1 - kKeptCurvature) * weight / squared;
  Weighed weighed;
  weighed.cost = inside ? squared : 2 * threshold * root - threshold_squared;
  weighed.force = weight * residual;
  for (int i = 0; i < 3; ++i) {
    for (int j = 0; j < 3; ++j) {
      weighed.hessian.m[i][j] = -along * residual.x[i] * residual.x[j];
      if (i == j) weighed.hessian.m[i][j] += weight;
    }
  }
  return weighed;
}

/// The arc's share in a link's closure, as arcOpening_m() in gap_share.h has it: k, and its derivatives to the outward
/// directions.
struct Arc {
  Vector k;
  Matrix to_c;
  Matrix to_n;
};

inline Arc arcBetween(const Vector& U_c, const Vector& U_n, Lanes e) {
  constexpr double kFolded = 1e-3;
  const Vector w = U_c - U_n;
  const Vector s = U_c + U_n;
  const Lanes distance = rootOf(dot(w, w));
  const Lanes length = distance > all(kFolded) ? distance : all(kFolded);
  const Vector m = (1.0 / length) * w;
  const Lanes a = angleOf(rootOf(dot(s, s)), length);
  const Lanes factor = 2.0 / 3.0 * e;
  // sin 2a, with tan a = |s| / length.
  const Lanes sine = 2.0 * rootOf(dot(s, s)) * length / (dot(s, s) + length * length);
  const Lanes slope = sine > all(1e-9) ? a / sine : all(0.5);
  const Lanes turn = factor * a * a / length;
  Arc arc;
  arc.k = (factor * a * a) * m;
  for (int i = 0; i < 3; ++i) {
    for (int j = 0; j < 3; ++j) {
      const Lanes turning = turn * ((i == j ? 1.0 : 0.0) - m.x[i] * m.x[j]);
      arc.to_c.m[i][j] = factor * slope * m.x[i] * U_n.x[j] + turning;
      arc.to_n.m[i][j] = factor * slope * m.x[i] * U_c.x[j] - turning;
    }
  }
  return arc;
}

/// Blocks tt, tr, rt and rr of a matrix of two cells' positions and rotations.
inline void storeBlocks(double* to, const Matrix& tt, const Matrix& tr, const Matrix& rt, const Matrix& rr) {
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t j = 0; j < 3; ++j) {
      store(to, 6 * i + j, tt.m[i][j]);
      store(to, 6 * i + 3 + j, tr.m[i][j]);
      store(to, 6 * (3 + i) + j, rt.m[i][j]);
      store(to, 6 * (3 + i) + 3 + j, rr.m[i][j]);
    }
  }
}
inline void storeVector(double* to, std::size_t at, const Vector& a) {
  for (std::size_t i = 0; i < 3; ++i) store(to, at + i, a.x[i]);
}

/// A rotation vector, with sine and cosine of half its angle.
struct Turn {
  Vector w;
  Lanes sine;
  Lanes cosine;
};

/// By way of the quaternion q: four times q q^T stands in R, and q is along each of its columns. Beyond 120 degrees the
/// longest of the last three is taken, so that half a turn is nothing special.
inline Turn turnOf(const Matrix& R) {
  const Lanes trace = R.m[0][0] + R.m[1][1] + R.m[2][2];
  const auto is_far = trace < all(1e-3);
  const Vector first = {{R.m[2][1] - R.m[1][2], R.m[0][2] - R.m[2][0], R.m[1][0] - R.m[0][1]}};
  Vector vec = first;
  Lanes real = all(0);
  Lanes square = trace + 1.0;
  Lanes longest = all(0);
  for (int k = 0; k < 3; ++k) {
    const Lanes diagonal = 1.0 + 2.0 * R.m[k][k] - trace;
    const auto is_longer = is_far & (diagonal > longest);
    for (int i = 0; i < 3; ++i) vec.x[i] = is_longer ? (i == k ? diagonal : R.m[i][k] + R.m[k][i]) : vec.x[i];
    real = is_longer ? first.x[k] : real;
    square = is_longer ? diagonal : square;
    longest = is_longer ? diagonal : longest;
  }
  const Lanes root = rootOf(square);
  const Lanes scale = 0.5 / root;
  vec = scale * vec;
  real = is_far ? scale * real : 0.5 * root;
  const Lanes sign = real < all(0) ? all(-1) : all(1);
  const Lanes norm = rootOf(dot(vec, vec) + real * real);
  vec = (sign / norm) * vec;
  Turn turn;
  turn.cosine = sign * real / norm;
  turn.sine = rootOf(dot(vec, vec));
  const Lanes half_angle = angleOf(turn.sine, turn.cosine);
  turn.w = (turn.sine < all(1e-12) ? all(2.0) : 2.0 * half_angle / turn.sine) * vec;
  return turn;
}

void links(const LinearizeSetting& setting, const LinkLanes& links) {
  const Matrix R_c = loadMatrix(links.R_c);
  const Matrix R_n = loadMatrix(links.R_n);
  const Vector p_c = loadVector(links.p_c);
  const Vector p_n = loadVector(links.p_n);
  const Lanes length_c = rootOf(dot(p_c, p_c));
  const Lanes length_n = rootOf(dot(p_n, p_n));
  const Vector u_c = (1.0 / length_c) * p_c;
  const Vector u_n = (1.0 / length_n) * p_n;
  const Lanes precision = all(setting.link_precision);

  // The rotation beyond the nominal one.
  const Matrix R_c_n = transposedTimes(R_c, R_n);
  const Turn turn = turnOf(R_c_n * transposed(loadMatrix(links.R_nom)));
  const Vector& w = turn.w;
  const Lanes angle_squared = dot(w, w);
  // Of the inverse of the left Jacobian; the tangent of half the angle is sine / cosine.
  const auto is_small = angle_squared < all(1e-8);
  const Lanes second =
      is_small ? all(1.0 / 12.0) : 1.0 / angle_squared - turn.cosine / (2.0 * rootOf(angle_squared) * turn.sine);

  Vector elastomer;
  Matrix whitened;  // axes^T (1 - [w]x / 2 + second [w]x^2), axes: those of linkAxes() in their precisions
  {
    const Lanes level = levelPart(u_c.x[0], u_c.x[1], u_c.x[2]);
    const Lanes bend = setting.bend_precision / level;
    const Lanes yaw = setting.yaw_precision * u_c.x[2] / level;
    Matrix axes_t = {};
    for (int j = 0; j < 3; ++j) axes_t.m[0][j] = setting.twist_precision * u_c.x[j];
    axes_t.m[1][0] = -bend * u_c.x[1];
    axes_t.m[1][1] = bend * u_c.x[0];
    axes_t.m[2][0] = -yaw * u_c.x[0];
    axes_t.m[2][1] = -yaw * u_c.x[1];
    axes_t.m[2][2] = setting.yaw_precision * level;
    elastomer = axes_t * w;
    const Matrix once = timesSkew(axes_t, w);
    const Matrix twice = timesSkew(once, w);
    whitened = axes_t + all(-0.5) * once + second * twice;
  }

  const Matrix across_c = timesSkew(R_c, u_c);
  const Matrix across_n = timesSkew(R_n, u_n);
  Matrix to_c = (precision * length_c) * across_c;  // of the closure, to the cells' rotations
  Matrix to_n = (-precision * length_n) * across_n;
  Vector opening = loadVector(links.t_c_n) + R_n * p_n - R_c * p_c;
  Vector to_share = {};
  if (setting.bends) {
    const Arc arc = arcBetween(R_c * u_c, R_n * u_n, 0.5 * (length_c + length_n));
    const Lanes share = precision * setting.gap_share;
    opening = opening - setting.gap_share * all(1) * arc.k;
    to_c = to_c + share * (arc.to_c * across_c);
    to_n = to_n + share * (arc.to_n * across_n);
    to_share = (-precision) * arc.k;
  }
  const Weighed closure = weigh(precision * opening, setting.threshold_squared);
  const Weighed bending = weigh(elastomer, setting.threshold_squared);
  store(links.cost, 0, 0.5 * (closure.cost + bending.cost));

  const Matrix moving = (precision * precision) * closure.hessian;
  const Matrix weighed_c = closure.hessian * to_c;
  const Matrix weighed_n = closure.hessian * to_n;
  const Matrix stiffness = transposedTimes(whitened, bending.hessian * whitened);  // of the elastomer, in c
  const Matrix stiffness_n = stiffness * R_c_n;
  const Matrix tr_c = (-precision) * weighed_c;
  const Matrix tr_n = precision * weighed_n;
  storeBlocks(links.matrix_c, moving, tr_c, transposed(tr_c), transposedTimes(to_c, weighed_c) + stiffness);
  storeBlocks(links.matrix_n, moving, tr_n, transposed(tr_n),
              transposedTimes(to_n, weighed_n) + transposedTimes(R_c_n, stiffness_n));
  storeBlocks(links.matrix_c_n, all(-1) * moving, all(-1) * tr_n, transposed(all(-1) * tr_c),
              transposedTimes(to_c, weighed_n) + all(-1) * stiffness_n);
  const Vector bending_c = transposedTimes(whitened, bending.force);
  storeVector(links.gradient, 0, (-precision) * closure.force);
  storeVector(links.gradient, 3, transposedTimes(to_c, closure.force) - bending_c);
  storeVector(links.gradient, 6, precision * closure.force);
  storeVector(links.gradient, 9, transposedTimes(to_n, closure.force) + transposedTimes(R_c_n, bending_c));
  if (setting.bends) {
    const Vector weighed_share = closure.hessian * to_share;
    storeVector(links.share, 0, (-precision) * weighed_share);
    storeVector(links.share, 3, transposedTimes(to_c, weighed_share));
    storeVector(links.share, 6, precision * weighed_share);
    storeVector(links.share, 9, transposedTimes(to_n, weighed_share));
    store(links.share, 12, dot(to_share, weighed_share));
    store(links.share, 13, dot(to_share, closure.force));
  }
}

constexpr LinearizeKernels kKernels{HEXODERM_LANES, cells, links};

}  // namespace
}  // namespace hexoderm
