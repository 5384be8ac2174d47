// The text of the kernels in front_kernels.h (lanes.inl says what that is).

#include "hexoderm/base/lanes.inl"
#include "hexoderm/solve/sparse/front_kernels.h"

namespace hexoderm {
namespace {

using Size = FrontKernels::Size;
constexpr Size kBlock = 6;
constexpr Size kWide = FrontKernels::kMaxPivotsAtOnce;
/// Of a long product so many columns at a time stay in the cache.
constexpr Size kDeep = 192;
/// Shorter products are not worth rearranging.
constexpr Size kShallow = 36;

inline double sumOf(Lanes values) {
#if HEXODERM_LANES == 4
  return (values[0] + values[1]) + (values[2] + values[3]);
#else
  return values[0] + values[1];
#endif
}

/// Element (k, j) of the right factor of a product, six columns wide, is at[k * step + j * across].
struct Factor {
  const double* at;
  Size step;
  Size across;
};

/// C -= A B for so many vectors of rows and six columns. `kDense`: B's six numbers stand side by side.
template <int kVectors, bool kDense>
inline void subtractTile(double* c, Size ldc, const double* a, Size lda, const Factor& b, Size depth) {
  Lanes sum[kBlock][kVectors] = {};
  const double* factors = b.at;
  const Size across = kDense ? 1 : b.across;
  for (Size k = 0; k < depth; ++k) {
    Lanes column[kVectors];
    HEXODERM_UNROLL
    for (int v = 0; v < kVectors; ++v) column[v] = load(a + v * kWidth);
    HEXODERM_UNROLL
    for (Size j = 0; j < kBlock; ++j) {
      const Lanes factor = all(factors[j * across]);
      HEXODERM_UNROLL
      for (int v = 0; v < kVectors; ++v) sum[j][v] += column[v] * factor;
    }
    a += lda;
    factors += b.step;
  }
  HEXODERM_UNROLL
  for (Size j = 0; j < kBlock; ++j) {
    HEXODERM_UNROLL
    for (int v = 0; v < kVectors; ++v) {
      double* at = c + j * ldc + v * kWidth;
      store(at, load(at) - sum[j][v]);
    }
  }
}

/// C (rows x 6) -= A (rows x depth) B.
template <bool kDense>
inline void subtractColumns(double* c, Size ldc, const double* a, Size lda, const Factor& b, Size rows, Size depth) {
  Size i = 0;
  for (; i + kWidth < rows; i += 2 * kWidth) subtractTile<2, kDense>(c + i, ldc, a + i, lda, b, depth);
  if (i < rows) subtractTile<1, kDense>(c + i, ldc, a + i, lda, b, depth);
}

/// Rearranges what a long product takes, so that it is read in the order in which it stands in memory.
inline void packColumns(double* packed, const Factor& b, Size depth) {
  for (Size k = 0; k < depth; ++k) {
    for (Size j = 0; j < kBlock; ++j) packed[k * kBlock + j] = b.at[k * b.step + j * b.across];
  }
}
template <int kVectors>
inline void packRows(double* packed, const double* a, Size lda, Size depth) {
  for (Size k = 0; k < depth; ++k) {
    for (int v = 0; v < kVectors; ++v) store(packed + (k * kVectors + v) * kWidth, load(a + k * lda + v * kWidth));
  }
}

/// C (rows x columns) -= A (rows x depth) B, where the second six columns of B begin `next` after the first. `kLower`:
/// what is above the diagonal may be left out.
template <bool kLower>
void subtractProduct(double* c, Size ldc, const double* a, Size lda, const Factor& b, Size next, Size rows,
                     Size columns, Size depth) {
  if (depth <= kShallow) {
    for (Size j = 0; j < columns; j += kBlock) {
      const Size top = kLower ? j : 0;
      const Factor six{b.at + j / kBlock * next, b.step, b.across};
      if (b.across == 1) {
        subtractColumns<true>(c + j * ldc + top, ldc, a + top, lda, six, rows - top, depth);
      } else {
        subtractColumns<false>(c + j * ldc + top, ldc, a + top, lda, six, rows - top, depth);
      }
    }
    return;
  }
  double packed_columns[kDeep * kWide];
  double packed_rows[kDeep * 2 * kWidth];
  for (Size k = 0; k < depth; k += kDeep) {
    const Size deep = depth - k < kDeep ? depth - k : kDeep;
    for (Size left = 0; left < columns; left += kWide) {
      const Size right = columns - left < kWide ? columns : left + kWide;
      for (Size j = left; j < right; j += kBlock) {
        const Factor six{b.at + k * b.step + j / kBlock * next, b.step, b.across};
        packColumns(packed_columns + (j - left) * kDeep, six, deep);
      }
      for (Size i = kLower ? left : 0; i < rows; i += 2 * kWidth) {
        const bool both = i + kWidth < rows;
        if (both) {
          packRows<2>(packed_rows, a + k * lda + i, lda, deep);
        } else {
          packRows<1>(packed_rows, a + k * lda + i, lda, deep);
        }
        for (Size j = left; j < right; j += kBlock) {
          if (kLower && i + 2 * kWidth <= j) break;
          const Factor six{packed_columns + (j - left) * kDeep, kBlock, 1};
          if (both) {
            subtractTile<2, true>(c + j * ldc + i, ldc, packed_rows, 2 * kWidth, six, deep);
          } else {
            subtractTile<1, true>(c + j * ldc + i, ldc, packed_rows, kWidth, six, deep);
          }
        }
      }
    }
  }
}

void subtractOuter(double* c, Size ldc, const double* a, Size lda, const double* b, Size ldb, Size rows, Size columns,
                   Size depth) {
  subtractProduct<true>(c, ldc, a, lda, {b, ldb, 1}, kBlock, rows, columns, depth);
}

/// A lower triangle of six rows and the inverses of its diagonal.
struct Triangle {
  double l[kBlock][kBlock];
  double inverse[kBlock];
};

inline Triangle triangleAt(const double* square, Size ld) {
  Triangle triangle;
  for (Size j = 0; j < kBlock; ++j) {
    for (Size i = j; i < kBlock; ++i) triangle.l[i][j] = square[i + j * ld];
    triangle.inverse[j] = 1 / triangle.l[j][j];
  }
  return triangle;
}

/// X becomes X L^-T, or X L^-1, for so many vectors of rows.
template <int kVectors, bool kTransposed>
inline void divideTile(double* x, Size ldx, const Triangle& triangle) {
  Lanes columns[kBlock][kVectors];
  HEXODERM_UNROLL
  for (Size j = 0; j < kBlock; ++j) {
    HEXODERM_UNROLL
    for (int v = 0; v < kVectors; ++v) columns[j][v] = load(x + j * ldx + v * kWidth);
  }
  HEXODERM_UNROLL
  for (Size step = 0; step < kBlock; ++step) {
    const Size j = kTransposed ? step : kBlock - 1 - step;
    HEXODERM_UNROLL
    for (Size earlier = 0; earlier < step; ++earlier) {
      const Size k = kTransposed ? earlier : kBlock - 1 - earlier;
      const Lanes factor = all(kTransposed ? triangle.l[j][k] : triangle.l[k][j]);
      HEXODERM_UNROLL
      for (int v = 0; v < kVectors; ++v) columns[j][v] -= columns[k][v] * factor;
    }
    const Lanes inverse = all(triangle.inverse[j]);
    HEXODERM_UNROLL
    for (int v = 0; v < kVectors; ++v) {
      columns[j][v] *= inverse;
      store(x + j * ldx + v * kWidth, columns[j][v]);
    }
  }
}

template <bool kTransposed>
inline void divide(double* x, Size ldx, Size rows, const Triangle& triangle) {
  Size i = 0;
  for (; i + kWidth < rows; i += 2 * kWidth) divideTile<2, kTransposed>(x + i, ldx, triangle);
  if (i < rows) divideTile<1, kTransposed>(x + i, ldx, triangle);
}

/// The factor of a block's six rows, in its lower triangle. False: not positive definite or not finite.
inline bool factorizeSix(double* square, Size ld, Triangle& triangle) {
  constexpr double kLargest = 1.7976931348623157e308;
  for (Size j = 0; j < kBlock; ++j) {
    double pivot = square[j + j * ld];
    for (Size k = 0; k < j; ++k) pivot -= triangle.l[j][k] * triangle.l[j][k];
    // A number that is not finite, here or further up the tree, has reached the diagonal.
    if (!(pivot > 0 && pivot <= kLargest)) return false;
    triangle.l[j][j] = __builtin_sqrt(pivot);
    triangle.inverse[j] = 1 / triangle.l[j][j];
    square[j + j * ld] = triangle.l[j][j];
    for (Size i = j + 1; i < kBlock; ++i) {
      double element = square[i + j * ld];
      for (Size k = 0; k < j; ++k) element -= triangle.l[i][k] * triangle.l[j][k];
      triangle.l[i][j] = element * triangle.inverse[j];
      square[i + j * ld] = triangle.l[i][j];
    }
  }
  return true;
}

bool factorize(double* panel, Size ld, Size rows, Size pivots) {
  for (Size left = 0; left < pivots; left += kWide) {
    const Size right = pivots - left < kWide ? pivots : left + kWide;
    if (left > 0) {
      subtractOuter(panel + left * ld + left, ld, panel + left, ld, panel + left, ld, rows - left, right - left, left);
    }
    for (Size j = left; j < right; j += kBlock) {
      double* square = panel + j * ld + j;
      const double* earlier = panel + left * ld + j;
      subtractColumns<true>(square, ld, earlier, ld, {earlier, ld, 1}, rows - j, j - left);
      Triangle triangle;
      if (!factorizeSix(square, ld, triangle)) return false;
      divide<true>(square + kBlock, ld, rows - j - kBlock, triangle);
    }
  }
  return true;
}

/// (L L^T)^-1 of a triangle, both triangles of it.
inline void invertSix(double* z, Size ldz, const Triangle& triangle) {
  double inverse[kBlock][kBlock];  // of L
  for (Size j = 0; j < kBlock; ++j) {
    inverse[j][j] = triangle.inverse[j];
    for (Size i = j + 1; i < kBlock; ++i) {
      double sum = 0;
      for (Size k = j; k < i; ++k) sum -= triangle.l[i][k] * inverse[k][j];
      inverse[i][j] = sum * triangle.inverse[i];
    }
  }
  for (Size j = 0; j < kBlock; ++j) {
    for (Size i = j; i < kBlock; ++i) {
      double sum = 0;
      for (Size k = i; k < kBlock; ++k) sum += inverse[k][i] * inverse[k][j];
      z[i + j * ldz] = z[j + i * ldz] = sum;
    }
  }
}

/// C (6 x 2) -= W^T Z, where W and Z have `depth` rows.
inline void subtractInnerTile(double* c, Size ldc, const double* w, Size ldw, const double* z, Size ldz, Size depth) {
  Lanes sum[2][kBlock] = {};
  Size k = 0;
  for (; k + kWidth <= depth; k += kWidth) {
    const Lanes first = load(z + k);
    const Lanes second = load(z + ldz + k);
    HEXODERM_UNROLL
    for (Size i = 0; i < kBlock; ++i) {
      const Lanes row = load(w + i * ldw + k);
      sum[0][i] += row * first;
      sum[1][i] += row * second;
    }
  }
  for (Size j = 0; j < 2; ++j) {
    for (Size i = 0; i < kBlock; ++i) {
      double total = sumOf(sum[j][i]);
      for (Size rest = k; rest < depth; ++rest) total += w[i * ldw + rest] * z[j * ldz + rest];
      c[i + j * ldc] -= total;
    }
  }
}

/// C -= W^T Z, which is symmetric: both triangles.
void subtractInner(double* c, Size ldc, const double* w, Size ldw, const double* z, Size ldz, Size size, Size depth) {
  for (Size j = 0; j < size; j += 2) {
    for (Size i = j / kBlock * kBlock; i < size; i += kBlock) {
      subtractInnerTile(c + i + j * ldc, ldc, w + i * ldw, ldw, z + j * ldz, ldz, depth);
    }
  }
  for (Size j = 0; j < size; ++j) {
    for (Size i = j + 1; i < size; ++i) c[j + i * ldc] = c[i + j * ldc];
  }
}

/// L_rp L_pp^-1 for columns that W holds a copy of L_rp of.
void divideByColumns(double* w, Size ldw, const double* square, Size ld, Size rows, Size size) {
  for (Size j = size - kBlock; j >= 0; j -= kBlock) {
    const double* below = square + j * ld + j + kBlock;
    subtractColumns<false>(w + j * ldw, ldw, w + (j + kBlock) * ldw, ldw, {below, 1, ld}, rows, size - j - kBlock);
    divide<false>(w + j * ldw, ldw, rows, triangleAt(square + j * ld + j, ld));
  }
}

inline void copyColumns(double* to, Size ld_to, const double* from, Size ld_from, Size rows, Size columns) {
  for (Size j = 0; j < columns; ++j) {
    for (Size i = 0; i < rows; i += kWidth) store(to + j * ld_to + i, load(from + j * ld_from + i));
  }
}

/// C (rows x columns) = -A B, with A of `depth` columns.
void negativeProduct(double* c, Size ldc, const double* a, Size lda, const double* b, Size ldb, Size rows, Size columns,
                     Size depth) {
  for (Size j = 0; j < columns; ++j) {
    for (Size i = 0; i < rows; i += kWidth) store(c + j * ldc + i, Lanes{});
  }
  subtractProduct<false>(c, ldc, a, lda, {b, 1, ldb}, kBlock * ldb, rows, columns, depth);
}

inline void transposeInto(double* to, const double* from, Size ld, Size rows, Size columns) {
  for (Size j = 0; j < columns; ++j) {
    for (Size i = 0; i < rows; ++i) to[j + i * ld] = from[i + j * ld];
  }
}

// With Z = A^-1 and W = L_rp L_pp^-1: Z_rp = -Z_rr W, Z_pp = (L_pp L_pp^T)^-1 - W^T Z_rp, for the pivots from `left` to
// `right` and the rows r behind them. W takes the workspace.

Size workspaceStride(Size rows, Size left, Size right) {
  const Size below = rows - right;
  return FrontKernels::paddedRows(below > right - left ? below : right - left);
}

/// The columns among themselves, six at a time; and W.
void beginInverse(double* z, Size ldz, const double* panel, Size ld, Size rows, Size left, Size right,
                  double* workspace) {
  const Size ldw = workspaceStride(rows, left, right);
  const double* square = panel + left * ld + left;
  double* z_pp = z + left * ldz + left;
  for (Size j = right - left - kBlock; j >= 0; j -= kBlock) {
    const Size after = right - left - j - kBlock;
    double* column = z_pp + j * ldz + j + kBlock;
    const Triangle triangle = triangleAt(square + j * ld + j, ld);
    double* diagonal = z_pp + j * ldz + j;
    if (after > 0) {
      copyColumns(workspace, ldw, square + j * ld + j + kBlock, ld, after, kBlock);
      divide<false>(workspace, ldw, after, triangle);
      negativeProduct(column, ldz, z_pp + (j + kBlock) * ldz + j + kBlock, ldz, workspace, ldw, after, kBlock, after);
    }
    invertSix(diagonal, ldz, triangle);
    if (after > 0) {
      subtractInner(diagonal, ldz, workspace, ldw, column, ldz, kBlock, after);
      transposeInto(z_pp + (j + kBlock) * ldz + j, column, ldz, after, kBlock);
    }
  }
  copyColumns(workspace, ldw, panel + left * ld + right, ld, rows - right, right - left);
  divideByColumns(workspace, ldw, square, ld, rows - right, right - left);
}

void inverseBelow(double* z, Size ldz, Size rows, Size left, Size right, Size begin, Size end,
                  const double* workspace) {
  negativeProduct(z + left * ldz + begin, ldz, z + right * ldz + begin, ldz, workspace,
                  workspaceStride(rows, left, right), end - begin, right - left, rows - right);
}

void endInverse(double* z, Size ldz, Size rows, Size left, Size right, const double* workspace) {
  const Size below = rows - right;
  const double* z_rp = z + left * ldz + right;
  subtractInner(z + left * ldz + left, ldz, workspace, workspaceStride(rows, left, right), z_rp, ldz, right - left,
                below);
  transposeInto(z + right * ldz + left, z_rp, ldz, below, right - left);
}

void substituteForward(const double* panel, Size ld, Size pivots, std::size_t first, const std::size_t* places,
                       std::size_t count, double* x, Size width) {
  double* own = x + kBlock * static_cast<Size>(first) * width;
  for (Size j = 0; j < pivots; j += kBlock) {
    subtractColumns<true>(own + j * width, width, own, width, {panel + j, ld, 1}, width, j);
    divide<true>(own + j * width, width, width, triangleAt(panel + j * ld + j, ld));
  }
  double packed[kDeep * kBlock];
  for (Size begin = 0; begin < pivots; begin += kDeep) {
    const Size deep = pivots - begin < kDeep ? pivots - begin : kDeep;
    for (std::size_t k = 0; k < count; ++k) {
      double* row = x + kBlock * static_cast<Size>(places[k]) * width;
      packColumns(packed, {panel + begin * ld + pivots + kBlock * static_cast<Size>(k), ld, 1}, deep);
      subtractColumns<true>(row, width, own + begin * width, width, {packed, kBlock, 1}, width, deep);
    }
  }
}

void substituteBack(const double* panel, Size ld, Size pivots, std::size_t first, const std::size_t* places,
                    std::size_t count, double* x, Size width, double* workspace) {
  double* own = x + kBlock * static_cast<Size>(first) * width;
  const Size block = kBlock * width;
  for (std::size_t k = 0; k < count; ++k) {
    const double* from = x + static_cast<Size>(places[k]) * block;
    double* to = workspace + static_cast<Size>(k) * block;
    for (Size i = 0; i < block; i += kWidth) store(to + i, load(from + i));
  }
  const Size rows = kBlock * static_cast<Size>(count);
  for (Size j = pivots - kBlock; j >= 0; j -= kBlock) {
    double* target = own + j * width;
    const double* column = panel + j * ld;
    subtractColumns<false>(target, width, workspace, width, {column + pivots, 1, ld}, width, rows);
    subtractColumns<false>(target, width, target + block, width, {column + j + kBlock, 1, ld}, width,
                           pivots - j - kBlock);
    divide<false>(target, width, width, triangleAt(column + j, ld));
  }
}

/// y -= A x for six columns of `rows` numbers.
inline void subtractSixColumns(double* y, const double* a, Size lda, const double* x, Size rows) {
  Lanes factor[kBlock];
  HEXODERM_UNROLL
  for (Size j = 0; j < kBlock; ++j) factor[j] = all(x[j]);
  Size i = 0;
  for (; i + kWidth <= rows; i += kWidth) {
    Lanes sum = load(a + i) * factor[0];
    HEXODERM_UNROLL
    for (Size j = 1; j < kBlock; ++j) sum += load(a + j * lda + i) * factor[j];
    store(y + i, load(y + i) - sum);
  }
  for (; i < rows; ++i) {
    double sum = 0;
    for (Size j = 0; j < kBlock; ++j) sum += a[j * lda + i] * x[j];
    y[i] -= sum;
  }
}

/// x -= A^T y for six columns of `rows` numbers.
inline void subtractSixProducts(double* x, const double* a, Size lda, const double* y, Size rows) {
  Lanes sum[kBlock] = {};
  Size i = 0;
  for (; i + kWidth <= rows; i += kWidth) {
    const Lanes numbers = load(y + i);
    HEXODERM_UNROLL
    for (Size j = 0; j < kBlock; ++j) sum[j] += load(a + j * lda + i) * numbers;
  }
  for (Size j = 0; j < kBlock; ++j) {
    double total = sumOf(sum[j]);
    for (Size rest = i; rest < rows; ++rest) total += a[j * lda + rest] * y[rest];
    x[j] -= total;
  }
}

void substituteVectorForward(const double* panel, Size ld, Size pivots, std::size_t first, const std::size_t* places,
                             std::size_t count, double* x, double* workspace) {
  double* own = x + kBlock * static_cast<Size>(first);
  const Size rows = kBlock * static_cast<Size>(count);
  for (Size i = 0; i < rows; ++i) workspace[i] = 0;
  for (Size j = 0; j < pivots; j += kBlock) {
    const Triangle triangle = triangleAt(panel + j * ld + j, ld);
    for (Size k = 0; k < kBlock; ++k) {
      for (Size earlier = 0; earlier < k; ++earlier) own[j + k] -= triangle.l[k][earlier] * own[j + earlier];
      own[j + k] *= triangle.inverse[k];
    }
    subtractSixColumns(own + j + kBlock, panel + j * ld + j + kBlock, ld, own + j, pivots - j - kBlock);
    subtractSixColumns(workspace, panel + j * ld + pivots, ld, own + j, rows);
  }
  for (std::size_t k = 0; k < count; ++k) {
    double* row = x + kBlock * static_cast<Size>(places[k]);
    for (Size i = 0; i < kBlock; ++i) row[i] += workspace[kBlock * static_cast<Size>(k) + i];
  }
}

void substituteVectorBack(const double* panel, Size ld, Size pivots, std::size_t first, const std::size_t* places,
                          std::size_t count, double* x, double* workspace) {
  double* own = x + kBlock * static_cast<Size>(first);
  const Size rows = kBlock * static_cast<Size>(count);
  for (std::size_t k = 0; k < count; ++k) {
    const double* row = x + kBlock * static_cast<Size>(places[k]);
    for (Size i = 0; i < kBlock; ++i) workspace[kBlock * static_cast<Size>(k) + i] = row[i];
  }
  for (Size j = pivots - kBlock; j >= 0; j -= kBlock) {
    subtractSixProducts(own + j, panel + j * ld + pivots, ld, workspace, rows);
    subtractSixProducts(own + j, panel + j * ld + j + kBlock, ld, own + j + kBlock, pivots - j - kBlock);
    const Triangle triangle = triangleAt(panel + j * ld + j, ld);
    for (Size k = kBlock - 1; k >= 0; --k) {
      for (Size later = k + 1; later < kBlock; ++later) own[j + k] -= triangle.l[later][k] * own[j + later];
      own[j + k] *= triangle.inverse[k];
    }
  }
}

void subtractRows(double* c, const double* a, const double* b, Size width) {
  for (Size j = 0; j < kBlock; j += 2) subtractInnerTile(c + j * kBlock, kBlock, a, width, b + j * width, width, width);
}

constexpr FrontKernels kKernels{
    factorize,      subtractOuter,           beginInverse,         inverseBelow, endInverse, substituteForward,
    substituteBack, substituteVectorForward, substituteVectorBack, subtractRows};

}  // namespace
}  // namespace hexoderm
