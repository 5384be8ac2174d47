// The real program, run as a user would: what it prints, what it leaves, what it ends with.

#include "hexoderm/base/text.h"
#include "hexoderm/base/units.h"
#include "hexoderm/device/skinwire/messages.h"
#include "hexoderm/io/calibration_json.h"
#include "hexoderm/io/session_json.h"
#include "hexoderm/session/session_store.h"
#include "hexoderm/session/store_version.h"
#include "tests/app/cli/cli_program.h"

#include <sstream>

namespace hexoderm {
namespace {

TEST_F(Cli, WholeWayFromASimulatedSkinToAnExport) {
  EXPECT_EQ(run("simulate --poses 3 --seed 4 -o arm.session.json").exit_code, 0);
  EXPECT_THAT(outputOf("solve arm.session.json -o arm.calibration.json"),
              AllOf(HasSubstr("17 cells, 16 links, 1 patch"), HasSubstr("Against the truth")));
  const auto json =
      jsonOf("evaluate arm.calibration.json --fit cylinder --true-radius 0.0501 --against arm.session.json --json");
  EXPECT_NEAR(json.at("fits").at(0).at("radius_mm").get<double>(), 50.1, 5);
  EXPECT_LT(json.at("against").at(0).at("orientation_rms_deg").get<double>(), 10);
  EXPECT_EQ(run("export arm.calibration.json --to csv -o tables").exit_code, 0);
  EXPECT_TRUE(exists("tables/cells.csv"));
  EXPECT_THAT(run("inspect arm.session.json").out, AllOf(HasSubstr("Poses: 3"), HasSubstr("Next: ")));
  EXPECT_THAT(run("inspect arm.calibration.json").out, HasSubstr("calibration"));
}

TEST_F(Cli, InspectSaysWhatSolveSaysUnlessItIsAskedToBeQuick) {
  run("simulate --patch ring8:closed --poses 6 -o ring.session.json");
  const auto verdictOf = [this](const std::string& command) {
    return nlohmann::json::parse(run(command + " ring.session.json --json").out).at("verdict");
  };
  const auto inspected = verdictOf("inspect");
  const auto solved = verdictOf("solve");
  const auto quick = verdictOf("inspect --solver tree");
  for (const char* key : {"level", "position_95_mm", "orientation_95_deg"}) {
    EXPECT_EQ(inspected.at(key), solved.at(key)) << key;
  }
  EXPECT_NE(quick.at("position_95_mm"), solved.at("position_95_mm"));
  EXPECT_THAT(run("inspect --solver tree ring.session.json").out, HasSubstr("--solver global"));
  EXPECT_THAT(run("inspect ring.session.json").out, Not(HasSubstr("--solver global")));
}

TEST_F(Cli, WhatChipsOfALotShareIsStated) {
  run("simulate --poses 4 --offset-sigma 15 --lot 50,10 -o arm.session.json");
  EXPECT_THAT(outputOf("solve arm.session.json -o arm.calibration.json"), HasSubstr("  lot: offset "));
  EXPECT_THAT(outputOf("inspect arm.calibration.json"), HasSubstr("    lot: offset "));
  const nlohmann::json lot = jsonOf("inspect arm.calibration.json --json").at("patches").at(0).at("lot");
  EXPECT_EQ(lot, nlohmann::json::parse(readFile(path("arm.calibration.json"))).at("patches").at(0).at("lot"));
  EXPECT_EQ(lot.size(), 4U);
  EXPECT_TRUE(jsonOf("inspect --solver tree arm.session.json --json").at("patches").at(0).at("lot").is_null());
}

TEST_F(Cli, SensorsOfASessionBecomeACellModelForTheNext) {
  EXPECT_EQ(run("simulate --poses 6 --seed 4 --offset-sigma 20 --lot 0,0 -o arm.session.json").exit_code, 0);
  EXPECT_THAT(outputOf("sensors arm.session.json -o chip.json"),
              AllOf(HasSubstr("17 of 17 accelerometers"), HasSubstr("offset        "), HasSubstr("cross-axis"),
                    HasSubstr("Cell model written to chip.json")));
  const auto figures = jsonOf("sensors arm.session.json --json");
  const double offset_g = figures.at("offset_g").at("sigma").get<double>();
  EXPECT_EQ(figures.at("offset_g").at("knowledge"), "measured");
  EXPECT_LE(figures.at("offset_g").at("low_95").get<double>(), 0.02);
  EXPECT_GE(figures.at("offset_g").at("high_95").get<double>(), 0.02);
  EXPECT_EQ(nlohmann::json::parse(readFile(path("chip.json"))).at("accelerometer").at("offset_sigma_g"), offset_g);
  EXPECT_EQ(run("simulate --poses 4 --cell-model chip.json -o next.session.json").exit_code, 0);
  EXPECT_EQ(run("solve next.session.json").exit_code, 0);
}

TEST_F(Cli, SensorsOfOnePoseAreNotKnownAndOfTwoModelsNotLookedFor) {
  EXPECT_EQ(run("simulate --poses 1 -o one.session.json").exit_code, 0);
  EXPECT_THAT(outputOf("sensors one.session.json -o chip.json", 1),
              AllOf(HasSubstr("offset        can't tell"), HasSubstr("Nothing can be told")));
  EXPECT_TRUE(exists("chip.json"));
  EXPECT_EQ(run("simulate --poses 2 --offset-sigma 20 -o other.session.json").exit_code, 0);
  EXPECT_THAT(errorOf("sensors one.session.json other.session.json", 3), HasSubstr("must have one cell model"));
  EXPECT_EQ(run("sensors").exit_code, 2);
}

TEST_F(Cli, SimulatesARobotWithItsJointAnglesAndTheTruth) {
  EXPECT_THAT(
      outputOf("simulate --robot demo --poses 4 --seed 3 -o arm.session.json"),
      AllOf(HasSubstr("34 cells in 2 patches, 4 poses"), HasSubstr("arm.joints.csv"), HasSubstr("arm.truth.json")));
  const Session session = readSessionJson(path("arm.session.json"));
  ASSERT_EQ(session.poses().size(), 4U);
  const std::string csv = readFile(path("arm.joints.csv"));
  EXPECT_THAT(csv, HasSubstr("pose,elbow[rad],grip[m],"));
  EXPECT_EQ(std::ranges::count(csv, '\n'), 5);
  EXPECT_EQ(session.poses()[3].joint_angles.positions.size(), 5U);
  const auto truth = nlohmann::json::parse(readFile(path("arm.truth.json")));
  EXPECT_EQ(truth.at("robot"), "demo_arm");
  EXPECT_EQ(truth.at("patches").at(1).at("link"), "forearm");
  EXPECT_EQ(truth.at("poses").size(), 4U);
  EXPECT_EQ(run("solve arm.session.json").exit_code, 0);

  outputOf(
      "simulate --robot demo --mount hand:0,0.02,0.05 --patch sheet:2x2 --surface plane --base hand --poses 2 "
      "-o hand.hexo --truth t.json --joints j.csv");
  EXPECT_TRUE(exists("t.json"));
  EXPECT_TRUE(exists("j.csv"));
  EXPECT_EQ(readSessionStore(path("hand.hexo")).poses()[1].joint_angles.positions.size(), 5U);
}

TEST_F(Cli, ARobotWithoutJointsHasNoJointAngles) {
  std::ofstream(path("block.urdf")) << "<robot name='block'><link name='block'/></robot>";
  const std::string block =
      "simulate --robot block.urdf --mount block:0,0,0.1 --patch sheet:2x2 --surface plane --poses 2 -o ";
  EXPECT_THAT(
      outputOf(block + "block.session.json"),
      AllOf(HasSubstr("4 cells in 1 patch, 2 poses"), HasSubstr("block.truth.json"), Not(HasSubstr("joint angles"))));
  EXPECT_TRUE(exists("block.truth.json"));
  EXPECT_FALSE(exists("block.joints.csv"));
  EXPECT_TRUE(readSessionJson(path("block.session.json")).poses().at(1).joint_angles.positions.empty());

  EXPECT_THAT(errorOf(block + "asked.session.json --joints j.csv", 2),
              HasSubstr("--joints: no joint of the robot can move"));
  EXPECT_FALSE(exists("asked.session.json"));
}

TEST_F(Cli, NamesWhatMakesNoSimulatedRobot) {
  const auto refused = [&](const std::string& arguments, int exit_code) {
    const Outcome outcome = run("simulate -o a.session.json " + arguments);
    EXPECT_EQ(outcome.exit_code, exit_code) << outcome.err;
    EXPECT_FALSE(exists("a.session.json"));
    return outcome.err;
  };
  EXPECT_THAT(refused("--robot none.urdf --mount a:0,0,0", 3), HasSubstr("none.urdf"));
  EXPECT_THAT(refused("--robot demo --mount forearm", 2), HasSubstr("LINK:X,Y,Z"));
  EXPECT_THAT(refused("--robot demo --mount fore_arm:0,0,0", 2), HasSubstr("did you mean forearm?"));
  EXPECT_THAT(refused("--robot demo --package x", 2), HasSubstr("NAME=FOLDER"));
  EXPECT_THAT(refused("--robot demo --motion robot", 2), HasSubstr("--motion"));
  EXPECT_THAT(refused("--mount forearm:0,0,0", 2), HasSubstr("--robot"));
}

TEST_F(Cli, AVerdictOfNotEnoughEndsWithOneAndStillWrites) {
  run("simulate --poses 1 -o one.session.json");
  EXPECT_EQ(run("solve one.session.json -o one.calibration.json").exit_code, 1);
  EXPECT_EQ(readCalibrationJson(path("one.calibration.json"))->assessment.level, VerdictLevel::NotEnough);
}

TEST_F(Cli, OfManyFindingsOfAKindTheFirstAreSaidAndTheOthersCounted) {
  run("simulate --poses 250 -o arm.session.json");
  const Outcome solved = run("solve arm.session.json -o arm.calibration.json");
  std::istringstream lines(solved.out);
  int said = 0;
  for (std::string line; std::getline(lines, line);) said += line.starts_with("  info  repeated-pose: ") ? 1 : 0;
  EXPECT_EQ(said, 20);
  const auto json = nlohmann::json::parse(run("inspect arm.calibration.json --json").out);
  const auto repeated = std::ranges::count_if(
      json.at("findings"), [](const nlohmann::json& finding) { return finding.at("code") == "repeated-pose"; });
  EXPECT_GT(repeated, 20);
  EXPECT_THAT(solved.out, HasSubstr("  and " + std::to_string(repeated - 20) + " more of repeated-pose; --json"));
}

TEST_F(Cli, TheVerdictIsSaidOnce) {
  run("simulate --poses 4 -o four.session.json");
  const std::string out = run("solve four.session.json -o four.calibration.json").out;
  const std::size_t line = out.find("Verdict: ");
  ASSERT_NE(line, std::string::npos) << out;
  const std::string verdict = out.substr(line, out.find('\n', line) - line);
  const bool is_good = verdict.starts_with("Verdict: good, ±");
  EXPECT_TRUE(is_good || verdict.starts_with("Verdict: usable, ±")) << verdict;
  EXPECT_EQ(verdict.find("Good"), std::string::npos) << verdict;
  EXPECT_EQ(verdict.find("Usable"), std::string::npos) << verdict;
}

TEST_F(Cli, UsageEndsWithTwo) {
  run("simulate -o arm.session.json");
  for (const std::string wrong :
       {"", "frobnicate", "simulate", "simulate --patch circle -o a.session.json", "simulate -o a.xyz",
        "solve arm.session.json --without seven", "solve arm.session.json --centre sometimes"}) {
    EXPECT_EQ(run(wrong).exit_code, 2) << wrong;
  }
  EXPECT_FALSE(exists("a.session.json"));
  for (const auto& [option, says] : {std::pair<std::string, std::string>{"--solver magic", "global or tree"},
                                     {"--gap-model rubber", "fit, arc or pivot"},
                                     {"--without 99", "cell 99"}}) {
    EXPECT_THAT(errorOf("solve arm.session.json -o arm.calibration.json " + option, 2), HasSubstr(says));
  }
  EXPECT_FALSE(exists("arm.calibration.json"));
}

TEST_F(Cli, BadInputEndsWithThreeOneLineAndNothingWritten) {
  run("simulate --seed 4 -o arm.hexo");
  const std::map<std::string, std::string> files = {
      {"broken.session.json", "{\"format\": \"hexoderm-session\", \"version\": 1, \"cells\": ["},
      {"newer.session.json", "{\"format\": \"hexoderm-session\", \"version\": 9}"},
      {"cut.hexo", readFile(path("arm.hexo")).substr(0, 9000)},
      {"empty.hexo", ""}};
  for (const auto& [name, content] : files) writeFileAtomically(path(name), content);
  for (const std::string name : {"broken.session.json", "newer.session.json", "cut.hexo", "empty.hexo",
                                 "missing.session.json", "missing.hexo", "."}) {
    EXPECT_THAT(complaint("solve " + name + " -o out.calibration.json", 3), HasSubstr(name == "." ? "folder" : name));
    EXPECT_FALSE(exists("out.calibration.json")) << name;
  }
  EXPECT_THAT(run("solve newer.session.json").err, AllOf(HasSubstr("version 9"), HasSubstr("version 1")));
}

TEST_F(Cli, FaultsThatAreNoneAreRefusedWithWhatThereIs) {
  for (const std::string bad : {"broken:3", "joint:3", "dead:3:1", "joint:3:1:2", "joint", ""}) {
    EXPECT_THAT(errorOf("simulate --fault '" + bad + "' -o a.session.json", 2),
                AllOf(HasSubstr("KIND:CELL with KIND dead, stuck, stuck-axis, dead-axis, saturated, noisy, "
                                "wrong-gain, no-samples, echo, swapped, yawed or reglued"),
                      HasSubstr("KIND:CELL:PORT with KIND wrong-port, joint or cable")))
        << bad;
  }
  EXPECT_THAT(run("simulate --fault joint:5:2 -o a.session.json").err, HasSubstr("cell 5, port 2 has no link"));
  EXPECT_THAT(run("simulate --fault joint:5:x -o a.session.json").err, HasSubstr("--fault joint:5:x"));
  EXPECT_THAT(run("simulate --help").out, AllOf(HasSubstr("dead-axis"), HasSubstr("wrong-port"), HasSubstr("ringN")));
}

TEST_F(Cli, HalfAngleOfAConeIsPrinted) {
  run("simulate --patch sheet:5x5 --surface cone:r=0.08,angle=0.3 --poses 4 --ideal -o cone.session.json");
  run("solve cone.session.json -o cone.calibration.json");
  EXPECT_THAT(run("evaluate cone.calibration.json --fit cone").out, ContainsRegex("half angle 17\\.[12]"));
  EXPECT_EQ(run("evaluate cone.calibration.json --fit cone --true-radius 0.08").exit_code, 2);
}

TEST_F(Cli, LoopGapOfTheRingIsPrinted) {
  run("simulate --patch ring8 --poses 2 -o ring.session.json");
  run("solve ring.session.json -o ring.calibration.json");
  EXPECT_THAT(outputOf("evaluate ring.calibration.json --loop 1:2,8:3"),
              AllOf(HasSubstr("Loop gap"), HasSubstr("222.2")));
}

TEST_F(Cli, ConvertTakesTumFilesBothWays) {
  const std::string tum = HEXODERM_TEST_DATA "/two_patches.tum.xml";
  EXPECT_EQ(run("convert '" + tum + "' -o tum.calibration.json").exit_code, 0);
  EXPECT_EQ(readCalibrationJson(path("tum.calibration.json"))->solver, "imported");
  EXPECT_EQ(run("convert '" + tum + "' -o tum.session.json").exit_code, 0);
  EXPECT_TRUE(readSessionJson(path("tum.session.json")).poses().empty());
  EXPECT_EQ(run("convert '" + tum + "' -o tum.hexo").exit_code, 0);
  EXPECT_EQ(readSessionStore(path("tum.hexo")).neighbors(), readSessionJson(path("tum.session.json")).neighbors());
  EXPECT_EQ(run("convert '" + tum + "' -o tum.xyz").exit_code, 2);
}

TEST_F(Cli, SessionStoresAreTakenWhereverSessionsAre) {
  EXPECT_EQ(run("simulate --poses 3 --seed 4 -o arm.hexo").exit_code, 0);
  EXPECT_EQ(run("simulate --poses 3 --seed 4 -o arm.session.json").exit_code, 0);
  EXPECT_THAT(outputOf("solve arm.hexo -o arm.calibration.json"),
              AllOf(HasSubstr("17 cells, 16 links, 1 patch"), HasSubstr("Against the truth")));
  EXPECT_EQ(readCalibrationJson(path("arm.calibration.json"))->source.file, "arm.hexo");
  EXPECT_THAT(run("inspect arm.hexo").out, AllOf(HasSubstr("session of cell model"), HasSubstr("Poses: 3")));
  EXPECT_EQ(run("evaluate arm.calibration.json --against arm.hexo").exit_code, 0);
  for (const std::string session : {"arm.hexo", "arm.session.json"}) {
    EXPECT_THAT(complaint("export " + session + " --to ply -o arm.ply", 3), HasSubstr("solve")) << session;
  }
  EXPECT_FALSE(exists("arm.ply"));

  EXPECT_THAT(errorOf("convert arm.hexo -o back.session.json", 0), HasSubstr("history"));
  EXPECT_EQ(readFile(path("back.session.json")), readFile(path("arm.session.json")));
  EXPECT_EQ(run("convert back.session.json -o again.hexo").exit_code, 0);
  EXPECT_EQ(run("convert again.hexo -o again.session.json").exit_code, 0);
  EXPECT_EQ(readFile(path("again.session.json")), readFile(path("arm.session.json")));
}

TEST_F(Cli, EveryCommandHasHelpWithAnExampleThatWorks) {
  // The examples build on one another in this order.
  run("simulate --seed 1 -o arm.session.json");
  run("solve arm.session.json -o arm.calibration.json");
  std::filesystem::copy_file(HEXODERM_TEST_DATA "/two_patches.tum.xml", path("skin_config.xml"));
  for (const std::string command : {"simulate", "solve", "evaluate", "export", "convert", "inspect"}) {
    const Outcome help = run(command + " --help");
    EXPECT_EQ(help.exit_code, 0);
    const std::size_t at = help.out.find("\n  hexoderm-cli " + command);
    ASSERT_NE(at, std::string::npos) << command;
    const std::size_t begin = at + std::string("\n  hexoderm-cli ").size();
    const std::string example = help.out.substr(begin, help.out.find('\n', begin) - begin);
    const Outcome result = run(example);
    EXPECT_EQ(result.exit_code, 0) << example << '\n' << result.err;
  }
}

TEST_F(Cli, QuietAndPipedRunsPrintNoProgress) {
  const Outcome result = run("simulate --quiet -o arm.session.json");
  EXPECT_EQ(result.err, "");
  EXPECT_THAT(run("solve arm.session.json").err, Not(HasSubstr("\r")));
}

using ::testing::MatchesRegex;

TEST_F(Cli, VersionSaysCommitFormatsAndLibraries) {
  const Outcome outcome = run("--version");
  EXPECT_EQ(outcome.exit_code, 0);
  EXPECT_EQ(outcome.err, "");
  const std::vector<std::string> lines = split(outcome.out, '\n');
  ASSERT_EQ(lines.size(), 6U) << outcome.out;
  EXPECT_EQ(lines[0], "hexoderm-cli " HEXODERM_VERSION);
  EXPECT_THAT(lines[1], MatchesRegex("commit: .+"));
  EXPECT_THAT(lines[2], HasSubstr("session " + std::to_string(kSessionVersion)));
  EXPECT_THAT(lines[2], HasSubstr("calibration " + std::to_string(kCalibrationVersion)));
  EXPECT_THAT(lines[2], HasSubstr("(*.hexo) " + std::to_string(kStoreVersion)));
  EXPECT_EQ(lines[3], "wire: SkinWire " + std::to_string(skinwire::kMajor) + "." + std::to_string(skinwire::kMinor));
  EXPECT_THAT(lines[4], MatchesRegex("libraries: [A-Za-z_0-9 ]+ [0-9.]+(, [A-Za-z_ ]+ [0-9.]+)*"));
  for (const char* library : {"CLI11", "Boost", "Eigen", "fmt", "libzip", "nlohmann_json", "OpenSSL", "Orocos KDL",
                              "Protocol Buffers", "pugixml", "SQLite", "urdfdom"}) {
    EXPECT_THAT(lines[4], HasSubstr(std::string(library) + " "));
  }
  EXPECT_EQ(lines[5], "");
}

}  // namespace
}  // namespace hexoderm
