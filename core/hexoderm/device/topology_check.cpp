#include "hexoderm/device/topology_check.h"

#include "hexoderm/skin/skin_graph.h"

#include <algorithm>
#include <array>
#include <utility>

namespace hexoderm {
namespace {

constexpr std::array<std::pair<FindingCode, ProtocolViolationKind>, 9> kViolationsOfTopologies = {
    {{FindingCode::ReservedCellId, ProtocolViolationKind::CellIdZero},
     {FindingCode::DuplicateCell, ProtocolViolationKind::DuplicateCell},
     {FindingCode::UnknownPort, ProtocolViolationKind::UnknownPort},
     {FindingCode::UnknownCell, ProtocolViolationKind::UnknownNeighbour},
     {FindingCode::OneSidedLink, ProtocolViolationKind::OneSidedLink},
     {FindingCode::SelfLink, ProtocolViolationKind::ContradictoryLink},
     {FindingCode::ContradictoryLink, ProtocolViolationKind::ContradictoryLink},
     {FindingCode::DuplicateLink, ProtocolViolationKind::ContradictoryLink},
     {FindingCode::ForbiddenPortPair, ProtocolViolationKind::ContradictoryLink}}};

/// What a device's maker can't know from the finding alone.
Message expectedOf(ProtocolViolationKind kind, const CellModel& model) {
  switch (kind) {
    case ProtocolViolationKind::CellIdZero:
      return message("IDs of cells begin with 1");
    case ProtocolViolationKind::UnknownPort: {
      std::vector<PortNumber> ports;
      for (const Port& port : model.ports) ports.push_back(port.number);
      return message("the model's ports are {}", ports);
    }
    case ProtocolViolationKind::OneSidedLink:
      return message("both cells of a link have to list it");
    default:
      return {};
  }
}

}  // namespace

std::vector<ProtocolViolation> offencesOf(const CellModel& model, const NeighborList& neighbors) {
  std::vector<ProtocolViolation> offences;
  const SkinGraph graph(model, neighbors);
  for (const Finding& finding : graph.findings()) {
    const auto* const offence =
        std::ranges::find(kViolationsOfTopologies, finding.code, &decltype(kViolationsOfTopologies)::value_type::first);
    if (offence == kViolationsOfTopologies.end()) continue;
    const ProtocolViolationKind kind = offence->second;
    const Message expected = expectedOf(kind, model);
    Message reason = located("topology", finding.message);
    if (!expected.empty()) reason = message("{} Expected: {}", std::move(reason), expected);
    offences.push_back({kind, std::move(reason)});
  }
  if (graph.cells().empty()) {
    offences.push_back(
        {ProtocolViolationKind::NoCells, located("topology.cells", message("expected at least one cell"))});
  }
  return offences;
}

}  // namespace hexoderm
