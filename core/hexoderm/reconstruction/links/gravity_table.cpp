#include "hexoderm/reconstruction/links/gravity_table.h"

#include <algorithm>
#include <cmath>
#include <map>

namespace hexoderm {
namespace {

/// A hand's tremor is not white: averaging does not bring a mean below this.
constexpr double kTremorFloor_g = 0.003;
/// The paper's K, where a file does not say how many samples were averaged.
constexpr double kDefaultCount = 100;

}  // namespace

GravityTable::GravityTable(const SessionSnapshot& snapshot, const SkinGraph& graph, std::vector<Finding>& findings)
    : cells_(graph.cells().size()), poses_(snapshot.poses.size()), entries_(cells_ * poses_) {
  const Accelerometer& accelerometer = snapshot.model->accelerometer;
  const double step_variance = accelerometer.lsb_g * accelerometer.lsb_g / 12;
  const double white_variance =
      accelerometer.noise_g_per_sqrt_hz * accelerometer.noise_g_per_sqrt_hz * accelerometer.rate_hz / 2;
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
      if (!sample.mean_g.allFinite() || !sample.cov_g2.allFinite()) continue;
      const double count = sample.count > 0 ? sample.count : kDefaultCount;
      const double stated_variance = std::max(0.0, sample.cov_g2.diagonal().maxCoeff());
      entry.mean_g = accelerometer.T_u_a.R * sample.mean_g;
      entry.count = count;
      entry.sample_sigma_g = std::sqrt(stated_variance * count);
      entry.variance_g2 = std::max(stated_variance > 0 ? stated_variance : white_variance / count,
                                   step_variance / count + kTremorFloor_g * kTremorFloor_g);
      entry.own_variance_g2 =
          std::max(stated_variance > 0 ? sample.cov_g2.trace() / 3 : white_variance / count, step_variance / count);
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

}  // namespace hexoderm
