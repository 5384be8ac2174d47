#include "hexoderm/reconstruction/sparse/block_cholesky.h"

#include <Eigen/Cholesky>
#include <algorithm>
#include <cassert>

namespace hexoderm {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;

constexpr Index kBlock = 6;

Index pivotsOf(const Supernode& node) { return kBlock * static_cast<Index>(node.pivots); }
Index rowsOf(const Supernode& node) { return kBlock * static_cast<Index>(node.rows.size()); }

/// Adds what a child's elimination leaves to its parent's front: `panel` its first columns, `update` the rest.
template <typename Panel>
void addToParent(const Supernode& child, const MatrixXd& left, Panel& panel, MatrixXd& update) {
  const Index pivots = panel.cols();
  const std::vector<std::size_t>& place = child.in_parent;
  for (std::size_t b = 0; b < place.size(); ++b) {
    const Index column = kBlock * static_cast<Index>(place[b]);
    for (Index c = 0; c < kBlock; ++c) {
      const double* source = left.col(kBlock * static_cast<Index>(b) + c).data();
      double* target = column < pivots ? panel.col(column + c).data() : update.col(column - pivots + c).data() - pivots;
      for (std::size_t a = b; a < place.size(); ++a) {
        const double* from = source + kBlock * a;
        double* to = target + kBlock * place[a];
        for (Index r = 0; r < kBlock; ++r) to[r] += from[r];
      }
    }
  }
}

/// The lower triangle of a child's rows and columns in its parent's front.
template <typename Target>
void takeFromParent(const Supernode& child, const MatrixXd& front, Target&& part) {
  const std::vector<std::size_t>& place = child.in_parent;
  for (std::size_t b = 0; b < place.size(); ++b) {
    for (Index c = 0; c < kBlock; ++c) {
      const double* source = front.col(kBlock * static_cast<Index>(place[b]) + c).data();
      double* target = part.col(kBlock * static_cast<Index>(b) + c).data();
      for (std::size_t a = b; a < place.size(); ++a) {
        std::copy_n(source + kBlock * place[a], kBlock, target + kBlock * a);
      }
    }
  }
}

/// A single column, or so many at a time that they stay in the cache.
template <typename Work>
void forSomeColumns(MatrixXd& B, Work&& work) {
  constexpr Index kAtATime = 48;
  for (Index begin = 0; begin < B.cols(); begin += kAtATime) {
    const Index count = std::min(kAtATime, B.cols() - begin);
    if (count == 1) {
      work(Eigen::Ref<Eigen::VectorXd>(B.col(begin)));
    } else {
      work(Eigen::Ref<MatrixXd>(B.middleCols(begin, count)));
    }
  }
}

}  // namespace

BlockCholesky::BlockCholesky(std::size_t size, const std::vector<Couple>& couples)
    : pattern_(analysePattern(size, couples)), couple_count_(couples.size()) {
  panel_begin_.reserve(pattern_.supernodes.size());
  for (const Supernode& node : pattern_.supernodes) {
    panel_begin_.push_back(factor_entries_);
    factor_entries_ += static_cast<std::size_t>(pivotsOf(node) * (pivotsOf(node) + rowsOf(node)));
  }
}

BlockCholesky::Panel BlockCholesky::panel(std::size_t supernode) {
  const Supernode& node = pattern_.supernodes[supernode];
  return {factor_.data() + panel_begin_[supernode], pivotsOf(node) + rowsOf(node), pivotsOf(node)};
}

BlockCholesky::ConstPanel BlockCholesky::panel(std::size_t supernode) const {
  const Supernode& node = pattern_.supernodes[supernode];
  return {factor_.data() + panel_begin_[supernode], pivotsOf(node) + rowsOf(node), pivotsOf(node)};
}

bool BlockCholesky::factorize(std::span<const Matrix6d> diagonal, std::span<const Matrix6d> couples) {
  assert(diagonal.size() == size() && couples.size() == couple_count_);
  factorized_ = false;
  factor_.resize(static_cast<Index>(factor_entries_));
  std::vector<MatrixXd> updates(pattern_.supernodes.size());
  for (std::size_t s = 0; s < pattern_.supernodes.size(); ++s) {
    const Supernode& node = pattern_.supernodes[s];
    const Index pivots = pivotsOf(node);
    const Index rows = rowsOf(node);
    Panel L = panel(s);
    L.setZero();
    for (std::size_t p = 0; p < node.pivots; ++p) {
      const Index at = kBlock * static_cast<Index>(p);
      L.block<kBlock, kBlock>(at, at) = diagonal[pattern_.order[node.first + p]];
    }
    for (const Supernode::Entry& entry : node.entries) {
      auto block =
          L.block<kBlock, kBlock>(kBlock * static_cast<Index>(entry.row), kBlock * static_cast<Index>(entry.column));
      if (entry.transposed) {
        block = couples[entry.couple].transpose();
      } else {
        block = couples[entry.couple];
      }
    }
    MatrixXd& update = updates[s];
    update.setZero(rows, rows);
    for (const std::size_t child : node.children) {
      addToParent(pattern_.supernodes[child], updates[child], L, update);
      updates[child].resize(0, 0);
    }

    Eigen::Ref<MatrixXd> L_pp = L.topRows(pivots);
    const Eigen::LLT<Eigen::Ref<MatrixXd>> llt(L_pp);
    // A number that is not finite, here or further up the tree, has reached the diagonal.
    if (llt.info() != Eigen::Success || !L_pp.diagonal().allFinite()) return false;
    if (rows == 0) continue;
    auto L_rp = L.bottomRows(rows);
    L_pp.transpose().triangularView<Eigen::Upper>().solveInPlace<Eigen::OnTheRight>(L_rp);
    update.selfadjointView<Eigen::Lower>().rankUpdate(L_rp, -1.0);
  }
  factorized_ = true;
  return true;
}

template <int Columns>
void BlockCholesky::substituteForward(Eigen::Ref<Eigen::Matrix<double, Eigen::Dynamic, Columns>> X) const {
  Eigen::Matrix<double, Eigen::Dynamic, Columns> at_rows;
  for (std::size_t s = 0; s < pattern_.supernodes.size(); ++s) {
    const Supernode& node = pattern_.supernodes[s];
    const ConstPanel L = panel(s);
    auto X_p = X.middleRows(kBlock * static_cast<Index>(node.first), L.cols());
    L.topRows(L.cols()).template triangularView<Eigen::Lower>().solveInPlace(X_p);
    at_rows.noalias() = L.bottomRows(rowsOf(node)) * X_p;
    for (Index c = 0; c < X.cols(); ++c) {
      for (std::size_t r = 0; r < node.rows.size(); ++r) {
        X.col(c).template segment<kBlock>(kBlock * static_cast<Index>(node.rows[r])) -=
            at_rows.col(c).template segment<kBlock>(kBlock * static_cast<Index>(r));
      }
    }
  }
}

template <int Columns>
void BlockCholesky::substituteBack(Eigen::Ref<Eigen::Matrix<double, Eigen::Dynamic, Columns>> X) const {
  Eigen::Matrix<double, Eigen::Dynamic, Columns> at_rows;
  for (std::size_t s = pattern_.supernodes.size(); s-- > 0;) {
    const Supernode& node = pattern_.supernodes[s];
    const ConstPanel L = panel(s);
    auto X_p = X.middleRows(kBlock * static_cast<Index>(node.first), L.cols());
    at_rows.resize(rowsOf(node), X.cols());
    for (Index c = 0; c < X.cols(); ++c) {
      for (std::size_t r = 0; r < node.rows.size(); ++r) {
        at_rows.col(c).template segment<kBlock>(kBlock * static_cast<Index>(r)) =
            X.col(c).template segment<kBlock>(kBlock * static_cast<Index>(node.rows[r]));
      }
    }
    X_p.noalias() -= L.bottomRows(rowsOf(node)).transpose() * at_rows;
    L.topRows(L.cols()).transpose().template triangularView<Eigen::Upper>().solveInPlace(X_p);
  }
}

void BlockCholesky::solveLower(MatrixXd& B) const {
  assert(factorized_ && B.rows() == kBlock * static_cast<Index>(size()));
  MatrixXd X(B.rows(), B.cols());
  for (std::size_t k = 0; k < size(); ++k) {
    X.middleRows<kBlock>(kBlock * static_cast<Index>(k)) =
        B.middleRows<kBlock>(kBlock * static_cast<Index>(pattern_.order[k]));
  }
  B.swap(X);
  forSomeColumns(B, [this](auto columns) { substituteForward<decltype(columns)::ColsAtCompileTime>(columns); });
}

void BlockCholesky::solveUpper(MatrixXd& B) const {
  assert(factorized_ && B.rows() == kBlock * static_cast<Index>(size()));
  forSomeColumns(B, [this](auto columns) { substituteBack<decltype(columns)::ColsAtCompileTime>(columns); });
  MatrixXd X(B.rows(), B.cols());
  for (std::size_t k = 0; k < size(); ++k) {
    X.middleRows<kBlock>(kBlock * static_cast<Index>(pattern_.order[k])) =
        B.middleRows<kBlock>(kBlock * static_cast<Index>(k));
  }
  B.swap(X);
}

void BlockCholesky::solve(MatrixXd& B) const {
  solveLower(B);
  solveUpper(B);
}

BlockCholesky::SelectedInverse BlockCholesky::selectedInverse() const {
  assert(factorized_);
  SelectedInverse inverse{std::vector<Matrix6d>(size()), std::vector<Matrix6d>(couple_count_)};
  // With Z = A^-1 and W = L_rp L_pp^-1: Z_rp = -Z_rr W, Z_pp = (L_pp L_pp^T)^-1 - W^T Z_rp. The rows of a front are in
  // its parent's, whose part of Z is known by then.
  std::vector<MatrixXd> fronts(pattern_.supernodes.size());  // lower triangles
  for (std::size_t s = pattern_.supernodes.size(); s-- > 0;) {
    const Supernode& node = pattern_.supernodes[s];
    const ConstPanel L = panel(s);
    const auto L_pp = L.topRows(L.cols()).triangularView<Eigen::Lower>();
    const Index rows = rowsOf(node);
    MatrixXd& Z = fronts[s];
    Z.resize(L.rows(), L.rows());
    MatrixXd Z_pp = MatrixXd::Identity(L.cols(), L.cols());
    L_pp.solveInPlace(Z_pp);
    L_pp.transpose().solveInPlace(Z_pp);
    if (rows > 0) {
      MatrixXd& parent_front = fronts[node.parent];
      auto Z_rr = Z.bottomRightCorner(rows, rows);
      takeFromParent(node, parent_front, Z_rr);
      if (pattern_.supernodes[node.parent].children.front() == s) parent_front.resize(0, 0);
      MatrixXd W = L.bottomRows(rows);
      L_pp.solveInPlace<Eigen::OnTheRight>(W);
      auto Z_rp = Z.bottomLeftCorner(rows, L.cols());
      Z_rp.noalias() = -(Z_rr.selfadjointView<Eigen::Lower>() * W);
      Z_pp.noalias() -= W.transpose() * Z_rp;
    }
    Z.topLeftCorner(L.cols(), L.cols()) = (Z_pp + Z_pp.transpose()) / 2;

    for (std::size_t p = 0; p < node.pivots; ++p) {
      const Index at = kBlock * static_cast<Index>(p);
      inverse.diagonal[pattern_.order[node.first + p]] = Z.block<kBlock, kBlock>(at, at);
    }
    for (const Supernode::Entry& entry : node.entries) {
      const Matrix6d block =
          Z.block<kBlock, kBlock>(kBlock * static_cast<Index>(entry.row), kBlock * static_cast<Index>(entry.column));
      inverse.couples[entry.couple] = entry.transposed ? Matrix6d(block.transpose()) : block;
    }
    if (node.children.empty()) Z.resize(0, 0);
  }
  return inverse;
}

}  // namespace hexoderm
