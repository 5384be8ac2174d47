#include "tests/core/kinematics/mesh/mesh_test.h"
#include "tests/support/temporary_folder.h"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

namespace hexoderm {
namespace {

using test::areaOf;
using test::littleEndian;
using test::refusalOf;
using test::saysAll;
using test::TemporaryFolder;
using Json = nlohmann::json;

/// Four corners of a square of side 1 as floats (48 bytes), two triangles as 16 bits (12 bytes) and as bytes (6).
std::string squareBytes() {
  std::string bytes;
  for (const float value : {0.F, 0.F, 0.F, 1.F, 0.F, 0.F, 1.F, 1.F, 0.F, 0.F, 1.F, 0.F}) bytes += littleEndian(value);
  for (const int value : {0, 1, 2, 0, 2, 3}) bytes += littleEndian(static_cast<std::uint16_t>(value));
  return bytes + std::string("\0\1\2\0\2\3", 6);
}
constexpr auto kSquareInBase64 =
    "AAAAAAAAAAAAAAAAAACAPwAAAAAAAAAAAACAPwAAgD8AAAAAAAAAAAAAgD8AAAAAAAABAAIAAAACAAMAAAECAAID";

/// The square as a document whose buffer has no place yet.
Json square() {
  return Json::parse(R"({"asset": {"version": "2.0"}, "scene": 0, "scenes": [{"nodes": [0]}], "nodes": [{"mesh": 0}],
    "meshes": [{"primitives": [{"attributes": {"POSITION": 0}, "indices": 1}]}],
    "accessors": [{"bufferView": 0, "componentType": 5126, "count": 4, "type": "VEC3"},
                  {"bufferView": 1, "componentType": 5123, "count": 6, "type": "SCALAR"},
                  {"bufferView": 1, "byteOffset": 12, "componentType": 5121, "count": 6, "type": "SCALAR"}],
    "bufferViews": [{"buffer": 0, "byteLength": 48}, {"buffer": 0, "byteOffset": 48, "byteLength": 18}],
    "buffers": [{"byteLength": 66}]})");
}

std::string chunk(const std::string& kind, std::string content) {
  content.resize((content.size() + 3) / 4 * 4, ' ');
  return littleEndian(static_cast<std::uint32_t>(content.size())) + kind + content;
}
std::string glb(const Json& json, const std::string& binary = squareBytes()) {
  const std::string chunks = chunk("JSON", json.dump()) + chunk(std::string("BIN\0", 4), binary);
  return "glTF" + littleEndian(2U) + littleEndian(static_cast<std::uint32_t>(12 + chunks.size())) + chunks;
}
/// The square after a change by RFC 6902.
Json changed(const char* patch) { return square().patch(Json::parse(patch)); }
std::string refusalAfter(const char* patch) { return refusalOf("m.glb", glb(changed(patch))); }

void expectSquare(const TriangleMesh& mesh, const std::string& what) {
  EXPECT_EQ(mesh.triangles.size(), 2U) << what;
  EXPECT_EQ(mesh.points.size(), 4U) << what;
  EXPECT_DOUBLE_EQ(areaOf(mesh), 1) << what;
}

TEST(Gltf, ReadsBuffersOfABinaryFileOfDataAndOfAFileBesideIt) {
  expectSquare(readMesh(glb(square()), "m"), "binary");
  Json json = square();
  json["buffers"][0]["uri"] = std::string("data:application/octet-stream;base64,") + kSquareInBase64;
  expectSquare(readMesh(json.dump(), "m"), "data");
  const TemporaryFolder folder;
  std::filesystem::create_directory(folder.path() / "in it");
  folder.put("in it/m.bin", squareBytes());
  json["buffers"][0]["uri"] = "in%20it/m.bin";
  expectSquare(readMeshFile(folder.put("m.gltf", " \n" + json.dump())), "a file");
}

TEST(Gltf, ReadsAllKindsOfTriangles) {
  expectSquare(
      readMesh(glb(changed(R"([{"op": "replace", "path": "/meshes/0/primitives/0/indices", "value": 2}])")), "m"),
      "bytes");
  expectSquare(readMesh(glb(changed(R"([{"op": "remove", "path": "/meshes/0/primitives/0/indices"},
                                        {"op": "add", "path": "/meshes/0/primitives/0/mode", "value": 6}])")),
                        "m"),
               "fan");
  const TriangleMesh strip = readMesh(glb(changed(R"([{"op": "remove", "path": "/meshes/0/primitives/0/indices"},
                                        {"op": "add", "path": "/meshes/0/primitives/0/mode", "value": 5}])")),
                                      "m");
  EXPECT_EQ(strip.triangles.size(), 2U);
  EXPECT_THAT(refusalAfter(R"([{"op": "add", "path": "/meshes/0/primitives/0/mode", "value": 1}])"),
              saysAll("triangles"));
}

TEST(Gltf, PlacesNodes) {
  const auto box = [](const char* node) {
    Json json = square();
    json["nodes"] = {Json::parse(node), {{"mesh", 0}}};
    return boundingBox(readMesh(glb(json), "m"));
  };
  EXPECT_EQ(box(R"({"mesh": 0, "translation": [1, 2, 3], "scale": [2, 1, 1]})").high, Eigen::Vector3d(3, 3, 3));
  EXPECT_EQ(box(R"({"children": [1], "matrix": [1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 7, 8, 9, 1]})").low,
            Eigen::Vector3d(7, 8, 9));
  EXPECT_LT((box(R"({"mesh": 0, "rotation": [0, 0, 0.70710678118654757, 0.70710678118654757]})").low -
             Eigen::Vector3d(-1, 0, 0))
                .norm(),
            1e-12);
}

TEST(Gltf, ReadsQuantizedPositions) {
  const Json json = changed(R"([{"op": "add", "path": "/extensionsRequired", "value": ["KHR_mesh_quantization"]},
      {"op": "replace", "path": "/accessors/0", "value": {"bufferView": 0, "componentType": 5120, "count": 3, "type": "VEC3", "normalized": true}},
      {"op": "add", "path": "/bufferViews/0/byteStride", "value": 4},
      {"op": "remove", "path": "/meshes/0/primitives/0/indices"}])");
  const TriangleMesh mesh = readMesh(glb(json, std::string("\0\0\0_\x7F\0\0_\0\x80\0_", 12) + squareBytes()), "m");
  ASSERT_EQ(mesh.points.size(), 3U);
  EXPECT_EQ(mesh.points[1], Eigen::Vector3d(1, 0, 0));
  EXPECT_EQ(mesh.points[2], Eigen::Vector3d(0, -1, 0));
}

TEST(Gltf, RefusesByNameWhatIsNotRead) {
  EXPECT_THAT(
      refusalAfter(R"([{"op": "add", "path": "/extensionsRequired", "value": ["KHR_draco_mesh_compression"]}])"),
      saysAll("m.glb", "KHR_draco_mesh_compression"));
  EXPECT_THAT(
      refusalAfter(
          R"([{"op": "add", "path": "/meshes/0/primitives/0/extensions", "value": {"KHR_draco_mesh_compression": {}}}])"),
      saysAll("KHR_draco_mesh_compression"));
  EXPECT_THAT(refusalAfter(R"([{"op": "add", "path": "/accessors/0/sparse", "value": {}}])"),
              saysAll("accessors[0].sparse"));
  EXPECT_THAT(refusalAfter(R"([{"op": "replace", "path": "/asset/version", "value": "1.0"}])"), saysAll("1.0"));
  EXPECT_THAT(refusalAfter(R"([{"op": "remove", "path": "/scenes"}])"), saysAll("scene"));
}

TEST(Gltf, RefusesAccessorsThatReachBeyondTheirBytes) {
  for (const char* patch : {R"([{"op": "replace", "path": "/accessors/0/count", "value": 5}])",
                            R"([{"op": "replace", "path": "/accessors/0/count", "value": 4294967295}])",
                            R"([{"op": "add", "path": "/accessors/0/byteOffset", "value": 4294967295}])",
                            R"([{"op": "add", "path": "/bufferViews/0/byteStride", "value": 4294967295}])",
                            R"([{"op": "replace", "path": "/bufferViews/0/byteLength", "value": 4294967295}])",
                            R"([{"op": "replace", "path": "/bufferViews/1/byteOffset", "value": 60}])"}) {
    EXPECT_THAT(refusalAfter(patch), saysAll("truncated")) << patch;
  }
  EXPECT_THAT(refusalAfter(R"([{"op": "replace", "path": "/accessors/0/count", "value": 3}])"),
              saysAll("indices below 3"));
  EXPECT_THAT(refusalAfter(R"([{"op": "add", "path": "/bufferViews/0/byteStride", "value": 1}])"),
              saysAll("byteStride"));
  EXPECT_THAT(refusalAfter(R"([{"op": "remove", "path": "/accessors/0/bufferView"}])"),
              saysAll("accessors[0].bufferView"));
  EXPECT_THAT(refusalAfter(R"([{"op": "replace", "path": "/accessors/0/count", "value": -1}])"),
              saysAll("accessors[0].count"));
  EXPECT_THAT(refusalAfter(R"([{"op": "replace", "path": "/accessors/0/type", "value": "VEC2"}])"),
              saysAll("VEC3", "VEC2"));
  EXPECT_THAT(refusalAfter(R"([{"op": "replace", "path": "/accessors/0/componentType", "value": 5124}])"),
              saysAll("5124"));
}

TEST(Gltf, RefusesIndicesOfNothing) {
  for (const char* patch : {R"([{"op": "replace", "path": "/scene", "value": 1}])",
                            R"([{"op": "replace", "path": "/scenes/0/nodes", "value": [1]}])",
                            R"([{"op": "add", "path": "/nodes/0/children", "value": [7]}])",
                            R"([{"op": "replace", "path": "/nodes/0/mesh", "value": 1}])",
                            R"([{"op": "replace", "path": "/meshes/0/primitives/0/indices", "value": 3}])",
                            R"([{"op": "replace", "path": "/accessors/0/bufferView", "value": 2}])",
                            R"([{"op": "replace", "path": "/bufferViews/0/buffer", "value": 1}])"}) {
    EXPECT_THAT(refusalAfter(patch), saysAll("m.glb", "an index below")) << patch;
  }
}

TEST(Gltf, RefusesNodesThatContainThemselves) {
  EXPECT_THAT(refusalAfter(R"([{"op": "replace", "path": "/nodes/0", "value": {"children": [0, 0]}}])"),
              saysAll("contain themselves"));
}

TEST(Gltf, RefusesBuffersThatAreNoFileFromItsFolder) {
  const TemporaryFolder folder;
  const auto complaint = [&](const std::string& uri) {
    Json json = square();
    json["buffers"][0]["uri"] = uri;
    const auto file = folder.put("m.gltf", json.dump());
    return test::messageOf<Error>([&] { readMeshFile(file); });
  };
  for (const char* uri : {"/dev/zero", "file:///etc/passwd", "https://example.org/m.bin", "", "data:;base64,A*",
                          "data:AAAA", "m.bin%00", "m%00.bin"}) {
    EXPECT_THAT(complaint(uri), saysAll("m.gltf", "buffers[0].uri")) << uri;
  }
  EXPECT_THAT(complaint("none.bin"), saysAll("m.gltf", "none.bin", "no such"));
  EXPECT_THAT(complaint("../../../../../../dev/zero"), saysAll("dev/zero", "none"));
  EXPECT_THAT(complaint("."), saysAll("none"));
  EXPECT_THAT(complaint(std::string("data:;base64,") + std::string(kSquareInBase64).substr(0, 80)),
              saysAll("truncated"));
  folder.put("large.bin", "");
  std::filesystem::resize_file(folder.path() / "large.bin", 4'000'000'000);
  EXPECT_THAT(complaint("large.bin"), saysAll("large.bin", "too large"));
}

TEST(Gltf, RefusesABinaryFileThatIsCutOffAnywhere) {
  const std::string bytes = glb(square());
  for (std::size_t size = 4; size < bytes.size(); ++size) {
    EXPECT_THROW(readMesh(bytes.substr(0, size), "m"), FormatError) << size;
  }
  EXPECT_THAT(refusalOf("m", "glTF" + littleEndian(1U) + bytes.substr(8)), saysAll("version 2"));
}

}  // namespace
}  // namespace hexoderm
