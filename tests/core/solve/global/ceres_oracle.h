#pragma once

// Ceres as oracle: the joint estimate's cost written down a second time, with the errors of every accelerometer as
// unknowns of their own instead of eliminated ones, automatic derivatives and another solver.

#include "hexoderm/solve/global/global_cost.h"

#include <ceres/ceres.h>
#include <ceres/rotation.h>

#include <Eigen/Geometry>
#include <array>
#include <cmath>
#include <vector>

namespace hexoderm::oracle {

template <typename T>
using Vector3 = Eigen::Matrix<T, 3, 1>;
template <typename T>
using ConstVector = Eigen::Map<const Vector3<T>>;
template <typename T>
using ConstRotation = Eigen::Map<const Eigen::Quaternion<T>>;

inline constexpr double kStandardGravityHere = 9.80665;  // m/s^2 in 1 g

struct ReadingCost {
  CellReading reading;
  Eigen::Matrix3d R_a_u;
  Eigen::Vector3d middle_o;

  template <typename T>
  bool operator()(const T* t, const T* q, const T* offset, const T* errors, const T* g, const T* acceleration,
                  T* residual) const {
    const Vector3<T> lever = ConstVector<T>(t) - middle_o.cast<T>();
    const Vector3<T> f = ConstVector<T>(g) + ConstVector<T>(acceleration).cross(lever) / T(kStandardGravityHere);
    const Vector3<T> v = R_a_u.cast<T>() * (ConstRotation<T>(q).conjugate() * f);
    const Eigen::Map<const Eigen::Matrix<T, 3, 3, Eigen::RowMajor>> D(errors);
    const Vector3<T> left = reading.y_g.cast<T>() - v - D * v - ConstVector<T>(offset);
    Eigen::Map<Vector3<T>> whitened(residual);
    whitened = left / T(std::sqrt(reading.variance_g2));
    return true;
  }
};

template <int Size>
struct PriorCost {
  std::array<double, Size> sigma;
  double mean = 0;

  template <typename T>
  bool operator()(const T* value, T* residual) const {
    for (std::size_t k = 0; k < Size; ++k) residual[k] = (value[k] - mean) / sigma[k];
    return true;
  }
};

struct ForceLengthCost {
  double sigma_g;

  template <typename T>
  bool operator()(const T* force, T* residual) const {
    residual[0] = (ConstVector<T>(force).norm() - T(1)) / T(sigma_g);
    return true;
  }
};

struct ClosureCost {
  GlobalLink link;
  double sigma_m;

  template <typename T>
  bool operator()(const T* t_c, const T* q_c, const T* t_n, const T* q_n, const T* share, T* residual) const {
    const ConstRotation<T> R_c(q_c);
    const ConstRotation<T> R_n(q_n);
    const Vector3<T> U_c = R_c * Vector3<T>(link.p_c.normalized().cast<T>());
    const Vector3<T> U_n = R_n * Vector3<T>(link.p_n.normalized().cast<T>());
    const Vector3<T> across = U_c - U_n;
    // a = atan(x), x = |U_c + U_n| / |U_c - U_n|; its square is smooth at 0, x is not.
    const T x_sq = (U_c + U_n).squaredNorm() / across.squaredNorm();
    T a_sq = x_sq * (T(1) - x_sq * T(2.0 / 3.0));
    if (x_sq > T(1e-10)) {
      using std::atan;
      using std::sqrt;
      const T a = atan(sqrt(x_sq));
      a_sq = a * a;
    }
    const double e = (link.p_c.norm() + link.p_n.norm()) / 2;
    const Vector3<T> k = T(2.0 / 3.0 * e) * a_sq * across.normalized();
    const Vector3<T> end_c = ConstVector<T>(t_c) + R_c * Vector3<T>(link.p_c.cast<T>());
    const Vector3<T> end_n = ConstVector<T>(t_n) + R_n * Vector3<T>(link.p_n.cast<T>());
    Eigen::Map<Vector3<T>> whitened(residual);
    whitened = (end_n - end_c - *share * k) / T(sigma_m);
    return true;
  }
};

struct ElastomerCost {
  GlobalLink link;
  const CellModel& model;

  template <typename T>
  bool operator()(const T* q_c, const T* q_n, T* residual) const {
    const Eigen::Quaternion<T> nominal = Eigen::Quaterniond(link.R_nom).cast<T>();
    const Eigen::Quaternion<T> turn =
        ConstRotation<T>(q_c).conjugate() * Eigen::Quaternion<T>(ConstRotation<T>(q_n)) * nominal.conjugate();
    const T wxyz[] = {turn.w(), turn.x(), turn.y(), turn.z()};
    Vector3<T> w;
    ceres::QuaternionToAngleAxis(wxyz, w.data());
    const Eigen::Matrix3d axes = linkAxes({PortNumber(), link.p_c});
    residual[0] = w.dot(axes.col(0).cast<T>()) / T(model.twist_sigma_rad);
    residual[1] = w.dot(axes.col(1).cast<T>()) / T(model.bend_sigma_rad);
    residual[2] = w.dot(axes.col(2).cast<T>()) / T(model.yaw_sigma_rad);
    return true;
  }
};

/// The problem in Ceres' terms, from a state on.
class CeresOracle {
 public:
  CeresOracle(const GlobalProblem& problem, const GlobalState& start)
      : problem_(problem), middle_o_(start.middle_o), share_(start.gap_share) {
    for (const SE3& cell : start.cells) {
      Cell unknowns;
      Eigen::Map<Eigen::Vector3d>(unknowns.t.data()) = cell.t;
      Eigen::Map<Eigen::Quaterniond>(unknowns.q.data()) = Eigen::Quaterniond(cell.R);
      cells_.push_back(unknowns);
    }
    for (std::size_t pose = 0; pose < problem.poses; ++pose) {
      Pose unknowns;
      Eigen::Map<Eigen::Vector3d>(unknowns.force.data()) = start.force_o[pose];
      Eigen::Map<Eigen::Vector3d>(unknowns.acceleration.data()) = start.acceleration_o[pose];
      poses_.push_back(unknowns);
    }
    addUnknowns();
    addReadings();
    addLinks();
  }

  /// As near the optimum as Ceres gets, on one thread.
  static ceres::Solver::Options exactOptions() {
    ceres::Solver::Options options;
    options.linear_solver_type = ceres::SPARSE_NORMAL_CHOLESKY;
    options.max_num_iterations = 500;
    options.function_tolerance = 1e-13;
    options.gradient_tolerance = 1e-13;
    options.parameter_tolerance = 1e-14;
    options.logging_type = ceres::SILENT;
    return options;
  }

  ceres::Solver::Summary solve(const ceres::Solver::Options& options = exactOptions()) {
    ceres::Solver::Summary summary;
    ceres::Solve(options, &ceres_, &summary);
    return summary;
  }

  [[nodiscard]] GlobalState state() const {
    GlobalState state;
    state.middle_o = middle_o_;
    state.gap_share = share_;
    for (const Cell& cell : cells_) {
      state.cells.push_back({Eigen::Map<const Eigen::Quaterniond>(cell.q.data()).toRotationMatrix(),
                             Eigen::Map<const Eigen::Vector3d>(cell.t.data())});
    }
    for (const Pose& pose : poses_) {
      state.force_o.emplace_back(pose.force.data());
      state.acceleration_o.emplace_back(pose.acceleration.data());
    }
    return state;
  }

 private:
  struct Cell {
    std::array<double, 3> t{};
    std::array<double, 4> q{};
    std::array<double, 3> offset{};
    std::array<double, 9> errors{};  // I + D, D row by row
  };
  struct Pose {
    std::array<double, 3> force{};
    std::array<double, 3> acceleration{};
  };

  void addUnknowns() {
    for (std::size_t k = 0; k < cells_.size(); ++k) {
      Cell& cell = cells_[k];
      ceres_.AddParameterBlock(cell.t.data(), 3);
      ceres_.AddParameterBlock(cell.q.data(), 4, new ceres::EigenQuaternionManifold);
      if (k != problem_.origin) continue;
      ceres_.SetParameterBlockConstant(cell.t.data());
      ceres_.SetParameterBlockConstant(cell.q.data());
    }
    for (Pose& pose : poses_) {
      ceres_.AddParameterBlock(pose.force.data(), 3);
      ceres_.AddResidualBlock(
          new ceres::AutoDiffCostFunction<ForceLengthCost, 1, 3>(new ForceLengthCost{problem_.force_sigma_g}), nullptr,
          pose.force.data());
      ceres_.AddParameterBlock(pose.acceleration.data(), 3);
      if (problem_.accelerations) {
        const double sigma = problem_.acceleration_sigma;
        addPrior<3>({sigma, sigma, sigma}, 0, pose.acceleration.data());
      } else {
        ceres_.SetParameterBlockConstant(pose.acceleration.data());
      }
    }
    ceres_.AddParameterBlock(&share_, 1);
    if (problem_.gap.sigma) {
      addPrior<1>({*problem_.gap.sigma}, problem_.gap.mean, &share_);
    } else {
      ceres_.SetParameterBlockConstant(&share_);
    }
  }

  template <int Size>
  void addPrior(const std::array<double, Size>& sigma, double mean, double* value) {
    using Cost = PriorCost<Size>;
    ceres_.AddResidualBlock(new ceres::AutoDiffCostFunction<Cost, Size, Size>(new Cost{sigma, mean}), nullptr, value);
  }

  [[nodiscard]] ceres::LossFunction* newLoss() const { return new ceres::HuberLoss(problem_.loss.threshold); }

  void addReadings() {
    const Accelerometer& a = problem_.model->accelerometer;
    const Eigen::Matrix3d R_a_u = a.T_u_a.R.transpose();
    for (std::size_t k = 0; k < cells_.size(); ++k) {
      if (problem_.readings[k].empty()) continue;
      Cell& cell = cells_[k];
      addPrior<3>({a.offset_sigma_g.x(), a.offset_sigma_g.y(), a.offset_sigma_g.z()}, 0, cell.offset.data());
      std::array<double, 9> sigma{};
      sigma.fill(a.cross_axis_sigma);
      sigma[0] = sigma[4] = sigma[8] = a.scale_sigma;
      addPrior<9>(sigma, 0, cell.errors.data());
      for (const CellReading& reading : problem_.readings[k]) {
        Pose& pose = poses_[reading.pose];
        ceres_.AddResidualBlock(new ceres::AutoDiffCostFunction<ReadingCost, 3, 3, 4, 3, 9, 3, 3>(
                                    new ReadingCost{reading, R_a_u, middle_o_}),
                                newLoss(), cell.t.data(), cell.q.data(), cell.offset.data(), cell.errors.data(),
                                pose.force.data(), pose.acceleration.data());
      }
    }
  }

  void addLinks() {
    for (const GlobalLink& link : problem_.links) {
      Cell& c = cells_[link.c];
      Cell& n = cells_[link.n];
      ceres_.AddResidualBlock(
          new ceres::AutoDiffCostFunction<ClosureCost, 3, 3, 4, 3, 4, 1>(new ClosureCost{link, problem_.link_sigma_m}),
          newLoss(), c.t.data(), c.q.data(), n.t.data(), n.q.data(), &share_);
      ceres_.AddResidualBlock(
          new ceres::AutoDiffCostFunction<ElastomerCost, 3, 4, 4>(new ElastomerCost{link, *problem_.model}), newLoss(),
          c.q.data(), n.q.data());
    }
  }

  const GlobalProblem& problem_;
  Eigen::Vector3d middle_o_;
  double share_;
  std::vector<Cell> cells_;
  std::vector<Pose> poses_;
  ceres::Problem ceres_;
};

}  // namespace hexoderm::oracle
