// `solve` of many sessions: what it leaves is what single runs leave, whatever goes wrong with some of them.

#include "hexoderm/base/text.h"
#include "tests/app/cli/cli_program.h"

namespace hexoderm {
namespace {

std::vector<std::string> linesOf(const std::string& text) {
  std::vector<std::string> lines = split(text, '\n');
  lines.pop_back();  // behind the last line feed
  return lines;
}

class CliBatch : public Cli {
 protected:
  void simulate(const std::string& name, const std::string& options = "") const {
    std::filesystem::create_directories(std::filesystem::path(path(name)).parent_path());
    ASSERT_EQ(run("simulate --samples 10 " + options + " -o " + name).exit_code, 0);
  }
  /// All files below a folder, in order.
  [[nodiscard]] std::vector<std::string> filesIn(const std::string& folder) const {
    std::vector<std::string> files;
    for (const auto& entry : std::filesystem::recursive_directory_iterator(path(folder))) {
      if (entry.is_regular_file()) files.push_back(entry.path().lexically_relative(path(folder)).string());
    }
    std::ranges::sort(files);
    return files;
  }
};

TEST_F(CliBatch, EveryCalibrationIsThatOfASingleRun) {
  // Of different sizes, so that they do not end in the order in which they begin.
  const std::vector<std::string> patches = {"sheet:9x9", "x17", "ring8", "sheet:4x5", "x17", "sheet:2x2"};
  for (std::size_t k = 0; k < patches.size(); ++k) {
    const std::string name = std::to_string(k) + (k == 3 ? ".hexo" : ".session.json");
    simulate(name, "--poses 3 --patch " + patches[k] + " --seed " + std::to_string(k + 1));
    run("solve " + name + " -o alone" + std::to_string(k) + ".calibration.json");
  }
  for (const std::string jobs : {"-j 1", "--jobs 2", "--jobs 5", ""}) {
    const Outcome batch = run("solve [0-9].* -o out " + jobs);
    EXPECT_EQ(batch.exit_code, 0) << batch.out << batch.err;
    const std::vector<std::string> lines = linesOf(batch.out);
    ASSERT_EQ(lines.size(), patches.size() + 1) << batch.out;
    for (std::size_t k = 0; k < patches.size(); ++k) {
      const std::string name = std::to_string(k);
      EXPECT_THAT(lines[k], AllOf(StartsWith(name + (k == 3 ? ".hexo: " : ".session.json: ")), HasSubstr("3 poses"),
                                  HasSubstr("Written to out/" + name + ".calibration.json")));
      EXPECT_EQ(readFile(path("out/" + name + ".calibration.json")),
                readFile(path("alone" + name + ".calibration.json")))
          << jobs << ", " << name;
    }
    EXPECT_THAT(lines.back(), StartsWith("6 sessions: "));
    EXPECT_EQ(filesIn("out").size(), patches.size());
    std::filesystem::remove_all(path("out"));
  }
}

TEST_F(CliBatch, WhatFailsIsNamedAndTheOthersGoOn) {
  simulate("a.session.json", "--poses 3");
  simulate("one_pose.session.json", "--poses 1");
  simulate("z.session.json", "--poses 3 --seed 2");
  writeFileAtomically(path("broken.session.json"), R"({"format": "hexoderm-session", "version": 1, "cells": [)");
  EXPECT_THAT(errorOf("solve a.session.json z.session.json -o out", 0), IsEmpty());
  EXPECT_THAT(outputOf("solve a.session.json one_pose.session.json -o out", 1),
              HasSubstr("2 sessions: 1 good, usable or coarse, 1 not enough, not trusted or failed, 0 with an error"));
  EXPECT_TRUE(exists("out/one_pose.calibration.json")) << "it is written all the same";

  std::filesystem::remove_all(path("out"));
  const Outcome bad =
      run("solve missing.session.json broken.session.json one_pose.session.json z.session.json -o out --jobs 2");
  EXPECT_EQ(bad.exit_code, 3) << bad.err;
  const std::vector<std::string> errors = linesOf(bad.err);
  ASSERT_EQ(errors.size(), 2U) << bad.err;
  EXPECT_THAT(errors[0], StartsWith("hexoderm-cli: missing.session.json: "));
  EXPECT_THAT(errors[1], StartsWith("hexoderm-cli: broken.session.json: "));
  EXPECT_THAT(filesIn("out"), ElementsAre("one_pose.calibration.json", "z.calibration.json"));

  // Where one can't be written.
  std::filesystem::create_directories(path("out/a.calibration.json"));
  const Outcome closed = run("solve a.session.json missing.session.json z.session.json -o out");
  EXPECT_EQ(closed.exit_code, 5) << closed.err;
  EXPECT_THAT(linesOf(closed.err).at(0), AllOf(HasSubstr("a.session.json: "), HasSubstr("out/a.calibration.json")));
  EXPECT_THAT(closed.out, HasSubstr("z.session.json: "));
}

TEST_F(CliBatch, SessionsOfOneNameDoNotMeet) {
  for (const std::string name : {"day1/arm.session.json", "day1/leg.session.json", "day2/arm.session.json"}) {
    simulate(name, "--poses 2 --seed " + std::to_string(name.find("day2") == 0 ? 2 : 1));
  }
  EXPECT_NE(run("solve day1/leg.session.json day2/arm.session.json -o flat").exit_code, 3);
  EXPECT_THAT(filesIn("flat"), ElementsAre("arm.calibration.json", "leg.calibration.json"));
  const Outcome apart = run("solve day*/*.session.json -o apart");
  EXPECT_LE(apart.exit_code, 1) << apart.err;
  EXPECT_THAT(filesIn("apart"),
              ElementsAre("day1/arm.calibration.json", "day1/leg.calibration.json", "day2/arm.calibration.json"));
  EXPECT_NE(readFile(path("apart/day1/arm.calibration.json")), readFile(path("apart/day2/arm.calibration.json")));

  // Two files of one name in one folder, and the very same file twice.
  ASSERT_EQ(run("convert day1/arm.session.json -o day1/arm.hexo").exit_code, 0);
  const Outcome numbered =
      run("solve day1/arm.hexo day1/arm.session.json day1/../day1/arm.session.json -o numbered --json");
  EXPECT_LE(numbered.exit_code, 1) << numbered.err;
  EXPECT_THAT(filesIn("numbered"),
              ElementsAre("arm-2.calibration.json", "arm-3.calibration.json", "arm.calibration.json"));
  EXPECT_EQ(nlohmann::json::parse(linesOf(numbered.out).at(1)).at("file"), "numbered/arm-2.calibration.json");
}

TEST_F(CliBatch, AsJsonEverySessionIsAnObjectInALine) {
  simulate("a.session.json", "--poses 3 --patch sheet:6x6");
  simulate("b.session.json", "--poses 3");
  run("solve a.session.json -o a.calibration.json");
  const Outcome batch = run("solve a.session.json missing.session.json b.session.json --json --jobs 3");
  EXPECT_EQ(batch.exit_code, 3);
  const std::vector<std::string> lines = linesOf(batch.out);
  ASSERT_EQ(lines.size(), 3U) << batch.out;
  const auto first = nlohmann::json::parse(lines[0]);
  EXPECT_EQ(first.at("session"), "a.session.json");
  EXPECT_EQ(first.at("exit_code"), 0);
  EXPECT_TRUE(first.at("error").is_null());
  EXPECT_TRUE(first.at("file").is_null());
  EXPECT_EQ(first.at("calibration"), nlohmann::json::parse(readFile(path("a.calibration.json"))));
  const auto second = nlohmann::json::parse(lines[1]);
  EXPECT_EQ(second.at("exit_code"), 3);
  EXPECT_THAT(second.at("error").get<std::string>(), StartsWith("missing.session.json: "));
  EXPECT_TRUE(second.at("calibration").is_null());
  EXPECT_EQ(nlohmann::json::parse(lines[2]).at("session"), "b.session.json");
}

TEST_F(CliBatch, OneSessionIsAsItWasUnlessAFolderIsAskedFor) {
  simulate("a.session.json", "--poses 3");
  const Outcome alone = run("solve a.session.json -o a.calibration.json --jobs 4");
  EXPECT_THAT(alone.out, AllOf(HasSubstr("Patch 0: "), HasSubstr("Verdict: ")));
  // What *.session.json names may be a single file.
  EXPECT_THAT(outputOf("solve *.session.json -o out/"),
              AllOf(StartsWith("a.session.json: "), Not(HasSubstr("Patch 0"))));
  EXPECT_EQ(readFile(path("out/a.calibration.json")), readFile(path("a.calibration.json")));
}

TEST_F(CliBatch, AFolderThatCannotBeOneIsRefusedBeforeAnythingIsSolved) {
  simulate("a.session.json", "--poses 2");
  simulate("b.session.json", "--poses 2");
  for (const auto& [output, reason] : {std::pair<std::string, std::string>{"-", "folder"},
                                       {"all.calibration.json", "folder"},
                                       {"a.session.json", "one of the inputs"}}) {
    const Outcome outcome = run("solve a.session.json b.session.json -o " + output);
    EXPECT_EQ(outcome.exit_code, 2) << output;
    EXPECT_THAT(outcome.err, HasSubstr(reason)) << output;
    EXPECT_EQ(linesOf(outcome.err).size(), 1U) << outcome.err;
    EXPECT_THAT(outcome.out, IsEmpty());
  }
  EXPECT_FALSE(exists("all.calibration.json"));
  EXPECT_EQ(run("solve a.session.json b.session.json -o a.session.json/out").exit_code, 5);
  EXPECT_EQ(run("solve a.session.json b.session.json --jobs 0").exit_code, 2);
  EXPECT_EQ(run("solve a.session.json b.session.json --solver magic").exit_code, 2);
}

}  // namespace
}  // namespace hexoderm
