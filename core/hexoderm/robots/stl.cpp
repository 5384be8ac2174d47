#include "hexoderm/robots/mesh_input.h"

#include <array>
#include <optional>

namespace hexoderm {
namespace {

constexpr std::size_t kStlHeader = 80;
constexpr std::size_t kStlStart = kStlHeader + 4;
constexpr std::size_t kStlTriangle = 50;  ///< 12 floats, and 16 bits for an attribute

std::optional<std::uint32_t> stlCount(std::string_view bytes) {
  if (bytes.size() < kStlStart) return std::nullopt;
  std::uint32_t count = 0;
  for (std::size_t k = kStlStart; k > kStlHeader; --k) count = count << 8U | static_cast<unsigned char>(bytes[k - 1]);
  return count;
}

void readBinaryStl(std::string_view bytes, MeshBuilder& mesh) {
  MeshBytes in(bytes, mesh);
  in.take(kStlHeader);
  const auto count = in.number<std::uint32_t>();
  MeshBytes triangles(in.take(std::uint64_t{count} * kStlTriangle), mesh);
  if (bytes.size() - kStlStart >= (std::uint64_t{count} + 1) * kStlTriangle) {
    mesh.fail(message("states {} triangles, but has the bytes of {}: expected as many as it states", count,
                      (bytes.size() - kStlStart) / kStlTriangle));
  }
  for (std::uint32_t k = 0; k < count; ++k) {
    triangles.take(3 * sizeof(float));  // the normal
    std::array<Eigen::Vector3d, 3> corners;
    for (Eigen::Vector3d& corner : corners) {
      for (double& coordinate : corner) coordinate = static_cast<double>(triangles.number<float>());
    }
    triangles.take(sizeof(std::uint16_t));
    mesh.add(corners[0], corners[1], corners[2]);
  }
}

bool isStlWord(std::string_view word, std::string_view lower) {
  const auto toLower = [](char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c; };
  return std::ranges::equal(word, lower, {}, toLower);
}

void readAsciiStl(std::string_view text, MeshBuilder& mesh) {
  MeshText in(text, mesh);
  std::vector<Eigen::Vector3d> corners;
  for (std::string_view word = in.word(); !word.empty(); word = in.word()) {
    if (isStlWord(word, "vertex")) {
      mesh.requireFewCorners(corners.size() + 1);
      corners.push_back(in.point());
    } else if (isStlWord(word, "endloop")) {
      mesh.addFan(corners.size(), [&](std::size_t k) { return corners[k]; });
      corners.clear();
    } else if (isStlWord(word, "solid") || isStlWord(word, "endsolid")) {
      in.nextLine();  // behind the name
    } else if (isStlWord(word, "facet")) {
      for (int k = 0; k < 4; ++k) in.word();  // "normal" and three numbers
    } else if (!isStlWord(word, "outer") && !isStlWord(word, "loop") && !isStlWord(word, "endfacet")) {
      in.failAt(word, message("a facet of an STL file"));
    }
  }
  if (!corners.empty()) failTruncated(mesh);
}

}  // namespace

bool isBinaryStl(std::string_view bytes) {
  const std::optional<std::uint32_t> count = stlCount(bytes);
  return count && bytes.size() == kStlStart + std::uint64_t{*count} * kStlTriangle;
}

bool isStlText(std::string_view text) { return isStlWord(takeWord(text), "solid"); }

void readStl(std::string_view bytes, MeshBuilder& mesh) {
  // Headers of binary files may begin with "solid" too, but their counts have zeros.
  const bool has_zeros = bytes.substr(0, kStlStart).find('\0') != std::string_view::npos;
  isStlText(bytes) && !has_zeros && !isBinaryStl(bytes) ? readAsciiStl(bytes, mesh) : readBinaryStl(bytes, mesh);
}

}  // namespace hexoderm
