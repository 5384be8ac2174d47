#pragma once

#include "hexoderm/reconstruction/joint/poses_first_equations.h"

#include <Eigen/Cholesky>
#include <memory>
#include <vector>

namespace hexoderm::poses_first {

inline constexpr Eigen::Index kShared = 12;  // phi x I

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
  explicit Factor(const JointProblem& problem);

  bool factorize(std::shared_ptr<const Equations> equations, double damping);

  /// By the gradient of `at`, which may be a later model than the factor's.
  double step(const Equations& at, Eigen::VectorXd& cells, Eigen::VectorXd& border) const;

  [[nodiscard]] Eigen::MatrixXd inverseOfRest() const {
    return rest_.solve(Eigen::MatrixXd::Identity(rest_.rows(), rest_.rows()));
  }

  /// What the sensors' and turns' errors do to forces: the covariance C of t, C B and B^T C B.
  struct ForceSpread {
    Eigen::MatrixXd C;
    Eigen::MatrixXd CB;
    Eigen::Matrix<double, kShared, kShared, Eigen::DontAlign> BCB;
  };
  [[nodiscard]] ForceSpread forceSpread() const;
  /// Cross-covariance of the forces of two poses: H_p^-1 U_p^T C U_q H_q^-1, and H_p^-1 on top where they are one.
  /// U_p = B phi_p + D_p, D_p being that of the deviating readings.
  [[nodiscard]] Eigen::Matrix3d forces(const ForceSpread& spread, std::size_t p, std::size_t q) const;
  [[nodiscard]] std::size_t poseCount() const { return equations_->phi.size(); }

  [[nodiscard]] std::size_t origin() const { return origin_; }
  [[nodiscard]] std::size_t cellCount() const { return cells_; }
  [[nodiscard]] bool estimatesGapShare() const { return estimates_gap_share_; }
  [[nodiscard]] const std::vector<LinkEnds>& links() const { return links_; }

 private:
  [[nodiscard]] Eigen::Index parts() const { return static_cast<Eigen::Index>(equations_->measured.size()); }
  [[nodiscard]] Eigen::Index turnOf(std::size_t part) const;
  /// r x G, the negative of U for a precision of 1.
  [[nodiscard]] SensorByForce couplingOf(Eigen::Index part, std::size_t pose) const;
  /// What a reading adds to U beyond its cell's usual precision.
  [[nodiscard]] SensorByForce deviationOf(const Deviation& deviation, std::size_t pose) const;
  /// phi x I; zero for a pose in which nothing is usual.
  [[nodiscard]] Eigen::Matrix<double, kShared, 3> sharedOf(std::size_t pose) const;

  void findMoving();
  void invertPoses(double damping);
  /// B: what all poses have in common, columns phi x I.
  void findShared();
  /// Takes the products of the deviating readings' D_p off the lower triangle of S.
  void subtractDeviations(Eigen::MatrixXd& S) const;
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
  Eigen::MatrixXd shared_;
  Eigen::LLT<Eigen::MatrixXd> sensors_;  ///< of S + P
  Eigen::MatrixXd lower_;                ///< L^-1 S K
  Eigen::LLT<Eigen::MatrixXd> rest_;     ///< of turns, positions and the gap share, sensors taken out
};

}  // namespace hexoderm::poses_first
