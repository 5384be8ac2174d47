// Where the program's input comes from and where its output goes: pipes, links, devices, and files that nobody should
// trust.

#include "tests/app/cli/cli_program.h"

namespace hexoderm {
namespace {

using CliFiles = CliWithSkin;

/// What it says on standard error.
std::string expectOneLine(const Outcome& outcome, int exit_code) {
  EXPECT_EQ(outcome.exit_code, exit_code) << outcome.err;
  EXPECT_EQ(std::ranges::count(outcome.err, '\n'), 1) << outcome.err;
  EXPECT_LE(outcome.err.size(), 2100U);
  EXPECT_THAT(outcome.err, Not(HasSubstr(".hexoderm-"))) << "a temporary file's name";
  const bool is_plain = std::ranges::all_of(
      outcome.err, [](char c) { return c == '\n' || (static_cast<unsigned char>(c) >= 0x20 && c != '\x7f'); });
  EXPECT_TRUE(is_plain) << "a control character";
  return outcome.err;
}

TEST_F(CliFiles, DashIsStandardOutput) {
  EXPECT_EQ(run("simulate --poses 3 --seed 4 -o -").out, readFile(path("arm.session.json")));
  const Outcome solve = run("solve arm.session.json -o -");
  EXPECT_EQ(solve.exit_code, 0);
  EXPECT_EQ(solve.out, readFile(path("arm.calibration.json")));
  EXPECT_THAT(solve.err, AllOf(HasSubstr("Verdict: "), HasSubstr("standard output")));
  EXPECT_EQ(run("solve arm.session.json --quiet -o -").err, "");
  EXPECT_EQ(run("convert arm.hexo -o -").out, readFile(path("arm.session.json")));
  ASSERT_EQ(run("convert arm.calibration.json -o again.calibration.json").exit_code, 0);
  EXPECT_EQ(run("convert arm.calibration.json -o -").out, readFile(path("again.calibration.json")));
  for (const std::string format :
       {"dot", "ply", "stl", "vtp", "urdf", "tf-yaml", "tum", "icub", "skinware", "obj", "gltf", "sdf", "mjcf"}) {
    EXPECT_EQ(run("export arm.calibration.json --to " + format + " -o arm." + format).exit_code, 0);
    EXPECT_EQ(run("export arm.calibration.json --to " + format + " -o -").out, readFile(path("arm." + format)));
  }
  EXPECT_FALSE(exists("-"));
}

TEST_F(CliFiles, DashIsRefusedWhereStandardOutputCannotBe) {
  EXPECT_THAT(expectOneLine(run("export arm.calibration.json --to csv -o -"), 2), HasSubstr("folder of several files"));
  EXPECT_THAT(expectOneLine(run("capture --source sim:x17 -o -"), 2), HasSubstr("*.hexo"));
  expectOneLine(run("solve arm.session.json --json -o -"), 2);
  expectOneLine(run("solve arm.session.json -o - >/dev/full"), 5);
  expectOneLine(run("solve arm.session.json -o /dev/full"), 5);
  EXPECT_THAT(run("export arm.calibration.json --to stl -o /dev/null").out, HasSubstr("Written: /dev/null"));
}

TEST_F(CliFiles, PipesAreReadWhereverFilesAre) {
  for (const std::string input : {"arm.session.json", "arm.hexo"}) {
    const Outcome solve = run("solve /dev/stdin -o piped.calibration.json", "cat " + input + " | ");
    EXPECT_EQ(solve.exit_code, 0) << input << solve.err;
    const auto piped = nlohmann::json::parse(readFile(path("piped.calibration.json")));
    const auto plain = nlohmann::json::parse(readFile(path("arm.calibration.json")));
    EXPECT_EQ(piped.at("patches"), plain.at("patches")) << input;
    EXPECT_EQ(run("convert /dev/stdin -o -", "cat " + input + " | ").out, readFile(path("arm.session.json")));
  }
  EXPECT_THAT(run("inspect /dev/stdin", "cat arm.calibration.json | ").out, HasSubstr("calibration of cell model"));
  EXPECT_EQ(run("export /dev/stdin --to stl -o arm.stl", "cat arm.calibration.json | ").exit_code, 0);
  EXPECT_EQ(run("evaluate arm.calibration.json --against /dev/stdin", "cat arm.session.json | ").exit_code, 0);
  const std::string tum = HEXODERM_TEST_DATA "/two_patches.tum.xml";
  EXPECT_THAT(run("inspect /dev/stdin", "cat '" + tum + "' | ").out, HasSubstr("calibration of cell model"));
  EXPECT_EQ(run("convert /dev/stdin -o tum.session.json", "cat '" + tum + "' | ").exit_code, 0);
  const auto session = nlohmann::json::parse(readFile(path("arm.session.json")));
  folder_.put("model.json", readFile(HEXODERM_TEST_DATA "/../../resources/cell_models/hex-bma150.json"));
  EXPECT_EQ(jsonOf("simulate --seed 4 --poses 3 --cell-model /dev/stdin -o -", 0, "cat model.json | ").at("poses"),
            session.at("poses"));
}

TEST_F(CliFiles, ARecordingIsPlayedFromAPipe) {
  ASSERT_EQ(run("capture --source sim:x17 --auto --poses 2 --record arm.skinrec -o first.hexo").exit_code, 0);
  const Outcome played = run("capture --source replay:/dev/stdin --poses 2 -o played.hexo", "cat arm.skinrec | ");
  EXPECT_THAT(played.out, HasSubstr("2 poses of 17 cells")) << played.err;
  expectOneLine(run("capture --source replay:/dev/zero -o none.hexo"), 3);
  EXPECT_THAT(expectOneLine(run("inspect /dev/stdin", "cat arm.skinrec | "), 3), HasSubstr("is a recording"));
}

TEST_F(CliFiles, HostileFilesEndWithOneLine) {
  const std::string head = R"({"format": "hexoderm-session", "version": 1, "cell_model": "hex-bma150", )";
  const std::string control = R"(\u001b[2J\u0007\u009b31m\r\n)";
  const std::vector<std::pair<std::string, std::string>> hostile = {
      {head + R"("cells": -1, "poses": []})", "cells: expected an array, found -1"},
      {head + R"("cells": [], "poses": )" + std::string(100'000, '['), "nested too deeply"},
      {R"({"format": ")" + control + R"("})", "\\u001b[2J\\u0007\\u009b31m\\r\\n"},
      {R"({"format": ")" + std::string(1'000'000, 'x') + R"("})", "..."},
      {"{\"" + std::string(1'000'000, 'k') + "\": ?}", "not JSON"},
      {R"({"format": "hexoderm-session", "version": 1, "cell_model": ")" + control + R"("})", "cell_model: expected"},
      {"<" + std::string(1'000'000, 'x') + "/>", "SkinConfig"},
  };
  for (const auto& [content, complaint] : hostile) {
    folder_.put("hostile.json", content);
    EXPECT_THAT(expectOneLine(run("solve hostile.json -o out.calibration.json"), 3),
                AllOf(HasSubstr("hostile.json: "), HasSubstr(complaint)));
    EXPECT_FALSE(exists("out.calibration.json"));
  }
  EXPECT_THAT(expectOneLine(run("inspect \"$(printf 'no\\033[31m\\nfile')\""), 3), HasSubstr("no\\u001b[31m\\nfile"));
  EXPECT_THAT(run("inspect \"$(printf '\\033[31m')\" too many").err, Not(HasSubstr("\x1b")));
}

TEST_F(CliFiles, NamesInFilesReachTheTerminalWithoutWhatSteersIt) {
  auto session = nlohmann::json::parse(readFile(path("arm.session.json")));
  const std::string name =
      "\x1b]0;title\x07\n\xc2\x9b"
      "2J\x7f";
  session["description"] = name;
  session.erase("description_message");
  session["poses"][0]["label"] = name;
  session["poses"][0].erase("label_message");
  for (auto& cell : session["cells"]) cell["body_part"] = name + cell["id"].dump();  // findings name the parts
  folder_.put("named.session.json", session.dump());
  ASSERT_NE(run("solve named.session.json -o named.calibration.json").exit_code, 3);
  for (const std::string command :
       {"solve named.session.json", "inspect named.session.json", "inspect named.session.json --json",
        "solve named.session.json --json", "inspect named.calibration.json"}) {
    const Outcome outcome = run(command);
    ASSERT_NE(outcome.out, "") << command;
    for (const std::string control : {"\x1b", "\x07", "\xc2\x9b", "\x7f"}) {
      EXPECT_THAT(outcome.out, Not(HasSubstr(control))) << command;
    }
    EXPECT_TRUE(!command.ends_with("--json") || nlohmann::json::accept(outcome.out)) << command;
  }
  const auto json = nlohmann::json::parse(run("inspect named.session.json --json").out);
  EXPECT_EQ(json.at("poses").at(0).at("label"), name) << "JSON says the same";
}

TEST_F(CliFiles, OutputsThatCannotBeAreOneLineAndFive) {
  std::filesystem::create_symlink("loop", path("loop"));
  std::filesystem::create_symlink("gone", path("dangling"));
  const auto before = contents();
  const std::string long_name(256, 'n');
  for (const std::string& output : {std::string("loop"), std::string("dangling"), std::string("loop/x"), long_name,
                                    std::string("nowhere/x"), std::string("arm.hexo/x"), std::string(".")}) {
    expectOneLine(run("solve arm.session.json -o " + output), 5);
  }
  for (const std::string command :
       {"export arm.calibration.json --to urdf -o nowhere/x", "export arm.calibration.json --to csv -o arm.hexo",
        "simulate -o nowhere/x.hexo", "simulate -o loop/x.session.json", "capture --source sim:x17 -o loop/x.hexo"}) {
    expectOneLine(run(command), 5);
  }
  EXPECT_TRUE(contents() == before);
}

}  // namespace
}  // namespace hexoderm
