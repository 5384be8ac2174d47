#include "hexoderm/solve/metrics/pose_coverage.h"

#include "hexoderm/base/se3.h"
#include "hexoderm/solve/global/accelerometer_fit.h"
#include "hexoderm/solve/tree/edge_rotation.h"

#include <Eigen/Eigenvalues>
#include <Eigen/LU>
#include <Eigen/SVD>
#include <algorithm>
#include <array>
#include <cmath>

namespace hexoderm {
namespace {

/// One cell's opinion of where up is.
struct Vote {
  Eigen::Vector3d up_o;
  double weight = 1;
};

/// Nothing where the reading is no gravity at all.
std::optional<Vote> voteOf(const Accelerometer& accelerometer, const CellPlacement& cell,
                           const Eigen::Vector3d& reading_g) {
  constexpr double kMin_g = 0.5;
  constexpr double kMax_g = 1.5;
  constexpr double kPlacedByLinks = 0.25;
  Eigen::Vector3d force_g = reading_g;
  if (cell.accel_offset_g) force_g -= *cell.accel_offset_g;
  if (cell.accel_scale && cell.accel_scale->minCoeff() > 0) force_g = force_g.cwiseQuotient(*cell.accel_scale);
  const double norm_g = force_g.norm();
  if (!(norm_g >= kMin_g && norm_g <= kMax_g)) return std::nullopt;
  return Vote{cell.T_o_u.R * (accelerometer.T_u_a.R * (force_g / norm_g)),
              cell.placed_by == PlacedBy::Links ? kPlacedByLinks : 1.0};
}

std::optional<Eigen::Vector3d> agreedUp(const std::vector<Vote>& votes) {
  constexpr double kFar = 15 * kDegree;
  constexpr double kMinAgreement = 0.7;
  constexpr int kRounds = 3;
  if (votes.empty()) return std::nullopt;
  Eigen::Vector3d sum = Eigen::Vector3d::Zero();
  double total = 0;
  for (const Vote& vote : votes) {
    sum += vote.weight * vote.up_o;
    total += vote.weight;
  }
  if (sum.norm() < kMinAgreement * total) return std::nullopt;
  Eigen::Vector3d up_o = sum.normalized();
  for (int round = 0; round < kRounds; ++round) {
    sum.setZero();
    for (const Vote& vote : votes) {
      const double away = angleBetween(vote.up_o, up_o) / kFar;
      sum += vote.weight / (1 + away * away) * vote.up_o;
    }
    if (sum.norm() > 0) up_o = sum.normalized();
  }
  return up_o;
}

template <class Samples, class Reading>
std::optional<Eigen::Vector3d> upFrom(const Reconstruction& reconstruction, const Samples& samples,
                                      const Reading& reading_g) {
  const PatchReconstruction* patch = largestPatch(reconstruction);
  if (patch == nullptr) return std::nullopt;
  std::vector<Vote> votes;
  votes.reserve(patch->cells.size());
  for (const auto& sample : samples) {
    const CellPlacement* cell = patch->findCell(sample.cell);
    if (cell == nullptr) continue;
    if (const auto vote = voteOf(reconstruction.model->accelerometer, *cell, reading_g(sample))) votes.push_back(*vote);
  }
  return agreedUp(votes);
}

struct Spread {
  Eigen::Vector3d values = Eigen::Vector3d::Zero();          ///< descending
  Eigen::Matrix3d directions = Eigen::Matrix3d::Identity();  ///< columns, in the same order
};

Spread spreadOf(const std::vector<GravityDirection>& gravity) {
  Eigen::Matrix3d sum = Eigen::Matrix3d::Zero();
  for (const GravityDirection& direction : gravity) sum += direction.g_o * direction.g_o.transpose();
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver(sum);
  Spread spread;
  spread.values = solver.eigenvalues().reverse().cwiseMax(0.0);
  spread.directions = solver.eigenvectors().rowwise().reverse();
  return spread;
}

/// Without any pose every direction is missing: the origin's front is as good as any, and easy to say.
MissingDirection missingDirection(const Spread& spread, double threshold, const PatchReconstruction& patch) {
  MissingDirection missing;
  missing.which = spread.values.x() < threshold ? 1 : spread.values.y() < threshold ? 2 : 3;
  missing.value = spread.values(missing.which - 1);
  missing.up_o =
      missing.which == 1 ? Eigen::Vector3d::UnitZ() : Eigen::Vector3d(spread.directions.col(missing.which - 1));
  missing.facing = clearestFacing(patch, missing.up_o);
  if (missing.facing.facing == Facing::Floor) {
    missing.facing.facing = Facing::Ceiling;
    missing.up_o = -missing.up_o;
  }
  return missing;
}

const char* axisName(const Eigen::Vector3d& up_o) {
  if (std::abs(up_o.x()) > std::abs(up_o.y())) return up_o.x() > 0 ? "+x" : "-x";
  return up_o.y() > 0 ? "+y" : "-y";
}

/// What readings along up directions will say about an edge's rotation: sums over the directions, so that one more
/// costs the same however many there are.
class EdgeForecast {
 public:
  explicit EdgeForecast(const CellModel& model)
      : sensor_(model.accelerometer.ofUnknownLot()),
        // The elastomer prior is taken alike in all directions, because the cells of a patch face many ways.
        prior_sq_((model.bend_sigma_rad * model.bend_sigma_rad + model.twist_sigma_rad * model.twist_sigma_rad +
                   model.yaw_sigma_rad * model.yaw_sigma_rad) /
                  3) {
    for (auto& block : mixed_) block.setZero();
  }

  [[nodiscard]] EdgeForecast with(const Eigen::Vector3d& up) const {
    // Averaging does not remove a hand's tremor, which is not white.
    constexpr double kTremor_g = 0.003;
    constexpr double kPrecision = 1 / (kTremor_g * kTremor_g);
    EdgeForecast more = *this;
    const Eigen::Vector4d row(1, up.x(), up.y(), up.z());
    const Eigen::Matrix3d J = skew(up);
    more.normal_ += kPrecision * row * row.transpose();
    more.information_ += kPrecision * J.transpose() * J;
    for (int axis = 0; axis < 3; ++axis) {
      more.mixed_[static_cast<std::size_t>(axis)] += kPrecision * row * J.row(axis);
    }
    more.directions_ += up * up.transpose();
    return more;
  }

  /// Predicted uncertainty of the rotation: rms over the three axes, radians.
  [[nodiscard]] double sigma() const {
    Eigen::Matrix3d information = information_;
    for (int axis = 0; axis < 3; ++axis) {
      // The errors of the sensor, eliminated.
      Eigen::Matrix4d of_sensor = normal_;
      of_sensor.diagonal() += sensor_.precision(axis);
      const auto& mixed = mixed_[static_cast<std::size_t>(axis)];
      const Eigen::Matrix<double, 4, 3> root = rootOfInverse(of_sensor).transpose() * mixed;
      information -= root.transpose() * root;
    }
    // An edge joins two cells that err alike.
    const Eigen::Matrix3d of_edge = information / 2 + Eigen::Matrix3d::Identity() / prior_sq_;
    return std::sqrt(of_edge.inverse().trace() / 3);
  }

  /// Share of the directions that lies off their main line: the second singular value of eq. (17), as the solver has
  /// it.
  [[nodiscard]] double secondDirection() const {
    return Eigen::JacobiSVD<Eigen::Matrix3d>(directions_).singularValues().y();
  }

 private:
  AccelerometerPrior sensor_;
  double prior_sq_;
  Eigen::Matrix4d normal_ = Eigen::Matrix4d::Zero();
  Eigen::Matrix3d information_ = Eigen::Matrix3d::Zero();
  std::array<Eigen::Matrix<double, 4, 3>, 3> mixed_;
  Eigen::Matrix3d directions_ = Eigen::Matrix3d::Zero();
};

constexpr double kDefined = 0.5;
constexpr double kClearlyDefined = 0.9;

/// Points spread evenly over the sphere (a Fibonacci lattice).
std::vector<Eigen::Vector3d> sphereCandidates() {
  constexpr int kCount = 400;
  const double golden = kPi * (3 - std::sqrt(5.0));
  std::vector<Eigen::Vector3d> candidates;
  for (int k = 0; k < kCount; ++k) {
    const double z = 1 - (2 * k + 1.0) / kCount;
    const double r = std::sqrt(1 - z * z);
    candidates.emplace_back(r * std::cos(golden * k), r * std::sin(golden * k), z);
  }
  return candidates;
}

}  // namespace

DiscPoint onDisc(const Eigen::Vector3d& up_o) {
  DiscPoint point;
  point.side = up_o.z() < 0 ? Hemisphere::Back : Hemisphere::Front;
  const double across = std::hypot(up_o.x(), up_o.y());
  if (across == 0) return point;
  const double radius = std::sqrt(std::max(0.0, 1 - std::abs(up_o.z())));
  const double mirror = point.side == Hemisphere::Back ? -1 : 1;
  point.at = radius / across * Vector2d(mirror * up_o.x(), up_o.y());
  return point;
}

double discRadius(double angle_rad) { return std::numbers::sqrt2 * std::sin(0.5 * angle_rad); }

Facing facingOf(const CellPlacement& cell, const Eigen::Vector3d& up_o) {
  // Rounded, so that exactly 45 degrees is not a matter of the last digit.
  const double upright = cell.T_o_u.R.col(2).dot(up_o);
  if (std::abs(upright) < std::cos(45 * kDegree) - 1e-9) return Facing::Wall;
  return upright > 0 ? Facing::Ceiling : Facing::Floor;
}

CellFacing clearestFacing(const PatchReconstruction& patch, const Eigen::Vector3d& up_o) {
  const CellPlacement* chosen = nullptr;
  double most_upright = 0;
  for (const CellPlacement& cell : patch.cells) {
    const double upright = std::abs(cell.T_o_u.R.col(2).dot(up_o));
    if (chosen != nullptr && upright <= most_upright + 1e-9) continue;
    chosen = &cell;
    most_upright = upright;
  }
  return {chosen->cell, facingOf(*chosen, up_o)};
}

PoseCoverage coverageOf(const Reconstruction& reconstruction,
                        std::span<const std::shared_ptr<const PoseCapture>> captures) {
  PoseCoverage coverage;
  coverage.threshold = reconstruction.options.class_threshold;
  const PatchReconstruction* patch = largestPatch(reconstruction);
  if (patch == nullptr) return coverage;
  const auto add = [&](const PoseSummary& pose, const Eigen::Vector3d& up_o) {
    coverage.seen.push_back({pose.pose, pose.label, pose.enabled, up_o, onDisc(up_o)});
    if (pose.enabled) ++coverage.enabled;
  };
  for (const PoseSummary& pose : reconstruction.poses) {
    const auto known = std::ranges::find(patch->gravity, pose.pose, &GravityDirection::pose);
    if (pose.enabled && known != patch->gravity.end()) {
      add(pose, known->g_o);
      continue;
    }
    const auto capture = std::ranges::find_if(captures, [&](const auto& taken) { return taken->id == pose.pose; });
    std::optional<Eigen::Vector3d> up_o;
    if (!pose.enabled && capture != captures.end()) {
      up_o = currentUp(reconstruction, std::span<const GravitySample>((*capture)->samples));
    }
    if (up_o) {
      add(pose, *up_o);
    } else {
      coverage.unplaced.push_back(pose.pose);
    }
  }
  const Spread spread = spreadOf(patch->gravity);
  coverage.singular_values = spread.values;
  coverage.quality = classifyEdge(spread.values, coverage.threshold);
  // A direction is missing where the assessment says that another one would help.
  if (coverage.quality != EdgeQuality::Over && reconstruction.assessment.remedy == Remedy::TakePose) {
    coverage.missing = missingDirection(spread, coverage.threshold, *patch);
  }
  return coverage;
}

bool fillsMissing(const PoseCoverage& coverage, const Eigen::Vector3d& up_o) {
  if (!coverage.missing) return false;
  std::vector<GravityDirection> gravity;
  for (const SeenDirection& seen : coverage.seen) {
    if (seen.enabled) gravity.push_back({seen.pose, seen.up_o, 0});
  }
  gravity.push_back({PoseId(), up_o.normalized(), 0});
  return spreadOf(gravity).values(coverage.missing->which - 1) >= coverage.threshold;
}

std::optional<Eigen::Vector3d> currentUp(const Reconstruction& reconstruction, std::span<const CellSample> readings) {
  return upFrom(reconstruction, readings, [](const CellSample& sample) { return sample.acceleration_g; });
}

std::optional<Eigen::Vector3d> currentUp(const Reconstruction& reconstruction, std::span<const GravitySample> means) {
  return upFrom(reconstruction, means, [](const GravitySample& sample) { return sample.mean_g; });
}

std::optional<NextPose> describeNextPose(const PoseAdvice& advice, const Reconstruction& reconstruction,
                                         const std::optional<Eigen::Vector3d>& current_up_o) {
  constexpr double kOpposite = 30 * kDegree;
  const PatchReconstruction* patch = largestPatch(reconstruction);
  if (patch == nullptr) return std::nullopt;
  NextPose next;
  next.up_o = advice.up;
  next.at = onDisc(advice.up);
  next.target = clearestFacing(*patch, advice.up);
  if (current_up_o) {
    next.turn_rad = angleBetween(*current_up_o, advice.up);
  } else if (!patch->gravity.empty()) {
    next.turn_rad = angleBetween(patch->gravity.back().g_o, advice.up);
  }
  next.sigma_now_rad = advice.sigma_now_rad;
  next.sigma_then_rad = advice.sigma_then_rad;
  const double threshold = reconstruction.options.class_threshold;
  const EdgeQuality quality = classifyEdge(spreadOf(patch->gravity).values, threshold);
  if (patch->gravity.empty()) {
    next.gain = PoseGain::First;
  } else if (quality < EdgeQuality::Fully) {
    next.gain = PoseGain::SecondDirection;
  } else if (quality == EdgeQuality::Fully) {
    next.gain = PoseGain::OutOfPlane;
  } else {
    const auto opposite = std::ranges::find_if(
        patch->gravity, [&](const GravityDirection& seen) { return angleBetween(-seen.g_o, advice.up) < kOpposite; });
    next.gain = opposite == patch->gravity.end() ? PoseGain::Further : PoseGain::Opposite;
    if (opposite != patch->gravity.end()) next.opposite_of = opposite->pose;
  }
  next.worthwhile = reconstruction.assessment.wantsPose();
  next.goal = reconstruction.options.goal;
  next.is_good = reconstruction.assessment.level == VerdictLevel::Good;
  return next;
}

Message poseLabel(const Eigen::Vector3d& up_o) {
  // Up in the origin's frame: its z is how much the origin's front points up.
  const double elevation_rad = std::asin(std::clamp(up_o.z(), -1.0, 1.0));
  constexpr double kLevel = 30 * kDegree;
  constexpr double kUpright = 60 * kDegree;
  if (elevation_rad >= kUpright) return message("facing ceiling");
  if (elevation_rad <= -kUpright) return message("facing floor");
  const std::string axis = axisName(up_o);
  if (std::abs(elevation_rad) <= kLevel) return message("facing wall, {} up", axis);
  return elevation_rad > 0 ? message("tilted up, {} up", axis) : message("tilted down, {} up", axis);
}

Message poseLabel(const Reconstruction& reconstruction, const PoseCapture& capture) {
  constexpr double kMin_g = 0.5;
  const PatchReconstruction* patch = largestPatch(reconstruction);
  if (patch == nullptr) return {};
  const auto sample = std::ranges::find(capture.samples, patch->origin, &GravitySample::cell);
  if (sample == capture.samples.end() || !(sample->mean_g.norm() >= kMin_g)) return {};
  return poseLabel(reconstruction.model->accelerometer.T_u_a.R * sample->mean_g.normalized());
}

PoseAdvice adviseNextPose(const CellModel& model, const std::vector<Eigen::Vector3d>& seen,
                          const std::vector<Eigen::Vector3d>& unreachable) {
  constexpr double kOutOfReach = 30 * kDegree;
  EdgeForecast now(model);
  for (const Eigen::Vector3d& up : seen) now = now.with(up);

  PoseAdvice advice;
  advice.sigma_now_rad = now.sigma();
  advice.sigma_then_rad = now.with(advice.up).sigma();
  if (seen.empty() && unreachable.empty()) return advice;
  bool found = false;
  const bool one_line = !seen.empty() && now.secondDirection() < kDefined;
  for (const Eigen::Vector3d& candidate : sphereCandidates()) {
    const bool out_of_reach = std::ranges::any_of(unreachable, [&](const Eigen::Vector3d& direction) {
      return angleBetween(candidate, direction) < kOutOfReach;
    });
    if (out_of_reach) continue;
    const EdgeForecast then = now.with(candidate);
    // To first order two poses 45 degrees apart suffer least from offsets, but leave the turn about their middle to a
    // single small angle: as long as all directions lie on one line, one that leaves this line comes first.
    if (one_line && then.secondDirection() < kClearlyDefined) continue;
    const double sigma = then.sigma();
    if (found && sigma >= advice.sigma_then_rad) continue;
    found = true;
    advice.sigma_then_rad = sigma;
    advice.up = candidate;
  }
  return advice;
}

std::vector<Eigen::Vector3d> directionsSeen(const Reconstruction& reconstruction) {
  std::vector<Eigen::Vector3d> seen;
  const PatchReconstruction* largest = largestPatch(reconstruction);
  if (largest == nullptr) return seen;
  for (const GravityDirection& gravity : largest->gravity) seen.push_back(gravity.g_o);
  return seen;
}

bool lieAlongOneLine(std::span<const Eigen::Vector3d> directions) {
  constexpr double kAcross = 15 * kDegree;  // offsets of the sensors bend opposite directions by up to as much
  if (directions.size() < 2) return false;
  Eigen::Matrix3d sum = Eigen::Matrix3d::Zero();
  for (const Eigen::Vector3d& direction : directions) sum += direction * direction.transpose();
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver(sum, Eigen::EigenvaluesOnly);
  const double along = solver.eigenvalues()[2] / sum.trace();
  return along > std::pow(std::cos(kAcross), 2);
}

Message adviceText(const PoseAdvice& advice, const Reconstruction& reconstruction) {
  const PatchReconstruction* patch = largestPatch(reconstruction);
  if (patch == nullptr) return {};
  const CellFacing target = clearestFacing(*patch, advice.up);
  // On a nearly flat patch no cell may face up or down: then its edge does, and the wall is what it faces.
  return target.facing == Facing::Ceiling ? message("Turn the part so that cell {} faces the ceiling.", target.cell)
         : target.facing == Facing::Floor
             ? message("Turn the part so that cell {} faces the floor.", target.cell)
             : message("Turn the part so that cell {} faces a wall, its side towards the ceiling.", target.cell);
}

}  // namespace hexoderm
