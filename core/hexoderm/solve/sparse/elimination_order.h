#pragma once

#include <cstddef>
#include <vector>

namespace hexoderm {

/// Two different block rows of a symmetric matrix between which there is a block that need not be zero.
struct BlockCouple {
  std::size_t row = 0;
  std::size_t column = 0;
};

// Orders in which to eliminate the rows of a symmetric matrix so that its Cholesky factor stays sparse. Both return a
// permutation: result[k] is the row that is eliminated as the k-th. Both are deterministic, for any graph.

/// Of equal rows the order takes one by its number, so that the same graph numbered otherwise gives another order;
/// which is the better one can only be tried.
enum class Numbering { Forwards, Backwards };

/// Approximate minimum degree (AMD of SuiteSparse). Amestoy, Davis and Duff, "Algorithm 837: AMD, an approximate
/// minimum degree ordering algorithm", ACM TOMS 30, 2004.
std::vector<std::size_t> minimumDegreeOrder(std::size_t size, const std::vector<BlockCouple>& couples,
                                            Numbering numbering = Numbering::Forwards);

/// Nested dissection by the levels of breadth-first searches: better for some large sheets, where minimum degree
/// depends much on how cells are numbered. George and Liu, "An automatic nested dissection algorithm for irregular
/// finite element problems", SIAM J. Numer. Anal. 15, 1978; the level is chosen by its size and balance.
std::vector<std::size_t> dissectionOrder(std::size_t size, const std::vector<BlockCouple>& couples);

}  // namespace hexoderm
