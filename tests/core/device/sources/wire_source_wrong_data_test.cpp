// Data that is cut off, broken, lost, of another version or at another baud rate.

#include "tests/core/device/sources/wire_source_fixture.h"
#include "tests/support/options.h"

namespace hexoderm::wire_source_test {
namespace {

TEST(WireSource, BrokenDataOnTcpIsNamedAndTheConnectionMadeAnew) {
  skinwire::Bytes wrong_crc = skinwire::encodeFrame(Framing::Length, skinwire::rawSamples(0, 1000));
  wrong_crc[10] ^= 4U;
  const skinwire::Bytes too_long = {0xFF, 0xFF, 0xFF, 0};
  const std::pair<skinwire::Bytes, const char*> cases[] = {{wrong_crc, "CRC"}, {too_long, "16777215"}};
  for (const auto& [bytes, why] : cases) {
    auto [device, listener, source] = started<TcpDevice>();
    {
      DeviceConnection connection = described(device);
      connection.sendBytes(bytes);
      ASSERT_TRUE(listener.waitFor(status(SourceState::Connecting, why)));
    }
    DeviceConnection connection = described(device);
    connection.send(skinwire::rawSamples(0, 1000));
    ASSERT_TRUE(listener.waitFor(frames(2)));
    EXPECT_EQ(listener.delivered().frames.size(), 2U);
  }
}

TEST(WireSource, AnotherMajorVersionIsNamedAndNotTriedAgain) {
  auto [device, listener, source] = started<TcpDevice>();
  DeviceConnection connection = device.accept(Framing::Lines);
  const std::string line = "{\"major\": 2, \"hello\": {\"device\": \"of the future\"}}\n";
  connection.sendBytes(skinwire::Bytes(line.begin(), line.end()));
  ASSERT_TRUE(listener.waitFor(status(SourceState::Incompatible, "SkinWire 2, this program SkinWire 1")));
  // The tick that answers a command is one that did not connect; the first retry would have been due before.
  const std::uint32_t command = source->send(SetRate{1});
  ASSERT_TRUE(listener.waitFor(outcome(command)));
  source->stop();
  EXPECT_FALSE(device.hasCaller());
}

TEST(WireSource, DatagramsLostTwiceReorderedBrokenAndTooLongAreCounted) {
  auto [device, listener, source] = started<UdpDevice>();
  describeWhenAsked(device);
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
  source->stop();
  const SourceStatus counted = listener.delivered().status();
  EXPECT_EQ(counted.frames, 6U);
  EXPECT_EQ(counted.lost_samples, 8U);
  EXPECT_EQ(counted.late_frames, 4U);
  EXPECT_EQ(counted.rejected_messages, 3U);
  EXPECT_EQ(counted.reconnects, 0U);
}

/// The reason of an offence, once it has these words.
bool saysViolation(CollectingListener& listener, ProtocolViolationKind kind, const std::string& words) {
  return listener.waitFor([&](const Delivered& d) {
    return std::ranges::any_of(d.statuses, [&](const SourceStatus& status) {
      return std::ranges::any_of(status.offences, [&](const ProtocolViolation& offence) {
        return offence.kind == kind && offence.reason.english().find(words) != std::string::npos;
      });
    });
  });
}

TEST(WireSource, BrokenBytesAloneOnASerialPortPutTheBaudRateInDoubt) {
  const WireOptions options = test::with(quick(), &WireOptions::reconnect_after, test::kForever);
  const skinwire::Bytes broken = {9, 17, 3, 200, 200, 0};
  const skinwire::Bytes framing_errors(30, 0);
  for (const skinwire::Bytes& bytes : {broken, framing_errors}) {
    auto [device, listener, source] = started<SerialDevice>(options, "?baud=9600");
    device.receive();
    for (int k = 0; k < 20; ++k) device.sendBytes(bytes);
    EXPECT_TRUE(saysViolation(listener, ProtocolViolationKind::BrokenFrame, "is the baud rate right? now 9600"));
    EXPECT_TRUE(listener.waitFor(status(SourceState::Silent, "is the baud rate right? now 9600")));
    source->stop();
  }
}

TEST(WireSource, ASerialDeviceThatDoesNotHearIsAskedForItsRx) {
  auto [device, listener, source] =
      started<SerialDevice>(test::with(patient(), &WireOptions::describe_every, milliseconds(50)));
  device.receive();
  device.send(skinwire::rawSamples(0, 1000));
  EXPECT_TRUE(saysViolation(listener, ProtocolViolationKind::NotDescribed, "did not answer Describe"));
  EXPECT_TRUE(saysViolation(listener, ProtocolViolationKind::NotDescribed, "is its RX connected?"));
  source->stop();
}

}  // namespace
}  // namespace hexoderm::wire_source_test
