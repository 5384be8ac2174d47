#include "hexoderm/reconstruction/sparse/block_cholesky.h"

#include <algorithm>
#include <cassert>
#include <utility>

namespace hexoderm {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

constexpr Index kBlock = 6;

using Square = Eigen::Map<const Eigen::Matrix<double, kBlock, kBlock>, 0, Eigen::OuterStride<>>;

Index numbersIn(std::size_t blocks) { return kBlock * static_cast<Index>(blocks); }
Index pivotsOf(const Supernode& node) { return numbersIn(node.pivots); }
Index rowsOf(const Supernode& node) { return numbersIn(node.rows.size()); }
Index frontOf(const Supernode& node) { return pivotsOf(node) + rowsOf(node); }
/// Numbers from one column of the panel to the next.
Index panelStride(const Supernode& node) { return FrontKernels::paddedRows(frontOf(node)); }
Index updateStride(const Supernode& node) { return FrontKernels::paddedRows(rowsOf(node)); }
std::size_t updateSize(const Supernode& node) { return static_cast<std::size_t>(updateStride(node) * rowsOf(node)); }
std::size_t frontSize(const Supernode& node) { return static_cast<std::size_t>(panelStride(node) * frontOf(node)); }

/// Rows of a supernode that stand side by side in its parent's front, too; in numbers.
struct Run {
  Index begin = 0;
  Index in_parent = 0;
  Index length = 0;
};

void findRuns(const Supernode& node, std::vector<Run>& runs) {
  runs.clear();
  for (std::size_t k = 0; k < node.in_parent.size(); ++k) {
    if (k > 0 && node.in_parent[k] == node.in_parent[k - 1] + 1) {
      runs.back().length += kBlock;
    } else {
      runs.push_back({numbersIn(k), numbersIn(node.in_parent[k]), kBlock});
    }
  }
}

void addNumbers(double* to, const double* from, Index count) {
  for (Index k = 0; k < count; ++k) to[k] += from[k];
}

/// Adds what a child's elimination leaves to its parent's front: `panel` its first columns, `rest` the others. Lower
/// triangles.
void addToParent(const std::vector<Run>& runs, const double* update, Index stride, const Supernode& parent,
                 double* panel, double* rest) {
  const Index pivots = pivotsOf(parent);
  for (std::size_t r = 0; r < runs.size(); ++r) {
    for (Index c = 0; c < runs[r].length; ++c) {
      const double* source = update + (runs[r].begin + c) * stride;
      const Index column = runs[r].in_parent + c;
      double* target = column < pivots ? panel + column * panelStride(parent)
                                       : rest + (column - pivots) * updateStride(parent) - pivots;
      const Index above = c / kBlock * kBlock;  // in the run, above the diagonal
      addNumbers(target + runs[r].in_parent + above, source + runs[r].begin + above, runs[r].length - above);
      for (std::size_t k = r + 1; k < runs.size(); ++k) {
        addNumbers(target + runs[k].in_parent, source + runs[k].begin, runs[k].length);
      }
    }
  }
}

}  // namespace

RightSides::RightSides(Index rows, Index columns)
    : rows_(rows),
      columns_(columns),
      width_((columns + 3) / 4 * 4),
      numbers_(static_cast<std::size_t>(rows * width_ + 2 * kBlock)) {}

Matrix6d RightSides::product(std::size_t a, std::size_t b, const FrontKernels& kernels) const {
  Matrix6d product = Matrix6d::Zero();
  const double* const rows = numbers_.data();
  kernels.subtractRows(product.data(), rows + numbersIn(a) * width_, rows + numbersIn(b) * width_, width_);
  return -product;
}

MatrixXd RightSides::gram(const FrontKernels& kernels) const {
  const Index stride = FrontKernels::paddedRows(width_);
  MatrixXd product = MatrixXd::Zero(stride, (columns_ + kBlock - 1) / kBlock * kBlock);
  kernels.subtractOuter(product.data(), stride, numbers_.data(), width_, numbers_.data(), width_, width_, columns_,
                        rows_);
  return -product.topLeftCorner(columns_, columns_);
}

BlockCholesky::BlockCholesky(std::size_t size, const std::vector<Couple>& couples, const FrontKernels& kernels)
    : BlockCholesky(std::make_shared<const SupernodalPattern>(analysePattern(size, couples)), kernels) {}

BlockCholesky::BlockCholesky(std::shared_ptr<const SupernodalPattern> pattern, const FrontKernels& kernels)
    : pattern_(std::move(pattern)), kernels_(kernels) {
  std::size_t numbers = 0;
  std::size_t stack = 0;
  panel_begin_.reserve(pattern_->supernodes.size() + 1);
  for (const Supernode& node : pattern_->supernodes) {
    panel_begin_.push_back(numbers);
    numbers += static_cast<std::size_t>(pivotsOf(node) * panelStride(node));
    factor_entries_ += static_cast<std::size_t>(pivotsOf(node) * frontOf(node));
    most_rows_ = std::max(most_rows_, static_cast<std::size_t>(rowsOf(node)));
    // A supernode's update is made on top of its children's, which it then replaces.
    most_updates_ = std::max(most_updates_, stack + updateSize(node));
    for (const std::size_t child : node.children) stack -= updateSize(pattern_->supernodes[child]);
    stack += updateSize(node);
  }
  panel_begin_.push_back(numbers);
}

/// The matrix's own elements in the columns of a supernode.
void BlockCholesky::assemble(std::size_t supernode, std::span<const Matrix6d> diagonal,
                             std::span<const Matrix6d> couples) {
  const Supernode& node = pattern_->supernodes[supernode];
  double* const numbers = factor_.data() + panel_begin_[supernode];
  std::fill(numbers, factor_.data() + panel_begin_[supernode + 1], 0.0);
  const Index stride = panelStride(node);
  const auto block = [&](std::size_t row, std::size_t column) {
    return Eigen::Map<Eigen::Matrix<double, kBlock, kBlock>, 0, Eigen::OuterStride<>>(
        numbers + numbersIn(row) + numbersIn(column) * stride, Eigen::OuterStride<>(stride));
  };
  for (std::size_t p = 0; p < node.pivots; ++p) block(p, p) = diagonal[pattern_->order[node.first + p]];
  for (const Supernode::Entry& entry : node.entries) {
    if (entry.transposed) {
      block(entry.row, entry.column) = couples[entry.couple].transpose();
    } else {
      block(entry.row, entry.column) = couples[entry.couple];
    }
  }
}

bool BlockCholesky::factorize(std::span<const Matrix6d> diagonal, std::span<const Matrix6d> couples) {
  assert(diagonal.size() == size() && couples.size() == pattern_->couples);
  factorized_ = false;
  factor_.resize(panel_begin_.back());
  updates_.resize(most_updates_);
  std::vector<std::size_t> update_begin(pattern_->supernodes.size());
  std::size_t top = 0;
  std::vector<Run> runs;
  for (std::size_t s = 0; s < pattern_->supernodes.size(); ++s) {
    const Supernode& node = pattern_->supernodes[s];
    const Index stride = panelStride(node);
    assemble(s, diagonal, couples);
    double* const L = factor_.data() + panel_begin_[s];
    double* const update = updates_.data() + top;
    std::fill_n(update, updateSize(node), 0.0);
    for (const std::size_t child : node.children) {
      const Supernode& below = pattern_->supernodes[child];
      findRuns(below, runs);
      addToParent(runs, updates_.data() + update_begin[child], updateStride(below), node, L, update);
    }
    if (!kernels_.factorize(L, stride, frontOf(node), pivotsOf(node))) return false;
    const double* const L_rp = L + pivotsOf(node);
    if (!node.rows.empty()) {
      kernels_.subtractOuter(update, updateStride(node), L_rp, stride, L_rp, stride, rowsOf(node), rowsOf(node),
                             pivotsOf(node));
    }
    update_begin[s] = node.children.empty() ? top : update_begin[node.children.front()];
    if (update_begin[s] != top) std::copy_n(update, updateSize(node), updates_.data() + update_begin[s]);
    top = update_begin[s] + updateSize(node);
  }
  factorized_ = true;
  return true;
}

RightSides BlockCholesky::ordered(const MatrixXd& B) const {
  assert(B.rows() == numbersIn(size()));
  RightSides rows(B.rows(), B.cols());
  auto matrix = rows.matrix();
  for (std::size_t k = 0; k < size(); ++k) {
    matrix.middleRows<kBlock>(numbersIn(k)) = B.middleRows<kBlock>(numbersIn(pattern_->order[k]));
  }
  return rows;
}

RightSides BlockCholesky::inOwnOrder(const RightSides& B) const {
  RightSides rows(B.rows_, B.columns_);
  const Index block = kBlock * B.width_;
  for (std::size_t k = 0; k < size(); ++k) {
    std::copy_n(B.numbers_.data() + static_cast<Index>(k) * block, block,
                rows.numbers_.data() + static_cast<Index>(pattern_->order[k]) * block);
  }
  return rows;
}

void BlockCholesky::solveLower(RightSides& B) const {
  assert(factorized_ && B.rows_ == numbersIn(size()));
  for (std::size_t s = 0; s < pattern_->supernodes.size(); ++s) {
    const Supernode& node = pattern_->supernodes[s];
    kernels_.substituteForward(panel(s), panelStride(node), pivotsOf(node), node.first, node.rows.data(),
                               node.rows.size(), B.numbers_.data(), B.width_);
  }
}

void BlockCholesky::solveUpper(RightSides& B) const {
  assert(factorized_ && B.rows_ == numbersIn(size()));
  std::vector<double> workspace(most_rows_ * static_cast<std::size_t>(B.width_));
  for (std::size_t s = pattern_->supernodes.size(); s-- > 0;) {
    const Supernode& node = pattern_->supernodes[s];
    kernels_.substituteBack(panel(s), panelStride(node), pivotsOf(node), node.first, node.rows.data(), node.rows.size(),
                            B.numbers_.data(), B.width_, workspace.data());
  }
}

VectorXd BlockCholesky::orderedVector(const VectorXd& b) const {
  assert(b.size() == numbersIn(size()));
  VectorXd rows(b.size());
  for (std::size_t k = 0; k < size(); ++k) {
    rows.segment<kBlock>(numbersIn(k)) = b.segment<kBlock>(numbersIn(pattern_->order[k]));
  }
  return rows;
}

VectorXd BlockCholesky::vectorInOwnOrder(const VectorXd& b) const {
  VectorXd rows(b.size());
  for (std::size_t k = 0; k < size(); ++k) {
    rows.segment<kBlock>(numbersIn(pattern_->order[k])) = b.segment<kBlock>(numbersIn(k));
  }
  return rows;
}

void BlockCholesky::solveLower(VectorXd& b) const {
  assert(factorized_ && b.size() == numbersIn(size()));
  std::vector<double> workspace(most_rows_);
  for (std::size_t s = 0; s < pattern_->supernodes.size(); ++s) {
    const Supernode& node = pattern_->supernodes[s];
    kernels_.substituteVectorForward(panel(s), panelStride(node), pivotsOf(node), node.first, node.rows.data(),
                                     node.rows.size(), b.data(), workspace.data());
  }
}

void BlockCholesky::solveUpper(VectorXd& b) const {
  assert(factorized_ && b.size() == numbersIn(size()));
  std::vector<double> workspace(most_rows_);
  for (std::size_t s = pattern_->supernodes.size(); s-- > 0;) {
    const Supernode& node = pattern_->supernodes[s];
    kernels_.substituteVectorBack(panel(s), panelStride(node), pivotsOf(node), node.first, node.rows.data(),
                                  node.rows.size(), b.data(), workspace.data());
  }
}

void BlockCholesky::solve(MatrixXd& B) const {
  constexpr Index kAtATime = 48;  // columns that stay in the cache
  for (Index begin = 0; begin < B.cols(); begin += kAtATime) {
    const Index count = std::min(kAtATime, B.cols() - begin);
    RightSides rows = ordered(B.middleCols(begin, count));
    solveLower(rows);
    solveUpper(rows);
    B.middleCols(begin, count) = inOwnOrder(rows).matrix();
  }
}

/// What is known of a front of the inverse from its parent's: the rows after the pivots.
void BlockCholesky::gather(std::size_t supernode, const double* parent_front, double* front) const {
  const Supernode& node = pattern_->supernodes[supernode];
  const Index parent_stride = panelStride(pattern_->supernodes[node.parent]);
  const Index stride = panelStride(node);
  double* const rest = front + pivotsOf(node) * (stride + 1);
  std::vector<Run> runs;
  findRuns(node, runs);
  for (const Run& columns : runs) {
    for (Index c = 0; c < columns.length; ++c) {
      const double* source = parent_front + (columns.in_parent + c) * parent_stride;
      double* target = rest + (columns.begin + c) * stride;
      for (const Run& run : runs) std::copy_n(source + run.in_parent, run.length, target + run.begin);
    }
  }
}

BlockCholesky::SelectedInverse BlockCholesky::selectedInverse() const {
  assert(factorized_);
  SelectedInverse inverse{std::vector<Matrix6d>(size()), std::vector<Matrix6d>(pattern_->couples)};
  const std::vector<Supernode>& supernodes = pattern_->supernodes;
  // Parents before their children, a whole subtree before the next: those that are still needed are on one way up the
  // tree.
  std::vector<std::size_t> begin(supernodes.size());
  std::vector<std::size_t> way;
  std::size_t numbers = 0;
  std::size_t most_in_workspace = 0;
  for (std::size_t s = supernodes.size(); s-- > 0;) {
    const Supernode& node = supernodes[s];
    while (!way.empty() && (node.rows.empty() || way.back() != node.parent)) way.pop_back();
    begin[s] = way.empty() ? 0 : begin[way.back()] + frontSize(supernodes[way.back()]);
    way.push_back(s);
    numbers = std::max(numbers, begin[s] + frontSize(node));
    most_in_workspace = std::max(
        most_in_workspace, static_cast<std::size_t>(FrontKernels::inverseWorkspace(frontOf(node), pivotsOf(node))));
  }
  std::vector<double> fronts(numbers);
  std::vector<double> workspace(most_in_workspace);
  for (std::size_t s = supernodes.size(); s-- > 0;) {
    const Supernode& node = supernodes[s];
    double* const Z = fronts.data() + begin[s];
    const Index stride = panelStride(node);
    if (!node.rows.empty()) gather(s, fronts.data() + begin[node.parent], Z);
    kernels_.invert(Z, stride, panel(s), stride, frontOf(node), pivotsOf(node), workspace.data());

    const auto block = [&](std::size_t row, std::size_t column) {
      return Square(Z + numbersIn(row) + numbersIn(column) * stride, Eigen::OuterStride<>(stride));
    };
    for (std::size_t p = 0; p < node.pivots; ++p) inverse.diagonal[pattern_->order[node.first + p]] = block(p, p);
    for (const Supernode::Entry& entry : node.entries) {
      const Square found = block(entry.row, entry.column);
      if (entry.transposed) {
        inverse.couples[entry.couple] = found.transpose();
      } else {
        inverse.couples[entry.couple] = found;
      }
    }
  }
  return inverse;
}

}  // namespace hexoderm
