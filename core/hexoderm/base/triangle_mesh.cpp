#include "hexoderm/base/triangle_mesh.h"

#include "hexoderm/base/units.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <utility>

namespace hexoderm {
namespace {

constexpr std::uint32_t kAround = 48;
constexpr std::uint32_t kSphereRows = 24;

/// The k-th of `kAround` directions in the plane z = 0.
Eigen::Vector3d directionAround(std::uint32_t k) {
  const double angle = 2 * kPi * k / kAround;
  return {std::cos(angle), std::sin(angle), 0};
}

}  // namespace

BoundingBox boundingBox(const TriangleMesh& mesh) {
  BoundingBox box;
  if (mesh.points.empty()) return box;
  box.low = box.high = mesh.points.front();
  for (const Eigen::Vector3d& point : mesh.points) {
    box.low = box.low.cwiseMin(point);
    box.high = box.high.cwiseMax(point);
  }
  return box;
}

std::optional<Eigen::Vector3d> normalOf(const std::array<Eigen::Vector3d, 3>& corners) {
  constexpr double kMinArea_m2 = 1e-14;  // twice that of the triangle
  const Eigen::Vector3d area = (corners[1] - corners[0]).cross(corners[2] - corners[0]);
  if (!(area.norm() > kMinArea_m2)) return std::nullopt;
  return area.normalized();
}

bool hasArea(const TriangleMesh& mesh) {
  return std::ranges::any_of(mesh.triangles, [&](const auto& triangle) {
    return normalOf({mesh.points[triangle[0]], mesh.points[triangle[1]], mesh.points[triangle[2]]}).has_value();
  });
}

TriangleMesh transformed(TriangleMesh mesh, const SE3& T_a_b) {
  for (Eigen::Vector3d& point : mesh.points) point = T_a_b * point;
  return mesh;
}

void append(TriangleMesh& mesh, const TriangleMesh& other) {
  const auto first = static_cast<std::uint32_t>(mesh.points.size());
  mesh.points.insert(mesh.points.end(), other.points.begin(), other.points.end());
  for (const auto& [a, b, c] : other.triangles) mesh.triangles.push_back({first + a, first + b, first + c});
}

double enclosedVolume(const TriangleMesh& mesh) {
  double six_volumes = 0;
  for (const auto& [a, b, c] : mesh.triangles) {
    six_volumes += mesh.points[a].dot(mesh.points[b].cross(mesh.points[c]));
  }
  return six_volumes / 6;
}

bool isInsideOut(const TriangleMesh& mesh) {
  constexpr double kMinFilled = 0.02;
  const double box_m3 = boundingBox(mesh).size().prod();
  return box_m3 > 0 && enclosedVolume(mesh) < -kMinFilled * box_m3;
}

void turnInsideOut(TriangleMesh& mesh) {
  for (auto& triangle : mesh.triangles) std::swap(triangle[1], triangle[2]);
}

TriangleMesh meshOfBox(const Eigen::Vector3d& size_m) {
  TriangleMesh mesh;
  for (unsigned corner = 0; corner < 8; ++corner) {
    const Eigen::Vector3d sign(corner & 1U ? 1 : -1, corner & 2U ? 1 : -1, corner & 4U ? 1 : -1);
    mesh.points.emplace_back(0.5 * sign.cwiseProduct(size_m));
  }
  mesh.triangles = {{0, 2, 1}, {1, 2, 3}, {4, 5, 6}, {5, 7, 6}, {0, 1, 4}, {1, 5, 4},
                    {2, 6, 3}, {3, 6, 7}, {0, 4, 2}, {2, 4, 6}, {1, 3, 5}, {3, 7, 5}};
  return mesh;
}

TriangleMesh meshOfCylinder(double radius_m, double length_m) {
  TriangleMesh mesh;
  const Eigen::Vector3d up(0, 0, 0.5 * length_m);
  for (std::uint32_t k = 0; k < kAround; ++k) {
    mesh.points.emplace_back(radius_m * directionAround(k) - up);
    mesh.points.emplace_back(radius_m * directionAround(k) + up);
  }
  const auto bottom = static_cast<std::uint32_t>(mesh.points.size());
  mesh.points.emplace_back(-up);
  mesh.points.emplace_back(up);
  for (std::uint32_t k = 0; k < kAround; ++k) {
    const std::uint32_t here = 2 * k;
    const std::uint32_t next = 2 * ((k + 1) % kAround);
    mesh.triangles.push_back({here, next, here + 1});
    mesh.triangles.push_back({next, next + 1, here + 1});
    mesh.triangles.push_back({next, here, bottom});
    mesh.triangles.push_back({here + 1, next + 1, bottom + 1});
  }
  return mesh;
}

TriangleMesh meshOfSphere(double radius_m) {
  TriangleMesh mesh;
  mesh.points.emplace_back(0, 0, -radius_m);
  for (std::uint32_t row = 1; row < kSphereRows; ++row) {
    const double latitude = kPi * row / kSphereRows - kPi / 2;
    for (std::uint32_t k = 0; k < kAround; ++k) {
      mesh.points.emplace_back(
          radius_m * (std::cos(latitude) * directionAround(k) + std::sin(latitude) * Eigen::Vector3d::UnitZ()));
    }
  }
  const auto top = static_cast<std::uint32_t>(mesh.points.size());
  mesh.points.emplace_back(0, 0, radius_m);

  const auto corner = [](std::uint32_t row, std::uint32_t k) { return 1 + (row - 1) * kAround + k % kAround; };
  for (std::uint32_t k = 0; k < kAround; ++k) {
    mesh.triangles.push_back({0, corner(1, k + 1), corner(1, k)});
    for (std::uint32_t row = 1; row + 1 < kSphereRows; ++row) {
      mesh.triangles.push_back({corner(row, k), corner(row, k + 1), corner(row + 1, k)});
      mesh.triangles.push_back({corner(row, k + 1), corner(row + 1, k + 1), corner(row + 1, k)});
    }
    mesh.triangles.push_back({corner(kSphereRows - 1, k), corner(kSphereRows - 1, k + 1), top});
  }
  return mesh;
}

}  // namespace hexoderm
