// Any text as a table of joint angles: one that is the same when written and read again, or an Error.

#include "hexoderm/robots/joint_angles_csv.h"

#include "tests/fuzz/fuzz_checks.h"

namespace {

using namespace hexoderm;

RobotModel robot() {
  std::string text = "<robot name='r'><link name='base'/>";
  for (const std::string joint : {"elbow", "wrist", "lift"}) {
    text += "<link name='of_" + joint + "'/><joint name='" + joint + "' type='" +
            (joint == "lift" ? "prismatic" : "revolute") + "'><parent link='base'/><child link='of_" + joint +
            "'/><limit lower='-1' upper='1' effort='1' velocity='1'/></joint>";
  }
  return RobotModel::parse(text + "</robot>", "r.urdf");
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  static const RobotModel kRobot = robot();
  fuzz::takeOrComplain([&] {
    const JointAnglesTable table = parseJointAnglesCsv(fuzz::asText({data, size}), "fuzz.csv", kRobot, {true});
    for (const JointAnglesRow& row : table.rows) row.angles.validate();
    const JointAnglesTable again = parseJointAnglesCsv(jointAnglesCsv(table, kRobot), "again.csv", kRobot, {true});
    fuzz::require(again.rows.size() == table.rows.size(), "as many rows again");
    for (std::size_t k = 0; k < table.rows.size(); ++k) {
      fuzz::require(again.rows[k].pose == table.rows[k].pose && again.rows[k].time_s == table.rows[k].time_s &&
                        again.rows[k].angles == table.rows[k].angles,
                    "the same rows again");
    }
  });
  return 0;
}
