#pragma once

#include "hexoderm/base/large_memory.h"
#include "hexoderm/solve/global/global_cost.h"
#include "hexoderm/solve/sparse/supernodes.h"

#include <memory>
#include <span>
#include <vector>

namespace hexoderm {

/// How the cells of a problem are eliminated. It depends on the links alone, so one is made per patch and serves all
/// solutions of it.
struct EliminationPlan {
  /// The block of the sparse matrix that a link adds to: two links may join the same two cells.
  struct Place {
    std::size_t couple = 0;
    bool transposed = false;
  };

  std::vector<BlockCouple> couples;
  std::vector<Place> of_link;
  std::shared_ptr<const SupernodalPattern> pattern;

  /// The blocks per couple, which are made in `sums` where several links join the same cells.
  [[nodiscard]] std::span<const Matrix6d> couplesOf(std::span<const Matrix6d> links, LargeVector<Matrix6d>& sums) const;
};

std::shared_ptr<const EliminationPlan> planElimination(const GlobalProblem& problem);

}  // namespace hexoderm
