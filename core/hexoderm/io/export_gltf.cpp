#include "hexoderm/io/export_formats.h"

#include "hexoderm/io/export_selection.h"
#include "hexoderm/solve/metrics/patch_mesh.h"

#include <bit>
#include <cmath>
#include <nlohmann/json.hpp>

namespace hexoderm {
namespace {

using Json = nlohmann::ordered_json;

static_assert(std::endian::native == std::endian::little, "glTF is little-endian and takes bytes as they are");

constexpr const char* kRootNode = "skin";
constexpr std::uint32_t kFloat = 5126;
constexpr std::uint32_t kTriangles = 4;
constexpr std::uint32_t kArrayBuffer = 34962;

/// z of the skin's frame becomes +Y of glTF.
Eigen::Matrix3d upright() { return expSO3(-0.5 * std::acos(-1.0) * Eigen::Vector3d::UnitX()); }

std::string cellNode(CellId cell) { return "cell_" + toString(cell); }

/// The triangles of a cell in its own frame, each with corners and a normal of its own.
struct CellTriangles {
  std::vector<Eigen::Vector3f> points;
  std::vector<Eigen::Vector3f> normals;
};

CellTriangles cellTriangles(const CellModel& model) {
  Reconstruction one;
  one.model = std::make_shared<const CellModel>(model);
  PatchReconstruction& patch = one.patches.emplace_back();
  patch.cells.emplace_back();
  const PatchMesh mesh = makePatchMesh(one);
  CellTriangles triangles;
  for (const auto& corners : triangulate(mesh)) {
    const Eigen::Vector3d& a = mesh.points[corners[0]];
    const Eigen::Vector3d normal = (mesh.points[corners[1]] - a).cross(mesh.points[corners[2]] - a).normalized();
    for (const std::uint32_t corner : corners) {
      triangles.points.emplace_back(mesh.points[corner].cast<float>());
      triangles.normals.emplace_back(normal.cast<float>());
    }
  }
  return triangles;
}

void appendFloats(std::string& bytes, const std::vector<Eigen::Vector3f>& vectors) {
  for (const Eigen::Vector3f& v : vectors) bytes.append(reinterpret_cast<const char*>(v.data()), 3 * sizeof(float));
}

Json bounds(const std::vector<Eigen::Vector3f>& points, bool largest) {
  Eigen::Vector3f bound = points.front();
  for (const Eigen::Vector3f& point : points)
    bound = largest ? bound.cwiseMax(point).eval() : bound.cwiseMin(point).eval();
  return {bound.x(), bound.y(), bound.z()};
}

void appendWord(std::string& bytes, std::uint32_t word) {
  bytes.append(reinterpret_cast<const char*>(&word), sizeof(word));
}

void appendChunk(std::string& bytes, std::uint32_t type, std::string content, char padding) {
  content.resize((content.size() + 3) / 4 * 4, padding);
  appendWord(bytes, static_cast<std::uint32_t>(content.size()));
  appendWord(bytes, type);
  bytes += content;
}

Json node(const std::string& name, const SE3& T) {
  const Eigen::Quaterniond q = quaternionOf(T.R);
  return {{"name", name},
          {"translation", {T.t.x() + 0.0, T.t.y() + 0.0, T.t.z() + 0.0}},
          {"rotation", {q.x(), q.y(), q.z(), q.w()}}};
}

/// Linear, as glTF has colours; the skin's are those of a screen.
double linear(std::uint32_t byte) {
  const double c = byte / 255.0;
  return c <= 0.04045 ? c / 12.92 : std::pow((c + 0.055) / 1.055, 2.4);
}

}  // namespace

std::string gltfBytes(const Reconstruction& reconstruction, const std::string& frame) {
  const CellTriangles triangles = cellTriangles(*reconstruction.model);
  std::string binary;
  appendFloats(binary, triangles.points);
  const std::size_t normals_at = binary.size();
  appendFloats(binary, triangles.normals);

  Json document = {{"asset", {{"version", "2.0"}, {"generator", "Hexoderm"}}}, {"scene", 0}};
  Json root_nodes = Json::array();
  root_nodes.push_back(0);
  document["scenes"] = Json::array();
  document["scenes"].push_back({{"nodes", root_nodes}});
  const auto material_list = skinMaterials();
  Json materials = Json::array();
  Json meshes = Json::array();
  for (std::size_t k = 0; k < material_list.size(); ++k) {
    Json color = Json::array();
    for (const unsigned shift : {16U, 8U, 0U}) color.push_back(linear((material_list[k].rgb >> shift) & 0xFFU));
    color.push_back(1.0);
    materials.push_back(
        {{"name", material_list[k].name},
         {"pbrMetallicRoughness", {{"baseColorFactor", color}, {"metallicFactor", 0.0}, {"roughnessFactor", 0.8}}}});
    Json primitive = {{"attributes", {{"POSITION", 0}, {"NORMAL", 1}}}, {"material", k}, {"mode", kTriangles}};
    meshes.push_back({{"name", material_list[k].name}, {"primitives", Json::array({primitive})}});
  }

  const Eigen::Quaterniond up = quaternionOf(upright());
  Json nodes = Json::array();
  nodes.push_back({{"name", kRootNode},
                   {"rotation", {up.x(), up.y(), up.z(), up.w()}},
                   {"extras", {{"frame", frame}, {"unit", "m"}}}});
  Json children = Json::array();
  const auto quality = worstUsedQuality(reconstruction);
  for (const PatchReconstruction& patch : reconstruction.patches) {
    for (const CellPlacement& cell : patch.cells) {
      const SE3 T_o_u = rigid(cell.T_o_u);
      const SE3 T_u_o = T_o_u.inverse();
      Json added = node(cellNode(cell.cell), T_o_u);
      const auto found = quality.find(cell.cell);
      added["mesh"] = found == quality.end() ? material_list.size() - 1 : static_cast<std::size_t>(found->second);
      const std::size_t index = nodes.size();
      children.push_back(index);
      nodes.push_back(added);
      Json sensors = Json::array();
      for (std::size_t k = 0; k < cell.sensors.size(); ++k) {
        sensors.push_back(nodes.size());
        Json sensor =
            node(cellNode(cell.cell) + "_sensor_" + std::to_string(k + 1), T_u_o * rigid(cell.sensors[k].T_o_s));
        sensor["extras"] = {{"sensor", cell.sensors[k].name}, {"type", cell.sensors[k].type}};
        nodes.push_back(sensor);
      }
      if (!sensors.empty()) nodes[index]["children"] = sensors;
    }
  }
  if (!children.empty()) nodes[0]["children"] = children;
  document["nodes"] = nodes;
  document["meshes"] = meshes;
  document["materials"] = materials;
  const auto vertices = triangles.points.size();
  document["accessors"] =
      Json::array({{{"bufferView", 0},
                    {"componentType", kFloat},
                    {"count", vertices},
                    {"type", "VEC3"},
                    {"min", bounds(triangles.points, false)},
                    {"max", bounds(triangles.points, true)}},
                   {{"bufferView", 1}, {"componentType", kFloat}, {"count", vertices}, {"type", "VEC3"}}});
  const auto view = [](std::size_t offset, std::size_t length) {
    return Json{{"buffer", 0}, {"byteOffset", offset}, {"byteLength", length}, {"target", kArrayBuffer}};
  };
  document["bufferViews"] = Json::array({view(0, normals_at), view(normals_at, binary.size() - normals_at)});
  document["buffers"] = Json::array();
  document["buffers"].push_back({{"byteLength", binary.size()}});

  std::string chunks;
  appendChunk(chunks, 0x4E4F534A, document.dump(-1, ' ', false, Json::error_handler_t::replace), ' ');  // "JSON"
  appendChunk(chunks, 0x004E4942, binary, '\0');                                                        // "BIN"
  constexpr std::uint32_t kHeader = 12;
  std::string bytes = "glTF";
  appendWord(bytes, 2);
  appendWord(bytes, static_cast<std::uint32_t>(kHeader + chunks.size()));
  return bytes + chunks;
}

}  // namespace hexoderm
