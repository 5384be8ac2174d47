// hexoderm-cli capture: a session from a source, in the real program.

#include "hexoderm/session/session_store.h"
#include "tests/app/cli/cli_program.h"
#include "tests/app/emulator/emulator_program.h"

namespace hexoderm {
namespace {

class CliCapture : public Cli {};

/// A sender of SkinWire's text dialect: two cells that are held (0 degrees a second) or turned for 12 s, 20 readings a
/// second.
std::string sender(double turn_deg_s) {
  return "python3 -c '"
         "import json, math\n"
         "print(json.dumps({\"hello\": {\"device\": \"test\", \"cell_model\": \"hex-bma150\", \"rate_hz\": 20}}))\n"
         "print(json.dumps({\"topology\": {\"id\": 1, \"cells\": [{\"id\": 1, \"ports\": [{\"port\": 1, \"cell\": 2, "
         "\"cell_port\": 2}]}, {\"id\": 2, \"ports\": [{\"port\": 2, \"cell\": 1, \"cell_port\": 1}]}]}}))\n"
         "for k in range(240):\n"
         "    a = math.radians(" +
         std::to_string(turn_deg_s) +
         " * k / 20)\n"
         "    g = [round(v / 0.004) * 0.004 for v in (math.sin(a), 0, math.cos(a))]\n"
         "    print(json.dumps({\"samples\": {\"sequence\": 2 * k, \"time_us\": 50000 * k, \"cells\": [1, 2], "
         "\"acceleration_g\": g + g}}))\n"
         "' | ";
}

TEST_F(CliCapture, SaysWhyNothingWasCaptured) {
  const Outcome text = run("capture --source stdin -o turned.hexo", sender(8));
  EXPECT_EQ(text.exit_code, 1) << text.err;
  EXPECT_THAT(text.out, AllOf(HasSubstr("0 poses of 2 cells"), HasSubstr("No pose was captured in 1"),
                              HasSubstr("turning: Hold still: the part turns by ")));
  // Without a terminal too, while it lasts: the tests have none.
  EXPECT_THAT(text.err, HasSubstr("No pose for "));
  EXPECT_THAT(text.err, HasSubstr("Hold still: the part turns by "));

  const auto hold = jsonOf("capture --source stdin --json -o again.hexo", 1, sender(8)).at("hold");
  EXPECT_GT(hold.at("watched_s").get<double>(), 10);
  EXPECT_EQ(hold.at("still_s"), 0);
  const auto& blocked = hold.at("blocked");
  ASSERT_FALSE(blocked.empty());
  EXPECT_EQ(blocked.at(0).at("by"), "turning");
  EXPECT_GT(blocked.at(0).at("for_s").get<double>(), 8);
  EXPECT_THAT(blocked.at(0).at("message").get<std::string>(), HasSubstr("the part turns by"));
  EXPECT_TRUE(hold.at("odd_cells").empty());
}

TEST_F(CliCapture, SaysThatADeviceSendsNoReadings) {
  const std::string silent =
      "python3 -c '"
      "import json, time\n"
      "print(json.dumps({\"hello\": {\"device\": \"test\", \"cell_model\": \"hex-bma150\"}}))\n"
      "print(json.dumps({\"topology\": {\"id\": 1, \"cells\": [{\"id\": 1, \"ports\": []}]}}))\n"
      "for k in range(50):\n"
      "    print(json.dumps({\"status\": {\"text\": \"the topics are empty\"}}), flush=True)\n"
      "    time.sleep(0.1)\n"
      "' | ";
  const Outcome outcome = run("capture --source stdin -o silent.hexo", silent);
  EXPECT_EQ(outcome.exit_code, 1) << outcome.err;
  // Without a terminal too.
  EXPECT_THAT(outcome.err, ContainsRegex("No readings for [0-9]+ s. stdin: connected to test: the topics are empty"));
  EXPECT_THAT(outcome.out, HasSubstr("No pose was captured: no readings came."));
}

TEST_F(CliCapture, SaysNothingOfThatWhereAPoseWasCaptured) {
  const Outcome outcome = run("capture --source stdin --json -o held.hexo", sender(0));
  const auto json = nlohmann::json::parse(outcome.out);
  EXPECT_EQ(json.at("poses"), 1) << outcome.err;
  EXPECT_GT(json.at("hold").at("still_s").get<double>(), 0.5);
  EXPECT_EQ(json.at("hold").at("blocked").at(0).at("by"), "not_moved") << "it was held on";
}

TEST_F(CliCapture, ARobotTellsItsJointAnglesWithEachPoseAndLinksAreFoundByThem) {
  const Outcome capture =
      run("capture --source 'sim:robot?seed=2&speed=30' --auto --poses 6 --timeout 600 --record arm.skinrec --json "
          "-o arm.hexo");
  EXPECT_NE(capture.exit_code, 4) << capture.err;
  const auto json = nlohmann::json::parse(capture.out);
  EXPECT_EQ(json.at("poses"), 6) << capture.err;
  EXPECT_EQ(json.at("cells"), 34);
  const Session session = readSessionStore(path("arm.hexo"));
  ASSERT_EQ(session.poses().size(), 6U);
  for (std::size_t k = 0; k < 6; ++k) {
    EXPECT_EQ(session.poses()[k].joint_angles.positions.size(), 5U);
    if (k == 0) continue;
    EXPECT_NE(session.poses()[k].joint_angles, session.poses()[k - 1].joint_angles);
  }
  const auto found = jsonOf("links arm.hexo --robot demo --json");
  ASSERT_EQ(found.at("patches").size(), 2U);
  EXPECT_EQ(found.at("patches").at(0).at("placed").at("link"), "upper_arm");
  EXPECT_EQ(found.at("patches").at(1).at("placed").at("link"), "forearm");

  // A recording holds the angles, too.
  EXPECT_NE(run("capture --source 'replay:arm.skinrec?speed=max' -o again.hexo").exit_code, 4);
  const Session again = readSessionStore(path("again.hexo"));
  ASSERT_EQ(again.poses().size(), 6U);
  for (std::size_t k = 0; k < 6; ++k) EXPECT_EQ(again.poses()[k].joint_angles, session.poses()[k].joint_angles);

  EXPECT_EQ(run("capture --source 'sim:robot?urdf=none.urdf&mount=a:0,0,0' -o none.hexo").exit_code, 3);
}

TEST_F(CliCapture, ALooseLinkDoesNotFillTheSession) {
  // Ends of a ring that find each other and lose each other, 5,000 times.
  const auto topology = [](int id, bool is_closed) {
    const std::string link = is_closed ? R"({"port": 1, "cell": 3, "cell_port": 4})" : "";
    const std::string back = is_closed ? R"({"port": 4, "cell": 1, "cell_port": 1})" : "";
    return R"({"topology": {"id": )" + std::to_string(id) + R"(, "cells": [{"id": 1, "ports": [)" + link +
           R"(]}, {"id": 2, "ports": []}, {"id": 3, "ports": [)" + back + "]}]}}\n";
  };
  std::string lines = "{\"hello\": {\"device\": \"loose\", \"cell_model\": \"hex-bma150\"}}\n";
  for (int k = 0; k < 5000; ++k) lines += topology(2 * k, true) + topology(2 * k + 1, false);
  std::ofstream(path("lines")) << lines;
  EXPECT_EQ(jsonOf("capture --source stdin --json -o loose.hexo", 1, "cat lines | ").at("skin_changes"), 9999);
  // A change takes some kilobytes in the file; all of them took 20 MB.
  EXPECT_LT(std::filesystem::file_size(path("loose.hexo")), 1'000'000U);
  EXPECT_TRUE(readSessionStore(path("loose.hexo")).neighbors()[0].neighbors.empty()) << "as the device said last";
}

/// Runs `command` as soon as the first pose is captured.
std::string afterTheFirstPose(const std::string& command) {
  return "meanwhile() { \"$@\" & until grep -q 'Pose 1 captured' stderr.txt || ! kill -0 $!; do sleep 0.02; done; " +
         command + "; wait $!; }; meanwhile ";
}

TEST_F(CliCapture, ARecordingThatFailsIsSaidOnceAndTheResultIsWritten) {
  const Outcome outcome =
      run("capture --source 'sim:x17?speed=2' --auto --poses 3 --record arm.skinrec --json -o arm.hexo",
          afterTheFirstPose("rm arm.skinrec"));
  EXPECT_EQ(outcome.exit_code, 5) << outcome.err;
  const std::string complaint = "hexoderm-cli: arm.skinrec: the recording ended: it was removed while it was written";
  const std::size_t at = outcome.err.find(complaint);
  ASSERT_NE(at, std::string::npos) << outcome.err;
  EXPECT_EQ(outcome.err.find("the recording ended", at + complaint.size()), std::string::npos) << outcome.err;
  EXPECT_LT(at, outcome.err.find("Pose 3 captured")) << "at once";
  const auto json = nlohmann::json::parse(outcome.out);
  EXPECT_EQ(json.at("poses"), 3);
  EXPECT_THAT(json.at("recording_error").get<std::string>(), HasSubstr("arm.skinrec: the recording ended"));
  EXPECT_FALSE(json.at("verdict").is_null());
  EXPECT_EQ(readSessionStore(path("arm.hexo")).poses().size(), 3U);
}

TEST_F(CliCapture, InterruptedItKeepsWhatThereIs) {
  // Ctrl+C as soon as it has said so; more can't come, for the part lies still.
  EXPECT_THAT(outputOf("capture --source 'sim:x17?speed=20' -o arm.hexo", 1,
                       "interrupt_at() { said=$1; shift; \"$@\" & "
                       "until grep -q \"$said\" stderr.txt || ! kill -0 $!; do sleep 0.02; done; "
                       "kill -s INT $!; wait $!; }; interrupt_at 'Pose 1 captured' "),
              HasSubstr("1 pose of 17 cells"));
  EXPECT_EQ(readSessionStore(path("arm.hexo")).poses().size(), 1U);
}

TEST_F(CliCapture, SaysWhatIsWrongWithASource) {
  EXPECT_EQ(run("capture --source nowhere -o a.hexo").exit_code, 2);
  EXPECT_EQ(run("capture --source sim:x16 -o a.hexo").exit_code, 2);
  EXPECT_EQ(run("capture --source sim:x17 -o a.session.json").exit_code, 2);
  // Nobody listens at port 1.
  EXPECT_THAT(errorOf("capture --source tcp://127.0.0.1:1 --timeout 0.5 -o a.hexo", 4), HasSubstr("tcp://127.0.0.1:1"));
  EXPECT_THAT(errorOf("capture --source stdin -o a.hexo", 4, "true | "),
              HasSubstr("ended before a skin described itself"));
  EXPECT_THAT(errorOf("capture --source stdin --auto -o b.hexo", 4,
                      "printf '{\"hello\":{\"device\":\"d\",\"cell_model\":\"hex-bma150\"}}\\n"
                      "{\"topology\":{\"id\":1,\"cells\":[{\"id\":1}]}}\\n' | "),
              HasSubstr("needs a device that turns by itself"));
  EXPECT_FALSE(exists("a.hexo"));
}

class HandsFree : public Cli, public ::testing::WithParamInterface<const char*> {};

TEST_P(HandsFree, AnEmulatedSkinIsExploredCapturedAndSolved) {
  const std::string wire = GetParam();
  // A quarter of the samples: a computer that is busy, or runs the programs under a sanitizer, keeps up.
  std::vector<std::string> arguments = {"--patch", "ring31", "--seed", "3", "--rate", "250", "--speed", "5", wire};
  if (wire != "--pty") arguments.emplace_back("0");
  const Emulator emulator(arguments);
  const Outcome capture =
      run("capture --source '" + emulator.address + "' --auto --poses 4 --timeout 600 --json -o arm.hexo");
  ASSERT_EQ(capture.exit_code, 0) << emulator.address << ": " << capture.err;
  const auto json = nlohmann::json::parse(capture.out);
  EXPECT_EQ(json.at("cells"), 31);
  EXPECT_EQ(json.at("poses"), 4);
  EXPECT_EQ(json.at("rejected_messages"), 0);
  EXPECT_THAT(capture.err,
              AllOf(HasSubstr("Pose 1 captured: 31 cells"), HasSubstr("Next: Turn the part so that cell")));
  ASSERT_EQ(run("solve arm.hexo -o arm.calibration.json").exit_code, 0);
  ASSERT_EQ(run("simulate --patch ring31 --seed 3 --poses 0 -o truth.session.json").exit_code, 0);
  const auto against = jsonOf("evaluate arm.calibration.json --against truth.session.json --json").at("against").at(0);
  // X17's bar with three poses is 0.70 degrees in the median of many skins; one skin may be twice as bad.
  EXPECT_LT(against.at("orientation_rms_deg").get<double>(), 1.4);
}

INSTANTIATE_TEST_SUITE_P(Wires, HandsFree, ::testing::Values("--tcp", "--udp", "--pty"),
                         [](const ::testing::TestParamInfo<const char*>& wire) { return std::string(wire.param + 2); });

}  // namespace
}  // namespace hexoderm
