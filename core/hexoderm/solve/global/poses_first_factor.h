#pragma once

#include "hexoderm/solve/global/poses_first_equations.h"

#include <Eigen/Cholesky>
#include <memory>
#include <vector>

namespace hexoderm::poses_first {

using SensorVector = Eigen::Matrix<double, kSensor, 1>;

/// The cells of a link; the factor keeps them, since it outlives the problem.
struct LinkEnds {
  std::size_t c = 0;
  std::size_t n = 0;
};

/// The matrix about sensors e, turns x and the gap share, with the forces taken out. With t = e + K x, its blocks are
/// S + P (P: the priors of e), S K and K^T S K + X (X: links and gap share).
class Factor {
 public:
  explicit Factor(const GlobalProblem& problem);

  bool factorize(std::shared_ptr<const Equations> equations, double damping);

  /// By the gradient of `at`, which may be a later model than the factor's.
  double step(const Equations& at, Eigen::VectorXd& cells, Eigen::VectorXd& border) const;

  [[nodiscard]] Eigen::MatrixXd inverseOfRest() const {
    return rest_.solve(Eigen::MatrixXd::Identity(rest_.rows(), rest_.rows()));
  }

  /// Covariance C of t.
  [[nodiscard]] Eigen::MatrixXd sensorCovariance() const;
  /// Covariance of the force of every pose: H_p^-1 + H_p^-1 U_p^T C U_p H_p^-1.
  [[nodiscard]] std::vector<Eigen::Matrix3d> forceOfEachPose(const Eigen::MatrixXd& C) const;
  /// Cross-covariance of the forces of two poses: H_p^-1 U_p^T C U_q H_q^-1.
  [[nodiscard]] Eigen::Matrix3d forces(const Eigen::MatrixXd& C, std::size_t p, std::size_t q) const;

  [[nodiscard]] std::size_t origin() const { return origin_; }
  [[nodiscard]] std::size_t cellCount() const { return cells_; }
  [[nodiscard]] bool estimatesGapShare() const { return estimates_gap_share_; }
  [[nodiscard]] const std::vector<LinkEnds>& links() const { return links_; }

 private:
  [[nodiscard]] Eigen::Index parts() const { return static_cast<Eigen::Index>(equations_->measured.size()); }
  [[nodiscard]] const MeasuredCell& measured(Eigen::Index part) const {
    return equations_->measured[static_cast<std::size_t>(part)];
  }
  [[nodiscard]] Eigen::Index turnOf(std::size_t part) const;
  /// U_p of a pose.
  [[nodiscard]] Eigen::MatrixXd couplingOf(std::size_t pose) const;
  [[nodiscard]] Eigen::MatrixXd precisionsOfPairs(Eigen::Index b) const;

  void findMoving();
  void invertPoses(double damping);
  /// S, both triangles.
  [[nodiscard]] Eigen::MatrixXd reducedInformation() const;
  [[nodiscard]] Eigen::MatrixXd timesK(const Eigen::MatrixXd& left) const;
  [[nodiscard]] Eigen::MatrixXd transposedKTimes(const Eigen::MatrixXd& right) const;
  /// X; lower triangle.
  [[nodiscard]] Eigen::MatrixXd matrixOfRest(double damping) const;

  std::size_t origin_;
  std::size_t cells_;
  bool estimates_gap_share_;
  std::vector<LinkEnds> links_;
  SensorVector prior_;
  std::shared_ptr<const Equations> equations_;  ///< those that are factorised
  std::vector<std::size_t> moving_;             ///< places in equations_->measured
  std::vector<Eigen::Matrix3d> pose_inverse_;   ///< H_p^-1
  Eigen::LLT<Eigen::MatrixXd> sensors_;         ///< of S + P
  Eigen::MatrixXd lower_;                       ///< L^-1 S K
  Eigen::LLT<Eigen::MatrixXd> rest_;            ///< of turns, positions and the gap share, sensors taken out
};

}  // namespace hexoderm::poses_first
