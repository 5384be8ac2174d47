#pragma once

#include "hexoderm/mounting/attachment/links.h"
#include "hexoderm/mounting/place/place.h"

#include <optional>
#include <string_view>

namespace hexoderm {

/// How a patch is turned on a link, with its covariance, as findLinks() found it: of the link that it is placed on, of
/// one that fits, or of the one that comes nearest. nullopt where the link is none of these.
std::optional<KnownRotation> rotationByGravity(const PatchLinks& patch, std::string_view link);

/// A turn that gravity does not allow.
struct AgainstGravity {
  double angle_rad = 0;  ///< about the axes that are known
  double sigma_rad = 0;  ///< of how the patch is turned about them, the worst way
};
/// Whether R_l_o is another turn than the known one, about axes that are known to 15 degrees or better: by more than
/// `slack_rad` and its uncertainty make probable (99.9 %). `slack_rad`, above 0, is how far off R_l_o may be itself, 1
/// sigma an axis.
std::optional<AgainstGravity> againstGravity(const KnownRotation& known, const Eigen::Matrix3d& R_l_o,
                                             double slack_rad);

}  // namespace hexoderm
