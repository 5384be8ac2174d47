// The commands and options that the help lists, so that a new one is tried too. No command replaces a file that it
// reads, nor a session; every option of numbers says which it takes, and refuses all others before any work.

#include "hexoderm/session/session_store.h"
#include "tests/app/cli/cli_program.h"
#include "tests/support/child_process.h"

#include <regex>
#include <set>
#include <sstream>

namespace hexoderm {
namespace {

namespace fs = std::filesystem;

struct Option {
  std::string name;  ///< "--robot"; of an argument "input"
  std::string type;  ///< "FILE"
};

/// Of the program's own help.
std::vector<std::string> commandsIn(const std::string& help) {
  std::istringstream lines(help);
  std::vector<std::string> names;
  std::string line;
  while (std::getline(lines, line) && line != "Subcommands:") continue;
  const std::regex entry("  ([a-z]+) .*");
  for (std::smatch match; std::getline(lines, line);) {
    if (std::regex_match(line, match, entry)) names.push_back(match[1]);
  }
  return names;
}

/// Options and arguments of a command's help that take a value.
std::vector<Option> optionsIn(const std::string& help) {
  std::istringstream lines(help);
  std::vector<Option> options;
  const std::regex entry("(?:  ){1,2}([a-z]+|(?:-\\w,)?--[-a-z]+) ([A-Z]{3,}(?::\\{)?).*");
  std::string line;
  for (std::smatch match; std::getline(lines, line);) {
    if (!std::regex_match(line, match, entry)) continue;
    const std::string name = match[1];
    options.push_back({name.substr(name.find(',') + 1), match[2]});
  }
  return options;
}

/// What each command needs beside inputs and outputs to be run at all. One that has an output has to be here.
const std::map<std::string, std::string> kNeeded = {
    {"simulate", "--robot demo"},
    {"capture", "--source sim:x17"},
    {"solve", "input"},
    {"check", "calibration --source sim:x17"},
    {"export", "calibration --to stl"},
    {"convert", "input"},
    {"sensors", "sessions"},
    {"place", "skin --robot demo --link forearm"},
};

/// Texts that name no file, and places where files are only read: of folders, or by an address.
const std::set<std::string> kWords = {
    "--source",   "source",  "--fit",        "--loop",     "--to",           "--place",   "--in-link",
    "--package",  "--put",   "--link",       "--rotation", "--point",        "--patch",   "--surface",
    "--fault",    "--mount", "--solver",     "--centre",   "--support-axes", "--weights", "--gap-model",
    "--distance", "--bind",  "--model-name", "--parent",   "--prefix"};

class CliOutputs : public CliWithSkin {
 protected:
  [[nodiscard]] std::vector<std::string> commands() const { return commandsIn(run("--help").out); }

  /// That a command ends with this code and one line that says all of this, and changes nothing.
  void expectRefused(const std::string& arguments, int exit_code, const std::vector<std::string>& says) {
    const auto before = contents();
    const Outcome outcome = run(arguments);
    EXPECT_EQ(outcome.exit_code, exit_code) << arguments << '\n' << outcome.err;
    EXPECT_EQ(outcome.out, "") << arguments;
    EXPECT_EQ(std::ranges::count(outcome.err, '\n'), 1) << arguments << '\n' << outcome.err;
    for (const std::string& text : says) EXPECT_THAT(outcome.err, HasSubstr(text)) << arguments;
    EXPECT_TRUE(contents() == before) << arguments;
  }

  /// The arguments of a command with these values; what it needs besides is a file, or is needed as it is.
  static std::string argumentsFor(const std::string& command, const std::map<std::string, std::string>& values) {
    std::istringstream needed(kNeeded.at(command));
    std::string line = command;
    std::set<std::string> given;
    for (std::string word; needed >> word;) {
      if (word.starts_with("--")) {
        std::string value;
        needed >> value;
        if (!values.contains(word)) line += " " + word + " " + value;
      } else if (!values.contains(word)) {
        line += " arm.calibration.json";
      } else {
        line += " " + values.at(word);
      }
      given.insert(word);
    }
    if (!values.contains("--output")) line += " -o none";
    for (const auto& [name, value] : values) {
      if (name.starts_with("--")) {
        line += " " + name + " " + value;
      } else if (!given.contains(name)) {
        line += " " + value;
      }
    }
    return line;
  }
};

TEST_F(CliOutputs, EveryOptionIsKnownAsAnInputAnOutputOrAWord) {
  std::string helps;
  for (const std::string& command : commands()) helps += run(command + " --help").out;
  const std::string program = std::exchange(program_, HEXODERM_EMULATOR);
  helps += run("--help").out;
  program_ = program;
  const std::set<std::string> known = {"FILE", "OUTPUT", "FLOAT", "INT", "UINT", "TEXT:{"};
  std::set<std::string> words;
  for (const Option& option : optionsIn(helps)) {
    if (option.type == "TEXT" || (option.name.starts_with("--") && !known.contains(option.type))) {
      words.insert(option.name);
    }
  }
  EXPECT_EQ(words, kWords) << "a file that is read (kInput), one that is written (kOutput), or a word?";
}

TEST_F(CliOutputs, NoneIsAnInputOrASession) {
  fs::create_directory(path("sub"));
  fs::copy_file(path("arm.hexo"), path("named.session.json"));
  fs::create_hard_link(path("arm.hexo"), path("hard.calibration.json"));
  fs::create_symlink("arm.hexo", path("soft.json"));
  fs::create_symlink("../arm.hexo", path("sub/soft.hexo"));
  const std::string names[] = {
      "arm.hexo",      path("arm.hexo"), "sub/../named.session.json", "hard.calibration.json", "soft.json",
      "sub/soft.hexo", "arm.hexo-wal"};
  std::size_t inputs = 0;
  std::size_t outputs = 0;
  for (const std::string& command : commands()) {
    const std::vector<Option> options = optionsIn(run(command + " --help").out);
    for (const Option& output : options) {
      if (output.type != "OUTPUT") continue;
      ++outputs;
      ASSERT_TRUE(kNeeded.contains(command)) << command << ' ' << output.name;
      const std::string said = output.name == "--output" ? "-o" : output.name;
      for (const Option& input : options) {
        if (input.type != "FILE") continue;
        ++inputs;
        expectRefused(argumentsFor(command, {{input.name, "arm.session.json"}, {output.name, "./arm.session.json"}}), 2,
                      {"./arm.session.json", said, "is one of the inputs"});
      }
      for (const std::string& name : names) {
        expectRefused(argumentsFor(command, {{output.name, name}}), 5, {name, said, "never replaced"});
      }
    }
  }
  EXPECT_GE(inputs, 15U);
  EXPECT_GE(outputs, 11U);
}

TEST_F(CliOutputs, AnInputThatIsASessionStaysToo) {
  fs::create_hard_link(path("arm.hexo"), path("hard.calibration.json"));
  for (const std::string name : {"arm.hexo", "hard.calibration.json"}) {
    expectRefused("solve arm.hexo -o " + name, 5, {"-o " + name});
    expectRefused("convert arm.hexo -o " + name, 5, {"-o " + name});
    expectRefused("sensors arm.session.json arm.hexo -o " + name, 5, {"-o " + name});
  }
}

TEST_F(CliOutputs, ASessionIsNotMadeBesideTheLogOfAnother) {
  std::ofstream(path("notes.hexo-wal")) << "somebody's notes";
  for (const std::string command : {"convert arm.session.json", "simulate --poses 2"}) {
    expectRefused(command + " -o notes.hexo", 5, {"notes.hexo", "-wal lies beside it"});
  }
}

TEST_F(CliOutputs, NothingIsWrittenInThePlaceOfASessionThatAnotherProcessCapturesInto) {
  test::ChildProcess capture(
      {program_, "capture", "--source", "sim:x17?speed=20", "--auto", "--poses", "6", "-o", "live.hexo"},
      folder_.path().string(), test::ChildProcess::Stream::Read, test::ChildProcess::Stream::Read);
  capture.waitForError("Pose 1 captured");
  for (const std::string name : {"live.hexo", "live.hexo-wal", "live.hexo-shm"}) {
    EXPECT_NE(run("solve arm.session.json -o " + name).exit_code, 0) << name;
    EXPECT_NE(run("export arm.calibration.json --to urdf -o " + name).exit_code, 0) << name;
  }
  capture.waitForOutput("6 poses of 17 cells");
  EXPECT_LE(capture.wait().value_or(-1), 1);
  EXPECT_EQ(readSessionStore(path("live.hexo")).poses().size(), 6U);
}

TEST_F(CliOutputs, EarlierOutputsAreReplaced) {
  std::ofstream(path("earlier.calibration.json")) << "earlier";
  EXPECT_EQ(run("solve arm.session.json -o earlier.calibration.json").exit_code, 0);
  EXPECT_EQ(readFile(path("earlier.calibration.json")), readFile(path("arm.calibration.json")));
  for (int times = 0; times < 2; ++times) {
    EXPECT_EQ(run("export arm.calibration.json --to csv,urdf -o out").exit_code, 0);
    EXPECT_EQ(run("solve arm.hexo leg.session.json -o out", "cp arm.session.json leg.session.json && ").exit_code, 0);
    EXPECT_EQ(run("simulate --robot demo --poses 1 -o robot.session.json").exit_code, 0);
  }
}

TEST_F(CliOutputs, FilesOfAFolderReplaceNoInputAndNoSession) {
  fs::create_directory(path("out"));
  fs::create_hard_link(path("arm.calibration.json"), path("out/manifest.json"));
  for (const std::string input : {"arm.calibration.json", "out/manifest.json"}) {
    expectRefused("export " + input + " --to stl,csv -o out", 2, {"out/manifest.json", "is one of the inputs"});
  }
  fs::rename(path("arm.hexo"), path("out/manifest.json"));
  expectRefused("export arm.calibration.json --to csv -o out", 5, {"out/manifest.json", "as a Hexoderm session"});
}

TEST_F(CliOutputs, TheRobotThatGetsTheSkinStays) {
  std::ofstream(path("manifest.json")) << "<robot name=\"arm\"><link name=\"base_link\"/></robot>";
  expectRefused("export arm.calibration.json --to robot-urdf,csv --robot manifest.json -o .", 2,
                {"manifest.json", "is one of the inputs"});
}

TEST_F(CliOutputs, CalibrationsOfManySessionsReplaceNoInputAndNoSession) {
  fs::create_directory(path("out"));
  fs::copy_file(path("arm.session.json"), path("leg.session.json"));
  fs::create_hard_link(path("leg.session.json"), path("out/leg.calibration.json"));
  expectRefused("solve arm.session.json leg.session.json -o out", 2, {"out/leg.calibration.json", "one of the inputs"});
  fs::rename(path("arm.hexo"), path("out/leg.calibration.json"));
  expectRefused("solve arm.session.json leg.session.json -o out", 5, {"out/leg.calibration.json", "Hexoderm session"});
}

TEST_F(CliOutputs, WhatIsWrittenBesideASimulatedRobotReplacesNoSession) {
  for (const std::string name : {"robot.joints.csv", "robot.truth.json"}) {
    fs::rename(path("arm.hexo"), path(name));
    expectRefused("simulate --robot demo -o robot.session.json", 5, {name, "as a Hexoderm session"});
    fs::rename(path(name), path("arm.hexo"));
  }
}

TEST_F(CliOutputs, ARecordingIsNotRecordedIntoItselfWhichMayBeStandardInput) {
  ASSERT_EQ(run("capture --source sim:x17?speed=20 --auto --poses 4 --record arm.skinrec -o first.hexo").exit_code, 0);
  fs::create_hard_link(path("arm.skinrec"), path("hard.skinrec"));
  for (const std::string name : {"arm.skinrec", "./arm.skinrec", "hard.skinrec"}) {
    expectRefused("capture --source 'replay:arm.skinrec?speed=max' --record " + name + " -o second.hexo", 2,
                  {"--record " + name, "is one of the inputs"});
  }
  const auto before = contents();
  EXPECT_THAT(errorOf("capture --source stdin --record arm.skinrec -o second.hexo <arm.skinrec", 2),
              AllOf(HasSubstr("--record arm.skinrec"), HasSubstr("is one of the inputs")));
  EXPECT_TRUE(contents() == before);
}

TEST_F(CliOutputs, NoFileIsWrittenByTwoOptionsAndNoneBesideARobotToStandardOutput) {
  for (const std::string arguments :
       {"simulate --robot demo --poses 2 -o a.session.json --joints a.session.json",
        "simulate --robot demo --poses 2 -o a.session.json --truth ./a.session.json",
        "simulate --robot demo --poses 2 -o a.session.json --joints j.csv --truth j.csv",
        "simulate --robot demo --poses 2 -o c.hexo --joints c.hexo",
        "simulate --robot demo --poses 2 -o a.session.json --truth a.joints.csv",
        "simulate --robot demo --poses 2 -o a.session.json --joints ./a.truth.json",
        "capture --source sim:x17 --auto --poses 2 -o live.hexo --record live.hexo-wal"}) {
    expectRefused(arguments, 2, {"which another option writes"});
  }
  for (const std::string option : {"--joints", "--truth"}) {
    expectRefused("simulate --robot demo --poses 2 -o a.session.json " + option + " -", 2, {option, "name of a file"});
  }
}

TEST_F(CliOutputs, TwoCalibrationsOfABatchAreNotOneFileNorIsAFileTheirFolder) {
  fs::create_directory(path("out"));
  std::ofstream(path("out/arm.calibration.json")) << "earlier";
  fs::create_symlink("arm.calibration.json", path("out/leg.calibration.json"));
  fs::copy_file(path("arm.session.json"), path("leg.session.json"));
  expectRefused("solve arm.session.json leg.session.json -o out", 2, {"leg.calibration.json", "collides with"});
  expectRefused("solve arm.session.json -o arm.session.json/", 2, {"expected a folder", "arm.session.json"});
}

TEST_F(CliOutputs, ARecordingStaysUntilASkinHasDescribedItself) {
  std::ofstream(path("earlier.skinrec")) << "earlier";
  EXPECT_EQ(run("capture --source tcp://localhost:1 --timeout 1 --record earlier.skinrec -o new.hexo").exit_code, 4);
  EXPECT_EQ(readFile(path("earlier.skinrec")), "earlier");
  EXPECT_EQ(run("capture --source tcp://localhost:1 --timeout 1 --record none.skinrec -o new.hexo").exit_code, 4);
  EXPECT_FALSE(exists("none.skinrec"));
}

TEST_F(CliOutputs, MeshesOfTheRobotStay) {
  fs::create_directory(path("m"));
  std::ofstream(path("m/box.obj")) << "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n";
  std::ofstream(path("m/box.gltf")) << R"({"asset": {"version": "2.0"}, "buffers": [{"uri": "box%20.bin"}]})";
  std::ofstream(path("m/box .bin")) << "buffer";
  std::ofstream(path("r.urdf"))
      << R"(<robot name="r"><link name="l1"><visual><geometry><box size="0.4 0.4 0.4"/>)"
         R"(</geometry></visual></link>)"
         R"(<link name="l2"><visual><geometry><mesh filename="m/box.obj"/></geometry></visual>)"
         R"(<collision><geometry><mesh filename="m/box.gltf"/></geometry></collision></link>)"
         R"(<joint name="j" type="fixed"><parent link="l1"/><child link="l2"/></joint></robot>)";
  const std::string export_robot =
      "export arm.calibration.json --to robot-urdf --robot r.urdf --place l1:0,0,0,0,0,0 -o ";
  const std::string simulated = "simulate --robot r.urdf --mount l1:0,0,0.2 --poses 2 -o new.session.json --truth ";
  for (const std::string& command :
       {export_robot, simulated,
        std::string("capture --source 'sim:robot?urdf=r.urdf&mount=l1:0,0,0.2' --poses 1 -o new.hexo --record ")}) {
    for (const std::string mesh : {"m/box.obj", "m/box.gltf", "'m/box .bin'"}) {
      expectRefused(command + mesh, 2, {"m/box", "is one of the inputs"});
    }
  }
}

TEST_F(CliOutputs, AnInputIsNotTakenForLeftBehind) {
  const std::string hidden = ".hexoderm-0123456789abcdef.tmp";
  fs::copy_file(path("arm.session.json"), path(hidden));
  EXPECT_EQ(run("solve " + hidden + " -o other.calibration.json").exit_code, 0);
  EXPECT_TRUE(exists(hidden));
}

using CliNumbers = Cli;

TEST_F(CliNumbers, ThatNoOptionTakesAreRefusedWithItsNameAndItsRange) {
  std::size_t tried = 0;
  for (const std::string& command : commandsIn(run("--help").out)) {
    for (const Option& option : optionsIn(run(command + " --help").out)) {
      if (option.type != "FLOAT" && option.type != "UINT" && option.type != "INT") continue;
      const std::string kind = option.type == "FLOAT" ? "a number" : "a whole number";
      const std::string others = option.name == "--up" ? " 0 1" : "";  // of a direction
      for (const std::string value : {"nan", "inf", "-inf", "1e300", "-1e300", "1e400", "''", "many"}) {
        ++tried;
        const std::string found = value == "''" ? "" : value;
        EXPECT_THAT(complaint(command + " " + option.name + " " + value + others, 2),
                    AllOf(HasSubstr(option.name + ": expected " + kind), HasSubstr("found \"" + found + "\""),
                          ContainsRegex("(from|above) -?[0-9.]+ (to|and at most) [0-9.]+")))
            << command;
      }
    }
  }
  EXPECT_GE(tried, 20U * 8U);
}

TEST_F(CliNumbers, OutsideTheRangeAreRefused) {
  for (const auto& [arguments, says] : {
           std::pair<std::string, std::string>{"capture --timeout 0",
                                               "--timeout: expected a number above 0 and at most 1000000, found \"0\""},
           {"simulate --offset-sigma -1", "--offset-sigma: expected a number from 0 to 100000, found \"-1\""},
           {"simulate --poses 1001", "--poses: expected a whole number from 0 to 1000, found \"1001\""},
           {"simulate --poses 2.5", "--poses: expected a whole number from 0 to 1000, found \"2.5\""},
           {"place --gap -0.1", "--gap: expected a number from 0 to 100000, found \"-0.1\""},
           {"place --surface-sigma 0", "--surface-sigma: expected a number from 0.001 to 100000, found \"0\""},
           {"place --normal-sigma 361", "--normal-sigma: expected a number from 0.001 to 360, found \"361\""},
           {"solve -j 0", "--jobs: expected a whole number from 1 to 1024, found \"0\""},
           {"solve --without -1", "--without: expected a whole number from 0 to 4294967295, found \"-1\""},
           {"simulate --seed -1", "--seed: expected a whole number from 0 to 18446744073709551615, found \"-1\""},
           {"simulate --seed 18446744073709551616", "--seed: expected a whole number from 0 to 18446744073709551615"},
           {"links --up 1,0,2e6", "--up: expected a number from -1000000 to 1000000, found \"2e6\""},
       }) {
    EXPECT_THAT(complaint(arguments, 2), HasSubstr(says));
  }
}

TEST_F(CliNumbers, AtTheEndsOfTheRangeAreTaken) {
  outputOf("simulate --poses 2 --samples 1 --offset-sigma 0 --seed 18446744073709551615 -o a.session.json");
  EXPECT_EQ(run("solve a.session.json -j 1024 --class-threshold 1000 -o a.calibration.json").exit_code, 0);
  for (const std::string ends : {"--gap 100000 --surface-sigma 100000 --normal-sigma 360",
                                 "--gap 0 --surface-sigma 0.001 --normal-sigma 0.001"}) {
    // Where the patch is turned any way, a search with such figures takes minutes.
    EXPECT_NE(run("place a.calibration.json --robot demo --link forearm --rotation 0,0,0 " + ends).exit_code, 2)
        << ends;
  }
}

TEST_F(CliNumbers, WithinATextAreRefusedToo) {
  ASSERT_EQ(run("simulate --poses 3 -o a.session.json").exit_code, 0);
  ASSERT_EQ(run("solve a.session.json -o a.calibration.json").exit_code, 0);
  const std::string place = "place a.calibration.json --robot demo --link forearm ";
  for (const auto& [arguments, option, range] : {
           std::tuple<std::string, std::string, std::string>{
               "export a.calibration.json --to urdf -o a.urdf --place l:VALUE,0,0,0,0,0", "--place", "1000000"},
           {"export a.calibration.json --to urdf -o a.urdf --place l:0,0,0,0,VALUE,0", "--place", "1000000"},
           {"simulate --robot demo -o b.session.json --mount forearm:0,VALUE,0", "--mount", "1000000"},
           {"simulate --robot demo -o b.session.json --mount forearm:0,0,0,VALUE,0,0", "--mount", "1000000"},
           {place + "--rotation 0,VALUE,0", "--rotation", "360"},
           {place + "--rotation 0,0,0:VALUE", "--rotation", "360"},
           {place + "--point 1:0,VALUE,0", "--point", "100"},
           {place + "--point 1:0,0,0:VALUE", "--point", "100"},
           {place + "--distance 1:2:VALUE", "--distance", "100"},
           {place + "--distance 1:2:1:VALUE", "--distance", "100"},
       }) {
    for (const std::string value : {"nan", "inf", "1e300", "-1e300", ""}) {
      std::string line = arguments;
      line.replace(line.find("VALUE"), 5, value);
      EXPECT_THAT(complaint(line, 2), AllOf(HasSubstr(option + ":"), HasSubstr("expected a number from "),
                                            HasSubstr(" to " + range + ", found \"" + value + "\"")))
          << line;
    }
  }
  EXPECT_FALSE(exists("a.urdf"));
  EXPECT_FALSE(exists("b.session.json"));
}

}  // namespace
}  // namespace hexoderm
