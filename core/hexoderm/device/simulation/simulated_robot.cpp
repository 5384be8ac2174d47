#include "hexoderm/device/simulation/simulated_robot.h"

#include "hexoderm/device/simulation/hand_motion.h"
#include "hexoderm/device/simulation/random_streams.h"
#include "hexoderm/geometry/mesh_surface.h"
#include "hexoderm/util/error.h"
#include "hexoderm/util/units.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <random>

namespace hexoderm {
namespace {

/// A robot's skin has as much room between the recordings as one in a hand.
constexpr double kPauseBetweenPoses_s = 10;

/// The angles in which poses of a joint are drawn.
JointLimits drawnRange(const RobotJoint& joint, double share) {
  const JointLimits limits = joint.limits.value_or(JointLimits{-kPi, kPi});
  const double middle = (limits.lower + limits.upper) / 2;
  const double half = share * (limits.upper - limits.lower) / 2;
  return {middle - half, middle + half};
}

Eigen::Vector3d drawDirection(std::mt19937_64& random) {
  std::normal_distribution<double> normal;
  Eigen::Vector3d direction;
  do {
    for (double& part : direction) part = normal(random);
  } while (direction.norm() < 1e-3);
  return direction.normalized();
}

/// The motion of a body that the robot carries, from the robot's own.
BodyMotion seenFrom(const Eigen::Matrix3d& R_w_b, const BodyMotion& motion_w) {
  return {R_w_b.transpose() * motion_w.up_b, R_w_b.transpose() * motion_w.field_b * R_w_b};
}

}  // namespace

SimulatedRobotOptions::SimulatedRobotOptions()
    : zero_offset_sigma_rad(0.5 * kDegree), base_tilt_sigma_rad(1 * kDegree) {}

void SimulatedRobotOptions::validate() const {
  const auto notNegative = [](double value, const std::string& name) {
    if (!(value >= 0 && std::isfinite(value))) {
      throw InvalidArgument(message("simulated robot: {} must not be negative", name));
    }
  };
  notNegative(zero_offset_sigma_rad, "zero_offset_sigma_rad");
  notNegative(base_tilt_sigma_rad, "base_tilt_sigma_rad");
  if (!(range_share >= 0 && range_share <= 1)) {
    throw InvalidArgument(message("simulated robot: range_share must be from 0 to 1"));
  }
  if (mounts.empty()) throw InvalidArgument(message("simulated robot: expected at least one patch on a link"));
  skin.validate();
}

SimulatedRobotOptions SimulatedRobotOptions::ideal() {
  SimulatedRobotOptions options;
  options.zero_offset_sigma_rad = 0;
  options.base_tilt_sigma_rad = 0;
  options.skin = SimulatedSkinOptions::ideal();
  return options;
}

struct SimulatedRobot::State {
  struct Mounted {
    SimulatedSkin skin;
    std::size_t link;
    SE3 T_l_b;
    std::uint32_t ids_before;  ///< cells of the skins before
  };

  CellModel model;
  RobotModel robot;
  SimulatedRobotOptions options;
  std::vector<Mounted> skins;
  std::vector<MountedPatch> patches;
  NeighborList neighbors;
  JointAngles zero_offsets;
  Eigen::Vector3d tilted_up_w = Eigen::Vector3d::UnitZ();
  std::size_t poses = 0;
  struct Held {
    SimulatedRobotPose pose;
    HandMotion motion;
    Eigen::Vector3d hand_w;
  };
  std::optional<Held> held;
  double clock_s = 0;

  State(CellModel cell_model, RobotModel robot_model, SimulatedRobotOptions robot_options);
  void mount(const PatchMount& mount, std::uint64_t seed);
  void drawErrors();
  [[nodiscard]] Eigen::Vector3d middleOfPatches(const SimulatedRobotPose& pose) const;
};

SimulatedRobot::State::State(CellModel cell_model, RobotModel robot_model, SimulatedRobotOptions robot_options)
    : model(std::move(cell_model)), robot(std::move(robot_model)), options(std::move(robot_options)) {
  options.validate();
  std::mt19937_64 seeds = randomStream(options.seed, Stream::RobotSkin);
  for (const PatchMount& patch : options.mounts) mount(patch, seeds());
  for (const Mounted& mounted : skins)
    model.interface_id = std::max(model.interface_id, mounted.skin.model().interface_id);
  const CellId above_all(static_cast<std::uint32_t>(neighbors.size()) + 1);
  model.interface_id = std::max(model.interface_id, above_all);
  drawErrors();
}

void SimulatedRobot::State::mount(const PatchMount& mount, std::uint64_t seed) {
  const std::size_t link = robot.linkNamed(mount.link);
  SimulatedSkinOptions skin_options = options.skin;
  skin_options.patch = mount.patch;
  skin_options.surface = mount.surface;
  skin_options.seed = seed;
  skin_options.lot_seed = options.seed;
  skin_options.hand_held = options.base == BaseHold::Hand;
  // A body's own frame is the link's; other surfaces are carried to where the patch's middle is wanted.
  SE3 T_l_b;
  if (mount.surface.empty() && robot.hasBody(link)) {
    skin_options.laid_on = std::make_shared<MeshSurface>(robot.bodyOf(link), mount.T_l_m, model.thickness_m);
  }
  SimulatedSkin skin(model, skin_options);
  if (!skin_options.laid_on) T_l_b = mount.T_l_m * makeSurface(skin.options().surface)->middle().inverse();

  const auto ids_before = static_cast<std::uint32_t>(neighbors.size());
  MountedPatch patch{mount.link, robot.links()[robot.partOf(link)].name, {}, {}};
  const auto renumbered = [&](CellId id) { return id.value() == 0 ? id : CellId(id.value() + ids_before); };
  for (const TrueCell& cell : skin.truth()) {
    patch.cells.push_back(renumbered(cell.id));
    patch.T_l_u.push_back(T_l_b * cell.T_b_u);
  }
  for (CellReport report : skin.neighbors()) {
    report.id = renumbered(report.id);
    for (NeighborReport& neighbor : report.neighbors) neighbor.cell = renumbered(neighbor.cell);
    neighbors.push_back(std::move(report));
  }
  patches.push_back(std::move(patch));
  skins.push_back({std::move(skin), link, T_l_b, ids_before});
}

void SimulatedRobot::State::drawErrors() {
  NormalSource normal(randomStream(options.seed, Stream::RobotZero));
  const double tilt_x = options.base_tilt_sigma_rad * normal.next();
  const double tilt_y = options.base_tilt_sigma_rad * normal.next();
  if (options.base == BaseHold::Fixed) tilted_up_w = expSO3({tilt_x, tilt_y, 0}) * Eigen::Vector3d::UnitZ();
  for (const RobotJoint& joint : robot.joints()) {
    if (!joint.isFree()) continue;
    const double offset_rad = options.zero_offset_sigma_rad * normal.next();
    zero_offsets.positions[joint.name] = joint.type == JointType::Prismatic ? 0 : offset_rad;
  }
}

/// In the base's frame.
Eigen::Vector3d SimulatedRobot::State::middleOfPatches(const SimulatedRobotPose& pose) const {
  Eigen::Vector3d sum = Eigen::Vector3d::Zero();
  for (std::size_t k = 0; k < skins.size(); ++k) sum += pose.T_w_l[skins[k].link] * patches[k].T_l_u.front().t;
  return sum / static_cast<double>(skins.size());
}

SimulatedRobot::SimulatedRobot(CellModel model, RobotModel robot, SimulatedRobotOptions options)
    : state_(std::make_unique<State>(std::move(model), std::move(robot), std::move(options))) {}
SimulatedRobot::~SimulatedRobot() = default;
SimulatedRobot::SimulatedRobot(SimulatedRobot&&) noexcept = default;
SimulatedRobot& SimulatedRobot::operator=(SimulatedRobot&&) noexcept = default;

const CellModel& SimulatedRobot::model() const { return state_->model; }
const RobotModel& SimulatedRobot::robot() const { return state_->robot; }
const SimulatedRobotOptions& SimulatedRobot::options() const { return state_->options; }
const NeighborList& SimulatedRobot::neighbors() const { return state_->neighbors; }
const std::vector<MountedPatch>& SimulatedRobot::patches() const { return state_->patches; }
const JointAngles& SimulatedRobot::zeroOffsets() const { return state_->zero_offsets; }

GroundTruth SimulatedRobot::groundTruth() const {
  GroundTruth truth;
  truth.frame = "the link that carries the cell";
  for (const MountedPatch& patch : state_->patches) {
    for (std::size_t k = 0; k < patch.cells.size(); ++k) truth.cells.push_back({patch.cells[k], patch.T_l_u[k]});
  }
  return truth;
}

Message SimulatedRobot::description() const {
  std::vector<Message> patches;
  for (const PatchMount& mount : options().mounts) patches.push_back(message("{} on {}", mount.patch, mount.link));
  return options().base == BaseHold::Fixed
             ? message("Simulated robot {} on a fixed base: {}, seed {}", robot().name(), patches, options().seed)
             : message("Simulated robot {} in a hand: {}, seed {}", robot().name(), patches, options().seed);
}

SimulatedRobotPose SimulatedRobot::nextPose() {
  State& state = *state_;
  const std::size_t index = state.poses++;
  std::mt19937_64 random = randomStream(state.options.seed, Stream::RobotPose, index);
  SimulatedRobotPose pose;
  std::uniform_real_distribution<double> share(0, 1);
  for (const RobotJoint& joint : state.robot.joints()) {
    if (!joint.isFree()) continue;
    const JointLimits range = drawnRange(joint, state.options.range_share);
    const double position = range.lower + share(random) * (range.upper - range.lower);
    pose.reported.positions[joint.name] = position;
    pose.true_angles.positions[joint.name] = position + state.zero_offsets.positions.at(joint.name);
  }
  pose.T_w_l = state.robot.forward(pose.true_angles);
  const bool upright = state.options.base == BaseHold::Fixed || index == 0;
  const Eigen::Vector3d wanted_up_w = upright ? state.tilted_up_w : drawDirection(random);
  HandMotion motion = state.options.base == BaseHold::Hand && index > 0
                          ? HandMotion(wanted_up_w, state.options.skin, random)
                          : HandMotion(wanted_up_w);
  pose.up_w = motion.orientationAt(0).transpose() * Eigen::Vector3d::UnitZ();
  state.held = State::Held{pose, std::move(motion), state.middleOfPatches(pose)};
  return pose;
}

std::vector<SampleFrame> SimulatedRobot::record(std::size_t frame_count) {
  State& state = *state_;
  if (!state.held) throw InvalidArgument("simulated robot: expected a pose before it is recorded");
  const State::Held& held = *state.held;
  std::vector<SampleFrame> frames(frame_count);
  for (State::Mounted& mounted : state.skins) {
    const SE3 T_w_b = held.pose.T_w_l[mounted.link] * mounted.T_l_b;
    const CarriedBody body{[&](double time_s) { return seenFrom(T_w_b.R, held.motion.at(time_s)); },
                           T_w_b.inverse() * held.hand_w};
    const std::vector<SampleFrame> recorded = mounted.skin.record(body, frame_count);
    for (std::size_t k = 0; k < frame_count; ++k) {
      for (CellSample sample : recorded[k].samples) {
        sample.cell = CellId(sample.cell.value() + mounted.ids_before);
        frames[k].samples.push_back(sample);
      }
    }
  }
  const double tick_s = 1 / state.skins.front().skin.rate_hz();
  for (std::size_t k = 0; k < frame_count; ++k) frames[k].time_s = state.clock_s + static_cast<double>(k) * tick_s;
  state.clock_s += static_cast<double>(frame_count) * tick_s + kPauseBetweenPoses_s;
  return frames;
}

std::vector<PatchMount> demoMounts() {
  // On the outside of the upper arm and on the inner side of the forearm, along the arm.
  const auto place = [](double x, double y, double z, double yaw_deg) {
    return SE3{rotationFromRpy({0, 0, yaw_deg * kDegree}), {x, y, z}};
  };
  return {{"upper_arm", place(0, 0.08, 0.14, 0)}, {"forearm", place(0.08, 0, 0.12, 90)}};
}

}  // namespace hexoderm
