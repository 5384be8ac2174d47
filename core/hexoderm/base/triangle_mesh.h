#pragma once

#include "hexoderm/base/se3.h"

#include <array>
#include <cstdint>
#include <optional>
#include <vector>

namespace hexoderm {

/// A surface of triangles, in metres, in a frame that its holder names. Corners are counter-clockwise as seen from
/// outside where the mesh is a closed one; triangles of no area are possible.
struct TriangleMesh {
  std::vector<Eigen::Vector3d> points;
  std::vector<std::array<std::uint32_t, 3>> triangles;  ///< indices of points

  [[nodiscard]] bool empty() const { return triangles.empty(); }  ///< there is no triangle
};

/// The box along the axes that holds a mesh. For a mesh without points both corners are zero.
struct BoundingBox {
  Eigen::Vector3d low = Eigen::Vector3d::Zero();
  Eigen::Vector3d high = Eigen::Vector3d::Zero();
  [[nodiscard]] Eigen::Vector3d size() const { return high - low; }  ///< the lengths of its edges
};
BoundingBox boundingBox(const TriangleMesh& mesh);  ///< the smallest box that holds all points of a mesh

/// The unit normal of a triangle, to the side from which its corners are counter-clockwise; nullopt where it has no
/// area.
std::optional<Eigen::Vector3d> normalOf(const std::array<Eigen::Vector3d, 3>& corners);
bool hasArea(const TriangleMesh& mesh);  ///< any of its triangles has one

/// Maps all points by T_a_b, from frame b to frame a.
TriangleMesh transformed(TriangleMesh mesh, const SE3& T_a_b);
/// Adds the triangles of another mesh in the same frame.
void append(TriangleMesh& mesh, const TriangleMesh& other);

/// Volume inside a closed mesh by the divergence theorem; negative where it is inside out.
double enclosedVolume(const TriangleMesh& mesh);
/// Whether the triangles of a closed mesh are clockwise as seen from outside. A body that is open somewhere encloses
/// nothing for certain; one inside out is clearly negative.
bool isInsideOut(const TriangleMesh& mesh);
/// Turns every triangle round.
void turnInsideOut(TriangleMesh& mesh);

/// A box about the origin. Sizes are above 0, m.
TriangleMesh meshOfBox(const Eigen::Vector3d& size_m);
/// A cylinder about the origin along z. Its corners lie on the cylinder: 48 around, off by 0.2 % of the radius in
/// between.
TriangleMesh meshOfCylinder(double radius_m, double length_m);
/// A sphere about the origin, 48 corners around and 24 rows.
TriangleMesh meshOfSphere(double radius_m);

}  // namespace hexoderm
