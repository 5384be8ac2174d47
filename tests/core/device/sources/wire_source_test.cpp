#include "hexoderm/device/sources/wire_source.h"

#include "hexoderm/device/sources/recording.h"
#include "hexoderm/util/error.h"
#include "tests/core/device/skinwire/collecting_listener.h"
#include "tests/core/device/skinwire/wire_messages.h"
#include "tests/core/device/sources/loopback_device.h"
#include "tests/support/temporary_folder.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <algorithm>
#include <filesystem>
#include <iterator>

namespace hexoderm {
namespace {

using skinwire::Framing;
using std::chrono::milliseconds;
using testing::HasSubstr;
using Delivered = CollectingListener::Delivered;

/// Everything in a tenth of the time, for tests that wait for time-outs.
WireOptions quick() {
  return {milliseconds(10),  milliseconds(100), milliseconds(150),
          milliseconds(300), milliseconds(50),  milliseconds(300)};
}

/// Runs a test of timing with more and more patience, until `passes(options)`; false if no patience helps. A computer
/// that stands still for a moment looks like a device that does.
template <class Test>
bool passesWithPatience(const Test& passes) {
  for (const int times : {1, 5, 25}) {
    WireOptions options = quick();
    options.silent_after *= times;
    options.reconnect_after *= times;
    options.command_timeout *= times;
    if (passes(options)) return true;
  }
  return false;
}

/// Options for tests in which nothing may time out: every event has another reason.
WireOptions patient() {
  WireOptions options;
  options.first_retry = milliseconds(10);
  options.silent_after = options.reconnect_after = options.command_timeout = test::kForever;
  return options;
}

template <class Device>
void describe(Device& device) {
  device.send(skinwire::helloMessage());
  device.send(skinwire::topologyMessage());
}

auto frames(std::size_t count) {
  return [count](const Delivered& d) { return d.frames.size() >= count; };
}
/// It has been so: it may have changed again before a busy computer looks.
auto state(SourceState wanted) {
  return [wanted](const Delivered& d) { return d.sawState(wanted); };
}
auto status(SourceState wanted, std::string text) {
  return [wanted, text = std::move(text)](const Delivered& d) { return d.saw(wanted, text); };
}
auto outcome(std::uint32_t command) {
  return [command](const Delivered& d) { return d.outcomeOf(command) != nullptr; };
}

TEST(WireSource, DeliversFromTcpInBothDialects) {
  for (const Framing framing : {Framing::Length, Framing::Lines}) {
    TcpDevice device;
    CollectingListener listener;
    WireSource source(device.address(), patient());
    source.start(listener);
    DeviceConnection connection = device.accept(framing);
    ASSERT_TRUE(listener.waitFor(state(SourceState::Waiting)));
    describe(connection);
    connection.send(skinwire::rawSamples(0, 1000));
    connection.send(skinwire::rawSamples(4, 3000));
    ASSERT_TRUE(listener.waitFor(frames(4)));
    ASSERT_TRUE(listener.waitFor(state(SourceState::Streaming)));
    source.stop();
    const Delivered delivered = listener.delivered();
    EXPECT_EQ(delivered.skins.size(), 1U);
    EXPECT_EQ(delivered.status().state, SourceState::Stopped);
    EXPECT_EQ(delivered.status().frames, 4U);
    EXPECT_EQ(delivered.status().lost_samples, 0U);
    EXPECT_EQ(delivered.statuses.front().state, SourceState::Connecting);
  }
}

TEST(WireSource, FindsAHostByName) {
  TcpDevice device;
  CollectingListener listener;
  WireSource source(device.address("localhost"), patient());
  source.start(listener);
  DeviceConnection connection = device.accept();
  describe(connection);
  EXPECT_TRUE(listener.waitFor(state(SourceState::Streaming)));
}

TEST(WireSource, CommandsAreAnsweredByNumberInTheDevicesDialect) {
  for (const Framing framing : {Framing::Length, Framing::Lines}) {
    TcpDevice device;
    CollectingListener listener;
    WireSource source(device.address(), patient());
    source.start(listener);
    DeviceConnection connection = device.accept(framing);
    describe(connection);
    ASSERT_TRUE(listener.waitFor(state(SourceState::Streaming)));

    const std::uint32_t led = source.send(SetLed{CellId(7), 255, 0, 16});
    skinwire::Command command = connection.receive();
    EXPECT_EQ(command, (skinwire::Command{led, skinwire::SetLed{7, 255, 0, 16}}));
    connection.send(skinwire::Ack{led, false, "there is no cell 7", false});
    ASSERT_TRUE(listener.waitFor(outcome(led)));
    EXPECT_FALSE(listener.delivered().outcomeOf(led)->done);
    EXPECT_EQ(listener.delivered().outcomeOf(led)->message.english(), "there is no cell 7");

    const std::uint32_t turn = source.send(TurnTo{CellId(1), Eigen::Vector3d::UnitX()});
    const std::uint32_t rate = source.send(SetRate{500});
    const std::uint32_t explore = source.send(ExploreAgain{});
    EXPECT_EQ(connection.receive(), (skinwire::Command{turn, skinwire::TurnTo{1, Eigen::Vector3d::UnitX()}}));
    EXPECT_EQ(connection.receive(), (skinwire::Command{rate, skinwire::SetRate{500}}));
    EXPECT_EQ(connection.receive(), (skinwire::Command{explore, skinwire::ExploreAgain{}}));
    connection.send(skinwire::Ack{rate, true, "", false});
    connection.send(skinwire::Ack{turn, true, "", false});
    ASSERT_TRUE(listener.waitFor(outcome(turn)));
    EXPECT_TRUE(listener.delivered().outcomeOf(turn)->done);
    EXPECT_TRUE(listener.delivered().outcomeOf(rate)->done);
    EXPECT_EQ(listener.delivered().outcomeOf(explore), nullptr);
    source.stop();
    ASSERT_NE(listener.delivered().outcomeOf(explore), nullptr) << "what is not answered fails in the end";
    EXPECT_FALSE(listener.delivered().outcomeOf(explore)->done);
  }
}

TEST(WireSource, CommandsThatCantBeAnsweredFailAndSayWhy) {
  TcpDevice device;
  CollectingListener listener;
  WireSource source(device.address(), patient());
  const std::uint32_t early = source.send(SetRate{100});
  source.start(listener);
  ASSERT_TRUE(listener.waitFor(outcome(early)));
  EXPECT_THAT(listener.delivered().outcomeOf(early)->message.english(), HasSubstr("not connected"));

  DeviceConnection connection = device.accept();
  skinwire::Hello hello = skinwire::helloMessage();
  hello.can_light_cells = hello.can_turn = false;
  connection.send(hello);
  connection.send(skinwire::topologyMessage());
  ASSERT_TRUE(listener.waitFor(state(SourceState::Streaming)));
  const std::uint32_t led = source.send(SetLed{CellId(1), 0, 0, 0});
  const std::uint32_t turn = source.send(TurnTo{CellId(1), Eigen::Vector3d::UnitX()});
  const std::uint32_t senseless = source.send(SetRate{-1});
  const std::uint32_t unanswered = source.send(ExploreAgain{});
  ASSERT_TRUE(listener.waitFor(outcome(senseless)));
  EXPECT_THAT(listener.delivered().outcomeOf(led)->message.english(), HasSubstr("can't light"));
  EXPECT_THAT(listener.delivered().outcomeOf(turn)->message.english(), HasSubstr("can't turn"));
  EXPECT_THAT(listener.delivered().outcomeOf(senseless)->message.english(), HasSubstr("rate_hz"));
  EXPECT_EQ(listener.delivered().outcomeOf(unanswered), nullptr);
  connection.close();
  ASSERT_TRUE(listener.waitFor(outcome(unanswered)));
  EXPECT_THAT(listener.delivered().outcomeOf(unanswered)->message.english(), HasSubstr("connection was lost"));
}

TEST(WireSource, ADeviceThatSaysThatItIsAtItIsWaitedForLongerThanOneThatSaysNothing) {
  EXPECT_TRUE(passesWithPatience([](WireOptions options) {
    options.silent_after = options.reconnect_after = test::kForever;
    TcpDevice device;
    CollectingListener listener;
    WireSource source(device.address(), options);
    source.start(listener);
    DeviceConnection connection = device.accept();
    describe(connection);
    EXPECT_TRUE(listener.waitFor(state(SourceState::Streaming)));
    const std::uint32_t slow = source.send(ExploreAgain{});
    const std::uint32_t unanswered = source.send(SetRate{100});
    while (listener.delivered().outcomeOf(unanswered) == nullptr) {
      connection.send(skinwire::Ack{slow, false, "", true});
      DeviceConnection::pause(milliseconds(1));
    }
    const Delivered delivered = listener.delivered();
    EXPECT_THAT(delivered.outcomeOf(unanswered)->message.english(), HasSubstr("did not answer"));
    return delivered.outcomeOf(slow) == nullptr;
  }));
}

TEST(WireSource, ConnectsAgainWhenTheCableWasPulled) {
  TcpDevice device;
  CollectingListener listener;
  WireSource source(device.address(), patient());
  source.start(listener);
  std::optional<DeviceConnection> connection = device.accept();
  describe(*connection);
  connection->send(skinwire::rawSamples(100, 1'000'000));
  ASSERT_TRUE(listener.waitFor(frames(2)));
  connection.reset();
  // Not by a time-out: none comes.
  ASSERT_TRUE(listener.waitFor(status(SourceState::Connecting, "next try in")));

  connection = device.accept();
  describe(*connection);
  connection->send(skinwire::rawSamples(0, 1000));  // it was switched off and on
  ASSERT_TRUE(listener.waitFor(frames(4)));
  source.stop();
  const Delivered delivered = listener.delivered();
  EXPECT_EQ(delivered.skins.size(), 1U) << "the same skin";
  EXPECT_EQ(delivered.status().reconnects, 1U);
  EXPECT_EQ(delivered.status().lost_samples, 0U);
  EXPECT_EQ(delivered.status().late_frames, 0U);
}

TEST(WireSource, HalfAFrameIsNeverDelivered) {
  TcpDevice device;
  CollectingListener listener;
  WireSource source(device.address(), patient());
  source.start(listener);
  {
    DeviceConnection connection = device.accept();
    describe(connection);
    const skinwire::Bytes frame = skinwire::encodeFrame(Framing::Length, skinwire::rawSamples(0, 1000));
    connection.sendBytes(skinwire::ByteView(frame).first(frame.size() - 1));
  }
  DeviceConnection connection = device.accept();
  describe(connection);
  connection.send(skinwire::rawSamples(0, 9000));
  ASSERT_TRUE(listener.waitFor(frames(2)));
  EXPECT_EQ(listener.delivered().frames[0].time_s, 0.009);
}

TEST(WireSource, BrokenDataOnTcpIsNamedAndTheConnectionMadeAnew) {
  skinwire::Bytes wrong_crc = skinwire::encodeFrame(Framing::Length, skinwire::rawSamples(0, 1000));
  wrong_crc[10] ^= 4U;
  const skinwire::Bytes too_long = {0xFF, 0xFF, 0xFF, 0};
  const std::pair<skinwire::Bytes, const char*> cases[] = {{wrong_crc, "CRC"}, {too_long, "16777215"}};
  for (const auto& [bytes, why] : cases) {
    TcpDevice device;
    CollectingListener listener;
    WireSource source(device.address(), patient());
    source.start(listener);
    {
      DeviceConnection connection = device.accept();
      describe(connection);
      connection.sendBytes(bytes);
      ASSERT_TRUE(listener.waitFor(status(SourceState::Connecting, why)));
    }
    DeviceConnection connection = device.accept();
    describe(connection);
    connection.send(skinwire::rawSamples(0, 1000));
    ASSERT_TRUE(listener.waitFor(frames(2)));
    EXPECT_EQ(listener.delivered().frames.size(), 2U);
  }
}

TEST(WireSource, BrokenLinesAreCountedAndSkipped) {
  TcpDevice device;
  CollectingListener listener;
  WireSource source(device.address(), patient());
  source.start(listener);
  DeviceConnection connection = device.accept(Framing::Lines);
  describe(connection);
  const std::string garbage = "{\"samples\": {\"cells\": [1], \"acceleration_g\": [0, 0]}}\nhello?\n";
  connection.sendBytes(skinwire::Bytes(garbage.begin(), garbage.end()));
  connection.send(skinwire::rawSamples(0, 1000));
  ASSERT_TRUE(listener.waitFor(frames(2)));
  source.stop();
  EXPECT_EQ(listener.delivered().status().rejected_messages, 2U);
  EXPECT_EQ(listener.delivered().status().reconnects, 0U);
}

TEST(WireSource, AnotherMajorVersionIsNamedAndNotTriedAgain) {
  TcpDevice device;
  CollectingListener listener;
  WireSource source(device.address(), patient());
  source.start(listener);
  DeviceConnection connection = device.accept(Framing::Lines);
  const std::string line = "{\"major\": 2, \"hello\": {\"device\": \"of the future\"}}\n";
  connection.sendBytes(skinwire::Bytes(line.begin(), line.end()));
  ASSERT_TRUE(listener.waitFor(status(SourceState::Incompatible, "SkinWire 2, this program SkinWire 1")));
  // The tick that answers a command is one that did not connect; the first retry would have been due before.
  const std::uint32_t command = source.send(SetRate{1});
  ASSERT_TRUE(listener.waitFor(outcome(command)));
  source.stop();
  EXPECT_FALSE(device.hasCaller());
}

TEST(WireSource, SilenceIsSaidAndThenTheConnectionIsMadeAnew) {
  TcpDevice device;
  CollectingListener listener;
  WireSource source(device.address(), quick());
  source.start(listener);
  DeviceConnection silent = device.accept();
  describe(silent);
  ASSERT_TRUE(listener.waitFor(state(SourceState::Streaming)));
  ASSERT_TRUE(listener.waitFor(status(SourceState::Silent, "nothing came")));
  DeviceConnection connection = device.accept();
  describe(connection);
  connection.send(skinwire::rawSamples(0, 1000));
  EXPECT_TRUE(listener.waitFor(frames(2)));
  EXPECT_TRUE(listener.delivered().saw(SourceState::Connecting, "nothing came for"));
}

TEST(WireSource, AStatusNowAndThenIsNoSilence) {
  EXPECT_TRUE(passesWithPatience([](const WireOptions& options) {
    TcpDevice device;
    CollectingListener listener;
    WireSource source(device.address(), options);
    source.start(listener);
    DeviceConnection connection = device.accept();
    describe(connection);
    // Longer than the time after which the connection would be made again.
    const auto end = std::chrono::steady_clock::now() + 2 * options.reconnect_after;
    while (std::chrono::steady_clock::now() < end) {
      connection.send(skinwire::Status{"resting", false, 0, 0});
      // A quarter of the time after which it would be said to be silent.
      connection.pause(quick().silent_after / 4);
    }
    source.stop();
    const Delivered delivered = listener.delivered();
    return !delivered.sawState(SourceState::Silent) && delivered.status().reconnects == 0;
  }));
}

TEST(WireSource, WaitsLongerAndLongerForADeviceThatIsNotThere) {
  const AbsentTcpDevice device;
  CollectingListener listener;
  WireSource source(device.address(), quick());
  source.start(listener);
  for (const char* wait : {"0.01 s", "0.02 s", "0.04 s", "0.08 s", "0.10 s"}) {
    ASSERT_TRUE(listener.waitFor(status(SourceState::Connecting, std::string("next try in ") + wait))) << wait;
  }
  source.stop();
  EXPECT_EQ(listener.delivered().status().state, SourceState::Stopped);
}

TEST(WireSource, CountsTheSecondsToTheNextTryDown) {
  const AbsentTcpDevice device;
  CollectingListener listener;
  WireOptions options = quick();
  options.first_retry = options.longest_retry = std::chrono::seconds(3);
  WireSource source(device.address(), options);
  source.start(listener);
  for (const char* left : {"3 s", "2 s", "1 s"}) {
    ASSERT_TRUE(listener.waitFor(status(SourceState::Connecting, std::string("next try in ") + left))) << left;
  }
}

TEST(WireSource, CountsTheSecondsOfSilenceDownToTheNextConnection) {
  TcpDevice device;
  CollectingListener listener;
  WireOptions options = quick();
  options.reconnect_after = std::chrono::seconds(3);
  WireSource source(device.address(), options);
  source.start(listener);
  DeviceConnection silent = device.accept();
  describe(silent);
  for (const char* left : {"3 s", "2 s", "1 s"}) {
    ASSERT_TRUE(listener.waitFor(status(SourceState::Silent, std::string("reconnecting in ") + left))) << left;
  }
}

std::size_t openDescriptors() {
  return static_cast<std::size_t>(
      std::distance(std::filesystem::directory_iterator("/proc/self/fd"), std::filesystem::directory_iterator()));
}

TEST(WireSource, AThousandReconnectsLeaveNothingOpen) {
  TcpDevice device;
  CollectingListener listener;
  WireOptions options = patient();
  options.first_retry = milliseconds(1);
  WireSource source(device.address(), options);
  source.start(listener);
  std::size_t after_ten = 0;
  for (int k = 0; k < 1000; ++k) {
    DeviceConnection connection = device.accept();
    describe(connection);
    connection.send(skinwire::rawSamples(0, 1000));
    ASSERT_TRUE(listener.waitFor(frames(2 * static_cast<std::size_t>(k + 1))));
    if (k == 10) after_ten = openDescriptors();
  }
  EXPECT_LE(openDescriptors(), after_ten);
  source.stop();
  EXPECT_EQ(listener.delivered().status().reconnects, 999U);
  EXPECT_EQ(listener.delivered().skins.size(), 1U);
}

TEST(WireSource, StopsInEveryState) {
  for (int k = 0; k < 20; ++k) {
    TcpDevice device;
    CollectingListener listener;
    WireSource source(device.address(), quick());
    source.start(listener);
    if (k % 2 == 0) device.accept();
    source.stop();
    source.stop();
    const std::size_t before = listener.delivered().statuses.size();
    EXPECT_EQ(listener.delivered().status().state, SourceState::Stopped);
    EXPECT_EQ(listener.delivered().statuses.size(), before);
  }
  WireSource never_started("tcp://localhost:7700");
  never_started.stop();
}

TEST(WireSource, UdpDevicesAreAskedAndKeptSending) {
  UdpDevice device;
  CollectingListener listener;
  WireOptions options = patient();
  options.describe_every = milliseconds(50);
  WireSource source(device.address(), options);
  source.start(listener);
  EXPECT_EQ(device.receive().request, skinwire::Request(skinwire::Describe{}));
  describe(device);
  ASSERT_TRUE(listener.waitFor(state(SourceState::Streaming)));
  device.send(skinwire::rawSamples(0, 1000));
  ASSERT_TRUE(listener.waitFor(frames(2)));
  // Asked again, now with the topology that it has.
  skinwire::Command again = device.receive();
  while (again.request == skinwire::Request(skinwire::Describe{})) again = device.receive();
  EXPECT_EQ(again.request, skinwire::Request(skinwire::Describe{3}));
}

TEST(WireSource, AUdpDeviceWhoseClockIsSetIsTakenUpAgain) {
  UdpDevice device;
  CollectingListener listener;
  WireSource source(device.address(), patient());
  source.start(listener);
  device.receive();
  describe(device);
  std::size_t delivered = 0;
  // As after an hour, after the device was restarted without a word, and after its clock ran away for one message.
  for (const std::uint64_t start_us : {3'600'000'000UL, 0UL, skinwire::kMaxTime_us - 10'000, 500'000UL}) {
    // A second of the device's time.
    for (std::uint64_t k = 0; k < 10; ++k) {
      if (start_us + 100'000 * k > skinwire::kMaxTime_us - 10'000) break;
      device.send(skinwire::rawSamples(4 * k, start_us + 100'000 * k));
    }
    const double latest_s = static_cast<double>(start_us) / 1e6;
    ASSERT_TRUE(listener.waitFor([&](const Delivered& d) {
      return d.frames.size() > delivered && d.frames.back().time_s >= latest_s && d.frames.back().time_s < latest_s + 2;
    })) << start_us;
    delivered = listener.delivered().frames.size();
  }
  source.stop();
  EXPECT_EQ(listener.delivered().status().reconnects, 0U);
  EXPECT_EQ(listener.delivered().status().clock_restarts, 2U);
}

TEST(WireSource, ALooseLinkNeitherFillsARecordingNorDelaysStopping) {
  const test::TemporaryFolder folder;
  const std::filesystem::path file = folder.path() / "loose.skinrec";
  TcpDevice device;
  CollectingListener listener;
  StreamRecorder recorder(file, listener);
  WireSource source(device.address(), patient());
  source.start(recorder);
  DeviceConnection connection = device.accept();
  // 1,000 cells in a row, of which the last is there and not there.
  skinwire::Topology whole{1, 0, 1, {}};
  for (std::uint32_t id = 1; id <= 1000; ++id) whole.cells.push_back({CellId(id), "", {}});
  skinwire::Topology without = whole;
  without.id = 2;
  without.cells.pop_back();
  connection.send(skinwire::helloMessage());
  constexpr std::uint64_t kFlaps = 2000;
  for (std::uint64_t k = 0; k < kFlaps; ++k) {
    connection.send(whole);
    connection.send(without);
  }
  connection.send(skinwire::Status{"that was all", false, 0, 0});
  ASSERT_TRUE(listener.waitFor([](const Delivered& d) { return !d.device_statuses.empty(); }));
  source.stop();
  recorder.finish();
  const Delivered delivered = listener.delivered();
  EXPECT_EQ(delivered.status().skin_changes, 2 * kFlaps - 1);
  EXPECT_EQ(delivered.skins.back().neighbors.size(), 999U);
  // The change that waits is passed on when it ends; else as many as the time that a busy computer takes allows.
  EXPECT_LT(delivered.skins.size(), 100U);
  const std::size_t one = skinwire::encodeBody(whole).size() + skinwire::encodeBody(skinwire::helloMessage()).size();
  EXPECT_LT(std::filesystem::file_size(file), (delivered.skins.size() + 1) * (one + 100));
}

TEST(WireSource, DatagramsLostTwiceReorderedBrokenAndTooLongAreCounted) {
  UdpDevice device;
  CollectingListener listener;
  WireSource source(device.address(), patient());
  source.start(listener);
  device.receive();
  describe(device);
  device.send(skinwire::rawSamples(0, 1000));
  device.send(skinwire::rawSamples(0, 1000));   // twice
  device.send(skinwire::rawSamples(12, 7000));  // 4 to 11 are missing
  device.send(skinwire::rawSamples(8, 5000));   // overtaken
  skinwire::Bytes broken = skinwire::encodeBody(skinwire::rawSamples(16, 9000));
  broken[5] ^= 1U;
  device.sendBytes(broken);
  device.sendBytes(skinwire::Bytes(1201, 1));
  device.sendBytes(skinwire::Bytes(3, 1));
  device.send(skinwire::rawSamples(16, 9000));
  ASSERT_TRUE(listener.waitFor(frames(6)));
  source.stop();
  const SourceStatus counted = listener.delivered().status();
  EXPECT_EQ(counted.frames, 6U);
  EXPECT_EQ(counted.lost_samples, 8U);
  EXPECT_EQ(counted.late_frames, 4U);
  EXPECT_EQ(counted.rejected_messages, 3U);
  EXPECT_EQ(counted.reconnects, 0U);
}

TEST(WireSource, CommandsOverUdpAreRepeatedUntilTheyAreAnswered) {
  UdpDevice device;
  CollectingListener listener;
  WireSource source(device.address(), patient());
  source.start(listener);
  device.receive();
  describe(device);
  ASSERT_TRUE(listener.waitFor(state(SourceState::Streaming)));
  const std::uint32_t rate = source.send(SetRate{10});
  const skinwire::Command expected{rate, skinwire::SetRate{10}};
  for (int times = 0; times < 2;) {
    if (device.receive() == expected) ++times;  // the first is lost
  }
  device.send(skinwire::Ack{rate, true, "", false});
  device.send(skinwire::Ack{rate, true, "", false});
  ASSERT_TRUE(listener.waitFor(outcome(rate)));
  source.stop();
  EXPECT_EQ(listener.delivered().outcomes.size(), 1U);
}

TEST(WireSource, ACommandOverUdpThatDoesNotEndIsSaidAndRepeatedMoreRarely) {
  UdpDevice device;
  CollectingListener listener;
  WireSource source(device.address(), patient());
  source.start(listener);
  device.receive();
  describe(device);
  ASSERT_TRUE(listener.waitFor(state(SourceState::Streaming)));
  const std::uint32_t rate = source.send(SetRate{10});
  const skinwire::Command expected{rate, skinwire::SetRate{10}};
  std::vector<std::chrono::steady_clock::time_point> sent;
  while (sent.size() < 10) {
    if (device.receive() != expected) continue;
    sent.push_back(std::chrono::steady_clock::now());
    device.send(skinwire::Ack{rate, false, "", true});
  }
  EXPECT_TRUE(listener.waitFor(status(SourceState::Streaming, "command 1 was sent 10 times")));
  // On a busy computer a single one may look nearer to the one before.
  EXPECT_GT(sent.back() - sent.front(), milliseconds(9 * 800));
  device.send(skinwire::Ack{rate, true, "", false});
  EXPECT_TRUE(listener.waitFor(outcome(rate)));
  source.stop();
}

TEST(WireSource, AUdpPortWhereNobodyListensIsSaid) {
  std::string address;
  {
    const UdpDevice device;
    address = device.address();
  }
  CollectingListener listener;
  WireSource source(address, quick());
  source.start(listener);
  EXPECT_TRUE(listener.waitFor(status(SourceState::Connecting, "next try in")));
}

TEST(WireSource, DeliversFromASerialPortAfterGarbage) {
  SerialDevice device;
  CollectingListener listener;
  WireSource source(device.address() + "?baud=921600", patient());
  source.start(listener);
  EXPECT_EQ(device.receive().request, skinwire::Request(skinwire::Describe{}));
  device.sendBytes(skinwire::Bytes{'b', 'o', 'o', 't', '\r', '\n', 17, 19, 3, 4, 0});
  describe(device);
  const skinwire::Bytes frame = skinwire::encodeFrame(Framing::Cobs, skinwire::rawSamples(0, 1000));
  device.sendBytes(skinwire::ByteView(frame).first(frame.size() / 2));  // the rest is lost
  device.sendBytes(skinwire::Bytes{0});
  device.send(skinwire::rawSamples(4, 3000));
  ASSERT_TRUE(listener.waitFor(frames(2)));
  const std::uint32_t led = source.send(SetLed{CellId(1), 1, 2, 3});
  EXPECT_EQ(device.receive(), (skinwire::Command{led, skinwire::SetLed{1, 1, 2, 3}}));
  source.stop();
  EXPECT_EQ(listener.delivered().status().rejected_messages, 2U);
}

/// The reason of an offence, once it has these words.
bool saysOffence(CollectingListener& listener, OffenceKind kind, const std::string& words) {
  return listener.waitFor([&](const Delivered& d) {
    return std::ranges::any_of(d.statuses, [&](const SourceStatus& status) {
      return std::ranges::any_of(status.offences, [&](const Offence& offence) {
        return offence.kind == kind && offence.reason.english().find(words) != std::string::npos;
      });
    });
  });
}

TEST(WireSource, BrokenBytesAloneOnASerialPortPutTheBaudRateInDoubt) {
  WireOptions options = quick();
  options.reconnect_after = test::kForever;
  const skinwire::Bytes broken = {9, 17, 3, 200, 200, 0};
  const skinwire::Bytes framing_errors(30, 0);
  for (const skinwire::Bytes& bytes : {broken, framing_errors}) {
    SerialDevice device;
    CollectingListener listener;
    WireSource source(device.address() + "?baud=9600", options);
    source.start(listener);
    device.receive();
    for (int k = 0; k < 20; ++k) device.sendBytes(bytes);
    EXPECT_TRUE(saysOffence(listener, OffenceKind::BrokenFrame, "is the baud rate right? now 9600"));
    EXPECT_TRUE(listener.waitFor(status(SourceState::Silent, "is the baud rate right? now 9600")));
    source.stop();
  }
}

TEST(WireSource, ASerialDeviceThatDoesNotHearIsAskedForItsRx) {
  WireOptions options = patient();
  options.describe_every = milliseconds(50);
  SerialDevice device;
  CollectingListener listener;
  WireSource source(device.address(), options);
  source.start(listener);
  device.receive();
  device.send(skinwire::rawSamples(0, 1000));
  EXPECT_TRUE(saysOffence(listener, OffenceKind::NotDescribed, "did not answer Describe"));
  EXPECT_TRUE(saysOffence(listener, OffenceKind::NotDescribed, "is its RX connected?"));
  source.stop();
}

TEST(WireSource, ASerialPortThatIsUnpluggedOrMissingIsSaid) {
  SerialDevice device;
  CollectingListener listener;
  WireSource source(device.address(), patient());
  source.start(listener);
  device.receive();
  describe(device);
  ASSERT_TRUE(listener.waitFor(state(SourceState::Streaming)));
  device.unplug();
  ASSERT_TRUE(listener.waitFor(status(SourceState::Connecting, "next try in")));
  ASSERT_TRUE(listener.waitFor(status(SourceState::Connecting, "No such file"))) << "the terminal is gone altogether";
}

TEST(WireSource, OptionsWithoutSenseAreRefused) {
  WireOptions options;
  options.first_retry = milliseconds(0);
  EXPECT_THROW(WireSource("tcp://localhost:1", options), InvalidArgument);
  options = {};
  options.reconnect_after = milliseconds(10);
  EXPECT_THROW(WireSource("tcp://localhost:1", options), InvalidArgument);
  CollectingListener listener;
  WireSource source("tcp://localhost:1");
  source.start(listener);
  EXPECT_THROW(source.start(listener), InvalidArgument);
}

}  // namespace
}  // namespace hexoderm
