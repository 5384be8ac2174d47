#include "hexoderm/io/export_selection.h"

#include "hexoderm/base/error.h"

#include <algorithm>
#include <set>

namespace hexoderm {
namespace {

bool hasLinks(PatchesInFile patches) { return patches == PatchesInFile::OnALink || patches == PatchesInFile::OnLinks; }

bool holdsAllInTheirFrames(const ExportFormatDescription& format, const ExportOptions& options) {
  return format.patches == PatchesInFile::All || (options.all_patches && format.patches == PatchesInFile::AllIfAsked);
}

/// Each placement belongs to a patch of this reconstruction.
void requirePlacements(const Reconstruction& reconstruction, const ExportOptions& options) {
  for (const PatchOnLink& place : options.placements) {
    const bool known = std::ranges::any_of(reconstruction.patches, [&](const PatchReconstruction& patch) {
      return patch.origin == place.origin && !patch.cells.empty();
    });
    if (!known) throw InvalidArgument("placements", message("no patch has cell {} as its origin", place.origin));
  }
}

/// The patch that the options name; null: none is named.
const PatchReconstruction* namedPatch(const Reconstruction& reconstruction, const ExportOptions& options) {
  if (!options.patch) return nullptr;
  const PatchReconstruction* patch = reconstruction.find(*options.patch).patch;
  if (patch == nullptr) throw InvalidArgument("patch", message("no patch holds a cell {}", *options.patch));
  return patch;
}

/// The patches that are placed, on the link that the options name if they name one.
std::vector<const PatchReconstruction*> placedPatches(const Reconstruction& reconstruction,
                                                      const ExportOptions& options) {
  const PatchReconstruction* only = namedPatch(reconstruction, options);
  std::vector<const PatchReconstruction*> placed;
  for (const PatchReconstruction& patch : reconstruction.patches) {
    const PatchOnLink* place = placementOf(patch, options);
    if (place == nullptr || (only != nullptr && only != &patch)) continue;
    if (options.in_link.empty() || place->link == options.in_link) placed.push_back(&patch);
  }
  return placed;
}

void requireOneLink(const std::vector<ExportMount>& mounted, const ExportFormatDescription& format) {
  std::set<std::string> links;
  for (const ExportMount& patch : mounted) links.insert(patch.link);
  if (links.size() <= 1) return;
  throw InvalidArgument(
      "in_link", message("the patches are placed on {} links, and {} as asked for holds one, for how links lie to each "
                         "other depends on the robot's joints: name one of them",
                         links.size(), format.name));
}

ExportMount mounted(const PatchReconstruction& patch, const ExportOptions& options) {
  const PatchOnLink* place = placementOf(patch, options);
  if (place == nullptr) return {&patch, options.parent_link, {}, false};
  return {&patch, place->link, place->T_l_o, true};
}

}  // namespace

const PatchOnLink* placementOf(const PatchReconstruction& patch, const ExportOptions& options) {
  const auto found = std::ranges::find(options.placements, patch.origin, &PatchOnLink::origin);
  return found == options.placements.end() ? nullptr : &*found;
}

ExportSelection selectForExport(const Reconstruction& reconstruction, const ExportFormatDescription& format,
                                const ExportOptions& options) {
  requirePlacements(reconstruction, options);
  if (options.all_patches && format.patches != PatchesInFile::All && format.patches != PatchesInFile::AllIfAsked) {
    throw InvalidArgument(
        "all_patches", message("{} has one frame, and how the patches lie to each other is not known: write each to a "
                               "file of its own",
                               format.name));
  }
  ExportSelection selection;
  if (!options.in_link.empty()) {
    if (holdsAllInTheirFrames(format, options)) {
      throw InvalidArgument("in_link",
                            message("{} holds each patch in a frame of its own, not in that of a link", format.name));
    }
    selection.patches = placedPatches(reconstruction, options);
    if (selection.patches.empty()) {
      throw InvalidArgument("in_link", message("no exported patch is placed on link {}", options.in_link));
    }
    if (!hasLinks(format.patches)) selection.frame_link = options.in_link;
  } else if (hasLinks(format.patches)) {
    selection.patches = placedPatches(reconstruction, options);
  }
  if (selection.patches.empty()) {
    if (const PatchReconstruction* only = namedPatch(reconstruction, options)) {
      selection.patches = {only};
    } else if (holdsAllInTheirFrames(format, options)) {
      for (const PatchReconstruction& patch : reconstruction.patches) selection.patches.push_back(&patch);
    } else if (const PatchReconstruction* largest = largestPatch(reconstruction)) {
      selection.patches = {largest};
    }
  }
  if (!hasLinks(format.patches)) return selection;
  for (const PatchReconstruction* patch : selection.patches) selection.mounted.push_back(mounted(*patch, options));
  const bool alone = format.format == ExportFormat::Urdf && options.urdf_form == UrdfForm::Alone;
  if (format.patches == PatchesInFile::OnALink || alone) requireOneLink(selection.mounted, format);
  return selection;
}

CellPlacement onLink(const CellPlacement& cell, const PatchOnLink& place) {
  CellPlacement placed = cell;
  placed.T_o_u = place.T_l_o * cell.T_o_u;
  for (SensorPlacement& sensor : placed.sensors) sensor.T_o_s = place.T_l_o * sensor.T_o_s;
  if (!cell.cov_t_r || !place.cov_t_r) {
    placed.cov_t_r.reset();
    return placed;
  }
  // With the errors dt_o, e_u of the cell and dt_l, e_o of the patch:
  // dt = dt_l - R_l_o [t_o]x e_o + R_l_o dt_o and e = R_o_u^T e_o + e_u.
  Matrix6d of_patch = Matrix6d::Identity();
  of_patch.topRightCorner<3, 3>() = -place.T_l_o.R * skew(cell.T_o_u.t);
  of_patch.bottomRightCorner<3, 3>() = cell.T_o_u.R.transpose();
  Matrix6d of_cell = Matrix6d::Identity();
  of_cell.topLeftCorner<3, 3>() = place.T_l_o.R;
  const Matrix6d covariance =
      of_patch * *place.cov_t_r * of_patch.transpose() + of_cell * *cell.cov_t_r * of_cell.transpose();
  placed.cov_t_r = 0.5 * (covariance + covariance.transpose());
  return placed;
}

Reconstruction exportedPart(const Reconstruction& reconstruction, const ExportSelection& selection,
                            const ExportOptions& options) {
  Reconstruction part = reconstruction;
  part.patches.clear();
  for (const PatchReconstruction* patch : selection.patches) {
    PatchReconstruction& added = part.patches.emplace_back(*patch);
    if (selection.frame_link.empty()) continue;
    for (CellPlacement& cell : added.cells) cell = onLink(cell, *placementOf(*patch, options));
  }
  const auto holds = [&](CellId cell) { return part.find(cell).cell != nullptr; };
  std::erase_if(part.layout.cells, [&](const FlatCell& cell) { return !holds(cell.cell); });
  std::erase_if(part.layout.links, [&](const FlatLink& link) {
    return std::ranges::none_of(part.patches, [&](const PatchReconstruction& patch) { return patch.id == link.patch; });
  });
  return part;
}

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
