#include "hexoderm/robots/urdf_document.h"

#include "hexoderm/base/error.h"
#include "hexoderm/base/spelling_suggestion.h"
#include "hexoderm/base/text.h"
#include "hexoderm/robots/mesh_input.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <iterator>
#include <pugixml.hpp>
#include <set>
#include <utility>

namespace hexoderm {
namespace {

/// What is wrong with an element of a URDF, or with one of its attributes.
struct UrdfFault : FormatError {
  UrdfFault(std::ptrdiff_t element, Message what) : FormatError(std::move(what)), offset(element) {}
  std::ptrdiff_t offset;  ///< of the element, from the beginning of the document
};

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

/// An <origin>, or an empty element for none. Throws UrdfFault for what is malformed or too large.
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

/// The shape in a <visual> or <collision>. Throws UrdfFault for what is missing or malformed: urdfdom would leave out
/// that shape and all that follow it in the link.
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

/// A humanoid with hands has 200 links; a file with more is made to keep a reader busy.
constexpr std::size_t kMaxUrdfLinks = 10'000;
constexpr std::size_t kMaxUrdfMegabytes = 20;
/// URDF nests five deep, extensions for simulators a little more; urdfdom's reader is recursive.
constexpr int kDeepestElement = 100;
/// The reader compares each attribute with those before it.
constexpr std::ptrdiff_t kMaxAttributes = 100;
constexpr std::size_t kLongestUrdfName = 1000;

class UrdfChecker {
 public:
  UrdfChecker(std::string_view text, const std::string& file) : text_(text), file_(file) {}

  UrdfDocument check() {
    if (text_.size() > kMaxUrdfMegabytes * 1'000'000) {
      throw FormatError(file_, message("is too large: at most {} MB of XML are read", kMaxUrdfMegabytes));
    }
    const pugi::xml_parse_result parsed =
        document_.load_buffer(text_.data(), text_.size(), pugi::parse_default | pugi::parse_doctype);
    if (!parsed) {
      failAt(lineAt(parsed.offset),
             message("this is not well-formed XML ({}; truncated?), expected a URDF", parsed.description()));
    }
    const pugi::xml_node robot = document_.document_element();
    requireNoDefinitions();
    DeepAndXacro walker(*this);
    document_.traverse(walker);
    if (std::strcmp(robot.name(), "robot") != 0) {
      fail(robot, message("expected a URDF, whose root element is <robot>, found <{}>", excerptOf(robot.name())));
    }
    requireShortName(robot);
    readLinks(robot);
    readJoints(robot);
    requireTree();
    return std::move(result_);
  }

 private:
  struct JointEnds {
    std::string name;
    std::string parent;
    std::string child;
    pugi::xml_node node;
  };

  /// Neither this reader nor urdfdom's expands entities.
  void requireNoDefinitions() const {
    for (const pugi::xml_node& node : document_.children()) {
      if (node.type() != pugi::node_doctype || std::string_view(node.value()).find('[') == std::string_view::npos)
        continue;
      fail(node, message("the DOCTYPE has definitions, entities for example, which are not read: expected a URDF "
                         "without them, with each entity replaced by its text"));
    }
  }

  /// Fails for elements that are nested deeply, or have many attributes or one twice, and for xacro's.
  class DeepAndXacro : public pugi::xml_tree_walker {
   public:
    explicit DeepAndXacro(const UrdfChecker& checker) : checker_(checker) {}
    bool for_each(pugi::xml_node& node) override {
      if (depth() > kDeepestElement) checker_.fail(node, message("the elements are nested too deeply for a URDF"));
      if (std::distance(node.attributes_begin(), node.attributes_end()) > kMaxAttributes) {
        checker_.fail(node, message("an element has more than {} attributes", kMaxAttributes));
      }
      requireDifferentAttributes(node);
      if (std::string_view(node.name()).starts_with("xacro:")) failXacro(node, node.name());
      if (std::strcmp(node.name(), "link") != 0 && std::strcmp(node.name(), "joint") != 0) return true;
      const std::string_view name = node.attribute("name").value();
      if (name.find("${") != std::string_view::npos) failXacro(node, name);
      return true;
    }

   private:
    void requireDifferentAttributes(const pugi::xml_node& node) const {
      std::set<std::string_view> names;
      for (const pugi::xml_attribute& attribute : node.attributes()) {
        if (names.insert(attribute.name()).second) continue;
        checker_.fail(node, message("<{}> has the attribute {} twice: expected each attribute once",
                                    excerptOf(node.name()), excerptOf(attribute.name())));
      }
    }
    [[noreturn]] void failXacro(const pugi::xml_node& node, std::string_view what) const {
      checker_.fail(node, message("{} is xacro, from which URDF is made: run xacro first, and open what it writes",
                                  excerptOf(what)));
    }
    const UrdfChecker& checker_;
  };

  /// Counts on from where it was asked last: most ask in the order of the text.
  [[nodiscard]] std::ptrdiff_t lineAt(std::ptrdiff_t offset) const {
    const auto end = std::min(static_cast<std::size_t>(std::max<std::ptrdiff_t>(offset, 0)), text_.size());
    if (end < counted_to_) {
      counted_to_ = 0;
      line_ = 0;
    }
    line_ += std::ranges::count(text_.substr(counted_to_, end - counted_to_), '\n');
    counted_to_ = end;
    return line_ + 1;
  }
  [[nodiscard]] Message inLine(std::ptrdiff_t line, Message what) const {
    return located(file_, located(message("line {}", line), std::move(what)));
  }
  [[noreturn]] void failAt(std::ptrdiff_t line, Message what) const {
    throw FormatError(inLine(line, std::move(what)));
  }
  [[noreturn]] void fail(const pugi::xml_node& node, Message what) const {
    failAt(lineAt(node.offset_debug()), std::move(what));
  }

  void requireShortName(const pugi::xml_node& node) const {
    const std::string_view name = node.attribute("name").value();
    if (name.size() <= kLongestUrdfName) return;
    fail(node,
         message("<{} name=\"{}\">: expected at most {} characters", node.name(), excerptOf(name), kLongestUrdfName));
  }

  std::string nameOf(const pugi::xml_node& node, const std::map<std::string, std::ptrdiff_t>& known) const {
    requireShortName(node);
    std::string name = node.attribute("name").value();
    if (name.empty()) fail(node, message("<{}> has no name", node.name()));
    const auto earlier = known.find(name);
    if (earlier != known.end()) {
      fail(node, message("there is a {} {} already, in line {}: expected each name once", node.name(), name,
                         earlier->second));
    }
    return name;
  }

  void readLinks(const pugi::xml_node& robot) {
    for (const pugi::xml_node node : robot.children("link")) {
      const std::string name = nameOf(node, result_.line_of_link);
      result_.line_of_link.emplace(name, lineAt(node.offset_debug()));
      result_.links.push_back({name, std::nullopt, shapesOf(node, name, "visual"), shapesOf(node, name, "collision")});
      if (result_.links.size() > kMaxUrdfLinks) fail(node, message("there are more than {} links", kMaxUrdfLinks));
    }
    if (result_.links.empty()) fail(robot, message("expected links, but the robot has none"));
  }

  [[nodiscard]] std::vector<LinkShape> shapesOf(const pugi::xml_node& link, const std::string& name,
                                                const char* element) const {
    std::vector<LinkShape> shapes;
    for (const pugi::xml_node node : link.children(element)) {
      try {
        shapes.push_back(urdfShape(node));
      } catch (const UrdfFault& fault) {
        shapes.push_back(
            {{}, UnreadShape{inLine(lineAt(fault.offset), located(message("link {}", name), fault.message()))}});
      }
    }
    return shapes;
  }

  std::string linkOf(const JointEnds& joint, const char* end) const {
    const pugi::xml_node node = joint.node.child(end);
    const std::string name = node.attribute("link").value();
    if (name.empty()) fail(joint.node, message("joint {} has no <{} link=\"...\">", joint.name, end));
    if (!result_.line_of_link.contains(name)) {
      std::vector<std::string> names;
      for (const RobotLink& link : result_.links) names.push_back(link.name);
      fail(node, inRow({message("joint {}: <{} link=\"{}\"> names none of the robot's links", joint.name, end,
                                excerptOf(name)),
                        didYouMean(name, names)},
                       "; "));
    }
    return name;
  }

  void requireOrigin(const JointEnds& joint) const {
    try {
      urdfOrigin(joint.node.child("origin"));
    } catch (const UrdfFault& fault) {
      failAt(lineAt(fault.offset), located(message("joint {}", joint.name), fault.message()));
    }
  }

  void readJoints(const pugi::xml_node& robot) {
    for (const pugi::xml_node node : robot.children("joint")) {
      JointEnds joint{nameOf(node, result_.line_of_joint), {}, {}, node};
      joint.parent = linkOf(joint, "parent");
      joint.child = linkOf(joint, "child");
      const auto [earlier, is_first] = carrier_.emplace(joint.child, ends_.size());
      if (!is_first) {
        fail(node, message("link {} has two parents, by the joints {} and {}: a URDF is a tree", joint.child,
                           ends_[earlier->second].name, joint.name));
      }
      result_.line_of_joint.emplace(joint.name, lineAt(node.offset_debug()));
      result_.joints.push_back(joint.name);
      requireOrigin(joint);
      ends_.push_back(std::move(joint));
    }
  }

  /// Every link has one parent at most by now: going up from it ends at a root or goes round.
  void requireTree() const {
    std::map<std::string, std::string> root_of;
    std::string first_root;
    for (const RobotLink& link : result_.links) {
      std::set<std::string> way;
      std::string at = link.name;
      while (!root_of.contains(at)) {
        if (!way.insert(at).second) failLoop(at);
        const auto joint = carrier_.find(at);
        if (joint == carrier_.end()) break;
        at = ends_[joint->second].parent;
      }
      const auto known = root_of.find(at);
      const std::string root = known == root_of.end() ? at : known->second;
      for (const std::string& passed : way) root_of[passed] = root;
      if (first_root.empty()) first_root = root;
      if (root != first_root) {
        failAt(result_.line_of_link.at(root),
               message("no joint carries link {}, nor link {}: expected one root", root, first_root));
      }
    }
  }

  [[noreturn]] void failLoop(const std::string& link) const {
    constexpr std::size_t kMaxNamed = 8;
    std::vector<std::string> joints;
    std::string at = link;
    do {
      const JointEnds& joint = ends_[carrier_.at(at)];
      joints.push_back(joint.name);
      at = joint.parent;
    } while (at != link && joints.size() < kMaxNamed);
    std::ranges::reverse(joints);
    fail(ends_[carrier_.at(link)].node,
         message("the joints {} form a loop: a URDF is a tree, whose root no joint carries", joints));
  }

  std::string_view text_;
  const std::string& file_;
  pugi::xml_document document_;
  UrdfDocument result_;
  std::vector<JointEnds> ends_;
  std::map<std::string, std::size_t> carrier_;  ///< of a link: index of the joint that it is the child of
  mutable std::size_t counted_to_ = 0;          ///< of lineAt(): so far
  mutable std::ptrdiff_t line_ = 0;             ///< of lineAt(): ends of lines before
};

}  // namespace

UrdfDocument checkUrdf(std::string_view text, const std::string& file) { return UrdfChecker(text, file).check(); }

}  // namespace hexoderm
