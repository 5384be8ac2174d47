#pragma once

// Sheets on doubly curved surfaces can't keep every link's law; here they come as near as they can.

#include "hexoderm/base/surface.h"
#include "hexoderm/sim/patch_plan.h"
#include "hexoderm/sim/simulated_skin.h"

#include <Eigen/Core>
#include <span>
#include <vector>

namespace hexoderm {

/// Violation of a link's law by two cells on the surface, metres, with derivatives by each cell's shift along its own x
/// and y axis (metres) and its turn about z (times `lever_m`, so metres too). Bend: the vector between the ends of both
/// extended port vectors, eq. (2), and the yaw times the rms half width of the side. Surface: at either end, the
/// bearing of the other cell less the extended pitch along the port.
struct LinkMisfit {
  Eigen::Vector4d value;
  Eigen::Matrix<double, 4, 3> by_source;
  Eigen::Matrix<double, 4, 3> by_target;
};

class SheetRelaxation {
 public:
  SheetRelaxation(const PatchPlan& plan, const Surface& surface, LinkLaw law);

  [[nodiscard]] LinkMisfit misfit(const PlannedLink& link, const SE3& source, const SE3& target) const;

  /// The cell moved along the surface by step (x, y, yaw times lever).
  [[nodiscard]] SE3 moved(const SE3& T_b_u, const Eigen::Vector3d& step) const;

  /// Fits one cell to those of its links whose other ends are laid.
  void fitCell(std::size_t cell, std::span<const PlannedLink> links, std::vector<SE3>& cells) const;

  /// Fits all cells to all links: damped Gauss-Newton, each step by conjugate gradients, whose shortest solution keeps
  /// the patch from wandering on a sphere. On a surface of changing curvature (torus, cone) the patch may slide to a
  /// place that fits better.
  void relax(std::vector<SE3>& cells) const;

 private:
  [[nodiscard]] LinkMisfit bendMisfit(const PlannedLink& link, const SE3& source, const SE3& target) const;
  [[nodiscard]] LinkMisfit surfaceMisfit(const PlannedLink& link, const SE3& source, const SE3& target) const;
  [[nodiscard]] double cost(const std::vector<SE3>& cells) const;

  const PatchPlan& plan_;
  const Surface& surface_;
  LinkLaw law_;
  double lever_m_;
};

}  // namespace hexoderm
