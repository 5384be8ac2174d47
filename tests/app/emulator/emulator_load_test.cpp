// 10,000 cells at 1 kHz on TCP: whatever this computer can do of it, every sample is received or said to be missing.

#include "tests/core/device/sources/wire_host.h"
#include "tests/support/slow_build.h"

#include "tests/app/emulator/emulator_program.h"

#include <atomic>
#include <cmath>

namespace hexoderm {
namespace {

constexpr std::uint64_t kSide = test::kSlowBuild ? 30 : 100;
constexpr std::uint64_t kCells = kSide * kSide;
constexpr double kRate_hz = 1000;

std::int64_t tickOf(const SampleFrame& frame) { return std::llround(frame.time_s * kRate_hz); }

/// Counts what comes, and judges every time that the source or the device says what it knows. All on the source's
/// thread but for waitUntil().
class Bookkeeper final : public SkinListener {
 public:
  explicit Bookkeeper(bool of_means) : of_means_(of_means) {}

  void onSkin(const SkinDescription& skin) override { EXPECT_EQ(skin.neighbors.size(), kCells); }
  void onFrame(const SampleFrame& frame) override {
    const std::lock_guard lock(mutex_);
    received += of_means_ ? frame.means.size() : frame.samples.size();
    last_tick_ = tickOf(frame);
    if (!first_tick_) first_tick_ = last_tick_;
  }
  void onStatus(const SourceStatus& status) override {
    const std::lock_guard lock(mutex_);
    source = status;
    // Of every tick of the device's clock since the first frame, each cell's sample has come or is missing.
    if (first_tick_ && !of_means_ && !is_slowed_down) {
      EXPECT_EQ(received + status.lost_samples, kCells * static_cast<std::uint64_t>(last_tick_ - *first_tick_ + 1));
    }
    changed_.notify_all();
  }
  void onDeviceStatus(const DeviceStatus& status) override {
    const std::lock_guard lock(mutex_);
    // On TCP all that was sent before is here.
    EXPECT_EQ(received, status.samples_sent);
    device = status;
    changed_.notify_all();
  }
  void onCommandOutcome(const CommandOutcome& outcome) override {
    EXPECT_TRUE(outcome.done) << outcome.message.english();
    const std::lock_guard lock(mutex_);
    is_answered = true;
    changed_.notify_all();
  }

  template <class Condition>
  bool waitUntil(Condition condition) {
    std::unique_lock lock(mutex_);
    return changed_.wait_for(lock, test::kPatience, condition);
  }
  [[nodiscard]] double seconds() const {
    return first_tick_ ? static_cast<double>(last_tick_ - *first_tick_) / kRate_hz : 0;
  }
  [[nodiscard]] bool isSettled() const {
    return source.lost_samples == device.samples_dropped && source.dropped_by_device == device.samples_dropped &&
           received == device.samples_sent;
  }

  std::uint64_t received = 0;  ///< samples, or means
  std::atomic<bool> is_slowed_down = false;
  bool is_answered = false;  ///< the command that was sent
  SourceStatus source;
  DeviceStatus device;

 private:
  bool of_means_;
  std::mutex mutex_;
  std::condition_variable changed_;
  std::optional<std::int64_t> first_tick_;
  std::int64_t last_tick_ = 0;
};

class EmulatorUnderLoad : public testing::TestWithParam<std::uint32_t> {};

TEST_P(EmulatorUnderLoad, KeepsUpOrSaysPreciselyWhatWasDropped) {
  const std::uint32_t means_of = GetParam();
  std::vector<std::string> arguments = {"--tcp", "0", "--patch",
                                        "sheet:" + std::to_string(kSide) + "x" + std::to_string(kSide)};
  if (means_of > 0) {
    arguments.emplace_back("--means");
    arguments.push_back(std::to_string(means_of));
  }
  const Emulator emulator(arguments);
  Bookkeeper books(means_of > 0);
  const auto source = wireSource(emulator.address, patient());
  source->start(books);
  constexpr double kLong_s = 3;
  EXPECT_TRUE(books.waitUntil([&] { return books.seconds() > kLong_s; }));

  // A frame a second: what was dropped last shows as a gap before the next one.
  books.is_slowed_down = true;
  source->send(SetRate{std::max(1.0, static_cast<double>(means_of))});
  // The books may agree for a moment before the device has slowed down.
  EXPECT_TRUE(books.waitUntil([&] { return books.is_answered && books.isSettled(); }));
  source->stop();
  EXPECT_TRUE(books.isSettled());
  const SourceStatus& status = books.source;
  EXPECT_EQ(status.reconnects + status.rejected_messages + status.late_frames + status.unknown_samples, 0U);
}

INSTANTIATE_TEST_SUITE_P(SamplesAndMeans, EmulatorUnderLoad, testing::Values(0U, 20U));

}  // namespace
}  // namespace hexoderm
