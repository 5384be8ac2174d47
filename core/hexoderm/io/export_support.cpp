#include "hexoderm/io/export_support.h"

#include <algorithm>

namespace hexoderm {

std::unordered_map<CellId, EdgeQuality> worstUsedQuality(const Reconstruction& reconstruction) {
  std::unordered_map<CellId, EdgeQuality> worst;
  for (const PatchReconstruction& patch : reconstruction.patches) {
    for (const LinkEstimate& link : patch.links) {
      if (!link.used) continue;
      for (const CellId cell : {link.source.cell, link.target.cell}) {
        const auto [entry, added] = worst.try_emplace(cell, link.quality);
        if (!added) entry->second = std::min(entry->second, link.quality);
      }
    }
  }
  return worst;
}

std::string frameText(const Reconstruction& reconstruction, const ExportSelection& selection) {
  if (!selection.frame_link.empty()) return "in the frame of link " + selection.frame_link;
  const PatchReconstruction* only = selection.patches.size() == 1        ? selection.patches.front()
                                    : reconstruction.patches.size() == 1 ? &reconstruction.patches.front()
                                                                         : nullptr;
  if (only == nullptr) return "each patch in the frame of its origin cell";
  return "in the frame of cell " + toString(only->origin) + ", the origin of the patch";
}

SE3 rigid(const SE3& T) { return {projectToSO3(T.R), T.t}; }

}  // namespace hexoderm
