#pragma once

#include "hexoderm/capture/pose_recorder.h"

#include <vector>

namespace hexoderm::test {

/// Keeps everything that a PoseRecorder says.
struct Captures : PoseRecorderListener {
  std::vector<CapturedPose> poses;
  std::vector<HoldStatus> holds;
  std::vector<SkinPreview> previews;

  void onPoseCaptured(CapturedPose captured) override { poses.push_back(std::move(captured)); }
  void onHold(const HoldStatus& status) override { holds.push_back(status); }
  void onPreview(SkinPreview preview) override { previews.push_back(std::move(preview)); }
};

}  // namespace hexoderm::test
