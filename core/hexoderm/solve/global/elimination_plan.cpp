#include "hexoderm/solve/global/elimination_plan.h"

#include <algorithm>
#include <utility>

namespace hexoderm {

std::span<const Matrix6d> EliminationPlan::couplesOf(std::span<const Matrix6d> links,
                                                     LargeVector<Matrix6d>& sums) const {
  if (couples.size() == links.size()) return links;
  sums.assign(couples.size(), Matrix6d::Zero());
  for (std::size_t k = 0; k < links.size(); ++k) {
    if (of_link[k].transposed) {
      sums[of_link[k].couple] += links[k].transpose();
    } else {
      sums[of_link[k].couple] += links[k];
    }
  }
  return sums;
}

std::shared_ptr<const EliminationPlan> planElimination(const GlobalProblem& problem) {
  auto plan = std::make_shared<EliminationPlan>();
  // Links sorted by their two cells, the first of equal ones first.
  std::vector<std::pair<std::pair<std::size_t, std::size_t>, std::size_t>> sorted;
  sorted.reserve(problem.links.size());
  for (std::size_t k = 0; k < problem.links.size(); ++k) {
    sorted.push_back({std::minmax({problem.links[k].c, problem.links[k].n}), k});
  }
  std::sort(sorted.begin(), sorted.end());
  std::vector<std::size_t> first(problem.links.size());  // link between the same cells
  for (std::size_t k = 0; k < sorted.size(); ++k) {
    const bool again = k > 0 && sorted[k].first == sorted[k - 1].first;
    first[sorted[k].second] = again ? first[sorted[k - 1].second] : sorted[k].second;
  }
  plan->of_link.resize(problem.links.size());
  for (std::size_t k = 0; k < problem.links.size(); ++k) {
    const GlobalLink& link = problem.links[k];
    if (first[k] == k) {
      plan->of_link[k] = {plan->couples.size(), false};
      plan->couples.push_back({link.c, link.n});
    } else {
      plan->of_link[k] = {plan->of_link[first[k]].couple, link.c != problem.links[first[k]].c};
    }
  }
  plan->pattern = std::make_shared<const SupernodalPattern>(analysePattern(problem.cellCount(), plan->couples));
  return plan;
}

}  // namespace hexoderm
