// A calibration from a microcontroller: the example firmware with skinwire.h, on a Cortex-M3 that QEMU emulates, whose
// serial port is a pseudo-terminal.

#include "hexoderm/base/se3.h"
#include "hexoderm/base/units.h"
#include "hexoderm/device/skinwire/examples/firmware/skin.h"
#include "hexoderm/io/calibration_json.h"
#include "hexoderm/session/session_store.h"
#include "tests/app/cli/cli_program.h"
#include "tests/core/device/skinwire/wire_messages.h"
#include "tests/core/device/sources/loopback_device.h"
#include "tests/core/device/sources/wire_host.h"
#include "tests/support/child_process.h"

namespace hexoderm {
namespace {

/// The emulated board with the firmware, from power-up to the end of the test.
struct Board : test::ChildProcess {
  Board()
      : ChildProcess({HEXODERM_QEMU, "-M", "mps2-an385", "-kernel", HEXODERM_FIRMWARE, "-display", "none", "-monitor",
                      "none", "-serial", "pty"},
                     ".", Stream::Read, Stream::AsOutput) {
    // "char device redirected to /dev/pts/3 (label serial0)"
    const std::string beginning = "redirected to ";
    for (std::string line = readLine(); !line.empty(); line = readLine()) {
      said += line + '\n';
      const std::size_t at = line.find(beginning);
      if (at == std::string::npos) continue;
      const std::string rest = line.substr(at + beginning.size());
      address = "serial:" + rest.substr(0, rest.find(' '));
      break;
    }
  }
  std::string address;  ///< empty if QEMU did not start; then `said` tells why
  std::string said;
};

CellId idOf(std::size_t cell) { return CellId(static_cast<std::uint32_t>(cell + 1)); }
PortNumber numberOf(std::size_t port) { return PortNumber(static_cast<std::uint32_t>(port + 1)); }

/// The neighbours that the firmware has to find: every port of every cell is listed.
NeighborList trueNeighbors() {
  NeighborList cells;
  for (std::size_t cell = 0; cell < SKIN_CELLS; ++cell) {
    CellReport& report = cells.emplace_back(CellReport{idOf(cell), "", {}});
    for (std::size_t port = 0; port < SKIN_PORTS; ++port) report.neighbors.push_back({numberOf(port), CellId(0), {}});
  }
  for (const skin_link& link : skin_links) {
    cells.at(link.cell).neighbors.at(link.port) = {numberOf(link.port), idOf(link.other_cell),
                                                   numberOf(link.other_port)};
    cells.at(link.other_cell).neighbors.at(link.other_port) = {numberOf(link.other_port), idOf(link.cell),
                                                               numberOf(link.port)};
  }
  return cells;
}

/// How the firmware's cell is turned in the part.
Eigen::Matrix3d firmwareRotation(std::size_t cell) {
  using Rows = Eigen::Matrix<std::int16_t, 3, 3, Eigen::RowMajor>;
  return Eigen::Map<const Rows>(&skin_rotation[cell][0][0]).cast<double>() / SKIN_ONE;
}

class Microcontroller : public Cli {
 protected:
  void SetUp() override {
    ASSERT_FALSE(std::string(HEXODERM_FIRMWARE).empty() || std::string(HEXODERM_QEMU).empty())
        << "there is no arm-none-eabi-gcc or no qemu-system-arm: packaging/setup.sh --tests installs them";
  }
};

TEST_F(Microcontroller, IsCapturedAndSolved) {
  const Board board;
  ASSERT_FALSE(board.address.empty()) << board.said;
  const auto json = jsonOf("capture --source " + board.address + " --auto --poses 3 --timeout 600 --json -o arm.hexo");
  EXPECT_EQ(json.at("device"), "seven cells on a Cortex-M3");
  EXPECT_EQ(json.at("cells"), SKIN_CELLS);
  EXPECT_EQ(json.at("poses"), 3);
  EXPECT_EQ(json.at("rejected_messages"), 0);
  EXPECT_TRUE(json.at("offences").empty()) << json.at("offences");
  EXPECT_EQ(readSessionStore(path("arm.hexo")).neighbors(), trueNeighbors());
  ASSERT_EQ(run("solve arm.hexo -o arm.calibration.json").exit_code, 0);
  const auto result = readCalibrationJson(path("arm.calibration.json"));
  for (const skin_link& link : skin_links) {
    const LinkEstimate* found =
        result->findLink({idOf(link.cell), numberOf(link.port)}, {idOf(link.other_cell), numberOf(link.other_port)});
    ASSERT_TRUE(found && found->source.cell == idOf(link.cell));
    const Eigen::Matrix3d R_c_n = firmwareRotation(link.cell).transpose() * firmwareRotation(link.other_cell);
    EXPECT_LT(toDegrees(rotationAngle(found->R_c_n.transpose() * R_c_n)), 2) << "from cell " << link.cell + 1;
  }
}

TEST_F(Microcontroller, AnswersCommands) {
  using Delivered = CollectingListener::Delivered;
  const Board board;
  ASSERT_FALSE(board.address.empty()) << board.said;
  WireHost host(board.address);
  ASSERT_TRUE(host.waitForFrames(20)) << "nothing came";
  EXPECT_EQ(host.listener.delivered().skins.at(0).neighbors, trueNeighbors());

  const auto outcomeOf = [&](const SkinCommand& command) {
    const CommandOutcome outcome = host.ask(command);
    return outcome.done ? "done" : outcome.message.english();
  };
  EXPECT_EQ(outcomeOf(SetLed{CellId(7), 255, 0, 16}), "done");
  EXPECT_EQ(outcomeOf(SetLed{CellId(8), 255, 0, 16}), "there is no such cell");
  EXPECT_EQ(outcomeOf(SetRate{1000}), "the rate is 1 to 200 Hz");
  EXPECT_EQ(outcomeOf(ExploreAgain{}), "done");
  const std::uint32_t first_turn = host.source->send(TurnTo{CellId(2), Eigen::Vector3d::UnitX()});
  EXPECT_EQ(outcomeOf(TurnTo{CellId(2), -Eigen::Vector3d::UnitX()}), "done");
  const Delivered turned = host.listener.delivered();
  ASSERT_NE(turned.outcomeOf(first_turn), nullptr);
  EXPECT_EQ(turned.outcomeOf(first_turn)->message.english(), "another turn was asked for");

  EXPECT_EQ(outcomeOf(SetRate{50}), "done");
  const std::size_t before = host.listener.delivered().frames.size();
  ASSERT_TRUE(host.waitForFrames(before + 20));
  host.source->stop();
  const Delivered delivered = host.listener.delivered();
  // Between two messages a busy computer may leave a gap; the ticks of a message follow each other.
  double shortest_s = 1;
  for (std::size_t k = before + 1; k < delivered.frames.size(); ++k) {
    shortest_s = std::min(shortest_s, delivered.frames[k].time_s - delivered.frames[k - 1].time_s);
  }
  EXPECT_NEAR(shortest_s, 0.02, 1e-9);
  // Cell 2 was turned upside down about its x axis.
  const SampleFrame& last = delivered.frames.back();
  ASSERT_EQ(last.samples.size(), std::size_t{SKIN_CELLS});
  EXPECT_NEAR(last.samples[1].acceleration_g.x(), -1, 0.1);
  EXPECT_EQ(delivered.skins.size(), 1U) << "the same cells were found again";
  EXPECT_EQ(delivered.status().rejected_messages, 0U);
  EXPECT_EQ(delivered.status().lost_samples, 0U);
}

TEST_F(Microcontroller, ACommandThatComesAgainIsNotBegunAnew) {
  const Board board;
  ASSERT_FALSE(board.address.empty()) << board.said;
  const std::string port = board.address.substr(std::string("serial:").size());
  SerialEnd host(::open(port.c_str(), O_RDWR | O_NOCTTY | O_CLOEXEC));
  const skinwire::Bytes turn = skinwire::encodeFrame(
      skinwire::Framing::Cobs, skinwire::Command{7, skinwire::TurnTo{2, -Eigen::Vector3d::UnitX()}});
  const skinwire::Bytes back = skinwire::encodeFrame(
      skinwire::Framing::Cobs, skinwire::Command{7, skinwire::TurnTo{2, Eigen::Vector3d::UnitX()}});
  host.sendBytes(skinwire::joined({turn, turn}));  // in one piece: the board turns for little more than a second
  const skinwire::Ack working{7, false, "", true};
  EXPECT_EQ(host.receive<skinwire::Ack>(), working) << "the second one is answered at once";
  const auto nextThatIsOver = [&] {
    skinwire::Ack ack = working;
    while (ack == working) ack = host.receive<skinwire::Ack>();
    return ack;
  };
  EXPECT_EQ(nextThatIsOver(), (skinwire::Ack{7, true, "", false}));
  // The same number from a host that starts anew is another command.
  host.sendBytes(skinwire::joined({turn, back}));
  EXPECT_EQ(nextThatIsOver(), (skinwire::Ack{7, false, "another turn was asked for", false}));
}

}  // namespace
}  // namespace hexoderm
