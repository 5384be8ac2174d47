#include "hexoderm/io/export_mesh.h"

#include "hexoderm/io/exporter.h"
#include "hexoderm/reconstruction/figures/patch_mesh.h"
#include "tests/support/hand_made_skins.h"
#include "tests/support/options.h"

#include <gmock/gmock.h>

#include <map>
#include <set>
#include <sstream>

namespace hexoderm {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;

struct PlainPly {
  struct Vertex {
    Eigen::Vector3d point;
    std::uint32_t color = 0;
  };
  std::vector<Vertex> vertices;
  std::vector<std::vector<unsigned>> faces;
};

/// Reads an ASCII PLY line by line, without any library.
PlainPly readPly(const std::string& text) {
  std::istringstream in(text);
  std::string line;
  std::size_t vertices = 0;
  std::size_t faces = 0;
  std::vector<std::string> properties;
  EXPECT_TRUE(std::getline(in, line) && line == "ply");
  EXPECT_TRUE(std::getline(in, line) && line == "format ascii 1.0");
  while (std::getline(in, line) && line != "end_header") {
    std::istringstream words(line);
    std::string first, second, third;
    words >> first >> second >> third;
    if (first == "element" && second == "vertex") vertices = std::stoul(third);
    if (first == "element" && second == "face") faces = std::stoul(third);
    if (first == "property" && second != "list") properties.push_back(second + " " + third);
  }
  EXPECT_THAT(properties,
              ElementsAre("float x", "float y", "float z", "uchar red", "uchar green", "uchar blue", "uchar alpha"));
  PlainPly ply;
  for (std::size_t k = 0; k < vertices; ++k) {
    PlainPly::Vertex vertex;
    std::uint32_t red = 0, green = 0, blue = 0, alpha = 0;
    in >> vertex.point.x() >> vertex.point.y() >> vertex.point.z() >> red >> green >> blue >> alpha;
    EXPECT_EQ(alpha, 255U);
    vertex.color = red << 16U | green << 8U | blue;
    ply.vertices.push_back(vertex);
  }
  for (std::size_t k = 0; k < faces; ++k) {
    std::size_t count = 0;
    in >> count;
    std::vector<unsigned> face(count);
    for (unsigned& index : face) in >> index;
    ply.faces.push_back(face);
  }
  EXPECT_TRUE(in);
  EXPECT_FALSE(in >> line) << "something follows the faces: " << line;
  return ply;
}

TEST(ExportPly, HoldsThePrismsInMetres) {
  const Reconstruction reconstruction = makeTestReconstruction();
  const std::string text = exportBytes(reconstruction, ExportFormat::Ply, {}, "skin.ply");
  const PlainPly ply = readPly(text);
  ASSERT_EQ(ply.vertices.size(), 3U * 12U);
  ASSERT_EQ(ply.faces.size(), 3U * 8U);
  // First corner of cell 3, and the back corner below it, straight from the definition.
  const SE3& T = reconstruction.patches[0].cells[0].T_o_u;
  EXPECT_LT((ply.vertices[0].point - T * Eigen::Vector3d(0.01502, 0, 0)).norm(), 1e-8);
  EXPECT_LT((ply.vertices[6].point - T * Eigen::Vector3d(0.01502, 0, -0.0034)).norm(), 1e-8);
  EXPECT_THAT(ply.faces[0], ElementsAre(0, 1, 2, 3, 4, 5));
  Reconstruction one = reconstruction;
  one.patches.resize(1);
  const ExportMesh meant = plyMesh(one);
  EXPECT_EQ(ply.faces, meant.polygons);
  for (std::size_t k = 0; k < ply.vertices.size(); ++k) {
    EXPECT_LT((ply.vertices[k].point - meant.points[k]).norm(), 1e-8) << k;
  }
  EXPECT_THAT(text, HasSubstr("\ncomment metres, in the frame of cell 7, the origin of the patch\n"));
}

TEST(ExportPly, ColoursCellsByTheirWorstUsedLink) {
  std::vector<std::uint32_t> colors;
  for (const std::uint32_t of_patch : {7U, 20U}) {
    const PlainPly ply = readPly(exportBytes(makeTestReconstruction(), ExportFormat::Ply,
                                             test::with(&ExportOptions::patch, CellId(of_patch)), "skin.ply"));
    for (std::size_t cell = 0; cell < ply.vertices.size() / 12; ++cell) {
      colors.push_back(ply.vertices[12 * cell].color);
      for (std::size_t k = 0; k < 12; ++k) EXPECT_EQ(ply.vertices[12 * cell + k].color, colors.back());
    }
  }
  // Cell 7 has links of both classes; the muted links of 7, 12 and 20 don't count.
  EXPECT_THAT(colors, ElementsAre(0x17A1CA, 0x17A1CA, 0x3A1FB0, 0x8A939E));
}

TEST(ExportPly, KeepsEveryByteOfEveryColour) {
  ExportMesh mesh;
  for (std::uint32_t byte = 0; byte < 256; ++byte) {
    mesh.points.emplace_back(byte, 1, 2);
    mesh.colors.push_back(byte << 16U | (255 - byte) << 8U | byte);
  }
  for (std::uint32_t k = 0; k + 2 < 256; ++k) mesh.polygons.push_back({k, k + 1, k + 2});
  const PlainPly ply = readPly(plyBytes(mesh, "colours.ply"));
  for (std::size_t k = 0; k < 256; ++k) EXPECT_EQ(ply.vertices[k].color, mesh.colors[k]);
}

}  // namespace
}  // namespace hexoderm
