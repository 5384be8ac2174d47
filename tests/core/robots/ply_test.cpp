#include "tests/core/robots/mesh_test.h"

namespace hexoderm {
namespace {

/// A header with properties of many types in front of what is read, and behind.
std::string plyHeader(const std::string& format) {
  return "ply\nformat " + format +
         " 1.0\ncomment element vertex 7\nelement edge 1\nproperty int8 a\n"
         "element vertex 4\nproperty uchar red\nproperty float x\nproperty double y\nproperty short z\n"
         "property list uint8 ushort tags\nelement face 2\nproperty list int uint vertex_indices\nproperty float w\n"
         "element nothing 4000000000\nend_header\n";
}

template <class Put>
std::string plyBody(Put put) {
  std::string body = put(std::int8_t{-1});
  for (const auto& [x, y] : {std::pair(0.F, 0.), std::pair(1.F, 0.), std::pair(1.F, 2.), std::pair(0.F, 2.)}) {
    body += put(std::uint8_t{255}) + put(x) + put(y) + put(std::int16_t{-3});
    body += put(std::uint8_t{2}) + put(std::uint16_t{7}) + put(std::uint16_t{8});
  }
  body += put(std::int32_t{4}) + put(0U) + put(1U) + put(2U) + put(3U) + put(1.F);
  return body + put(std::int32_t{2}) + put(0U) + put(1U) + put(1.F);
}

std::string plyFile(const std::string& format) {
  if (format == "binary_big_endian") return plyHeader(format) + plyBody([](auto value) { return bigEndian(value); });
  if (format == "binary_little_endian")
    return plyHeader(format) + plyBody([](auto value) { return littleEndian(value); });
  return plyHeader(format) + plyBody([](auto value) { return std::to_string(value) + "\n"; });
}

constexpr std::array kFormats = {"ascii", "binary_little_endian", "binary_big_endian"};

TEST(Ply, ReadsTextAndBothOrdersOfBytesAndSkipsWhatIsNoGeometry) {
  for (const char* format : kFormats) {
    const TriangleMesh mesh = readMesh(plyFile(format), "m");
    EXPECT_EQ(mesh.triangles.size(), 2U) << format;
    ASSERT_EQ(mesh.points.size(), 4U) << format;
    EXPECT_EQ(mesh.points[2], Eigen::Vector3d(1, 2, -3)) << format;
    EXPECT_DOUBLE_EQ(areaOf(mesh), 2) << format;
  }
}

TEST(Ply, RefusesAFileThatIsCutOffAnywhere) {
  for (const char* format : kFormats) {
    const std::string bytes = plyFile(format);
    // A number of text may end earlier.
    const std::size_t end =
        format == std::string_view("ascii") ? bytes.rfind('\n', bytes.size() - 2) + 2 : bytes.size();
    for (std::size_t size = 4; size < end; ++size) {
      EXPECT_THROW(readMesh(bytes.substr(0, size), "m"), FormatError) << format << ' ' << size;
    }
  }
}

TEST(Ply, ReadsStripsWithTheirEnds) {
  const std::string text =
      "ply\r\nformat ascii 1.0\r\nelement vertex 4\r\nproperty float x\r\nproperty float y\r\nproperty float z\r\n"
      "element tristrips 1\r\nproperty list int int vertex_indices\r\nend_header\r\n0 0 0 1 0 0 0 1 0 1 1 0 8 0 1 2 3 "
      "-1 1 3 2";
  const TriangleMesh mesh = readMesh(text, "m");
  ASSERT_EQ(mesh.triangles.size(), 3U);
  for (const auto& [a, b, c] : mesh.triangles) {
    EXPECT_GT((mesh.points[b] - mesh.points[a]).cross(mesh.points[c] - mesh.points[a]).z(), 0) << "none turned round";
  }
}

TEST(Ply, RefusesNumbersThatDoNotFit) {
  const auto ply = [](const std::string& vertices, const std::string& faces, const std::string& body) {
    return refusalOf("m.ply", "ply\nformat ascii 1.0\nelement vertex " + vertices +
                                  "\nproperty float x\nproperty float y\nproperty float z\nelement face " + faces +
                                  "\nproperty list uchar int vertex_index\nend_header\n" + body);
  };
  const std::string points = "0 0 0 1 0 0 0 1 0 ";
  EXPECT_THAT(ply("3", "1", points + "3 0 1 3"), saysAll("m.ply", "point 3", "3 points"));
  EXPECT_THAT(ply("3", "1", points + "3 0 1 -1"), saysAll("m.ply", "-1"));
  EXPECT_THAT(ply("3", "1", points + "3 0 1 1.5"), saysAll("m.ply", "1.5"));
  EXPECT_THAT(ply("3", "1", points + "-3 0 1 2"), saysAll("m.ply", "-3"));
  EXPECT_THAT(ply("3", "1", points + "4000000 0 1 2"), saysAll("truncated"));
  EXPECT_THAT(ply("4000000", "1", points), saysAll("truncated"));
  EXPECT_THAT(ply("4294967296", "1", points), saysAll("line 3", "4294967296"));
  EXPECT_THAT(ply("3", "1", "0 0 0 1 0 0 0 inf 0 3 0 1 2"), saysAll("not finite"));
}

TEST(Ply, RefusesMoreOfAnythingThanItReads) {
  const std::string header = "ply\nformat binary_little_endian 1.0\n";
  const std::string points = "property uchar x\nproperty uchar y\nproperty uchar z\n";
  EXPECT_THAT(refusalOf("m.ply", header + "element vertex 84999900\n" + points + "end_header\n"),
              saysAll("m.ply", "84999900 points", "at most 10000000"));
  EXPECT_THAT(refusalOf("m.ply", header + "element vertex 1\n" + points +
                                     "element face 1\nproperty list uint uchar vertex_index\nend_header\n123" +
                                     littleEndian(255'000'000U)),
              saysAll("m.ply", "255000000 corners", "at most 10000000"));
  EXPECT_THAT(refusalOf("m.ply", header + "element edge 200000000\nproperty uchar a\nend_header\n"),
              saysAll("m.ply", "200000000 rows", "\"edge\"", "at most 10000000"));
}

TEST(Ply, RefusesAHeaderThatMakesNoSense) {
  EXPECT_THAT(refusalOf("m", "ply\nformat ascii 1.0\nelement vertex 1\nproperty float x\nend_header\n0"),
              saysAll("x, y and z"));
  EXPECT_THAT(refusalOf("m",
                        "ply\nformat ascii 1.0\nelement vertex 3\nelement face 1\nproperty list uchar int "
                        "vertex_index\nend_header\n3 0 1 2"),
              saysAll("x, y and z"));
  EXPECT_THAT(refusalOf("m", "ply\nformat utf8 1.0\nend_header\n"), saysAll("utf8", "binary_little_endian"));
  EXPECT_THAT(refusalOf("m", "ply\nformat ascii 1.0\nelement vertex 1\nproperty quad x\n"), saysAll("line 4", "quad"));
  std::string endless = "ply\n";
  for (int k = 0; k < 20'000; ++k) endless += "comment\n";
  EXPECT_THAT(refusalOf("m", endless), saysAll("end_header"));
}

}  // namespace
}  // namespace hexoderm
