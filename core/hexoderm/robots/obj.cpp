#include "hexoderm/robots/mesh_input.h"

#include <charconv>
#include <vector>

namespace hexoderm {
namespace {

/// The point of a face's corner, "POINT", "POINT/TEXTURE", "POINT//NORMAL" or "POINT/TEXTURE/NORMAL": counted from 1,
/// or from the last point before the face as -1.
std::size_t objPoint(const MeshText& in, std::string_view corner, std::size_t points) {
  const std::string_view digits = corner.substr(0, corner.find('/'));
  std::int64_t index = 0;
  const auto [end, error] = std::from_chars(digits.data(), digits.data() + digits.size(), index);
  if (error != std::errc() || end != digits.data() + digits.size()) in.failAt(corner, message("the number of a point"));
  const auto count = static_cast<std::int64_t>(points);
  if (index == 0 || index > count || index < -count) in.fail(noSuchPoint(index, points));
  return static_cast<std::size_t>(index > 0 ? index - 1 : count + index);
}

}  // namespace

void readObj(std::string_view text, MeshBuilder& mesh) {
  MeshText in(text, mesh);
  std::vector<Eigen::Vector3d> points;
  std::vector<std::size_t> corners;
  do {
    const std::string_view keyword = in.wordInLine();
    if (keyword == "v") {
      mesh.requireFewPoints(points.size() + 1);
      points.push_back(in.pointInLine());
    } else if (keyword == "f") {
      corners.clear();
      for (std::string_view corner = in.wordInLine(); !corner.empty(); corner = in.wordInLine()) {
        mesh.requireFewCorners(corners.size() + 1);
        corners.push_back(objPoint(in, corner, points.size()));
      }
      mesh.addFan(corners.size(), [&](std::size_t k) { return points[corners[k]]; });
    }
  } while (in.nextLine());
}

}  // namespace hexoderm
