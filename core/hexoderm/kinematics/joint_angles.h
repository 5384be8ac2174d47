#pragma once

#include <functional>
#include <map>
#include <string>

namespace hexoderm {

/// Where the joints of a robot stand at one moment, by their names in its URDF: rad, for prismatic joints m. Finite.
struct JointAngles {
  std::map<std::string, double, std::less<>> positions;
  friend bool operator==(const JointAngles&, const JointAngles&) = default;
};

}  // namespace hexoderm
