#pragma once

#include "hexoderm/device/sources/open_source.h"
#include "hexoderm/device/sources/recording.h"
#include "tests/support/qt_wait.h"

#include <gtest/gtest.h>

#include <atomic>
#include <filesystem>
#include <string>

namespace hexoderm {

/// Records a simulated skin until it has sent so many frames or a few more.
inline void recordSkin(const std::string& address, const std::filesystem::path& path, int frames) {
  struct Counter final : SkinListener {
    void onSkin(const SkinDescription& /*skin*/) override {}
    void onFrame(const SampleFrame& /*frame*/) override { ++count; }
    void onStatus(const SourceStatus& /*status*/) override {}
    void onCommandOutcome(const CommandOutcome& /*outcome*/) override {}
    std::atomic<int> count = 0;
  } counter;
  StreamRecorder recorder(path, counter);
  const auto source = openSkinSource(address);
  source->start(recorder);
  EXPECT_TRUE(test::waitUntil([&] { return counter.count >= frames; }));
  source->stop();
  recorder.finish();
}

}  // namespace hexoderm
