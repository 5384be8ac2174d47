#include "hexoderm/robots/joint_angles_csv.h"

#include "hexoderm/base/units.h"
#include "tests/support/testing.h"

namespace hexoderm {
namespace {

/// Joints that turn: elbow, wrist, tilt_deg; one that slides: lift; one that mimics the elbow; a fixed one.
const RobotModel& robot() {
  static const RobotModel instance = [] {
    std::string text = "<robot name=\"r\"><link name=\"base\"/>";
    const auto add = [&](const std::string& name, const std::string& type, const std::string& rest) {
      text += "<link name=\"of_" + name + "\"/><joint name=\"" + name + "\" type=\"" + type +
              "\"><parent link=\"base\"/><child link=\"of_" + name + "\"/>" + rest + "</joint>";
    };
    const std::string limit = "<limit lower=\"-1\" upper=\"1\" effort=\"1\" velocity=\"1\"/>";
    add("elbow", "revolute", limit);
    add("wrist", "revolute", limit);
    add("tilt_deg", "continuous", "");
    add("lift", "prismatic", limit);
    add("follower", "revolute", limit + "<mimic joint=\"elbow\"/>");
    add("plate", "fixed", "");
    return RobotModel::parse(text + "</robot>", "r.urdf");
  }();
  return instance;
}

JointAnglesTable parse(const std::string& text, bool missing_are_zero = false) {
  return parseJointAnglesCsv(text, "a.csv", robot(), {missing_are_zero});
}
std::string csvError(const std::string& text, bool missing_are_zero = false) {
  return messageOf<FormatError>([&] { parse(text, missing_are_zero); });
}

TEST(JointAnglesCsv, ReadsUnitsInBracketsAndEndings) {
  const JointAnglesTable table = parse(
      "pose,elbow[deg],wrist_rad,tilt_deg (rad),lift[mm]\n"
      "1,90,0.5,2,100\n"
      "\n"
      "# a remark\n"
      "3,-45,0,1e-3,0\r\n");
  ASSERT_EQ(table.rows.size(), 2U);
  EXPECT_EQ(table.rows[0].pose, PoseId(1));
  EXPECT_FALSE(table.rows[0].time_s);
  EXPECT_NEAR(table.rows[0].angles.positions.at("elbow"), kPi / 2, 1e-15);
  EXPECT_EQ(table.rows[0].angles.positions.at("wrist"), 0.5);
  EXPECT_EQ(table.rows[0].angles.positions.at("tilt_deg"), 2);
  EXPECT_NEAR(table.rows[0].angles.positions.at("lift"), 0.1, 1e-15);
  EXPECT_EQ(table.rows[1].pose, PoseId(3));
  EXPECT_EQ(table.rows[1].angles.positions.size(), 4U);
}

TEST(JointAnglesCsv, ReadsDecimalCommasWhereColumnsAreSeparatedOtherwise) {
  const JointAnglesTable table = parse("pose;elbow[rad];wrist[rad];tilt_deg[rad];lift[m]\n1;0,5;-1,25;2.5;0,1\n");
  ASSERT_EQ(table.rows.size(), 1U);
  EXPECT_EQ(table.rows[0].angles, (JointAngles{{{"elbow", 0.5}, {"wrist", -1.25}, {"tilt_deg", 2.5}, {"lift", 0.1}}}));
  EXPECT_THAT(csvError("pose;elbow[rad];wrist[rad];tilt_deg[rad];lift[m]\n1;1.000,5;0;0;0\n"),
              saysAll("line 2", "expected a number", "1.000,5"));
}

TEST(JointAnglesCsv, SaysWhatToDoAboutColumnsOfAnythingElse) {
  EXPECT_THAT(csvError("pose,elbow[rad],battery_voltage\n1,0,12\n"),
              saysAll("battery_voltage", "columns of anything else have to be taken out"));
}

TEST(JointAnglesCsv, ReadsOneUnitForAllOtherSeparatorsAndAByteOrderMark) {
  const JointAnglesTable table = parse("\xEF\xBB\xBF# unit: deg\npose;wrist;elbow;tilt_deg;lift[m]\n1;180;90;0;0.1\n");
  EXPECT_NEAR(table.rows[0].angles.positions.at("wrist"), kPi, 1e-15);
  EXPECT_EQ(table.rows[0].angles.positions.at("tilt_deg"), 0);  // a name as a whole, not "tilt" in degrees
  EXPECT_EQ(parse("# unit: rad\npose\twrist\telbow\ttilt_deg\tlift_m\n1\t1\t1\t1\t1\n").rows.size(), 1U);
}

TEST(JointAnglesCsv, KnowsTimes) {
  const JointAnglesTable table =
      parse("time[ms],elbow[rad],wrist[rad],tilt_deg[rad],lift[m]\n1000,0,0,0,0\n2500,1,0,0,0\n");
  EXPECT_EQ(table.rows[1].time_s, 2.5);
  EXPECT_EQ(table.of(PoseId(1), 2400)->positions.at("elbow"), 1);
  EXPECT_EQ(table.of(PoseId(1), 1700)->positions.at("elbow"), 0);
  EXPECT_FALSE(table.of(PoseId(1), 3600));
  EXPECT_FALSE(table.of(PoseId(1), std::nullopt));
}

TEST(JointAnglesCsv, JointsWithoutAColumnAreNamedUnlessTheyMayStandAtZero) {
  const std::string text = "pose,elbow[deg],wrist[deg]\n1,0,0\n";
  EXPECT_THAT(csvError(text), saysAll("a.csv", "line 1", "tilt_deg", "lift"));
  EXPECT_EQ(parse(text, true).rows[0].angles.positions.size(), 2U);
}

TEST(JointAnglesCsv, WantsTheUnitSaid) {
  EXPECT_THAT(csvError("pose,elbow\n1,0\n"), saysAll("line 1", "column elbow", "elbow[deg]", "# unit: deg"));
  EXPECT_THAT(csvError("# unit: deg\npose,lift\n1,0\n"), saysAll("column lift", "lift[m]"));
  EXPECT_THAT(csvError("pose,elbow[m]\n1,0\n"), saysAll("column elbow[m]", "deg or rad", "found m"));
  EXPECT_THAT(csvError("pose,elbow[grad]\n1,0\n"), saysAll("deg or rad", "grad"));
  EXPECT_THAT(csvError("pose,lift[deg]\n1,0\n"), saysAll("m or mm"));
  EXPECT_THAT(csvError("time[h],elbow[deg]\n1,0\n"), saysAll("column time[h]", "s, ms, us or ns"));
  EXPECT_THAT(csvError("# unit: furlong\npose,elbow\n1,0\n"), saysAll("line 1", "furlong"));
  EXPECT_THAT(csvError("pose,elbow[deg],wrist[deg],tilt_deg[deg],lift[m]\n# unit: rad\n1,0,0,0,0\n"),
              saysAll("line 2", "above"));
}

TEST(JointAnglesCsv, NamesColumnsThatAreNoJoints) {
  EXPECT_THAT(csvError("pose,elbo[deg]\n1,0\n"), saysAll("line 1", "column elbo[deg]", "did you mean elbow?"));
  EXPECT_THAT(csvError("pose,plate[deg]\n1,0\n"), saysAll("column plate[deg]", "fixed"));
  EXPECT_THAT(csvError("pose,elbow[deg],elbow_rad\n1,0,0\n"), saysAll("column elbow_rad", "already"));
  EXPECT_THAT(csvError("pose,time,elbow[deg]\n1,0,0\n"), saysAll("column time", "second"));
  EXPECT_THAT(csvError("elbow[deg]\n0\n"), saysAll("pose", "time"));
  EXPECT_THAT(csvError("pose,,elbow[deg]\n"), saysAll("line 1", "name of a joint"));
}

TEST(JointAnglesCsv, NamesLineAndColumnOfWhatIsNoNumber) {
  const std::string header = "pose,elbow[deg],wrist[deg]\n";
  EXPECT_THAT(csvError(header + "1,0,0\n2,x,0\n", true), saysAll("line 3", "column elbow[deg]", "found x"));
  EXPECT_THAT(csvError(header + "1,0,\n", true), saysAll("line 2", "column wrist[deg]", "there is none"));
  EXPECT_THAT(csvError(header + "1,nan,0\n", true), saysAll("line 2", "column elbow[deg]"));
  EXPECT_THAT(csvError(header + "1,1e300,0\n", true), saysAll("line 2", "column elbow[deg]"));
  EXPECT_THAT(csvError(header + "one,0,0\n", true), saysAll("line 2", "column pose"));
  EXPECT_THAT(csvError(header + "1,0\n", true), saysAll("line 2", "3 columns", "found 2"));
  EXPECT_THAT(csvError(header + "1,\"0,0\n", true), saysAll("line 2", "quote"));
  EXPECT_THAT(csvError(header + "1,0,0\n1,1,1\n", true), saysAll("line 3", "pose 1", "line 2"));
  EXPECT_THAT(csvError("time,elbow[deg]\n2,0\n1,0\n", true), saysAll("line 3", "column time", "ascend"));
  EXPECT_THAT(csvError(header, true), saysAll("a.csv", "line for each pose"));
  EXPECT_THAT(csvError(""), saysAll("a.csv", "empty"));
}

TEST(JointAnglesCsv, ReadsBackWhatItWrites) {
  JointAnglesTable table;
  for (std::uint32_t pose = 1; pose <= 3; ++pose) {
    const double x = 1.0 / pose;
    table.rows.push_back(
        {PoseId(pose), std::nullopt, {{{"elbow", x}, {"wrist", -x}, {"tilt_deg", 3 * x}, {"lift", 0.1 * x}}}});
  }
  const std::string text = jointAnglesCsv(table, robot());
  const JointAnglesTable back = parse(text);
  ASSERT_EQ(back.rows.size(), 3U);
  for (std::size_t k = 0; k < 3; ++k) {
    EXPECT_EQ(back.rows[k].pose, table.rows[k].pose);
    EXPECT_EQ(back.rows[k].angles, table.rows[k].angles);
  }
  EXPECT_EQ(text.substr(0, text.find('\n')), "pose,elbow[rad],lift[m],tilt_deg[rad],wrist[rad]");
  table.rows[1].angles.positions.erase("lift");
  EXPECT_THROW(jointAnglesCsv(table, robot()), InvalidArgument);
}

}  // namespace
}  // namespace hexoderm
