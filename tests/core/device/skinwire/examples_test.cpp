// The example senders, as people start them.

#include "hexoderm/base/file.h"
#include "hexoderm/device/sources/stdin_source.h"
#include "hexoderm/skin/cell_model.h"
#include "tests/core/device/sources/wire_host.h"
#include "tests/support/child_process.h"
#include "tests/support/paths.h"
#include "tests/support/testing.h"

#include <stdexcept>

namespace hexoderm {
namespace {

using Delivered = CollectingListener::Delivered;
using test::ChildProcess;

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
  const ChildProcess program(std::move(command), ".", ChildProcess::Stream::Read, ChildProcess::Stream::AsOutput);
  const std::string line = program.readLine();
  const std::size_t at = line.find("tcp://");
  ASSERT_NE(at, std::string::npos) << line;
  WireHost host(line.substr(at));
  ASSERT_TRUE(host.waitForFrames(20)) << "nothing came";
  EXPECT_TRUE(host.ask(SetLed{CellId(1), 255, 0, 0}).done);
  const CommandOutcome rate = host.ask(SetRate{50});
  EXPECT_FALSE(rate.done);
  EXPECT_NE(rate.message.english().find("only light"), std::string::npos);
  host.source->stop();
  expectRest(host.listener.delivered(), cells);
  const SourceStatus status = host.listener.delivered().status();
  EXPECT_EQ(status.rejected_messages + status.lost_samples + status.late_frames + status.unknown_samples, 0U);
}

void expectDeviceOnStdin(std::vector<std::string> command, std::size_t cells) {
  const ChildProcess program(std::move(command));
  CollectingListener listener;
  const auto source = stdinSource(program.output());
  source->start(listener);
  ASSERT_TRUE(listener.waitFor([](const Delivered& d) { return d.frames.size() >= 20; })) << "nothing came";
  source->stop();
  expectRest(listener.delivered(), cells);
  EXPECT_EQ(listener.delivered().status().rejected_messages, 0U);
}

const std::string kFolder = HEXODERM_SKINWIRE_SOURCES;

TEST(ExampleSender, InCIsASkinOnTcp) { expectDeviceOnTcp({HEXODERM_C_SENDER, "0"}, 2); }

TEST(ExampleSender, InPythonIsASkinOnTcp) {
  expectDeviceOnTcp({"/usr/bin/env", "python3", kFolder + "/examples/sender.py", "--port", "0"}, 3);
}

TEST(ExampleSender, InPythonIsASkinOnStandardOutput) {
  expectDeviceOnStdin({"/usr/bin/env", "python3", kFolder + "/examples/sender.py"}, 3);
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
  expectDeviceOnStdin({"/usr/bin/env", "python3", "-c", exampleIn("README.md", "python")}, 2);
}

TEST(ExampleCell, TheCellModelOnThePageIsOne) {
  const std::string text = exampleIn("build_a_cell.md", "json");
  EXPECT_EQ(cellModelFromJson(text, "page").accelerometer.lsb_g, 0.001);
  const std::string turned = replaced(text, "[1, 0, 0, 0]", "[0.70710678, 0, 0, 0.70710678]");
  const Eigen::Vector3d x_u = cellModelFromJson(turned, "page").accelerometer.T_u_a.R * Eigen::Vector3d::UnitX();
  EXPECT_NEAR(x_u.y(), 1, 1e-9);
}

}  // namespace
}  // namespace hexoderm
