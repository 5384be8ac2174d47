// Wires that are lost, silent or not there: when it is said, and when the connection is made anew.

#include "tests/core/device/sources/wire_source_fixture.h"
#include "tests/support/options.h"

#include <chrono>

namespace hexoderm::wire_source_test {
namespace {

TEST(WireSource, ConnectsAgainWhenTheCableWasPulled) {
  auto [device, listener, source] = started<TcpDevice>();
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
  source->stop();
  const Delivered delivered = listener.delivered();
  EXPECT_EQ(delivered.skins.size(), 1U) << "the same skin";
  EXPECT_EQ(delivered.status().reconnects, 1U);
  EXPECT_EQ(delivered.status().lost_samples, 0U);
  EXPECT_EQ(delivered.status().late_frames, 0U);
}

TEST(WireSource, SilenceIsSaidAndThenTheConnectionIsMadeAnew) {
  auto [device, listener, source] = started<TcpDevice>(quick());
  DeviceConnection silent = described(device);
  ASSERT_TRUE(listener.waitFor(state(SourceState::Streaming)));
  ASSERT_TRUE(listener.waitFor(status(SourceState::Silent, "nothing came")));
  DeviceConnection connection = described(device);
  connection.send(skinwire::rawSamples(0, 1000));
  EXPECT_TRUE(listener.waitFor(frames(2)));
  EXPECT_TRUE(listener.delivered().saw(SourceState::Connecting, "nothing came for"));
}

TEST(WireSource, AStatusNowAndThenIsNoSilence) {
  EXPECT_TRUE(passesWithPatience([](const WireOptions& options) {
    auto [device, listener, source] = started<TcpDevice>(options);
    DeviceConnection connection = described(device);
    // Longer than the time after which the connection would be made again.
    const auto end = std::chrono::steady_clock::now() + 2 * options.reconnect_after;
    while (std::chrono::steady_clock::now() < end) {
      connection.send(skinwire::Status{"resting", false, 0, 0});
      // A quarter of the time after which it would be said to be silent.
      connection.pause(quick().silent_after / 4);
    }
    source->stop();
    const Delivered delivered = listener.delivered();
    return !delivered.sawState(SourceState::Silent) && delivered.status().reconnects == 0;
  }));
}

/// What is said one after the other of a device that is not there.
void expectWaits(const WireOptions& options, const std::vector<std::string>& waits) {
  CollectingListener listener;
  const auto source = wireSource("tcp://127.0.0.1:1", options);
  source->start(listener);
  for (const std::string& wait : waits) {
    EXPECT_TRUE(listener.waitFor(status(SourceState::Connecting, "next try in " + wait))) << wait;
  }
  source->stop();
  EXPECT_EQ(listener.delivered().status().state, SourceState::Stopped);
}

TEST(WireSource, WaitsLongerAndLongerForADeviceThatIsNotThere) {
  expectWaits(quick(), {"0.01 s", "0.02 s", "0.04 s", "0.08 s", "0.10 s"});
}

TEST(WireSource, CountsTheSecondsToTheNextTryDown) {
  WireOptions options = quick();
  options.first_retry = options.longest_retry = std::chrono::seconds(3);
  expectWaits(options, {"3 s", "2 s", "1 s"});
}

TEST(WireSource, CountsTheSecondsOfSilenceDownToTheNextConnection) {
  auto [device, listener, source] =
      started<TcpDevice>(test::with(quick(), &WireOptions::reconnect_after, std::chrono::seconds(3)));
  DeviceConnection silent = described(device);
  for (const char* left : {"3 s", "2 s", "1 s"}) {
    ASSERT_TRUE(listener.waitFor(status(SourceState::Silent, std::string("reconnecting in ") + left))) << left;
  }
}

std::size_t openDescriptors() {
  return static_cast<std::size_t>(
      std::distance(std::filesystem::directory_iterator("/proc/self/fd"), std::filesystem::directory_iterator()));
}

TEST(WireSource, AThousandReconnectsLeaveNothingOpen) {
  auto [device, listener, source] =
      started<TcpDevice>(test::with(patient(), &WireOptions::first_retry, milliseconds(1)));
  std::size_t after_ten = 0;
  for (int k = 0; k < 1000; ++k) {
    DeviceConnection connection = described(device);
    connection.send(skinwire::rawSamples(0, 1000));
    ASSERT_TRUE(listener.waitFor(frames(2 * static_cast<std::size_t>(k + 1))));
    if (k == 10) after_ten = openDescriptors();
  }
  EXPECT_LE(openDescriptors(), after_ten);
  source->stop();
  EXPECT_EQ(listener.delivered().status().reconnects, 999U);
  EXPECT_EQ(listener.delivered().skins.size(), 1U);
}

TEST(WireSource, AUdpPortWhereNobodyListensIsSaid) {
  CollectingListener listener;
  const auto source = wireSource("udp://127.0.0.1:1", quick());
  source->start(listener);
  EXPECT_TRUE(listener.waitFor(status(SourceState::Connecting, "next try in")));
}

TEST(WireSource, ASerialPortThatIsUnpluggedOrMissingIsSaid) {
  auto [device, listener, source] = started<SerialDevice>();
  describeWhenAsked(device);
  ASSERT_TRUE(listener.waitFor(state(SourceState::Streaming)));
  device.unplug();
  ASSERT_TRUE(listener.waitFor(status(SourceState::Connecting, "next try in")));
  ASSERT_TRUE(listener.waitFor(status(SourceState::Connecting, "No such file"))) << "the terminal is gone altogether";
}

}  // namespace
}  // namespace hexoderm::wire_source_test
