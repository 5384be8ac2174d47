#include "hexoderm/capture/skin_check.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <set>
#include <utility>

namespace hexoderm {
namespace {

SkinCheckItem checkLinks(const Reconstruction& reconstruction) {
  SkinCheckItem item;
  std::size_t muted = 0;
  for (const PatchReconstruction& patch : reconstruction.patches) {
    for (const LinkEstimate& link : patch.links) {
      if (!link.muted_by) continue;
      ++muted;
      item.cells.push_back(link.source.cell);
      item.cells.push_back(link.target.cell);
    }
  }
  if (muted == 0) {
    item.message = message("Every link joins two ports that fit");
  } else {
    item.severity = Severity::Warning;
    item.message = message("{} of {} links are kept out: see the findings", muted, reconstruction.linkCount());
  }
  return item;
}

Message rangeText(std::span<const CellSample> readings) {
  const auto [least, most] = std::minmax_element(
      readings.begin(), readings.end(),
      [](const CellSample& a, const CellSample& b) { return a.acceleration_g.norm() < b.acceleration_g.norm(); });
  const Number least_g{least->acceleration_g.norm(), 2};
  if (readings.size() == 1) return message("{} g", least_g);
  return message("{} to {} g", least_g, Number{most->acceleration_g.norm(), 2});
}

void checkReadings(const CellModel& model, std::span<const CellSample> readings, const std::set<CellId>& silent,
                   std::vector<SkinCheckItem>& items) {
  const Accelerometer accelerometer = model.accelerometer.ofUnknownLot();
  const double tolerance_g = 5 * std::hypot(accelerometer.largestOffsetSigma_g(), accelerometer.scale_sigma);
  std::vector<CellSample> odd;
  std::copy_if(readings.begin(), readings.end(), std::back_inserter(odd), [&](const CellSample& reading) {
    return !(std::abs(reading.acceleration_g.norm() - 1) <= tolerance_g);
  });
  if (!odd.empty()) {
    SkinCheckItem item{Severity::Warning, {}, {}};
    for (const CellSample& reading : odd) item.cells.push_back(reading.cell);
    item.message = odd.size() == 1 ? message("Cell {} reads {}: gravity is 1 g, give or take {} g", odd.front().cell,
                                             rangeText(odd), Number{tolerance_g, 2})
                                   : message("{} cells read {}: gravity is 1 g, give or take {} g", odd.size(),
                                             rangeText(odd), Number{tolerance_g, 2});
    items.push_back(std::move(item));
  }
  if (!silent.empty()) {
    const std::vector<CellId> cells(silent.begin(), silent.end());
    items.push_back({Severity::Warning, message("Nothing comes from {}", cellsText(cells)), cells});
  } else if (odd.empty()) {
    items.push_back({Severity::Info,
                     readings.size() == 1
                         ? message("The cell sends and reads {}", rangeText(readings))
                         : message("All {} cells send and read {}", readings.size(), rangeText(readings)),
                     {}});
  } else {
    items.push_back({Severity::Info,
                     readings.size() == 1 ? message("The cell sends") : message("All {} cells send", readings.size()),
                     {}});
  }
}

}  // namespace

SkinCheck checkSkin(const Reconstruction& reconstruction, std::span<const CellSample> readings,
                    std::span<const OddCell> odd) {
  SkinCheck check;
  std::set<CellId> silent;
  for (const PatchReconstruction& patch : reconstruction.patches) {
    for (const CellPlacement& cell : patch.cells) silent.insert(cell.cell);
  }
  const std::size_t cell_count = silent.size();
  for (const CellSample& reading : readings) silent.erase(reading.cell);

  check.items.push_back({Severity::Info, message("Found: {}", sizeText(reconstruction)), {}});
  if (cell_count > 0) check.items.push_back(checkLinks(reconstruction));
  if (!readings.empty()) checkReadings(*reconstruction.model, readings, silent, check.items);
  for (const OddCell& cell : odd) {
    // Silent cells were named above.
    if (cell.kind != OddCellKind::Silent) check.items.push_back({Severity::Warning, describe(cell), {cell.cell}});
  }

  check.ready = cell_count > 0 && !readings.empty();
  if (cell_count == 0) {
    check.because = message("The skin has no cells");
  } else if (readings.empty()) {
    check.because = message("No readings have come yet");
  } else if (silent.empty()) {
    check.because = message("Every cell sends");
  } else {
    check.because = message("{} of {} cells send", cell_count - silent.size(), cell_count);
  }
  return check;
}

}  // namespace hexoderm
