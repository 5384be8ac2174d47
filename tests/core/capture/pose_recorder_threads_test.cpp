#include "tests/core/capture/pose_recorder_fixture.h"

#include <atomic>
#include <thread>

namespace hexoderm::pose_recorder_test {
namespace {

TEST(PoseRecorderThreads, CommandsMayComeFromAnotherThread) {
  SyntheticStream stream({.cells = 3});
  stream.hold(1);
  Captures captures;
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
  feed(recorder, stream.frames);
  ended = true;
  operators.join();

  // This one is taken, whatever came before.
  captures.poses.clear();
  recorder.setNextPoseId(PoseId(9));
  recorder.captureNow();
  stream.frames.clear();
  stream.hold(0.5);
  feed(recorder, stream.frames);
  ASSERT_EQ(captures.poses.size(), 1U);
  EXPECT_EQ(captures.poses.front().pose->id, PoseId(9));
}

}  // namespace
}  // namespace hexoderm::pose_recorder_test
