#include "tests/core/robots/mesh_test.h"

namespace hexoderm {
namespace {

constexpr auto kSquare = "# a square\nv 0 0 0\nv 1 0 0 1.0\nv 1 1 0 0.5 0.5 0.5\nv 0 1 0\n";

TEST(Obj, ReadsPolygonsWithAllKindsOfCorners) {
  for (const char* face : {"f 1 2 3 4", "f 1/1 2/2 3/3 4/4", "f 1//1 2//1 3//1 4//1", "f 1/1/1 2/2/1 3/3/1 4/4/1",
                           "f -4 -3 -2 -1", "f 1 2 \\\n3 4", "f\t1 2 3 4\r\n"}) {
    const TriangleMesh mesh =
        readMesh(std::string(kSquare) + "usemtl none\n" + face + "\nl 1 2\np 1\nvt 0 0\ng a", "m.OBJ");
    EXPECT_EQ(mesh.triangles.size(), 2U) << face;
    EXPECT_EQ(mesh.points.size(), 4U) << face;
    EXPECT_DOUBLE_EQ(areaOf(mesh), 1) << face;
  }
}

TEST(Obj, LeavesOutFacesOfTwoCornersAndPointsOfNoFace) {
  const TriangleMesh mesh = readMesh(std::string(kSquare) + "v nan 0 0\nf 1 2\nf 1 2 3\n", "m.obj");
  EXPECT_EQ(mesh.triangles.size(), 1U);
  EXPECT_EQ(mesh.points.size(), 3U);
}

TEST(Obj, RefusesCornersThatAreNoPoint) {
  for (const char* face : {"f 1 2 5", "f 0 1 2", "f -5 1 2", "f 1 2 99999999999"}) {
    EXPECT_THAT(refusalOf("m.obj", std::string(kSquare) + face), saysAll("m.obj", "line 6")) << face;
  }
  EXPECT_THAT(refusalOf("m.obj", std::string(kSquare) + "f 1 2 x3"), saysAll("line 6", "x3"));
  EXPECT_THAT(refusalOf("m.obj", std::string(kSquare) + "f 1 2 99999999999999999999"), saysAll("line 6"));
}

TEST(Obj, CountsEveryLine) {
  for (const auto& [text, line] : {
           std::pair{"\n\n# c\nv x 0 0\n", "m.obj: line 4:"},
           std::pair{"\xEF\xBB\xBF\nv x 0 0\n", "m.obj: line 2:"},
           std::pair{"v 0 \\\n0 0\nv x 0 0\n", "m.obj: line 3:"},
           std::pair{"v 0 \\\r\nx 0\n", "m.obj: line 2:"},
           std::pair{"vn 0 \\\n0 1\n# c\nv 0 0 0\nv x 0 0\n", "m.obj: line 5:"},
       }) {
    EXPECT_THAT(refusalOf("m.obj", text), saysAll(line, "expected a number, found \"x\"")) << text;
  }
}

TEST(Obj, TakesNoCoordinateFromTheNextLine) {
  EXPECT_THAT(refusalOf("m.obj", "v 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n"),
              saysAll("m.obj: line 1: expected three coordinates, found the end of the line"));
  EXPECT_THAT(refusalOf("m.obj", "v 0 0 0\nv 1 0"), saysAll("m.obj: line 2: expected three coordinates"));
}

TEST(Obj, RefusesATextWithoutFaces) {
  EXPECT_THAT(refusalOf("m.obj", kSquare), saysAll("m.obj", "triangles"));
  EXPECT_THAT(refusalOf("m.obj", ""), saysAll("m.obj", "triangles"));
}

}  // namespace
}  // namespace hexoderm
