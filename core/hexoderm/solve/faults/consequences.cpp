#include "hexoderm/solve/faults/consequences.h"

#include "hexoderm/skin/cut_elements.h"

#include <algorithm>
#include <array>
#include <optional>
#include <set>
#include <utility>

namespace hexoderm {
namespace {

using PatchPair = std::pair<PatchId, PatchId>;

/// About a link that joins two parts of a patch, unless it is no skin link.
bool isAboutUsableLink(FindingCode code) {
  constexpr std::array kCodes = {FindingCode::ImplausibleBend,  FindingCode::ImplausibleTwist,
                                 FindingCode::ImplausibleYaw,   FindingCode::LinkNotRigid,
                                 FindingCode::LinkDoesNotClose, FindingCode::LinkSetAside,
                                 FindingCode::TornSkin};
  return std::ranges::count(kCodes, code) > 0;
}

/// A cell that is placed by its links.
bool isAboutReadings(FindingCode code) {
  constexpr std::array kCodes = {
      FindingCode::NoSamples,       FindingCode::DeadSensor,  FindingCode::StuckSensor,
      FindingCode::SaturatedSensor, FindingCode::NoisySensor, FindingCode::WrongNorm,
      FindingCode::DeadAxis,        FindingCode::WrongGain,   FindingCode::InconsistentSensor,
      FindingCode::TurnedSensor,    FindingCode::MovedCell,   FindingCode::LeftOut};
  return std::ranges::count(kCodes, code) > 0;
}

/// The patches at the two ends of the link that a finding muted, where these are two.
std::optional<PatchPair> splitBy(const SkinGraph& graph, const Finding& finding) {
  if (!isAboutUsableLink(finding.code) || finding.cells.size() < 2 || finding.ports.size() < 2) return std::nullopt;
  const auto link = graph.indexOf({finding.cells[0], finding.ports[0]}, {finding.cells[1], finding.ports[1]});
  if (!link || graph.links()[*link].muted_by != finding.code) return std::nullopt;
  const PatchId source = graph.cells()[graph.links()[*link].source].patch;
  const PatchId target = graph.cells()[graph.links()[*link].target].patch;
  return source == target ? std::nullopt : std::optional<PatchPair>(std::minmax(source, target));
}

}  // namespace

void addConsequences(const SkinLinks& skin, std::vector<Finding>& findings) {
  const SkinGraph& graph = skin.graph();
  std::optional<CutElements> cuts;
  const auto joinsParts = [&](const Finding& finding) {
    if (!isAboutReadings(finding.code) || finding.cells.size() != 1) return false;
    const auto cell = graph.indexOf(finding.cells.front());
    if (!cell || skin.readings().measured(*cell)) return false;
    if (!cuts) cuts = findCutElements(graph);
    const bool joins = cuts->is_articulation[*cell];
    cuts->is_articulation[*cell] = false;  // of several findings about a cell the first says it
    return joins;
  };
  std::set<PatchPair> said;
  for (Finding& finding : findings) {
    const std::optional<PatchPair> patches = splitBy(graph, finding);
    if (patches && said.insert(*patches).second) {
      finding.message = message("{} No path of used links connects its two cells any more: the patch is split there.",
                                std::move(finding.message));
    } else if (joinsParts(finding)) {
      finding.message = message("{} It alone connects parts of the patch, whose relative placement is less certain.",
                                std::move(finding.message));
    }
  }
}

}  // namespace hexoderm
