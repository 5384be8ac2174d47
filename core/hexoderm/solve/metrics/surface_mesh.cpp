#include "hexoderm/solve/metrics/surface_mesh.h"

#include "hexoderm/base/units.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace hexoderm {
namespace {

struct Interval {
  double low = std::numeric_limits<double>::infinity();
  double high = -std::numeric_limits<double>::infinity();

  void extend(double value) {
    low = std::min(low, value);
    high = std::max(high, value);
  }
  [[nodiscard]] Interval widened(double by) const { return {low - by, high + by}; }
  [[nodiscard]] double at(std::size_t k, std::size_t count) const {
    return low + (high - low) * static_cast<double>(k) / static_cast<double>(count - 1);
  }
};

/// The shortest interval that holds all angles, its ends `margin` further out; a whole turn where that closes it.
Interval aroundAngles(std::vector<double> angles, double margin) {
  std::ranges::sort(angles);
  double widest = angles.front() + 2 * kPi - angles.back();
  std::size_t begin = 0;
  for (std::size_t k = 1; k < angles.size(); ++k) {
    if (angles[k] - angles[k - 1] > widest) {
      widest = angles[k] - angles[k - 1];
      begin = k;
    }
  }
  const Interval interval{angles[begin] - margin, angles[begin] + 2 * kPi - widest + margin};
  return interval.high - interval.low >= 2 * kPi ? Interval{interval.low, interval.low + 2 * kPi} : interval;
}

/// Number of points that makes an arc look round.
std::size_t pointsForArc(double angle) {
  constexpr double kStep = 4 * kDegree;
  return 2 + static_cast<std::size_t>(std::ceil(angle / kStep));
}

/// A frame with the surface's axis as z.
Eigen::Matrix3d axisFrame(const SurfaceEvaluation& evaluation) {
  return shortestRotation(Eigen::Vector3d::UnitZ(), evaluation.axis.normalized());
}

void meshPlane(const SurfaceEvaluation& evaluation, double margin_m, SurfaceMesh& mesh) {
  const Eigen::Matrix3d R = axisFrame(evaluation);
  Interval x;
  Interval y;
  for (const Eigen::Vector3d& foot : mesh.feet) {
    const Eigen::Vector3d local = R.transpose() * (foot - evaluation.point);
    x.extend(local.x());
    y.extend(local.y());
  }
  x = x.widened(margin_m);
  y = y.widened(margin_m);
  mesh.rows = mesh.columns = 2;
  for (std::size_t row = 0; row < mesh.rows; ++row) {
    for (std::size_t column = 0; column < mesh.columns; ++column) {
      mesh.points.emplace_back(evaluation.point +
                               R * Eigen::Vector3d(x.at(column, mesh.columns), y.at(row, mesh.rows), 0));
      mesh.normals.emplace_back(R.col(2));
    }
  }
}

/// A cylinder is a cone that does not widen.
void meshCone(const SurfaceEvaluation& evaluation, double margin_m, SurfaceMesh& mesh) {
  const Eigen::Matrix3d R = axisFrame(evaluation);
  const double radius_m = *evaluation.radius_m;
  const double half_angle_rad = evaluation.half_angle_rad.value_or(0);
  Interval z;
  std::vector<double> angles;
  for (const Eigen::Vector3d& foot : mesh.feet) {
    const Eigen::Vector3d local = R.transpose() * (foot - evaluation.point);
    z.extend(local.z());
    angles.push_back(std::atan2(local.y(), local.x()));
  }
  z = z.widened(margin_m * std::cos(half_angle_rad));
  // Not beyond the tip.
  if (half_angle_rad > 0) z.low = std::max(z.low, -radius_m / std::tan(half_angle_rad));
  const Interval angle = aroundAngles(angles, margin_m / radius_m);
  mesh.rows = 2;
  mesh.columns = pointsForArc(angle.high - angle.low);
  for (std::size_t row = 0; row < mesh.rows; ++row) {
    for (std::size_t column = 0; column < mesh.columns; ++column) {
      const double a = angle.at(column, mesh.columns);
      const Eigen::Vector3d out(std::cos(a), std::sin(a), 0);
      const double along_m = z.at(row, mesh.rows);
      const double here_m = radius_m + along_m * std::tan(half_angle_rad);
      mesh.points.emplace_back(evaluation.point + R * (here_m * out + along_m * Eigen::Vector3d::UnitZ()));
      mesh.normals.emplace_back(R *
                                (std::cos(half_angle_rad) * out - std::sin(half_angle_rad) * Eigen::Vector3d::UnitZ()));
    }
  }
}

/// A cap about the middle of the cells.
void meshSphere(const SurfaceEvaluation& evaluation, double margin_m, SurfaceMesh& mesh) {
  const double radius_m = *evaluation.radius_m;
  Eigen::Vector3d middle = Eigen::Vector3d::Zero();
  for (const Eigen::Vector3d& foot : mesh.feet) middle += foot - evaluation.point;
  // Cells all around have no middle; then the whole sphere is drawn whatever the axis.
  const bool has_middle = middle.norm() > 1e-6 * radius_m * static_cast<double>(mesh.feet.size());
  const Eigen::Vector3d pole = has_middle ? Eigen::Vector3d(middle.normalized()) : Eigen::Vector3d::UnitZ();
  const Eigen::Matrix3d R = shortestRotation(Eigen::Vector3d::UnitZ(), pole);
  double reach = 0;
  for (const Eigen::Vector3d& foot : mesh.feet) reach = std::max(reach, angleBetween(foot - evaluation.point, pole));
  reach = std::min(reach + margin_m / radius_m, kPi);
  mesh.rows = pointsForArc(reach);
  mesh.columns = pointsForArc(2 * kPi);
  for (std::size_t row = 0; row < mesh.rows; ++row) {
    const double polar = Interval{0, reach}.at(row, mesh.rows);
    for (std::size_t column = 0; column < mesh.columns; ++column) {
      const double a = Interval{0, 2 * kPi}.at(column, mesh.columns);
      const Eigen::Vector3d out =
          R * Eigen::Vector3d(std::sin(polar) * std::cos(a), std::sin(polar) * std::sin(a), std::cos(polar));
      mesh.points.emplace_back(evaluation.point + radius_m * out);
      mesh.normals.push_back(out);
    }
  }
}

}  // namespace

SurfaceMesh meshSurface(const SurfaceEvaluation& evaluation, const PatchReconstruction& patch, double margin_m) {
  SurfaceMesh mesh;
  for (std::size_t k = 0; k < evaluation.cells.size(); ++k) {
    const CellPlacement* cell = patch.findCell(evaluation.cells[k]);
    if (cell == nullptr) continue;
    const Eigen::Vector3d center = cell->T_o_u.t;
    mesh.centers.push_back(center);
    mesh.feet.emplace_back(center - evaluation.distance_m[k] * evaluation.normalAt(center));
  }
  if (mesh.feet.empty()) return mesh;
  const auto& add = evaluation.kind == SurfaceKind::Plane    ? meshPlane
                    : evaluation.kind == SurfaceKind::Sphere ? meshSphere
                                                             : meshCone;  // of a cylinder too
  add(evaluation, margin_m, mesh);
  return mesh;
}

}  // namespace hexoderm
