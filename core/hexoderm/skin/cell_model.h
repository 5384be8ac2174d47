#pragma once

#include "hexoderm/base/ids.h"
#include "hexoderm/base/se3.h"
#include "hexoderm/base/units.h"

#include <array>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace hexoderm {

/// A side of a cell through which it can be joined to a neighbour.
struct Port {
  PortNumber number;
  /// Extended port vector in the cell frame, metres: from the cell's centre to its side and on by half the gap.
  Eigen::Vector3d vector_m;
};

/// The accelerometer of a cell, as its data sheet has it. Chips of one lot resemble each other: an error of a chip is
/// the lot's, which all cells of a skin share, and its own, which is independent of the others'.
struct Accelerometer {
  double range_g = 2.0;
  double lsb_g = 0.004;
  double rate_hz = 1000.0;
  double noise_g_per_sqrt_hz = 0.0005;
  /// 1 sigma of a chip's own uncalibrated offset, accelerometer axes; z is often worse than x and y.
  Eigen::Vector3d offset_sigma_g = Eigen::Vector3d::Constant(0.06);
  double offset_shared_sigma_g = 0;  ///< the same of the lot's offset, of each axis
  double scale_sigma = 0.02;         ///< 1 sigma of a chip's own relative scale error, per axis
  double scale_shared_sigma = 0;     ///< the same of the lot's, which all axes share
  double cross_axis_sigma = 0.005;   ///< 1 sigma of each off-diagonal element
  /// 1 sigma, per axis, of what a chip's own offset changes by from one session to another, and of what the offsets of
  /// all chips change by together: those of four recordings of a board of eight MPU-9150 on different days.
  double offset_drift_sigma_g = 0.006;
  double offset_drift_shared_sigma_g = 0.005;
  /// The same from one pose to another of one session (bias instability), while the chips warm up.
  double offset_instability_sigma_g = 0.0005;
  double offset_instability_shared_sigma_g = 0.0025;
  SE3 T_u_a;  ///< placement of the accelerometer in the cell frame

  /// The lot has errors of its own.
  [[nodiscard]] bool sharesErrors() const { return offset_shared_sigma_g > 0 || scale_shared_sigma > 0; }
  /// offset_sigma_g of the worst axis, for tests that take all axes alike.
  [[nodiscard]] double largestOffsetSigma_g() const { return offset_sigma_g.maxCoeff(); }
  /// The same of a chip that is looked at alone: the lot's errors count as its own.
  [[nodiscard]] Accelerometer ofUnknownLot() const;
  /// Covariance of what two cells' offsets differ by because both have the lot's, b - R_a_b b, g^2, in the first one's
  /// axes; `R_a_b` maps the second one's axes to these.
  [[nodiscard]] Eigen::Matrix3d sharedOffsetBetween_g2(const Eigen::Matrix3d& R_a_b) const;
};

/// A sensor on a cell, placed in the cell frame.
struct CellSensor {
  std::string name;
  std::string type;
  SE3 T_u_s;
};

/// A kind of cell: all that is known of it before anything is measured. The built-in model is
/// resources/cell_models/hex-bma150.json.
///
/// Cell frame: origin at the centre of the hexagon's front face, z out of the skin, right-handed. Metres, radians, g.
///
/// What has a default may be left as it is, as in a file; the rest must be given. Session and reconstruct() refuse a
/// model that validate() refuses.
struct CellModel {
  std::string name;
  double side_m = 0;
  double thickness_m = 0;
  double gap_m = 0;
  std::vector<Port> ports;
  CellId interface_id;  ///< cells with this ID or a larger one are computer interfaces
  Accelerometer accelerometer;
  std::vector<CellSensor> sensors;
  std::vector<std::pair<PortNumber, PortNumber>> forbidden_port_pairs;
  /// 1 sigma, about each axis, by which a chip sits askew in its cell. Readings show the chip's attitude, and the
  /// cell's only to within this. Chips soldered by machine: 0.1 to 0.5 degrees.
  double mounting_sigma_rad = 0.3 * kDegree;
  double side_angle_rad = 0;  ///< rotation of the outline about z; at 0 a corner lies on +x
  double link_sigma_m = 0.0005;
  double bend_sigma_rad = 30 * kDegree;  ///< priors of the elastomer, 1 sigma
  double twist_sigma_rad = 10 * kDegree;
  double yaw_sigma_rad = 2 * kDegree;

  /// nullptr if the model has no such port.
  [[nodiscard]] const Port* findPort(PortNumber number) const;
  /// Throws InvalidArgument if the model has no such port.
  [[nodiscard]] const Port& port(PortNumber number) const;
  [[nodiscard]] bool isForbidden(PortNumber a, PortNumber b) const;  ///< the two ports can't be joined
  /// Length of the longest extended port vector, metres.
  [[nodiscard]] double reach_m() const;
  /// The six corners of the front face in the cell frame, counter-clockwise seen from +z, metres.
  [[nodiscard]] std::array<Eigen::Vector3d, 6> outline() const;
  /// Throws InvalidArgument naming the first value that makes no sense.
  void validate() const;
};

/// The nominal alignment R_c_n of a link: turns p_n to -p_c and z x p_n to -z x p_c, so about z where z is 0 in both.
Eigen::Matrix3d nominalAlignment(const Port& source, const Port& target);

/// What twist, bend and yaw of a link are about, in the columns: unit vectors along the port's outward direction u,
/// z x u, and u x (z x u), which is z where the port lies in the cell's plane.
Eigen::Matrix3d linkAxes(const Port& port);

/// Twist, bend and yaw of a link, beyond its nominal alignment: with R_c_n R_nom^T = exp(w), the parts of w along the
/// linkAxes() of the source's port. Radians.
struct LinkAngles {
  double twist_rad = 0;
  double bend_rad = 0;
  double yaw_rad = 0;
};
/// The angles of the link between two ports, from the rotation of its cells.
LinkAngles linkAngles(const Eigen::Matrix3d& R_c_n, const Port& source, const Port& target);

/// T_c_n of two joined cells from their relative rotation, eq. (3): t_c_n = p_c - R_c_n p_n.
SE3 linkTransform(const Eigen::Matrix3d& R_c_n, const Port& source, const Port& target);

/// The built-in model of the given name ("hex-bma150"). Throws InvalidArgument listing the names there are.
CellModel builtInCellModel(std::string_view name);
std::vector<std::string> builtInCellModelNames();  ///< the names that builtInCellModel() knows

/// JSON text of a model, and back. `file` is named in errors (FormatError with the key path).
CellModel cellModelFromJson(std::string_view text, const std::string& file);
std::string cellModelToJson(const CellModel& model);  ///< the model as a document that cellModelFromJson() reads

/// A built-in name, or the path of a JSON file.
CellModel loadCellModel(const std::string& name_or_path);

}  // namespace hexoderm
