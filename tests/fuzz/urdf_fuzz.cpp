// Any text as a URDF: a robot whose links are at finite places, or an Error. Meshes are not opened.

#include "hexoderm/robots/robot_model.h"

#include "tests/fuzz/fuzz_checks.h"

#include <variant>

namespace {

using namespace hexoderm;

void requireSoundLink(const RobotModel& robot, std::size_t link) {
  const RobotLink& described = robot.links()[link];
  bool has_mesh = false;
  for (const auto* shapes : {&described.visuals, &described.collisions}) {
    for (const LinkShape& shape : *shapes) {
      const auto* mesh = std::get_if<MeshShape>(&shape.shape);
      if (mesh == nullptr) continue;
      has_mesh = true;
      fuzz::takeOrComplain([&] { static_cast<void>(robot.meshFile(*mesh, link)); });
    }
  }
  if (has_mesh) return;
  const TriangleMesh body = robot.bodyOf(link);
  for (const Eigen::Vector3d& point : body.points) fuzz::require(point.allFinite(), "finite bodies");
  static_cast<void>(robot.suspectedUnit(link, body));
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  fuzz::takeOrComplain([&] {
    const RobotModel robot = RobotModel::parse(fuzz::asText({data, size}), "fuzz.urdf");
    JointAngles angles;
    for (const std::string& joint : robot.freeJointNames()) angles.positions[joint] = 0.7;
    for (const SE3& T_w_l : robot.forward(angles)) {
      fuzz::require(T_w_l.t.allFinite() && (T_w_l.R * T_w_l.R.transpose()).isIdentity(1e-6), "links at finite places");
    }
    fuzz::require(!robot.links()[robot.rootLink()].joint, "a root that no joint carries");
    for (std::size_t link = 0; link < robot.links().size(); ++link) {
      fuzz::require(robot.partOf(link) < robot.links().size(), "parts that are links");
      requireSoundLink(robot, link);
    }
  });
  return 0;
}
