#include "hexoderm/skin/cell_model.h"

#include "hexoderm/base/error.h"
#include "hexoderm/base/is_rotation.h"
#include "hexoderm/base/limits.h"
#include "hexoderm/base/units.h"
#include "hexoderm/skin/cell_lengths.h"

#include <algorithm>
#include <cmath>
#include <set>
#include <utility>

namespace hexoderm {
namespace {

// Far beyond every skin, and such that squares, and one divided by them, are still numbers.
constexpr double kMin = 1e-12;
constexpr double kMax = 1e9;

double headingOf(const Port& port) { return std::atan2(port.vector_m.y(), port.vector_m.x()); }
double elevationOf(const Port& port) { return std::atan2(port.vector_m.z(), port.vector_m.head<2>().norm()); }

}  // namespace

Accelerometer Accelerometer::ofUnknownLot() const {
  Accelerometer alone = *this;
  const double shared_g = std::exchange(alone.offset_shared_sigma_g, 0);
  alone.offset_sigma_g = offset_sigma_g.unaryExpr([&](double own_g) { return std::hypot(own_g, shared_g); });
  alone.scale_sigma = std::hypot(scale_sigma, std::exchange(alone.scale_shared_sigma, 0));
  return alone;
}

Eigen::Matrix3d Accelerometer::sharedOffsetBetween_g2(const Eigen::Matrix3d& R_a_b) const {
  // (I - R)(I - R)^T
  return offset_shared_sigma_g * offset_shared_sigma_g * (2 * Eigen::Matrix3d::Identity() - R_a_b - R_a_b.transpose());
}

const Port* CellModel::findPort(PortNumber number) const {
  const auto found = std::ranges::find(ports, number, &Port::number);
  return found == ports.end() ? nullptr : &*found;
}

const Port& CellModel::port(PortNumber number) const {
  const Port* found = findPort(number);
  if (found == nullptr) throw InvalidArgument(message("cell model {} has no port {}", name, number));
  return *found;
}

bool CellModel::isForbidden(PortNumber a, PortNumber b) const {
  return std::ranges::any_of(forbidden_port_pairs,
                             [&](const auto& pair) { return pair == std::pair(a, b) || pair == std::pair(b, a); });
}

double CellModel::reach_m() const {
  double reach = 0;
  for (const Port& port : ports) reach = std::max(reach, port.vector_m.norm());
  return reach;
}

std::array<Eigen::Vector3d, 6> CellModel::outline() const {
  std::array<Eigen::Vector3d, 6> corners;
  for (int k = 0; k < 6; ++k) {
    const double angle = side_angle_rad + k * kPi / 3;
    corners.at(static_cast<std::size_t>(k)) = {side_m * std::cos(angle), side_m * std::sin(angle), 0};
  }
  return corners;
}

void CellModel::validate() const {
  const auto require = [&](bool holds, const Message& what) {
    if (!holds) throw InvalidArgument(located(message("cell model {}", name), what));
  };
  const auto within = [&](double value, const std::string& what, double least, double most) {
    require(value >= least && value <= most,
            message("{} must be from {} to {}, found {}", what, Number{least}, Number{most}, Number{value}));
  };
  const auto positive = [&](double value, const std::string& what, double most = kMax) {
    require(value > 0, message("{} must be above 0", what));
    within(value, what, kMin, most);
  };
  const auto notNegative = [&](double value, const std::string& what, double most = kMax) {
    require(value >= 0, message("{} must not be negative", what));
    if (value != 0) positive(value, what, most);
  };
  const auto placed = [&](const SE3& T, const std::string& what) {
    require(isWithin(T.t, kMaxCellLength_m),
            message("{} must be within {} m", what + "t_u_m", Number{kMaxCellLength_m}));
    require(isRotation(T.R), message("{} must be a rotation", what + "R_u"));
  };
  require(!name.empty(), message("name must not be empty"));
  within(side_m, "side_m", kMinCellSide_m, kMaxCellLength_m);
  notNegative(thickness_m, "thickness_m", kMaxCellLength_m);
  notNegative(gap_m, "gap_m", kMaxCellLength_m);
  require(!ports.empty(), message("there must be at least one port"));
  std::set<PortNumber> numbers;
  for (const Port& port : ports) {
    require(numbers.insert(port.number).second, message("port {} is listed twice", port.number));
    require(isWithin(port.vector_m, kMaxCellLength_m) && port.vector_m.head<2>().norm() > 1e-9,
            message("port {}: vector_m must point out of the cell's side, by at most {} m", port.number,
                    Number{kMaxCellLength_m}));
  }
  for (const auto& [a, b] : forbidden_port_pairs) {
    require(findPort(a) != nullptr && findPort(b) != nullptr, message("forbidden_port_pairs names an unknown port"));
  }
  require(interface_id.value() > 0, message("interface_id must be above 0"));
  positive(accelerometer.range_g, "accelerometer.range_g", kMaxAcceleration_g);
  notNegative(accelerometer.lsb_g, "accelerometer.lsb_g", kMaxAcceleration_g);
  positive(accelerometer.rate_hz, "accelerometer.rate_hz");
  notNegative(accelerometer.noise_g_per_sqrt_hz, "accelerometer.noise_g_per_sqrt_hz");
  for (const double sigma_g : accelerometer.offset_sigma_g) notNegative(sigma_g, "accelerometer.offset_sigma_g");
  notNegative(accelerometer.offset_shared_sigma_g, "accelerometer.offset_shared_sigma_g");
  notNegative(accelerometer.scale_sigma, "accelerometer.scale_sigma");
  notNegative(accelerometer.scale_shared_sigma, "accelerometer.scale_shared_sigma");
  notNegative(accelerometer.cross_axis_sigma, "accelerometer.cross_axis_sigma");
  notNegative(accelerometer.offset_drift_sigma_g, "accelerometer.offset_drift_sigma_g");
  notNegative(accelerometer.offset_drift_shared_sigma_g, "accelerometer.offset_drift_shared_sigma_g");
  notNegative(accelerometer.offset_instability_sigma_g, "accelerometer.offset_instability_sigma_g");
  notNegative(accelerometer.offset_instability_shared_sigma_g, "accelerometer.offset_instability_shared_sigma_g");
  placed(accelerometer.T_u_a, "accelerometer.");
  for (const CellSensor& sensor : sensors) placed(sensor.T_u_s, "sensor " + sensor.name + ": ");
  notNegative(mounting_sigma_rad, "mounting_sigma_rad", kPi);
  require(std::abs(side_angle_rad) <= kMax, message("side_angle_rad must be within {}", Number{kMax}));
  positive(link_sigma_m, "link_sigma_m");
  positive(bend_sigma_rad, "bend_sigma_rad");
  positive(twist_sigma_rad, "twist_sigma_rad");
  positive(yaw_sigma_rad, "yaw_sigma_rad");
}

Eigen::Matrix3d nominalAlignment(const Port& source, const Port& target) {
  const double angle = headingOf(source) + kPi - headingOf(target);
  Eigen::Matrix3d R;
  R << std::cos(angle), -std::sin(angle), 0, std::sin(angle), std::cos(angle), 0, 0, 0, 1;
  const double fold = -(elevationOf(source) + elevationOf(target));
  return Eigen::AngleAxisd(fold, linkAxes(source).col(1)).toRotationMatrix() * R;
}

Eigen::Matrix3d linkAxes(const Port& port) {
  const Eigen::Vector3d u = port.vector_m.normalized();
  const double level = u.z() == 0 ? 1 : u.head<2>().norm();  // z is z to the last digit where ports have no height
  Eigen::Matrix3d axes;
  axes << u, Eigen::Vector3d::UnitZ().cross(u) / level, Eigen::Vector3d(-u.z() * u.x(), -u.z() * u.y(), 0) / level;
  axes(2, 2) = level;
  return axes;
}

LinkAngles linkAngles(const Eigen::Matrix3d& R_c_n, const Port& source, const Port& target) {
  const Eigen::Matrix3d axes = linkAxes(source);
  const Eigen::Vector3d w = logSO3(R_c_n * nominalAlignment(source, target).transpose());
  return {w.dot(axes.col(0)), w.dot(axes.col(1)), w.dot(axes.col(2))};
}

SE3 linkTransform(const Eigen::Matrix3d& R_c_n, const Port& source, const Port& target) {
  return {R_c_n, source.vector_m - R_c_n * target.vector_m};
}

}  // namespace hexoderm
