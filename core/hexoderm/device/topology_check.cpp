#include "hexoderm/device/topology_check.h"

#include "hexoderm/skin/skin_graph.h"

#include <algorithm>
#include <array>
#include <utility>

namespace hexoderm {
namespace {

constexpr std::array<std::pair<FindingCode, OffenceKind>, 9> kOffencesOfTopologies = {
    {{FindingCode::ReservedCellId, OffenceKind::CellIdZero},
     {FindingCode::DuplicateCell, OffenceKind::DuplicateCell},
     {FindingCode::UnknownPort, OffenceKind::UnknownPort},
     {FindingCode::UnknownCell, OffenceKind::UnknownNeighbour},
     {FindingCode::OneSidedLink, OffenceKind::OneSidedLink},
     {FindingCode::SelfLink, OffenceKind::ContradictoryLink},
     {FindingCode::ContradictoryLink, OffenceKind::ContradictoryLink},
     {FindingCode::DuplicateLink, OffenceKind::ContradictoryLink},
     {FindingCode::ForbiddenPortPair, OffenceKind::ContradictoryLink}}};

/// What a device's maker can't know from the finding alone.
Message expectedOf(OffenceKind kind, const CellModel& model) {
  switch (kind) {
    case OffenceKind::CellIdZero:
      return message("IDs of cells begin with 1");
    case OffenceKind::UnknownPort: {
      std::vector<PortNumber> ports;
      for (const Port& port : model.ports) ports.push_back(port.number);
      return message("the model's ports are {}", ports);
    }
    case OffenceKind::OneSidedLink:
      return message("both cells of a link have to list it");
    default:
      return {};
  }
}

}  // namespace

std::vector<Offence> offencesOf(const CellModel& model, const NeighborList& neighbors) {
  std::vector<Offence> offences;
  const SkinGraph graph(model, neighbors);
  for (const Finding& finding : graph.findings()) {
    const auto* const offence =
        std::ranges::find(kOffencesOfTopologies, finding.code, &decltype(kOffencesOfTopologies)::value_type::first);
    if (offence == kOffencesOfTopologies.end()) continue;
    const OffenceKind kind = offence->second;
    const Message expected = expectedOf(kind, model);
    Message reason = located("topology", finding.message);
    if (!expected.empty()) reason = message("{} Expected: {}", std::move(reason), expected);
    offences.push_back({kind, std::move(reason)});
  }
  if (graph.cells().empty()) {
    offences.push_back({OffenceKind::NoCells, located("topology.cells", message("expected at least one cell"))});
  }
  return offences;
}

}  // namespace hexoderm
