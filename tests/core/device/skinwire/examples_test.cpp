// The example senders, as people start them.

#include "hexoderm/device/sources/stdin_source.h"
#include "hexoderm/device/sources/wire_source.h"
#include "hexoderm/graph/cell_model.h"
#include "hexoderm/util/file.h"
#include "tests/core/device/skinwire/collecting_listener.h"
#include "tests/support/paths.h"

#include <fcntl.h>
#include <signal.h>
#include <sys/wait.h>
#include <unistd.h>

#include <gtest/gtest.h>
#include <array>
#include <stdexcept>
#include <string>
#include <vector>

namespace hexoderm {
namespace {

using Delivered = CollectingListener::Delivered;

/// A running program, one of whose outputs is read here.
class Program {
 public:
  Program(std::vector<std::string> command, int output) {
    std::array<int, 2> ends{};
    if (::pipe2(ends.data(), O_CLOEXEC) != 0) throw std::runtime_error("no pipe");
    std::vector<char*> arguments;
    for (std::string& argument : command) arguments.push_back(argument.data());
    arguments.push_back(nullptr);
    process_ = ::fork();
    if (process_ == 0) {
      ::dup2(ends[1], output);
      ::execvp(arguments[0], arguments.data());
      ::_exit(127);
    }
    ::close(ends[1]);
    output_ = ends[0];
  }
  ~Program() {
    ::kill(process_, SIGTERM);
    ::waitpid(process_, nullptr, 0);
    ::close(output_);
  }
  Program(const Program&) = delete;
  Program& operator=(const Program&) = delete;

  [[nodiscard]] int output() const { return output_; }
  [[nodiscard]] std::string readLine() const {
    std::string line;
    for (char c = 0; ::read(output_, &c, 1) == 1 && c != '\n';) line += c;
    return line;
  }

 private:
  pid_t process_ = -1;
  int output_ = -1;
};

void expectRest(const Delivered& delivered, std::size_t cells) {
  ASSERT_EQ(delivered.skins.size(), 1U);
  EXPECT_EQ(delivered.skins[0].neighbors.size(), cells);
  for (const SampleFrame& frame : delivered.frames) {
    ASSERT_EQ(frame.samples.size(), cells);
    for (const CellSample& sample : frame.samples) {
      EXPECT_NEAR(sample.acceleration_g.z(), 1, 0.1);
      EXPECT_NEAR(sample.acceleration_g.head<2>().norm(), 0, 0.1);
    }
  }
}

void expectDeviceOnTcp(std::vector<std::string> command, std::size_t cells) {
  const Program program(std::move(command), STDERR_FILENO);
  const std::string line = program.readLine();
  const std::size_t at = line.find("tcp://");
  ASSERT_NE(at, std::string::npos) << line;
  CollectingListener listener;
  WireOptions patient;
  patient.silent_after = patient.reconnect_after = patient.command_timeout = test::kForever;
  WireSource source(line.substr(at), patient);
  source.start(listener);
  ASSERT_TRUE(listener.waitFor([](const Delivered& d) { return d.frames.size() >= 20; })) << "nothing came";
  const std::uint32_t led = source.send(SetLed{CellId(1), 255, 0, 0});
  const std::uint32_t rate = source.send(SetRate{50});
  ASSERT_TRUE(listener.waitFor(
      [&](const Delivered& d) { return d.outcomeOf(led) != nullptr && d.outcomeOf(rate) != nullptr; }));
  EXPECT_TRUE(listener.delivered().outcomeOf(led)->done);
  EXPECT_FALSE(listener.delivered().outcomeOf(rate)->done);
  EXPECT_NE(listener.delivered().outcomeOf(rate)->message.english().find("only light"), std::string::npos);
  source.stop();
  expectRest(listener.delivered(), cells);
  const SourceStatus status = listener.delivered().status();
  EXPECT_EQ(status.rejected_messages + status.lost_samples + status.late_frames + status.unknown_samples, 0U);
}

void expectDeviceOnStdin(std::vector<std::string> command, std::size_t cells) {
  const Program program(std::move(command), STDOUT_FILENO);
  CollectingListener listener;
  StdinSource source(program.output());
  source.start(listener);
  ASSERT_TRUE(listener.waitFor([](const Delivered& d) { return d.frames.size() >= 20; })) << "nothing came";
  source.stop();
  expectRest(listener.delivered(), cells);
  EXPECT_EQ(listener.delivered().status().rejected_messages, 0U);
}

const std::string kFolder = HEXODERM_SKINWIRE_SOURCES;

TEST(ExampleSender, InCIsASkinOnTcp) { expectDeviceOnTcp({HEXODERM_C_SENDER, "0"}, 2); }

TEST(ExampleSender, InPythonIsASkinOnTcp) {
  expectDeviceOnTcp({"python3", kFolder + "/examples/sender.py", "--port", "0"}, 3);
}

TEST(ExampleSender, InPythonIsASkinOnStandardOutput) {
  expectDeviceOnStdin({"python3", kFolder + "/examples/sender.py"}, 3);
}

/// The first piece of a page in this language.
std::string exampleIn(const std::string& page, const std::string& language) {
  const std::string text = readFile(kFolder + "/" + page);
  const std::string fence = "```" + language + "\n";
  const std::size_t begin = text.find(fence);
  if (begin == std::string::npos) throw std::runtime_error("no " + language + " in " + page);
  return text.substr(begin + fence.size(), text.find("```", begin + fence.size()) - begin - fence.size());
}

TEST(ExampleSender, TheScriptInTheReadmeIsASkin) {
  expectDeviceOnStdin({"python3", "-c", exampleIn("README.md", "python")}, 2);
}

TEST(ExampleCell, TheCellModelOnThePageIsOne) {
  std::string text = exampleIn("build_a_cell.md", "json");
  EXPECT_EQ(cellModelFromJson(text, "page").accelerometer.lsb_g, 0.001);
  const std::string upright = "[1, 0, 0, 0]";
  ASSERT_NE(text.find(upright), std::string::npos);
  text.replace(text.find(upright), upright.size(), "[0.70710678, 0, 0, 0.70710678]");
  const Eigen::Vector3d x_u = cellModelFromJson(text, "page").accelerometer.T_u_a.R * Eigen::Vector3d::UnitX();
  EXPECT_NEAR(x_u.y(), 1, 1e-9);
}

}  // namespace
}  // namespace hexoderm
