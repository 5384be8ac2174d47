#include "hexoderm/capture/stillness_detector.h"

#include "hexoderm/base/text.h"
#include "hexoderm/capture/cell_motion.h"
#include "hexoderm/capture/sample_slots.h"

#include <algorithm>
#include <cmath>
#include <optional>

namespace hexoderm {
namespace {

constexpr std::size_t kMinDriftSlots = 5;
constexpr std::size_t kMinHoldSlots = 3;
constexpr double kUsualWindow_s = 1.5;
constexpr double kLongestWindow_s = 5;
constexpr double kLongerWindow = 1.1;
constexpr float kDead_g = 0.1F;
constexpr double kCoarsestStep_g = 4.0 / 256;  // 8 bits for 2 g to either side
constexpr double kMovingTimesLimit = 3;        // a patch that drifts faster than this many times the limit is moved
constexpr double kNoisyTimesOthers = 4;        // rms of a noisy cell over the median
constexpr float kRestlessSigma2 = 36;          // six sigma of its own noise
constexpr double kLongAgo_s = -1e300;
constexpr double kWhiteScatter_s = 10;
constexpr double kWhite = 2;  // whiteness of noise is below, of motion above
constexpr double kLearnDown_s = 0.5;
constexpr double kLearnUp_s = 2;
// Standard deviation of a slope's component that one cell's judgement bears, over the limit; more cells bear more. A
// part that stands still is then taken for one that turns once in some thousand judgements, and one that turns at three
// times the limit never for a still one.
constexpr double kBearableSlopeNoise = 0.31;
constexpr double kBearableAtLast = 1.5;   // times as much in the longest window
constexpr double kBearableOnceStill = 2;  // times as much for a part that was found still
constexpr double kSureSlope2 = 18;        // squared slope over its variance that no noise explains
constexpr double kChanceSlope2 = 4;       // of a squared slope over its variance, by which a limit may be exceeded
constexpr double kMinColour = 0.05, kMaxColour = 10;
// The mean that shows whether the part has moved is of so many samples that their noise is this share of the angle.
constexpr double kMoveNoiseShare = 0.15;
constexpr double kMaxForMove = 25;         // samples ...
constexpr double kLongestForMove_s = 0.5;  // ... or, if those are more, the samples of so long

struct CellState {
  CellMotion motion, next;
  Eigen::Vector3f captured_g = Eigen::Vector3f::Zero();
  bool is_captured = false;
  float floor_g2 = 0;
  float still_g2 = 0;  ///< variance of a sample while the part was still: noise and vibration
  // Seconds of misbehaving while the patch was still, less seconds of behaving.
  double noisy_s = 0, restless_s = 0;
  bool is_noisy = false, is_restless = false;
};

template <class Values>
auto nth(Values& values, std::size_t n) {
  const auto place = values.begin() + static_cast<std::ptrdiff_t>(n);
  std::nth_element(values.begin(), place, values.end());
  return *place;
}

/// Of an even number the lower one of two. Orders the values otherwise.
template <class Values>
auto lowerMedian(Values& values) {
  return nth(values, (values.size() - 1) / 2);
}

const StillnessOptions& validated(const StillnessOptions& options) {
  options.validate();
  return options;
}

/// With one decimal, or none where it would be a zero.
Number limitText(double value) { return {value, formatFixed(value, 1).ends_with(".0") ? 0 : 1}; }

/// Counts `step_s` up while `misbehaves`, else down; whether it is (still) set aside.
bool setAside(bool misbehaves, double step_s, double patience_s, bool was, double& misbehaved_s) {
  misbehaved_s = std::clamp(misbehaved_s + (misbehaves ? step_s : -step_s), 0.0, patience_s);
  return misbehaves ? was || misbehaved_s >= patience_s : was && misbehaved_s > 0;
}

}  // namespace

double angleBetweenReadings(const Eigen::Vector3d& a_g, const Eigen::Vector3d& b_g) {
  return 2 * std::asin(std::min(1.0, (a_g - b_g).norm() / 2));
}

struct StillnessDetector::State {
  State(const Accelerometer& accelerometer, StillnessOptions stillness_options)
      : options(validated(stillness_options)), slots(options.silent_after_s) {
    const double white_g2 = std::pow(accelerometer.noise_g_per_sqrt_hz, 2) * accelerometer.rate_hz / 2;
    step_g2 = static_cast<float>(accelerometer.lsb_g * accelerometer.lsb_g / 12);
    model_floor_g2 = static_cast<float>(white_g2) + step_g2;
    stated_step_g = accelerometer.lsb_g;
    coarsest_step_g = std::max(kCoarsestStep_g, accelerometer.lsb_g);
    window_s = options.drift_window_s;
    sayWaiting();
  }

  StillnessOptions options;
  float step_g2 = 0;
  float model_floor_g2 = 0;
  double stated_step_g = 0;
  double coarsest_step_g = 0;  ///< readings may differ by more, but not because of the sensor's steps

  SampleSlots slots;
  std::vector<CellState> cells;

  double window_s = 0;                    ///< length of the drift window
  bool is_longest = false;                ///< whether it can't be longer
  double looked_back_s = kUsualWindow_s;  ///< length of the last judgement's window, kUsualWindow_s at least
  double colour = 1;                      ///< of the noise, see CellMotion
  SlotWindow window;
  double still_since_s = 0;
  double moving_s = kLongAgo_s;  ///< when the patch last moved
  double white_for_s = 0;
  double rate_hz = 0;       ///< samples per second and cell
  double squared_turn = 0;  ///< of the patch's direction, rad2/s2, noise included
  double slope_noise2 = 0;  ///< variance of one component of a cell's slope
  bool was_captured = false;
  Stillness result;

  // Kept between judgements, so that none allocates.
  std::vector<std::size_t> used;
  std::vector<float> scratch;
  std::vector<std::pair<float, std::size_t>> excesses;

  bool add(const SampleFrame& frame) {
    const SampleSlots::Event event = slots.add(frame);
    if (event == SampleSlots::Event::Gap) forgetWindow();
    if (event == SampleSlots::Event::SlotEnded) judge();
    return event != SampleSlots::Event::None;
  }

  void forgetWindow() {
    white_for_s = 0;
    window_s = options.drift_window_s;
    sayWaiting();
  }

  void sayWaiting() {
    Stillness waiting;
    waiting.time_s = slots.end_s();
    waiting.armed = result.armed;
    waiting.moved_rad = result.moved_rad;
    waiting.window_s = window_s;
    waiting.drift_limit_rad_s = options.drift_limit_rad_s;
    waiting.excess_limit_g = options.excess_limit_g;
    waiting.rearm_rad = options.rearm_angle_rad;
    result = std::move(waiting);
  }

  bool layWindow() {
    window.newest = slots.newest();
    window.drift_slots = slots.spanning(window_s, kMinDriftSlots);
    window.hold_slots = slots.spanning(options.hold_s, kMinHoldSlots);
    if (window.drift_slots == 0 || window.hold_slots == 0) return false;
    const double from_s = slots.start_s(window.drift_slots - 1);
    const double centre_s = (from_s + slots.end_s()) / 2, half_s = (slots.end_s() - from_s) / 2;
    for (std::size_t n = 0; n < window.drift_slots; ++n) {
      const double t = slots.middle_s(n) - centre_s;
      window.time_s[n] = static_cast<float>(t);
      window.weight[n] = static_cast<float>(std::max(0.01, 1 - std::pow(t / half_s, 2)));
    }
    return true;
  }

  // ---- judgement

  /// What the readings say about the patch's direction.
  enum class Direction { Unknown, Held, Turns };

  void judge() {
    const bool was_still = result.still;
    sayWaiting();
    while (cells.size() < slots.cellCount()) cells.emplace_back().floor_g2 = model_floor_g2;
    result.cells = slots.heardCount();
    watchMove();
    nameSilentCells();
    const Direction direction = judgeDirection(was_still);
    result.window_s = window_s;
    looked_back_s = std::max(kUsualWindow_s, window_s);
    if (!used.empty()) decide(direction, was_still);
    sayWhatBlocks();
  }

  /// Looks back as far as it takes to tell a part that is still from one that turns, and no further: before that the
  /// part may have moved.
  Direction judgeDirection(bool was_still) {
    used.clear();
    is_longest = false;
    bool has_colour = false;
    for (window_s = options.drift_window_s;;) {
      if (!layWindow() || !measureCells()) break;
      measurePatch();
      if (!has_colour && !isSurelyTurning()) {
        has_colour = learnColour();
        measurePatch();
      }
      if (isSurelyTurning()) return Direction::Turns;
      is_longest = window_s >= kLongestWindow_s || window.drift_slots == kSlots;
      const double bearable =
          kBearableSlopeNoise * options.drift_limit_rad_s * std::pow(static_cast<double>(used.size()), 0.25);
      const double wider = was_still ? kBearableOnceStill : is_longest ? kBearableAtLast : 1;
      if (slope_noise2 <= std::pow(wider * bearable, 2)) {
        const double limit = (was_still ? options.release_factor : 1) * options.drift_limit_rad_s;
        const double chance2 = kChanceSlope2 * slope_noise2 / std::sqrt(static_cast<double>(used.size()));
        return std::pow(result.drift_rad_s, 2) > limit * limit + chance2 ? Direction::Turns : Direction::Held;
      }
      result.drift_rad_s = 0;
      if (is_longest) break;
      // The variance of a slope falls with the third power of the window's length.
      const double wanted_s = window_s * std::cbrt(slope_noise2 / (bearable * bearable));
      window_s = std::clamp(wanted_s, kLongerWindow * window_s, kLongestWindow_s);
    }
    return Direction::Unknown;
  }

  /// By more than any noise explains that the window shows.
  [[nodiscard]] bool isSurelyTurning() const {
    return squared_turn > options.drift_limit_rad_s * options.drift_limit_rad_s + kSureSlope2 * slope_noise2;
  }

  /// Learns from the shortest window that tells; returns false if this one does not.
  bool learnColour() {
    scratch.clear();
    for (const std::size_t k : used) {
      if (cells[k].motion.colour >= 0) scratch.push_back(cells[k].motion.colour);
    }
    if (scratch.empty()) return false;
    const double weight = slots.slotLength_s() / window_s * std::sqrt(static_cast<double>(scratch.size()));
    const double seen = std::clamp(static_cast<double>(lowerMedian(scratch)), kMinColour, kMaxColour);
    colour += std::min(0.5, weight) * (seen - colour);
    return true;
  }

  void nameSilentCells() {
    for (std::size_t k = 0; k < cells.size(); ++k) {
      if (!slots.isHeard(k)) {
        result.odd_cells.push_back({slots.id(k), OddCellKind::Silent, slots.end_s() - slots.heard_s(k)});
      }
    }
  }

  [[nodiscard]] bool isDead(const CellState& cell) const {
    return cell.motion.mean_g.squaredNorm() < kDead_g * kDead_g;
  }
  [[nodiscard]] bool isStuck(std::size_t cell) const {
    // The drift knows of a motion for as long as its window reaches back.
    return slots.changed_s(cell) + looked_back_s + slots.slotLength_s() < moving_s;
  }

  /// Returns false, and leaves those of a shorter window, where too few cells have sent enough for this window.
  bool measureCells() {
    const double samples_in_slot = std::max(1.0, rate_hz * slots.slotLength_s());
    std::size_t judged = 0;
    for (std::size_t k = 0; k < cells.size(); ++k) {
      if (!slots.isHeard(k)) continue;
      CellState& cell = cells[k];
      const double steady_g =
          2 * options.excess_limit_g + 6 * std::sqrt(static_cast<double>(cell.floor_g2) / samples_in_slot);
      cell.next = motionOf(slots.slotsOf(k), window, static_cast<float>(steady_g));
      if (cell.next.enough) ++judged;
    }
    if (judged == 0 || 2 * judged < slots.heardCount()) return false;
    used.clear();
    for (std::size_t k = 0; k < cells.size(); ++k) {
      cells[k].motion = slots.isHeard(k) ? cells[k].next : CellMotion{};
      if (cells[k].motion.enough && !isDead(cells[k]) && !isStuck(k)) used.push_back(k);
    }
    if (used.empty()) {
      for (std::size_t k = 0; k < cells.size(); ++k) {
        if (cells[k].motion.enough) used.push_back(k);
      }
    }
    result.cells_used = used.size();
    return true;
  }

  void nameDeadAndStuckCells() {
    for (std::size_t k = 0; k < cells.size(); ++k) {
      const CellMotion& motion = cells[k].motion;
      if (!motion.enough) continue;
      if (isDead(cells[k])) {
        result.odd_cells.push_back({slots.id(k), OddCellKind::Dead, static_cast<double>(motion.mean_g.norm())});
      }
      if (!isDead(cells[k]) && isStuck(k)) result.odd_cells.push_back({slots.id(k), OddCellKind::Stuck, 0});
    }
  }

  template <class Value>
  double medianOf(Value&& value) {
    scratch.clear();
    for (const std::size_t k : used) scratch.push_back(static_cast<float>(value(cells[k])));
    return static_cast<double>(lowerMedian(scratch));
  }

  /// Variance of the slope of a cell's reading along one axis that its noise makes. It comes from how the readings lie
  /// about a straight line, and from how slow the noise was while the part was still: a data sheet knows nothing of
  /// motors. Readings of a sensor whose noise is below its step lie better than they are; half a window is then worth
  /// one of them.
  [[nodiscard]] double slopeNoise2(const CellMotion& motion) const {
    const double residual_g2 = static_cast<double>(motion.residual_g2);
    // Noise that is slower than the parts of the window whose means were compared is more than they show.
    const double in_slope = colour > 1 ? 2 * colour - 1 : colour;
    const double noise2 = in_slope * residual_g2 * static_cast<double>(motion.slope_variance_s2);
    const auto seen_g = static_cast<double>(slots.step_g());
    const double step_g = std::isfinite(seen_g) ? std::min(seen_g, coarsest_step_g) : stated_step_g;
    if (step_g * step_g <= 4 * residual_g2) return noise2;
    return noise2 + step_g * step_g / 12 * 8 / (window_s * window_s);
  }

  void measurePatch() {
    squared_turn = medianOf([](const CellState& cell) { return cell.motion.turn_rad2_s2; });
    slope_noise2 = medianOf([this](const CellState& cell) { return slopeNoise2(cell.motion); });
    const double drift2 = medianOf([this](const CellState& cell) {
      return static_cast<double>(cell.motion.turn_rad2_s2) - 2 * slopeNoise2(cell.motion);
    });
    result.drift_rad_s = std::sqrt(std::max(0.0, drift2));
    excesses.clear();
    for (const std::size_t k : used) excesses.emplace_back(cells[k].motion.variance_g2 - cells[k].floor_g2, k);
    const auto share = static_cast<std::size_t>(options.quiet_fraction * static_cast<double>(used.size() - 1));
    const auto [excess_g2, cell] = nth(excesses, std::min(share, options.quiet_cells));
    result.excess_g = std::sqrt(std::max(0.0, static_cast<double>(excess_g2)));
    result.excess_cell = slots.id(cell);
    const double hold_s = slots.end_s() - slots.start_s(window.hold_slots - 1);
    rate_hz = medianOf([](const CellState& c) { return c.motion.count; }) / hold_s;
    result.rate_hz = rate_hz;
    result.steady_for_s = slots.slotLength_s() * medianOf([](const CellState& c) { return c.motion.steady_slots; });
  }

  /// How a variance of that many samples may exceed the true one by chance (two sigma).
  static double chanceIn(double samples) { return 1 + 2 * std::sqrt(2 / (3 * std::max(1.0, samples - 1))); }

  void decide(Direction direction, bool was_still) {
    nameDeadAndStuckCells();
    const bool turns = direction == Direction::Turns;
    const double factor = was_still ? options.release_factor : 1;
    const double samples = medianOf([](const CellState& cell) { return cell.motion.count; });
    const bool shakes = result.excess_g > factor * options.excess_limit_g * std::sqrt(chanceIn(samples));
    if (result.drift_rad_s > kMovingTimesLimit * options.drift_limit_rad_s) moving_s = slots.end_s();
    const double whiteness = medianOf([](const CellState& cell) { return cell.motion.whiteness; });
    white_for_s = !turns && shakes && whiteness < kWhite ? white_for_s + slots.slotLength_s() : 0;
    if (direction == Direction::Held && (!shakes || white_for_s >= kWhiteScatter_s)) learnFloors();

    result.blocker = turns                             ? Blocker::Turning
                     : shakes                          ? Blocker::Shaking
                     : direction == Direction::Unknown ? Blocker::Waiting
                                                       : Blocker::None;
    if (result.blocker == Blocker::None) watchEachCell();
    nameMisbehaving();
    result.still = result.blocker == Blocker::None;
    if (result.still) {
      // A part that is first found still has been so for hold_s.
      if (!was_still) still_since_s = slots.end_s() - options.hold_s;
      result.still_for_s = slots.end_s() - still_since_s;
      for (CellState& cell : cells) {
        if (cell.motion.enough) cell.still_g2 = cell.motion.residual_g2;
      }
    }
  }

  void learnFloors() {
    const float down = static_cast<float>(std::min(1.0, slots.slotLength_s() / kLearnDown_s));
    const float up = static_cast<float>(std::min(1.0, slots.slotLength_s() / kLearnUp_s));
    for (CellState& cell : cells) {
      if (!cell.motion.enough) continue;
      const float seen_g2 = std::max(cell.motion.white_g2, step_g2);
      if (seen_g2 < cell.floor_g2) cell.floor_g2 += down * (seen_g2 - cell.floor_g2);
      if (seen_g2 > cell.floor_g2 && static_cast<double>(cell.motion.whiteness) < kWhite)
        cell.floor_g2 += up * (seen_g2 - cell.floor_g2);
    }
  }

  /// Cells that turn or scatter although the patch is still.
  void watchEachCell() {
    if (used.size() < 2) return;
    const double median_g2 = medianOf([](const CellState& cell) { return cell.motion.variance_g2; });
    const double noisy_g2 =
        std::max(std::pow(options.excess_limit_g, 2), kNoisyTimesOthers * kNoisyTimesOthers * median_g2);
    const double limit_rad_s = kRestlessTimesLimit * options.drift_limit_rad_s;
    for (const std::size_t k : used) {
      CellState& cell = cells[k];
      const CellMotion& motion = cell.motion;
      cell.is_noisy = setAside(static_cast<double>(motion.variance_g2) > noisy_g2, slots.slotLength_s(),
                               options.patience_s, cell.is_noisy, cell.noisy_s);
      const double noise2 =
          std::max(1.0, colour) * static_cast<double>(kRestlessSigma2 * motion.variance_g2 * motion.slope_variance_s2);
      const bool turns = static_cast<double>(motion.turn_rad2_s2) > limit_rad_s * limit_rad_s + noise2;
      cell.is_restless = setAside(turns, slots.slotLength_s(), options.patience_s, cell.is_restless, cell.restless_s);
      const double turn_rad_s = std::sqrt(static_cast<double>(motion.turn_rad2_s2));
      if (turns && !cell.is_restless && turn_rad_s > result.turning_rad_s) {
        result.turning_cell = slots.id(k);
        result.turning_rad_s = turn_rad_s;
        result.blocker = Blocker::CellTurning;
      }
    }
  }

  void nameMisbehaving() {
    for (const std::size_t k : used) {
      const CellState& cell = cells[k];
      const CellMotion& motion = cell.motion;
      if (cell.is_noisy) {
        result.odd_cells.push_back(
            {slots.id(k), OddCellKind::Noisy, std::sqrt(static_cast<double>(motion.variance_g2))});
      } else if (cell.is_restless) {
        result.odd_cells.push_back(
            {slots.id(k), OddCellKind::Restless, std::sqrt(static_cast<double>(motion.turn_rad2_s2))});
      }
    }
    std::ranges::sort(result.odd_cells, {}, &OddCell::cell);
  }

  // ---- moves between captures

  /// Mean of so many of a cell's latest samples that their noise is no move.
  [[nodiscard]] std::optional<Eigen::Vector3d> recentForMove_g(std::size_t cell) const {
    const double bearable_rad = kMoveNoiseShare * options.rearm_angle_rad;
    const double noise_g2 =
        3 * std::max(1.0, colour) * static_cast<double>(cell < cells.size() ? cells[cell].still_g2 : 0.0F);
    const double wanted = noise_g2 > 0 ? noise_g2 / (bearable_rad * bearable_rad) : 1;
    return slots.recent_g(cell, std::clamp(wanted, 1.0, std::max(kMaxForMove, rate_hz * kLongestForMove_s)));
  }

  void watchMove() {
    if (!was_captured) return;
    scratch.clear();
    for (std::size_t k = 0; k < cells.size(); ++k) {
      const CellState& cell = cells[k];
      if (!cell.is_captured || isStuck(k)) continue;
      const auto now_g = recentForMove_g(k);
      if (now_g) scratch.push_back(static_cast<float>(angleBetweenReadings(*now_g, cell.captured_g.cast<double>())));
    }
    if (scratch.empty()) return;
    result.moved_rad = static_cast<double>(lowerMedian(scratch));
    if (result.moved_rad > options.rearm_angle_rad) result.armed = true;
  }

  void sayWhatBlocks() {
    // After a capture the operator is told to turn the part, not to hold it still.
    if (!result.armed && result.blocker != Blocker::Waiting) result.blocker = Blocker::NotMoved;
    result.message = whatBlocks();
  }

  [[nodiscard]] Message whatBlocks() const {
    switch (result.blocker) {
      case Blocker::None:
        return {};
      case Blocker::Waiting:
        return slots.count() == 0 || cells.empty() ? message("Waiting for samples")
               : slots.heardCount() == 0           ? message("Waiting for samples: all cells are silent")
               : is_longest ? message("Hold still: the readings scatter too much to tell whether the part turns")
                            : message("Waiting for samples: fewer than {} s so far", limitText(window_s));
      case Blocker::NotMoved:
        return message("Turn the part: it has moved {} deg since the last capture, more than {} are needed",
                       Number{toDegrees(result.moved_rad), 1}, limitText(toDegrees(options.rearm_angle_rad)));
      case Blocker::Turning:
        return message("Hold still: the part turns by {} deg/s, limit {}", Number{toDegrees(result.drift_rad_s), 1},
                       limitText(toDegrees(options.drift_limit_rad_s)));
      case Blocker::Shaking:
        return message("Hold still: cell {} moves {} mg, limit {}", result.excess_cell,
                       Number{1000 * result.excess_g, 0}, Number{1000 * options.excess_limit_g, 0});
      case Blocker::CellTurning:
        return message("Hold still: cell {} turns by {} deg/s against the rest, limit {}", result.turning_cell,
                       Number{toDegrees(result.turning_rad_s), 1},
                       limitText(toDegrees(kRestlessTimesLimit * options.drift_limit_rad_s)));
    }
    return {};
  }
};

StillnessDetector::StillnessDetector(const Accelerometer& accelerometer, StillnessOptions options)
    : state_(std::make_unique<State>(accelerometer, options)) {}
StillnessDetector::~StillnessDetector() = default;
StillnessDetector::StillnessDetector(StillnessDetector&&) noexcept = default;
StillnessDetector& StillnessDetector::operator=(StillnessDetector&&) noexcept = default;

bool StillnessDetector::add(const SampleFrame& frame) { return state_->add(frame); }

const SampleFrame& StillnessDetector::newIn(const SampleFrame& frame) const { return state_->slots.newIn(frame); }

const Stillness& StillnessDetector::stillness() const { return state_->result; }

void StillnessDetector::disarm(const PoseCapture& pose) {
  for (CellState& cell : state_->cells) cell.is_captured = false;
  for (const GravitySample& sample : pose.samples) {
    const std::size_t k = state_->slots.find(sample.cell);
    if (k >= state_->cells.size()) continue;
    state_->cells[k].captured_g = sample.mean_g.cast<float>();
    state_->cells[k].is_captured = true;
  }
  state_->was_captured = true;
  state_->result.armed = false;
  state_->result.moved_rad = 0;
  state_->sayWhatBlocks();
}

void StillnessDetector::restart() {
  state_->slots.restart();
  state_->moving_s = kLongAgo_s;
  state_->forgetWindow();
}

std::vector<CellSample> StillnessDetector::recentMeans() const {
  std::vector<CellSample> means;
  means.reserve(state_->cells.size());
  for (std::size_t k = 0; k < state_->cells.size(); ++k) {
    const auto mean_g = state_->slots.recent_g(k);
    if (mean_g) means.push_back({state_->slots.id(k), *mean_g});
  }
  return means;
}

std::vector<CellId> StillnessDetector::cellsHeard() const {
  std::vector<CellId> heard;
  for (std::size_t k = 0; k < state_->cells.size(); ++k) {
    if (state_->slots.isHeard(k)) heard.push_back(state_->slots.id(k));
  }
  return heard;
}

double StillnessDetector::angleFrom(const PoseCapture& pose) const {
  std::vector<double> angles;
  for (const GravitySample& sample : pose.samples) {
    const std::size_t k = state_->slots.find(sample.cell);
    if (k >= state_->cells.size()) continue;
    const auto now_g = state_->recentForMove_g(k);
    if (now_g) angles.push_back(angleBetweenReadings(*now_g, sample.mean_g));
  }
  return angles.empty() ? 0 : lowerMedian(angles);
}

double StillnessDetector::noiseFloor_g(CellId cell) const {
  const std::size_t k = state_->slots.find(cell);
  return std::sqrt(static_cast<double>(k < state_->cells.size() ? state_->cells[k].floor_g2 : state_->model_floor_g2));
}

}  // namespace hexoderm
