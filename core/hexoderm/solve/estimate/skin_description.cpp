#include "hexoderm/solve/estimate/skin_description.h"

#include "hexoderm/solve/metrics/pose_summary.h"
#include "hexoderm/solve/result/patch_placements.h"

#include <utility>

namespace hexoderm {

std::shared_ptr<Reconstruction> describeSkin(const SkinLinks& skin, std::vector<PatchReconstruction> patches) {
  const SessionSnapshot& snapshot = skin.snapshot();
  auto result = std::make_shared<Reconstruction>();
  result->revision = snapshot.revision;
  result->solver = solverName(skin.options().solver);
  result->options = skin.options();
  result->source = snapshot.source;
  result->model = snapshot.model;
  result->patches = std::move(patches);
  result->poses = summarisePoses(snapshot, skin.table(), *result);
  result->robot = snapshot.robot;
  result->placements = placementsOf(result->patches, snapshot.placements);
  result->layout = computeFlatLayout(skin.model(), result->patches);
  return result;
}

}  // namespace hexoderm
