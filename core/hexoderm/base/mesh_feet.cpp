#include "hexoderm/base/mesh_feet.h"

#include "hexoderm/base/error.h"
#include "hexoderm/base/se3.h"
#include "hexoderm/base/units.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <boost/geometry.hpp>
#include <boost/geometry/index/rtree.hpp>
#include <boost/iterator/function_output_iterator.hpp>
#include <cmath>
#include <iterator>
#include <limits>
#include <map>
#include <optional>
#include <utility>
#include <vector>

namespace hexoderm {
namespace {

namespace bg = boost::geometry;
using MeshPoint = bg::model::point<double, 3, bg::cs::cartesian>;
using MeshBox = bg::model::box<MeshPoint>;
using BoxOfTriangle = std::pair<MeshBox, std::uint32_t>;
using BoxTree = bg::index::rtree<BoxOfTriangle, bg::index::rstar<8>>;

constexpr double kEdge = 40 * kDegree;

MeshPoint toBoost(const Eigen::Vector3d& x) { return {x.x(), x.y(), x.z()}; }

using Corners = std::array<Eigen::Vector3d, 3>;
using CornerIndices = std::array<std::uint32_t, 3>;

/// The triangles in their order without those that repeat an earlier one. Otherwise every foot would be looked for in
/// all that repeat it.
std::vector<CornerIndices> withoutRepeats(std::vector<CornerIndices> triangles) {
  std::vector<std::pair<CornerIndices, std::uint32_t>> sorted;
  sorted.reserve(triangles.size());
  for (CornerIndices corners : triangles) {
    std::rotate(corners.begin(), std::ranges::min_element(corners), corners.end());
    sorted.emplace_back(corners, static_cast<std::uint32_t>(sorted.size()));
  }
  std::ranges::sort(sorted);
  const auto repeats =
      std::unique(sorted.begin(), sorted.end(), [](const auto& a, const auto& b) { return a.first == b.first; });
  if (repeats == sorted.end()) return triangles;
  sorted.erase(repeats, sorted.end());
  std::ranges::sort(sorted, {}, &std::pair<CornerIndices, std::uint32_t>::second);
  std::vector<CornerIndices> once;
  for (const auto& [corners, index] : sorted) once.push_back(triangles[index]);
  return once;
}

/// A triangle at one of its corners, or several of about the same normal.
struct Meeting {
  Eigen::Vector3d normal;
  double angle_rad;
};

/// Where many triangles meet, as at the apex of a fine cone, those within about 14 degrees become one: each will be
/// compared with all.
void joinDirections(std::vector<Meeting>& meeting) {
  constexpr std::size_t kMany = 64;
  constexpr double kPerUnit = 4;
  if (meeting.size() <= kMany) return;
  std::map<std::array<double, 3>, Eigen::Vector3d> joined;
  for (const Meeting& one : meeting) {
    const Eigen::Vector3d cell = (kPerUnit * one.normal).array().round();
    joined.try_emplace({cell.x(), cell.y(), cell.z()}, Eigen::Vector3d::Zero()).first->second +=
        one.angle_rad * one.normal;
  }
  meeting.clear();
  for (const auto& [cell, sum] : joined) meeting.push_back({sum.normalized(), sum.norm()});
}

/// Barycentric coordinates of the point of a triangle that is nearest to x (Ericson, Real-Time Collision Detection,
/// 5.1.5).
Eigen::Vector3d nearestInTriangle(const Corners& corners, const Eigen::Vector3d& x) {
  const Eigen::Vector3d ab = corners[1] - corners[0];
  const Eigen::Vector3d ac = corners[2] - corners[0];
  const Eigen::Vector3d ax = x - corners[0];
  const double d1 = ab.dot(ax);
  const double d2 = ac.dot(ax);
  if (d1 <= 0 && d2 <= 0) return {1, 0, 0};
  const Eigen::Vector3d bx = x - corners[1];
  const double d3 = ab.dot(bx);
  const double d4 = ac.dot(bx);
  if (d3 >= 0 && d4 <= d3) return {0, 1, 0};
  const double vc = d1 * d4 - d3 * d2;
  if (vc <= 0 && d1 >= 0 && d3 <= 0) return {1 - d1 / (d1 - d3), d1 / (d1 - d3), 0};
  const Eigen::Vector3d cx = x - corners[2];
  const double d5 = ab.dot(cx);
  const double d6 = ac.dot(cx);
  if (d6 >= 0 && d5 <= d6) return {0, 0, 1};
  const double vb = d5 * d2 - d1 * d6;
  if (vb <= 0 && d2 >= 0 && d6 <= 0) return {1 - d2 / (d2 - d6), 0, d2 / (d2 - d6)};
  const double va = d3 * d6 - d5 * d4;
  if (va <= 0 && d4 - d3 >= 0 && d5 - d6 >= 0) {
    const double w = (d4 - d3) / ((d4 - d3) + (d5 - d6));
    return {0, 1 - w, w};
  }
  const double sum = va + vb + vc;
  return {va / sum, vb / sum, vc / sum};
}

constexpr double kStep_m = 0.002;
constexpr double kCurvatureStep_m = 0.004;

/// `direction` made a unit tangent.
Eigen::Vector3d tangent(const Eigen::Vector3d& direction, const Eigen::Vector3d& normal) {
  return (direction - direction.dot(normal) * normal).normalized();
}

/// A point of the surface, and the normal there.
struct OnSurface {
  Eigen::Vector3d position;
  Eigen::Vector3d normal;
};

}  // namespace

struct MeshFeet::State {
  std::vector<Corners> triangles;
  std::vector<Corners> normals;  ///< at the corners of each
  BoxTree tree;

  void addTriangles(const TriangleMesh& mesh);
  [[nodiscard]] MeshFoot footIn(std::uint32_t triangle, const Eigen::Vector3d& weights) const;
};

void MeshFeet::State::addTriangles(const TriangleMesh& mesh) {
  std::vector<std::vector<Meeting>> meeting(mesh.points.size());
  std::vector<Eigen::Vector3d> face_normals;
  std::vector<CornerIndices> kept;
  for (const auto& triangle : withoutRepeats(mesh.triangles)) {
    const Corners corners{mesh.points.at(triangle[0]), mesh.points.at(triangle[1]), mesh.points.at(triangle[2])};
    const std::optional<Eigen::Vector3d> normal = normalOf(corners);
    if (!normal) continue;
    triangles.push_back(corners);
    face_normals.push_back(*normal);
    kept.push_back(triangle);
    for (std::size_t k = 0; k < 3; ++k) {
      const double angle = angleBetween(corners[(k + 1) % 3] - corners[k], corners[(k + 2) % 3] - corners[k]);
      meeting[triangle[k]].push_back({face_normals.back(), angle});
    }
  }
  for (std::vector<Meeting>& at_point : meeting) joinDirections(at_point);
  const double cos_edge = std::cos(kEdge);
  std::vector<BoxOfTriangle> boxes;
  for (std::size_t t = 0; t < triangles.size(); ++t) {
    Corners& at_corners = normals.emplace_back();
    for (std::size_t k = 0; k < 3; ++k) {
      Eigen::Vector3d sum = Eigen::Vector3d::Zero();
      for (const Meeting& other : meeting[kept[t][k]]) {
        if (other.normal.dot(face_normals[t]) >= cos_edge) sum += other.angle_rad * other.normal;
      }
      at_corners[k] = sum.normalized();
    }
    const Corners& corners = triangles[t];
    boxes.emplace_back(MeshBox(toBoost(corners[0].cwiseMin(corners[1]).cwiseMin(corners[2])),
                               toBoost(corners[0].cwiseMax(corners[1]).cwiseMax(corners[2]))),
                       static_cast<std::uint32_t>(t));
  }
  tree = BoxTree(boxes);
}

/// `weights`: barycentric coordinates.
MeshFoot MeshFeet::State::footIn(std::uint32_t triangle, const Eigen::Vector3d& weights) const {
  const Corners& corners = triangles[triangle];
  const Corners& at_corners = normals[triangle];
  MeshFoot foot;
  foot.position = weights[0] * corners[0] + weights[1] * corners[1] + weights[2] * corners[2];
  const Eigen::Vector3d sum = weights[0] * at_corners[0] + weights[1] * at_corners[1] + weights[2] * at_corners[2];
  foot.normal = sum.normalized();
  // Moving by dx in the triangle's plane changes the weight of a corner by its height's direction over that height.
  const Eigen::Vector3d area = (corners[1] - corners[0]).cross(corners[2] - corners[0]);
  Eigen::Matrix3d of_sum = Eigen::Matrix3d::Zero();
  for (std::size_t k = 0; k < 3; ++k) {
    const Eigen::Vector3d opposite = corners[(k + 2) % 3] - corners[(k + 1) % 3];
    of_sum += at_corners[k] * (area.cross(opposite) / area.squaredNorm()).transpose();
  }
  foot.W = (Eigen::Matrix3d::Identity() - foot.normal * foot.normal.transpose()) * of_sum / sum.norm();
  return foot;
}

MeshFeet::MeshFeet(const TriangleMesh& mesh) {
  auto state = std::make_unique<State>();
  state->addTriangles(mesh);
  state_ = std::move(state);
}
MeshFeet::~MeshFeet() = default;
MeshFeet::MeshFeet(MeshFeet&&) noexcept = default;
MeshFeet& MeshFeet::operator=(MeshFeet&&) noexcept = default;

bool MeshFeet::empty() const { return state_->triangles.empty(); }

MeshFoot MeshFeet::footOf(const Eigen::Vector3d& x) const {
  const auto first = static_cast<unsigned>(std::min<std::size_t>(32, state_->triangles.size()));
  constexpr double kRounding = 1e-9;
  const MeshPoint point = toBoost(x);
  double nearest_m2 = std::numeric_limits<double>::infinity();
  std::uint32_t nearest = 0;
  Eigen::Vector3d weights = Eigen::Vector3d::Zero();
  const auto look = [&](std::uint32_t triangle) {
    const Corners& corners = state_->triangles[triangle];
    const Eigen::Vector3d w = nearestInTriangle(corners, x);
    const Eigen::Vector3d position = w[0] * corners[0] + w[1] * corners[1] + w[2] * corners[2];
    const double distance_m2 = (position - x).squaredNorm();
    if (distance_m2 >= nearest_m2) return;
    nearest_m2 = distance_m2;
    nearest = triangle;
    weights = w;
  };
  std::vector<BoxOfTriangle> near;
  state_->tree.query(bg::index::nearest(point, first), std::back_inserter(near));
  double farthest_m2 = 0;
  for (const auto& [box, triangle] : near) {
    farthest_m2 = std::max(farthest_m2, bg::comparable_distance(point, box));
    look(triangle);
  }
  // The boxes that are nearest; and where none is farther than the nearest triangle, all that reach as near as that.
  if (near.size() < state_->triangles.size() && farthest_m2 <= nearest_m2) {
    const Eigen::Vector3d reach = Eigen::Vector3d::Constant((1 + kRounding) * std::sqrt(nearest_m2) + kRounding);
    const auto look_closely = boost::make_function_output_iterator([&](const BoxOfTriangle& found) {
      if (bg::comparable_distance(point, found.first) <= nearest_m2) look(found.second);
    });
    state_->tree.query(bg::index::intersects(MeshBox(toBoost(x - reach), toBoost(x + reach))), look_closely);
  }
  return state_->footIn(nearest, weights);
}

struct MeshSurface::State {
  explicit State(const TriangleMesh& mesh) : feet(mesh) {}
  MeshFeet feet;
  double height_m = 0;
  SE3 middle;

  [[nodiscard]] OnSurface onSurface(const Eigen::Vector3d& x) const;
};

/// The point of the surface at height_m: the one that stands on a foot's smooth normal, which is not quite the normal
/// of the foot's triangle. A few steps find the foot whose point is nearest to x.
OnSurface MeshSurface::State::onSurface(const Eigen::Vector3d& x) const {
  constexpr int kSteps = 4;
  MeshFoot foot = feet.footOf(x);
  if (height_m > 0) {
    for (int k = 0; k < kSteps; ++k) foot = feet.footOf(x - height_m * foot.normal);
  }
  return {foot.position + height_m * foot.normal, foot.normal};
}

MeshSurface::MeshSurface(TriangleMesh mesh, const SE3& T_b_near, double height_m) {
  if (!(height_m >= 0 && std::isfinite(height_m))) throw InvalidArgument("expected a height of 0 or more");
  auto state = std::make_unique<State>(mesh);
  state->height_m = height_m;
  if (state->feet.empty()) throw InvalidArgument(message("the body has no surface on which a patch could lie"));
  const OnSurface foot = state->onSurface(T_b_near.t);
  const Eigen::Vector3d x = T_b_near.R.col(0);
  if (!(x.cross(foot.normal).norm() > 1e-3)) {
    throw InvalidArgument(message("the patch can't be laid there: its x axis would stand upright on the body"));
  }
  state->middle.t = foot.position;
  state->middle.R.col(0) = tangent(x, foot.normal);
  state->middle.R.col(1) = foot.normal.cross(state->middle.R.col(0));
  state->middle.R.col(2) = foot.normal;
  state_ = std::move(state);
}
MeshSurface::~MeshSurface() = default;

SE3 MeshSurface::middle() const { return state_->middle; }
Eigen::Vector3d MeshSurface::project(const Eigen::Vector3d& x) const { return state_->onSurface(x).position; }
Eigen::Vector3d MeshSurface::normal(const Eigen::Vector3d& x) const { return state_->onSurface(x).normal; }

Eigen::Matrix3d MeshSurface::weingarten(const Eigen::Vector3d& x) const {
  const Eigen::Vector3d n = normal(x);
  Eigen::Matrix<double, 3, 2> axes;
  axes.col(0) = n.unitOrthogonal();
  axes.col(1) = n.cross(axes.col(0));
  Eigen::Matrix2d W;
  for (int k = 0; k < 2; ++k) {
    const Eigen::Vector3d step = kCurvatureStep_m * axes.col(k);
    W.col(k) = axes.transpose() * (normal(x + step) - normal(x - step)) / (2 * kCurvatureStep_m);
  }
  const Eigen::Matrix2d symmetric = (W + W.transpose()) / 2;
  return axes * symmetric * axes.transpose();
}

GeodesicPoint MeshSurface::walk(const Eigen::Vector3d& from, const Eigen::Vector3d& direction, double length_m) const {
  const auto steps = std::max(1, static_cast<int>(std::ceil(length_m / kStep_m)));
  const double step_m = length_m / steps;
  GeodesicPoint at{from, tangent(direction, normal(from))};
  for (int k = 0; k < steps; ++k) {
    // The middle of the step has the direction of its chord, to second order.
    const OnSurface half = state_->onSurface(at.position + step_m / 2 * at.direction);
    const Eigen::Vector3d along = tangent(at.direction, half.normal);
    const OnSurface end = state_->onSurface(at.position + step_m * along);
    at = {end.position, tangent(along, end.normal)};
  }
  return at;
}

Eigen::Vector3d MeshSurface::bearing(const Eigen::Vector3d& from, const Eigen::Vector3d& to) const {
  constexpr int kTries = 10;
  constexpr double kNear_m = 1e-6;
  const Eigen::Vector3d n = normal(from);
  Eigen::Vector3d way = to - from;
  way -= way.dot(n) * n;
  for (int k = 0; k < kTries && way.norm() > kNear_m; ++k) {
    const GeodesicPoint end = walk(from, way.normalized(), way.norm());
    const Eigen::Vector3d miss = to - end.position;
    if (miss.norm() < kNear_m) break;
    // What is missing at the end, carried back to the start as the direction was.
    const Eigen::Vector3d end_normal = normal(end.position);
    const Eigen::Vector3d start_direction = way.normalized();
    const double forward = miss.dot(end.direction);
    const double sideways = miss.dot(end_normal.cross(end.direction));
    way += forward * start_direction + sideways * n.cross(start_direction);
  }
  return way;
}

}  // namespace hexoderm
