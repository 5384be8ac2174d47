#pragma once

#include <vtkMapper.h>
#include <vtkNew.h>
#include <vtkPlane.h>
#include <Eigen/Core>
#include <initializer_list>
#include <optional>

namespace hexoderm {

/// A plane that cuts the scene open: what lies in front of it, on the side that `normal` points to, is not drawn.
struct SceneCut {
  Eigen::Vector3d normal = Eigen::Vector3d::UnitZ();  ///< unit, in the scene
  double offset_m = 0;                                ///< of the plane's points along the normal

  [[nodiscard]] bool removes(const Eigen::Vector3d& p) const { return normal.dot(p) > offset_m; }

  /// Shortens the line from `from` to `to` to what is left of it; false if that is nothing.
  bool shorten(Eigen::Vector3d& from, Eigen::Vector3d& to) const {
    const double from_before_m = normal.dot(from) - offset_m;
    const double to_before_m = normal.dot(to) - offset_m;
    if (from_before_m > 0 && to_before_m > 0) return false;
    if (from_before_m <= 0 && to_before_m <= 0) return true;
    const Eigen::Vector3d crossing = from + from_before_m / (from_before_m - to_before_m) * (to - from);
    (from_before_m > 0 ? from : to) = crossing;
    return true;
  }

  friend bool operator==(const SceneCut& a, const SceneCut& b) {
    return a.normal == b.normal && a.offset_m == b.offset_m;
  }
};

/// The cut as VTK draws it. A plane that moves is the same object with other values, so that nothing is sent to the
/// graphics card again.
class DrawnCut {
 public:
  /// The mappers must be the same in each call; none: they are drawn whole.
  void set(const std::optional<SceneCut>& cut, std::initializer_list<vtkMapper*> mappers) {
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

  [[nodiscard]] const std::optional<SceneCut>& get() const { return cut_; }

 private:
  std::optional<SceneCut> cut_;
  vtkNew<vtkPlane> plane_;
};

}  // namespace hexoderm
