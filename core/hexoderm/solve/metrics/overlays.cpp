#include "hexoderm/solve/metrics/overlays.h"

#include "hexoderm/base/procrustes.h"
#include "hexoderm/solve/metrics/value_scale.h"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <unordered_map>

namespace hexoderm {
namespace {

/// Whether the points span a plane, so that a rigid fit of them has one solution.
bool fixesARotation(std::span<const Eigen::Vector3d> points) {
  if (points.size() < 3) return false;
  Eigen::Vector3d mean = Eigen::Vector3d::Zero();
  for (const Eigen::Vector3d& point : points) mean += point;
  mean /= static_cast<double>(points.size());
  Eigen::Matrix3d scatter = Eigen::Matrix3d::Zero();
  for (const Eigen::Vector3d& point : points) scatter += (point - mean) * (point - mean).transpose();
  Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver(scatter, Eigen::EigenvaluesOnly);
  constexpr double kThin = 0.05;  // width of a line of points, of its length
  return solver.eigenvalues()[1] > kThin * kThin * solver.eigenvalues()[2];
}

}  // namespace

std::vector<AlignedCell> alignTruth(const Reconstruction& reconstruction, const GroundTruth& truth) {
  std::unordered_map<CellId, const SE3*> true_placement;
  for (const TrueCellPlacement& cell : truth.cells) true_placement.emplace(cell.id, &cell.T_b_u);
  std::vector<AlignedCell> aligned;
  for (std::size_t p = 0; p < reconstruction.patches.size(); ++p) {
    const std::size_t first = aligned.size();
    std::vector<Eigen::Vector3d> estimated;
    std::vector<Eigen::Vector3d> expected;
    std::vector<Eigen::Matrix3d> turns;
    for (const CellPlacement& cell : reconstruction.patches[p].cells) {
      const auto found = true_placement.find(cell.cell);
      if (found == true_placement.end()) continue;
      const SE3& T_b_u = *found->second;
      aligned.push_back({p, cell.cell, T_b_u});
      estimated.push_back(cell.T_o_u.t);
      expected.push_back(T_b_u.t);
      turns.emplace_back(cell.T_o_u.R * T_b_u.R.transpose());
    }
    if (estimated.empty()) continue;
    SE3 T_o_b = alignPoints(estimated, expected);
    if (!fixesARotation(expected)) {
      T_o_b.R = chordalMean(turns);
      T_o_b.t.setZero();
      Eigen::Vector3d offset = Eigen::Vector3d::Zero();
      for (std::size_t k = 0; k < estimated.size(); ++k) offset += estimated[k] - T_o_b.R * expected[k];
      T_o_b.t = offset / static_cast<double>(estimated.size());
    }
    for (std::size_t k = first; k < aligned.size(); ++k) aligned[k].T_o_u = T_o_b * aligned[k].T_o_u;
  }
  return aligned;
}

std::vector<CellShift> shiftsOf(const Reconstruction& reconstruction, std::span<const Comparison> comparisons) {
  std::vector<CellShift> shifts;
  for (const Comparison& comparison : comparisons) {
    const auto patch = std::ranges::find(reconstruction.patches, comparison.patch, &PatchReconstruction::id);
    if (patch == reconstruction.patches.end()) continue;
    const auto index = static_cast<std::size_t>(patch - reconstruction.patches.begin());
    for (const CellDifference& difference : comparison.cells) {
      const CellPlacement* cell = patch->findCell(difference.cell);
      if (cell == nullptr) continue;
      const Eigen::Vector3d now = cell->T_o_u.t;
      shifts.push_back({index, difference.cell, now + comparison.T_ref_o.R.transpose() * difference.position_m, now});
    }
  }
  return shifts;
}

double enlargement(double largest, double room) {
  constexpr double kLargestFactor = 1000;
  double factor = 1;
  for (double candidate = 1; candidate <= kLargestFactor; candidate = roundStep(1.5 * candidate)) {
    if (candidate * largest <= room) factor = candidate;
  }
  return factor;
}

}  // namespace hexoderm
