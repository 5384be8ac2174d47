#pragma once

#include "hexoderm/solve/result/reconstruction.h"

#include "hexoderm/solve/global/global_solver.h"
#include "hexoderm/solve/global/motion_compensated_readings.h"
#include "hexoderm/solve/global/rigidity.h"
#include "hexoderm/solve/global/sensor_evidence.h"
#include "hexoderm/solve/tree/gravity_table.h"

#include <memory>
#include <optional>
#include <span>
#include <vector>

namespace hexoderm {

/// The joint estimate of one patch (the global solver in core/hexoderm/solve/README.md), from the tree's
/// placements, in the terms of the skin's graph.
class GlobalRefinement {
 public:
  /// `cells`: of the patch, ascending; `placements`: of these, in the origin's frame.
  GlobalRefinement(const CellModel& model, const SkinGraph& graph, const GravityTable& table,
                   const SolverOptions& options, const std::vector<std::size_t>& cells, std::size_t origin,
                   std::vector<SE3> placements);

  /// Solves from the latest state, unless `stop` is requested: then what is there is no solution.
  void solve(const std::stop_token& stop);

  /// From now on the cell is placed by its links. Needs another solve().
  void leaveOut(std::size_t cell);

  /// Misfit of a cell's readings with the gravity that all others agree on, for the best attitude of the cell;
  /// meaningless with fewer than two readings.
  [[nodiscard]] Misfit misfitOf(std::size_t cell) const;
  /// The turn of a cell between two of its readings that explains them best; needs two readings.
  [[nodiscard]] TurnBetweenPoses turnOf(std::size_t cell) const;
  /// Per pose of poses(): rms over the cells of what it leaves unexplained, in standard deviations of its readings.
  [[nodiscard]] std::vector<double> poseMisfits() const;

  /// The link (of the graph) that misses its loops by the most, and by how much.
  struct OpenLink {
    std::size_t link = 0;
    double opening_m = 0;
  };
  [[nodiscard]] std::optional<OpenLink> widestOpen() const;

  [[nodiscard]] const SE3& placementOf(std::size_t cell) const;
  [[nodiscard]] const Matrix6d& covarianceOf(std::size_t cell) const;  ///< see CellPlacement::cov_t_r
  /// See CellPlacement::shape_cov_t_r; per cell, in the order of the patch's cells. All covariances are computed, and
  /// the factor is given back, when one of cells or links is first asked for; that is not for several threads at a
  /// time.
  [[nodiscard]] const std::vector<Matrix6d>& shapeCovariances() const;
  /// A reading (cell frame) freed from the offset, gains and cross-axis sensitivity estimated for its sensor and its
  /// lot.
  [[nodiscard]] Eigen::Vector3d correctedReading(std::size_t cell, const Eigen::Vector3d& mean_g) const;
  /// The covariances of all cells (CellPlacement::cov_t_r, in the order of the patch's cells) that the patch would have
  /// with more readings, each as the estimate foretells it and as noisy as the cell's others: of another pose with
  /// `up_o` (unit, patch frame) up, in every cell that has readings; or of the poses that it has, in the cells that
  /// lack them there. Costs about as much as a step of the solver with its covariance.
  [[nodiscard]] std::vector<Matrix6d> covariancesWithPose(const Eigen::Vector3d& up_o) const;
  [[nodiscard]] std::vector<Matrix6d> covariancesWithAllReadings() const;
  /// What is asked for of two cells at a time takes memory for the problem, and for its factor only from the first
  /// question on.
  [[nodiscard]] std::shared_ptr<const PlacementCovariance> placementCovariance(const SkinGraph& graph) const;
  [[nodiscard]] std::shared_ptr<const GravityCovariance> gravityCovariance() const;  ///< poses as in poses()
  /// Errors that the patch's accelerometers share; none unless the cell model says that there may be some.
  [[nodiscard]] const SensorLot& lot() const;
  /// The errors of a cell's own accelerometer beside them.
  [[nodiscard]] const AccelerometerFit& sensorOf(std::size_t cell) const;
  /// The readings of a cell that are used, without the lot's errors, and per reading the specific force in the
  /// accelerometer's axes.
  [[nodiscard]] std::span<const CellReading> readingsOf(std::size_t cell) const;
  [[nodiscard]] std::span<const Eigen::Vector3d> forcesAt(std::size_t cell) const;
  /// What the readings say about the sensors of the cells that have any, in the order of the patch's cells.
  [[nodiscard]] SensorEvidence sensorEvidence() const;
  [[nodiscard]] const GlobalSolution& solution() const { return solution_; }
  [[nodiscard]] const GlobalProblem& problem() const { return *problem_; }
  /// Poses of the table that the patch has readings in; the solution's poses, in its order.
  [[nodiscard]] const std::vector<std::size_t>& poses() const { return poses_; }
  /// Covariance of the error d of a link's rotation, R_true = exp(d) R_c_n in the source's frame.
  [[nodiscard]] Eigen::Matrix3d linkCovariance(std::size_t link) const;

 private:
  /// Place of a cell of the graph in the problem.
  [[nodiscard]] std::size_t localOf(std::size_t cell) const;
  [[nodiscard]] CellReading foretold(std::size_t local, std::size_t pose, const GlobalState& state) const;
  void finishCovariances() const;
  [[nodiscard]] std::vector<CellReading> readingsByOwnErrors(std::size_t local) const;
  [[nodiscard]] double grantedVariance_g2(std::size_t local, std::size_t reading) const;
  void fitSensors();
  void solveWithMotionCompensatedReadings(const std::stop_token& stop);
  void solveWithSpreads(const GlobalSolverOptions& options);
  [[nodiscard]] double seenLinkSpread_m() const;
  [[nodiscard]] double seenAccelerations_rad_s2() const;
  [[nodiscard]] double seenNoise();
  void takeNoise(double share);

  std::vector<std::size_t> cells_;  ///< indices in the graph, ascending; in the problem's order
  std::vector<std::size_t> links_;  ///< the same for links
  std::vector<std::size_t> poses_;
  std::shared_ptr<GlobalProblem> problem_;
  std::unique_ptr<GlobalSolver> solver_;
  GlobalSolution solution_;
  mutable std::vector<Matrix6d> shape_;  ///< of the solution; empty: not asked for yet
  std::vector<SensorState> sensors_;
  std::optional<MotionCompensatedReadings> motion_compensated_readings_;  ///< of many poses
  /// Of a reading, per axis, beside the one that the estimate takes.
  struct Noise {
    double granted_g2 = 0;  ///< with a hand's tremor
    double own_g2 = 0;      ///< of the samples alone
  };
  std::vector<std::vector<Noise>> noise_;  ///< of the readings of every cell
  double noise_share_ = 1;                 ///< of the variances that are granted, see seenNoise()
};

}  // namespace hexoderm
