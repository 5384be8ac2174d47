#include "widgets/scene/scene_cut.h"

#include <vtkMapper.h>

namespace hexoderm {

bool SceneCut::shorten(Eigen::Vector3d& from, Eigen::Vector3d& to) const {
  const double from_before_m = normal.dot(from) - offset_m;
  const double to_before_m = normal.dot(to) - offset_m;
  if (from_before_m > 0 && to_before_m > 0) return false;
  if (from_before_m <= 0 && to_before_m <= 0) return true;
  const Eigen::Vector3d crossing = from + from_before_m / (from_before_m - to_before_m) * (to - from);
  (from_before_m > 0 ? from : to) = crossing;
  return true;
}

void DrawnCut::set(const std::optional<SceneCut>& cut, std::initializer_list<vtkMapper*> mappers) {
  const bool was_cut = cut_.has_value();
  cut_ = cut;
  if (cut) {
    // VTK keeps the side that its normal points to.
    const Eigen::Vector3d kept = -cut->normal;
    const Eigen::Vector3d origin = cut->offset_m * cut->normal;
    plane_->SetNormal(kept.x(), kept.y(), kept.z());
    plane_->SetOrigin(origin.x(), origin.y(), origin.z());
  }
  if (cut.has_value() == was_cut) return;
  for (vtkMapper* mapper : mappers) {
    if (cut) {
      mapper->AddClippingPlane(plane_);
    } else {
      mapper->RemoveClippingPlane(plane_);
    }
  }
}

}  // namespace hexoderm
