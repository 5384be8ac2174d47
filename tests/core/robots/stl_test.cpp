#include "tests/core/robots/mesh_test.h"

namespace hexoderm {
namespace {

std::string binaryStl(std::string header, const std::vector<float>& coordinates) {
  header.resize(80);
  std::string bytes = header + littleEndian(static_cast<std::uint32_t>(coordinates.size() / 9));
  for (std::size_t k = 0; k < coordinates.size(); ++k) {
    if (k % 9 == 0) bytes += std::string(12, '\0');
    bytes += littleEndian(coordinates[k]);
    if (k % 9 == 8) bytes += std::string(2, '\0');
  }
  return bytes;
}

const std::vector<float> kTwoFacets = {0, 0, 0, 1, 0, 0, 1, 1, 0, -0.0F, 0, 0, 1, 1, 0, 0, 1, 0.5};

TEST(Stl, ReadsBinaryWhateverTheHeaderAndTheNameSay) {
  for (const std::string& header :
       {std::string(), std::string("solid part"), std::string("glTF"), std::string("ply\n")}) {
    const TriangleMesh mesh = readMesh(binaryStl(header, kTwoFacets), "m.obj");
    ASSERT_EQ(mesh.triangles.size(), 2U);
    EXPECT_EQ(mesh.points.size(), 4U) << "0 and -0 are one";
    EXPECT_EQ(mesh.points.back(), Eigen::Vector3d(0, 1, 0.5));
  }
}

TEST(Stl, SkipsWhatFollowsTheTrianglesOfABinaryFile) {
  EXPECT_EQ(readMesh(binaryStl("solid", kTwoFacets) + "more", "m.stl").triangles.size(), 2U);
}

TEST(Stl, RefusesABinaryFileWithMoreTrianglesThanItStates) {
  std::string bytes = binaryStl("part", kTwoFacets);
  bytes[80] = 1;
  EXPECT_EQ(refusalOf("m.stl", bytes),
            "m.stl: states 1 triangles, but has the bytes of 2: expected as many as it states");
  bytes[80] = 0;
  EXPECT_THAT(refusalOf("m.stl", bytes), saysAll("states 0 triangles", "of 2"));
}

TEST(Stl, RefusesABinaryFileThatIsTooShort) {
  const std::string bytes = binaryStl("solid", kTwoFacets);
  for (const std::size_t size : {std::size_t{83}, std::size_t{84}, std::size_t{133}, bytes.size() - 1}) {
    EXPECT_THAT(refusalOf("m.stl", bytes.substr(0, size)), saysAll("m.stl", "truncated")) << size;
  }
}

TEST(Stl, ReadsTextInAnyCaseAndInOneLine) {
  const std::string facet =
      " FACET normal 0 0 nan outer LOOP vertex 0 0 0 vertex +1 0 0 Vertex 1e0 1 0 endloop endfacet";
  EXPECT_EQ(readMesh("\n solid vertex 1 2\n" + facet + "\nendsolid\nsolid two\n" + facet + facet, "m").triangles.size(),
            3U);
}

TEST(Stl, RefusesTextThatIsNoFacet) {
  EXPECT_THAT(refusalOf("m.stl", "solid\nfacet normal 0 0 1\nouter loop\nvertex 0 0 x\n"),
              saysAll("line 4", "a number", "x"));
  EXPECT_THAT(refusalOf("m.stl", "solid\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 0 0\nvertex 0 1 0\n"),
              saysAll("truncated"));
  EXPECT_THAT(refusalOf("m.stl", "solid\nvertex 0 0"), saysAll("truncated"));
  EXPECT_THAT(refusalOf("m.stl", "solid s\nhexagon\n"), saysAll("line 2", "hexagon"));
  EXPECT_THAT(refusalOf("m.stl", "solid s\nendsolid s\n"), saysAll("triangles"));
}

}  // namespace
}  // namespace hexoderm
