#include "hexoderm/kinematics/mesh_file.h"

#include "hexoderm/util/error.h"
#include "hexoderm/util/file.h"
#include "hexoderm/util/kept_files.h"
#include "hexoderm/util/limits.h"
#include "hexoderm/util/system_reason.h"
#include "hexoderm/util/text.h"

#include <assimp/config.h>
#include <assimp/postprocess.h>
#include <assimp/scene.h>

#include <assimp/Importer.hpp>
#include <system_error>

namespace hexoderm {
namespace {

constexpr std::size_t kMostTriangles = 10'000'000;
/// Nodes deeper than any mesh file's: they are visited recursively.
constexpr int kDeepestNode = 500;

[[noreturn]] void failMesh(const std::filesystem::path& file, Message why) {
  throw FormatError(located(file.string(), std::move(why)));
}

/// That there is something to read, and not too much: Assimp opens the file itself, because formats such as glTF refer
/// to other files beside them.
void requireReadable(const std::filesystem::path& file) {
  noteRead(file);
  std::error_code error;
  const auto status = std::filesystem::status(file, error);
  if (status.type() == std::filesystem::file_type::not_found) {
    throw StorageError(located(file.string(), message("there is no such mesh file")));
  }
  if (error) throw StorageError(located(file.string(), message("cannot be read: {}", systemReason(error))));
  if (status.type() != std::filesystem::file_type::regular) {
    throw StorageError(located(file.string(), message("expected a mesh file, but this is none")));
  }
  const std::uintmax_t size = std::filesystem::file_size(file, error);
  if (error) throw StorageError(located(file.string(), message("cannot be read: {}", systemReason(error))));
  if (size > kMostFileBytes) {
    failMesh(file, message("is too large: at most {} MB of a mesh are read", kMostFileBytes / 1'000'000));
  }
}

class MeshCollector {
 public:
  MeshCollector(const aiScene& scene, const std::filesystem::path& file) : scene_(scene), file_(file) {}

  TriangleMesh collect() {
    if (scene_.mRootNode != nullptr) visit(*scene_.mRootNode, aiMatrix4x4(), 0);
    if (mesh_.empty()) failMesh(file_, message("expected a mesh of triangles, but it has none"));
    return std::move(mesh_);
  }

 private:
  void visit(const aiNode& node, const aiMatrix4x4& T_file_parent, int depth) {
    if (depth > kDeepestNode) failMesh(file_, message("nests its parts too deeply"));
    const aiMatrix4x4 T_file_node = T_file_parent * node.mTransformation;
    for (unsigned k = 0; k < node.mNumMeshes; ++k) add(*scene_.mMeshes[node.mMeshes[k]], T_file_node);
    for (unsigned k = 0; k < node.mNumChildren; ++k) visit(*node.mChildren[k], T_file_node, depth + 1);
  }

  void add(const aiMesh& mesh, const aiMatrix4x4& T_file_node) {
    if (mesh_.triangles.size() + mesh.mNumFaces > kMostTriangles) {
      failMesh(file_, message("has more than {} triangles", kMostTriangles));
    }
    const auto first = static_cast<std::uint32_t>(mesh_.points.size());
    for (unsigned k = 0; k < mesh.mNumVertices; ++k) {
      const aiVector3D point = T_file_node * mesh.mVertices[k];
      mesh_.points.emplace_back(point.x, point.y, point.z);
      if (!isWithin(mesh_.points.back(), kMostLength_m)) {
        failMesh(file_,
                 message("point {} is not finite or farther than {} from its origin", k, Number{kMostLength_m, 0}));
      }
    }
    for (unsigned k = 0; k < mesh.mNumFaces; ++k) {
      const aiFace& face = mesh.mFaces[k];
      if (face.mNumIndices != 3) continue;  // points and lines
      mesh_.triangles.push_back({first + face.mIndices[0], first + face.mIndices[1], first + face.mIndices[2]});
    }
  }

  const aiScene& scene_;
  const std::filesystem::path& file_;
  TriangleMesh mesh_;
};

}  // namespace

TriangleMesh readMeshFile(const std::filesystem::path& file) {
  requireReadable(file);
  Assimp::Importer importer;
  // Assimp would turn Collada files until y points up; robot software does not.
  importer.SetPropertyBool(AI_CONFIG_IMPORT_COLLADA_IGNORE_UP_DIRECTION, true);
  // Normals, colours and textures would keep corners apart that are one point.
  importer.SetPropertyInteger(AI_CONFIG_PP_RVC_FLAGS, aiComponent_NORMALS | aiComponent_TANGENTS_AND_BITANGENTS |
                                                          aiComponent_COLORS | aiComponent_TEXCOORDS |
                                                          aiComponent_TEXTURES | aiComponent_MATERIALS);
  const aiScene* scene = importer.ReadFile(
      file.string(), aiProcess_RemoveComponent | aiProcess_Triangulate | aiProcess_JoinIdenticalVertices);
  if (scene == nullptr) {
    failMesh(file, message("this is no mesh that can be read: {}", shortened(importer.GetErrorString(), 300)));
  }
  return MeshCollector(*scene, file).collect();
}

}  // namespace hexoderm
