#include "hexoderm/sim/simulated_robot.h"

#include "hexoderm/base/error.h"
#include "hexoderm/base/mesh_feet.h"
#include "hexoderm/sim/hand_motion.h"
#include "hexoderm/sim/patch_plan.h"
#include "hexoderm/sim/random_streams.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <optional>
#include <random>
#include <utility>

namespace hexoderm {
namespace {

constexpr double kFastestJoint_rad_s = 60 * kDegree;
constexpr double kFastestSlide_m_s = 0.1;
constexpr double kQuotientStep_s = 1e-3;

/// The motion of a body that the robot carries, from that of the base.
BodyMotion seenFrom(const Eigen::Matrix3d& R_w_b, const BodyMotion& motion_w) {
  return {R_w_b.transpose() * motion_w.up_b, R_w_b.transpose() * motion_w.field_b * R_w_b};
}

template <class Value>
Value secondDerivative(const Value& before, const Value& now, const Value& after) {
  return (before - 2.0 * now + after) / (kQuotientStep_s * kQuotientStep_s);
}

/// A robot while one pose is held: its joints stand still, and the whole of it moves as its base does. Frames: `w` the
/// base, `b` a body that a link carries, `v` the world, whose z is up.
class RobotHold {
 public:
  /// `angles`: where the joints truly stand. `base`: how the base is held and moved, about the point `hand_w`.
  RobotHold(RobotModel robot, JointAngles angles, HandMotion base, const Eigen::Vector3d& hand_w)
      : robot_(std::move(robot)),
        angles_(std::move(angles)),
        base_(std::move(base)),
        hand_w_(hand_w),
        T_w_l_(robot_.forward(angles_)),
        from_(angles_) {}

  /// Begins where `before` was at that time of its own. From there all joints move at once, smoothly and no faster than
  /// 60 degrees or 0.1 m a second, and the base is turned as HandMotion::arriveFrom() has it.
  void arriveFrom(const RobotHold& before, double time_s) {
    base_.arriveFrom(before.orientationAt(time_s));
    from_ = before.anglesAt(time_s);
    joints_arrive_s_ = 0;
    for (const auto& [name, position] : angles_.positions) {
      const bool slides = robot_.joints()[robot_.jointNamed(name)].type == JointType::Prismatic;
      const double way = std::abs(position - from_.positions.at(name));
      joints_arrive_s_ =
          std::max(joints_arrive_s_, kPeakOverMean * way / (slides ? kFastestSlide_m_s : kFastestJoint_rad_s));
    }
  }
  [[nodiscard]] double arrival_s() const { return std::max(joints_arrive_s_, base_.arrival_s()); }

  [[nodiscard]] JointAngles anglesAt(double time_s) const {
    if (time_s >= joints_arrive_s_) return angles_;
    const double left = 1 - minimumJerk(std::max(time_s, 0.0) / joints_arrive_s_);
    JointAngles angles = angles_;
    for (auto& [name, position] : angles.positions) position += left * (from_.positions.at(name) - position);
    return angles;
  }
  /// R_v_w.
  [[nodiscard]] Eigen::Matrix3d orientationAt(double time_s) const { return base_.orientationAt(time_s); }
  /// Of a body with the placement T_l_b on a link. While joints move, its acceleration is the difference quotient of
  /// where it is 1 ms before and after.
  [[nodiscard]] BodyMotion motionOf(std::size_t link, const SE3& T_l_b, double time_s) const {
    const BodyMotion base = base_.at(time_s);
    if (time_s >= joints_arrive_s_) return seenFrom((T_w_l_[link] * T_l_b).R, base);
    const Eigen::Vector3d hand_b = handIn(link, T_l_b);
    std::array<Eigen::Matrix3d, 3> R_v_b;
    std::array<Eigen::Vector3d, 3> place_v;
    const std::array<Stance, 3>& stances = around(time_s);
    for (std::size_t k = 0; k < stances.size(); ++k) {
      const SE3 T_w_b = stances[k].T_w_l[link] * T_l_b;
      R_v_b[k] = stances[k].R_v_w * T_w_b.R;
      place_v[k] = stances[k].R_v_w * (T_w_b * hand_b - hand_w_);
    }
    const Eigen::Vector3d acceleration_v = secondDerivative(place_v[0], place_v[1], place_v[2]);
    const Eigen::Matrix3d turning_v = secondDerivative(R_v_b[0], R_v_b[1], R_v_b[2]);
    const Eigen::Vector3d force_v = stances[1].R_v_w * base.up_b + acceleration_v / kStandardGravity;
    return {R_v_b[1].transpose() * force_v, R_v_b[1].transpose() * turning_v / kStandardGravity};
  }
  /// The point of the body that motionOf() refers to: the one that is in the hand once all joints stand.
  [[nodiscard]] Eigen::Vector3d handIn(std::size_t link, const SE3& T_l_b) const {
    return (T_w_l_[link] * T_l_b).inverse() * hand_w_;
  }

 private:
  struct Stance {
    Eigen::Matrix3d R_v_w;
    std::vector<SE3> T_w_l;
  };
  /// Before, at and after that time.
  [[nodiscard]] const std::array<Stance, 3>& around(double time_s) const {
    if (around_s_ == time_s) return around_;
    around_s_ = time_s;
    for (std::size_t k = 0; k < around_.size(); ++k) {
      const double then_s = time_s + (static_cast<double>(k) - 1) * kQuotientStep_s;
      around_[k] = {orientationAt(then_s), robot_.forward(anglesAt(then_s))};
    }
    return around_;
  }

  RobotModel robot_;
  JointAngles angles_;
  HandMotion base_;
  Eigen::Vector3d hand_w_;
  std::vector<SE3> T_w_l_;  ///< once all joints stand
  JointAngles from_;
  double joints_arrive_s_ = 0;
  // All bodies are asked for at one time, and the links are where they are for all of them.
  mutable double around_s_ = -1;
  mutable std::array<Stance, 3> around_;
};

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

// Of so many, the best one is about 5 degrees off where the joints reach all directions.
constexpr std::size_t kTriesOfAngles = 500;
constexpr double kNearEnough = 90 * kDegree;

CellId& cellOf(CellFault& fault) { return fault.cell; }
CellId& cellOf(LinkFault& fault) { return fault.at.cell; }

/// Makes the skin of a patch, which names its links by its own numbers of the cells.
template <class Make>
SimulatedSkin numberedFrom(std::uint32_t first, const std::string& link, const Make& make) {
  try {
    return make();
  } catch (const InvalidArgument& error) {
    if (first == 1) throw;
    throw InvalidArgument(message("patch on {}, whose cell 1 is the robot's cell {}", link, first), error.message());
  }
}

/// Those of `count` cells behind the first `before` ones, as these number themselves.
template <class Fault>
std::vector<Fault> faultsAmong(const std::vector<Fault>& faults, std::uint32_t before, std::size_t count) {
  std::vector<Fault> among;
  for (Fault fault : faults) {
    CellId& cell = cellOf(fault);
    if (cell.value() <= before || cell.value() > before + count) continue;
    cell = CellId(cell.value() - before);
    among.push_back(fault);
  }
  return among;
}

}  // namespace

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
  return {.zero_offset_sigma_rad = 0, .base_tilt_sigma_rad = 0, .skin = SimulatedSkinOptions::ideal()};
}

struct SimulatedRobot::State {
  struct Mounted {
    SimulatedSkin skin;
    std::size_t link;
    SE3 T_l_b;
    std::uint32_t ids_before;  ///< cells of the skins before

    [[nodiscard]] CellId idOnSkin(CellId id) const { return CellId(id.value() - ids_before); }
    /// The skin's samples to the robot's.
    void addTo(SampleFrame& frame, const SampleFrame& of_skin) const {
      for (CellSample sample : of_skin.samples) {
        sample.cell = CellId(sample.cell.value() + ids_before);
        frame.samples.push_back(sample);
      }
    }
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
    RobotHold hold;
  };
  std::optional<Held> held;  ///< what is recorded
  double clock_s = 0;
  std::optional<Held> live;
  std::uint64_t live_tick = 0;  ///< since the hold began
  double live_clock_s = 0;

  State(CellModel cell_model, RobotModel robot_model, SimulatedRobotOptions robot_options)
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
  void mount(const PatchMount& mount, std::uint64_t seed) {
    const std::size_t link = robot.linkNamed(mount.link);
    parseLivePatch(mount.patch);
    SimulatedSkinOptions skin_options = options.skin;
    skin_options.patch = mount.patch;
    skin_options.surface = mount.surface;
    skin_options.seed = seed;
    skin_options.lot_seed = options.seed;
    skin_options.hand_held = options.base == BaseHold::Hand;
    const auto ids_before = static_cast<std::uint32_t>(neighbors.size());
    const std::size_t cells = planPatch(mount.patch, model).cell_count;
    skin_options.faults = faultsAmong(options.skin.faults, ids_before, cells);
    skin_options.link_faults = faultsAmong(options.skin.link_faults, ids_before, cells);
    // A body's own frame is the link's; other surfaces are carried to where the patch's middle is wanted.
    SE3 T_l_b;
    if (mount.surface.empty() && robot.hasBody(link)) {
      skin_options.laid_on = std::make_shared<MeshSurface>(robot.bodyOf(link), mount.T_l_m, model.thickness_m);
    }
    SimulatedSkin skin = numberedFrom(ids_before + 1, mount.link, [&] { return SimulatedSkin(model, skin_options); });
    if (!skin_options.laid_on) T_l_b = mount.T_l_m * makeSurface(skin.options().surface)->middle().inverse();

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
  void drawErrors() {
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
  [[nodiscard]] Eigen::Vector3d middleOfPatches(const std::vector<SE3>& T_w_l) const {
    Eigen::Vector3d sum = Eigen::Vector3d::Zero();
    for (std::size_t k = 0; k < skins.size(); ++k) sum += T_w_l[skins[k].link] * patches[k].T_l_u.front().t;
    return sum / static_cast<double>(skins.size());
  }

  [[nodiscard]] JointAngles drawAngles(std::mt19937_64& random) const {
    JointAngles angles;
    std::uniform_real_distribution<double> share(0, 1);
    for (const RobotJoint& joint : robot.joints()) {
      if (!joint.isFree()) continue;
      const JointLimits range = drawnRange(joint, options.range_share);
      angles.positions[joint.name] = range.lower + share(random) * (range.upper - range.lower);
    }
    return angles;
  }
  [[nodiscard]] JointAngles trueAngles(JointAngles reported) const {
    for (auto& [name, position] : reported.positions) position += zero_offsets.positions.at(name);
    return reported;
  }
  [[nodiscard]] Held hold(JointAngles reported, const Eigen::Vector3d& up_w, bool by_hand,
                          std::mt19937_64& random) const {
    SimulatedRobotPose pose;
    pose.true_angles = trueAngles(reported);
    pose.reported = std::move(reported);
    pose.T_w_l = robot.forward(pose.true_angles);
    HandMotion base = by_hand ? HandMotion(up_w, options.skin, random) : HandMotion(up_w);
    pose.up_w = base.orientationAt(0).transpose() * Eigen::Vector3d::UnitZ();
    RobotHold robot_hold(robot, pose.true_angles, std::move(base), middleOfPatches(pose.T_w_l));
    return {std::move(pose), std::move(robot_hold)};
  }
  /// The next pose of the robot's own choice.
  Held drawPose() {
    const std::size_t index = poses++;
    std::mt19937_64 random = randomStream(options.seed, Stream::RobotPose, index);
    JointAngles reported = drawAngles(random);
    const bool in_hand = options.base == BaseHold::Hand && index > 0;
    const Eigen::Vector3d up_w = in_hand ? drawDirection(random) : tilted_up_w;
    return hold(std::move(reported), up_w, in_hand, random);
  }
  /// The robot as what carries one of its skins. `hold` must outlive it.
  [[nodiscard]] CarriedBody carried(std::size_t k, const RobotHold& hold) const {
    return {[this, k, &hold](double time_s) { return hold.motionOf(skins[k].link, skins[k].T_l_b, time_s); },
            hold.handIn(skins[k].link, skins[k].T_l_b)};
  }

  [[nodiscard]] double rate_hz() const { return skins.front().skin.rate_hz(); }
  [[nodiscard]] double liveTime_s() const { return static_cast<double>(live_tick) / rate_hz(); }
  void holdLive(Held next) {
    if (live) next.hold.arriveFrom(live->hold, liveTime_s());
    live = std::move(next);
    live_tick = 0;
    for (std::size_t k = 0; k < skins.size(); ++k) skins[k].skin.carry(carried(k, live->hold));
  }
  /// In the next pose, unless it stands in one already.
  void beginLive() {
    if (!live) holdLive(drawPose());
  }
  /// Which of the skins has the cell.
  [[nodiscard]] std::size_t indexOf(CellId cell) const {
    std::size_t k = skins.size() - 1;
    while (skins[k].ids_before >= cell.value()) --k;
    return k;
  }
  [[nodiscard]] Mounted& skinOf(CellId cell) { return skins[indexOf(cell)]; }
  /// In the base's frame, were the joints at these angles.
  [[nodiscard]] Eigen::Matrix3d rotationOf(CellId cell, const JointAngles& reported) const {
    const std::size_t k = indexOf(cell);
    const std::vector<SE3> T_w_l = robot.forward(trueAngles(reported));
    return T_w_l[skins[k].link].R * patches[k].T_l_u[skins[k].idOnSkin(cell).value() - 1].R;
  }
  /// Of angles drawn at random, those at which the direction of the cell's points up most exactly.
  [[nodiscard]] JointAngles anglesNearest(CellId cell, const Eigen::Vector3d& up_u, std::mt19937_64& random) const {
    JointAngles nearest;
    double least_rad = 2 * kPi;
    for (std::size_t k = 0; k < kTriesOfAngles; ++k) {
      JointAngles angles = drawAngles(random);
      const double off_rad = angleBetween(rotationOf(cell, angles) * up_u, tilted_up_w);
      if (off_rad >= least_rad) continue;
      least_rad = off_rad;
      nearest = std::move(angles);
    }
    if (least_rad > kNearEnough) {
      throw InvalidArgument(
          message("the joints can't turn cell {} there: they come within {}", cell, Degrees{least_rad, 0}));
    }
    return nearest;
  }
};

// ---- poses

SimulatedRobot::SimulatedRobot(CellModel model, RobotModel robot, SimulatedRobotOptions options)
    : state_(std::make_unique<State>(std::move(model), std::move(robot), std::move(options))) {
  for (const CellFault& fault : state_->options.skin.faults) requireCell(fault.cell);
  for (const LinkFault& fault : state_->options.skin.link_faults) requireCell(fault.at.cell);
}
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

double SimulatedRobot::rate_hz() const { return state_->rate_hz(); }
std::vector<CellFault> SimulatedRobot::cellFaults() const { return options().skin.faults; }
std::vector<LinkFault> SimulatedRobot::linkFaults() const { return options().skin.link_faults; }

std::unique_ptr<SimulatedBody> SimulatedRobot::withLinkFaults(std::vector<LinkFault> faults) const {
  SimulatedRobotOptions options = state_->options;
  options.skin.faults.clear();
  options.skin.link_faults = std::move(faults);
  return std::make_unique<SimulatedRobot>(state_->model, state_->robot, std::move(options));
}

SimulatedRobotPose SimulatedRobot::nextPose() {
  state_->held = state_->drawPose();
  return state_->held->pose;
}

std::vector<SampleFrame> SimulatedRobot::record(std::size_t frame_count) {
  State& state = *state_;
  if (!state.held) throw InvalidArgument("simulated robot: expected a pose before it is recorded");
  std::vector<SampleFrame> frames(frame_count);
  for (std::size_t k = 0; k < state.skins.size(); ++k) {
    State::Mounted& mounted = state.skins[k];
    const std::vector<SampleFrame> recorded = mounted.skin.record(state.carried(k, state.held->hold), frame_count);
    for (std::size_t tick = 0; tick < frame_count; ++tick) mounted.addTo(frames[tick], recorded[tick]);
  }
  const double tick_s = 1 / state.rate_hz();
  for (std::size_t k = 0; k < frame_count; ++k) frames[k].time_s = state.clock_s + static_cast<double>(k) * tick_s;
  state.clock_s += static_cast<double>(frame_count) * tick_s + kPauseBetweenPoses_s;
  return frames;
}

// ---- live

void SimulatedRobot::turnTo(CellId cell, const Eigen::Vector3d& up_u) {
  requireCell(cell);
  const Eigen::Vector3d up = unitUp(up_u);
  State& state = *state_;
  state.beginLive();
  std::mt19937_64 random = randomStream(state.options.seed, Stream::RobotPose, state.poses++);
  if (state.options.base == BaseHold::Fixed) {
    state.holdLive(state.hold(state.anglesNearest(cell, up, random), state.tilted_up_w, false, random));
  } else {
    const JointAngles angles = state.drawAngles(random);
    state.holdLive(state.hold(angles, state.rotationOf(cell, angles) * up, true, random));
  }
}

void SimulatedRobot::turnTo(const Eigen::Vector3d& up_w) {
  const Eigen::Vector3d up = unitUp(up_w);
  State& state = *state_;
  if (state.options.base == BaseHold::Fixed) {
    throw InvalidArgument(message("the robot's base is fixed: only its joints turn"));
  }
  state.beginLive();
  std::mt19937_64 random = randomStream(state.options.seed, Stream::RobotPose, state.poses++);
  state.holdLive(state.hold(state.live->pose.reported, up, true, random));
}

void SimulatedRobot::turnToNextPose() {
  state_->beginLive();
  state_->holdLive(state_->drawPose());
}

bool SimulatedRobot::turning() const { return state_->live && state_->liveTime_s() < state_->live->hold.arrival_s(); }

JointAngles SimulatedRobot::jointAngles() const {
  State& state = *state_;
  state.beginLive();
  if (!turning()) return state.live->pose.reported;
  JointAngles angles = state.live->hold.anglesAt(state.liveTime_s());
  for (auto& [name, position] : angles.positions) position -= state.zero_offsets.positions.at(name);
  return angles;
}

SampleFrame SimulatedRobot::next() {
  State& state = *state_;
  state.beginLive();
  SampleFrame frame;
  frame.time_s = state.live_clock_s;
  for (State::Mounted& mounted : state.skins) mounted.addTo(frame, mounted.skin.next());
  ++state.live_tick;
  state.live_clock_s += 1 / state.rate_hz();
  return frame;
}

void SimulatedRobot::skip(std::size_t ticks) {
  State& state = *state_;
  state.beginLive();
  for (State::Mounted& mounted : state.skins) mounted.skin.skip(ticks);
  state.live_tick += ticks;
  state.live_clock_s += static_cast<double>(ticks) / state.rate_hz();
}

void SimulatedRobot::breakCell(const CellFault& fault) {
  requireCell(fault.cell);
  State::Mounted& mounted = state_->skinOf(fault.cell);
  mounted.skin.breakCell({fault.kind, mounted.idOnSkin(fault.cell)});
}

void SimulatedRobot::mendCell(CellId cell) {
  requireCell(cell);
  State::Mounted& mounted = state_->skinOf(cell);
  mounted.skin.mendCell(mounted.idOnSkin(cell));
}

std::vector<PatchMount> demoMounts() {
  // On the outside of the upper arm and on the inner side of the forearm, along the arm.
  const auto place = [](double x, double y, double z, double yaw_deg) {
    return SE3{rotationFromRpy({0, 0, yaw_deg * kDegree}), {x, y, z}};
  };
  return {{"upper_arm", place(0, 0.08, 0.14, 0)}, {"forearm", place(0.08, 0, 0.12, 90)}};
}

}  // namespace hexoderm
