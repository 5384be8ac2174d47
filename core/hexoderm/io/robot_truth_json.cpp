#include "hexoderm/io/robot_truth_json.h"

#include "hexoderm/session/session_parts_json.h"

namespace hexoderm {

std::string robotTruthToJson(const SimulatedRobot& robot, const SimulatedRobotSession& simulated) {
  const auto placement = [](const SE3& T) { return nlohmann::ordered_json{{"R", toJson(T.R)}, {"t_m", toJson(T.t)}}; };
  nlohmann::ordered_json json;
  json["format"] = kRobotTruthFormat;
  json["version"] = kRobotTruthVersion;
  json["description"] = robot.description().english();
  json["robot"] = robot.robot().name();
  json["robot_sha256"] = robot.robot().sha256();
  json["zero_offsets"] = jointAnglesJson(robot.zeroOffsets());
  json["patches"] = nlohmann::ordered_json::array();
  for (const MountedPatch& patch : robot.patches()) {
    nlohmann::ordered_json cells = nlohmann::ordered_json::array();
    for (std::size_t k = 0; k < patch.cells.size(); ++k) {
      nlohmann::ordered_json cell = placement(patch.T_l_u[k]);
      cell["id"] = patch.cells[k].value();
      cells.push_back(std::move(cell));
    }
    json["patches"].push_back({{"link", patch.link}, {"part", patch.part}, {"cells", std::move(cells)}});
  }
  json["poses"] = nlohmann::ordered_json::array();
  for (std::size_t k = 0; k < simulated.poses.size(); ++k) {
    const SimulatedRobotPose& pose = simulated.poses[k];
    nlohmann::ordered_json links = nlohmann::ordered_json::array();
    for (std::size_t l = 0; l < pose.T_w_l.size(); ++l) {
      nlohmann::ordered_json link = placement(pose.T_w_l[l]);
      link["link"] = robot.robot().links()[l].name;
      links.push_back(std::move(link));
    }
    json["poses"].push_back({{"id", simulated.session.poses().at(k).capture->id.value()},
                             {"joint_angles", jointAnglesJson(pose.true_angles)},
                             {"up_w", toJson(pose.up_w)},
                             {"links", std::move(links)}});
  }
  return dumpReadable(json);
}

}  // namespace hexoderm
