#pragma once

// The text of a URDF, checked for what urdfdom lets pass or reports without a place.

#include "hexoderm/robots/robot_model.h"

#include <cstddef>
#include <map>
#include <string>
#include <string_view>
#include <vector>

namespace hexoderm {

/// No robot is larger.
inline constexpr double kFarthestJoint_m = 1000;

/// What is in a URDF, in the order of the text.
struct UrdfDocument {
  std::vector<RobotLink> links;  ///< their names and shapes; which joints carry them is for urdfdom to say
  std::vector<std::string> joints;
  std::map<std::string, std::ptrdiff_t> line_of_link;
  std::map<std::string, std::ptrdiff_t> line_of_joint;
};

/// Reads the text as XML and makes sure of a tree: a root element <robot>, links and joints of different names, joints
/// between links that exist, one root, no link with two parents, no loop. Throws FormatError naming file, line, place
/// and expectation. Text of xacro is recognised. A malformed shape becomes an UnreadShape.
UrdfDocument checkUrdf(std::string_view text, const std::string& file);

}  // namespace hexoderm
