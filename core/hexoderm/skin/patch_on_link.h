#pragma once

#include "hexoderm/base/ids.h"
#include "hexoderm/base/se3.h"

#include <map>
#include <optional>
#include <string>
#include <vector>

namespace hexoderm {

/// Where a patch is on the robot: x_l = T_l_o x_o, from the patch's frame into that of a link.
struct PatchOnLink {
  CellId origin;     ///< the origin cell of the patch, whose frame is o
  std::string link;  ///< as the robot's description names it
  SE3 T_l_o;         ///< metres
  /// Order position (m, link frame) then rotation (rad, right-multiplied error in the patch frame). Absent where it is
  /// not known; the covariances of cells in the link's frame are then not known either.
  std::optional<Matrix6d> cov_t_r;
};

/// The centre of a cell's front face is at a point of the link.
struct KnownPoint {
  CellId cell;
  Eigen::Vector3d x_l = Eigen::Vector3d::Zero();  ///< m
  double sigma_m = 0.001;                         ///< an axis
};
/// The centres of the front faces of two cells of different patches are so far apart.
struct KnownDistance {
  CellId a;
  CellId b;
  double distance_m = 0;
  double sigma_m = 0.001;
};

/// The robot that wears the skin: which description of it is meant.
struct RobotDescription {
  std::string urdf;                             ///< path of the URDF, as it was given
  std::string sha256;                           ///< of its bytes, hexadecimal digits
  std::map<std::string, std::string> packages;  ///< folders of package://NAME/, by NAME
  friend bool operator==(const RobotDescription&, const RobotDescription&) = default;
  /// Throws InvalidArgument for a description without a file, and a package without a name or a folder.
  void validate() const;
};

/// What was decided about the place of a patch on the robot, and what it was found by.
struct PatchPlacement {
  CellId origin;             ///< the origin cell of the patch when it was decided; it names the patch
  std::string link;          ///< the link that the patch is on; empty: not decided
  bool link_chosen = false;  ///< by the operator; else no other link fitted
  bool by_surface = true;    ///< the backs of the cells lie on the link's surface
  std::vector<KnownPoint> points;
  std::vector<KnownDistance> distances;  ///< from a cell of this patch, `a`, to one of another
  std::optional<PatchOnLink> place;      ///< once it was chosen

  /// Nothing is decided.
  [[nodiscard]] bool isEmpty() const {
    return link.empty() && points.empty() && distances.empty() && !place && by_surface;
  }
  /// Throws InvalidArgument for numbers that are not finite or beyond kMaxLength_m, sigmas that are not above 0, a
  /// rotation that is none, a covariance that is none, and a place that is not that of this patch on this link.
  void validate() const;
};

}  // namespace hexoderm
