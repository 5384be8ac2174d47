#pragma once

#include <cstddef>

namespace hexoderm {

/// What a multifrontal factor spends its time on, on plain numbers: matrices by columns, each with the distance of its
/// columns ("ld"). Rows and columns come in blocks of six.
///
/// Vectors of numbers are worked on at once, so two rows more than a matrix has may be read and written: a matrix of
/// n rows needs a distance of at least paddedRows(n), also below its last column. What stands there, and above the
/// diagonal of what is a lower triangle, is anything.
struct FrontKernels {
  using Size = std::ptrdiff_t;

  /// The panel of a supernode, `rows` x `pivots`, its pivots' square on top and everything that earlier supernodes took
  /// from it in it, becomes its columns of the factor. False: not positive definite or not finite.
  bool (*factorize)(double* panel, Size ld, Size rows, Size pivots);
  /// The lower triangle of C (rows x columns) -= A B^T, with A of `depth` columns, and B the same with `columns` rows
  /// (rounded up to a multiple of six).
  void (*subtractOuter)(double* c, Size ldc, const double* a, Size lda, const double* b, Size ldb, Size rows,
                        Size columns, Size depth);
  /// Z, the inverse of the whole matrix at the `rows` rows of a front: both triangles of what belongs to the rows from
  /// `right` on are known, and the pivots from `left` to `right`, kMaxPivotsAtOnce at most, follow from the panel L.
  /// First what they need among themselves. `workspace`, for all three: inverseWorkspace(rows, right - left) numbers.
  void (*beginInverse)(double* z, Size ldz, const double* panel, Size ld, Size rows, Size left, Size right,
                       double* workspace);
  /// Then their rows from `begin` to `end`, in any order and side by side: at or after `right`, and kMaxPivotsAtOnce
  /// or a multiple of that after it, or the last.
  void (*inverseBelow)(double* z, Size ldz, Size rows, Size left, Size right, Size begin, Size end,
                       const double* workspace);
  /// And what these leave, where there are any.
  void (*endInverse)(double* z, Size ldz, Size rows, Size left, Size right, const double* workspace);
  /// Right-hand sides stand row by row, in the order of elimination: x holds 6 rows per block, `width` numbers each, a
  /// multiple of four. A supernode whose pivots begin with row 6 `first`, and whose further blocks of rows are
  /// `places`, takes its share in L^-1 x, or in L^-T x, for which `workspace` needs 6 `count` x `width` numbers.
  void (*substituteForward)(const double* panel, Size ld, Size pivots, std::size_t first, const std::size_t* places,
                            std::size_t count, double* x, Size width);
  void (*substituteBack)(const double* panel, Size ld, Size pivots, std::size_t first, const std::size_t* places,
                         std::size_t count, double* x, Size width, double* workspace);
  /// The same for one right-hand side whose numbers stand side by side; `workspace`: 6 `count` numbers.
  void (*substituteVectorForward)(const double* panel, Size ld, Size pivots, std::size_t first,
                                  const std::size_t* places, std::size_t count, double* x, double* workspace);
  void (*substituteVectorBack)(const double* panel, Size ld, Size pivots, std::size_t first, const std::size_t* places,
                               std::size_t count, double* x, double* workspace);
  /// C (6 x 6) -= A B^T, with A and B of six rows, row by row, `width` numbers each.
  void (*subtractRows)(double* c, const double* a, const double* b, Size width);

  static constexpr Size paddedRows(Size rows) { return rows + 2; }
  static constexpr Size inverseWorkspace(Size rows, Size pivots) {
    return paddedRows(rows) * (pivots < kMaxPivotsAtOnce ? pivots : kMaxPivotsAtOnce);
  }
  /// Wide panels are worked on so many columns at a time.
  static constexpr Size kMaxPivotsAtOnce = 48;
};

/// The same on any machine.
const FrontKernels& portableFrontKernels();
/// With AVX2 and FMA; only where hasVectorInstructions(). Differs from the portable form by rounding.
const FrontKernels& avx2FrontKernels();
/// The faster that the machine can run.
const FrontKernels& frontKernels();

}  // namespace hexoderm
