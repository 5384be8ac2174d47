#include "hexoderm/solve/faults/cell_health.h"

#include "hexoderm/base/median.h"
#include "hexoderm/base/se3.h"
#include "hexoderm/base/units.h"

#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <optional>
#include <utility>

namespace hexoderm {
namespace {

constexpr double kDeadNorm_g = 0.5;           // no offset and no pose leaves less of 1 g than this
constexpr double kMinNormTolerance_g = 0.15;  // a good sensor with an uncalibrated scale may read 0.9 g
constexpr double kStuckAngle = 2 * kDegree;   // a stuck sensor turns less than this ...
constexpr double kMovedAngle = 15 * kDegree;  // ... while the other cells turned at least this
constexpr double kNoisyTimesOthers = 4;
constexpr double kMovingSigma_g =
    0.25;  // tremor is 10 mg, at the end of an arm's length 100 mg; a moving part far above

/// The step of the grid that all of the values lie on, as far as they show one: their neighbours are whole multiples of
/// the smallest difference apart. 0 if they show none.
double stepOfGrid(std::vector<double> values) {
  constexpr std::size_t kFewest = 12;  // differences
  constexpr double kEqual = 1e-9;
  constexpr double kFarthest = 20;  // steps: the values of a grid are closer than that, but for a few
  constexpr double kOff = 0.1;      // of a step: decimals that a file leaves out
  constexpr double kMostBeside = 0.1;
  std::ranges::sort(values);
  std::vector<double> differences;
  for (std::size_t k = 1; k < values.size(); ++k) {
    if (values[k] - values[k - 1] > kEqual) differences.push_back(values[k] - values[k - 1]);
  }
  if (differences.size() < kFewest) return 0;
  const double step = std::ranges::min(differences);
  const auto beside = std::ranges::count_if(differences, [&](double difference) {
    const double steps = difference / step;
    return steps > kFarthest || std::abs(steps - std::round(steps)) > kOff;
  });
  return static_cast<double>(beside) <= kMostBeside * static_cast<double>(differences.size()) ? step : 0;
}

class Judge {
 public:
  Judge(const SessionSnapshot& snapshot, const SkinGraph& graph, GravityTable& table, std::vector<Finding>& findings)
      : snapshot_(snapshot), graph_(graph), table_(table), findings_(findings) {}

  void run() {
    findMissing();
    for (std::size_t cell = 0; cell < table_.cellCount(); ++cell) findDeadAxis(cell);
    const double expected_g = normOfLot_g();
    for (std::size_t cell = 0; cell < table_.cellCount(); ++cell) judgeReadings(cell, expected_g);
    findIdentical();
    for (const std::size_t pose : table_.enabledPoses()) judgeScatter(pose);
    findStuck();
  }

 private:
  [[nodiscard]] CellId id(std::size_t cell) const { return graph_.cells()[cell].id; }
  [[nodiscard]] PoseId poseId(std::size_t pose) const { return snapshot_.poses[pose].capture->id; }
  [[nodiscard]] std::vector<PoseId> poseIds(const std::vector<std::size_t>& poses) const {
    std::vector<PoseId> ids;
    for (const std::size_t pose : poses) ids.push_back(poseId(pose));
    return ids;
  }
  static Message inPoses(const std::vector<PoseId>& poses) {
    return poses.size() == 1 ? message("in pose {}", poses.front()) : message("in poses {}", poses);
  }

  void findMissing() {
    const std::vector<std::size_t>& enabled = table_.enabledPoses();
    for (std::size_t cell = 0; cell < table_.cellCount() && !enabled.empty(); ++cell) {
      std::vector<PoseId> missing;
      std::vector<PoseId> not_finite;
      for (const std::size_t pose : enabled) {
        const GravityTable::Entry& entry = table_.at(cell, pose);
        if (!entry.measured) (entry.not_finite ? not_finite : missing).push_back(poseId(pose));
      }
      if (missing.size() + not_finite.size() == enabled.size()) {
        findings_.push_back(
            makeFinding(FindingCode::NoSamples, withoutReadings(cell, !not_finite.empty()), {id(cell)}));
        continue;
      }
      if (!missing.empty()) {
        findings_.push_back(makeFinding(
            FindingCode::MissingSamples,
            message("Cell {} delivered no reading {}; it is placed from the other poses.", id(cell), inPoses(missing)),
            {id(cell)}, {}, missing));
      }
      if (!not_finite.empty()) {
        findings_.push_back(
            makeFinding(FindingCode::MissingSamples,
                        message("The reading of cell {} is no finite number {}; it is placed from the other poses.",
                                id(cell), inPoses(not_finite)),
                        {id(cell)}, {}, not_finite));
      }
    }
  }

  [[nodiscard]] Message withoutReadings(std::size_t cell, bool not_finite) const {
    const bool has_links = graph_.patches()[graph_.cells()[cell].patch.value()].size() > 1;
    if (not_finite) {
      return has_links
                 ? message("The readings of cell {} are no finite numbers; it is placed through its links.", id(cell))
                 : message("The readings of cell {} are no finite numbers, and no link joins it to another cell.",
                           id(cell));
    }
    return has_links
               ? message("Cell {} delivered no reading in any pose; it is placed through its links.", id(cell))
               : message("Cell {} delivered no reading in any pose, and no link joins it to another cell.", id(cell));
  }

  /// What one sensor sends is nobody else's, digit for digit: noise, steps and offsets make that as good as impossible.
  /// Cells that share all digits in a pose are repeated by whoever delivers them, and nobody knows whose they are.
  void findIdentical() {
    constexpr double kByChance = 1e-4;
    std::map<std::vector<std::size_t>, std::vector<std::size_t>> poses_of;  // per group of cells
    for (const std::size_t pose : table_.enabledPoses()) {
      for (const std::vector<std::size_t>& cells : cellsThatReadAlike(pose)) poses_of[cells].push_back(pose);
    }
    const double grid_step_g = poses_of.empty() ? 0 : stepOfMeans();
    for (const auto& [cells, poses] : poses_of) {
      if (chanceOfSameReadings(cells.front(), poses, grid_step_g) < kByChance) describeIdentical(cells, poses);
    }
  }

  /// Groups of at least two cells, each in the order of the cells.
  [[nodiscard]] std::vector<std::vector<std::size_t>> cellsThatReadAlike(std::size_t pose) const {
    std::vector<std::pair<double, std::size_t>> by_x;
    by_x.reserve(table_.cellCount());
    for (std::size_t cell = 0; cell < table_.cellCount(); ++cell) {
      if (table_.at(cell, pose).usable) by_x.emplace_back(table_.at(cell, pose).mean_g.x(), cell);
    }
    std::ranges::sort(by_x);
    std::vector<std::vector<std::size_t>> groups;
    for (auto from = by_x.begin(); from != by_x.end();) {
      const auto to = std::find_if(from, by_x.end(), [&](const auto& entry) { return entry.first != from->first; });
      if (to - from > 1) {
        std::map<std::pair<double, double>, std::vector<std::size_t>> alike;
        for (auto k = from; k != to; ++k) {
          const Eigen::Vector3d& y_g = table_.at(k->second, pose).mean_g;
          alike[{y_g.y(), y_g.z()}].push_back(k->second);
        }
        for (auto& [reading, cells] : alike) {
          if (cells.size() > 1) groups.push_back(std::move(cells));
        }
      }
      from = to;
    }
    return groups;
  }

  /// How many pairs of this skin's cells are to be expected to share all digits with each other in so many poses.
  /// `grid_step_g`: of the means; 0: none to be seen.
  [[nodiscard]] double chanceOfSameReadings(std::size_t cell, const std::vector<std::size_t>& poses,
                                            double grid_step_g) const {
    const Accelerometer& a = snapshot_.model->accelerometer;
    const auto cells = static_cast<double>(table_.cellCount());
    double chance = cells * cells / 2 * static_cast<double>(table_.enabledPoses().size());
    double offset_g =
        a.largestOffsetSigma_g();  // two sensors that agree in one pose have the same offsets in all others
    for (const std::size_t pose : poses) {
      const std::optional<double> step_g = resolution(cell, pose, grid_step_g);
      if (!step_g) return 1;
      const double spread_g = std::hypot(offset_g, std::sqrt(table_.at(cell, pose).own_variance_g2));
      chance *= std::pow(std::min(1.0, *step_g / (2 * std::sqrt(kPi) * spread_g)), 3);
      offset_g = 0;
    }
    return chance;
  }

  /// Means may be rounded more coarsely than the data sheet says, on their way here or by the chip. All axes' steps are
  /// the same.
  [[nodiscard]] double stepOfMeans() const {
    const Eigen::Matrix3d R_a_u = snapshot_.model->accelerometer.T_u_a.R.transpose();
    std::vector<double> values;
    for (const std::size_t pose : table_.enabledPoses()) {
      for (std::size_t cell = 0; cell < table_.cellCount(); ++cell) {
        if (!table_.at(cell, pose).measured) continue;
        const Eigen::Vector3d y_g = R_a_u * table_.at(cell, pose).mean_g;
        values.insert(values.end(), y_g.begin(), y_g.end());
      }
    }
    return stepOfGrid(std::move(values));
  }

  /// The step between two readings that can be told apart. None where nothing says that the readings are a real
  /// sensor's: those of an ideal one, without noise and steps, may well be the same.
  [[nodiscard]] std::optional<double> resolution(std::size_t cell, std::size_t pose, double grid_step_g) const {
    const double lsb_g = snapshot_.model->accelerometer.lsb_g;
    const GravityTable::Entry& entry = table_.at(cell, pose);
    if (entry.sample_sigma_g > 0) return std::max(lsb_g / entry.count, grid_step_g);
    constexpr double kWhole = 1e-6;
    const Eigen::Vector3d steps = snapshot_.model->accelerometer.T_u_a.R.transpose() * entry.mean_g / lsb_g;
    const bool is_one_sample = lsb_g > 0 && (steps - steps.array().round().matrix()).cwiseAbs().maxCoeff() < kWhole;
    return is_one_sample ? std::optional(std::max(lsb_g, grid_step_g)) : std::nullopt;
  }

  void describeIdentical(const std::vector<std::size_t>& cells, const std::vector<std::size_t>& poses) {
    std::vector<CellId> ids;
    for (const std::size_t cell : cells) {
      ids.push_back(id(cell));
      // Whose readings they are is not known in the other poses either.
      for (const std::size_t pose : table_.enabledPoses()) table_.at(cell, pose).usable = false;
    }
    const std::vector<PoseId> pose_ids = poseIds(poses);
    Message words =
        cells.size() == table_.cellCount()
            ? message(
                  "All {} cells read the same, digit for digit, {}: the readings of one are delivered for all. None "
                  "is used.",
                  cells.size(), inPoses(pose_ids))
            : message(
                  "The cells {} read the same, digit for digit, {}: no two sensors do, so one's readings are "
                  "delivered for the others too. None of them is used; they are placed through their links.",
                  ids, inPoses(pose_ids));
    findings_.push_back(makeFinding(FindingCode::IdenticalReadings, std::move(words), ids, {}, pose_ids));
  }

  /// How improbable it is that 1 g was read in every pose by a sensor with an offset and scale errors: a chi-squared.
  [[nodiscard]] double misfitOfNorms(std::size_t cell, const std::vector<std::size_t>& poses) const {
    using Vector6 = Eigen::Matrix<double, 6, 1>;
    constexpr double kMin = 1e-3;
    constexpr double kLinear_g = 0.02;  // what is left of a norm when it is taken as linear in offsets of 0.2 g
    const Accelerometer a = snapshot_.model->accelerometer.ofUnknownLot();
    // An offset b lengthens a reading along d by b.d, and scales s by the sum of s_i d_i^2.
    Vector6 sigmas;
    sigmas << a.offset_sigma_g.cwiseMax(kMin), Eigen::Vector3d::Constant(std::max(kMin, a.scale_sigma));
    Matrix6d information = sigmas.cwiseAbs2().cwiseInverse().asDiagonal();
    Vector6 weighted = Vector6::Zero();
    double squares = 0;
    for (const std::size_t pose : poses) {
      const Eigen::Vector3d y_g = a.T_u_a.R.transpose() * table_.at(cell, pose).mean_g;
      const double too_long = (y_g.norm() - 1) / kLinear_g;
      Vector6 longer;
      longer << y_g.normalized(), y_g.normalized().cwiseAbs2();
      longer /= kLinear_g;
      information += longer * longer.transpose();
      weighted += longer * too_long;
      squares += too_long * too_long;
    }
    return squares - weighted.dot(information.llt().solve(weighted));
  }

  /// An axis that reads the same in all poses although the length of what the cell reads rises and falls with them by
  /// more than a sensor's errors explain. (An axis along which gravity happens not to change leaves the length as it
  /// is. Among thousands of cells there are some of which this holds, and whose offsets are large.)
  void findDeadAxis(std::size_t cell) {
    constexpr double kConstant_g = 0.02;
    constexpr double kChanging_g = 0.3;
    constexpr std::size_t kFewestPoses = 3;
    const Accelerometer& a = snapshot_.model->accelerometer;
    if (table_.usablePoseCount(cell) < kFewestPoses) return;
    const std::vector<std::size_t> poses = table_.usablePoses(cell);
    // With three degrees of freedom healthy cells exceed the first two once in two skins; that gravity is the same
    // along an axis of theirs too is rare. What further poses add is as many again.
    const double least_misfit = 4 + 2 * std::log(static_cast<double>(table_.cellCount())) +
                                2 * static_cast<double>(poses.size() - kFewestPoses);
    Eigen::Vector3d lowest = Eigen::Vector3d::Constant(std::numeric_limits<double>::infinity());
    Eigen::Vector3d highest = -lowest;
    double shortest_g = std::numeric_limits<double>::infinity();
    double longest_g = 0;
    for (const std::size_t pose : poses) {
      const Eigen::Vector3d y_g = a.T_u_a.R.transpose() * table_.at(cell, pose).mean_g;
      lowest = lowest.cwiseMin(y_g);
      highest = highest.cwiseMax(y_g);
      shortest_g = std::min(shortest_g, y_g.norm());
      longest_g = std::max(longest_g, y_g.norm());
    }
    if (longest_g < kDeadNorm_g || longest_g - shortest_g < kChanging_g) return;
    const Eigen::Vector3d range_g = highest - lowest;
    for (int axis = 0; axis < 3; ++axis) {
      if (range_g[axis] > kConstant_g || range_g.maxCoeff() < kChanging_g) continue;
      if (misfitOfNorms(cell, poses) < least_misfit) return;
      for (const std::size_t pose : poses) table_.at(cell, pose).usable = false;
      findings_.push_back(makeFinding(
          FindingCode::DeadAxis,
          message("Cell {} reads {} on its {} axis in all poses, while what it reads in all ranges from {} to {}: the "
                  "axis is dead. The cell is placed through its links.",
                  id(cell), MilliG{lowest[axis]}, std::string(1, "xyz"[axis]), MilliG{shortest_g}, MilliG{longest_g}),
          {id(cell)}, {}, poseIds(poses)));
      return;
    }
  }

  /// How much the skin's lot reads of 1 g: what most of its readings do, as far as the cell model allows.
  [[nodiscard]] double normOfLot_g() const {
    const double allowed = 5 * snapshot_.model->accelerometer.scale_shared_sigma;
    std::vector<double> norms;
    for (const std::size_t pose : table_.enabledPoses()) {
      for (std::size_t cell = 0; cell < table_.cellCount(); ++cell) {
        if (table_.at(cell, pose).usable) norms.push_back(table_.at(cell, pose).mean_g.norm());
      }
    }
    return norms.empty() ? 1 : std::clamp(median(std::move(norms)), 1 - allowed, 1 + allowed);
  }

  /// Range and norm: a reading that can't be gravity is not used.
  void judgeReadings(std::size_t cell, double expected_g) {
    const Accelerometer& a = snapshot_.model->accelerometer;
    // Both the reading and what it is compared with hold the lot's offset, as it lies in their poses.
    const double own = std::hypot(a.largestOffsetSigma_g(), a.scale_sigma);
    const double tolerance =
        std::max(kMinNormTolerance_g, 5 * std::hypot(own, std::sqrt(2.0) * a.offset_shared_sigma_g));
    std::vector<std::size_t> saturated;
    std::vector<std::size_t> dead;
    std::vector<std::size_t> off_norm;
    double worst_norm = expected_g;
    std::size_t measured = 0;
    for (const std::size_t pose : table_.enabledPoses()) {
      GravityTable::Entry& entry = table_.at(cell, pose);
      if (!entry.usable) continue;
      ++measured;
      const double norm = entry.mean_g.norm();
      if ((a.T_u_a.R.transpose() * entry.mean_g).cwiseAbs().maxCoeff() >= a.range_g - 1.5 * a.lsb_g) {
        saturated.push_back(pose);
      } else if (norm < kDeadNorm_g) {
        dead.push_back(pose);
      } else if (std::abs(norm - expected_g) > tolerance) {
        off_norm.push_back(pose);
        if (std::abs(norm - expected_g) > std::abs(worst_norm - expected_g)) worst_norm = norm;
      } else {
        continue;
      }
      entry.usable = false;
    }
    if (!saturated.empty()) {
      const std::vector<PoseId> poses = poseIds(saturated);
      findings_.push_back(
          makeFinding(FindingCode::SaturatedSensor,
                      message("Cell {} reads the end of its range ({} g) {}; these readings are not used.", id(cell),
                              Number{a.range_g, 1}, inPoses(poses)),
                      {id(cell)}, {}, poses));
    }
    if (!dead.empty()) {
      const std::vector<PoseId> poses = poseIds(dead);
      const bool always = dead.size() == measured;
      findings_.push_back(
          makeFinding(FindingCode::DeadSensor,
                      always ? message("Cell {} reads less than {} {}: its accelerometer is dead. The cell is placed "
                                       "through its links.",
                                       id(cell), MilliG{kDeadNorm_g}, inPoses(poses))
                             : message("Cell {} reads less than {} {}; these readings are not used.", id(cell),
                                       MilliG{kDeadNorm_g}, inPoses(poses)),
                      {id(cell)}, {}, poses));
    }
    if (!off_norm.empty()) {
      const std::vector<PoseId> poses = poseIds(off_norm);
      findings_.push_back(
          makeFinding(FindingCode::WrongNorm,
                      message("Cell {} reads up to {} {}, expected {} +- {}; these readings are not used.", id(cell),
                              MilliG{worst_norm}, inPoses(poses), MilliG{expected_g}, MilliG{tolerance}),
                      {id(cell)}, {}, poses));
    }
  }

  /// One cell that scatters is a bad sensor; most cells that scatter are a part that moved.
  void judgeScatter(std::size_t pose) {
    const Accelerometer& a = snapshot_.model->accelerometer;
    const double white_g = std::hypot(a.noise_g_per_sqrt_hz * std::sqrt(a.rate_hz / 2), a.lsb_g / std::sqrt(12));
    std::vector<double> sigmas;
    for (std::size_t cell = 0; cell < table_.cellCount(); ++cell) {
      const GravityTable::Entry& entry = table_.at(cell, pose);
      if (entry.usable && entry.sample_sigma_g > 0) sigmas.push_back(entry.sample_sigma_g);
    }
    const double usual_g = median(sigmas);
    if (usual_g > std::max(kMovingSigma_g, kNoisyTimesOthers * white_g)) {
      findings_.push_back(makeFinding(
          FindingCode::PartMoved,
          message(
              "In pose {} the readings of most cells scatter by {}: the part was probably moving. Take the pose again.",
              poseId(pose), MilliG{usual_g}),
          {}, {}, {poseId(pose)}));
      return;
    }
    // Two cells can't outvote each other.
    constexpr std::size_t kFewestForAVote = 3;
    const double limit_g = std::max(kNoisyTimesOthers * (sigmas.size() >= kFewestForAVote ? usual_g : 0), 5 * white_g);
    for (std::size_t cell = 0; cell < table_.cellCount(); ++cell) {
      GravityTable::Entry& entry = table_.at(cell, pose);
      if (!entry.usable || entry.sample_sigma_g <= limit_g) continue;
      entry.usable = false;
      findings_.push_back(
          makeFinding(FindingCode::NoisySensor,
                      message("Cell {} scatters by {} in pose {} (other cells {}, limit {}); the reading is not used.",
                              id(cell), MilliG{entry.sample_sigma_g}, poseId(pose), MilliG{usual_g}, MilliG{limit_g}),
                      {id(cell)}, {}, {poseId(pose)}));
    }
  }

  /// The largest angle between a cell's reading in its first usable pose and in any other one.
  [[nodiscard]] double turned(std::size_t cell) const {
    const GravityTable::Entry* first = nullptr;
    double largest = 0;
    for (const std::size_t pose : table_.enabledPoses()) {
      const GravityTable::Entry& entry = table_.at(cell, pose);
      if (!entry.usable) continue;
      if (first == nullptr) {
        first = &entry;
      } else {
        largest = std::max(largest, angleBetween(first->mean_g, entry.mean_g));
      }
    }
    return largest;
  }

  void findStuck() {
    for (const std::vector<std::size_t>& patch : graph_.patches()) {
      std::vector<double> angles;
      std::vector<std::pair<std::size_t, double>> turns;
      for (const std::size_t cell : patch) {
        if (table_.usablePoseCount(cell) < 2) continue;
        turns.emplace_back(cell, turned(cell));
        angles.push_back(turns.back().second);
      }
      const double usual = median(angles);
      if (usual < kMovedAngle) continue;
      for (const auto& [cell, angle] : turns) {
        if (angle >= kStuckAngle) continue;
        const std::vector<std::size_t> poses = table_.usablePoses(cell);
        for (const std::size_t pose : poses) table_.at(cell, pose).usable = false;
        findings_.push_back(makeFinding(
            FindingCode::StuckSensor,
            message("Cell {} reads the same direction in all poses (within {} degrees) while the other cells turn by "
                    "{} degrees: its accelerometer is stuck. The cell is placed through its links.",
                    id(cell), Number{toDegrees(angle), 1}, Number{toDegrees(usual), 0}),
            {id(cell)}, {}, poseIds(poses)));
      }
    }
  }

  const SessionSnapshot& snapshot_;
  const SkinGraph& graph_;
  GravityTable& table_;
  std::vector<Finding>& findings_;
};

}  // namespace

void judgeCells(const SessionSnapshot& snapshot, const SkinGraph& graph, GravityTable& table,
                std::vector<Finding>& findings) {
  Judge(snapshot, graph, table, findings).run();
}

}  // namespace hexoderm
