#pragma once

#include "hexoderm/io/exporter.h"

#include <string>
#include <unordered_map>
#include <vector>

namespace hexoderm {

/// A patch and the link that a file fixes it to.
struct ExportMount {
  const PatchReconstruction* patch = nullptr;
  std::string link;
  SE3 T_l_o;
  bool placed = false;  ///< false: where the patch is on the link is not known, and its frame is the link's
};

/// What of a skin goes into a file, and in which frame.
struct ExportSelection {
  std::vector<const PatchReconstruction*> patches;
  std::vector<ExportMount> mounted;  ///< the same, for formats with links
  std::string frame_link;  ///< of formats without links: whose frame coordinates are in; empty: each patch's own
};

/// InvalidArgument: the options and the format don't go together, or no patch is what the options ask for.
ExportSelection selectForExport(const Reconstruction& reconstruction, const ExportFormatDescription& format,
                                const ExportOptions& options);

/// The reconstruction with the selected patches alone; with a `frame_link` its cells, sensors and covariances are in
/// that link's frame.
Reconstruction exportedPart(const Reconstruction& reconstruction, const ExportSelection& selection,
                            const ExportOptions& options);

/// The placement of a patch by its origin; null if it is not placed.
const PatchOnLink* placementOf(const PatchReconstruction& patch, const ExportOptions& options);

/// A cell in the frame of its patch's link, its covariance with that of the patch, both taken as independent.
CellPlacement onLink(const CellPlacement& cell, const PatchOnLink& place);

// Functions shared by the exporters.

/// Class of each cell's worst used link; cells without a used link are not in the map.
std::unordered_map<CellId, EdgeQuality> worstUsedQuality(const Reconstruction& reconstruction);

/// The frame of the points, for files that say it: "in the frame of cell 7, the origin of the patch", "in the frame of
/// link r_forearm".
std::string frameText(const Reconstruction& reconstruction, const ExportSelection& selection = {});

/// The placement with its rotation made orthogonal to rounding: files may state rotations with few decimals, and
/// quaternions and angles can only say true ones.
SE3 rigid(const SE3& T);

}  // namespace hexoderm
