#include "hexoderm/device/sources/stdin_source.h"

#include "hexoderm/device/skinwire/framing.h"
#include "tests/core/device/skinwire/collecting_listener.h"
#include "tests/core/device/skinwire/wire_messages.h"
#include "tests/support/temporary_folder.h"
#include "tests/support/testing.h"

#include <fcntl.h>
#include <unistd.h>

namespace hexoderm {
namespace {

using Delivered = CollectingListener::Delivered;

class Pipe {
 public:
  Pipe() {
    if (::pipe2(ends_.data(), O_CLOEXEC) != 0) throw std::runtime_error("no pipe");
  }
  ~Pipe() {
    ::close(ends_[0]);
    closeWriter();
  }
  Pipe(const Pipe&) = delete;
  Pipe& operator=(const Pipe&) = delete;
  [[nodiscard]] int reader() const { return ends_[0]; }
  void write(const std::string& text) const { ASSERT_EQ(::write(ends_[1], text.data(), text.size()), text.size()); }
  void writeLine(const skinwire::Message& message) const { write(skinwire::encodeLine(message) + "\n"); }
  void closeWriter() {
    if (ends_[1] >= 0) ::close(ends_[1]);
    ends_[1] = -1;
  }

 private:
  std::array<int, 2> ends_{-1, -1};
};

class StdinSourceTest : public testing::Test {
 protected:
  bool comes(SourceState state) {
    return listener_.waitFor([state](const Delivered& d) { return d.sawState(state); });
  }

  Pipe pipe_;
  CollectingListener listener_;
};

TEST_F(StdinSourceTest, DeliversLinesUntilTheInputIsOver) {
  const auto source = stdinSource(pipe_.reader());
  source->start(listener_);
  pipe_.writeLine(skinwire::helloMessage());
  pipe_.writeLine(skinwire::topologyMessage());
  pipe_.write("what is this\n");
  pipe_.writeLine(skinwire::rawSamples(0, 1000));
  ASSERT_TRUE(comes(SourceState::Streaming));
  pipe_.write(skinwire::encodeLine(skinwire::rawSamples(4, 3000)));  // without a line feed
  pipe_.closeWriter();
  ASSERT_TRUE(comes(SourceState::Ended));
  EXPECT_EQ(listener_.delivered().frames.size(), 4U);
  EXPECT_EQ(listener_.delivered().status().rejected_messages, 1U);
}

TEST_F(StdinSourceTest, TakesFramesOfBytesToo) {
  const auto source = stdinSource(pipe_.reader());
  source->start(listener_);
  for (const skinwire::Message& message : std::vector<skinwire::Message>{
           skinwire::helloMessage(), skinwire::topologyMessage(), skinwire::rawSamples(0, 1000)}) {
    const skinwire::Bytes frame = skinwire::encodeFrame(skinwire::Framing::Length, message);
    pipe_.write(std::string(frame.begin(), frame.end()));
  }
  EXPECT_TRUE(listener_.waitFor([](const Delivered& d) { return d.frames.size() == 2; }));
}

TEST_F(StdinSourceTest, ReadsAFileThatWasRedirected) {
  const test::TemporaryFolder folder;
  const auto path = folder.put("lines", skinwire::encodeLine(skinwire::helloMessage()) + "\n" +
                                            skinwire::encodeLine(skinwire::topologyMessage()) + "\n" +
                                            skinwire::encodeLine(skinwire::rawSamples(0, 1000)) + "\n");
  const int file = ::open(path.c_str(), O_RDONLY | O_CLOEXEC);
  ASSERT_GE(file, 0);
  const auto source = stdinSource(file);
  source->start(listener_);
  EXPECT_TRUE(comes(SourceState::Ended));
  source->stop();
  EXPECT_EQ(listener_.delivered().frames.size(), 2U);
  ::close(file);
}

TEST_F(StdinSourceTest, SaysSilenceAndRefusesCommands) {
  const auto source = stdinSource(pipe_.reader(), std::chrono::milliseconds(50));
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
