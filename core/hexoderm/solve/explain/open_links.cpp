#include "hexoderm/skin/cut_elements.h"
#include "hexoderm/solve/explain/explainer.h"

namespace hexoderm {
namespace {

Finding describeOpenLink(const SkinGraph& graph, const GlobalRefinement::OpenLink& open, double limit_m) {
  const LinkEnd source = graph.sourceEnd(graph.links()[open.link]);
  const LinkEnd target = graph.targetEnd(graph.links()[open.link]);
  const Message link = linkText(source, target);
  const Millimetres opening{open.opening_m, 0};
  const Millimetres limit{limit_m, 0};
  const std::size_t candidates = linksOfAllLoopsThrough(graph, open.link).size();
  return makeFinding(
      FindingCode::LinkDoesNotClose,
      candidates > 1
          ? message("With all other links the ends of the {} come to lie {} apart, and a skin link leaves no more than "
                    "{}. All of its loops have {} links in common, and any one of these may be a cable. The link is "
                    "not used.",
                    link, opening, limit, candidates)
          : message("With all other links the ends of the {} come to lie {} apart, and a skin link leaves no more than "
                    "{}: it is probably a cable, since no other link is in all of its loops. The link is not used.",
                    link, opening, limit),
      {source.cell, target.cell}, {source.port, target.port});
}

std::optional<Explanation> explainOpenLinks(const Estimate& estimate) {
  const SkinLinks& skin = estimate.skin();
  const double limit_m = skin.options().max_opening * skin.model().link_sigma_m;
  Explanation found;
  for (const PatchSolver& patch : estimate.patches()) {
    if (patch.joint() == nullptr) continue;
    const auto widest = patch.joint()->widestOpen();
    if (!widest || widest->opening_m <= limit_m) continue;
    found.links[FindingCode::LinkDoesNotClose].push_back(widest->link);
    found.findings.push_back(describeOpenLink(skin.graph(), *widest, limit_m));
  }
  return found.empty() ? std::nullopt : std::optional(std::move(found));
}

}  // namespace

Explainer makeOpenLinkExplainer() { return {Estimate::Stage::Patches, explainOpenLinks}; }

}  // namespace hexoderm
