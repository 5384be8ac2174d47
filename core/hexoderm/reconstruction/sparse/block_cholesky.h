#pragma once

#include "hexoderm/geometry/se3.h"
#include "hexoderm/reconstruction/sparse/supernodes.h"

#include <cstddef>
#include <span>
#include <vector>

namespace hexoderm {

/// A = L L^T for a sparse symmetric positive definite matrix of 6 x 6 blocks, one block row per cell, its solutions and
/// those blocks of its inverse that stand where A has blocks. For graphs like a skin's, where cells are coupled with a
/// few near ones, the factor of n cells has about n log n blocks and takes about n^1.5 block products. Multifrontal, on
/// dense panels (supernodes.h). Any size: none, one cell, several parts that are not coupled.
///
/// One object may be read by several threads; factorize() is not for two at a time. Deterministic.
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
  BlockCholesky(std::size_t size, const std::vector<Couple>& couples);

  /// Block rows.
  [[nodiscard]] std::size_t size() const { return pattern_.order.size(); }
  /// Numbers that the factor is stored as.
  [[nodiscard]] std::size_t factorEntries() const { return factor_entries_; }

  /// Factorises the matrix with the blocks `diagonal`, of which only the lower triangles are read, and per couple the
  /// block (row, column); (column, row) is its transpose. False, and no factor: not positive definite or not finite. A
  /// matrix that is singular but for rounding may pass.
  bool factorize(std::span<const Matrix6d> diagonal, std::span<const Matrix6d> couples);
  /// The last factorize() succeeded; what follows needs that.
  [[nodiscard]] bool factorized() const { return factorized_; }

  /// Replaces B, 6 size() x m, by A^-1 B. Many columns in one call are cheaper than one by one.
  void solve(Eigen::MatrixXd& B) const;
  /// The two halves of solve(): B becomes L^-1 B, its rows in the order of elimination, and from there L^-T B, its rows
  /// in their own order again. So A^-1 = (L^-1)^T (L^-1) in products of solveLower()'s results.
  void solveLower(Eigen::MatrixXd& B) const;
  void solveUpper(Eigen::MatrixXd& B) const;

  /// About twice the work of factorize(); needs memory for the dense fronts on one way up the elimination tree.
  [[nodiscard]] SelectedInverse selectedInverse() const;

 private:
  using Panel = Eigen::Map<Eigen::MatrixXd>;
  using ConstPanel = Eigen::Map<const Eigen::MatrixXd>;

  Panel panel(std::size_t supernode);
  [[nodiscard]] ConstPanel panel(std::size_t supernode) const;
  template <int Columns>
  void substituteForward(Eigen::Ref<Eigen::Matrix<double, Eigen::Dynamic, Columns>> X) const;
  template <int Columns>
  void substituteBack(Eigen::Ref<Eigen::Matrix<double, Eigen::Dynamic, Columns>> X) const;

  SupernodalPattern pattern_;
  std::size_t couple_count_ = 0;
  std::vector<std::size_t> panel_begin_;  ///< per supernode, in factor_
  std::size_t factor_entries_ = 0;
  Eigen::VectorXd factor_;  ///< per supernode (pivots + rows) x pivots blocks by columns; above the diagonal anything
  bool factorized_ = false;
};

}  // namespace hexoderm
