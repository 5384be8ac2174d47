#include "hexoderm/solve/metrics/review_summary.h"

#include "hexoderm/solve/metrics/cell_links.h"

#include <algorithm>

namespace hexoderm {
namespace {

double furthestFromZero(const Eigen::Vector3d& values) {
  Eigen::Index axis = 0;
  values.cwiseAbs().maxCoeff(&axis);
  return values(axis);
}

PoseResiduals describe(std::size_t index, PoseId pose, std::vector<double> residuals) {
  std::ranges::sort(residuals);
  return {index,
          pose,
          residuals.size(),
          residuals.front(),
          quantileOf(residuals, 0.25),
          quantileOf(residuals, 0.5),
          quantileOf(residuals, 0.75),
          residuals.back()};
}

std::vector<ValueBin> countRatios(const std::vector<RankedLink>& links) {
  // Fine enough to see where 1 lies; what is far beyond shares the last bin.
  constexpr double kWidth = 0.1;
  constexpr std::size_t kMaxBins = 50;
  std::vector<ValueBin> bins;
  for (const RankedLink& link : links) {
    if (!link.sigma_rad) continue;
    const double place = std::min(link.residual_rad / *link.sigma_rad / kWidth, static_cast<double>(kMaxBins - 1));
    const auto bin = static_cast<std::size_t>(place);
    while (bins.size() <= bin) {
      const auto k = static_cast<double>(bins.size());
      bins.push_back({kWidth * k, kWidth * (k + 1), 0});
    }
    ++bins[bin].count;
  }
  return bins;
}

}  // namespace

std::vector<CellSummary> summariseCells(const Reconstruction& reconstruction) {
  std::vector<CellSummary> summaries;
  const CellLinks links(reconstruction);
  summaries.reserve(reconstruction.cellCount());
  for (const PatchReconstruction& patch : reconstruction.patches) {
    for (const CellPlacement& cell : patch.cells) {
      CellSummary summary;
      summary.patch = patch.id;
      summary.cell = cell.cell;
      summary.origin = cell.cell == patch.origin;
      summary.placed_by = cell.placed_by;
      summary.T_o_u = cell.T_o_u;
      summary.stated = uncertaintyOf(cell);
      summary.shape = shapeUncertaintyOf(cell);
      summary.worst_residual_rad = worstOf(links.of(summaries.size())).residual_rad;
      summary.offset_g = cell.accel_offset_g;
      if (cell.accel_scale) summary.worst_scale_error = furthestFromZero(cell.accel_scale->array() - 1);
      summaries.push_back(summary);
    }
  }
  return summaries;
}

ResidualSummary summariseResiduals(const Reconstruction& reconstruction) {
  ResidualSummary summary;
  std::vector<std::vector<double>> by_pose(reconstruction.poses.size());
  for (std::size_t p = 0; p < reconstruction.patches.size(); ++p) {
    const PatchReconstruction& patch = reconstruction.patches[p];
    for (std::size_t k = 0; k < patch.links.size(); ++k) {
      const LinkEstimate& link = patch.links[k];
      for (std::size_t pose = 0; pose < std::min(by_pose.size(), link.pose_residual_rad.size()); ++pose) {
        if (link.pose_residual_rad[pose]) by_pose[pose].push_back(*link.pose_residual_rad[pose]);
      }
      if (const std::optional<double> residual_rad = link.knownResidual()) {
        summary.links.push_back({p, k, *residual_rad, link.knownSigma()});
      }
    }
  }
  for (std::size_t pose = 0; pose < by_pose.size(); ++pose) {
    if (by_pose[pose].empty()) continue;
    summary.poses.push_back(describe(pose, reconstruction.poses[pose].pose, std::move(by_pose[pose])));
  }
  std::ranges::stable_sort(summary.links, std::ranges::greater(), &RankedLink::residual_rad);
  summary.ratios = countRatios(summary.links);
  return summary;
}

Message lotText(const LotEstimate& lot) {
  const auto milli_g = [](double value_g) { return Number{1e3 * value_g, 1}; };
  return message("offset {}, {}, {} +- {} mg, scale {} +- {} (1 sigma)", milli_g(lot.offset_g.x()),
                 milli_g(lot.offset_g.y()), milli_g(lot.offset_g.z()), milli_g(lot.offset_sigma_g.maxCoeff()),
                 Number{lot.scale, 3}, Number{lot.scale_sigma, 3});
}

}  // namespace hexoderm
