#include "hexoderm/solve/faults/tears.h"

#include <algorithm>
#include <functional>
#include <numeric>
#include <span>
#include "hexoderm/solve/explain/explainer.h"

namespace hexoderm {
namespace {

/// A tear through the link that is open, or else through one of those that stand out most: ends that a tear holds open
/// drag sound links open, too.
std::vector<std::size_t> findTear(const SkinLinks& skin, std::size_t open_link, std::span<const double> deviations) {
  constexpr std::size_t kTries = 8;
  std::vector<std::size_t> seeds(deviations.size());
  std::iota(seeds.begin(), seeds.end(), std::size_t{0});
  const std::size_t tries = std::min(kTries, seeds.size());
  std::ranges::partial_sort(seeds, seeds.begin() + static_cast<std::ptrdiff_t>(tries), std::greater<>(),
                            [&](std::size_t link) { return deviations[link]; });
  seeds.resize(tries);
  seeds.insert(seeds.begin(), open_link);
  for (const std::size_t seed : seeds) {
    std::vector<std::size_t> links = tearThrough(skin, seed, deviations);
    if (!links.empty()) return links;
  }
  return {};
}

std::optional<Explanation> explainTears(const Estimate& estimate) {
  const SkinLinks& skin = estimate.skin();
  std::optional<std::vector<double>> deviations;
  for (const PatchSolver& patch : estimate.patches()) {
    if (patch.joint() == nullptr) continue;
    const auto widest = patch.joint()->widestOpen();
    if (!widest || widest->opening_m <= skin.options().max_opening * skin.model().link_sigma_m) continue;
    if (!deviations) deviations = linkDeviations(skin);
    const std::vector<std::size_t> links = findTear(skin, widest->link, *deviations);
    if (links.empty()) continue;
    Explanation found;
    found.findings.push_back(describeTear(skin, links));
    found.links[FindingCode::TornSkin] = links;
    return found;
  }
  return std::nullopt;
}

}  // namespace

Explainer makeTearExplainer() { return {Estimate::Stage::Patches, explainTears}; }

}  // namespace hexoderm
