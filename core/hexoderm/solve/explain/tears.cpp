#include "hexoderm/solve/faults/tears.h"
#include "hexoderm/solve/explain/explainer.h"

namespace hexoderm {
namespace {

std::optional<Explanation> explainTears(const Estimate& estimate) {
  const SkinLinks& skin = estimate.skin();
  std::optional<std::vector<double>> deviations;
  for (const PatchSolver& patch : estimate.patches()) {
    if (patch.joint() == nullptr) continue;
    const auto widest = patch.joint()->widestOpen();
    if (!widest || widest->opening_m <= skin.options().max_opening * skin.model().link_sigma_m) continue;
    if (!deviations) deviations = linkDeviations(skin);
    const std::vector<std::size_t> links = tearThrough(skin, widest->link, *deviations);
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
