#pragma once

#include "hexoderm/solve/sparse/elimination_order.h"

#include <cstddef>
#include <vector>

namespace hexoderm {

/// Consecutive columns of a Cholesky factor that are stored as one dense panel. Its front is its pivots, then its rows;
/// numbers of blocks throughout.
struct Supernode {
  /// Position of a couple's block in the front, in the lower triangle.
  struct Entry {
    std::size_t couple = 0;
    std::size_t row = 0;
    std::size_t column = 0;   ///< one of the pivots
    bool transposed = false;  ///< the couple's block is the one of the upper triangle
  };

  std::size_t first = 0;  ///< place of the first pivot in the elimination order
  std::size_t pivots = 0;
  std::size_t parent = 0;              ///< meaningless without rows
  std::vector<std::size_t> rows;       ///< places in the elimination order below the pivots, ascending
  std::vector<std::size_t> in_parent;  ///< per row: where it stands in the parent's front
  std::vector<std::size_t> children;
  std::vector<Entry> entries;
};

/// Symbolic Cholesky factorisation of a symmetric matrix of blocks.
struct SupernodalPattern {
  std::vector<std::size_t> order;     ///< row of the matrix by place in the elimination order
  std::vector<Supernode> supernodes;  ///< children before their parents, and whole subtrees one after the other
  std::size_t couples = 0;            ///< in the matrix
};

/// Takes the elimination order that makes less work; couples as in BlockCholesky. Deterministic.
/// Liu, Ng and Peyton, "On finding supernodes for sparse matrix computations", SIAM J. Matrix Anal. Appl. 14, 1993.
SupernodalPattern analysePattern(std::size_t size, const std::vector<BlockCouple>& couples);

}  // namespace hexoderm
