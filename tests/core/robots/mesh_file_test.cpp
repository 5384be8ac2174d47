#include "hexoderm/robots/mesh_file.h"

#include "tests/support/paths.h"
#include "tests/support/temporary_folder.h"
#include "tests/support/testing.h"

#include <sys/stat.h>

namespace hexoderm {
namespace {

using test::TemporaryFolder;

TEST(MeshFile, RefusesPointsThatAreNowhere) {
  const TemporaryFolder folder;
  const auto complaint = [&](const std::string& x) {
    const auto file = folder.put("m.obj", "v 0 0 0\nv " + x + " 0 0\nv 0 1 0\nf 1 2 3\n");
    return messageOf<FormatError>([&] { readMeshFile(file); });
  };
  EXPECT_THAT(complaint("1e30"), saysAll("m.obj"));
  EXPECT_THAT(complaint("nan"), saysAll("m.obj"));
  EXPECT_THAT(complaint("1e400"), saysAll("m.obj", "line 2"));
}

TEST(MeshFile, RefusesOtherFormatsByTheirContent) {
  for (const char* name : {"m.off", "m.md5mesh", "m.fbx", "m.ply", "m.glb", "m"}) {
    EXPECT_THAT(messageOf<FormatError>([&] { readMesh("OFF\n3 2 0\n0 0 0", name); }),
                saysAll(name, "OFF", "STL, OBJ, COLLADA, glTF or PLY"));
  }
}

TEST(MeshFile, ReadsNumbersWithAPlusAndThoseTooSmallForADouble) {
  const TriangleMesh mesh = readMesh("v 0.5 0 0\nv 1.5 1e-400 0\nv 0 +1 0\nf 1 2 3\n", "m.obj");
  EXPECT_EQ(mesh.points[1], Eigen::Vector3d(1.5, 0, 0));
}

TEST(MeshFile, RefusesWhatIsNoRegularFileOrTooLarge) {
  const TemporaryFolder folder;
  const auto complaint = [&](const std::filesystem::path& file) {
    return messageOf<Error>([&] { readMeshFile(file); });
  };
  EXPECT_THAT(complaint(folder.path() / "none.stl"), saysAll("none.stl", "no such mesh file"));
  EXPECT_THAT(complaint(folder.path()), saysAll("this is none"));
  EXPECT_THAT(complaint("/dev/zero"), saysAll("/dev/zero", "this is none"));
  const std::filesystem::path pipe = folder.path() / "pipe.stl";
  ASSERT_EQ(::mkfifo(pipe.c_str(), 0600), 0);
  EXPECT_THAT(complaint(pipe), saysAll("pipe.stl", "this is none"));
  const std::filesystem::path loop = folder.path() / "loop.stl";
  std::filesystem::create_symlink("loop.stl", loop);
  EXPECT_THAT(complaint(loop), saysAll("loop.stl", "cannot be read"));
  EXPECT_THAT(complaint(folder.put("empty.stl", "")), saysAll("empty.stl", "this one is empty"));
  // As /proc/kmsg, which a reader would wait at: a regular file by its mode.
  EXPECT_THAT(complaint("/proc/version"), saysAll("/proc/version", "this one is empty"));
  const auto sparse = folder.put("sparse.stl", "");
  std::filesystem::resize_file(sparse, 4'000'000'000);
  EXPECT_THAT(complaint(sparse), saysAll("sparse.stl", "too large"));
}

/// Files that crashed, or exhausted the memory of, the reader that was there before.
TEST(MeshFile, RefusesFilesThatCrashedReaders) {
  const std::filesystem::path corpus = HEXODERM_TEST_DATA "/../fuzz/corpus/mesh";
  for (const char* name :
       {"face0.off", "heap.md5mesh", "index.md5mesh", "index.ply", "segv.ply", "selfnode.dae", "trunc.glb"}) {
    EXPECT_THAT(messageOf<FormatError>([&] { readMeshFile(corpus / name); }), saysAll(name));
  }
  EXPECT_EQ(readMeshFile(corpus / "face0.ply").triangles.size(), 1U) << "a face without corners is none";
}

}  // namespace
}  // namespace hexoderm
