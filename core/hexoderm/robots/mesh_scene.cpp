#include "hexoderm/robots/mesh_scene.h"

#include <map>

namespace hexoderm {
namespace {

void addPlaced(MeshBuilder& mesh, const TriangleMesh& part, const Eigen::Affine3d& T_file_part) {
  const bool is_mirrored = T_file_part.linear().determinant() < 0;
  for (const auto& [a, b, c] : part.triangles) {
    mesh.add(T_file_part * part.points[a], T_file_part * part.points[is_mirrored ? c : b],
             T_file_part * part.points[is_mirrored ? b : c]);
  }
}

}  // namespace

void failTooManyNodes(const MeshBuilder& mesh) {
  mesh.fail(message("has more than {} nodes, or nodes that contain themselves", kMaxMeshNodes));
}

void addScene(MeshBuilder& mesh, const std::vector<MeshNode>& nodes, const std::vector<std::size_t>& roots,
              const ReadMeshPart& read_part) {
  struct Visit {
    std::size_t node;
    Eigen::Affine3d T_file_parent;
  };
  std::vector<Visit> ahead;
  std::size_t visits = 0;
  // A circle ends here, too.
  const auto count = [&](std::size_t more) {
    visits += more;
    if (visits > kMaxMeshNodes) failTooManyNodes(mesh);
  };
  const auto visitLater = [&](const std::vector<std::size_t>& children, const Eigen::Affine3d& T_file_parent) {
    count(children.size());
    for (auto child = children.rbegin(); child != children.rend(); ++child) ahead.push_back({*child, T_file_parent});
  };
  std::map<std::size_t, TriangleMesh> parts;
  visitLater(roots, Eigen::Affine3d::Identity());
  while (!ahead.empty()) {
    const auto [index, T_file_parent] = ahead.back();
    ahead.pop_back();
    const MeshNode& node = nodes[index];
    const Eigen::Affine3d T_file_node = T_file_parent * node.T_parent_node;
    count(node.parts.size());
    for (const std::size_t part : node.parts) {
      const auto [read, is_new] = parts.try_emplace(part);
      if (is_new) {
        MeshBuilder builder = mesh.forPart();
        read_part(part, builder);
        read->second = builder.take();
      }
      addPlaced(mesh, read->second, T_file_node);
    }
    visitLater(node.children, T_file_node);
  }
}

}  // namespace hexoderm
