#include "hexoderm/reconstruction/faults/consequences.h"

#include "hexoderm/graph/cut_elements.h"

#include <optional>
#include <utility>

namespace hexoderm {
namespace {

/// The link that a finding muted, if it did, and if its ends are in different patches without it.
bool saysThatAPatchFallsApart(const SkinGraph& graph, const Finding& finding) {
  if (finding.cells.size() != 2 || finding.ports.size() != 2) return false;
  const auto link = graph.indexOf({finding.cells[0], finding.ports[0]}, {finding.cells[1], finding.ports[1]});
  if (!link || graph.links()[*link].muted_by != finding.code) return false;
  const GraphLink& muted = graph.links()[*link];
  return graph.cells()[muted.source].patch != graph.cells()[muted.target].patch;
}

}  // namespace

void addConsequences(const SkinLinks& skin, std::vector<Finding>& findings) {
  const SkinGraph& graph = skin.graph();
  std::optional<CutElements> cuts;
  const auto joinsParts = [&](const Finding& finding) {
    if (finding.cells.size() != 1 || !finding.ports.empty()) return false;
    const auto cell = graph.indexOf(finding.cells.front());
    if (!cell || skin.readings().measured(*cell)) return false;
    if (!cuts) cuts = findCutElements(graph);
    const bool joins = cuts->is_articulation[*cell];
    cuts->is_articulation[*cell] = false;  // of several findings about a cell the first says it
    return joins;
  };
  for (Finding& finding : findings) {
    if (saysThatAPatchFallsApart(graph, finding)) {
      finding.message = message("{} No other path of links connects its two cells: the patch is split there.",
                                std::move(finding.message));
    } else if (joinsParts(finding)) {
      finding.message = message("{} It alone connects parts of the patch, whose relative placement is less certain.",
                                std::move(finding.message));
    }
  }
}

}  // namespace hexoderm
