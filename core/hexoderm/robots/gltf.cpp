#include "hexoderm/base/error.h"
#include "hexoderm/base/file.h"
#include "hexoderm/base/json_reader.h"
#include "hexoderm/base/text.h"
#include "hexoderm/robots/mesh_input.h"

#include <array>
#include <limits>
#include <map>
#include <optional>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

namespace hexoderm {
namespace {

/// A mesh takes a few hundred.
constexpr std::size_t kMaxGltfValues = 1'000'000;
/// No file system has longer ones.
constexpr std::size_t kLongestGltfPath = 4096;

template <class Component>
double readGltfNumber(MeshBytes& in, bool is_normalized) {
  const auto value = static_cast<double>(in.number<Component>());
  if (!is_normalized || std::is_floating_point_v<Component>) return value;
  return std::max(-1.0, value / static_cast<double>(std::numeric_limits<Component>::max()));
}

struct GltfType {
  std::uint32_t code;
  std::size_t size;
  double (*read)(MeshBytes&, bool is_normalized);
};
constexpr std::array<GltfType, 6> kGltfTypes = {{{5120, 1, readGltfNumber<std::int8_t>},
                                                 {5121, 1, readGltfNumber<std::uint8_t>},
                                                 {5122, 2, readGltfNumber<std::int16_t>},
                                                 {5123, 2, readGltfNumber<std::uint16_t>},
                                                 {5125, 4, readGltfNumber<std::uint32_t>},
                                                 {5126, 4, readGltfNumber<float>}}};

/// The numbers of an accessor, all of which lie in `bytes`.
struct GltfNumbers {
  std::string_view bytes;
  std::uint32_t count = 0;
  std::uint32_t stride = 0;
  const GltfType* type = nullptr;
  bool is_normalized = false;
};

/// The bytes of base64, with or without its padding; nullopt for what is none.
std::optional<std::string> bytesOfBase64(std::string_view text) {
  constexpr std::string_view kDigits = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  while (text.ends_with('=')) text.remove_suffix(1);
  std::string bytes;
  bytes.reserve(text.size() / 4 * 3);
  std::uint32_t bits = 0;
  unsigned bit_count = 0;
  for (const char c : text) {
    const std::size_t digit = kDigits.find(c);
    if (digit == std::string_view::npos) return std::nullopt;
    bits = (bits << 6U | static_cast<std::uint32_t>(digit)) & 0xFFFFU;
    bit_count += 6;
    if (bit_count < 8) continue;
    bit_count -= 8;
    bytes += static_cast<char>(bits >> bit_count & 0xFFU);
  }
  return bytes;
}

/// A URI with its characters written as %20 and the like replaced.
std::string pathOfUri(std::string_view uri) {
  std::string path;
  while (!uri.empty()) {
    constexpr std::string_view kDigits = "0123456789ABCDEFabcdef";
    const bool is_escape = uri.size() >= 3 && uri[0] == '%' && uri.substr(1, 2).find_first_not_of(kDigits) == uri.npos;
    path += is_escape ? static_cast<char>(std::stoi(std::string(uri.substr(1, 2)), nullptr, 16)) : uri[0];
    uri.remove_prefix(is_escape ? 3 : 1);
  }
  return path;
}

class GltfReader {
 public:
  /// `chunk` is the binary part of a GLB.
  GltfReader(std::string_view text, std::optional<std::string_view> chunk, const std::filesystem::path& file,
             MeshBuilder& mesh)
      : json_(parseJson(text, mesh.file(), kMaxGltfValues)),
        root_(json_),
        chunk_(chunk),
        folder_(file.parent_path()),
        mesh_(mesh) {}

  void read() {
    const std::string version = root_.at("asset").at("version").string();
    if (!version.starts_with("2.")) {
      mesh_.fail(message("expected {}, found \"{}\"", message("glTF of version 2"), excerptOf(version)));
    }
    requireExtensions();
    meshes_ = list("meshes");
    accessors_ = list("accessors");
    views_ = list("bufferViews");
    buffers_ = list("buffers");
    const std::vector<JsonReader> nodes = list("nodes");
    if (nodes.size() > kMaxMeshNodes) failTooManyNodes(mesh_);
    std::vector<MeshNode> read;
    for (const JsonReader& node : nodes) read.push_back(nodeOf(node, nodes.size()));

    const std::vector<JsonReader> scenes = list("scenes");
    if (scenes.empty()) mesh_.fail(message("expected a scene, but it has none"));
    const std::optional<JsonReader> chosen = root_.find("scene");
    addScene(mesh_, read, indices(scenes[chosen ? indexIn(scenes.size(), *chosen) : 0], "nodes", read.size()),
             [this](std::size_t mesh, MeshBuilder& part) { readMesh(meshes_[mesh], part); });
  }

 private:
  /// Of the extensions without which a file makes no sense, only those that leave its triangles as they are.
  void requireExtensions() const {
    for (const JsonReader& required : list("extensionsRequired")) {
      const std::string name = required.string();
      const auto begins = [&](const char* start) { return name.starts_with(start); };
      if (name == "KHR_mesh_quantization" || begins("KHR_materials_") || begins("KHR_texture_") ||
          begins("EXT_texture_") || begins("KHR_lights_")) {
        continue;
      }
      mesh_.fail(message("needs the extension {} of glTF, which is not read", excerptOf(name)));
    }
  }

  [[nodiscard]] std::vector<JsonReader> list(const std::string& key) const {
    const std::optional<JsonReader> found = root_.find(key);
    return found ? found->items() : std::vector<JsonReader>();
  }

  static std::size_t indexIn(std::size_t size, const JsonReader& index) {
    const std::uint32_t value = index.unsignedInteger();
    if (value >= size) index.fail(message("an index below {}", size));
    return value;
  }
  static std::vector<std::size_t> indices(const JsonReader& object, const std::string& key, std::size_t size) {
    std::vector<std::size_t> result;
    if (const auto found = object.find(key)) {
      for (const JsonReader& index : found->items()) result.push_back(indexIn(size, index));
    }
    return result;
  }
  static std::uint32_t numberOr(const JsonReader& object, const std::string& key, std::uint32_t otherwise,
                                std::uint32_t min = 0) {
    const auto found = object.find(key);
    return found ? found->unsignedInteger(min) : otherwise;
  }

  MeshNode nodeOf(const JsonReader& json, std::size_t nodes) const {
    MeshNode node;
    node.children = indices(json, "children", nodes);
    if (const auto mesh = json.find("mesh")) node.parts.push_back(indexIn(meshes_.size(), *mesh));
    if (const auto matrix = json.find("matrix")) {
      const std::array<double, 16> m = matrix->numbers<16>();
      node.T_parent_node.affine() = Eigen::Map<const Eigen::Matrix4d>(m.data()).topRows<3>();
    }
    if (const auto translation = json.find("translation")) node.T_parent_node.translate(translation->vector3());
    if (const auto rotation = json.find("rotation")) {
      const std::array<double, 4> q = rotation->numbers<4>();
      node.T_parent_node.rotate(Eigen::Quaterniond(q.data()).normalized());  // x, y, z, w
    }
    if (const auto scale = json.find("scale")) node.T_parent_node.scale(scale->vector3());
    return node;
  }

  void readMesh(const JsonReader& json, MeshBuilder& part) {
    for (const JsonReader& primitive : json.at("primitives").items()) {
      constexpr std::uint32_t kTriangles = 4;
      constexpr std::uint32_t kStrip = 5;
      constexpr std::uint32_t kFan = 6;
      const std::uint32_t mode = numberOr(primitive, "mode", kTriangles);
      if (mode < kTriangles || mode > kFan) continue;  // points and lines
      const auto extensions = primitive.find("extensions");
      if (extensions && extensions->find("KHR_draco_mesh_compression")) {
        mesh_.fail(message("needs the extension {} of glTF, which is not read", "KHR_draco_mesh_compression"));
      }
      const GltfNumbers points = numbersOf(primitive.at("attributes").at("POSITION"), "VEC3");
      const auto indices = primitive.find("indices");
      const GltfNumbers order = indices ? numbersOf(*indices, "SCALAR") : GltfNumbers();
      const std::size_t count = indices ? order.count : points.count;
      std::size_t start = 0;
      const auto corner = [&](std::size_t k) {
        const double index = indices ? number(order, start + k, 0) : static_cast<double>(start + k);
        if (!(index >= 0 && index < points.count)) indices->fail(message("indices below {}", points.count));
        const auto at = static_cast<std::size_t>(index);
        return Eigen::Vector3d(number(points, at, 0), number(points, at, 1), number(points, at, 2));
      };
      if (mode == kStrip) {
        part.addStrip(count, corner);
      } else if (mode == kFan) {
        part.addFan(count, corner);
      } else {
        for (; start + 3 <= count; start += 3) part.addFan(3, corner);
      }
    }
  }

  [[nodiscard]] double number(const GltfNumbers& numbers, std::size_t index, std::size_t component) const {
    MeshBytes in(numbers.bytes.substr(index * numbers.stride + component * numbers.type->size), mesh_);
    return numbers.type->read(in, numbers.is_normalized);
  }

  GltfNumbers numbersOf(const JsonReader& index, const std::string& shape) {
    const JsonReader& accessor = accessors_[indexIn(accessors_.size(), index)];
    const JsonReader found_shape = accessor.at("type");
    if (found_shape.string() != shape) found_shape.fail(Message::verbatim(shape));
    if (const auto sparse = accessor.find("sparse")) sparse->fail(message("an accessor that is not sparse"));
    GltfNumbers numbers;
    const JsonReader code = accessor.at("componentType");
    const auto type = std::ranges::find(kGltfTypes, code.unsignedInteger(), &GltfType::code);
    if (type == kGltfTypes.end()) code.fail(message("a number type"));
    numbers.type = &*type;
    numbers.count = accessor.at("count").unsignedInteger();
    const auto normalized = accessor.find("normalized");
    numbers.is_normalized = normalized && normalized->boolean();

    const JsonReader& view = views_[indexIn(views_.size(), accessor.at("bufferView"))];
    const std::uint64_t length = view.at("byteLength").unsignedInteger();
    const std::uint64_t offset = numberOr(accessor, "byteOffset", 0);
    const auto element = static_cast<std::uint32_t>(type->size * (shape == "VEC3" ? 3 : 1));
    numbers.stride = numberOr(view, "byteStride", element, element);
    const std::string_view buffer = bytesOf(indexIn(buffers_.size(), view.at("buffer")));
    MeshBytes in(buffer, mesh_);
    in.take(numberOr(view, "byteOffset", 0));
    MeshBytes in_view(in.take(length), mesh_);
    in_view.take(offset);
    // The last element need not be followed by the gap that the stride makes.
    const std::uint64_t gaps = numbers.count == 0 ? 0 : numbers.count - 1;
    numbers.bytes = in_view.take(gaps * numbers.stride + (numbers.count == 0 ? 0 : element));
    return numbers;
  }

  std::string_view bytesOf(std::size_t index) {
    const auto known = buffer_bytes_.find(index);
    if (known != buffer_bytes_.end()) return known->second;
    const JsonReader& buffer = buffers_[index];
    const auto uri = buffer.find("uri");
    if (!uri) {
      if (index > 0 || !chunk_) buffer.fail(message("a buffer with a uri"));
      return *chunk_;
    }
    std::string bytes = bytesAt(*uri);
    if (bytes.size() < buffer.at("byteLength").unsignedInteger()) failTruncated(mesh_);
    return buffer_bytes_.emplace(index, std::move(bytes)).first->second;
  }

  std::string bytesAt(const JsonReader& uri) {
    const std::string text = uri.string();
    if (text.starts_with("data:")) {
      constexpr std::string_view kStart = ";base64,";
      const std::size_t start = text.find(kStart);
      auto bytes = start == std::string::npos ? std::nullopt
                                              : bytesOfBase64(std::string_view(text).substr(start + kStart.size()));
      if (!bytes) uri.fail(message("data in base64"));
      return std::move(*bytes);
    }
    const std::filesystem::path path = pathOfUri(text);
    if (text.empty() || text.find(':') != std::string::npos || path.is_absolute() || text.size() > kLongestGltfPath ||
        path.native().find('\0') != std::string::npos) {
      uri.fail(message("a data URI or a relative path"));
    }
    // All buffers together are no more than a file may be.
    try {
      std::string bytes = readRegularFile(folder_ / path, max_bytes_);
      max_bytes_ -= bytes.size();
      mesh_.allowFor(bytes.size());
      return bytes;
    } catch (const StorageError& error) {
      throw StorageError(mesh_.file(), error.message());
    } catch (const FormatError& error) {
      throw FormatError(mesh_.file(), error.message());
    }
  }

  const JsonDocument json_;
  JsonReader root_;
  std::optional<std::string_view> chunk_;
  std::filesystem::path folder_;
  MeshBuilder& mesh_;
  std::vector<JsonReader> meshes_;
  std::vector<JsonReader> accessors_;
  std::vector<JsonReader> views_;
  std::vector<JsonReader> buffers_;
  std::map<std::size_t, std::string> buffer_bytes_;
  std::uintmax_t max_bytes_ = kMaxFileBytes;
};

}  // namespace

void readGltf(std::string_view text, const std::filesystem::path& file, MeshBuilder& mesh) {
  GltfReader(text, std::nullopt, file, mesh).read();
}

std::vector<std::filesystem::path> gltfBuffers(std::string_view text, const std::filesystem::path& file) {
  const nlohmann::json json = parseJson(text, file.string(), kMaxGltfValues).root;
  std::vector<std::filesystem::path> files;
  if (!json.contains("buffers") || !json["buffers"].is_array()) return files;
  for (const nlohmann::json& buffer : json["buffers"]) {
    if (!buffer.is_object() || !buffer.contains("uri") || !buffer["uri"].is_string()) continue;
    const auto uri = buffer["uri"].get<std::string>();
    if (!uri.starts_with("data:")) files.push_back(file.parent_path() / pathOfUri(uri));
  }
  return files;
}

void readGlb(std::string_view bytes, const std::filesystem::path& file, MeshBuilder& mesh) {
  constexpr std::uint32_t kVersion = 2;
  constexpr std::uint32_t kJson = 0x4E4F534A;
  constexpr std::uint32_t kBinary = 0x004E4942;
  MeshBytes in(bytes, mesh);
  in.take(4);  // "glTF"
  const auto version = in.number<std::uint32_t>();
  if (version != kVersion) {
    mesh.fail(message("expected {}, found \"{}\"", message("glTF of version 2"), std::to_string(version)));
  }
  constexpr std::uint32_t kHeader = 12;
  const auto whole_length = in.number<std::uint32_t>();
  MeshBytes chunks(in.take(std::max(whole_length, kHeader) - kHeader), mesh);
  std::optional<std::string_view> text;
  std::optional<std::string_view> chunk;
  while (!chunks.atEnd()) {
    const auto length = chunks.number<std::uint32_t>();
    const auto kind = chunks.number<std::uint32_t>();
    const std::string_view content = chunks.take(length);
    if (kind == kJson && !text) text = content;
    if (kind == kBinary && !chunk) chunk = content;
  }
  if (!text) failTruncated(mesh);
  GltfReader(*text, chunk, file, mesh).read();
}

}  // namespace hexoderm
