// Any bytes as a mesh file: a mesh within its limits, or an Error. Content that does not tell its format is read as
// each of those that only the name tells.

#include "hexoderm/base/limits.h"
#include "hexoderm/robots/mesh_file.h"

#include "tests/fuzz/fuzz_checks.h"

#include <string>
#include <vector>

namespace {

using namespace hexoderm;

void requireSoundMesh(const TriangleMesh& mesh, std::size_t bytes) {
  fuzz::require(!mesh.empty() && mesh.triangles.size() <= bytes + 500'000, "as many triangles as the file may have");
  std::vector<bool> is_used(mesh.points.size());
  for (const auto& triangle : mesh.triangles) {
    for (const std::uint32_t point : triangle) is_used.at(point) = true;
  }
  for (std::size_t k = 0; k < is_used.size(); ++k) {
    fuzz::require(is_used[k], "points of triangles only");
    fuzz::require(isWithin(mesh.points[k], kMaxLength_m), "points within their limit");
  }
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  for (const char* name : {"fuzz.stl", "fuzz.obj", "fuzz.dae"}) {
    fuzz::takeOrComplain([&] { requireSoundMesh(readMesh(std::string(fuzz::asText({data, size})), name), size); });
  }
  return 0;
}
