#include "hexoderm/kinematics/joint_angles.h"

#include "hexoderm/util/error.h"

#include <cmath>

namespace hexoderm {

void JointAngles::validate() const {
  for (const auto& [name, position] : positions) {
    if (name.empty()) throw InvalidArgument(message("a joint's position needs the name of the joint"));
    if (std::abs(position) <= kMostJointPosition) continue;  // NaN is not
    throw InvalidArgument(
        message("joint {}: expected a finite position, at most {}", name, Number{kMostJointPosition, 0}));
  }
}

}  // namespace hexoderm
