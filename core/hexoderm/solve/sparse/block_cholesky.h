#pragma once

#include "hexoderm/base/large_memory.h"
#include "hexoderm/base/se3.h"
#include "hexoderm/solve/sparse/front_kernels.h"
#include "hexoderm/solve/sparse/supernodes.h"

#include <cstddef>
#include <memory>
#include <span>
#include <vector>

namespace hexoderm {

/// Right-hand sides as a factor takes them: row by row.
class RightHandSides {
 public:
  using RowMajor = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;
  using View = Eigen::Map<RowMajor, 0, Eigen::OuterStride<>>;
  using ConstView = Eigen::Map<const RowMajor, 0, Eigen::OuterStride<>>;

  RightHandSides() = default;
  /// With anything in it.
  RightHandSides(Eigen::Index rows, Eigen::Index columns);
  [[nodiscard]] View matrix() { return {numbers_.data(), rows_, columns_, Eigen::OuterStride<>(width_)}; }
  [[nodiscard]] ConstView matrix() const { return {numbers_.data(), rows_, columns_, Eigen::OuterStride<>(width_)}; }
  /// Of six rows each, from 6 a and 6 b on, the first times the second's transpose.
  [[nodiscard]] Matrix6d product(std::size_t a, std::size_t b, const FrontKernels& kernels = frontKernels()) const;
  /// This matrix's transpose times itself; its lower triangle.
  [[nodiscard]] Eigen::MatrixXd gram(const FrontKernels& kernels = frontKernels()) const;

 private:
  friend class BlockCholesky;
  [[nodiscard]] RightHandSides columns(Eigen::Index begin, Eigen::Index count) const;
  void putColumns(Eigen::Index begin, const RightHandSides& some);
  template <class Use>
  void inColumns(const Use& use);

  Eigen::Index rows_ = 0;
  Eigen::Index columns_ = 0;
  Eigen::Index width_ = 0;       ///< of a row with zeros that fill it up
  LargeVector<double> numbers_;  ///< some more than the rows need, for kernels that read ahead
};

/// A = L L^T for a sparse symmetric positive definite matrix of 6 x 6 blocks, one block row per cell, its solutions and
/// those blocks of its inverse that stand where A has blocks. For graphs like a skin's, where cells are coupled with a
/// few near ones, the factor of n cells has about n log n blocks and takes about n^1.5 block products. Multifrontal, on
/// dense panels (supernodes.h). Any size: none, one cell, several parts that are not coupled.
///
/// Subtrees of the elimination tree, strips of large fronts and columns of right-hand sides are worked on by several
/// threads (inParallel()); no number depends on how many. One object may be read by several threads; factorize() is not
/// for two at a time.
///
/// Duff and Reid, "The multifrontal solution of indefinite sparse symmetric linear equations", ACM TOMS 9, 1983; for
/// the inverse Takahashi, Fagan and Chin, "Formation of a sparse bus impedance matrix and its application to short
/// circuit study", PICA 1973.
class BlockCholesky {
 public:
  using Couple = BlockCouple;

  /// Blocks of A^-1: (i, i) per block row and (row, column) per couple.
  struct SelectedInverse {
    std::vector<Matrix6d> diagonal;
    std::vector<Matrix6d> couples;
  };

  /// Everything that depends on the pattern alone. Couples: row != column, each unordered pair at most once.
  BlockCholesky(std::size_t size, const std::vector<Couple>& couples, const FrontKernels& kernels = frontKernels());
  BlockCholesky(std::shared_ptr<const SupernodalPattern> pattern, const FrontKernels& kernels = frontKernels());

  /// Block rows.
  [[nodiscard]] std::size_t size() const { return pattern_->order.size(); }
  /// Numbers that the factor consists of.
  [[nodiscard]] std::size_t factorEntries() const { return factor_entries_; }

  /// Factorises the matrix with the blocks `diagonal`, of which only the lower triangles are read, and per couple the
  /// block (row, column); (column, row) is its transpose. False, and no factor: not positive definite or not finite. A
  /// matrix that is singular but for rounding may pass.
  bool factorize(std::span<const Matrix6d> diagonal, std::span<const Matrix6d> couples);
  /// The last factorize() succeeded; what follows needs that.
  [[nodiscard]] bool factorized() const { return factorized_; }

  /// Replaces B, 6 size() x m, by A^-1 B. Many columns in one call are cheaper than one by one.
  void solve(Eigen::MatrixXd& B) const;
  /// The two halves of solve(), L^-1 B and from there L^-T B, on rows in the order of elimination. So A^-1 = (L^-1)^T
  /// (L^-1) in products of solveLower()'s results.
  [[nodiscard]] RightHandSides ordered(const RightHandSides::RowMajor& B) const;
  void solveLower(RightHandSides& B) const;
  void solveUpper(RightHandSides& B) const;
  /// The same for one right-hand side, which takes no more time than it takes to read the factor.
  [[nodiscard]] Eigen::VectorXd orderedVector(const Eigen::VectorXd& b) const;
  void solveLower(Eigen::VectorXd& b) const;
  void solveUpper(Eigen::VectorXd& b) const;
  [[nodiscard]] Eigen::VectorXd vectorInOwnOrder(const Eigen::VectorXd& b) const;
  /// Rows in their own order again; in the same memory.
  [[nodiscard]] RightHandSides inOwnOrder(RightHandSides B) const;

  /// About twice the work of factorize(). The inverse takes the factor's place, so that it needs no more memory than
  /// for one dense front per thread: another factorize() is needed afterwards.
  [[nodiscard]] SelectedInverse selectedInverse() &&;
  /// Its diagonal blocks alone.
  [[nodiscard]] std::vector<Matrix6d> inverseDiagonal() &&;
  /// The same as the first by a copy of the factor.
  [[nodiscard]] SelectedInverse selectedInverse() const& { return BlockCholesky(*this).selectedInverse(); }

 private:
  using Numbers = LargeVector<double>;
  struct Blocks {
    std::span<const Matrix6d> diagonal;
    std::span<const Matrix6d> couples;
  };
  /// All supernodes from `first` to `root`.
  struct Subtree {
    std::size_t first = 0;
    std::size_t root = 0;
  };
  void findSubtrees();
  const double* panel(std::size_t supernode) const { return factor_.data() + panel_begin_[supernode]; }
  void assemble(std::size_t supernode, const Blocks& A);
  bool eliminate(std::size_t supernode, const Blocks& A, std::vector<Numbers>& updates);
  struct InverseWorkspace {
    InverseWorkspace(std::span<const Supernode> supernodes, std::span<const Subtree> parts);
    Numbers front;
    Numbers products;
  };
  void gather(std::size_t supernode, double* front) const;
  /// Couples are left out where `inverse` has no room for any.
  void invert(std::size_t supernode, InverseWorkspace& workspace, SelectedInverse& inverse);
  void invertDown(std::span<const Subtree> parts, SelectedInverse& inverse);
  void takeInverse(SelectedInverse& inverse);

  std::shared_ptr<const SupernodalPattern> pattern_;
  const FrontKernels& kernels_;
  std::vector<std::size_t> panel_begin_;  ///< per supernode, in factor_
  std::size_t factor_entries_ = 0;
  std::size_t most_rows_ = 0;      ///< below the pivots of a supernode, in numbers
  std::vector<Subtree> subtrees_;  ///< that are worked on side by side, ascending
  Numbers factor_;  ///< per supernode a panel of (pivots + rows) x pivots blocks; above the diagonal anything
  bool factorized_ = false;
};

}  // namespace hexoderm
