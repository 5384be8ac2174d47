#pragma once

#include "hexoderm/robots/mesh_file.h"

#include "tests/support/testing.h"

#include <bit>

namespace hexoderm {

/// Why the bytes are refused as a mesh file of this name.
inline std::string refusalOf(const std::string& name, const std::string& bytes) {
  return messageOf<FormatError>([&] { readMesh(bytes, name); });
}

inline double areaOf(const TriangleMesh& mesh) {
  double area = 0;
  for (const auto& [a, b, c] : mesh.triangles) {
    area += (mesh.points[b] - mesh.points[a]).cross(mesh.points[c] - mesh.points[a]).norm() / 2;
  }
  return area;
}

/// A number's bytes, little-endian.
template <class Number>
std::string littleEndian(Number value) {
  const auto bytes = std::bit_cast<std::array<char, sizeof(Number)>>(value);
  return {bytes.begin(), bytes.end()};
}
template <class Number>
std::string bigEndian(Number value) {
  const std::string bytes = littleEndian(value);
  return {bytes.rbegin(), bytes.rend()};
}

}  // namespace hexoderm
