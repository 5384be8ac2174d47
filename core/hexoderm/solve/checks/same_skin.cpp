#include "hexoderm/solve/checks/same_skin.h"

#include "hexoderm/base/error.h"
#include "hexoderm/skin/skin_graph.h"

#include <algorithm>
#include <set>

namespace hexoderm {
namespace {

using LinkEnds = std::pair<LinkEnd, LinkEnd>;

void requireSameCells(const CellModel& calibrated, const CellModel& today) {
  constexpr double kSame = 1e-6;  // of metres and of rotation matrices
  for (const Port& port : calibrated.ports) {
    const Port* other = today.findPort(port.number);
    if (other != nullptr && (other->vector_m - port.vector_m).norm() < kSame) continue;
    throw InvalidArgument(
        message("the calibration is of another kind of cell: port {} of its cell model {} is not where the cell model "
                "{} has it",
                port.number, calibrated.name, today.name));
  }
  const auto turn = [](const CellModel& model) { return model.accelerometer.T_u_a.R; };
  if (today.ports.size() == calibrated.ports.size() && (turn(calibrated) - turn(today)).norm() < kSame) return;
  throw InvalidArgument(
      message("the calibration is of another kind of cell: the ports or the accelerometer of its cell model {} are not "
              "those of "
              "the cell model {}",
              calibrated.name, today.name));
}

}  // namespace

MissingParts findMissingParts(const Reconstruction& calibration, const CellModel& model, const SkinGraph& today) {
  requireSameCells(*calibration.model, model);
  std::set<CellId> cells;
  std::set<LinkEnds> links;
  for (const PatchReconstruction& patch : calibration.patches) {
    for (const CellPlacement& cell : patch.cells) cells.insert(cell.cell);
    for (const LinkEstimate& link : patch.links) links.insert(std::minmax(link.source, link.target));
  }

  std::vector<CellId> added;
  for (const GraphCell& cell : today.cells()) {
    if (!cells.contains(cell.id)) added.push_back(cell.id);
  }
  if (!added.empty()) {
    throw InvalidArgument(message("the calibration is of another skin: {} of today is not in it",
                                  added.size() == 1 ? cellsText(added) : message("one of the {}", cellsText(added))));
  }
  for (const GraphLink& link : today.links()) {
    const LinkEnds ends = std::minmax(today.sourceEnd(link), today.targetEnd(link));
    if (link.muted() || links.contains(ends)) continue;
    throw InvalidArgument(
        message("the calibration is of another skin, or the cells were joined otherwise: {} is not in it",
                linkText(ends.first, ends.second)));
  }

  MissingParts missing;
  for (const CellId cell : cells) {
    if (!today.indexOf(cell)) missing.cells.push_back(cell);
  }
  if (2 * missing.cells.size() > cells.size()) {
    throw InvalidArgument(message("the calibration is of another skin: {} of its {} cells are not there today",
                                  missing.cells.size(), cells.size()));
  }
  for (const LinkEnds& ends : links) {
    const bool joins = today.indexOf(ends.first.cell) && today.indexOf(ends.second.cell);
    if (joins && !today.indexOf(ends.first, ends.second)) missing.links.push_back(ends);
  }
  return missing;
}

}  // namespace hexoderm
