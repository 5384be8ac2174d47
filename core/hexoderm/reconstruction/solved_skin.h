#pragma once

#include "hexoderm/reconstruction/patch/patch_solver.h"
#include "hexoderm/reconstruction/solve_progress.h"

#include <memory>
#include <span>
#include <stop_token>
#include <vector>

namespace hexoderm {

/// A skin with its patches solved, before it is described as a Reconstruction: what estimates of its sensors start from
/// too. Snapshot and options must outlive it.
class SolvedSkin {
 public:
  SolvedSkin(const SessionSnapshot& snapshot, const SolverOptions& options) : skin_(snapshot, options, findings_) {}
  // The patches refer to the skin.
  SolvedSkin(const SolvedSkin&) = delete;
  SolvedSkin& operator=(const SolvedSkin&) = delete;

  [[nodiscard]] const SkinLinks& skin() const { return skin_; }
  [[nodiscard]] std::span<const double> weights() const { return weights_; }  ///< per link, of the paths
  [[nodiscard]] std::span<const PatchSolver> patches() const { return patches_; }
  [[nodiscard]] const std::vector<Finding>& findings() const { return findings_; }

 private:
  friend std::unique_ptr<const SolvedSkin> solveSkin(const SessionSnapshot& snapshot, const SolverOptions& options,
                                                     const Reconstruction* earlier, const std::stop_token& stop,
                                                     SolveProgress* progress);

  std::vector<Finding> findings_;
  SkinLinks skin_;
  std::vector<double> weights_;
  std::vector<PatchSolver> patches_;
};

/// The steps of reconstruct() up to the description, with its arguments; null if it was stopped.
std::unique_ptr<const SolvedSkin> solveSkin(const SessionSnapshot& snapshot, const SolverOptions& options,
                                            const Reconstruction* earlier = nullptr, const std::stop_token& stop = {},
                                            SolveProgress* progress = nullptr);

}  // namespace hexoderm
