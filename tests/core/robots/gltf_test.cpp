#include "tests/core/robots/mesh_test.h"
#include "tests/support/temporary_folder.h"

#include <nlohmann/json.hpp>

namespace hexoderm {
namespace {

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
/// The square with other values at these places; null takes away what is there.
using Changes = std::map<std::string, Json>;
Json changed(const Changes& changes) {
  Json json = square();
  for (const auto& [place, value] : changes) {
    const Json::json_pointer at(place);
    if (value.is_null()) {
      json.at(at.parent_pointer()).erase(at.back());
    } else {
      json[at] = value;
    }
  }
  return json;
}
std::string refusalAfter(const std::string& place, const Json& value) {
  return refusalOf("m.glb", glb(changed({{place, value}})));
}

void expectSquare(const TriangleMesh& mesh, const std::string& what) {
  EXPECT_EQ(mesh.triangles.size(), 2U) << what;
  EXPECT_EQ(mesh.points.size(), 4U) << what;
  EXPECT_DOUBLE_EQ(areaOf(mesh), 1) << what;
}

TEST(Gltf, ReadsAllKindsOfTriangles) {
  const std::string of_indices = "/meshes/0/primitives/0/indices";
  const std::string of_mode = "/meshes/0/primitives/0/mode";
  expectSquare(readMesh(glb(changed({{of_indices, 2}})), "m"), "bytes");
  expectSquare(readMesh(glb(changed({{of_indices, nullptr}, {of_mode, 6}})), "m"), "fan");
  EXPECT_EQ(readMesh(glb(changed({{of_indices, nullptr}, {of_mode, 5}})), "m").triangles.size(), 2U) << "strip";
  EXPECT_THAT(refusalAfter(of_mode, 1), saysAll("triangles"));
}

TEST(Gltf, ReadsQuantizedPositions) {
  const Json json = changed({{"/extensionsRequired", Json::parse(R"(["KHR_mesh_quantization"])")},
                             {"/accessors/0", Json::parse(R"({"bufferView": 0, "componentType": 5120, "count": 3,
                                                              "type": "VEC3", "normalized": true})")},
                             {"/bufferViews/0/byteStride", 4},
                             {"/meshes/0/primitives/0/indices", nullptr}});
  const TriangleMesh mesh = readMesh(glb(json, std::string("\0\0\0_\x7F\0\0_\0\x80\0_", 12) + squareBytes()), "m");
  ASSERT_EQ(mesh.points.size(), 3U);
  EXPECT_EQ(mesh.points[1], Eigen::Vector3d(1, 0, 0));
  EXPECT_EQ(mesh.points[2], Eigen::Vector3d(0, -1, 0));
}

TEST(Gltf, RefusesByNameWhatIsNotRead) {
  EXPECT_THAT(refusalAfter("/extensionsRequired", Json::parse(R"(["KHR_draco_mesh_compression"])")),
              saysAll("m.glb", "KHR_draco_mesh_compression"));
  EXPECT_THAT(refusalAfter("/meshes/0/primitives/0/extensions/KHR_draco_mesh_compression", Json::object()),
              saysAll("KHR_draco_mesh_compression"));
  EXPECT_THAT(refusalAfter("/accessors/0/sparse", Json::object()), saysAll("accessors[0].sparse"));
  EXPECT_THAT(refusalAfter("/asset/version", "1.0"), saysAll("1.0"));
  EXPECT_THAT(refusalAfter("/scenes", nullptr), saysAll("scene"));
}

TEST(Gltf, RefusesAccessorsThatReachBeyondTheirBytes) {
  for (const auto& [place, value] :
       {std::pair("/accessors/0/count", 5U), std::pair("/accessors/0/count", 4294967295U),
        std::pair("/accessors/0/byteOffset", 4294967295U), std::pair("/bufferViews/0/byteStride", 4294967295U),
        std::pair("/bufferViews/0/byteLength", 4294967295U), std::pair("/bufferViews/1/byteOffset", 60U)}) {
    EXPECT_THAT(refusalAfter(place, value), saysAll("truncated")) << place << " = " << value;
  }
  EXPECT_THAT(refusalAfter("/accessors/0/count", 3), saysAll("indices below 3"));
  EXPECT_THAT(refusalAfter("/bufferViews/0/byteStride", 1), saysAll("byteStride"));
  EXPECT_THAT(refusalAfter("/accessors/0/bufferView", nullptr), saysAll("accessors[0].bufferView"));
  EXPECT_THAT(refusalAfter("/accessors/0/count", -1), saysAll("accessors[0].count"));
  EXPECT_THAT(refusalAfter("/accessors/0/type", "VEC2"), saysAll("VEC3", "VEC2"));
  EXPECT_THAT(refusalAfter("/accessors/0/componentType", 5124), saysAll("5124"));
}

TEST(Gltf, RefusesIndicesOfNothing) {
  for (const auto& [place, value] :
       {std::pair("/scene", 1), std::pair("/scenes/0/nodes/0", 1), std::pair("/nodes/0/children/0", 7),
        std::pair("/nodes/0/mesh", 1), std::pair("/meshes/0/primitives/0/indices", 3),
        std::pair("/accessors/0/bufferView", 2), std::pair("/bufferViews/0/buffer", 1)}) {
    EXPECT_THAT(refusalAfter(place, value), saysAll("m.glb", "an index below")) << place;
  }
}

TEST(Gltf, RefusesNodesThatContainThemselves) {
  EXPECT_THAT(refusalAfter("/nodes/0", Json::parse(R"({"children": [0, 0]})")), saysAll("contain themselves"));
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

TEST(Gltf, ReadsBuffersOfDataAndOfAFileBesideIt) {
  Json json = square();
  json["buffers"][0]["uri"] = std::string("data:application/octet-stream;base64,") + kSquareInBase64;
  expectSquare(readMesh(json.dump(), "m"), "data");
  const TemporaryFolder folder;
  std::filesystem::create_directory(folder.path() / "in it");
  folder.put("in it/m.bin", squareBytes());
  json["buffers"][0]["uri"] = "in%20it/m.bin";
  expectSquare(readMeshFile(folder.put("m.gltf", " \n" + json.dump())), "a file");
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
