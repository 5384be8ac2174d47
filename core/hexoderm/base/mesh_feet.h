#pragma once

// The nearest points of a mesh, and the surface of a body that is given as one.

#include "hexoderm/base/surface.h"
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

/// The surface of a body given as triangles, or the one that lies `height_m` above it, which is where the front faces
/// of cells of that thickness are. All coordinates are in the mesh's frame.
///
/// Normals are smooth where the body is: within a triangle they go over from corner to corner, and at a corner they are
/// the mean of the triangles that meet there, weighted by their angles, but for those that meet at more than 40
/// degrees, which is an edge. Curvatures are those of the normals, over 4 mm to either side. Ways along the surface are
/// followed in steps of 2 mm.
class MeshSurface final : public Surface {
 public:
  /// `T_b_near`: the middle of a patch is laid at the surface's nearest point to its origin, with x as near to its x as
  /// the surface allows. Throws InvalidArgument for a mesh without triangles that have an area, a height that is not
  /// finite or negative, and where the x axis stands on the surface.
  MeshSurface(TriangleMesh mesh, const SE3& T_b_near, double height_m = 0);
  ~MeshSurface() override;

  [[nodiscard]] SE3 middle() const override;
  [[nodiscard]] Eigen::Vector3d project(const Eigen::Vector3d& x) const override;
  [[nodiscard]] Eigen::Vector3d normal(const Eigen::Vector3d& x) const override;
  [[nodiscard]] Eigen::Matrix3d weingarten(const Eigen::Vector3d& x) const override;
  [[nodiscard]] GeodesicPoint walk(const Eigen::Vector3d& from, const Eigen::Vector3d& direction,
                                   double length_m) const override;
  [[nodiscard]] Eigen::Vector3d bearing(const Eigen::Vector3d& from, const Eigen::Vector3d& to) const override;

 private:
  struct State;
  std::unique_ptr<const State> state_;
};

}  // namespace hexoderm
