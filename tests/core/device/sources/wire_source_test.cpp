#include "hexoderm/device/sources/wire_source.h"

#include "hexoderm/device/sources/recording.h"
#include "hexoderm/util/error.h"
#include "tests/core/device/sources/wire_source_fixture.h"
#include "tests/support/temporary_folder.h"

#include <gtest/gtest.h>
#include <cstdint>
#include <filesystem>

namespace hexoderm::wire_source_test {
namespace {

TEST(WireSource, DeliversFromTcpInBothDialects) {
  for (const Framing framing : {Framing::Length, Framing::Lines}) {
    auto [device, listener, source] = started<TcpDevice>();
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

TEST(WireSource, UdpDevicesAreAskedAndKeptSending) {
  WireOptions options = patient();
  options.describe_every = milliseconds(50);
  auto [device, listener, source] = started<UdpDevice>(options);
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
  auto [device, listener, source] = started<UdpDevice>();
  describeWhenAsked(device);
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

TEST(WireSource, DeliversFromASerialPortAfterGarbage) {
  auto [device, listener, source] = started<SerialDevice>(patient(), "?baud=921600");
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

TEST(WireSource, StopsInEveryState) {
  for (int k = 0; k < 20; ++k) {
    auto [device, listener, source] = started<TcpDevice>(quick());
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
}  // namespace hexoderm::wire_source_test
