#include "hexoderm/solve/global/linearize_lanes.h"

#include "hexoderm/base/units.h"

#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <stdexcept>

namespace hexoderm {
namespace {

/// What is the same for all cells and links, and the numbers that it points to.
struct LaneSetting {
  LinearizeSetting numbers{};
  std::vector<double> force_o;
  std::vector<double> acceleration_o;

  LaneSetting(const GlobalProblem& problem, const GlobalState& state) {
    const CellModel& model = *problem.model;
    const AccelerometerPrior prior = priorOfChips(problem, state);
    const Eigen::Matrix3d R_a_u = model.accelerometer.T_u_a.R.transpose();
    for (int i = 0; i < 3; ++i) {
      for (int j = 0; j < 3; ++j) numbers.R_a_u[3 * i + j] = R_a_u(i, j);
      for (int j = 0; j < 4; ++j) numbers.prior_precision[i][j] = prior.precision(i)[j];
    }
    numbers.threshold_squared = problem.loss.threshold * problem.loss.threshold;
    numbers.poses = problem.poses;
    numbers.accelerations = problem.accelerations;
    numbers.lot = problem.estimatesLot();
    numbers.lot_scale = state.lot.scale;
    for (std::size_t pose = 0; pose < problem.poses; ++pose) {
      for (int i = 0; i < 3; ++i) {
        force_o.push_back(state.force_o[pose][i]);
        if (problem.accelerations) acceleration_o.push_back(state.acceleration_o[pose][i] / kStandardGravity);
      }
    }
    numbers.force_o = force_o.data();
    numbers.acceleration_o = acceleration_o.data();
    numbers.link_precision = 1 / problem.link_sigma_m;
    numbers.twist_precision = 1 / model.twist_sigma_rad;
    numbers.bend_precision = 1 / model.bend_sigma_rad;
    numbers.yaw_precision = 1 / model.yaw_sigma_rad;
    numbers.bends = problem.gap.sigma.has_value() || problem.gap.mean != 0;
    numbers.gap_share = state.gap_share;
  }
  LaneSetting(const LaneSetting&) = delete;
  LaneSetting& operator=(const LaneSetting&) = delete;
};

/// Numbers of several cells or links, element by element.
class LaneArray {
 public:
  LaneArray(std::size_t elements, std::size_t lanes) : lanes_(lanes), numbers_(elements * lanes) {}
  double& operator()(std::size_t element, std::size_t lane) { return numbers_[element * lanes_ + lane]; }
  double* data() { return numbers_.data(); }

  void put(std::size_t lane, const Eigen::Vector3d& v) {
    for (std::size_t i = 0; i < 3; ++i) (*this)(i, lane) = v[static_cast<Eigen::Index>(i)];
  }
  void put(std::size_t lane, const Eigen::Matrix3d& M) {
    for (std::size_t k = 0; k < 9; ++k) {
      (*this)(k, lane) = M(static_cast<Eigen::Index>(k / 3), static_cast<Eigen::Index>(k % 3));
    }
  }
  template <int kRows, int kColumns>
  [[nodiscard]] Eigen::Matrix<double, kRows, kColumns> get(std::size_t lane, std::size_t from = 0) const {
    Eigen::Matrix<double, kRows, kColumns> M;
    for (int i = 0; i < kRows; ++i) {
      for (int j = 0; j < kColumns; ++j) M(i, j) = numbers_[(from + kColumns * i + j) * lanes_ + lane];
    }
    return M;
  }
  /// The sum of an element over its lanes.
  [[nodiscard]] double sumOf(std::size_t element) const {
    const auto first = numbers_.begin() + static_cast<std::ptrdiff_t>(element * lanes_);
    return std::accumulate(first, first + static_cast<std::ptrdiff_t>(lanes_), 0.0);
  }

 private:
  std::size_t lanes_;
  std::vector<double> numbers_;
};

/// As much as all lanes of a number may take, and aligned as that may have to be.
struct alignas(4 * sizeof(double)) LaneBlock {
  double numbers[4];
};

class CellsInLanes {
 public:
  CellsInLanes(const LinearizeKernels& kernels, const GlobalProblem& problem, const GlobalState& state,
               NormalEquations& equations)
      : kernels_(kernels),
        problem_(problem),
        state_(state),
        equations_(equations),
        layout_(problem),
        columns_(columnsOfPose(problem.accelerations)),
        setting_(problem, state),
        R_(9, kernels.lanes),
        lever_(3, kernels.lanes),
        y_(3 * problem.poses, kernels.lanes),
        precision_(problem.poses, kernels.lanes),
        cost_(1, kernels.lanes),
        matrix_(36, kernels.lanes),
        gradient_(6, kernels.lanes),
        border_(6 * columns_ * problem.poses, kernels.lanes),
        border_sums_(columns_ * columns_ * problem.poses * (problem.poses + 1) / 2, kernels.lanes),
        gradient_sums_(columns_ * problem.poses, kernels.lanes),
        lot_border_(6 * kLotColumns, kernels.lanes),
        lot_sums_(kLotColumns * (columns_ * problem.poses + kLotColumns + 1), kernels.lanes),
        workspace_(CellLanes::kWorkspaceOfPose * std::max<std::size_t>(1, problem.poses)),
        prior_(priorOfChips(problem, state)),
        of_lane_(kernels.lanes) {
    for (std::size_t pose = 0; pose < problem.poses; ++pose) {
      for (std::size_t column = 0; column < columns_; ++column) places_.push_back(placeOf(pose, column));
    }
  }

  void run() {
    for (std::size_t begin = 0; begin < problem_.cellCount(); begin += kernels_.lanes) {
      bool any = false;
      for (std::size_t lane = 0; lane < kernels_.lanes; ++lane) any = fill(lane, begin + lane) || any;
      if (!any) continue;
      compute();
      for (std::size_t lane = 0; lane < kernels_.lanes; ++lane) add(lane);
    }
    addSums();
  }

 private:
  /// A lane without a cell is one of a cell that nothing was read from.
  void empty(std::size_t lane) {
    of_lane_[lane] = problem_.cellCount();
    R_.put(lane, Eigen::Matrix3d(Eigen::Matrix3d::Identity()));
    lever_.put(lane, Eigen::Vector3d(Eigen::Vector3d::Zero()));
    for (std::size_t k = 0; k < problem_.poses; ++k) {
      precision_(k, lane) = 0;
      for (std::size_t i = 0; i < 3; ++i) y_(3 * k + i, lane) = 0;
    }
  }

  bool fill(std::size_t lane, std::size_t cell) {
    empty(lane);
    if (cell >= problem_.cellCount() || problem_.readings[cell].empty()) return false;
    of_lane_[lane] = cell;
    R_.put(lane, state_.cells[cell].R);
    lever_.put(lane, Eigen::Vector3d(state_.cells[cell].t - state_.middle_o));
    for (const CellReading& reading : problem_.readings[cell]) {
      if (precision_(reading.pose, lane) != 0) throw std::logic_error("a cell has two readings in one pose");
      precision_(reading.pose, lane) = 1 / reading.variance_g2;
      for (std::size_t i = 0; i < 3; ++i) {
        const auto axis = static_cast<Eigen::Index>(i);
        y_(3 * reading.pose + i, lane) = reading.y_g[axis] - state_.lot.offset_g[axis];
      }
    }
    return true;
  }

  void compute() {
    const CellLanes lanes{R_.data(),
                          lever_.data(),
                          y_.data(),
                          precision_.data(),
                          cost_.data(),
                          matrix_.data(),
                          gradient_.data(),
                          border_.data(),
                          border_sums_.data(),
                          gradient_sums_.data(),
                          lot_border_.data(),
                          lot_sums_.data(),
                          workspace_.data()->numbers};
    const unsigned beyond = kernels_.cells(setting_.numbers, lanes);
    if (beyond == 0) return;
    // What a robust loss leaves of the precision of such a cell's readings is their precision where they fit best.
    std::vector<double> robust_cost(kernels_.lanes);
    for (std::size_t lane = 0; lane < kernels_.lanes; ++lane) {
      if ((beyond >> lane & 1U) == 0 || of_lane_[lane] == problem_.cellCount()) continue;
      fitCell(problem_, prior_, state_, of_lane_[lane], sensor_);
      robust_cost[lane] = sensor_.fit.cost;
      for (std::size_t k = 0; k < sensor_.fit.precision.size(); ++k) {
        precision_(problem_.readings[of_lane_[lane]][k].pose, lane) = sensor_.fit.precision[k];
      }
    }
    LinearizeSetting of_squares = setting_.numbers;
    of_squares.threshold_squared = std::numeric_limits<double>::infinity();
    const bool is_finite = kernels_.cells(of_squares, lanes) == 0;
    for (std::size_t lane = 0; lane < kernels_.lanes; ++lane) {
      if ((beyond >> lane & 1U) != 0) cost_(0, lane) = robust_cost[lane];
      if (!is_finite) cost_(0, lane) = std::numeric_limits<double>::quiet_NaN();
    }
  }

  void add(std::size_t lane) {
    const std::size_t cell = of_lane_[lane];
    if (cell == problem_.cellCount()) return;
    equations_.cost += cost_(0, lane);
    if (problem_.with_mounting && std::isfinite(cost_(0, lane))) eliminateMounting(lane);
    if (cell == problem_.origin) return;
    if (!std::isfinite(cost_(0, lane))) {  // so are its blocks, which no factorization takes
      equations_.cells[cell].setConstant(cost_(0, lane));
      return;
    }
    const auto row = static_cast<Eigen::Index>(6 * cell);
    equations_.cells[cell] += matrix_.get<6, 6>(lane);
    equations_.gradient_cells.segment<6>(row) += gradient_.get<6, 1>(lane);
    const std::size_t width = columns_ * problem_.poses;
    for (std::size_t j = 0; j < 6; ++j) {
      double* const to = &equations_.border_cells(row + static_cast<Eigen::Index>(j), 0);
      for (std::size_t column = 0; column < width; ++column) {
        to[places_[column]] += border_(j * width + column, lane);
      }
    }
    if (!problem_.estimatesLot()) return;
    equations_.border_cells.block<6, kLotUnknowns>(row, layout_.lot()) += lot_border_.get<6, kLotUnknowns>(lane);
  }

  /// A turn of the chip in its cell does to the readings what the same turn of the cell does, and nothing to its links:
  /// what it takes from the information of a cell's readings is as with any unknown that is eliminated.
  void eliminateMounting(std::size_t lane) {
    const std::size_t cell = of_lane_[lane];
    const auto row = static_cast<Eigen::Index>(6 * cell);
    const std::size_t width = columns_ * problem_.poses;
    Eigen::Matrix3Xd of_border = Eigen::Matrix3Xd::Zero(3, layout_.size());
    for (std::size_t j = 0; j < 3; ++j) {
      for (std::size_t column = 0; column < width; ++column) {
        of_border(static_cast<Eigen::Index>(j), places_[column]) = border_((j + 3) * width + column, lane);
      }
    }
    if (problem_.estimatesLot()) {
      of_border.middleCols<kLotUnknowns>(layout_.lot()) = lot_border_.get<6, kLotUnknowns>(lane).bottomRows<3>();
    }
    const Eigen::Matrix<double, 3, 6> of_cell = matrix_.get<6, 6>(lane).bottomRows<3>();
    Eigen::Matrix3d information = of_cell.rightCols<3>();
    information.diagonal().array() += std::pow(problem_.model->mounting_sigma_rad, -2);
    const Eigen::LLT<Eigen::Matrix3d> factor(information);
    const Eigen::Matrix3Xd root_of_border = factor.matrixL().solve(of_border);
    equations_.border.triangularView<Eigen::Lower>() -= root_of_border.transpose() * root_of_border;
    if (cell == problem_.origin) return;
    const Eigen::Matrix<double, 3, 6> root_of_cell = factor.matrixL().solve(of_cell);
    equations_.cells[cell] -= root_of_cell.transpose() * root_of_cell;
    equations_.border_cells.middleRows<6>(row) -= root_of_cell.transpose() * root_of_border;
  }

  /// In the border, of a pose's column.
  [[nodiscard]] Eigen::Index placeOf(std::size_t pose, std::size_t column) const {
    const auto at = static_cast<Eigen::Index>(column);
    return column < 3 ? layout_.force(pose) + at : layout_.acceleration(pose) + at - 3;
  }

  void addSums() {
    std::size_t element = 0;
    for (std::size_t pose = 0; pose < problem_.poses; ++pose) {
      for (std::size_t i = 0; i < columns_; ++i) {
        equations_.gradient_border[placeOf(pose, i)] += gradient_sums_.sumOf(pose * columns_ + i);
      }
      for (std::size_t earlier = 0; earlier <= pose; ++earlier) {
        for (std::size_t i = 0; i < columns_; ++i) {
          for (std::size_t j = 0; j < columns_; ++j, ++element) {
            if (earlier == pose && j > i) continue;
            const auto [low, high] = std::minmax({placeOf(pose, i), placeOf(earlier, j)});
            equations_.border(high, low) += border_sums_.sumOf(element);
          }
        }
      }
    }
    if (problem_.estimatesLot()) addSumsOfLot();
  }

  void addSumsOfLot() {
    std::size_t element = 0;
    for (std::size_t pose = 0; pose < problem_.poses; ++pose) {
      for (Eigen::Index row = 0; row < kLotUnknowns; ++row) {
        for (std::size_t column = 0; column < columns_; ++column, ++element) {
          equations_.border(layout_.lot() + row, placeOf(pose, column)) += lot_sums_.sumOf(element);
        }
      }
    }
    for (Eigen::Index row = 0; row < kLotUnknowns; ++row) {
      for (Eigen::Index column = 0; column < kLotUnknowns; ++column, ++element) {
        if (column <= row) {
          equations_.border(layout_.lot() + row, layout_.lot() + column) += lot_sums_.sumOf(element);
        }
      }
    }
    for (Eigen::Index row = 0; row < kLotUnknowns; ++row, ++element) {
      equations_.gradient_border[layout_.lot() + row] += lot_sums_.sumOf(element);
    }
  }

  const LinearizeKernels& kernels_;
  const GlobalProblem& problem_;
  const GlobalState& state_;
  NormalEquations& equations_;
  BorderLayout layout_;
  std::size_t columns_;
  LaneSetting setting_;
  LaneArray R_, lever_, y_, precision_;
  LaneArray cost_, matrix_, gradient_, border_, border_sums_, gradient_sums_, lot_border_, lot_sums_;
  std::vector<LaneBlock> workspace_;
  AccelerometerPrior prior_;
  std::vector<Eigen::Index> places_;  // in the border, of each column of each pose
  std::vector<std::size_t> of_lane_;  // its cell; the number of cells if there is none
  SensorState sensor_;
};

class LinksInLanes {
 public:
  LinksInLanes(const LinearizeKernels& kernels, const GlobalProblem& problem, const GlobalState& state,
               NormalEquations& equations)
      : kernels_(kernels),
        problem_(problem),
        state_(state),
        share_(BorderLayout(problem).gapShare()),
        equations_(equations),
        setting_(problem, state),
        R_c_(9, kernels.lanes),
        R_n_(9, kernels.lanes),
        t_c_n_(3, kernels.lanes),
        p_c_(3, kernels.lanes),
        p_n_(3, kernels.lanes),
        R_nom_(9, kernels.lanes),
        cost_(1, kernels.lanes),
        matrix_c_(36, kernels.lanes),
        matrix_n_(36, kernels.lanes),
        matrix_c_n_(36, kernels.lanes),
        gradient_(12, kernels.lanes),
        of_share_(14, kernels.lanes) {}

  void run() {
    const LinkLanes lanes{R_c_.data(),      R_n_.data(),        t_c_n_.data(),    p_c_.data(),
                          p_n_.data(),      R_nom_.data(),      cost_.data(),     matrix_c_.data(),
                          matrix_n_.data(), matrix_c_n_.data(), gradient_.data(), of_share_.data()};
    const std::size_t count = problem_.links.size();
    for (std::size_t begin = 0; begin < count; begin += kernels_.lanes) {
      for (std::size_t lane = 0; lane < kernels_.lanes; ++lane) fill(lane, std::min(begin + lane, count - 1));
      kernels_.links(setting_.numbers, lanes);
      for (std::size_t lane = 0; lane < kernels_.lanes && begin + lane < count; ++lane) add(lane, begin + lane);
    }
  }

 private:
  void fill(std::size_t lane, std::size_t index) {
    const GlobalLink& link = problem_.links[index];
    const SE3& T_c = state_.cells[link.c];
    const SE3& T_n = state_.cells[link.n];
    R_c_.put(lane, T_c.R);
    R_n_.put(lane, T_n.R);
    t_c_n_.put(lane, Eigen::Vector3d(T_n.t - T_c.t));
    p_c_.put(lane, link.p_c);
    p_n_.put(lane, link.p_n);
    R_nom_.put(lane, link.R_nom);
  }

  void add(std::size_t lane, std::size_t index) {
    const GlobalLink& link = problem_.links[index];
    equations_.cost += cost_(0, lane);
    const bool moves_c = link.c != problem_.origin;
    const bool moves_n = link.n != problem_.origin;
    const auto c = static_cast<Eigen::Index>(6 * link.c);
    const auto n = static_cast<Eigen::Index>(6 * link.n);
    if (moves_c) {
      equations_.cells[link.c] += matrix_c_.get<6, 6>(lane);
      equations_.gradient_cells.segment<6>(c) += gradient_.get<6, 1>(lane);
    }
    if (moves_n) {
      equations_.cells[link.n] += matrix_n_.get<6, 6>(lane);
      equations_.gradient_cells.segment<6>(n) += gradient_.get<6, 1>(lane, 6);
    }
    if (moves_c && moves_n) equations_.links[index] = matrix_c_n_.get<6, 6>(lane);
    if (!problem_.gap.sigma) return;
    equations_.border(share_, share_) += of_share_(12, lane);
    equations_.gradient_border[share_] += of_share_(13, lane);
    if (moves_c) equations_.border_cells.block<6, 1>(c, share_) += of_share_.get<6, 1>(lane);
    if (moves_n) equations_.border_cells.block<6, 1>(n, share_) += of_share_.get<6, 1>(lane, 6);
  }

  const LinearizeKernels& kernels_;
  const GlobalProblem& problem_;
  const GlobalState& state_;
  Eigen::Index share_;
  NormalEquations& equations_;
  LaneSetting setting_;
  LaneArray R_c_, R_n_, t_c_n_, p_c_, p_n_, R_nom_;
  LaneArray cost_, matrix_c_, matrix_n_, matrix_c_n_, gradient_, of_share_;
};

}  // namespace

void linearizeCellsInLanes(const LinearizeKernels& kernels, const GlobalProblem& problem, const GlobalState& state,
                           NormalEquations& equations) {
  CellsInLanes(kernels, problem, state, equations).run();
}

void linearizeLinksInLanes(const LinearizeKernels& kernels, const GlobalProblem& problem, const GlobalState& state,
                           NormalEquations& equations) {
  LinksInLanes(kernels, problem, state, equations).run();
}

}  // namespace hexoderm
