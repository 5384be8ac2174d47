#include "hexoderm/base/surface.h"

#include "hexoderm/base/error.h"
#include "hexoderm/base/limits.h"
#include "hexoderm/base/text.h"
#include "hexoderm/base/units.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <string>

namespace hexoderm {
namespace {

/// Wraps an angle to (-pi, pi].
double wrapAngle(double angle) { return std::remainder(angle, 2 * kPi); }

/// Cylindrical coordinates' unit vectors at azimuth a.
Eigen::Vector3d radialDirection(double azimuth) { return {std::cos(azimuth), std::sin(azimuth), 0}; }
Eigen::Vector3d aroundDirection(double azimuth) { return {-std::sin(azimuth), std::cos(azimuth), 0}; }
double azimuthOf(const Eigen::Vector3d& x) { return std::atan2(x.y(), x.x()); }

/// Frame at a point on the x side of a body of revolution: x around it, z along the normal.
SE3 frameAt(const Eigen::Vector3d& position, const Eigen::Vector3d& normal) {
  SE3 T;
  T.R.col(0) = Eigen::Vector3d::UnitY();
  T.R.col(1) = normal.cross(Eigen::Vector3d::UnitY());
  T.R.col(2) = normal;
  T.t = position;
  return T;
}

class Plane final : public Surface {
 public:
  [[nodiscard]] SE3 middle() const override { return {}; }
  [[nodiscard]] Eigen::Vector3d project(const Eigen::Vector3d& x) const override { return {x.x(), x.y(), 0}; }
  [[nodiscard]] Eigen::Vector3d normal(const Eigen::Vector3d&) const override { return Eigen::Vector3d::UnitZ(); }
  [[nodiscard]] Eigen::Matrix3d weingarten(const Eigen::Vector3d&) const override { return Eigen::Matrix3d::Zero(); }
  [[nodiscard]] GeodesicPoint walk(const Eigen::Vector3d& from, const Eigen::Vector3d& direction,
                                   double length_m) const override {
    return {from + length_m * direction, direction};
  }
  [[nodiscard]] Eigen::Vector3d bearing(const Eigen::Vector3d& from, const Eigen::Vector3d& to) const override {
    return to - from;
  }
};

/// Geodesics are helices.
class Cylinder final : public Surface {
 public:
  explicit Cylinder(double radius_m) : r_(radius_m) {}
  [[nodiscard]] SE3 middle() const override { return frameAt({r_, 0, 0}, Eigen::Vector3d::UnitX()); }
  [[nodiscard]] Eigen::Vector3d project(const Eigen::Vector3d& x) const override { return at(azimuthOf(x), x.z()); }
  [[nodiscard]] Eigen::Vector3d normal(const Eigen::Vector3d& x) const override {
    return radialDirection(azimuthOf(x));
  }
  [[nodiscard]] Eigen::Matrix3d weingarten(const Eigen::Vector3d& x) const override {
    const Eigen::Vector3d around = aroundDirection(azimuthOf(x));
    return around * around.transpose() / r_;
  }
  [[nodiscard]] GeodesicPoint walk(const Eigen::Vector3d& from, const Eigen::Vector3d& direction,
                                   double length_m) const override {
    const double azimuth = azimuthOf(from);
    const double around = direction.dot(aroundDirection(azimuth));
    const double end = azimuth + length_m * around / r_;
    return {at(end, from.z() + length_m * direction.z()),
            around * aroundDirection(end) + direction.z() * Eigen::Vector3d::UnitZ()};
  }
  [[nodiscard]] Eigen::Vector3d bearing(const Eigen::Vector3d& from, const Eigen::Vector3d& to) const override {
    const double azimuth = azimuthOf(from);
    return r_ * wrapAngle(azimuthOf(to) - azimuth) * aroundDirection(azimuth) +
           (to.z() - from.z()) * Eigen::Vector3d::UnitZ();
  }

 private:
  [[nodiscard]] Eigen::Vector3d at(double azimuth, double z) const {
    return r_ * radialDirection(azimuth) + z * Eigen::Vector3d::UnitZ();
  }
  double r_;
};

/// Geodesics are great circles.
class Sphere final : public Surface {
 public:
  explicit Sphere(double radius_m) : r_(radius_m) {}
  [[nodiscard]] SE3 middle() const override { return frameAt({r_, 0, 0}, Eigen::Vector3d::UnitX()); }
  [[nodiscard]] Eigen::Vector3d project(const Eigen::Vector3d& x) const override { return r_ * x.normalized(); }
  [[nodiscard]] Eigen::Vector3d normal(const Eigen::Vector3d& x) const override { return x.normalized(); }
  [[nodiscard]] Eigen::Matrix3d weingarten(const Eigen::Vector3d& x) const override {
    const Eigen::Vector3d n = x.normalized();
    return (Eigen::Matrix3d::Identity() - n * n.transpose()) / r_;
  }
  [[nodiscard]] GeodesicPoint walk(const Eigen::Vector3d& from, const Eigen::Vector3d& direction,
                                   double length_m) const override {
    const Eigen::Vector3d n = from.normalized();
    const double angle = length_m / r_;
    return {r_ * (std::cos(angle) * n + std::sin(angle) * direction),
            std::cos(angle) * direction - std::sin(angle) * n};
  }
  [[nodiscard]] Eigen::Vector3d bearing(const Eigen::Vector3d& from, const Eigen::Vector3d& to) const override {
    const Eigen::Vector3d n = from.normalized();
    const Eigen::Vector3d sideways = to / r_ - n * n.dot(to / r_);
    const double sine = sideways.norm();
    if (sine < 1e-300) return Eigen::Vector3d::Zero();
    return r_ * std::atan2(sine, n.dot(to / r_)) / sine * sideways;
  }

 private:
  double r_;
};

/// Geodesics are straight lines once the cone is unrolled: a point at slant distance s from the apex and azimuth a
/// comes to polar coordinates (s, a sin(angle)).
class Cone final : public Surface {
 public:
  Cone(double radius_m, double angle_rad)
      : r_(radius_m), sine_(std::sin(angle_rad)), cosine_(std::cos(angle_rad)), apex_z_(radius_m * cosine_ / sine_) {}
  [[nodiscard]] SE3 middle() const override { return frameAt({r_, 0, 0}, {cosine_, 0, sine_}); }
  [[nodiscard]] Eigen::Vector3d project(const Eigen::Vector3d& x) const override {
    return at(slantOf(x), azimuthOf(x));
  }
  [[nodiscard]] Eigen::Vector3d normal(const Eigen::Vector3d& x) const override {
    return cosine_ * radialDirection(azimuthOf(x)) + sine_ * Eigen::Vector3d::UnitZ();
  }
  [[nodiscard]] Eigen::Matrix3d weingarten(const Eigen::Vector3d& x) const override {
    const Eigen::Vector3d around = aroundDirection(azimuthOf(x));
    return cosine_ / (slantOf(x) * sine_) * around * around.transpose();
  }
  [[nodiscard]] GeodesicPoint walk(const Eigen::Vector3d& from, const Eigen::Vector3d& direction,
                                   double length_m) const override {
    const double azimuth = azimuthOf(from);
    const Eigen::Vector2d step(direction.dot(downDirection(azimuth)), direction.dot(aroundDirection(azimuth)));
    const Eigen::Vector2d end = Eigen::Vector2d(slantOf(from), 0) + length_m * step;
    const double turn = std::atan2(end.y(), end.x());
    const double end_azimuth = azimuth + turn / sine_;
    const double down = step.x() * std::cos(turn) + step.y() * std::sin(turn);
    const double around = step.y() * std::cos(turn) - step.x() * std::sin(turn);
    return {at(end.norm(), end_azimuth), down * downDirection(end_azimuth) + around * aroundDirection(end_azimuth)};
  }
  [[nodiscard]] Eigen::Vector3d bearing(const Eigen::Vector3d& from, const Eigen::Vector3d& to) const override {
    const double azimuth = azimuthOf(from);
    const double turn = wrapAngle(azimuthOf(to) - azimuth) * sine_;
    const double slant = slantOf(to);
    return (slant * std::cos(turn) - slantOf(from)) * downDirection(azimuth) +
           slant * std::sin(turn) * aroundDirection(azimuth);
  }

 private:
  [[nodiscard]] Eigen::Vector3d downDirection(double azimuth) const {
    return sine_ * radialDirection(azimuth) - cosine_ * Eigen::Vector3d::UnitZ();
  }
  [[nodiscard]] double slantOf(const Eigen::Vector3d& x) const {
    return std::max(std::hypot(x.x(), x.y()) * sine_ + (apex_z_ - x.z()) * cosine_, 1e-12);
  }
  [[nodiscard]] Eigen::Vector3d at(double slant, double azimuth) const {
    return apex_z_ * Eigen::Vector3d::UnitZ() + slant * downDirection(azimuth);
  }
  double r_, sine_, cosine_, apex_z_;
};

/// Geodesics have no closed form here: they are integrated (Runge-Kutta, steps of r/50 at most).
class Torus final : public Surface {
 public:
  Torus(double ring_m, double tube_m) : R_(ring_m), r_(tube_m) {}
  [[nodiscard]] SE3 middle() const override { return frameAt({R_ + r_, 0, 0}, Eigen::Vector3d::UnitX()); }
  [[nodiscard]] Eigen::Vector3d project(const Eigen::Vector3d& x) const override {
    return R_ * radialDirection(azimuthOf(x)) + r_ * normal(x);
  }
  [[nodiscard]] Eigen::Vector3d normal(const Eigen::Vector3d& x) const override {
    return (x - R_ * radialDirection(azimuthOf(x))).normalized();
  }
  [[nodiscard]] Eigen::Matrix3d weingarten(const Eigen::Vector3d& x) const override {
    const Eigen::Vector3d n = normal(x);
    const Eigen::Vector3d around = aroundDirection(azimuthOf(x));
    const Eigen::Vector3d about_tube = n.cross(around);
    return about_tube * about_tube.transpose() / r_ +
           n.dot(radialDirection(azimuthOf(x))) / std::hypot(x.x(), x.y()) * around * around.transpose();
  }
  [[nodiscard]] GeodesicPoint walk(const Eigen::Vector3d& from, const Eigen::Vector3d& direction,
                                   double length_m) const override {
    const int steps = std::max(1, static_cast<int>(std::ceil(std::abs(length_m) / (r_ / 50))));
    const double h = length_m / steps;
    Eigen::Vector3d x = from;
    Eigen::Vector3d u = direction;
    for (int k = 0; k < steps; ++k) {
      const Eigen::Vector3d a1 = acceleration(x, u);
      const Eigen::Vector3d u2 = u + h / 2 * a1;
      const Eigen::Vector3d a2 = acceleration(x + h / 2 * u, u2);
      const Eigen::Vector3d u3 = u + h / 2 * a2;
      const Eigen::Vector3d a3 = acceleration(x + h / 2 * u2, u3);
      const Eigen::Vector3d u4 = u + h * a3;
      const Eigen::Vector3d a4 = acceleration(x + h * u3, u4);
      x = project(x + h / 6 * (u + 2 * u2 + 2 * u3 + u4));
      u += h / 6 * (a1 + 2 * a2 + 2 * a3 + a4);
      const Eigen::Vector3d n = normal(x);
      u = (u - n * n.dot(u)).normalized();
    }
    return {x, u};
  }
  /// By shooting from the chord's direction until the walk ends at `to`.
  [[nodiscard]] Eigen::Vector3d bearing(const Eigen::Vector3d& from, const Eigen::Vector3d& to) const override {
    const Eigen::Vector3d n = normal(from);
    const Eigen::Vector3d chord = to - from;
    Eigen::Vector3d aim = chord - n * n.dot(chord);
    if (aim.norm() < 1e-300) return Eigen::Vector3d::Zero();
    aim *= chord.norm() / aim.norm();
    for (int k = 0; k < 30; ++k) {
      const double length = aim.norm();
      const Eigen::Vector3d forwards = aim / length;
      const GeodesicPoint end = walk(from, forwards, length);
      const Eigen::Vector3d miss = to - end.position;
      aim +=
          miss.dot(end.direction) * forwards + miss.dot(normal(end.position).cross(end.direction)) * n.cross(forwards);
      if (miss.norm() < 1e-13 * length) break;
    }
    return aim;
  }

 private:
  [[nodiscard]] Eigen::Vector3d acceleration(const Eigen::Vector3d& x, const Eigen::Vector3d& u) const {
    return -u.dot(weingarten(x) * u) * normal(x);
  }
  double R_, r_;
};

/// The numbers of "kind:name=value,name=value", all of them given, positive, and no others.
std::map<std::string, double> readParameters(const std::string& description, std::string_view text,
                                             const std::vector<std::string>& names) {
  const auto fail = [&](const Message& what) {
    throw InvalidArgument(
        message("surface \"{}\": {}; expected plane, cylinder:r=M, sphere:r=M, cone:r=M,angle=RAD or torus:R=M,r=M",
                description, what));
  };
  constexpr double kLargest = kMaxLength_m / 10;  // so that cells stay within it
  std::map<std::string, double> values;
  if (!text.empty()) {
    for (const std::string& item : split(text, ',')) {
      const std::size_t equals = item.find('=');
      if (equals == std::string::npos) fail(message("\"{}\" is not name=value", item));
      const std::string name = item.substr(0, equals);
      if (std::ranges::find(names, name) == names.end()) fail(message("there is no \"{}\" here", name));
      std::string what = "surface \"" + description + "\", ";
      what += name;
      const double value = parseNumber(std::string_view(item).substr(equals + 1), what);
      if (!(value > 0 && value <= kLargest))
        fail(message("{} must be above 0 and at most {}", name, Number{kLargest, 0}));
      if (!values.emplace(name, value).second) fail(message("{} is given twice", name));
    }
  }
  for (const std::string& name : names) {
    if (!values.contains(name)) fail(message("{} is missing", name));
  }
  return values;
}

}  // namespace

std::unique_ptr<Surface> makeSurface(std::string_view description) {
  const std::string text(description);
  const std::size_t colon = text.find(':');
  const std::string kind = text.substr(0, colon);
  const std::string parameters = colon == std::string::npos ? "" : text.substr(colon + 1);
  const auto read = [&](const std::vector<std::string>& names) { return readParameters(text, parameters, names); };
  if (kind == "plane") {
    read({});
    return std::make_unique<Plane>();
  }
  if (kind == "cylinder") return std::make_unique<Cylinder>(read({"r"}).at("r"));
  if (kind == "sphere") return std::make_unique<Sphere>(read({"r"}).at("r"));
  if (kind == "cone") {
    const auto values = read({"r", "angle"});
    if (values.at("angle") >= kPi / 2) {
      throw InvalidArgument(
          message("surface \"{}\": angle must be below pi/2 rad (it is between axis and surface)", text));
    }
    return std::make_unique<Cone>(values.at("r"), values.at("angle"));
  }
  if (kind == "torus") {
    const auto values = read({"R", "r"});
    if (values.at("R") <= values.at("r")) {
      throw InvalidArgument(message("surface \"{}\": R must be larger than r, or the torus meets itself", text));
    }
    return std::make_unique<Torus>(values.at("R"), values.at("r"));
  }
  throw InvalidArgument(message(
      "surface \"{}\" is not known; expected plane, cylinder:r=M, sphere:r=M, cone:r=M,angle=RAD or torus:R=M,r=M",
      text));
}

}  // namespace hexoderm
