#include "hexoderm/solve/tree/gravity_table.h"

#include <algorithm>
#include <cmath>
#include <map>

namespace hexoderm {
namespace {

/// The paper's K, where a file does not say how many samples were averaged.
constexpr double kDefaultCount = 100;
/// Degrees of freedom with which a variance is known well enough to weigh a reading.
constexpr double kEnoughFreedom = 20;

double countOf(const GravitySample& sample) { return sample.count > 0 ? sample.count : kDefaultCount; }

}  // namespace

/// Variances of single samples, pooled over all poses of a cell: the worst axis of each, and the mean of the axes.
class GravityTable::Scatter {
 public:
  Scatter(const SessionSnapshot& snapshot, const SkinGraph& graph) : pooled_(graph.cells().size()) {
    for (const SessionPose& pose : snapshot.poses) {
      for (const GravitySample& sample : pose.capture->samples) {
        const auto cell = graph.indexOf(sample.cell);
        if (!cell || !sample.cov_g2.allFinite() || worst(sample) <= 0) continue;
        Pooled& pooled = pooled_[*cell];
        const double freedom = countOf(sample) - 1;
        pooled.freedom += freedom;
        pooled.worst_g2 += freedom * countOf(sample) * worst(sample);
        pooled.mean_g2 += freedom * countOf(sample) * mean(sample);
      }
    }
  }

  /// Variances of a mean; 0 if nothing states any.
  [[nodiscard]] double worstOf(std::size_t cell, const GravitySample& sample) const {
    return completed(sample, worst(sample), pooled_[cell].worst_g2, pooled_[cell].freedom);
  }
  [[nodiscard]] double meanOf(std::size_t cell, const GravitySample& sample) const {
    return completed(sample, mean(sample), pooled_[cell].mean_g2, pooled_[cell].freedom);
  }

 private:
  struct Pooled {
    double freedom = 0;
    double worst_g2 = 0;  // sums over the poses, weighted by their degrees of freedom
    double mean_g2 = 0;
  };
  static double worst(const GravitySample& sample) { return sample.cov_g2.diagonal().maxCoeff(); }
  static double mean(const GravitySample& sample) { return sample.cov_g2.trace() / 3; }
  static double completed(const GravitySample& sample, double stated_g2, double sum_g2, double freedom) {
    const double stated = std::max(0.0, stated_g2);
    const double count = countOf(sample);
    const double missing = kEnoughFreedom - (count - 1);
    if (missing <= 0 || freedom <= 0) return stated;
    return ((count - 1) * stated + missing * sum_g2 / freedom / count) / kEnoughFreedom;
  }

  std::vector<Pooled> pooled_;
};

GravityTable::GravityTable(const SessionSnapshot& snapshot, const SkinGraph& graph, std::vector<Finding>& findings)
    : cells_(graph.cells().size()), poses_(snapshot.poses.size()), entries_(cells_ * poses_) {
  const Accelerometer& accelerometer = snapshot.model->accelerometer;
  const double step_variance = accelerometer.lsb_g * accelerometer.lsb_g / 12;
  const double white_variance =
      accelerometer.noise_g_per_sqrt_hz * accelerometer.noise_g_per_sqrt_hz * accelerometer.rate_hz / 2;
  const Scatter scatter(snapshot, graph);
  std::map<PoseId, std::size_t> first_of;
  for (std::size_t p = 0; p < poses_; ++p) {
    const PoseCapture& capture = *snapshot.poses[p].capture;
    if (!snapshot.poses[p].disabled) enabled_.push_back(p);
    if (!first_of.emplace(capture.id, p).second) {
      findings.push_back(makeFinding(FindingCode::DuplicatePose,
                                     message("Two poses carry the number {}; both are used.", capture.id), {}, {},
                                     {capture.id}));
    }
    for (const GravitySample& sample : capture.samples) {
      const auto cell = graph.indexOf(sample.cell);
      if (!cell) {
        findings.push_back(makeFinding(
            FindingCode::SampleOfUnknownCell,
            message("Pose {} holds a reading of cell {}, which is not in the skin.", capture.id, sample.cell),
            {sample.cell}, {}, {capture.id}));
        continue;
      }
      Entry& entry = at(*cell, p);
      if (entry.measured) {
        findings.push_back(
            makeFinding(FindingCode::DuplicateSample,
                        message("Pose {} holds two readings of cell {}; the first counts.", capture.id, sample.cell),
                        {sample.cell}, {}, {capture.id}));
        continue;
      }
      entry.not_finite = !sample.mean_g.allFinite() || !sample.cov_g2.allFinite();
      if (entry.not_finite) continue;
      const double stated_variance = scatter.worstOf(*cell, sample);
      entry.count = countOf(sample);
      entry.mean_g = accelerometer.T_u_a.R * sample.mean_g;
      entry.sample_sigma_g = std::sqrt(std::max(0.0, sample.cov_g2.diagonal().maxCoeff()) * entry.count);
      entry.variance_g2 = std::max(stated_variance > 0 ? stated_variance : white_variance / entry.count,
                                   step_variance / entry.count + kTremorFloor_g * kTremorFloor_g);
      entry.own_variance_g2 =
          std::max(stated_variance > 0 ? scatter.meanOf(*cell, sample) : white_variance / entry.count,
                   step_variance / entry.count);
      entry.measured = true;
      entry.usable = true;
    }
  }
}

std::vector<std::size_t> GravityTable::usablePoses(std::size_t cell) const {
  std::vector<std::size_t> poses;
  poses.reserve(enabled_.size());
  for (const std::size_t p : enabled_) {
    if (at(cell, p).usable) poses.push_back(p);
  }
  return poses;
}

std::size_t GravityTable::usablePoseCount(std::size_t cell) const {
  return static_cast<std::size_t>(
      std::ranges::count_if(enabled_, [&](std::size_t pose) { return at(cell, pose).usable; }));
}

}  // namespace hexoderm
