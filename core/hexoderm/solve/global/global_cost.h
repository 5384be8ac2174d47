#pragma once

#include "hexoderm/base/se3.h"
#include "hexoderm/skin/cell_model.h"

#include "hexoderm/base/large_memory.h"
#include "hexoderm/solve/global/accelerometer_fit.h"
#include "hexoderm/solve/global/linearize_kernels.h"
#include "hexoderm/solve/tree/gap_share.h"

#include <memory>
#include <vector>

namespace hexoderm {

/// A link of one patch, ends as indices into its cells.
struct GlobalLink {
  std::size_t c = 0;
  std::size_t n = 0;
  Eigen::Vector3d p_c;  ///< extended port vectors, in their own cells' frames, metres
  Eigen::Vector3d p_n;
  Eigen::Matrix3d R_nom;  ///< nominal alignment, n to c
};

struct EliminationPlan;

/// One patch as the joint estimate sees it. The origin cell's frame is the patch frame and does not move.
struct GlobalProblem {
  const CellModel* model = nullptr;
  std::size_t origin = 0;
  std::size_t poses = 0;                           ///< those with a usable reading in this patch
  std::vector<std::vector<CellReading>> readings;  ///< per cell; empty: placed by its links
  std::vector<GlobalLink> links;
  double link_sigma_m = 0;  ///< how far link points are apart, per axis
  GapShare gap;
  double force_sigma_g = 0.005;   ///< how far the force at the patch's middle may be from 1 g
  bool accelerations = false;     ///< every pose has an angular acceleration of its own
  double acceleration_sigma = 3;  ///< of its prior about zero, per axis, rad/s^2
  HuberLoss loss;
  /// The matrix of the equations counts that chips sit askew in their cells (CellModel::mounting_sigma_rad), each by an
  /// unknown turn of its own that is eliminated: it is that of what readings say about cells. The cost, its gradient
  /// and its optimum are those of chips that sit straight.
  bool with_mounting = false;
  /// For these cells and links, where it is known; one that is missing is made anew for each solution.
  std::shared_ptr<const EliminationPlan> elimination;

  [[nodiscard]] std::size_t cellCount() const { return readings.size(); }
  [[nodiscard]] bool estimatesLot() const;  ///< the model's accelerometers share errors
};

/// The unknowns: placements T_o_u, per pose the specific force at the patch's middle and the angular acceleration, and
/// the gap share, and the errors that the accelerometers share. A hand's translation adds to gravity, so the force's
/// length is not exactly 1 g.
struct GlobalState {
  std::vector<SE3> cells;
  std::vector<Eigen::Vector3d> force_o;                ///< specific force at the patch's middle, g; about 1 long
  std::vector<Eigen::Vector3d> acceleration_o;         ///< rad/s^2; zero where not estimated
  Eigen::Vector3d middle_o = Eigen::Vector3d::Zero();  ///< point at which accelerations have no lever arm; a constant
  double gap_share = 0.5;
  SensorLot lot;
};

/// Second-order model of the cost about a state (Gauss-Newton), sparse in the cells: every cell has a block of six
/// (position in the patch frame, then rotation as R exp(d)); every pose, the lot and the gap share stand in a dense
/// border.
struct NormalEquations {
  LargeVector<Matrix6d> cells;  ///< diagonal blocks; the origin's is the identity
  LargeVector<Matrix6d> links;  ///< block (c, n) per link
  /// 6 N x B; row by row, for what belongs to a cell is made and taken at once.
  Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor> border_cells;
  Eigen::MatrixXd border;          ///< B x B
  Eigen::VectorXd gradient_cells;  ///< 6 N
  Eigen::VectorXd gradient_border;
  double cost = 0;
};

/// Places of the unknowns in the border.
struct BorderLayout {
  explicit BorderLayout(const GlobalProblem& problem);
  [[nodiscard]] Eigen::Index force(std::size_t pose) const { return static_cast<Eigen::Index>(3 * pose); }
  [[nodiscard]] Eigen::Index acceleration(std::size_t pose) const {
    return static_cast<Eigen::Index>(3 * poses_ + 3 * pose);
  }
  /// Where the lot is estimated: its offset, three numbers, and its scale.
  [[nodiscard]] Eigen::Index lot() const { return lot_; }
  [[nodiscard]] Eigen::Index gapShare() const { return size_ - 1; }
  [[nodiscard]] Eigen::Index size() const { return size_; }

 private:
  std::size_t poses_;
  Eigen::Index lot_;
  Eigen::Index size_;
};
/// Unknowns of a lot.
inline constexpr Eigen::Index kLotUnknowns = 4;

/// Negative logarithm of the posterior, up to a constant:
///   1/2 sum over readings of rho(|y - (I + D)(R^T f) - b|^2 / V) + accelerometer priors,
///       f = f_p + a_p x (t - middle) / 9.80665, b and D eliminated (accelerometer_fit.h), y without the lot's errors;
///   1/2 sum over links of rho(|t_n + R_n p_n - t_c - R_c p_c - s k|^2 / link_sigma^2),
///       k = (2/3) e a^2 m, the arc's share: e is the length of the extended port vectors, a half the angle between
///       u_c and -u_n, m = unit(u_c - u_n), with u the outward port directions in one frame;
///   1/2 sum over links of rho of twist, bend and yaw in their priors' sigmas;
///   1/2 of the squared deviations from their priors: the gap share, the accelerations, the forces' lengths from 1 g,
///       the lot's offset and its scale's from 1.
double jointCost(const GlobalProblem& problem, const GlobalState& state);

/// The specific force at a cell in a pose, patch frame, g.
Eigen::Vector3d specificForce(const GlobalProblem& problem, const GlobalState& state, std::size_t cell,
                              std::size_t pose);

/// Squared distances of all links' end points in units of link_sigma, losses applied.
double closureCost(const GlobalProblem& problem, const GlobalState& state);

/// Distance between the end points of a link, less the arc's share; metres.
double linkOpening_m(const GlobalProblem& problem, const GlobalState& state, std::size_t link);

/// jointCost() with its gradient (exact) and its Gauss-Newton matrix (of the eliminated problem: Kaufman's; with the
/// chips' turns eliminated, where the problem is with_mounting).
void linearize(const GlobalProblem& problem, const GlobalState& state, NormalEquations& equations,
               const LinearizeKernels& kernels = linearizeKernels());

/// The matrix of the equations: all cells' unknowns, then the border's.
Eigen::MatrixXd denseMatrix(const GlobalProblem& problem, const NormalEquations& equations);

/// state (+) step: R exp(dr), the rest added.
GlobalState moved(const GlobalProblem& problem, const GlobalState& state, const Eigen::VectorXd& cells,
                  const Eigen::VectorXd& border);

/// The accelerometers of the patch at a state: readings without the lot's errors, forces in the accelerometers' axes,
/// and the most probable errors of their own.
struct SensorState {
  std::vector<CellReading> readings;
  std::vector<Eigen::Vector3d> v_g;
  AccelerometerFit fit;
};
void fitCell(const GlobalProblem& problem, const AccelerometerPrior& prior, const GlobalState& state, std::size_t cell,
             SensorState& sensor);
/// The prior that it takes.
AccelerometerPrior priorOfChips(const GlobalProblem& problem, const GlobalState& state);

}  // namespace hexoderm
