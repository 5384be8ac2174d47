// Ctrl+C ends the programs whatever holds them up: each row of the table holds one up in a way of its own.

#include "hexoderm/base/text.h"
#include "hexoderm/io/calibration_json.h"
#include "tests/core/device/sources/loopback_device.h"
#include "tests/support/child_process.h"
#include "tests/support/neighbor_lists.h"
#include "tests/support/paths.h"
#include "tests/support/temporary_folder.h"

#include <sys/stat.h>

#include <gmock/gmock.h>

#include <functional>

namespace hexoderm {
namespace {

using Stream = test::ChildProcess::Stream;
/// An exit code, or 128 and the number of a signal; nothing of what does not end.
using End = std::optional<int>;

constexpr int kByForce = 130;

/// A program that holds itself up in a folder of its own, and is interrupted then.
using Run = std::function<End(const std::string& folder)>;

struct Case {
  std::string name;
  /// The program's end: its own (0, 1 or 4), or by force.
  std::vector<int> exit_codes;
  Run run;
};

/// The program and its arguments, of which none has a blank.
std::vector<std::string> cli(const std::string& arguments, const char* program = HEXODERM_CLI) {
  std::vector<std::string> words = split(arguments, ' ');
  words.insert(words.begin(), program);
  return words;
}
std::vector<std::string> emulator(const std::string& arguments) { return cli(arguments, HEXODERM_EMULATOR); }

/// Interrupted at the moment for which `wait` waits.
Run interrupted(const std::vector<std::string>& words, const std::function<void(test::ChildProcess&)>& wait,
                Stream out = Stream::Read, Stream err = Stream::Read) {
  return [=](const std::string& folder) {
    test::ChildProcess program(words, folder, out, err);
    wait(program);
    program.interrupt();
    return program.wait();
  };
}
Run atOnce(const std::vector<std::string>& words) {
  return interrupted(words, [](auto& /*program*/) {});
}
/// When it does nothing by itself any more.
Run whenIdle(const std::vector<std::string>& words, Stream out = Stream::Read, Stream err = Stream::Read) {
  return interrupted(
      words, [](auto& program) { program.waitUntilIdle(); }, out, err);
}
/// As soon as it has written this on standard error, or on its output.
Run afterError(const std::vector<std::string>& words, const std::string& text, Stream out = Stream::Read) {
  return interrupted(
      words, [=](auto& program) { program.waitForError(text); }, out);
}
Run afterOutput(const std::vector<std::string>& words, const std::string& text) {
  return interrupted(words, [=](auto& program) { program.waitForOutput(text); });
}
/// With a pipe of this name, of which nobody holds the other end.
Run withFifo(const std::string& name, const Run& run) {
  return [=](const std::string& folder) {
    if (::mkfifo((folder + "/" + name).c_str(), 0600) != 0) throw std::runtime_error("no pipe with a name");
    return run(folder);
  };
}
/// Runs to its end; the files it makes are there.
void prepare(const std::string& command, const std::string& folder) {
  if (std::system(("cd '" + folder + "' && '" HEXODERM_CLI "' " + command + " >/dev/null 2>&1").c_str()) != 0) {
    throw std::runtime_error(command);
  }
}
Run after(const std::vector<std::string>& commands, const Run& run) {
  return [=](const std::string& folder) {
    for (const std::string& command : commands) prepare(command, folder);
    return run(folder);
  };
}

std::string rowOfCells(std::uint32_t count) {
  return skinwire::encodeLine(skinwire::Hello{skinwire::kMinor, "row", "hex-bma150"}) + "\n" +
         skinwire::encodeLine(skinwire::Topology{1, 0, 1, test::listOfSheet(1, count)}) + "\n";
}

End captureFromADeviceThatSaysNothing(const std::string& folder) {
  TcpDevice device;
  test::ChildProcess program(cli("capture -o a.hexo --source " + device.address()), folder);
  const DeviceConnection silent = device.accept();
  program.interrupt();
  return program.wait();
}
End captureFromASerialPortWithoutAWord(const std::string& folder) {
  const SerialDevice device;
  return whenIdle(cli("capture -o a.hexo --source " + device.address()))(folder);
}
End emulatorWithAHostThatDoesNotRead(const std::string& folder) {
  test::ChildProcess program(emulator("--tcp 0 --patch sheet:15x20 --speed 50"), folder);
  const std::string line = program.readLine();
  boost::asio::ip::tcp::iostream host("127.0.0.1", line.substr(line.rfind(':') + 1));
  program.waitForOutput("messages\n");
  EXPECT_TRUE(host.get() != std::iostream::traits_type::eof()) << "it is served";
  program.interrupt();
  return program.wait();
}
std::vector<Case> cases() {
  const std::string two_poses = "capture --source sim:x17?speed=max --auto --poses 2 -o a.hexo";
  std::string many = "solve -o out a.session.json";
  for (int k = 0; k < 50; ++k) many += " b.session.json";
  const std::string small = "simulate -o a.session.json";
  const std::string large = "simulate --patch sheet:30x30 --poses 4 -o b.session.json";
  return {
      {"CaptureFromADeviceThatSaysNothing", {4}, captureFromADeviceThatSaysNothing},
      {"CaptureFromANameThatIsLookedUp", {4}, whenIdle(cli("capture --source tcp://nobody.invalid:7700 -o a.hexo"))},
      {"CaptureFromStandardInputWithoutAWord", {4}, whenIdle(cli("capture --source stdin -o a.hexo"))},
      {"CaptureFromASerialPortWithoutAWord", {4}, captureFromASerialPortWithoutAWord},
      {"CaptureFromARecordingThatNobodyWrites",
       {kByForce},
       withFifo("in.skinrec", whenIdle(cli("capture --source replay:in.skinrec -o a.hexo")))},
      {"CaptureIntoARecordingThatNobodyReads",
       {kByForce},
       withFifo("out.skinrec", whenIdle(cli("capture --source sim:x17 --record out.skinrec -o a.hexo")))},
      {"CaptureWhileTheStreamRunsAtFullSpeed",
       {0, 1},
       afterError(cli("capture --source sim:x17?speed=max --keep-raw -o a.hexo"), "Pose 1 captured")},
      {"CaptureWhoseResultNobodyReads", {kByForce}, afterError(cli(two_poses), "Pose 2 captured", Stream::Never)},
      {"CaptureWhoseRemarksNobodyReads",
       {kByForce},
       whenIdle(cli("capture --source sim:x17 -o a.hexo"), Stream::Read, Stream::Never)},
      {"CaptureThatIsSolvingAHugeSkin",
       {0, 1, kByForce},
       interrupted(cli("capture --source stdin -o a.hexo"),
                   [](auto& program) {
                     program.write(rowOfCells(8'000));
                     program.waitForError("8000 cells");
                   })},
      {"SolveOfAFileThatNobodyWrites", {kByForce}, withFifo("in.session.json", whenIdle(cli("solve in.session.json")))},
      {"SolveWhoseResultNobodyReads",
       {kByForce},
       after({small}, whenIdle(cli("solve a.session.json --json"), Stream::Never))},
      {"SolveInTheMiddleOfIt", {kByForce}, after({large}, atOnce(cli("solve b.session.json")))},
      {"SolveOfManySessionsInTheMiddleOfIt",
       {kByForce},
       after({small, large}, afterOutput(cli(many), "out/a.calibration.json"))},
      {"SolveOfManySessionsOfWhichNobodyWritesOne",
       {kByForce},
       after({small}, withFifo("in.session.json", afterOutput(cli("solve a.session.json in.session.json -o out"),
                                                              "out/a.calibration.json")))},
      {"ReproduceInTheMiddleOfIt", {kByForce}, atOnce({HEXODERM_REPRODUCE})},
      {"EmulatorWithAHostThatDoesNotRead", {0}, emulatorWithAHostThatDoesNotRead},
      {"EmulatorWhoseAnswersNobodyReads",
       {kByForce},
       interrupted(emulator("--tcp 0"),
                   [](auto& program) {
                     program.waitForOutput("messages\n");
                     for (int k = 0; k < 100; ++k) program.write("help\n");  // a kilobyte each, more than a pipe holds
                     program.waitUntilIdle();
                   })},
  };
}

class Interrupt : public testing::TestWithParam<Case> {};

TEST_P(Interrupt, EndsTheProgram) {
  const test::TemporaryFolder folder;
  const End end = GetParam().run(folder.path().string());
  ASSERT_TRUE(end.has_value());
  EXPECT_THAT(GetParam().exit_codes, testing::Contains(*end));
}

INSTANTIATE_TEST_SUITE_P(WhateverHoldsItUp, Interrupt, testing::ValuesIn(cases()),
                         [](const auto& row) { return row.param.name; });

TEST(InterruptTwice, EndsAtOnceAndSaysWhatIsKept) {
  const test::TemporaryFolder folder;
  test::ChildProcess program(cli("capture --source sim:x17?speed=max --auto --poses 2 -o a.hexo"),
                             folder.path().string(), Stream::Never, Stream::Read);
  program.waitForError("Pose 2 captured");
  program.interrupt();
  program.interrupt();
  program.waitForError("is in the file");
  EXPECT_EQ(program.wait(), kByForce);
}

TEST(InterruptOfACheck, SaysHowManyPosesItHad) {
  const test::TemporaryFolder folder;
  const std::string in = folder.path().string();
  prepare("simulate --poses 3 -o a.session.json", in);
  prepare("solve a.session.json -o a.calibration.json", in);
  test::ChildProcess program(cli("check a.calibration.json --source sim:x17 --auto --poses 100"), in, Stream::Read,
                             Stream::Read);
  program.waitForError("17 cells");
  program.interrupt();
  program.waitForError("of 100 poses taken, nothing is compared");
  EXPECT_EQ(program.wait(), kByForce);
}

TEST(InterruptOfManySessions, LeavesWhatIsWrittenWhole) {
  const test::TemporaryFolder folder;
  const std::string in = folder.path().string();
  prepare("simulate --patch sheet:10x10 --poses 3 -o a.session.json", in);
  std::vector<std::string> words = cli("solve -o out --jobs 2");
  words.insert(words.end(), 1000, "a.session.json");
  test::ChildProcess program(std::move(words), in, Stream::Read, Stream::Read);
  program.waitForOutput("out/a-3.calibration.json");
  program.interrupt();
  program.waitForError("nterrupted");  // in order, with how many were solved, or on a busy computer by force
  EXPECT_EQ(program.wait(), kByForce);
  std::size_t written = 0;
  for (const auto& entry : std::filesystem::directory_iterator(folder.path() / "out")) {
    EXPECT_NO_THROW(readCalibrationJson(entry.path())) << entry.path();
    ++written;
  }
  EXPECT_GE(written, 3U);
  EXPECT_LT(written, 1000U);
}

}  // namespace
}  // namespace hexoderm
