#include "hexoderm/solve/metrics/skin_signs.h"

#include <algorithm>
#include <array>
#include <unordered_map>

namespace hexoderm {

bool isAboutCells(FindingCode code) {
  using enum FindingCode;
  constexpr std::array kAboutCells = {NoSamples,       DeadSensor,   StuckSensor, SaturatedSensor,    NoisySensor,
                                      WrongNorm,       DeadAxis,     WrongGain,   InconsistentSensor, IdenticalReadings,
                                      SwappedReadings, TurnedSensor, TurnedGroup, MovedCell,          SuspiciousSensor};
  return std::ranges::find(kAboutCells, code) != kAboutCells.end();
}

namespace {

/// Its cells and ports are the ends of one link, or of the links of a tear one after the other.
bool isAboutLinks(const Finding& finding) {
  return (finding.cells.size() == 2 || finding.code == FindingCode::TornSkin) &&
         finding.ports.size() == finding.cells.size();
}

}  // namespace

SkinSigns signsOf(const Reconstruction& reconstruction) {
  SkinSigns signs;
  signs.cells.reserve(reconstruction.cellCount());
  std::unordered_map<CellId, std::size_t> index;
  index.reserve(reconstruction.cellCount());
  bool any_measured = false;
  for (const PatchReconstruction& patch : reconstruction.patches) {
    for (const CellPlacement& cell : patch.cells) {
      index.emplace(cell.cell, signs.cells.size());
      signs.cells.push_back({.by_links = cell.placed_by == PlacedBy::Links});
      any_measured = any_measured || cell.placed_by == PlacedBy::Samples;
    }
  }
  if (!any_measured) {
    for (CellSign& sign : signs.cells) sign.by_links = false;
  }
  for (const Finding& finding : reconstruction.findings) {
    if (finding.severity == Severity::Info) continue;
    if (isAboutLinks(finding)) {
      for (std::size_t k = 0; k + 1 < finding.cells.size(); k += 2) {
        const LinkEnd a{finding.cells[k], finding.ports[k]};
        const LinkEnd b{finding.cells[k + 1], finding.ports[k + 1]};
        const LinkEstimate* link = reconstruction.findLink(a, b);
        if (link != nullptr) signs.links.emplace_back(link->source, link->target);
      }
    } else if (isAboutCells(finding.code)) {
      for (const CellId cell : finding.cells) {
        const auto found = index.find(cell);
        if (found == index.end()) continue;
        CellSign& sign = signs.cells[found->second];
        (finding.severity == Severity::Error ? sign.faulty : sign.doubtful) = true;
      }
    }
  }
  for (CellSign& sign : signs.cells) sign.doubtful = sign.doubtful && !sign.faulty;
  std::ranges::sort(signs.links);
  signs.links.erase(std::unique(signs.links.begin(), signs.links.end()), signs.links.end());
  return signs;
}

bool isOfOneQuality(const Reconstruction& reconstruction) {
  std::optional<EdgeQuality> common;
  for (const PatchReconstruction& patch : reconstruction.patches) {
    for (const LinkEstimate& link : patch.links) {
      if (!link.used) continue;
      if (link.quality == EdgeQuality::Undefined || common.value_or(link.quality) != link.quality) return false;
      common = link.quality;
    }
  }
  return common.has_value();
}

}  // namespace hexoderm
