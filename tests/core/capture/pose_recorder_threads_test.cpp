#include "tests/core/capture/captures_of.h"
#include "tests/core/capture/synthetic_stream.h"

#include <atomic>
#include <thread>

namespace hexoderm {
namespace {

TEST(PoseRecorderThreads, CommandsMayComeFromAnotherThread) {
  test::SyntheticStream stream({.cells = 3});
  stream.hold(1);
  test::Captures captures;
  PoseRecorder recorder(captures);
  std::atomic<bool> ended = false;
  std::thread operators([&] {
    while (!ended) {
      recorder.setAutomatic(true);
      recorder.setEarlierPoses({});
      recorder.captureNow();
      recorder.cancelCapture();
      recorder.setAutomatic(false);
    }
  });
  for (const SampleFrame& frame : stream.frames) recorder.addFrame(frame);
  ended = true;
  operators.join();

  // This one is taken, whatever came before.
  captures.poses.clear();
  recorder.setNextPoseId(PoseId(9));
  recorder.captureNow();
  stream.frames.clear();
  stream.hold(0.5);
  for (const SampleFrame& frame : stream.frames) recorder.addFrame(frame);
  ASSERT_EQ(captures.poses.size(), 1U);
  EXPECT_EQ(captures.poses.front().pose->id, PoseId(9));
}

}  // namespace
}  // namespace hexoderm
