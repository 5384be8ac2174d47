#pragma once

// The nearest points of a mesh, for surfaces that are triangles and for what lies on them.

#include "hexoderm/base/triangle_mesh.h"

#include <memory>

namespace hexoderm {

/// The point of a mesh that is nearest to another one, with what the surface does there.
struct MeshFoot {
  Eigen::Vector3d position = Eigen::Vector3d::Zero();
  Eigen::Vector3d normal = Eigen::Vector3d::UnitZ();  ///< smooth, unit
  /// By how much the smooth normal turns, dn = W dx, 1/m, where the foot moves within its triangle.
  Eigen::Matrix3d W = Eigen::Matrix3d::Zero();
};

/// Nearest points of a mesh, looked up in a tree of its triangles' boxes (Boost.Geometry's R*-tree).
///
/// Normals are smooth where the body is: within a triangle they go over from corner to corner, and at a corner they are
/// the mean of the triangles that meet there, weighted by their angles, but for those that meet at more than 40
/// degrees, which is an edge.
class MeshFeet {
 public:
  /// Triangles without an area are left out.
  explicit MeshFeet(const TriangleMesh& mesh);
  ~MeshFeet();
  MeshFeet(MeshFeet&&) noexcept;
  MeshFeet& operator=(MeshFeet&&) noexcept;

  /// No triangle has an area, and nothing has a foot.
  [[nodiscard]] bool empty() const;
  /// Undefined for an empty mesh.
  [[nodiscard]] MeshFoot footOf(const Eigen::Vector3d& x) const;

 private:
  struct State;
  std::unique_ptr<const State> state_;
};

}  // namespace hexoderm
