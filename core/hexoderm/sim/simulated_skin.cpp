#include "hexoderm/sim/simulated_skin.h"

#include "hexoderm/base/enum_names.h"
#include "hexoderm/base/error.h"
#include "hexoderm/base/rounding.h"
#include "hexoderm/base/text.h"
#include "hexoderm/sim/hand_motion.h"
#include "hexoderm/sim/patch_layout.h"
#include "hexoderm/sim/patch_plan.h"
#include "hexoderm/sim/random_streams.h"
#include "hexoderm/sim/simulated_faults.h"

#include <Eigen/Core>
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <random>

namespace hexoderm {
namespace {

constexpr double kReach_rad = 60 * kDegree;
constexpr double kShortestStay_s = 3;
constexpr double kLongestStay_s = 8;
// Readings 50 ms apart then correlate by 0.3, as those of the real leg do by 0 to 0.4.
constexpr double kCorrelation_s = 0.04;

/// Van der Corput's sequence in base 2, 0 to 1: every number far from those before it.
double spread(std::size_t number) {
  double value = 0;
  for (double share = 0.5; number > 0; number /= 2, share /= 2) value += share * static_cast<double>(number % 2);
  return value;
}

Eigen::Vector3d upAt(double angle_rad) { return {0, std::sin(angle_rad), std::cos(angle_rad)}; }

/// A single joint about the body's x axis, which is level, and vibration. Where it goes and for how long it stays
/// follow from the number of the hold.
class RobotMotion {
 public:
  RobotMotion(const SimulatedSkinOptions& options, std::size_t cells) {
    std::mt19937_64 random = randomStream(options.seed, Stream::Vibration);
    std::uniform_real_distribution<double> rms(options.least_vibration_g, options.most_vibration_g);
    cells_.reserve(cells);
    for (std::size_t k = 0; k < cells; ++k) {
      const double x = rms(random);
      const double y = rms(random);
      cells_.push_back({{x, y, rms(random)}});
    }
  }

  static constexpr double kFastest_rad_s = 20 * kDegree;
  /// The direction that points up in a hold, body frame, counted from 0.
  static Eigen::Vector3d upOf(std::size_t hold) {
    // Upright, at one end, at the other, and then in between.
    if (hold == 0) return upAt(0);
    if (hold <= 2) return upAt(hold == 1 ? kReach_rad : -kReach_rad);
    return upAt(kReach_rad * (1 - 2 * spread(hold - 1)));
  }
  /// The reachable direction that is nearest to `up_b`.
  static Eigen::Vector3d nearestTo(const Eigen::Vector3d& up_b) {
    return upAt(std::clamp(std::atan2(up_b.y(), up_b.z()), -kReach_rad, kReach_rad));
  }
  /// For how long the part is held.
  static double staysFor_s(std::size_t hold) {
    return kLongestStay_s - (kLongestStay_s - kShortestStay_s) * spread(hold);
  }

  /// What vibration adds to a cell's reading at its next tick, g, `step_s` after the one before. `unit` is drawn anew
  /// for every tick: three normal numbers of variance 1.
  Eigen::Vector3d vibration(std::size_t cell, double step_s, const Eigen::Vector3d& unit) {
    Shaken& shaken = cells_[cell];
    // Noise through a low pass of first order, stationary from its first value on.
    const double kept = shaken.has_begun ? std::exp(-step_s / kCorrelation_s) : 0;
    shaken.now = kept * shaken.now + std::sqrt(1 - kept * kept) * unit;
    shaken.has_begun = true;
    return shaken.rms_g.cwiseProduct(shaken.now);
  }

 private:
  struct Shaken {
    Eigen::Vector3d rms_g;
    Eigen::Vector3d now = Eigen::Vector3d::Zero();  ///< of variance 1
    bool has_begun = false;
  };
  std::vector<Shaken> cells_;
};

constexpr double kPauseBetweenRecordings_s = 10;
constexpr double kHandOffset_m = 0.02;

/// Turns the body's motion into a cell's reading.
struct SensorChain {
  Eigen::Matrix3d gain_R_a_b;
  Eigen::Vector3d offset_g;
  Eigen::Vector3d position_b;  ///< position of the accelerometer
};

constexpr EnumNames<LinkLaw> kLinkLaws = {{"bend", "surface"}};

}  // namespace

std::string_view linkLawName(LinkLaw law) { return kLinkLaws.of(law); }

LinkLaw linkLawFromName(std::string_view name) {
  if (const std::optional<LinkLaw> law = kLinkLaws.find(name)) return *law;
  throw InvalidArgument("link_law: expected bend or surface, found \"" + std::string(name) + "\"");
}

void SimulatedSkinOptions::validate() const {
  const auto notNegative = [](double value, const std::string& name) {
    if (!std::isfinite(value) || value < 0)
      throw InvalidArgument(message("simulated skin: {} must not be negative", name));
  };
  notNegative(position_jitter_m, "position_jitter_m");
  notNegative(yaw_jitter_rad, "yaw_jitter_rad");
  notNegative(tilt_jitter_rad, "tilt_jitter_rad");
  notNegative(hand_orientation_sigma_rad, "hand_orientation_sigma_rad");
  notNegative(tremor_angle_sigma_rad, "tremor_angle_sigma_rad");
  notNegative(tremor_acceleration_g, "tremor_acceleration_g");
  notNegative(drift_rad_per_s, "drift_rad_per_s");
  notNegative(reading_rate_hz, "reading_rate_hz");
  notNegative(least_vibration_g, "least_vibration_g");
  notNegative(most_vibration_g, "most_vibration_g");
  if (least_vibration_g > most_vibration_g) {
    throw InvalidArgument(message("simulated skin: least_vibration_g must not be above most_vibration_g"));
  }
  if (!std::isfinite(joint_angle_rad)) throw InvalidArgument(message("simulated skin: joint_angle_rad must be finite"));
}

SimulatedSkinOptions SimulatedSkinOptions::ideal() {
  SimulatedSkinOptions options;
  options.position_jitter_m = 0;
  options.yaw_jitter_rad = 0;
  options.tilt_jitter_rad = 0;
  options.sensor_errors = false;
  options.sensor_noise = false;
  options.hand_held = false;
  return options;
}

SimulatedSkinOptions SimulatedSkinOptions::robot() {
  SimulatedSkinOptions options;
  options.hand_held = false;
  options.on_robot = true;
  options.reading_rate_hz = 20;
  return options;
}

struct SimulatedSkin::State {
  CellModel model;
  SimulatedSkinOptions options;
  std::string surface_text;
  NeighborList neighbors;
  std::optional<std::pair<LinkEnd, LinkEnd>> loop;
  std::vector<TrueCell> truth;
  std::vector<CellHealth> health;
  std::optional<WrongDelivery> wrong_delivery;
  std::vector<SensorChain> sensors;
  std::vector<SensorChain> bent_sensors;  ///< with the joints bent; empty without joints
  Eigen::Vector3d middle_b = Eigen::Vector3d::Zero();
  std::size_t recordings = 0;
  double clock_s = 0;

  /// A hold of the part: its motion since it began, and the source of the sensors' noise.
  struct Hold {
    HandMotion motion;
    Eigen::Vector3d hand_b;
    std::mt19937_64 noise;
    bool is_bent = false;
    std::size_t recording = 0;
    std::size_t tick = 0;
    std::function<BodyMotion(double time_s)> carried{};  ///< instead of `motion`
    std::vector<Eigen::Vector3d> drift_g{};              ///< of every cell's offset

    [[nodiscard]] BodyMotion at(double time_s) const { return carried ? carried(time_s) : motion.at(time_s); }
  };
  std::optional<RobotMotion> robot;  ///< absent unless it holds the part
  std::optional<Hold> live;
  FastNormalSource live_noise{std::mt19937_64()};
  double live_clock_s = 0;
  std::size_t robot_holds = 0;  ///< those that the robot has gone to

  [[nodiscard]] double rate_hz() const {
    return options.reading_rate_hz > 0 ? options.reading_rate_hz : model.accelerometer.rate_hz;
  }
  [[nodiscard]] double liveTime_s() const { return static_cast<double>(live->tick) / rate_hz(); }

  /// A new hold, by hand unless it is the skin's first.
  Hold hold(const Eigen::Vector3d& up_b) {
    const Eigen::Vector3d wanted_b = unitUp(up_b);
    const std::size_t recording = recordings++;
    std::mt19937_64 hand_random = randomStream(options.seed, Stream::Hand, recording);
    const Eigen::Vector3d up = robot ? RobotMotion::nearestTo(up_b) : wanted_b;
    const bool in_hand = options.hand_held && recording > 0;
    HandMotion motion = in_hand ? HandMotion(up, options, hand_random) : HandMotion(up);
    // A hand holds the part near its middle, not in it.
    const Eigen::Vector3d hand_b = middle_b + kHandOffset_m * NormalSource(hand_random).nextVector();
    return {std::move(motion),
            hand_b,
            randomStream(options.seed, Stream::Noise, recording),
            !bent_sensors.empty() && recording % 2 == 1,
            recording,
            0,
            {},
            driftIn(recording)};
  }
  Hold hold(const CarriedBody& body) {
    const std::size_t recording = recordings++;
    return {HandMotion(Eigen::Vector3d::UnitZ()),
            body.hand_b,
            randomStream(options.seed, Stream::Noise, recording),
            !bent_sensors.empty() && recording % 2 == 1,
            recording,
            0,
            body.motion,
            driftIn(recording)};
  }
  /// What the cells' offsets have changed by in a recording.
  [[nodiscard]] std::vector<Eigen::Vector3d> driftIn(std::size_t recording) const {
    std::vector<Eigen::Vector3d> drift_g(truth.size(), Eigen::Vector3d::Zero());
    if (!options.drifts_after) return drift_g;
    const auto add = [&](std::size_t drawn_for, double shared_sigma_g, double own_sigma_g) {
      NormalSource random(randomStream(options.seed, Stream::Drift, drawn_for));
      const Eigen::Vector3d shared_g = shared_sigma_g * random.nextVector();
      for (Eigen::Vector3d& of_cell_g : drift_g) of_cell_g += shared_g + own_sigma_g * random.nextVector();
    };
    const Accelerometer& a = model.accelerometer;
    add(recording + 1, a.offset_instability_shared_sigma_g, a.offset_instability_sigma_g);
    if (recording >= *options.drifts_after) add(0, a.offset_drift_shared_sigma_g, a.offset_drift_sigma_g);
    return drift_g;
  }
  void record(Hold holding, std::size_t frame_count, const FrameSink& take) {
    NormalSource noise(holding.noise);
    SampleFrame frame;
    for (std::size_t k = 0; k < frame_count; ++k) {
      frame.samples.clear();
      frame.time_s = clock_s + static_cast<double>(k) / rate_hz();
      sense(holding, noise, frame);
      take(frame);
    }
    clock_s += static_cast<double>(frame_count) / rate_hz() + kPauseBetweenRecordings_s;
  }
  std::vector<SampleFrame> framesOf(Hold holding, std::size_t frame_count) {
    std::vector<SampleFrame> frames;
    frames.reserve(frame_count);
    record(std::move(holding), frame_count, [&](const SampleFrame& frame) { frames.push_back(frame); });
    return frames;
  }
  void holdLive(Hold holding) {
    live = std::move(holding);
    live_noise = FastNormalSource(live->noise);
  }
  /// On a table, unless it is held already.
  void beginLive() {
    if (!live) holdLive(hold(Eigen::Vector3d::UnitZ()));
  }
  /// Readings of all cells at the hold's next tick.
  template <class Noise>
  void sense(Hold& holding, Noise& noise, SampleFrame& frame) {
    const Accelerometer& accelerometer = model.accelerometer;
    // White noise of a density d, sampled at a rate f, has the variance d^2 f / 2.
    const double white_g = accelerometer.noise_g_per_sqrt_hz * std::sqrt(accelerometer.rate_hz / 2);
    const auto asOutput = [&](const Eigen::Vector3d& value_g) {
      Eigen::Vector3d output = value_g;
      if (options.sensor_noise && accelerometer.lsb_g > 0) {
        for (double& value : output) value = accelerometer.lsb_g * nearestWhole(value / accelerometer.lsb_g);
      }
      return Eigen::Vector3d(output.cwiseMin(accelerometer.range_g).cwiseMax(-accelerometer.range_g));
    };
    const std::vector<SensorChain>& chains = holding.is_bent ? bent_sensors : sensors;
    const BodyMotion body = holding.at(static_cast<double>(holding.tick++) / rate_hz());
    frame.samples.reserve(truth.size());
    bool all_send_their_own = options.whole_skin_faults.empty();
    for (std::size_t c = 0; c < truth.size(); ++c) {
      const SensorChain& sensor = chains[c];
      CellHealth& cell = health[c];
      all_send_their_own = all_send_their_own && !cell.sendsAnothers();
      // Drawn also where it is not used: a fault of one cell leaves the others' noise as it was.
      const Eigen::Vector3d unit_noise =
          options.sensor_noise || cell.has(SkinFault::Noisy) ? noise.nextVector() : Eigen::Vector3d::Zero();
      const Eigen::Vector3d vibration =
          robot ? robot->vibration(c, 1 / rate_hz(), noise.nextVector()) : Eigen::Vector3d::Zero();
      if (cell.has(SkinFault::NoSamples)) continue;
      Eigen::Vector3d force_b = body.up_b + body.field_b * (sensor.position_b - holding.hand_b);
      if (cell.turn && (!cell.has(SkinFault::Reglued) || holding.recording >= options.reglued_before)) {
        const Eigen::Matrix3d& R_b_u = truth[c].T_b_u.R;
        force_b = R_b_u * cell.turn->transpose() * R_b_u.transpose() * force_b;
      }
      Eigen::Vector3d reading = sensor.gain_R_a_b * force_b + sensor.offset_g + holding.drift_g[c];
      reading += vibration;
      reading = cell.sensed(reading) + cell.noiseFactor() * white_g * unit_noise;
      reading = cell.sent(asOutput(reading));
      frame.samples.push_back({cellNumbered(c), reading});
    }
    if (!all_send_their_own) wrong_delivery->apply(health, holding.recording, frame);
  }

  State(CellModel cell_model, SimulatedSkinOptions skin_options)
      : model(std::move(cell_model)), options(std::move(skin_options)) {
    model.validate();
    options.validate();
    const PatchPlan plan = planPatch(options.patch, model);
    surface_text = options.surface;
    if (options.laid_on) options.surface = surface_text = "a body";
    if (options.surface.empty() && options.patch == "x17") options.surface = surface_text = "cylinder:r=0.0501";
    if (options.surface.empty() && plan.is_ring) {
      const double radius = closingRadius(model, plan.cell_count, options.link_law == LinkLaw::Bend);
      options.surface = "cylinder:r=" + formatExact(radius);
      surface_text = "cylinder:r=" + formatFixed(radius, 4);
    }
    if (options.surface.empty()) options.surface = surface_text = "plane";
    const std::shared_ptr<const Surface> surface = options.laid_on ? options.laid_on : makeSurface(options.surface);

    // IDs run from 1 without gaps, and none may be an interface's: a skin larger than the model's range of IDs gets a
    // wider range.
    const CellId above_all(static_cast<std::uint32_t>(plan.cell_count) + 1);
    model.interface_id = std::max(model.interface_id, above_all);
    loop = plan.loop;
    LinkFaults link_faults(plan, model, options);
    neighbors.resize(plan.cell_count);
    reportNeighbors(link_faults.takeReportedLinks());
    drawCells(layPatch(plan, *surface, options.link_law));
    link_faults.pullCables(truth);
    sensors = sensorsOf({});
    if (const std::vector<SE3> bending = link_faults.bendingOf(truth); !bending.empty()) {
      bent_sensors = sensorsOf(bending);
    }
    health = breakCells(options, truth.size());
    if (options.on_robot) robot.emplace(options, truth.size());
    wrong_delivery.emplace(options, neighbors);
  }

 private:
  void reportNeighbors(const std::vector<PlannedLink>& links) {
    for (std::size_t k = 0; k < neighbors.size(); ++k) neighbors[k].id = cellNumbered(k);
    for (const PlannedLink& link : links) {
      CellReport& source = neighbors[link.source];
      CellReport& target = neighbors[link.target];
      source.neighbors.push_back({link.source_port.number, target.id, link.target_port.number});
      target.neighbors.push_back({link.target_port.number, source.id, link.source_port.number});
    }
    for (CellReport& cell : neighbors) std::ranges::sort(cell.neighbors, {}, &NeighborReport::port);
  }
  void drawCells(const std::vector<SE3>& placements);
  [[nodiscard]] std::vector<SensorChain> sensorsOf(const std::vector<SE3>& bending) const {
    std::vector<SensorChain> chains;
    chains.reserve(truth.size());
    for (std::size_t k = 0; k < truth.size(); ++k) {
      SE3 T_b_a = truth[k].T_b_u * model.accelerometer.T_u_a;
      T_b_a.R = truth[k].T_b_u.R * truth[k].R_u_askew * model.accelerometer.T_u_a.R;
      if (!bending.empty()) T_b_a = bending[k] * T_b_a;
      chains.push_back({truth[k].gain * T_b_a.R.transpose(), truth[k].offset_g, T_b_a.t});
    }
    return chains;
  }
};

void SimulatedSkin::State::drawCells(const std::vector<SE3>& placements) {
  NormalSource jitter(randomStream(options.seed, Stream::Placement));
  NormalSource errors(randomStream(options.seed, Stream::Sensors));
  NormalSource mounting(randomStream(options.seed, Stream::Mounting));
  const Accelerometer& accelerometer = model.accelerometer;
  // All chips are of one lot.
  NormalSource lot(randomStream(options.lot_seed.value_or(options.seed), Stream::Lot));
  const Eigen::Vector3d shared_offset_g = accelerometer.offset_shared_sigma_g * lot.nextVector();
  const double shared_scale = std::exp(accelerometer.scale_shared_sigma * lot.next());
  truth.reserve(placements.size());
  for (std::size_t k = 0; k < placements.size(); ++k) {
    TrueCell cell{cellNumbered(k), placements[k]};
    const Eigen::Vector3d shift = options.position_jitter_m * jitter.nextVector();
    const Eigen::Vector3d sigma(options.tilt_jitter_rad, options.tilt_jitter_rad, options.yaw_jitter_rad);
    const Eigen::Vector3d turn = sigma.cwiseProduct(jitter.nextVector());
    cell.T_b_u.t += cell.T_b_u.R * shift;
    cell.T_b_u.R *= expSO3(turn);
    if (options.sensor_errors) {
      cell.offset_g = shared_offset_g + accelerometer.offset_sigma_g.cwiseProduct(errors.nextVector());
      for (int row = 0; row < 3; ++row) {
        for (int col = 0; col < 3; ++col) {
          cell.gain(row, col) +=
              (row == col ? accelerometer.scale_sigma : accelerometer.cross_axis_sigma) * errors.next();
        }
      }
      cell.gain *= shared_scale;
      cell.R_u_askew = expSO3(model.mounting_sigma_rad * mounting.nextVector());
    }
    middle_b += cell.T_b_u.t / static_cast<double>(placements.size());
    truth.push_back(cell);
  }
}

SimulatedSkin::SimulatedSkin(CellModel model, SimulatedSkinOptions options)
    : state_(std::make_unique<State>(std::move(model), std::move(options))) {}
SimulatedSkin::~SimulatedSkin() = default;
SimulatedSkin::SimulatedSkin(SimulatedSkin&&) noexcept = default;
SimulatedSkin& SimulatedSkin::operator=(SimulatedSkin&&) noexcept = default;

const CellModel& SimulatedSkin::model() const { return state_->model; }
const SimulatedSkinOptions& SimulatedSkin::options() const { return state_->options; }
const NeighborList& SimulatedSkin::neighbors() const { return state_->neighbors; }
const std::vector<TrueCell>& SimulatedSkin::truth() const { return state_->truth; }

GroundTruth SimulatedSkin::groundTruth() const {
  GroundTruth truth;
  truth.cells.reserve(state_->truth.size());
  for (const TrueCell& cell : state_->truth) truth.cells.push_back({cell.id, cell.T_b_u});
  return truth;
}
std::optional<std::pair<LinkEnd, LinkEnd>> SimulatedSkin::loop() const { return state_->loop; }
double SimulatedSkin::rate_hz() const { return state_->rate_hz(); }
bool SimulatedSkin::turnsOnRequest() const { return !state_->robot; }
std::vector<CellFault> SimulatedSkin::cellFaults() const { return state_->options.faults; }
std::vector<LinkFault> SimulatedSkin::linkFaults() const { return state_->options.link_faults; }

std::unique_ptr<SimulatedBody> SimulatedSkin::withLinkFaults(std::vector<LinkFault> faults) const {
  SimulatedSkinOptions options = state_->options;
  options.faults.clear();
  options.link_faults = std::move(faults);
  return std::make_unique<SimulatedSkin>(state_->model, std::move(options));
}

std::vector<Eigen::Vector3d> SimulatedSkin::upDirections(std::size_t pose_count) const {
  if (!state_->robot) return scriptedUpDirections(pose_count);
  std::vector<Eigen::Vector3d> directions;
  for (std::size_t k = 0; k < pose_count; ++k) directions.push_back(RobotMotion::upOf(k));
  return directions;
}

Message SimulatedSkin::description() const {
  if (state_->robot) {
    return message("Simulated {} on {}, link law {}, seed {}, on a robot with its motors on", state_->options.patch,
                   state_->surface_text, linkLawName(state_->options.link_law), state_->options.seed);
  }
  return message("Simulated {} on {}, link law {}, seed {}", state_->options.patch, state_->surface_text,
                 linkLawName(state_->options.link_law), state_->options.seed);
}

void SimulatedSkin::record(const Eigen::Vector3d& up_b, std::size_t frame_count, const FrameSink& take) {
  state_->record(state_->hold(up_b), frame_count, take);
}

std::vector<SampleFrame> SimulatedSkin::record(const Eigen::Vector3d& up_b, std::size_t frame_count) {
  return state_->framesOf(state_->hold(up_b), frame_count);
}

std::vector<SampleFrame> SimulatedSkin::record(const CarriedBody& body, std::size_t frame_count) {
  return state_->framesOf(state_->hold(body), frame_count);
}

void SimulatedSkin::turnTo(const Eigen::Vector3d& up_b) {
  State& state = *state_;
  state.beginLive();
  const Eigen::Matrix3d R_w_b = state.live->motion.orientationAt(state.liveTime_s());
  state.holdLive(state.hold(up_b));
  state.live->motion.arriveFrom(R_w_b, state.robot ? RobotMotion::kFastest_rad_s : kFastestTurn_rad_s);
}

void SimulatedSkin::turnTo(CellId cell, const Eigen::Vector3d& up_u) {
  requireCell(cell);
  turnTo(state_->truth[cell.value() - 1].T_b_u.R * up_u);
}

void SimulatedSkin::turnToNextPose() {
  state_->beginLive();
  const std::size_t poses = state_->recordings;
  turnTo(upDirections(poses + 1).back());
}

void SimulatedSkin::carry(const CarriedBody& body) { state_->holdLive(state_->hold(body)); }

bool SimulatedSkin::turning() const {
  const State& state = *state_;
  if (!state.live) return false;
  return state.liveTime_s() < state.live->motion.arrival_s();
}

SampleFrame SimulatedSkin::next() {
  State& state = *state_;
  state.beginLive();
  if (state.robot && !state.live->carried &&
      state.liveTime_s() >= state.live->motion.arrival_s() + RobotMotion::staysFor_s(state.robot_holds)) {
    turnTo(RobotMotion::upOf(++state.robot_holds));
  }
  SampleFrame frame;
  frame.time_s = state.live_clock_s;
  state.live_clock_s += 1 / state.rate_hz();
  state.sense(*state.live, state.live_noise, frame);
  return frame;
}

void SimulatedSkin::skip(std::size_t ticks) {
  State& state = *state_;
  state.beginLive();
  state.live->tick += ticks;
  state.live_clock_s += static_cast<double>(ticks) / state.rate_hz();
}

void SimulatedSkin::breakCell(const CellFault& fault) {
  requireCell(fault.cell);
  std::mt19937_64 random = randomStream(state_->options.seed, Stream::DeadAxis, {fault.cell.value()});
  addFault(state_->health[fault.cell.value() - 1], fault.kind, random);
}

void SimulatedSkin::mendCell(CellId cell) {
  requireCell(cell);
  state_->health[cell.value() - 1] = CellHealth{};
}

Eigen::Matrix3d SimulatedSkin::turnOf(CellId cell) const {
  requireCell(cell);
  return state_->health[cell.value() - 1].turn.value_or(Eigen::Matrix3d::Identity());
}

std::vector<Eigen::Vector3d> scriptedUpDirections(std::size_t pose_count) {
  // Three orthogonal ones first, then their opposites (which separate offsets), then the corners of the cube.
  std::vector<Eigen::Vector3d> directions = {
      Eigen::Vector3d::UnitZ(),  Eigen::Vector3d::UnitY(),  Eigen::Vector3d::UnitX(),
      -Eigen::Vector3d::UnitZ(), -Eigen::Vector3d::UnitY(), -Eigen::Vector3d::UnitX(),
  };
  for (const Eigen::Vector3d& corner :
       {Eigen::Vector3d(1, 1, 1), Eigen::Vector3d(-1, -1, 1), Eigen::Vector3d(-1, 1, -1), Eigen::Vector3d(1, -1, -1),
        Eigen::Vector3d(-1, -1, -1), Eigen::Vector3d(1, 1, -1), Eigen::Vector3d(1, -1, 1), Eigen::Vector3d(-1, 1, 1)}) {
    directions.push_back(corner.normalized());
  }
  // Beyond that, a sequence without end that fills the sphere evenly (Roberts' R2: powers of the plastic number), less
  // what would nearly repeat one of the directions above.
  constexpr double kPlastic = 1.32471795724474602596;
  constexpr double kTooNear = 8 * kDegree;
  const std::size_t regular = directions.size();
  for (std::size_t k = 1; directions.size() < pose_count; ++k) {
    const double n = static_cast<double>(k);
    const double u = n / kPlastic - std::floor(n / kPlastic);
    const double v = n / (kPlastic * kPlastic) - std::floor(n / (kPlastic * kPlastic));
    const double z = 1 - 2 * u;
    const double s = std::sqrt(1 - z * z);
    const Eigen::Vector3d up(s * std::cos(2 * kPi * v), s * std::sin(2 * kPi * v), z);
    const auto repeats = [&](const Eigen::Vector3d& other) { return angleBetween(up, other) < kTooNear; };
    if (std::none_of(directions.begin(), directions.begin() + static_cast<std::ptrdiff_t>(regular), repeats)) {
      directions.push_back(up);
    }
  }
  directions.resize(pose_count);
  return directions;
}

}  // namespace hexoderm
