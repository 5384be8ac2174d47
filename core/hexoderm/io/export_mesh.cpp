#include "hexoderm/io/export_formats.h"

#include "hexoderm/base/text.h"
#include "hexoderm/base/units.h"
#include "hexoderm/io/export_selection.h"
#include "hexoderm/io/skin_tree.h"
#include "hexoderm/solve/metrics/patch_mesh.h"
#include "hexoderm/solve/result/quality_colors.h"

#include <fmt/ranges.h>

#include <bit>
#include <iterator>

namespace hexoderm {
namespace {

constexpr std::size_t kPointsPerCell = 12;

/// 0xRRGGBB of the worst used link of each cell; grey: the cell has none.
std::vector<std::uint32_t> colorsOf(const std::vector<CellId>& cells, const Reconstruction& reconstruction) {
  const auto quality = worstUsedQuality(reconstruction);
  std::vector<std::uint32_t> colors;
  for (const CellId cell : cells) {
    const auto found = quality.find(cell);
    colors.push_back(found == quality.end() ? unusedColor(Background::Light)
                                            : qualityColor(found->second, Background::Light));
  }
  return colors;
}

}  // namespace

std::string plyText(const Reconstruction& reconstruction, const ExportSelection& selection) {
  const PatchMesh mesh = makePatchMesh(reconstruction);
  const std::vector<std::uint32_t> colors = colorsOf(mesh.cells, reconstruction);
  std::string text = fmt::format(
      "ply\nformat ascii 1.0\ncomment metres, {}\n"
      "element vertex {}\nproperty float x\nproperty float y\nproperty float z\n"
      "property uchar red\nproperty uchar green\nproperty uchar blue\nproperty uchar alpha\n"
      "element face {}\nproperty list uchar int vertex_index\nend_header\n",
      frameText(reconstruction, selection), mesh.points.size(), mesh.polygons.size());
  const auto to = std::back_inserter(text);
  for (std::size_t k = 0; k < mesh.points.size(); ++k) {
    const Eigen::Vector3f point = mesh.points[k].cast<float>();
    const std::uint32_t rgb = colors[k / kPointsPerCell];
    fmt::format_to(to, "{} {} {} {} {} {} 255\n", point.x(), point.y(), point.z(), rgb >> 16U, rgb >> 8U & 0xFFU,
                   rgb & 0xFFU);
  }
  for (const PatchMesh::Polygon& polygon : mesh.polygons) {
    fmt::format_to(to, "{} {}\n", polygon.points.size(), fmt::join(polygon.points, " "));
  }
  return text;
}

std::string stlBytes(const Reconstruction& reconstruction, LengthUnit unit) {
  static_assert(std::endian::native == std::endian::little, "STL is little-endian and takes bytes as they are");
  const double scale = unit == LengthUnit::Millimetres ? 1 / kMillimetre : 1.0;
  const PatchMesh mesh = makePatchMesh(reconstruction);
  const auto triangles = triangulate(mesh);
  constexpr std::size_t kHeader = 80;
  std::string bytes = "Hexoderm";
  bytes.resize(kHeader);
  const auto count = static_cast<std::uint32_t>(triangles.size());
  bytes.append(reinterpret_cast<const char*>(&count), sizeof(count));
  for (const auto& [a, b, c] : triangles) {
    Eigen::Matrix3d corners;
    corners << mesh.points[a], mesh.points[b], mesh.points[c];
    Eigen::Matrix<float, 3, 4> facet;  // with its normal in front
    facet << (corners.col(1) - corners.col(0)).cross(corners.col(2) - corners.col(0)).normalized().cast<float>(),
        (scale * corners).cast<float>();
    bytes.append(reinterpret_cast<const char*>(facet.data()), sizeof(float) * 12);
    bytes.append(2, '\0');
  }
  return bytes;
}

std::string objText(const Reconstruction& reconstruction, const ExportSelection& selection) {
  const PatchMesh mesh = makePatchMesh(reconstruction);
  const std::vector<std::uint32_t> colors = colorsOf(mesh.cells, reconstruction);
  std::string text = "# metres, " + frameText(reconstruction, selection) + "\n";
  std::size_t polygon = 0;
  for (std::size_t cell = 0; cell < mesh.cells.size(); ++cell) {
    text += "o cell_" + toString(mesh.cells[cell]) + "\n";
    for (std::size_t k = kPointsPerCell * cell; k < kPointsPerCell * (cell + 1); ++k) {
      text += "v " + vectorText(mesh.points[k]) + " " + rgbText(colors[cell]) + "\n";
    }
    for (; polygon < mesh.polygons.size() && mesh.polygons[polygon].cell == cell; ++polygon) {
      text += "f";
      for (const std::uint32_t corner : mesh.polygons[polygon].points)
        text += " " + std::to_string(corner + 1);  // from 1
      text += "\n";
    }
  }
  return text;
}

}  // namespace hexoderm
