#include "hexoderm/solve/sparse/block_cholesky.h"

#include "hexoderm/base/parallel.h"

#include <algorithm>
#include <atomic>
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

/// Rows of a supernode that stand side by side in a front above it, too; in numbers.
struct Run {
  Index begin = 0;
  Index above = 0;
  Index length = 0;
};

/// `places`: of rows, in the front above.
void findRuns(std::span<const std::size_t> places, std::vector<Run>& runs) {
  runs.clear();
  for (std::size_t k = 0; k < places.size(); ++k) {
    if (k > 0 && places[k] == places[k - 1] + 1) {
      runs.back().length += kBlock;
    } else {
      runs.push_back({numbersIn(k), numbersIn(places[k]), kBlock});
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
      const Index column = runs[r].above + c;
      double* target = column < pivots ? panel + column * panelStride(parent)
                                       : rest + (column - pivots) * updateStride(parent) - pivots;
      const Index above = c / kBlock * kBlock;  // in the run, above the diagonal
      addNumbers(target + runs[r].above + above, source + runs[r].begin + above, runs[r].length - above);
      for (std::size_t k = r + 1; k < runs.size(); ++k) {
        addNumbers(target + runs[k].above, source + runs[k].begin, runs[k].length);
      }
    }
  }
}

/// The lower triangle of a matrix of `rows` x `columns`, with whole blocks on the diagonal.
void clearLower(double* numbers, Index stride, Index rows, Index columns) {
  for (Index column = 0; column < columns; ++column) {
    const Index top = column / kBlock * kBlock;
    std::fill(numbers + column * stride + top, numbers + column * stride + rows, 0.0);
  }
}

/// What is above the diagonal becomes what is below it; blocks on the diagonal are whole.
void mirrorLower(double* numbers, Index stride, Index size) {
  for (Index column = 0; column < size; column += kBlock) {
    for (Index row = column + kBlock; row < size; row += kBlock) {
      const double* const from = numbers + column * stride + row;
      double* const to = numbers + row * stride + column;
      for (Index i = 0; i < kBlock; ++i) {
        for (Index j = 0; j < kBlock; ++j) to[i * stride + j] = from[j * stride + i];
      }
    }
  }
}

/// About how many products it takes to eliminate a supernode.
double workOf(const Supernode& node) {
  const auto front = static_cast<double>(frontOf(node));
  return static_cast<double>(pivotsOf(node)) * front * front;
}

/// So many products pay for a thread.
constexpr double kMinWork = 1e7;

/// C -= A A^T, the lower triangle of as many columns, in strips of columns side by side.
void subtractOwnOuter(const FrontKernels& kernels, double* c, Index ldc, const double* a, Index lda, Index rows,
                      Index columns, Index depth) {
  constexpr Index kStrip = 2 * FrontKernels::kMaxPivotsAtOnce;
  if (static_cast<double>(rows * columns) * static_cast<double>(depth) < kMinWork) {
    return kernels.subtractOuter(c, ldc, a, lda, a, lda, rows, columns, depth);
  }
  inRanges(static_cast<std::size_t>(columns), kStrip, [&](std::size_t begin, std::size_t end) {
    const auto from = static_cast<Index>(begin);
    kernels.subtractOuter(c + from * ldc + from, ldc, a + from, lda, a + from, lda, rows - from,
                          static_cast<Index>(end - begin), depth);
  });
}

/// A panel becomes columns of the factor; a wide one some at a time, and what they take from those behind them side by
/// side.
bool factorizePanel(const FrontKernels& kernels, double* L, Index stride, Index front, Index pivots) {
  constexpr Index kAtOnce = FrontKernels::kMaxPivotsAtOnce;
  constexpr Index kWide = 6 * kAtOnce;
  if (pivots <= kWide) return kernels.factorize(L, stride, front, pivots);
  for (Index left = 0; left < pivots; left += kAtOnce) {
    const Index right = std::min(pivots, left + kAtOnce);
    double* const square = L + left * stride + left;
    if (!kernels.factorize(square, stride, front - left, right - left)) return false;
    if (right == pivots) break;
    subtractOwnOuter(kernels, L + right * stride + right, stride, square + (right - left), stride, front - right,
                     pivots - right, right - left);
  }
  return true;
}

/// The columns of a front's pivots in the inverse, some at a time, the last first: those behind them are among the rows
/// that are known then. Strips of rows side by side.
void invertFront(const FrontKernels& kernels, double* Z, const double* L, Index stride, Index front, Index pivots,
                 double* workspace) {
  constexpr Index kAtOnce = FrontKernels::kMaxPivotsAtOnce;
  constexpr Index kStrip = 4 * kAtOnce;
  for (Index left = (pivots - 1) / kAtOnce * kAtOnce; left >= 0; left -= kAtOnce) {
    const Index right = std::min(pivots, left + kAtOnce);
    const Index below = front - right;
    kernels.beginInverse(Z, stride, L, stride, front, left, right, workspace);
    if (below == 0) continue;
    if (static_cast<double>(below * below) * static_cast<double>(right - left) < kMinWork) {
      kernels.inverseBelow(Z, stride, front, left, right, right, front, workspace);
    } else {
      inRanges(static_cast<std::size_t>(below), kStrip, [&](std::size_t begin, std::size_t end) {
        kernels.inverseBelow(Z, stride, front, left, right, right + static_cast<Index>(begin),
                             right + static_cast<Index>(end), workspace);
      });
    }
    kernels.endInverse(Z, stride, front, left, right, workspace);
  }
}

/// How many subtrees are worked on before what is above them: more than cores, for they are not equally large.
std::size_t subtreesAtOnce() {
  const std::size_t free = freeCores();
  return free == 0 ? 1 : 2 * (1 + free);
}

}  // namespace

RightHandSides::RightHandSides(Index rows, Index columns)
    : rows_(rows),
      columns_(columns),
      width_((columns + 3) / 4 * 4),
      numbers_(static_cast<std::size_t>(rows * width_ + 2 * kBlock)) {
  if (columns_ < width_) {
    for (Index row = 0; row < rows; ++row) {
      std::fill_n(numbers_.data() + row * width_ + columns_, width_ - columns_, 0.0);
    }
  }
  std::fill(numbers_.end() - 2 * kBlock, numbers_.end(), 0.0);
}

Matrix6d RightHandSides::product(std::size_t a, std::size_t b, const FrontKernels& kernels) const {
  Matrix6d product = Matrix6d::Zero();
  const double* const rows = numbers_.data();
  kernels.subtractRows(product.data(), rows + numbersIn(a) * width_, rows + numbersIn(b) * width_, width_);
  return -product;
}

/// Some of the columns, from a multiple of four on.
RightHandSides RightHandSides::columns(Index begin, Index count) const {
  RightHandSides some(rows_, count);
  for (Index row = 0; row < rows_; ++row) {
    std::copy_n(numbers_.data() + row * width_ + begin, std::min(some.width_, width_ - begin),
                some.numbers_.data() + row * some.width_);
  }
  return some;
}

void RightHandSides::putColumns(Index begin, const RightHandSides& some) {
  for (Index row = 0; row < rows_; ++row) {
    std::copy_n(some.numbers_.data() + row * some.width_, std::min(some.width_, width_ - begin),
                numbers_.data() + row * width_ + begin);
  }
}

/// Calls use(B), or with groups of its columns side by side, where that pays.
template <class Use>
void RightHandSides::inColumns(const Use& use) {
  constexpr Index kSideBySide = 4;
  constexpr Index kMinRows = 10000;
  // Each group reads the whole factor.
  const std::size_t groups =
      rows_ < kMinRows ? 1 : std::min(1 + freeCores(), static_cast<std::size_t>(width_ / kSideBySide));
  if (groups <= 1) return use(*this);
  const auto begin_of = [&](std::size_t group) {
    return kSideBySide * static_cast<Index>(static_cast<std::size_t>(width_ / kSideBySide) * group / groups);
  };
  inParallel(groups, [&](std::size_t group) {
    const Index begin = begin_of(group);
    RightHandSides some = columns(begin, std::min(begin_of(group + 1), columns_) - begin);
    use(some);
    putColumns(begin, some);
  });
}

MatrixXd RightHandSides::gram(const FrontKernels& kernels) const {
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
  panel_begin_.reserve(pattern_->supernodes.size() + 1);
  for (const Supernode& node : pattern_->supernodes) {
    panel_begin_.push_back(numbers);
    numbers += static_cast<std::size_t>(pivotsOf(node) * panelStride(node));
    factor_entries_ += static_cast<std::size_t>(pivotsOf(node) * frontOf(node));
    most_rows_ = std::max(most_rows_, static_cast<std::size_t>(rowsOf(node)));
  }
  panel_begin_.push_back(numbers);
  findSubtrees();
}

/// What the largest of the supernodes need.
BlockCholesky::InverseWorkspace::InverseWorkspace(std::span<const Supernode> supernodes,
                                                  std::span<const Subtree> parts) {
  std::size_t front_size = 0;
  Index product_size = 0;
  for (const Subtree& part : parts) {
    for (const Supernode& node : supernodes.subspan(part.first, part.root + 1 - part.first)) {
      front_size = std::max(front_size, frontSize(node));
      product_size = std::max(product_size, FrontKernels::inverseWorkspace(frontOf(node), pivotsOf(node)));
    }
  }
  front.resize(front_size);
  products.resize(static_cast<std::size_t>(product_size));
}

/// The largest subtrees with a small share of the work, or with so little that a thread would not pay.
void BlockCholesky::findSubtrees() {
  constexpr double kShare = 1.0 / 32;
  const std::vector<Supernode>& supernodes = pattern_->supernodes;
  std::vector<double> work(supernodes.size());  // of whole subtrees
  std::vector<std::size_t> first(supernodes.size());
  double total = 0;
  for (std::size_t s = 0; s < supernodes.size(); ++s) {
    const Supernode& node = supernodes[s];
    first[s] = node.children.empty() ? s : first[node.children.front()];
    work[s] = workOf(node);
    total += work[s];
    for (const std::size_t child : node.children) work[s] += work[child];
  }
  const double most = std::max(2 * kMinWork, kShare * total);
  for (std::size_t s = 0; s < supernodes.size(); ++s) {
    const bool has_parent = !supernodes[s].rows.empty();
    if (work[s] > most || (has_parent && work[supernodes[s].parent] <= most)) continue;
    subtrees_.push_back({first[s], s});
  }
}

/// The matrix's own elements in the columns of a supernode.
void BlockCholesky::assemble(std::size_t supernode, const Blocks& A) {
  const Supernode& node = pattern_->supernodes[supernode];
  double* const numbers = factor_.data() + panel_begin_[supernode];
  const Index stride = panelStride(node);
  clearLower(numbers, stride, frontOf(node), pivotsOf(node));
  const auto block = [&](std::size_t row, std::size_t column) {
    return Eigen::Map<Eigen::Matrix<double, kBlock, kBlock>, 0, Eigen::OuterStride<>>(
        numbers + numbersIn(row) + numbersIn(column) * stride, Eigen::OuterStride<>(stride));
  };
  for (std::size_t p = 0; p < node.pivots; ++p) block(p, p) = A.diagonal[pattern_->order[node.first + p]];
  for (const Supernode::Entry& entry : node.entries) {
    if (entry.transposed) {
      block(entry.row, entry.column) = A.couples[entry.couple].transpose();
    } else {
      block(entry.row, entry.column) = A.couples[entry.couple];
    }
  }
}

/// Makes a supernode's columns of the factor, and of what its children leave to it what it leaves to its parent. False:
/// not positive definite or not finite.
bool BlockCholesky::eliminate(std::size_t supernode, const Blocks& A, std::vector<Numbers>& updates) {
  const Supernode& node = pattern_->supernodes[supernode];
  const Index stride = panelStride(node);
  assemble(supernode, A);
  double* const L = factor_.data() + panel_begin_[supernode];
  Numbers update(updateSize(node));
  clearLower(update.data(), updateStride(node), rowsOf(node), rowsOf(node));
  std::vector<Run> runs;
  for (const std::size_t child : node.children) {
    const Supernode& below = pattern_->supernodes[child];
    findRuns(below.in_parent, runs);
    addToParent(runs, updates[child].data(), updateStride(below), node, L, update.data());
    updates[child] = Numbers();
  }
  if (!factorizePanel(kernels_, L, stride, frontOf(node), pivotsOf(node))) return false;
  if (!node.rows.empty()) {
    subtractOwnOuter(kernels_, update.data(), updateStride(node), L + pivotsOf(node), stride, rowsOf(node),
                     rowsOf(node), pivotsOf(node));
  }
  updates[supernode] = std::move(update);
  return true;
}

bool BlockCholesky::factorize(std::span<const Matrix6d> diagonal, std::span<const Matrix6d> couples) {
  assert(diagonal.size() == size() && couples.size() == pattern_->couples);
  factorized_ = false;
  factor_.resize(panel_begin_.back());
  const Blocks A{diagonal, couples};
  std::vector<Numbers> updates(pattern_->supernodes.size());
  std::atomic<bool> fails = false;
  const auto eliminateAll = [&](const Subtree& subtree) {
    for (std::size_t s = subtree.first; s <= subtree.root && !fails; ++s) {
      if (!eliminate(s, A, updates)) fails = true;
    }
  };
  const std::size_t at_once = subtreesAtOnce();
  std::size_t next = 0;  // subtree
  std::size_t done = 0;
  for (std::size_t s = 0; s < pattern_->supernodes.size() && !fails; ++s) {
    if (next == subtrees_.size() || s != subtrees_[next].first) {
      eliminateAll({s, s});
      continue;
    }
    if (next == done) {
      const std::size_t count = std::min(at_once, subtrees_.size() - next);
      inParallel(count, [&](std::size_t k) { eliminateAll(subtrees_[next + k]); });
      done += count;
    }
    s = subtrees_[next++].root;
  }
  factorized_ = !fails;
  return factorized_;
}

RightHandSides BlockCholesky::ordered(const RightHandSides::RowMajor& B) const {
  assert(B.rows() == numbersIn(size()));
  RightHandSides rows(B.rows(), B.cols());
  auto matrix = rows.matrix();
  for (std::size_t k = 0; k < size(); ++k) {
    matrix.middleRows<kBlock>(numbersIn(k)) = B.middleRows<kBlock>(numbersIn(pattern_->order[k]));
  }
  return rows;
}

RightHandSides BlockCholesky::inOwnOrder(RightHandSides B) const {
  const Index block = kBlock * B.width_;
  const auto rowsAt = [&](std::size_t place) { return B.numbers_.begin() + static_cast<Index>(place) * block; };
  std::vector<double> moving(static_cast<std::size_t>(block));
  std::vector<bool> moved(size(), false);
  for (std::size_t first = 0; first < size(); ++first) {
    if (moved[first]) continue;
    // Each of a cycle to where the next one was.
    std::copy_n(rowsAt(first), block, moving.begin());
    std::size_t place = first;
    do {
      place = pattern_->order[place];
      std::swap_ranges(moving.begin(), moving.end(), rowsAt(place));
      moved[place] = true;
    } while (place != first);
  }
  return B;
}

void BlockCholesky::solveLower(RightHandSides& B) const {
  assert(factorized_ && B.rows_ == numbersIn(size()));
  B.inColumns([this](RightHandSides& columns) {
    for (std::size_t s = 0; s < pattern_->supernodes.size(); ++s) {
      const Supernode& node = pattern_->supernodes[s];
      kernels_.substituteForward(panel(s), panelStride(node), pivotsOf(node), node.first, node.rows.data(),
                                 node.rows.size(), columns.numbers_.data(), columns.width_);
    }
  });
}

void BlockCholesky::solveUpper(RightHandSides& B) const {
  assert(factorized_ && B.rows_ == numbersIn(size()));
  B.inColumns([this](RightHandSides& columns) {
    std::vector<double> workspace(most_rows_ * static_cast<std::size_t>(columns.width_));
    for (std::size_t s = pattern_->supernodes.size(); s-- > 0;) {
      const Supernode& node = pattern_->supernodes[s];
      kernels_.substituteBack(panel(s), panelStride(node), pivotsOf(node), node.first, node.rows.data(),
                              node.rows.size(), columns.numbers_.data(), columns.width_, workspace.data());
    }
  });
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
    RightHandSides rows = ordered(B.middleCols(begin, count));
    solveLower(rows);
    solveUpper(rows);
    B.middleCols(begin, count) = inOwnOrder(std::move(rows)).matrix();
  }
}

/// What is known of a front of the inverse from the panels above it: the rows after the pivots, each of which is a
/// pivot of a supernode on the way up. `front`: of the inverse.
void BlockCholesky::gather(std::size_t supernode, double* front) const {
  const Supernode& node = pattern_->supernodes[supernode];
  const Index stride = panelStride(node);
  double* const rest = front + pivotsOf(node) * (stride + 1);
  const std::size_t rows = node.rows.size();
  std::vector<std::size_t> places = node.in_parent;  // of the rows that are left, in one front above after the other
  std::vector<Run> runs;
  std::size_t begin = 0;
  for (std::size_t s = node.parent; begin < rows; s = pattern_->supernodes[s].parent) {
    const Supernode& above = pattern_->supernodes[s];
    std::size_t end = begin;
    while (end < rows && places[end] < above.pivots) ++end;
    findRuns(std::span(places).subspan(begin), runs);
    for (std::size_t k = begin; k < end; ++k) {
      const double* const source = panel(s) + numbersIn(places[k]) * panelStride(above);
      double* const target = rest + numbersIn(k) * stride + numbersIn(begin);
      for (Index c = 0; c < kBlock; ++c) {
        for (const Run& run : runs) {
          std::copy_n(source + c * panelStride(above) + run.above, run.length, target + c * stride + run.begin);
        }
      }
    }
    begin = end;
    for (std::size_t k = begin; k < rows; ++k) places[k] = above.in_parent[places[k] - above.pivots];
  }
  mirrorLower(rest, stride, rowsOf(node));
}

/// A supernode's blocks of the inverse, which take the place of its panel.
void BlockCholesky::invert(std::size_t supernode, InverseWorkspace& workspace, SelectedInverse& inverse) {
  const Supernode& node = pattern_->supernodes[supernode];
  const Index stride = panelStride(node);
  double* const Z = workspace.front.data();
  gather(supernode, Z);
  double* const L = factor_.data() + panel_begin_[supernode];
  invertFront(kernels_, Z, L, stride, frontOf(node), pivotsOf(node), workspace.products.data());
  std::copy_n(Z, pivotsOf(node) * stride, L);

  const auto block = [&](std::size_t row, std::size_t column) {
    return Square(Z + numbersIn(row) + numbersIn(column) * stride, Eigen::OuterStride<>(stride));
  };
  for (std::size_t p = 0; p < node.pivots; ++p) inverse.diagonal[pattern_->order[node.first + p]] = block(p, p);
  if (inverse.couples.empty()) return;
  for (const Supernode::Entry& entry : node.entries) {
    const Square found = block(entry.row, entry.column);
    if (entry.transposed) {
      inverse.couples[entry.couple] = found.transpose();
    } else {
      inverse.couples[entry.couple] = found;
    }
  }
}

/// Parents before their children.
void BlockCholesky::invertDown(std::span<const Subtree> parts, SelectedInverse& inverse) {
  InverseWorkspace workspace(pattern_->supernodes, parts);
  for (const Subtree& part : parts) {
    for (std::size_t s = part.root + 1; s-- > part.first;) invert(s, workspace, inverse);
  }
}

void BlockCholesky::takeInverse(SelectedInverse& inverse) {
  assert(factorized_);
  factorized_ = false;
  std::vector<Subtree> above;
  std::size_t end = pattern_->supernodes.size();
  for (std::size_t k = subtrees_.size(); k-- > 0;) {
    if (subtrees_[k].root + 1 < end) above.push_back({subtrees_[k].root + 1, end - 1});
    end = subtrees_[k].first;
  }
  if (end > 0) above.push_back({0, end - 1});
  invertDown(above, inverse);
  inParallel(subtrees_.size(), [&](std::size_t k) { invertDown(std::span(subtrees_).subspan(k, 1), inverse); });
  factor_ = Numbers();
}

BlockCholesky::SelectedInverse BlockCholesky::selectedInverse() && {
  SelectedInverse inverse{std::vector<Matrix6d>(size()), std::vector<Matrix6d>(pattern_->couples)};
  takeInverse(inverse);
  return inverse;
}

std::vector<Matrix6d> BlockCholesky::inverseDiagonal() && {
  SelectedInverse inverse{std::vector<Matrix6d>(size()), {}};
  takeInverse(inverse);
  return std::move(inverse.diagonal);
}

}  // namespace hexoderm
