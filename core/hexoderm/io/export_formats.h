#pragma once

// The formats that are written in one go. exportReconstruction(), exportBundle() and exportBytes() call these
// functions, and have checked that options make sense, that all numbers are finite and that a mesh has cells: only
// those that say so throw an Error. Placements in a Reconstruction are in the frame of the patch's origin cell, or in
// that of the link that ExportOptions::in_link names, which the selection, or `frame` in words, says. dotText() draws
// the flat layout.

#include "hexoderm/io/export_selection.h"
#include "hexoderm/io/exporter.h"
#include "hexoderm/io/skin_tree.h"
#include "hexoderm/robots/robot_model.h"
#include "hexoderm/solve/result/reconstruction.h"

#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

namespace hexoderm {

/// A cluster per patch, a node per cell at its place in the flat layout (real size; `neato` and `fdp` read `pos` in
/// inches), two directed edges per link with the ports at their ends and the quality as colour, style and tooltip.
std::string dotText(const Reconstruction& reconstruction);

/// glTF 2.0 in its binary form (.glb), metres. glTF has +Y up: the root node turns the skin's frame, whose z becomes
/// that +Y. Below it a node "cell_N" for each cell, with its place as translation and rotation and one of five shared
/// meshes, one a colour, and below that a node for each sensor. The frame is said in the root node's extras.
std::string gltfBytes(const Reconstruction& reconstruction, const std::string& frame);

/// SDF 1.9 (Gazebo), of one link of the robot: one <link> for it, with the cells as visuals in it, and a <frame> for
/// every patch, cell and sensor. A link of SDF has a mass; the skin's is not known, and 1 g stands for it.
std::string sdfBytes(const SkinTree& tree);
/// MJCF (MuJoCo), likewise: a body for the link of the robot, each patch and each cell, a site for each sensor, and an
/// <accelerometer> for those sensors that are. The geometry has no mass and touches nothing.
std::string mjcfBytes(const SkinTree& tree);

/// Static transforms for TF: of every frame, its parent, and T_parent_frame as a translation in metres and a
/// quaternion.
std::string rosLaunchText(const std::vector<SkinFrame>& frames);   ///< ROS 1: static_transform_publisher of tf2_ros
std::string ros2LaunchText(const std::vector<SkinFrame>& frames);  ///< ROS 2, in Python
/// A list of geometry_msgs/TransformStamped, for a node that sends all of them at once.
std::string transformsYaml(const std::vector<SkinFrame>& frames);

/// TUM SkinConfig XML: every patch with its cells in the frame of its origin (the root cell), their neighbours at each
/// port, and a patchExtrinsics element with where the root cell is in the link it is placed on. Metres, 12 decimals.
std::string tumBytes(const Reconstruction& reconstruction, const ExportOptions& options);

// Meshes of the cells: their prisms, in PLY and OBJ in the colours of each cell's worst used link.

/// ASCII PLY in metres with uchar colours and a comment that names unit and frame.
std::string plyText(const Reconstruction& reconstruction, const ExportSelection& selection = {});

/// Binary STL, in the unit asked for.
std::string stlBytes(const Reconstruction& reconstruction, LengthUnit unit);

/// Wavefront OBJ in metres: an object "cell_N" for each cell, its colour at each vertex ("v x y z r g b", which most
/// programs read and others skip), no file of materials.
std::string objText(const Reconstruction& reconstruction, const ExportSelection& selection = {});

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

/// What a URDF of the skin holds: all joints fixed and named after their child. With one link per patch the cells are
/// its visuals and the sensors are <sensor> elements. Cells are drawn as hexagonal prisms.
struct UrdfContent {
  SkinTree tree;
  bool link_per_cell = true;
  UrdfForm form = UrdfForm::Alone;  ///< of a file of the skin's own
};

/// The skin in a file of its own. InvalidArgument: the name of a patch is none that a xacro macro can have.
std::string urdfBytes(const UrdfContent& content);

/// The description of a robot: its text, and what urdfdom and KDL make of it.
struct RobotUrdf {
  std::string text;
  RobotModel model;
};
/// Throws StorageError; FormatError, naming file, place and expectation, for what is no URDF.
RobotUrdf readRobotUrdf(const std::filesystem::path& path);

/// The robot with the skin on it: its text byte for byte, and in front of </robot> the links and joints of the skin.
/// InvalidArgument: the robot has no link of the name that a patch is placed on. FormatError: it has a link, joint or
/// sensor already of the name of one that would be added. Materials that it has, of an earlier skin, are used.
std::string robotUrdfBytes(const RobotUrdf& robot, const UrdfContent& content);

/// A field of a table: empty, a text, a whole number or a number.
using CsvField = std::variant<std::monostate, std::string, std::uint64_t, double>;

/// A table: a header line whose names carry the units, then one row each of as many fields.
struct CsvTable {
  std::string file;  ///< "cells.csv"
  std::vector<std::string> header;
  std::vector<std::vector<CsvField>> rows;
};

/// cells.csv, sensors.csv, links.csv, poses.csv and residuals.csv (links x poses), in metres, degrees and g; and
/// covariances.csv, each cell's upper triangle (order and frames as in CellPlacement), in metres and radians. A field
/// is empty where its figure is not known. Rows with a place name the patch and the cell whose frame it is in.
std::vector<CsvTable> csvTables(const Reconstruction& reconstruction);

/// What the table with this name holds: lengths at all, and what is in a patch's frame.
struct CsvContents {
  bool lengths = true;
  bool in_frame = true;
};
CsvContents csvContents(std::string_view file);

/// RFC 4180 quoting, UTF-8, lines ended by a line feed, every number exact. InvalidArgument: a number is not finite.
std::string csvText(const CsvTable& table);

/// A cell as a taxel: the centre of its front face and its outward normal in the link's frame, metres.
struct Taxel {
  CellId cell;
  Eigen::Vector3d position = Eigen::Vector3d::Zero();
  Eigen::Vector3d normal = Eigen::Vector3d::Zero();
  std::size_t link = 0;  ///< index into the links of the file
};
struct TaxelMap {
  std::vector<std::string> links;  ///< in order of their first patch
  std::vector<Taxel> taxels;
  double radius_m = 0;  ///< of the circle in a cell
};
TaxelMap taxelMap(const CellModel& model, const std::vector<ExportMount>& mounted, const ExportOptions& options);

/// iCub taxel positions: a row "x y z nx ny nz" for each cell in order of ID, then rows of zeros, which stand for no
/// taxel, up to whole triangles of 12, at least one, and an empty line: a reader that drops the last row, or the last
/// line, loses no cell. Each cell is its own representative in taxel2Repr, -1 a row without. The file's `name` is that
/// of the link.
std::string icubText(const TaxelMap& map);

/// Skinware map: the number of cells, then a line of ten integers each: type (0), uid (the cell), position (nm), normal
/// (a unit vector times 10^9), radius (nm), link (0 for the first of `map`).
std::string skinwareText(const TaxelMap& map);

}  // namespace hexoderm
