#include "hexoderm/robots/robot_model.h"

#include "hexoderm/base/error.h"
#include "hexoderm/base/file.h"
#include "hexoderm/base/kept_files.h"
#include "hexoderm/base/limits.h"
#include "hexoderm/base/sha256.h"
#include "hexoderm/base/spelling_suggestion.h"
#include "hexoderm/base/text.h"
#include "hexoderm/base/units.h"
#include "hexoderm/robots/mesh_file.h"
#include "hexoderm/robots/urdf_document.h"

#include <console_bridge/console.h>
#include <urdf_model/model.h>
#include <urdf_parser/urdf_parser.h>

#include <algorithm>
#include <kdl/frames.hpp>
#include <kdl/segment.hpp>
#include <mutex>
#include <set>
#include <utility>

namespace hexoderm {
namespace {

/// The most triangles of a link's body, and what shapes that repeat may add to those of its mesh files.
constexpr std::size_t kMaxLinkTriangles = 10'000'000;
constexpr std::size_t kMaxRepeatedLinkTriangles = 2'000'000;

KDL::Vector toKdl(const Eigen::Vector3d& v) { return {v.x(), v.y(), v.z()}; }
KDL::Frame toKdl(const SE3& T) {
  return {KDL::Rotation(toKdl(T.R.col(0)), toKdl(T.R.col(1)), toKdl(T.R.col(2))), toKdl(T.t)};
}
SE3 fromKdl(const KDL::Frame& frame) {
  SE3 T;
  for (int row = 0; row < 3; ++row) {
    T.t[row] = frame.p[row];
    for (int column = 0; column < 3; ++column) T.R(row, column) = frame.M(row, column);
  }
  return T;
}

/// What urdfdom says while it reads; it would go to standard error.
class UrdfdomWords : public console_bridge::OutputHandler {
 public:
  UrdfdomWords() : lock_(mutex()), level_(console_bridge::getLogLevel()) {
    console_bridge::useOutputHandler(this);
    console_bridge::setLogLevel(console_bridge::CONSOLE_BRIDGE_LOG_ERROR);
  }
  ~UrdfdomWords() override {
    console_bridge::setLogLevel(level_);
    console_bridge::restorePreviousOutputHandler();
  }
  void log(const std::string& text, console_bridge::LogLevel /*level*/, const char* /*file*/, int /*line*/) override {
    if (first_.empty()) first_ = text;
  }
  [[nodiscard]] const std::string& first() const { return first_; }

 private:
  /// The handler belongs to the process.
  static std::mutex& mutex() {
    static std::mutex instance;
    return instance;
  }
  std::lock_guard<std::mutex> lock_;
  console_bridge::LogLevel level_;
  std::string first_;
};

urdf::ModelInterfaceSharedPtr parseByUrdfdom(std::string_view text, const std::string& file) {
  UrdfdomWords words;
  const urdf::ModelInterfaceSharedPtr model = urdf::parseURDF(std::string(text));
  if (!model) {
    const std::string why = words.first().empty() ? "no reason given" : shortened(words.first(), 300);
    throw FormatError(file, message("this is no valid URDF; urdfdom says: {}", why));
  }
  return model;
}

/// urdfdom's model as this library's, with its numbers checked.
class UrdfConverter {
 public:
  UrdfConverter(const urdf::ModelInterface& model, const UrdfDocument& document, const std::string& file)
      : model_(model), document_(document), file_(file) {
    for (std::size_t k = 0; k < document.links.size(); ++k) link_index_.emplace(document.links[k].name, k);
    for (std::size_t k = 0; k < document.joints.size(); ++k) joint_index_.emplace(document.joints[k], k);
    requireSameNames();
  }

  std::vector<RobotLink> links() const {
    std::vector<RobotLink> links = document_.links;
    for (RobotLink& link : links) {
      const urdf::JointConstSharedPtr carrier = model_.getLink(link.name)->parent_joint;
      if (carrier) link.joint = joint_index_.at(carrier->name);
    }
    return links;
  }

  std::vector<RobotJoint> joints(std::vector<Message>& notes) const {
    std::vector<RobotJoint> joints;
    for (const std::string& name : document_.joints) {
      const urdf::JointConstSharedPtr joint = model_.getJoint(name);
      place_ = message("joint {}", name);
      line_ = document_.line_of_joint.at(name);
      joints.push_back(jointOf(*joint, notes));
    }
    for (std::size_t k = 0; k < joints.size(); ++k) requireEndingMimic(joints, k);
    return joints;
  }

 private:
  /// urdfdom reads XML with another library, which is not as strict about what is malformed.
  void requireSameNames() const {
    bool same = model_.links_.size() == link_index_.size() && model_.joints_.size() == joint_index_.size();
    for (const auto& [name, link] : model_.links_) same = same && link && link_index_.contains(name);
    for (const auto& [name, joint] : model_.joints_) {
      same = same && joint && joint_index_.contains(name) && link_index_.contains(joint->parent_link_name) &&
             link_index_.contains(joint->child_link_name);
    }
    if (same) return;
    throw FormatError(file_, message("urdfdom reads other links or joints in it than this program: an element or "
                                     "an attribute is probably malformed, or there twice"));
  }

  [[noreturn]] void fail(Message what) const {
    throw FormatError(file_, located(message("line {}", line_), located(place_, std::move(what))));
  }

  static Eigen::Vector3d vectorOf(const urdf::Vector3& v) { return {v.x, v.y, v.z}; }

  /// Its numbers have been checked.
  static SE3 placementOf(const urdf::Pose& pose) {
    SE3 T;
    T.t = vectorOf(pose.position);
    const Eigen::Quaterniond q(pose.rotation.w, pose.rotation.x, pose.rotation.y, pose.rotation.z);
    T.R = q.normalized().toRotationMatrix();
    return T;
  }

  [[nodiscard]] RobotJoint jointOf(const urdf::Joint& joint, std::vector<Message>& notes) const {
    RobotJoint result;
    result.name = joint.name;
    result.parent = link_index_.at(joint.parent_link_name);
    result.child = link_index_.at(joint.child_link_name);
    result.T_parent_joint = placementOf(joint.parent_to_joint_origin_transform);
    result.type = typeOf(joint, notes);
    if (result.type == JointType::Fixed) return result;

    result.axis = vectorOf(joint.axis);
    if (!isWithin(result.axis, kMaxJointPosition)) {
      fail(message("expected an axis of three numbers within {}", Number{kMaxJointPosition, 0}));
    }
    if (result.axis.norm() < 1e-6) fail(message("expected an axis, but its length is 0"));
    result.axis.normalize();
    if (joint.limits && result.type != JointType::Continuous) {
      result.limits = JointLimits{joint.limits->lower, joint.limits->upper};
      if (!isWithin(Eigen::Vector2d(result.limits->lower, result.limits->upper), kMaxJointPosition)) {
        fail(message("expected limits within {}; a joint without limits is of the type continuous",
                     Number{kMaxJointPosition, 0}));
      }
      if (result.limits->lower > result.limits->upper) {
        fail(message("expected limits of which the lower is not above the upper"));
      }
    }
    if (joint.mimic) result.mimic = mimicOf(*joint.mimic);
    return result;
  }

  [[nodiscard]] JointType typeOf(const urdf::Joint& joint, std::vector<Message>& notes) const {
    if (joint.type == urdf::Joint::REVOLUTE) return JointType::Revolute;
    if (joint.type == urdf::Joint::CONTINUOUS) return JointType::Continuous;
    if (joint.type == urdf::Joint::PRISMATIC) return JointType::Prismatic;
    if (joint.type == urdf::Joint::FLOATING) {
      notes.push_back(message("Joint {} is a floating one; it is taken as fixed at its zero.", joint.name));
    } else if (joint.type == urdf::Joint::PLANAR) {
      notes.push_back(message("Joint {} is a planar one; it is taken as fixed at its zero.", joint.name));
    } else if (joint.type != urdf::Joint::FIXED) {
      fail(message("expected the type revolute, continuous, prismatic, fixed, floating or planar"));
    }
    return JointType::Fixed;
  }

  [[nodiscard]] JointMimic mimicOf(const urdf::JointMimic& mimic) const {
    const auto joint = joint_index_.find(mimic.joint_name);
    if (joint == joint_index_.end()) {
      fail(message("mimics joint {}, which is not among the robot's joints", shortened(mimic.joint_name, 80)));
    }
    if (!isWithin(Eigen::Vector2d(mimic.multiplier, mimic.offset), kMaxJointPosition)) {
      fail(message("expected a multiplier and an offset within {}", Number{kMaxJointPosition, 0}));
    }
    return {joint->second, mimic.multiplier, mimic.offset};
  }

  void requireEndingMimic(const std::vector<RobotJoint>& joints, std::size_t first) const {
    std::size_t at = first;
    for (std::size_t steps = 0; joints[at].mimic; ++steps) {
      at = joints[at].mimic->joint;
      if (steps <= joints.size()) continue;
      place_ = message("joint {}", joints[first].name);
      line_ = document_.line_of_joint.at(joints[first].name);
      fail(message("mimics joints that mimic each other in a circle"));
    }
  }

  const urdf::ModelInterface& model_;
  const UrdfDocument& document_;
  const std::string& file_;
  std::map<std::string, std::size_t> link_index_;
  std::map<std::string, std::size_t> joint_index_;
  mutable Message place_;  ///< what is read, for complaints
  mutable std::ptrdiff_t line_ = 0;
};

/// KDL's counterpart of a joint and the link that it carries. KDL puts the axis into the parent's frame.
KDL::Segment segmentOf(const RobotJoint& joint, const std::string& child) {
  const KDL::Frame T_parent_joint = toKdl(joint.T_parent_joint);
  const KDL::Vector axis = T_parent_joint.M * toKdl(joint.axis);
  switch (joint.type) {
    case JointType::Fixed:
      break;
    case JointType::Revolute:
    case JointType::Continuous:
      return KDL::Segment(child, KDL::Joint(joint.name, T_parent_joint.p, axis, KDL::Joint::RotAxis), T_parent_joint);
    case JointType::Prismatic:
      return KDL::Segment(child, KDL::Joint(joint.name, T_parent_joint.p, axis, KDL::Joint::TransAxis), T_parent_joint);
  }
  return KDL::Segment(child, KDL::Joint(joint.name, KDL::Joint::None), T_parent_joint);
}

/// The rest of an address behind "SCHEME://PACKAGE/"; nullopt for other addresses.
struct PackageFile {
  std::string package;
  std::string rest;
};
std::optional<PackageFile> packageFile(std::string_view address) {
  for (const std::string_view scheme : {"package://", "model://"}) {
    if (!address.starts_with(scheme)) continue;
    const std::string_view path = address.substr(scheme.size());
    const std::size_t slash = path.find('/');
    if (slash == 0 || slash == std::string_view::npos) return std::nullopt;
    return PackageFile{std::string(path.substr(0, slash)), std::string(path.substr(slash + 1))};
  }
  return std::nullopt;
}

/// A mesh with another scale; one that is mirrored keeps its outside.
TriangleMesh scaled(TriangleMesh mesh, const Eigen::Vector3d& scale) {
  for (Eigen::Vector3d& point : mesh.points) point = point.cwiseProduct(scale);
  if (scale.prod() < 0) {
    for (auto& triangle : mesh.triangles) std::swap(triangle[1], triangle[2]);
  }
  return mesh;
}

/// `name` is that of none of these links or joints.
template <class Named>
[[noreturn]] void failUnknown(const std::filesystem::path& file, Message what, std::string_view name,
                              const std::vector<Named>& known) {
  std::vector<std::string> names;
  for (const Named& one : known) names.push_back(one.name);
  throw InvalidArgument(file.string(), inRow({std::move(what), didYouMean(name, names)}, "; "));
}

double longestSide(const TriangleMesh& mesh) { return boundingBox(mesh).size().maxCoeff(); }

}  // namespace

struct RobotModel::State {
  std::string name;
  std::filesystem::path file;
  std::string sha256;
  PackageFolders packages;
  std::vector<RobotLink> links;
  std::vector<RobotJoint> joints;
  std::vector<Message> notes;
  std::size_t root = 0;
  std::map<std::string, std::size_t, std::less<>> link_index;
  std::map<std::string, std::size_t, std::less<>> joint_index;
  std::vector<std::size_t> parents_first;  ///< all joints, each behind the one that carries its parent
  std::vector<KDL::Segment> segments;      ///< of each joint
  double reach_m = 0;                      ///< the longest distance from a link's origin to a joint on it

  [[nodiscard]] double positionOf(std::size_t joint, const JointAngles& angles) const;
  void orderJoints();
  void noteMeshes() const;
  [[nodiscard]] TriangleMesh readMesh(const std::filesystem::path& path, std::size_t link) const;
  [[nodiscard]] std::filesystem::path fileOf(const MeshShape& mesh, std::size_t link) const;
  [[nodiscard]] std::filesystem::path packageFolder(const PackageFile& wanted, const MeshShape& mesh,
                                                    std::size_t link) const;
  class BodyBuilder;
  [[nodiscard]] Message inLink(std::size_t link, Message what) const {
    return located(file.string(), located(message("link {}", links[link].name), std::move(what)));
  }
  [[noreturn]] void failMesh(const MeshShape& mesh, std::size_t link, Message why) const {
    throw FormatError(inLink(link, message("the mesh {} can't be found: {}", excerptOf(mesh.file), std::move(why))));
  }
};

double RobotModel::State::positionOf(std::size_t joint, const JointAngles& angles) const {
  const auto given = angles.positions.find(joints[joint].name);
  if (given != angles.positions.end()) return given->second;
  if (!joints[joint].mimic) return 0;
  const JointMimic& mimic = *joints[joint].mimic;
  return mimic.multiplier * positionOf(mimic.joint, angles) + mimic.offset;
}

void RobotModel::State::orderJoints() {
  std::vector<std::vector<std::size_t>> carried(links.size());
  for (std::size_t k = 0; k < joints.size(); ++k) carried[joints[k].parent].push_back(k);
  std::vector<std::size_t> ahead{root};
  while (!ahead.empty()) {
    const std::size_t link = ahead.back();
    ahead.pop_back();
    for (const std::size_t joint : carried[link]) {
      parents_first.push_back(joint);
      ahead.push_back(joints[joint].child);
      reach_m = std::max(reach_m, joints[joint].T_parent_joint.t.norm());
    }
  }
  for (const RobotJoint& joint : joints) segments.push_back(segmentOf(joint, links[joint.child].name));
}

std::filesystem::path RobotModel::State::packageFolder(const PackageFile& wanted, const MeshShape& mesh,
                                                       std::size_t link) const {
  const auto named = packages.find(wanted.package);
  if (named != packages.end()) return named->second;
  std::error_code ignored;
  const std::filesystem::path start = std::filesystem::absolute(file, ignored);
  for (std::filesystem::path at = start.parent_path(); at.has_relative_path(); at = at.parent_path()) {
    if (at.filename() == wanted.package) return at;
  }
  failMesh(mesh, link,
           message("say which folder is the package {}, as --package {}=FOLDER", shortened(wanted.package, 80),
                   shortened(wanted.package, 80)));
}

std::filesystem::path RobotModel::State::fileOf(const MeshShape& mesh, std::size_t link) const {
  const std::string_view address = mesh.file;
  constexpr std::string_view kFileScheme = "file://";
  if (const auto wanted = packageFile(address)) return packageFolder(*wanted, mesh, link) / wanted->rest;
  if (address.starts_with(kFileScheme)) return address.substr(kFileScheme.size());
  if (address.empty() || address.find("://") != std::string_view::npos) {
    failMesh(mesh, link, message("expected package://NAME/FILE, file:///FILE or a path"));
  }
  return file.parent_path() / address;  // an absolute one stays as it is
}

/// Meshes are inputs, also those that nobody needs.
void RobotModel::State::noteMeshes() const {
  if (!keepsWhatIsRead()) return;
  std::set<std::filesystem::path> noted;
  for (std::size_t link = 0; link < links.size(); ++link) {
    for (const std::vector<LinkShape>* shapes : {&links[link].visuals, &links[link].collisions}) {
      for (const LinkShape& shape : *shapes) {
        const auto* mesh = std::get_if<MeshShape>(&shape.shape);
        if (mesh == nullptr) continue;
        try {
          const std::filesystem::path path = fileOf(*mesh, link);
          if (noted.insert(path).second) noteMeshFile(path);
        } catch (const FormatError&) {
          continue;  // of a package that is not known: said where the mesh is needed
        }
      }
    }
  }
}

TriangleMesh RobotModel::State::readMesh(const std::filesystem::path& path, std::size_t link) const {
  try {
    return readMeshFile(path);
  } catch (const StorageError& error) {
    throw StorageError(inLink(link, error.message()));
  } catch (const FormatError& error) {
    throw FormatError(inLink(link, error.message()));
  }
}

/// Collects the shapes of a link, reads each mesh file once, and makes triangles when it is known how many.
class RobotModel::State::BodyBuilder {
 public:
  BodyBuilder(const State& state, std::size_t link) : state_(state), link_(link) {}

  void add(const LinkShape& shape) {
    pieces_.push_back(std::visit([&](const auto& of) { return pieceOf(of); }, shape.shape));
    pieces_.back().T_l_shape = shape.T_l_shape;
    triangles_ += pieces_.back().mesh->triangles.size();
  }

  TriangleMesh build() const {
    requireAtMost(std::min(kMaxLinkTriangles, file_triangles_ + kMaxRepeatedLinkTriangles), triangles_);
    TriangleMesh body;
    for (const Piece& piece : pieces_) append(body, transformed(scaled(*piece.mesh, piece.scale), piece.T_l_shape));
    if (!body.empty() && !hasArea(body)) {
      fail(files_.empty() ? message("has no triangle with an area")
                          : located(files_.begin()->first.string(), message("the mesh has no triangle with an area")));
    }
    return body;
  }

 private:
  struct Piece {
    const TriangleMesh* mesh;
    Eigen::Vector3d scale;
    SE3 T_l_shape{};
  };

  [[noreturn]] void fail(Message what) const { throw FormatError(state_.inLink(link_, std::move(what))); }

  void requireAtMost(std::size_t most, std::size_t triangles) const {
    if (triangles > most) {
      fail(message("its shapes have {} triangles together, but at most {} are read", triangles, most));
    }
  }

  Piece pieceOf(const BoxShape& box) const { return {&box_, box.size_m}; }
  Piece pieceOf(const CylinderShape& cylinder) const {
    return {&cylinder_, {cylinder.radius_m, cylinder.radius_m, cylinder.length_m}};
  }
  Piece pieceOf(const SphereShape& sphere) const { return {&sphere_, Eigen::Vector3d::Constant(sphere.radius_m)}; }
  Piece pieceOf(const MeshShape& mesh) {
    const auto [read, is_new] = files_.try_emplace(state_.fileOf(mesh, link_));
    if (is_new) {
      read->second = state_.readMesh(read->first, link_);
      file_triangles_ += read->second.triangles.size();
      requireAtMost(kMaxLinkTriangles, file_triangles_);
    }
    return {&read->second, mesh.scale};
  }
  static Piece pieceOf(const UnreadShape& shape) { throw FormatError(shape.why); }

  const State& state_;
  std::size_t link_;
  TriangleMesh box_ = meshOfBox({1, 1, 1});
  TriangleMesh cylinder_ = meshOfCylinder(1, 1);
  TriangleMesh sphere_ = meshOfSphere(1);
  std::map<std::filesystem::path, TriangleMesh> files_;
  std::vector<Piece> pieces_;
  std::size_t triangles_ = 0;       ///< of all shapes
  std::size_t file_triangles_ = 0;  ///< of the files, each counted once
};

RobotModel::RobotModel(std::shared_ptr<const State> state) : state_(std::move(state)) {}

RobotModel RobotModel::read(const std::filesystem::path& urdf, PackageFolders packages) {
  return parse(readFile(urdf), urdf, std::move(packages));
}

RobotModel RobotModel::parse(std::string_view urdf, const std::filesystem::path& file, PackageFolders packages) {
  const UrdfDocument document = checkUrdf(urdf, file.string());
  const urdf::ModelInterfaceSharedPtr model = parseByUrdfdom(urdf, file.string());
  const std::string file_name = file.string();
  const UrdfConverter converter(*model, document, file_name);
  auto state = std::make_shared<State>();
  state->name = model->getName();
  state->file = file;
  state->sha256 = sha256Hex(urdf);
  state->packages = std::move(packages);
  state->links = converter.links();
  state->joints = converter.joints(state->notes);
  for (std::size_t k = 0; k < state->links.size(); ++k) {
    state->link_index.emplace(state->links[k].name, k);
    if (!state->links[k].joint) state->root = k;
  }
  for (std::size_t k = 0; k < state->joints.size(); ++k) state->joint_index.emplace(state->joints[k].name, k);
  state->orderJoints();
  state->noteMeshes();
  return RobotModel(std::move(state));
}

const std::string& RobotModel::name() const { return state_->name; }
const std::filesystem::path& RobotModel::file() const { return state_->file; }
const std::string& RobotModel::sha256() const { return state_->sha256; }
const std::vector<RobotLink>& RobotModel::links() const { return state_->links; }
const std::vector<RobotJoint>& RobotModel::joints() const { return state_->joints; }
std::size_t RobotModel::rootLink() const { return state_->root; }
const std::vector<Message>& RobotModel::notes() const { return state_->notes; }

std::optional<std::size_t> RobotModel::findLink(std::string_view name) const {
  const auto found = state_->link_index.find(name);
  return found == state_->link_index.end() ? std::nullopt : std::optional(found->second);
}

std::optional<std::size_t> RobotModel::findJoint(std::string_view name) const {
  const auto found = state_->joint_index.find(name);
  return found == state_->joint_index.end() ? std::nullopt : std::optional(found->second);
}

std::size_t RobotModel::linkNamed(std::string_view name) const {
  if (const auto found = findLink(name)) return *found;
  failUnknown(file(), message("the robot has no link {}", excerptOf(name)), name, links());
}

std::size_t RobotModel::jointNamed(std::string_view name) const {
  if (const auto found = findJoint(name)) return *found;
  failUnknown(file(), message("the robot has no joint {}", excerptOf(name)), name, joints());
}

std::vector<SE3> RobotModel::forward(const JointAngles& angles) const {
  angles.validate();
  for (const auto& [name, position] : angles.positions) static_cast<void>(jointNamed(name));
  std::vector<SE3> T_w_l(links().size());
  for (const std::size_t joint : state_->parents_first) {
    const double position = state_->positionOf(joint, angles);
    requirePosition(joints()[joint].name, position);  // of a mimicking one it may be anything
    const SE3 T_parent_child = fromKdl(state_->segments[joint].pose(position));
    T_w_l[joints()[joint].child] = T_w_l[joints()[joint].parent] * T_parent_child;
  }
  return T_w_l;
}

std::vector<std::size_t> RobotModel::freeJointsTo(std::size_t link) const {
  std::set<std::size_t> result;
  for (std::optional<std::size_t> at = links().at(link).joint; at; at = links()[joints()[*at].parent].joint) {
    std::size_t joint = *at;
    while (const auto& mimic = joints()[joint].mimic) joint = mimic->joint;
    if (joints()[joint].isFree()) result.insert(joint);
  }
  return {result.begin(), result.end()};
}

std::size_t RobotModel::partOf(std::size_t link) const {
  while (links().at(link).joint && joints()[*links()[link].joint].type == JointType::Fixed) {
    link = joints()[*links()[link].joint].parent;
  }
  return link;
}

std::vector<std::string> RobotModel::freeJointNames() const {
  std::vector<std::string> names;
  for (const RobotJoint& joint : joints()) {
    if (joint.isFree()) names.push_back(joint.name);
  }
  return names;
}

bool RobotModel::hasBody(std::size_t link, LinkBody body) const {
  const RobotLink& described = links().at(link);
  return (body != LinkBody::Collision && !described.visuals.empty()) ||
         (body != LinkBody::Visual && !described.collisions.empty());
}

TriangleMesh RobotModel::bodyOf(std::size_t link, LinkBody body) const {
  const RobotLink& described = links().at(link);
  const bool by_visuals = body == LinkBody::Visual || (body == LinkBody::Any && !described.visuals.empty());
  State::BodyBuilder builder(*state_, link);
  for (const LinkShape& shape : by_visuals ? described.visuals : described.collisions) builder.add(shape);
  return builder.build();
}

std::filesystem::path RobotModel::meshFile(const MeshShape& mesh, std::size_t link) const {
  return state_->fileOf(mesh, link);
}

std::optional<SuspectedUnit> RobotModel::suspectedUnit(std::size_t link, const TriangleMesh& body) const {
  constexpr double kLongestLink_m = 5;
  constexpr double kMaxTimesReach = 20;
  constexpr double kLongAnyway_m = 1;
  constexpr double kShortestLink_m = 0.001;
  const double size_m = longestSide(body);
  const bool too_long = size_m > kLongestLink_m ||
                        (size_m > kLongAnyway_m && state_->reach_m > 0 && size_m > kMaxTimesReach * state_->reach_m);
  if (!too_long && (size_m >= kShortestLink_m || body.empty())) return std::nullopt;

  SuspectedUnit suspicion{size_m, too_long ? kMillimetre : 1 / kMillimetre, {}};
  const std::string& name = links().at(link).name;
  if (too_long) {
    suspicion.message = message(
        "The body of link {} would be {} m long: its mesh is probably in millimetres, where a "
        "URDF needs metres. With a scale of 0.001 it would be {} long.",
        name, Number{size_m, 1}, Millimetres{size_m * suspicion.factor, 0});
  } else {
    suspicion.message = message(
        "The body of link {} would be only {} long: its mesh is probably scaled twice. With a "
        "scale 1000 times as large it would be {} long.",
        name, Millimetres{size_m, 4}, Millimetres{size_m * suspicion.factor, 0});
  }
  return suspicion;
}

}  // namespace hexoderm
