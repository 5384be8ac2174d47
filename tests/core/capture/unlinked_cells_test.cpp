// 20,000 cells without a single link, from a device on a wire to a pose, and as a graph.

#include "hexoderm/capture/pose_recorder.h"
#include "hexoderm/skin/skin_graph.h"

#include "tests/core/device/sources/loopback_device.h"
#include "tests/core/device/sources/wire_host.h"
#include "tests/support/neighbor_lists.h"
#include "tests/support/testing.h"

#include <sys/resource.h>

#include <chrono>
#include <future>

namespace hexoderm {
namespace {

constexpr std::uint32_t kCells = 20'000;
#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
constexpr long kMaxMemory_KiB = 2L << 20U;
#else
constexpr long kMaxMemory_KiB = 256L << 10U;
#endif

long mostMemory_KiB() {
  rusage usage{};
  ::getrusage(RUSAGE_SELF, &usage);
  return usage.ru_maxrss;
}

/// Source and pose recorder as a program joins them.
class Recording final : public SkinListener, public PoseRecorderListener {
 public:
  void onSkin(const SkinDescription& skin) override {
    recorder_.setSkin(skin);
    skin_ = skin;
  }
  void onFrame(const SampleFrame& frame) override { recorder_.addFrame(frame); }
  void onStatus(const SourceStatus& /*status*/) override {}
  void onCommandOutcome(const CommandOutcome& /*outcome*/) override {}
  void onPoseCaptured(CapturedPose captured) override { pose_.set_value(captured.pose); }
  void onHold(const HoldStatus& /*status*/) override {}
  void onPreview(SkinPreview /*preview*/) override {}

  std::shared_ptr<const PoseCapture> waitForPose() {
    auto pose = pose_.get_future();
    return pose.wait_for(test::kPatience) == std::future_status::ready ? pose.get() : nullptr;
  }
  /// Once the source has stopped.
  [[nodiscard]] const SkinDescription& skin() const { return skin_; }

 private:
  std::promise<std::shared_ptr<const PoseCapture>> pose_;
  SkinDescription skin_;
  PoseRecorder recorder_{*this};
};

TEST(UnlinkedCells, TwentyThousandAreCapturedInLittleMemory) {
  const long before_KiB = mostMemory_KiB();
  skinwire::Topology topology{1, 0, 1, {}};
  skinwire::Samples samples{.period_us = 1000};
  for (std::uint32_t id = 1; id <= kCells; ++id) {
    topology.cells.push_back({CellId(id), "", {}});
    samples.cells.push_back(id);
    samples.raw_lsb.insert(samples.raw_lsb.end(), {0, 0, 256});
  }

  TcpDevice device;
  Recording recording;
  const auto source = wireSource(device.address(), patient());
  source->start(recording);
  DeviceConnection connection = device.accept();
  connection.send(
      skinwire::Hello{skinwire::kMinor, "many", cellModelToJson(test::modelOfMany()), false, false, 100, 1});
  connection.send(topology);
  // 3 s at 100 Hz, held still, with noise of one LSB.
  for (std::uint64_t tick = 0; tick < 300; ++tick) {
    samples.sequence = tick * kCells;
    samples.time_us = 10'000 * tick;
    for (std::size_t k = 0; k < samples.raw_lsb.size(); k += 3) {
      samples.raw_lsb[k] = static_cast<std::int32_t>((tick * 7 + k / 3 * 5 + tick * k) % 3) - 1;
    }
    connection.send(samples);
  }
  const std::shared_ptr<const PoseCapture> pose = recording.waitForPose();
  source->stop();
  ASSERT_NE(pose, nullptr);
  EXPECT_EQ(pose->samples.size(), kCells);
  EXPECT_EQ(recording.skin().neighbors.size(), kCells);

  const SkinGraph graph(*recording.skin().model, recording.skin().neighbors);
  EXPECT_EQ(graph.patches().size(), kCells);
  EXPECT_LT(mostMemory_KiB() - before_KiB, kMaxMemory_KiB);
  RecordProperty("memory_KiB", static_cast<int>(mostMemory_KiB() - before_KiB));
}

}  // namespace
}  // namespace hexoderm
