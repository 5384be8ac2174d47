#pragma once

#include "hexoderm/io/export_selection.h"

#include <cstdint>
#include <string>
#include <variant>
#include <vector>

namespace hexoderm {

/// An array of a VTK file: `components` values for each tuple.
struct VtpArray {
  using Values = std::variant<std::vector<double>, std::vector<std::int64_t>, std::vector<std::string>>;
  std::string name;
  std::size_t components = 1;
  Values values;
};
struct VtpSection {
  std::string name;  ///< element of the file: "CellData", "Points", "Verts", "Polys"
  std::vector<VtpArray> arrays;
};

/// A vtkPolyData: the prisms of the cells (polygons) and the sensors (vertices), metres, each patch in the frame of its
/// origin cell, or of the link that the selection names.
///
/// Every polygon and vertex carries cell_id, patch, patch_origin, body_part, sensor and sensor_type (empty on the
/// cell's own polygons), placed_by (0 samples, 1 links), quality of the worst used link (0 un to 3 over, -1 none),
/// position_m and orientation_wxyz of the cell or sensor, sigma_position_m and sigma_rotation_rad of the cell
/// (not-a-number where not known). Field data: units, frame, cell model, solver, verdict and source as texts; cells,
/// the IDs of all cells, with cov_t_r, their covariances (upper triangle, order as in CellPlacement), accel_offset_g
/// and accel_scale.
struct VtpData {
  std::size_t points = 0;
  std::size_t verts = 0;
  std::size_t polys = 0;
  std::vector<VtpArray> field_data;
  std::vector<VtpSection> sections;
};

VtpData vtpData(const Reconstruction& reconstruction, const ExportSelection& selection = {});

/// XML with base64 blocks (no number loses a bit), as vtkXMLPolyDataReader reads it.
std::string vtpBytes(const VtpData& data);

}  // namespace hexoderm
