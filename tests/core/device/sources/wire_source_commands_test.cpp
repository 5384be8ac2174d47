// Commands to a device on a wire: their answers, their repetition, and those that get no answer.

#include "tests/core/device/sources/wire_source_fixture.h"

#include <chrono>

namespace hexoderm::wire_source_test {
namespace {

TEST(WireSource, CommandsAreAnsweredByNumberInTheDevicesDialect) {
  for (const Framing framing : {Framing::Length, Framing::Lines}) {
    auto [device, listener, source] = started<TcpDevice>();
    DeviceConnection connection = described(device, framing);
    ASSERT_TRUE(listener.waitFor(state(SourceState::Streaming)));

    const std::uint32_t led = source->send(SetLed{CellId(7), 255, 0, 16});
    skinwire::Command command = connection.receive();
    EXPECT_EQ(command, (skinwire::Command{led, skinwire::SetLed{7, 255, 0, 16}}));
    connection.send(skinwire::Ack{led, false, "there is no cell 7", false});
    ASSERT_TRUE(listener.waitFor(outcome(led)));
    EXPECT_FALSE(listener.delivered().outcomeOf(led)->done);
    EXPECT_EQ(listener.delivered().outcomeOf(led)->message.english(), "there is no cell 7");

    const std::uint32_t turn = source->send(TurnTo{CellId(1), Eigen::Vector3d::UnitX()});
    const std::uint32_t rate = source->send(SetRate{500});
    const std::uint32_t explore = source->send(ExploreAgain{});
    EXPECT_EQ(connection.receive(), (skinwire::Command{turn, skinwire::TurnTo{1, Eigen::Vector3d::UnitX()}}));
    EXPECT_EQ(connection.receive(), (skinwire::Command{rate, skinwire::SetRate{500}}));
    EXPECT_EQ(connection.receive(), (skinwire::Command{explore, skinwire::ExploreAgain{}}));
    connection.send(skinwire::Ack{rate, true, "", false});
    connection.send(skinwire::Ack{turn, true, "", false});
    ASSERT_TRUE(listener.waitFor(outcome(turn)));
    EXPECT_TRUE(listener.delivered().outcomeOf(turn)->done);
    EXPECT_TRUE(listener.delivered().outcomeOf(rate)->done);
    EXPECT_EQ(listener.delivered().outcomeOf(explore), nullptr);
    source->stop();
    ASSERT_NE(listener.delivered().outcomeOf(explore), nullptr) << "what is not answered fails in the end";
    EXPECT_FALSE(listener.delivered().outcomeOf(explore)->done);
  }
}

TEST(WireSource, CommandsThatCantBeAnsweredFailAndSayWhy) {
  TcpDevice device;
  CollectingListener listener;
  const auto source = wireSource(device.address(), patient());
  const std::uint32_t early = source->send(SetRate{100});
  source->start(listener);
  ASSERT_TRUE(listener.waitFor(outcome(early)));
  EXPECT_THAT(listener.delivered().outcomeOf(early)->message.english(), HasSubstr("not connected"));

  DeviceConnection connection = device.accept();
  skinwire::Hello hello = skinwire::helloMessage();
  hello.can_light_cells = hello.can_turn = false;
  connection.send(hello);
  connection.send(skinwire::topologyMessage());
  ASSERT_TRUE(listener.waitFor(state(SourceState::Streaming)));
  const std::uint32_t led = source->send(SetLed{CellId(1), 0, 0, 0});
  const std::uint32_t turn = source->send(TurnTo{CellId(1), Eigen::Vector3d::UnitX()});
  const std::uint32_t senseless = source->send(SetRate{-1});
  const std::uint32_t unanswered = source->send(ExploreAgain{});
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
    auto [device, listener, source] = started<TcpDevice>(options);
    DeviceConnection connection = described(device);
    EXPECT_TRUE(listener.waitFor(state(SourceState::Streaming)));
    const std::uint32_t slow = source->send(ExploreAgain{});
    const std::uint32_t unanswered = source->send(SetRate{100});
    while (listener.delivered().outcomeOf(unanswered) == nullptr) {
      connection.send(skinwire::Ack{slow, false, "", true});
      DeviceConnection::pause(milliseconds(1));
    }
    const Delivered delivered = listener.delivered();
    EXPECT_THAT(delivered.outcomeOf(unanswered)->message.english(), HasSubstr("did not answer"));
    return delivered.outcomeOf(slow) == nullptr;
  }));
}

/// What a device hears on a wire on which everything may be lost.
void receiveTimes(UdpDevice& device, const skinwire::Command& expected, int times,
                  const std::optional<skinwire::Ack>& answer = {}) {
  while (times > 0) {
    if (device.receive() != expected) continue;
    --times;
    if (answer) device.send(*answer);
  }
}

TEST(WireSource, CommandsOverUdpAreRepeatedUntilTheyAreAnswered) {
  auto [device, listener, source] = started<UdpDevice>();
  describeWhenAsked(device);
  ASSERT_TRUE(listener.waitFor(state(SourceState::Streaming)));
  const std::uint32_t rate = source->send(SetRate{10});
  receiveTimes(device, {rate, skinwire::SetRate{10}}, 2);  // the first is lost
  device.send(skinwire::Ack{rate, true, "", false});
  device.send(skinwire::Ack{rate, true, "", false});
  ASSERT_TRUE(listener.waitFor(outcome(rate)));
  source->stop();
  EXPECT_EQ(listener.delivered().outcomes.size(), 1U);
}

TEST(WireSource, ACommandOverUdpThatDoesNotEndIsSaidAndRepeatedMoreRarely) {
  WireOptions options = patient();
  options.repeat_command = milliseconds(1);
  options.repeat_working = milliseconds(40);
  auto [device, listener, source] = started<UdpDevice>(options);
  describeWhenAsked(device);
  ASSERT_TRUE(listener.waitFor(state(SourceState::Streaming)));
  const std::uint32_t rate = source->send(SetRate{10});
  const skinwire::Command expected{rate, skinwire::SetRate{10}};
  const skinwire::Ack working{rate, false, "", true};
  receiveTimes(device, expected, 10, working);  // some were on their way before the source knew
  const auto began = std::chrono::steady_clock::now();
  receiveTimes(device, expected, 10, working);
  EXPECT_TRUE(listener.waitFor(status(SourceState::Streaming, "a command was sent 20 times")));
  // A busy computer may take the last of the others late.
  EXPECT_GT(std::chrono::steady_clock::now() - began, 10 * options.repeat_working / 2);
  device.send(skinwire::Ack{rate, true, "", false});
  EXPECT_TRUE(listener.waitFor(outcome(rate)));
  source->stop();
}

}  // namespace
}  // namespace hexoderm::wire_source_test
