#include "hexoderm/device/sources/wire_source.h"

#include "tests/core/device/sources/wire_source_fixture.h"
#include "tests/support/options.h"

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
    source->stop();
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
  const auto source = wireSource(device.address("localhost"), patient());
  source->start(listener);
  DeviceConnection connection = described(device);
  EXPECT_TRUE(listener.waitFor(state(SourceState::Streaming)));
}

TEST(WireSource, UdpDevicesAreAskedAndKeptSending) {
  auto [device, listener, source] =
      started<UdpDevice>(test::with(patient(), &WireOptions::describe_every, milliseconds(50)));
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
  const std::uint32_t led = source->send(SetLed{CellId(1), 1, 2, 3});
  EXPECT_EQ(device.receive(), (skinwire::Command{led, skinwire::SetLed{1, 1, 2, 3}}));
  source->stop();
  EXPECT_EQ(listener.delivered().status().rejected_messages, 1U) << "the first may be the end of a whole one";
}

TEST(WireSource, StopsInEveryState) {
  for (int k = 0; k < 20; ++k) {
    auto [device, listener, source] = started<TcpDevice>(quick());
    if (k % 2 == 0) device.accept();
    source->stop();
    source->stop();
    EXPECT_EQ(listener.delivered().status().state, SourceState::Stopped);
  }
  const auto never_started = wireSource("tcp://localhost:7700");
  never_started->stop();
}

TEST(WireSource, OptionsWithoutSenseAreRefused) {
  WireOptions options{.first_retry = milliseconds(0)};
  EXPECT_THROW(wireSource("tcp://localhost:1", options), InvalidArgument);
  options = {};
  options.reconnect_after = milliseconds(10);
  EXPECT_THROW(wireSource("tcp://localhost:1", options), InvalidArgument);
  CollectingListener listener;
  const auto source = wireSource("tcp://localhost:1");
  source->start(listener);
  EXPECT_THROW(source->start(listener), InvalidArgument);
}

}  // namespace
}  // namespace hexoderm::wire_source_test
