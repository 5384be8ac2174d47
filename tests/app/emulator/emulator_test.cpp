// The emulator as a user would start it, and the library's own source as its host.

#include "hexoderm/base/text.h"
#include "hexoderm/device/skinwire/framing.h"
#include "hexoderm/sim/exploration.h"
#include "hexoderm/sim/simulated_skin.h"

#include "tests/app/emulator/emulator_program.h"
#include "tests/core/device/sources/wire_host.h"
#include "tests/support/options.h"

#include <boost/asio/io_context.hpp>
#include <boost/asio/ip/tcp.hpp>
#include <boost/asio/ip/udp.hpp>

namespace hexoderm {
namespace {

using std::chrono::milliseconds;
using Delivered = CollectingListener::Delivered;

struct Host : WireHost {
  using WireHost::WireHost;

  bool waitForNewFrames(std::size_t count) { return waitForFrames(listener.delivered().frames.size() + count); }
  /// A status that came after the first `earlier` ones; it may have gone again before a busy computer looks.
  bool waitForStatus(const std::function<bool(const SourceStatus&)>& is_it, std::size_t earlier = 0) {
    return listener.waitFor([&](const Delivered& d) {
      return std::any_of(d.statuses.begin() + static_cast<std::ptrdiff_t>(earlier), d.statuses.end(), is_it);
    });
  }
  std::size_t statusesSoFar() { return listener.delivered().statuses.size(); }
};

/// The topology that the emulator should report of its skin.
NeighborList trueTopology() {
  const SimulatedSkin skin(builtInCellModel("hex-bma150"),
                           test::with(SimulatedSkinOptions(), &SimulatedSkinOptions::patch, "ring8"));
  NeighborList cells = skin.neighbors();
  const LinkEnd interface_at = firstFreePorts(cells, skin.model()).at(0);
  cells[0].neighbors.push_back({interface_at.port, skin.model().interface_id, PortNumber(1)});
  std::ranges::sort(cells[0].neighbors, {}, &NeighborReport::port);
  return cells;
}

/// Few samples at four times the pace of life: the part is soon there, and a computer that is busy, or runs the
/// programs under a sanitizer, keeps up.
constexpr double kRate_hz = 100;
std::vector<std::string> ring8(std::vector<std::string> wire) {
  for (const char* word : {"--patch", "ring8", "--ideal", "--speed", "4", "--rate", "100"}) wire.emplace_back(word);
  return wire;
}

std::int64_t tickOf(const SampleFrame& frame) { return std::llround(frame.time_s * kRate_hz); }

/// The newest `count` frames follow each other tick by tick.
bool areInARow(const std::vector<SampleFrame>& frames, std::size_t count) {
  return frames.size() >= count &&
         tickOf(frames.back()) - tickOf(frames[frames.size() - count]) == static_cast<std::int64_t>(count) - 1;
}

/// The whole of what a host does, on any wire.
void talk(const Emulator& emulator, std::size_t cells) {
  Host host(emulator.address);
  // A computer that stands still for a moment makes the device leave out samples, but never for long.
  ASSERT_TRUE(host.listener.waitFor([](const Delivered& d) { return areInARow(d.frames, 100); }));
  {
    const Delivered delivered = host.listener.delivered();
    ASSERT_THAT(delivered.skins, SizeIs(1));
    EXPECT_EQ(delivered.skins[0].neighbors, trueTopology());
    EXPECT_TRUE(delivered.skins[0].can_turn && delivered.skins[0].can_light_cells);
    EXPECT_THAT(delivered.skins[0].device.english(), HasSubstr("emulated"));
    for (std::size_t k = 1; k < delivered.frames.size(); ++k) {
      EXPECT_THAT(delivered.frames[k].samples, SizeIs(cells));
      const double step_s = delivered.frames[k].time_s - delivered.frames[k - 1].time_s;
      EXPECT_GE(step_s, 1 / kRate_hz - 1e-6);
      EXPECT_NEAR(step_s * kRate_hz, std::round(step_s * kRate_hz), 1e-4) << "whole ticks";
    }
  }

  const Eigen::Vector3d up_u = Eigen::Vector3d(1, 1, 0).normalized();
  EXPECT_TRUE(host.ask(TurnTo{CellId(3), up_u}).done);
  ASSERT_TRUE(host.waitForNewFrames(20));
  const SampleFrame frame = host.listener.delivered().frames.back();
  EXPECT_LT((frame.samples.at(2).acceleration_g - up_u).norm(), 0.01) << "an ideal skin turns exactly";

  EXPECT_TRUE(host.ask(SetLed{CellId(7), 255, 0, 16}).done);
  EXPECT_EQ(emulator.type("led 7"), "cell 7 #ff0010");
  EXPECT_THAT(host.ask(SetLed{CellId(70), 1, 1, 1}).message.english(), HasSubstr("no cell 70"));
  host.source->stop();
  const Delivered all = host.listener.delivered();
  const SourceStatus status = all.status();
  // The missing samples are reported, to the sample.
  const auto ticks = static_cast<std::size_t>(tickOf(all.frames.back()) - tickOf(all.frames.front()) + 1);
  EXPECT_EQ(cells * all.frames.size() + status.lost_samples, cells * ticks);
  EXPECT_EQ(status.rejected_messages, 0U);
  EXPECT_EQ(status.late_frames, 0U);
  EXPECT_EQ(status.unknown_samples, 0U);
}

struct Wire {
  const char* name;
  std::vector<std::string> options;
  const char* address_begins;
  int hosts = 1;  ///< one after the other
};

class EmulatorOnAWire : public testing::TestWithParam<Wire> {};

TEST_P(EmulatorOnAWire, IsASkin) {
  const Emulator emulator(ring8(GetParam().options));
  EXPECT_THAT(emulator.address, StartsWith(GetParam().address_begins));
  EXPECT_THAT(emulator.about, HasSubstr("8 cells"));
  for (int k = 0; k < GetParam().hosts; ++k) talk(emulator, 8);
}

INSTANTIATE_TEST_SUITE_P(Wires, EmulatorOnAWire,
                         testing::Values(Wire{"Tcp", {"--tcp", "0"}, "tcp://127.0.0.1:", 2},
                                         Wire{"TcpInLines", {"--tcp", "0", "--json"}, "tcp://127.0.0.1:"},
                                         Wire{"Udp", {"--udp", "0"}, "udp://127.0.0.1:", 2},
                                         Wire{"PseudoTerminal", {"--pty"}, "serial:/dev/pts/"}),
                         [](const auto& wire) { return std::string(wire.param.name); });

TEST(Emulator, IsARobotThatSaysWhereItsJointsStand) {
  const Emulator emulator({"--tcp", "0", "--robot", "demo", "--ideal", "--speed", "4", "--rate", "100"});
  EXPECT_THAT(emulator.about, AllOf(HasSubstr("demo_arm"), HasSubstr("34 cells")));
  Host host(emulator.address);
  ASSERT_TRUE(host.listener.waitFor([](const Delivered& d) { return d.joints.size() >= 3; }));
  const JointAngles first = host.listener.delivered().joints.front().angles;
  EXPECT_THAT(first.positions, SizeIs(5));

  EXPECT_EQ(emulator.type("pose"), "turning");
  ASSERT_TRUE(host.listener.waitFor([&](const Delivered& d) { return d.joints.back().angles != first; }));
  EXPECT_EQ(host.listener.delivered().status().rejected_messages, 0U);
  EXPECT_THAT(emulator.type("turn 1 0 0"), StartsWith("error: the robot's base is fixed"));
  EXPECT_THAT(emulator.type("break dead 20"), HasSubstr("cell 20 is broken: dead"));
}

// What the skin does then is for EmulatedDevice's tests.
TEST(Emulator, CellsBreakAndAreMendedByWhatIsTyped) {
  const Emulator emulator({"--tcp", "0", "--fault", "no-samples:2"});
  Host host(emulator.address);
  ASSERT_TRUE(host.waitForFrames(1));
  struct Typed {
    const char* line;
    const char* answer;
    std::size_t cells;  // that send after it
  };
  const Typed all_typed[] = {{"turn 1 0 0", "turning", 16},
                             {"mend 2", "whole", 17},
                             {"break no-samples 5", "cell 5 is broken: no-samples", 16},
                             {"mend 5", "whole", 17},
                             {"break wrong-port 3 1", "starts again", 17},
                             {"mend 3 1", "whole", 17},
                             {"break no-answer 5", "explore again", 17}};
  for (const Typed& typed : all_typed) {
    EXPECT_THAT(emulator.type(typed.line), HasSubstr(typed.answer)) << typed.line;
    const auto typedCellsSend = [&](const Delivered& d) { return d.frames.back().samples.size() == typed.cells; };
    EXPECT_TRUE(host.listener.waitFor(typedCellsSend)) << typed.line;
  }
}

TEST(Emulator, TheWireHasFaults) {
  const Emulator emulator({"--tcp", "0", "--ideal", "--patch", "ring8", "--rate", "200"});
  WireOptions quick = patient();
  quick.silent_after = milliseconds(200);
  quick.reconnect_after = milliseconds(1000);
  Host host(emulator.address, quick);
  ASSERT_TRUE(host.waitForFrames(50));

  const std::pair<std::string, std::function<bool(const SourceStatus&)>> faults[] = {
      {"drop 50%", [](const SourceStatus& s) { return s.lost_samples > 0; }},
      {"silence on", [](const SourceStatus& s) { return s.state == SourceState::Silent; }},
      {"garble on", [](const SourceStatus& s) { return s.rejected_messages > 0; }},
      {"disconnect", [](const SourceStatus& s) { return s.state == SourceState::Connecting; }}};
  for (const auto& [typed, shows] : faults) {
    const std::size_t earlier = host.statusesSoFar();
    EXPECT_THAT(emulator.type(typed), StartsWith(typed));
    EXPECT_TRUE(host.waitForStatus(shows, earlier)) << typed;
    if (typed != "disconnect") emulator.type(typed.substr(0, typed.find(' ')) + " off");
    EXPECT_TRUE(host.waitForNewFrames(50)) << typed;
  }
  // After garbled bytes, and where it was disconnected.
  EXPECT_TRUE(host.waitForStatus([](const SourceStatus& s) { return s.reconnects >= 2; }));
}

TEST(Emulator, GarbledBytesOnASerialPortCostTheirFrameOnly) {
  const Emulator emulator({"--pty", "--ideal", "--patch", "ring8"});
  Host host(emulator.address);
  ASSERT_TRUE(host.waitForFrames(20));
  emulator.type("garble 30%");
  EXPECT_TRUE(host.waitForStatus([](const SourceStatus& s) { return s.rejected_messages > 2; }));
  emulator.type("garble off");
  EXPECT_TRUE(host.waitForNewFrames(50));
  EXPECT_EQ(host.listener.delivered().status().reconnects, 0U);
}

/// A connection that does only what it is told to: it neither reads nor sends by itself.
template <class Protocol>
class BareHost {
 public:
  explicit BareHost(const std::string& address) {
    const auto port = static_cast<std::uint16_t>(std::stoul(address.substr(address.rfind(':') + 1)));
    socket_.connect({boost::asio::ip::address_v4::loopback(), port});
  }

  void describe() {
    const skinwire::Command command{0, skinwire::Describe{}};
    constexpr bool kIsTcp = std::is_same_v<Protocol, boost::asio::ip::tcp>;
    socket_.send(boost::asio::buffer(kIsTcp ? skinwire::encodeFrame(skinwire::Framing::Length, command)
                                            : skinwire::encodeBody(command)));
  }
  /// Waits for something to come; false at the end of the connection.
  [[nodiscard]] bool hears() {
    std::array<char, 1> byte{};
    boost::system::error_code error;
    return socket_.receive(boost::asio::buffer(byte), 0, error) > 0;
  }
  [[nodiscard]] bool hasHeard() const { return socket_.available() > 0; }

 private:
  boost::asio::io_context io_;
  typename Protocol::socket socket_{io_};
};
using BareTcpHost = BareHost<boost::asio::ip::tcp>;
using BareUdpHost = BareHost<boost::asio::ip::udp>;

TEST(Emulator, AConnectionThatSaysNothingGivesWayToTheNext) {
  const Emulator emulator(ring8({"--tcp", "0"}));
  BareTcpHost silent(emulator.address);
  ASSERT_TRUE(silent.hears()) << "it is served, as nobody else is there";
  Host host(emulator.address);
  ASSERT_TRUE(host.waitForFrames(100));
  while (silent.hears()) continue;  // until it was closed

  // The host has said that it is one, and is not disturbed.
  const std::uint64_t reconnects = host.listener.delivered().status().reconnects;
  BareTcpHost next(emulator.address);
  ASSERT_TRUE(host.waitForNewFrames(200));
  EXPECT_FALSE(next.hasHeard());
  EXPECT_EQ(host.listener.delivered().status().reconnects, reconnects);
  host.source->stop();
  EXPECT_TRUE(next.hears()) << "it waited until the host had gone";
}

TEST(Emulator, OverUdpOnlyTheHostIsAnswered) {
  const Emulator emulator(ring8({"--udp", "0"}));
  BareUdpHost host(emulator.address);
  host.describe();
  ASSERT_TRUE(host.hears());
  BareUdpHost other(emulator.address);
  other.describe();
  // What the host asks after that is answered after that.
  host.describe();
  for (int k = 0; k < 200; ++k) ASSERT_TRUE(host.hears());
  EXPECT_FALSE(other.hasHeard());
  // The host is gone when it asks no more.
  const auto until = std::chrono::steady_clock::now() + test::kPatience;
  while (!other.hasHeard() && std::chrono::steady_clock::now() < until) {
    other.describe();
    ::poll(nullptr, 0, 100);
  }
  EXPECT_TRUE(other.hasHeard());
}

TEST(Emulator, NeverWaitsForAHostThatDoesNotReadAndLeavesItForTheNext) {
  // 50 times as fast, 300 cells: what the network holds for a host is full at once.
  const Emulator emulator({"--tcp", "0", "--patch", "sheet:15x20", "--speed", "50"});
  BareTcpHost stuck(emulator.address);
  stuck.describe();
  ASSERT_TRUE(stuck.hears());
  const auto dropped = [&] {
    const std::string status = emulator.type("status");
    const std::size_t at = status.find("dropped ");
    return at == std::string::npos ? 0UL : std::stoul(status.substr(at + 8));
  };
  const auto until = std::chrono::steady_clock::now() + test::kPatience;
  while (dropped() == 0 && std::chrono::steady_clock::now() < until) ::poll(nullptr, 0, 20);
  EXPECT_GT(dropped(), 0U);
  Host host(emulator.address);
  EXPECT_TRUE(host.waitForFrames(10));
}

TEST(Emulator, SaysWhatItDoesNotUnderstand) {
  Emulator emulator({"--tcp", "0"});
  const std::string wrong =
      "nonsense|break|break dead|break dead x|break dead 99|break rotten 3|break joint 1 9|break wrong-port 99 1|mend "
      "99|"
      "mend 3 1|drop|drop 120%|drop x|silence 20%|turn 0 0 0|turn 1 2|turn 1 2 nan|led 0|led x|status please";
  for (const std::string& line : split(wrong, '|')) {
    EXPECT_THAT(emulator.type(line), StartsWith("error: ")) << line;
  }
  EXPECT_THAT(emulator.type("help"), HasSubstr("standard input"));
  emulator.closeInput();  // which is no reason to end
  Host host(emulator.address);
  EXPECT_TRUE(host.waitForFrames(1));
}

TEST(Emulator, EndsWithTheCodesOfTheOtherPrograms) {
  Emulator emulator({"--tcp", "0"});
  const std::string port = emulator.address.substr(emulator.address.rfind(':') + 1);
  const std::pair<const char*, int> cases[] = {
      {"", 2},
      {"--help", 0},
      {"--tcp 0 --pty", 2},
      {"--udp 0 --json", 2},
      {"--tcp 0 --patch blob", 2},
      {"--tcp 0 --rate 5000", 2},
      {"--tcp 0 --fault rotten:1", 2},
      {"--tcp 0 --bind nowhere", 2},
      {"--tcp 0 --robot none.urdf --mount a:0,0,0", 3},
      {"--tcp 0 --robot none.urdf", 2},
      {"--tcp 0 --robot demo --mount fore_arm:0,0,0", 2},
      {"--tcp 0 --robot demo --base table", 2},
      {"--tcp 0 --mount forearm:0,0,0", 2},
  };
  const auto codeOf = [](const std::string& line) {
    return Program(line.empty() ? std::vector<std::string>() : split(line, ' ')).wait();
  };
  EXPECT_EQ(codeOf("--tcp " + port), 4) << "the port is taken";
  for (const auto& [line, code] : cases) EXPECT_EQ(codeOf(line), code) << line;
  EXPECT_EQ(emulator.type("quit"), "bye");
  EXPECT_EQ(emulator.wait(), 0);
}

}  // namespace
}  // namespace hexoderm
