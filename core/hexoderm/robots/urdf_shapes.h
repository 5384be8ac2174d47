#pragma once

// What links of a URDF look like.

#include "hexoderm/base/error.h"
#include "hexoderm/robots/robot_model.h"

#include <cstddef>
#include <utility>

namespace pugi {
class xml_node;
}

namespace hexoderm {

/// What is wrong with an element of a URDF, or with one of its attributes.
struct UrdfFault : FormatError {
  UrdfFault(std::ptrdiff_t element, Message what) : FormatError(std::move(what)), offset(element) {}
  std::ptrdiff_t offset;  ///< of the element, from the beginning of the document
};

/// An <origin>, or an empty element for none. Throws UrdfFault for what is malformed or too large.
SE3 urdfOrigin(const pugi::xml_node& origin);

/// The shape in a <visual> or <collision>. Throws UrdfFault for what is missing or malformed: urdfdom would leave out
/// that shape and all that follow it in the link.
LinkShape urdfShape(const pugi::xml_node& element);

}  // namespace hexoderm
