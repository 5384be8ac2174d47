#pragma once

#include "hexoderm/base/ids.h"
#include "hexoderm/base/message.h"
#include "hexoderm/device/sample_frame.h"

#include <Eigen/Core>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

namespace hexoderm {

/// The mean of a cell's readings in one pose, eq. (19) of the paper.
struct GravitySample {
  CellId cell;
  Eigen::Vector3d mean_g = Eigen::Vector3d::Zero();  ///< accelerometer's axes; not normalised
  /// Covariance of the mean; zero: not known. The solver takes no variance as less than a hand's tremor of 3 mg makes.
  Eigen::Matrix3d cov_g2 = Eigen::Matrix3d::Zero();
  std::uint32_t count = 0;                ///< samples averaged; 0: not known
  std::optional<double> temperature_c{};  ///< absent where the device does not measure it
};

/// One captured pose: gravity as every cell saw it while the part was held still. Immutable once captured.
struct PoseCapture {
  PoseId id;
  Message label{};
  std::vector<GravitySample> samples{};
  std::optional<std::int64_t> taken_at_ms{};  ///< milliseconds since 1970, UTC; absent where it is not known
};

/// Averages frames into a pose, per cell: mean, covariance of the mean (sample covariance / count) and count.
/// Means that a device made are pooled by their counts. Cells without a sample do not appear. Samples and means that
/// are not finite, or beyond kMaxAcceleration_g, are left out.
PoseCapture averageFrames(std::span<const SampleFrame> frames, PoseId id, Message label);

}  // namespace hexoderm
