#include "hexoderm/device/diagnosis/topology_check.h"

#include "hexoderm/graph/skin_graph.h"

#include <optional>

namespace hexoderm {
namespace {

std::optional<OffenceKind> offenceOf(FindingCode code) {
  switch (code) {
    case FindingCode::ReservedCellId:
      return OffenceKind::CellIdZero;
    case FindingCode::DuplicateCell:
      return OffenceKind::DuplicateCell;
    case FindingCode::UnknownPort:
      return OffenceKind::UnknownPort;
    case FindingCode::UnknownCell:
      return OffenceKind::UnknownNeighbour;
    case FindingCode::OneSidedLink:
      return OffenceKind::OneSidedLink;
    case FindingCode::SelfLink:
    case FindingCode::ContradictoryLink:
    case FindingCode::DuplicateLink:
    case FindingCode::ForbiddenPortPair:
      return OffenceKind::ContradictoryLink;
    default:
      return std::nullopt;
  }
}

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
    const std::optional<OffenceKind> kind = offenceOf(finding.code);
    if (!kind) continue;
    const Message expected = expectedOf(*kind, model);
    Message reason = located("topology", finding.message);
    if (!expected.empty()) reason = message("{} Expected: {}", std::move(reason), expected);
    offences.push_back({*kind, std::move(reason)});
  }
  if (graph.cells().empty()) {
    offences.push_back({OffenceKind::NoCells, located("topology.cells", message("expected at least one cell"))});
  }
  return offences;
}

}  // namespace hexoderm
