#include "hexoderm/base/joint_angles.h"

#include "hexoderm/base/error.h"

#include <cmath>

namespace hexoderm {

void requirePosition(const std::string& joint, double position) {
  if (std::abs(position) <= kMaxJointPosition) return;  // NaN is not
  throw InvalidArgument(
      message("joint {}: expected a finite position, at most {}", joint, Number{kMaxJointPosition, 0}));
}

void JointAngles::validate() const {
  for (const auto& [name, position] : positions) {
    if (name.empty()) throw InvalidArgument(message("a joint's position needs the name of the joint"));
    requirePosition(name, position);
  }
}

}  // namespace hexoderm
