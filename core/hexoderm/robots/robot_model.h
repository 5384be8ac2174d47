#pragma once

#include "hexoderm/base/joint_angles.h"
#include "hexoderm/base/message.h"
#include "hexoderm/base/se3.h"
#include "hexoderm/base/triangle_mesh.h"

#include <cstddef>
#include <filesystem>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

namespace hexoderm {

/// How a joint moves.
enum class JointType { Fixed, Revolute, Continuous, Prismatic };

/// How far a joint moves.
struct JointLimits {
  double lower = 0;  ///< rad; prismatic: m
  double upper = 0;
};
/// The joint stands at multiplier * (position of `joint`) + offset.
struct JointMimic {
  std::size_t joint = 0;  ///< index in RobotModel::joints()
  double multiplier = 1;
  double offset = 0;
};
/// A joint of a robot, as its URDF has it.
struct RobotJoint {
  std::string name;
  JointType type = JointType::Fixed;
  std::size_t parent = 0;  ///< index in RobotModel::links()
  std::size_t child = 0;
  SE3 T_parent_joint;  ///< at position 0, where the joint's frame is that of the child link
  /// Unit, in the joint's frame, and so in that of the child link as well; zero for a fixed joint.
  Eigen::Vector3d axis = Eigen::Vector3d::Zero();
  std::optional<JointLimits> limits;
  std::optional<JointMimic> mimic;
  /// Has a position of its own: neither fixed nor mimicking another joint.
  [[nodiscard]] bool isFree() const { return type != JointType::Fixed && !mimic; }
  /// Turns about its axis, with limits or without.
  [[nodiscard]] bool turns() const { return type == JointType::Revolute || type == JointType::Continuous; }
};

/// A box around the origin of its frame.
struct BoxShape {
  Eigen::Vector3d size_m;
};
/// About the z axis.
struct CylinderShape {
  double radius_m = 0;
  double length_m = 0;
};
/// A sphere around the origin of its frame.
struct SphereShape {
  double radius_m = 0;
};
/// A mesh in a file.
struct MeshShape {
  std::string file;  ///< as the URDF has it: package://..., file://... or a path
  Eigen::Vector3d scale = Eigen::Vector3d::Ones();
};
/// A shape that is missing or malformed in the URDF.
struct UnreadShape {
  Message why;  ///< file, line, link, element and attribute, what was found and what is expected
};
/// A piece of what a link looks like.
struct LinkShape {
  SE3 T_l_shape;
  std::variant<BoxShape, CylinderShape, SphereShape, MeshShape, UnreadShape> shape;
};
/// A link of a robot, as its URDF has it.
struct RobotLink {
  std::string name;
  std::optional<std::size_t> joint;  ///< that carries the link, index in RobotModel::joints(); none for the root
  std::vector<LinkShape> visuals;
  std::vector<LinkShape> collisions;
};

/// Which of a link's two descriptions of its body is meant. `Any`: the visual one where there is one, because it is the
/// finer, else the one for collisions.
enum class LinkBody { Any, Visual, Collision };

/// A mesh whose size no link has: its file is probably in another unit than metres. Nothing is ever scaled for it.
struct SuspectedUnit {
  double size_m = 0;  ///< the longest side of the mesh's box, as the file and the URDF's scale have it
  double factor = 1;  ///< that would make it plausible: 0.001 for a file in millimetres
  Message message;    ///< says so, with the figures
};

/// Where packages are: "package://NAME/rest" and "model://NAME/rest" mean rest in the folder of NAME. A package that is
/// not named here is looked for in the folders that the URDF lies in: the nearest one called NAME.
using PackageFolders = std::map<std::string, std::filesystem::path>;

/// A robot as its URDF describes it: a tree of links that joints carry. Frames: `l` a link, `w` the root link, which is
/// the robot's base. Immutable; copies share everything.
///
/// Read by urdfdom; kinematics by Orocos KDL. What urdfdom lets pass or reports without a place (loops, links with two
/// parents, unknown links, numbers that are not finite or that no robot has) is looked for before.
///
/// Floating and planar joints are taken as fixed at their zero, as KDL's own reader of URDF does; notes() says so.
class RobotModel {
 public:
  /// Throws StorageError (missing, unreadable) or FormatError, which name file, place and expectation. Meshes are not
  /// opened, except by hexoderm-cli, which looks up the buffers of glTF files because it never replaces an input;
  /// malformed shapes of links are for bodyOf() to refuse.
  static RobotModel read(const std::filesystem::path& urdf, PackageFolders packages = {});
  /// The same of a text; `file` is named in errors, and meshes are looked for from its folder.
  static RobotModel parse(std::string_view urdf, const std::filesystem::path& file, PackageFolders packages = {});

  [[nodiscard]] const std::string& name() const;            ///< the robot's own name
  [[nodiscard]] const std::filesystem::path& file() const;  ///< the URDF that it was read from
  /// SHA-256 of the URDF's bytes, in hexadecimal digits.
  [[nodiscard]] const std::string& sha256() const;
  [[nodiscard]] const std::vector<RobotLink>& links() const;    ///< in the order of the file
  [[nodiscard]] const std::vector<RobotJoint>& joints() const;  ///< in the order of the file
  [[nodiscard]] std::size_t rootLink() const;                   ///< the index of the link that no joint moves
  /// What was taken otherwise than the file says; empty for most robots.
  [[nodiscard]] const std::vector<Message>& notes() const;

  /// Index of a link or joint. Throw InvalidArgument naming the file, and the name that may have been meant.
  [[nodiscard]] std::size_t linkNamed(std::string_view name) const;
  /// The index of a joint; throws InvalidArgument naming those there are.
  [[nodiscard]] std::size_t jointNamed(std::string_view name) const;
  /// nullopt if there is none of the name.
  [[nodiscard]] std::optional<std::size_t> findLink(std::string_view name) const;
  /// The index of a joint; nothing if there is none of this name.
  [[nodiscard]] std::optional<std::size_t> findJoint(std::string_view name) const;

  /// T_w_l of every link, by index. A free joint that is not named stands at 0; a joint that mimics another follows it
  /// unless it is named itself. Positions beyond the limits are taken as they are.
  /// With these, joint j's axis in the base is T_w_l[joints()[j].child].R * joints()[j].axis, and a revolute joint's
  /// line goes through T_w_l[joints()[j].child].t.
  /// Throws InvalidArgument for a name that no joint has, and for a position that is not finite or beyond 1e6.
  [[nodiscard]] std::vector<SE3> forward(const JointAngles& angles) const;

  /// The free joints on which T_w_l depends, ascending; a mimicking joint counts as the one it follows.
  [[nodiscard]] std::vector<std::size_t> freeJointsTo(std::size_t link) const;
  /// Links that are fixed to each other, by fixed joints alone, are one rigid part: the one of them nearest to the
  /// root.
  [[nodiscard]] std::size_t partOf(std::size_t link) const;
  /// Names of the free joints, in the order of joints().
  [[nodiscard]] std::vector<std::string> freeJointNames() const;

  /// Whether something describes the link's body.
  [[nodiscard]] bool hasBody(std::size_t link, LinkBody body = LinkBody::Any) const;
  /// The link's body in its frame l, of all its shapes; empty where nothing describes it. Opens mesh files, at every
  /// call, each once. Throws StorageError (missing) or FormatError (a shape is malformed, no mesh, too large, not
  /// finite, no triangle with an area) naming link and file. At most 10 million triangles are made, and no more than 2
  /// million above those of the mesh files, however often shapes repeat.
  [[nodiscard]] TriangleMesh bodyOf(std::size_t link, LinkBody body = LinkBody::Any) const;
  /// The file that a mesh of the link is in. Throws FormatError for a package that is not known, or an address that is
  /// no file's; whether the file is there, bodyOf() will tell.
  [[nodiscard]] std::filesystem::path meshFile(const MeshShape& mesh, std::size_t link) const;
  /// Whether the link's body has a size that no link has: nullopt for a plausible one. `body` is bodyOf(link). Longer
  /// than 5 m; or than 1 m and 20 times the longest distance from a link's origin to a joint on it; or shorter than 1
  /// mm.
  [[nodiscard]] std::optional<SuspectedUnit> suspectedUnit(std::size_t link, const TriangleMesh& body) const;

 private:
  struct State;
  explicit RobotModel(std::shared_ptr<const State> state);
  std::shared_ptr<const State> state_;
};

}  // namespace hexoderm
