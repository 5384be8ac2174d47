#pragma once

#include "hexoderm/device/ground_truth.h"
#include "hexoderm/solve/checks/evaluation.h"

#include <memory>
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

}  // namespace hexoderm
