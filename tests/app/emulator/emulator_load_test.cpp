// 10,000 cells at 1 kHz on TCP: whatever this computer can do of it, every sample is received or said to be missing.

#include "tests/core/device/sources/wire_host.h"
#include "tests/support/slow_build.h"

#include "tests/app/emulator/emulator_program.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <condition_variable>
#include <iostream>
#include <mutex>
#include <optional>

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
  explicit Bookkeeper(std::uint32_t means_of) : means_of_(means_of) {}

  void onSkin(const SkinDescription& skin) override { EXPECT_EQ(skin.neighbors.size(), kCells); }

  void onFrame(const SampleFrame& frame) override {
    const std::lock_guard lock(mutex_);
    const std::uint64_t count = means_of_ > 0 ? frame.means.size() : frame.samples.size();
    received_ += count;
    last_tick_ = tickOf(frame);
    if (!first_tick_) first_tick_ = last_tick_;
    if (means_of_ == 0) return;
    for (const CellMean& mean : frame.means) averaged_ += mean.count;
    // A mean of all its samples ends with the last tick of its turn, and so tells how the turns lie.
    if (!first_turn_ && frame.means.front().count == means_of_) first_turn_ = last_tick_ % means_of_;
  }

  void onStatus(const SourceStatus& status) override {
    const std::lock_guard lock(mutex_);
    source_ = status;
    if (judges_clock_ && first_tick_ && (means_of_ == 0 || first_turn_)) {
      // Ticks of the device's clock, or turns of its means, from the first frame that came to the last one.
      EXPECT_EQ(received_ + status.lost_samples,
                kCells * static_cast<std::uint64_t>(turnOf(last_tick_) - turnOf(*first_tick_) + 1));
      ++judged_;
    }
    changed_.notify_all();
  }

  void onDeviceStatus(const DeviceStatus& status) override {
    const std::lock_guard lock(mutex_);
    // On TCP all that was sent before is here.
    EXPECT_EQ(received_, status.samples_sent);
    device_ = status;
    changed_.notify_all();
  }
  void onCommandOutcome(const CommandOutcome& outcome) override {
    EXPECT_TRUE(outcome.done) << outcome.message.english();
    const std::lock_guard lock(mutex_);
    is_answered_ = true;
    changed_.notify_all();
  }

  template <class Condition>
  bool waitUntil(Condition condition) {
    std::unique_lock lock(mutex_);
    return changed_.wait_for(lock, test::kPatience, [&] { return condition(*this); });
  }
  /// The device's rate is about to change.
  void endOfClock() {
    const std::lock_guard lock(mutex_);
    judges_clock_ = false;
  }

  [[nodiscard]] double seconds() const {
    return first_tick_ ? static_cast<double>(last_tick_ - *first_tick_) / kRate_hz : 0;
  }
  [[nodiscard]] bool isAnswered() const { return is_answered_; }
  [[nodiscard]] bool isSettled() const {
    return source_.lost_samples == device_.samples_dropped && source_.dropped_by_device == device_.samples_dropped &&
           received_ == device_.samples_sent;
  }
  [[nodiscard]] std::uint64_t received() const { return received_; }
  [[nodiscard]] std::uint64_t averaged() const { return averaged_; }
  [[nodiscard]] int judged() const { return judged_; }
  [[nodiscard]] const SourceStatus& source() const { return source_; }
  [[nodiscard]] const DeviceStatus& device() const { return device_; }

 private:
  /// Rounded down.
  [[nodiscard]] std::int64_t turnOf(std::int64_t tick) const {
    return means_of_ == 0 ? tick : (tick + means_of_ - 1 - *first_turn_) / means_of_;
  }

  std::uint32_t means_of_;
  std::mutex mutex_;
  std::condition_variable changed_;
  std::uint64_t received_ = 0;  ///< samples, or means
  std::uint64_t averaged_ = 0;  ///< samples in the means
  std::optional<std::int64_t> first_tick_;
  std::optional<std::int64_t> first_turn_;  ///< remainder of the tick that ends a turn
  std::int64_t last_tick_ = 0;
  bool judges_clock_ = true;
  int judged_ = 0;
  bool is_answered_ = false;  ///< the command that was sent
  SourceStatus source_;
  DeviceStatus device_;
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
  Bookkeeper bookkeeper(means_of);
  const auto source = wireSource(emulator.address, patient());
  source->start(bookkeeper);
  constexpr double kLong_s = 3;
  EXPECT_TRUE(bookkeeper.waitUntil([](const Bookkeeper& b) { return b.seconds() > kLong_s && b.judged() > 2; }));

  // A frame a second: what was dropped last shows as a gap before the next one.
  bookkeeper.endOfClock();
  source->send(SetRate{std::max(1.0, static_cast<double>(means_of))});
  // The books may agree for a moment before the device has slowed down.
  EXPECT_TRUE(bookkeeper.waitUntil([](const Bookkeeper& b) { return b.isAnswered() && b.isSettled(); }));
  source->stop();
  const SourceStatus& status = bookkeeper.source();
  EXPECT_EQ(status.lost_samples, bookkeeper.device().samples_dropped);
  EXPECT_EQ(status.dropped_by_device, bookkeeper.device().samples_dropped);
  EXPECT_EQ(bookkeeper.received(), bookkeeper.device().samples_sent);
  EXPECT_EQ(status.reconnects + status.rejected_messages + status.late_frames + status.unknown_samples, 0U);
  const double dropped = static_cast<double>(status.lost_samples);
  std::cout << bookkeeper.received() << (means_of > 0 ? " means" : " samples") << " received, " << status.lost_samples
            << " dropped (" << 100 * dropped / (dropped + static_cast<double>(bookkeeper.received())) << " %)";
  if (means_of > 0) std::cout << ", of " << bookkeeper.averaged() << " samples";
  std::cout << '\n';
}

INSTANTIATE_TEST_SUITE_P(Samples, EmulatorUnderLoad, testing::Values(0U));
INSTANTIATE_TEST_SUITE_P(Means, EmulatorUnderLoad, testing::Values(20U));

}  // namespace
}  // namespace hexoderm
