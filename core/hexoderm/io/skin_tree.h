#pragma once

#include "hexoderm/io/export_selection.h"

#include <array>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace hexoderm {

// A skin as robot descriptions have it: link of the robot -> PREFIXpatchK -> PREFIXcellN -> PREFIXcellN_SENSOR. URDF,
// SDF, MJCF and the static transforms are made of it, so that a frame has one name in all of them.

struct SkinTreeSensor {
  std::string name;
  std::string type;
  SE3 T_o_s;
};
struct SkinTreeCell {
  CellId cell;
  std::string name;
  std::string material;
  SE3 T_o_u;
  std::vector<SkinTreeSensor> sensors;
};
struct SkinTreePatch {
  std::string name;
  std::string link;
  SE3 T_l_o;
  bool placed = false;
  CellId origin;
  std::vector<SkinTreeCell> cells;
};
struct SkinTree {
  std::string model;
  std::vector<std::string> links;  ///< of the robot, in order of their first patch; without patches the parent link
  std::vector<SkinTreePatch> patches;
  double side_m = 0;
  double thickness_m = 0;
  double side_angle_rad = 0;
};

/// Throws InvalidArgument if a link of the robot is also the name of one made here.
SkinTree skinTree(const CellModel& model, const std::vector<ExportMount>& mounted, const Reconstruction& reconstruction,
                  const ExportOptions& options);

/// A frame of the tree and where it hangs.
struct SkinFrame {
  std::string name;
  std::string parent;
  SE3 T_parent_frame;
};
/// Patches, and with `cells` cells and sensors; parents before children.
std::vector<SkinFrame> skinFrames(const SkinTree& tree, bool cells);

/// A regular hexagonal prism as boxes: each spans two opposite sides, and the three together are the prism exactly. So
/// a description holds the true shape of a cell without a mesh file that would have to be found.
struct CellBoxes {
  Eigen::Vector3d size_m;
  std::array<SE3, 3> T_u_box;  ///< the front face is at z = 0 of the cell
};
CellBoxes cellBoxes(const SkinTree& tree);
/// Of a box of a cell, counted from 1 in the name.
std::string boxName(const SkinTreeCell& cell, std::size_t box);

/// The colours of cells by the quality of their worst used link.
struct SkinMaterial {
  std::string name;
  std::uint32_t rgb = 0;
};
std::vector<SkinMaterial> skinMaterials();
/// "0.1 0.5 0.9", and with a 1 behind it.
std::string rgbText(std::uint32_t rgb);
std::string rgbaText(std::uint32_t rgb);

/// "0 0.1 -0.02", each number exact, no "-0".
std::string vectorText(const Eigen::Vector3d& v);
/// The quaternion of a rotation with w >= 0.
Eigen::Quaterniond quaternionOf(const Eigen::Matrix3d& R);
/// Not empty, and only letters, digits and _ - . / with no slash in front: what URDF and TF accept.
bool isLinkName(std::string_view name);

}  // namespace hexoderm
