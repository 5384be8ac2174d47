#include "hexoderm/sim/robot_truth_json.h"

#include "hexoderm/session/session_parts_json.h"

namespace hexoderm {
namespace {

/// An object of a placement, and what stands `behind`.
template <class... Behind>
void writePlaced(JsonWriter& json, const SE3& T, const Behind&... behind) {
  json.object(requiredField("R", T.R, kRotation), requiredField("t_m", T.t), behind...);
}

void writePatch(JsonWriter& json, const MountedPatch& patch) {
  json.beginObject();
  json.member("link", patch.link);
  json.member("part", patch.part);
  json.key("cells");
  json.beginArray();
  for (std::size_t k = 0; k < patch.cells.size(); ++k) {
    writePlaced(json, patch.T_l_u[k], requiredField("id", patch.cells[k]));
  }
  json.endArray();
  json.endObject();
}

}  // namespace

std::string robotTruthToJson(const SimulatedRobot& robot, const SimulatedRobotSession& simulated) {
  return jsonText([&](JsonWriter& json) {
    json.beginObject();
    json.member("format", kRobotTruthFormat);
    json.member("version", kRobotTruthVersion);
    json.member("description", robot.description().english());
    json.member("robot", robot.robot().name());
    json.member("robot_sha256", robot.robot().sha256());
    json.key("zero_offsets");
    AsJointAngles().put(json, robot.zeroOffsets().positions);
    json.arrayMember("patches", robot.patches(), [&](const MountedPatch& patch) { writePatch(json, patch); });
    json.key("poses");
    json.beginArray();
    for (std::size_t k = 0; k < simulated.poses.size(); ++k) {
      const SimulatedRobotPose& pose = simulated.poses[k];
      json.beginObject();
      json.member("id", simulated.session.poses().at(k).capture->id);
      json.key("joint_angles");
      AsJointAngles().put(json, pose.true_angles.positions);
      json.member("up_w", pose.up_w);
      json.key("links");
      json.beginArray();
      for (std::size_t l = 0; l < pose.T_w_l.size(); ++l) {
        writePlaced(json, pose.T_w_l[l], requiredField("link", robot.robot().links()[l].name));
      }
      json.endArray();
      json.endObject();
    }
    json.endArray();
    json.endObject();
  });
}

}  // namespace hexoderm
