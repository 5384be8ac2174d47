#pragma once

#include <functional>
#include <map>
#include <string>

namespace hexoderm {

/// No joint stands farther from its zero, rad or m.
inline constexpr double kMaxJointPosition = 1e6;

/// Throws InvalidArgument naming the joint for a position that is not finite or beyond kMaxJointPosition.
void requirePosition(const std::string& joint, double position);

/// Where the joints of a robot stand at one moment, by their names in its URDF: rad, for prismatic joints m. Finite.
struct JointAngles {
  std::map<std::string, double, std::less<>> positions;
  /// Throws InvalidArgument for a position that is not finite or beyond kMaxJointPosition, and for a joint without a
  /// name.
  void validate() const;
  friend bool operator==(const JointAngles&, const JointAngles&) = default;
};

}  // namespace hexoderm
