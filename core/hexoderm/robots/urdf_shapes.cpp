#include "hexoderm/robots/urdf_shapes.h"

#include "hexoderm/base/text.h"
#include "hexoderm/robots/mesh_input.h"
#include "hexoderm/robots/urdf_document.h"

#include <cmath>
#include <utility>

#include <pugixml.hpp>

namespace hexoderm {
namespace {

/// No file system has longer ones.
constexpr std::size_t kLongestMeshAddress = 4096;

[[noreturn]] void refuseUrdfAttribute(const pugi::xml_node& element, const char* name, Message expected) {
  const pugi::xml_attribute found = element.attribute(name);
  if (!found) {
    throw UrdfFault{element.offset_debug(),
                    message("<{}> has no {}: expected {}", element.name(), name, std::move(expected))};
  }
  throw UrdfFault{element.offset_debug(), message("<{} {}=\"{}\">: expected {}", element.name(), name,
                                                  excerptOf(found.value()), std::move(expected))};
}

/// The numbers of an attribute: `N` of them, separated by blanks, that all fit.
template <int N>
Eigen::Matrix<double, N, 1> urdfNumbers(const pugi::xml_node& element, const char* name, bool (*fits)(double),
                                        const Message& expected) {
  std::string_view text = element.attribute(name).value();
  Eigen::Matrix<double, N, 1> numbers;
  for (double& number : numbers) {
    const std::optional<double> value = meshNumber(takeWord(text));
    if (!value || !fits(*value)) refuseUrdfAttribute(element, name, expected);
    number = *value;
  }
  if (!takeWord(text).empty()) refuseUrdfAttribute(element, name, expected);
  return numbers;
}

bool isUrdfLength(double value) { return value > 0 && value <= kFarthestJoint_m; }

double urdfLength(const pugi::xml_node& element, const char* name) {
  return urdfNumbers<1>(element, name, isUrdfLength,
                        message("a length above 0 and at most {} m", Number{kFarthestJoint_m, 0}))[0];
}

MeshShape urdfMesh(const pugi::xml_node& mesh) {
  MeshShape shape;
  shape.file = mesh.attribute("filename").value();
  if (shape.file.empty() || shape.file.size() > kLongestMeshAddress) {
    refuseUrdfAttribute(mesh, "filename", message("package://NAME/FILE, file:///FILE or a path"));
  }
  if (mesh.attribute("scale")) {
    shape.scale = urdfNumbers<3>(
        mesh, "scale", [](double value) { return value != 0 && std::abs(value) <= kMaxJointPosition; },
        message("three numbers within {}, none of them 0, separated by blanks", Number{kMaxJointPosition, 0}));
  }
  return shape;
}

/// The only shape in the only <geometry> of an element; none if there is none.
pugi::xml_node urdfGeometry(const pugi::xml_node& element) {
  const pugi::xml_node geometry = element.child("geometry");
  if (const pugi::xml_node second = geometry.next_sibling("geometry")) {
    throw UrdfFault{second.offset_debug(),
                    message("<{}> has a second <geometry>: expected one, and another <{}> for each further shape",
                            element.name(), element.name())};
  }
  const auto isElement = [](const pugi::xml_node& child) { return child.type() == pugi::node_element; };
  const pugi::xml_node shape = geometry.find_child(isElement);
  for (pugi::xml_node other = shape.next_sibling(); other; other = other.next_sibling()) {
    if (!isElement(other)) continue;
    throw UrdfFault{
        other.offset_debug(),
        message("<geometry> has a second shape, <{}>: expected one, and another <{}> for each further shape",
                excerptOf(other.name()), element.name())};
  }
  return shape;
}

}  // namespace

SE3 urdfOrigin(const pugi::xml_node& origin) {
  SE3 T;
  if (origin.attribute("xyz")) {
    T.t = urdfNumbers<3>(
        origin, "xyz", [](double value) { return std::abs(value) <= kFarthestJoint_m; },
        message("three coordinates within {} m, separated by blanks", Number{kFarthestJoint_m, 0}));
  }
  if (origin.attribute("rpy")) {
    T.R = rotationFromRpy(urdfNumbers<3>(
        origin, "rpy", [](double value) { return std::abs(value) <= kMaxJointPosition; },
        message("three angles within {} rad, separated by blanks", Number{kMaxJointPosition, 0})));
  }
  return T;
}

LinkShape urdfShape(const pugi::xml_node& element) {
  LinkShape result{urdfOrigin(element.child("origin")), {}};
  const pugi::xml_node shape = urdfGeometry(element);
  const std::string_view kind = shape.name();
  if (kind == "box") {
    result.shape = BoxShape{urdfNumbers<3>(
        shape, "size", isUrdfLength,
        message("three lengths above 0 and at most {} m, separated by blanks", Number{kFarthestJoint_m, 0}))};
  } else if (kind == "cylinder") {
    result.shape = CylinderShape{urdfLength(shape, "radius"), urdfLength(shape, "length")};
  } else if (kind == "sphere") {
    result.shape = SphereShape{urdfLength(shape, "radius")};
  } else if (kind == "mesh") {
    result.shape = urdfMesh(shape);
  } else if (shape) {
    throw UrdfFault{shape.offset_debug(), message("<{}>: expected a box, cylinder, sphere or mesh", excerptOf(kind))};
  } else {
    throw UrdfFault{element.offset_debug(),
                    message("<{}> has no <geometry> with a box, cylinder, sphere or mesh", element.name())};
  }
  return result;
}

}  // namespace hexoderm
