#include "hexoderm/device/sources/stdin_source.h"

#include "hexoderm/device/skinwire/framing.h"
#include "tests/core/device/skinwire/collecting_listener.h"
#include "tests/core/device/skinwire/wire_messages.h"
#include "tests/support/pipe.h"
#include "tests/support/temporary_folder.h"
#include "tests/support/testing.h"

#include <fcntl.h>

namespace hexoderm {
namespace {

using Delivered = CollectingListener::Delivered;

const std::vector<skinwire::Message> kDescribedTick = {skinwire::helloMessage(), skinwire::topologyMessage(),
                                                       skinwire::rawSamples(0, 1000)};

class StdinSourceTest : public testing::Test {
 protected:
  bool comes(SourceState state) {
    return listener_.waitFor([state](const Delivered& d) { return d.sawState(state); });
  }

  void writeLine(const skinwire::Message& message) const { pipe_.write(skinwire::encodeLine(message) + "\n"); }

  test::Pipe pipe_;
  CollectingListener listener_;
};

TEST_F(StdinSourceTest, DeliversLinesUntilTheInputIsOver) {
  const auto source = stdinSource(pipe_.ends[0]);
  source->start(listener_);
  for (const skinwire::Message& message : kDescribedTick) writeLine(message);
  pipe_.write("what is this\n");
  ASSERT_TRUE(comes(SourceState::Streaming));
  pipe_.write(skinwire::encodeLine(skinwire::rawSamples(4, 3000)));  // without a line feed
  pipe_.closeEnd(1);
  ASSERT_TRUE(comes(SourceState::Ended));
  EXPECT_EQ(listener_.delivered().frames.size(), 4U);
  EXPECT_EQ(listener_.delivered().status().rejected_messages, 1U);
}

TEST_F(StdinSourceTest, ReadsAFileThatWasRedirected) {
  const test::TemporaryFolder folder;
  std::string lines;
  for (const skinwire::Message& message : kDescribedTick) lines += skinwire::encodeLine(message) + "\n";
  const int file = ::open(folder.put("lines", lines).c_str(), O_RDONLY | O_CLOEXEC);
  ASSERT_GE(file, 0);
  const auto source = stdinSource(file);
  source->start(listener_);
  EXPECT_TRUE(comes(SourceState::Ended));
  source->stop();
  EXPECT_EQ(listener_.delivered().frames.size(), 2U);
  ::close(file);
}

TEST_F(StdinSourceTest, SaysSilenceAndRefusesCommands) {
  const auto source = stdinSource(pipe_.ends[0], std::chrono::milliseconds(50));
  source->start(listener_);
  ASSERT_TRUE(comes(SourceState::Silent));
  const std::uint32_t command = source->send(SetRate{100});
  ASSERT_TRUE(listener_.waitFor([&](const Delivered& d) { return d.outcomeOf(command) != nullptr; }));
  EXPECT_FALSE(listener_.delivered().outcomeOf(command)->done);
  pipe_.write("{\"major\": 2}\n");
  EXPECT_TRUE(comes(SourceState::Incompatible));
}

}  // namespace
}  // namespace hexoderm
