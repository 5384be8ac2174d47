#pragma once

// Skins and frames for a PoseRecorder, and what it makes of them.

#include "hexoderm/capture/pose_recorder.h"
#include "tests/core/capture/synthetic_stream.h"

namespace hexoderm::pose_recorder_test {

using test::held;
using test::StreamOptions;
using test::SyntheticStream;

/// Keeps everything that a PoseRecorder says.
struct Captures : PoseRecorderListener {
  std::vector<CapturedPose> poses;
  std::vector<HoldStatus> holds;
  std::vector<SkinPreview> previews;

  void onPoseCaptured(CapturedPose captured) override { poses.push_back(std::move(captured)); }
  void onHold(const HoldStatus& status) override { holds.push_back(status); }
  void onPreview(SkinPreview preview) override { previews.push_back(std::move(preview)); }
};

inline SkinDescription skinOf(std::size_t cells, double rate_hz = 1000) {
  SkinDescription skin;
  auto model = std::make_shared<CellModel>(builtInCellModel("hex-bma150"));
  model->accelerometer.rate_hz = rate_hz;
  skin.model = std::move(model);
  for (std::size_t k = 1; k <= cells; ++k) {
    CellReport cell;
    cell.id = CellId(static_cast<std::uint32_t>(k));
    skin.neighbors.push_back(cell);
  }
  return skin;
}

inline void feed(PoseRecorder& recorder, const std::vector<SampleFrame>& frames) {
  for (const SampleFrame& frame : frames) recorder.addFrame(frame);
}

inline StreamOptions cells(std::size_t count, double rate_hz = 1000) { return {.cells = count, .rate_hz = rate_hz}; }

/// A recorder of the default options.
class PoseRecorderTest : public testing::Test {
 protected:
  Captures captures_;
  PoseRecorder recorder_{captures_};
};

/// Frames of [from, to] in device time.
inline std::vector<SampleFrame> between(const std::vector<SampleFrame>& frames, double after_s, double to_s) {
  std::vector<SampleFrame> some;
  for (const SampleFrame& frame : frames) {
    if (frame.time_s > after_s && frame.time_s <= to_s) some.push_back(frame);
  }
  return some;
}

}  // namespace hexoderm::pose_recorder_test
