#include "hexoderm/skin/patch_on_link.h"

#include "hexoderm/base/covariance.h"
#include "hexoderm/base/error.h"
#include "hexoderm/base/is_rotation.h"
#include "hexoderm/base/limits.h"
#include "hexoderm/base/message.h"

namespace hexoderm {
namespace {

[[noreturn]] void failPlacement(CellId origin, Message why) {
  throw InvalidArgument(message("the patch of cell {}", origin), std::move(why));
}

bool isSigmaOfLength(double sigma_m) { return sigma_m > 0 && sigma_m <= kMaxLength_m; }

}  // namespace

void RobotDescription::validate() const {
  if (urdf.empty()) throw InvalidArgument(message("the description of a robot needs a file"));
  for (const auto& [name, folder] : packages) {
    if (name.empty() || folder.empty()) throw InvalidArgument(message("a package has a name and a folder"));
  }
}

void PatchPlacement::validate() const {
  for (const KnownPoint& point : points) {
    if (!isWithin(point.x_l, kMaxLength_m) || !isSigmaOfLength(point.sigma_m)) {
      failPlacement(origin, message("expected a point within {} m and a sigma above 0 for cell {}",
                                    Number{kMaxLength_m, 0}, point.cell));
    }
  }
  for (const KnownDistance& distance : distances) {
    const bool is_length = distance.distance_m > 0 && distance.distance_m <= kMaxLength_m;
    if (distance.a == distance.b || !is_length || !isSigmaOfLength(distance.sigma_m)) {
      failPlacement(origin, message("expected a distance above 0 between two cells, and a sigma above 0, for cell {}",
                                    distance.a));
    }
  }
  if (!place) return;
  if (place->origin != origin || place->link != link || link.empty()) {
    failPlacement(origin, message("expected a place of this patch on its link"));
  }
  if (!isWithin(place->T_l_o.t, kMaxLength_m) || !isRotation(place->T_l_o.R)) {
    failPlacement(origin, message("expected a rotation and a translation within {} m", Number{kMaxLength_m, 0}));
  }
  if (place->cov_t_r && !isCovariance(*place->cov_t_r)) {
    failPlacement(origin, message("expected a covariance (positive semidefinite)"));
  }
}

}  // namespace hexoderm
