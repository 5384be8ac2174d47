#include "hexoderm/base/mesh_surface.h"

#include "hexoderm/base/error.h"
#include "hexoderm/base/mesh_feet.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

namespace hexoderm {
namespace {

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
