#include "hexoderm/mounting/parts/hand_share.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace hexoderm {

double meanHandShare(const std::function<double(double hand_share)>& log_evidence) {
  constexpr std::array<double, 7> kShares = {1, 1. / 2, 1. / 4, 1. / 8, 1. / 16, 1. / 32, 1. / 64};
  std::array<double, kShares.size()> evidence{};
  std::ranges::transform(kShares, evidence.begin(), log_evidence);
  const double most = *std::ranges::max_element(evidence);
  double sum = 0;
  double weights = 0;
  for (std::size_t k = 0; k < kShares.size(); ++k) {
    const double weight = std::exp(evidence[k] - most);
    sum += weight * kShares[k];
    weights += weight;
  }
  return sum / weights;
}

}  // namespace hexoderm
