#pragma once

#include "hexoderm/robots/mesh_builder.h"

#include <Eigen/Geometry>
#include <cstddef>
#include <functional>
#include <vector>

namespace hexoderm {

/// A node of a COLLADA or glTF scene: where it is in its parent, and the indices of the nodes and meshes in it. Files
/// may use a node several times, and hostile ones within itself.
struct MeshNode {
  Eigen::Affine3d T_parent_node = Eigen::Affine3d::Identity();
  std::vector<std::size_t> children;
  std::vector<std::size_t> parts;
};

/// The most nodes of a scene, counted as often as they are used.
inline constexpr std::size_t kMaxMeshNodes = 100'000;
[[noreturn]] void failTooManyNodes(const MeshBuilder& mesh);

/// Adds the triangles of a part to a builder.
using ReadMeshPart = std::function<void(std::size_t part, MeshBuilder& mesh)>;

/// Adds all parts below the roots, each where its nodes place it. `read_part` is called once for each part that is
/// used. A part that is mirrored keeps its outside. Children are indices of `nodes`.
void addScene(MeshBuilder& mesh, const std::vector<MeshNode>& nodes, const std::vector<std::size_t>& roots,
              const ReadMeshPart& read_part);

}  // namespace hexoderm
