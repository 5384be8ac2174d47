#pragma once

#include "hexoderm/device/ground_truth.h"
#include "hexoderm/device/sample_frame.h"
#include "hexoderm/solve/checks/evaluation.h"
#include "widgets/coloring/coloring.h"

#include <Eigen/Core>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace hexoderm {

/// Things that lie over a patch: results and truths about the reconstruction that is shown, which is no part of this
/// value. The caller brings them up to date, or takes them back, when another reconstruction is shown. Null members are
/// not there; two values are equal if they hold the same objects.
struct PatchOverlays {
  std::shared_ptr<const GroundTruth> truth;                   ///< placements of a simulated skin, drawn as outlines
  std::shared_ptr<const SurfaceEvaluation> surface;           ///< fitted to a patch
  std::shared_ptr<const LoopEvaluation> loop;                 ///< its gap is drawn
  std::shared_ptr<const std::vector<Comparison>> comparison;  ///< with another calibration, per patch

  friend bool operator==(const PatchOverlays&, const PatchOverlays&) = default;
};

/// The state of a patch that changes from moment to moment while a skin is connected, and with the picked pose. Cheap
/// to copy. Up directions are unit vectors in the frame of the largest patch.
struct PatchMoment {
  std::optional<PoseId> pose;  ///< its gravity is what the arrow shows; none: the last pose's
  /// The cells' present readings; null: none. The distances to a fitted surface are not taken from here but from
  /// PatchOverlays.
  std::shared_ptr<const CellReadings> readings;
  /// Up at this moment: the picture turns so that it stays upwards while the part is turned, and the arrow of gravity
  /// follows. None: the picture stays as it is, and the arrow is a pose's.
  std::optional<Eigen::Vector3d> up_o;
  /// Up in the next pose: shown as a ghost beside the skin. None: no ghost.
  std::optional<Eigen::Vector3d> next_up_o;
  /// The cell that the present instruction speaks of: it is lit and named. None: it speaks of none.
  std::optional<CellId> told_cell;
  /// The angle by which the part is to be turned to get there ("90°", UTF-8), written beside the ghost; may be empty.
  std::string next_turn;
};

/// Null if there is neither a sample nor a temperature.
inline std::shared_ptr<const CellReadings> readingsOf(const std::vector<CellSample>& samples,
                                                      const std::vector<CellTemperature>& temperatures = {}) {
  if (samples.empty() && temperatures.empty()) return nullptr;
  auto readings = std::make_shared<CellReadings>();
  for (const CellSample& sample : samples) readings->acceleration_g[sample.cell] = sample.acceleration_g;
  for (const CellTemperature& reading : temperatures) readings->temperature_c[reading.cell] = reading.temperature_c;
  return readings;
}

}  // namespace hexoderm
