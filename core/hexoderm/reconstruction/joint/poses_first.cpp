#include "hexoderm/reconstruction/joint/poses_first.h"

#include <Eigen/Cholesky>
#include <algorithm>
#include <cassert>
#include <mutex>
#include <stdexcept>
#include <utility>

namespace hexoderm {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

constexpr Index kSensor = 12;  // offset and gains of an accelerometer: per axis (b_i, D_i)
constexpr Index kShared = 12;  // phi x I

using SensorVector = Eigen::Matrix<double, kSensor, 1>;
using SensorByForce = Eigen::Matrix<double, kSensor, 3>;

/// A reading whose precision is not its cell's usual one; absent readings have a precision of 0.
struct Deviation {
  std::size_t part = 0;
  double excess = 0;  ///< precision less the usual one
};

struct PoseReadings {
  /// Most cells read with their usual precision. Where few do, differences from it would lose their digits: nothing is
  /// usual then.
  bool usual = true;
  std::vector<Deviation> deviating;
};

/// A cell with readings.
struct MeasuredCell {
  std::size_t cell = 0;
  bool moves = true;              ///< false for the origin
  Eigen::Matrix3d G;              ///< d residual / d force
  Eigen::Matrix4d T;              ///< r = T (1, f)
  SensorByForce K;                ///< change of (b, D) that makes up for a turn of the cell
  Eigen::Matrix4d information;    ///< sum of w r r^T
  double usual_precision = 0;     ///< the median over all poses
  std::vector<double> precision;  ///< per pose, 0 without a reading
};

/// (r x G) of one reading.
SensorByForce coupling(const Eigen::Vector4d& r, const Eigen::Matrix3d& G) {
  SensorByForce product;
  for (int axis = 0; axis < 3; ++axis) product.middleRows<4>(4 * axis).noalias() = r * G.row(axis);
  return product;
}

/// The second-order model: links and the gap share as in NormalEquations, readings by their parts.
struct PosesFirstEquations {
  NormalEquations rest;  ///< of the border nothing but the gap share; its gradients are complete
  std::vector<MeasuredCell> measured;
  std::vector<Eigen::Vector4d> phi;               ///< per pose
  std::vector<PoseReadings> readings;             ///< per pose
  std::vector<Eigen::Matrix3d> pose_information;  ///< H_p
  VectorXd gradient_poses;
  // Diagonals of the matrix after the sensors' elimination, of which damping adds a share.
  VectorXd diagonal_cells;
  VectorXd diagonal_poses;
};

class PosesFirstLinearizer {
 public:
  PosesFirstLinearizer(const JointProblem& problem, const JointState& state, PosesFirstEquations& equations)
      : problem_(problem),
        state_(state),
        equations_(equations),
        prior_(problem.model->accelerometer),
        R_a_u_(problem.model->accelerometer.T_u_a.R.transpose()) {}

  void run() {
    startRest();
    equations_.phi.resize(problem_.poses);
    equations_.pose_information.assign(problem_.poses, Eigen::Matrix3d::Zero());
    equations_.gradient_poses.setZero(static_cast<Index>(3 * problem_.poses));
    for (std::size_t pose = 0; pose < problem_.poses; ++pose) {
      equations_.phi[pose] << 1, state_.force_o[pose];
      addForcePrior(problem_, state_.force_o[pose], equations_.pose_information[pose],
                    equations_.gradient_poses.segment<3>(static_cast<Index>(3 * pose)));
    }
    equations_.diagonal_poses.setZero(equations_.gradient_poses.size());
    equations_.diagonal_cells.setZero(equations_.rest.gradient_cells.size());
    equations_.measured.clear();
    for (std::size_t cell = 0; cell < problem_.cellCount(); ++cell) add(cell);
    findDeviating();
    for (std::size_t pose = 0; pose < problem_.poses; ++pose) {
      equations_.diagonal_poses.segment<3>(static_cast<Index>(3 * pose)) +=
          equations_.pose_information[pose].diagonal();
    }
    addLinks(problem_, state_, 0, equations_.rest);
    for (std::size_t cell = 0; cell < problem_.cellCount(); ++cell) {
      equations_.diagonal_cells.segment<6>(static_cast<Index>(6 * cell)) += equations_.rest.cells[cell].diagonal();
    }
  }

 private:
  void startRest() {
    NormalEquations& rest = equations_.rest;
    const auto rows = static_cast<Index>(6 * problem_.cellCount());
    const Index border = problem_.gap.sigma ? 1 : 0;
    rest.cells.assign(problem_.cellCount(), Matrix6d::Zero());
    rest.cells[problem_.origin].setIdentity();
    rest.links.assign(problem_.links.size(), Matrix6d::Zero());
    rest.border_cells.setZero(rows, border);
    rest.border.setZero(border, border);
    rest.gradient_cells.setZero(rows);
    rest.gradient_border.setZero(border);
    rest.cost = priorCost(problem_, state_);
  }

  void add(std::size_t cell) {
    const std::vector<CellReading>& readings = problem_.readings[cell];
    if (readings.empty()) return;
    fitCell(problem_, prior_, state_, cell, sensor_);
    const AccelerometerFit& fit = sensor_.fit;
    equations_.rest.cost += fit.cost;

    MeasuredCell& measured = equations_.measured.emplace_back();
    const Eigen::Matrix3d R_a_o = R_a_u_ * state_.cells[cell].R.transpose();
    measured.cell = cell;
    measured.moves = cell != problem_.origin;
    measured.G = -fit.gain * R_a_o;
    measured.T.setIdentity();
    measured.T.bottomRightCorner<3, 3>() = R_a_o;
    measured.K.setZero();
    for (int axis = 0; axis < 3 && measured.moves; ++axis) {
      measured.K.middleRows<3>(4 * axis + 1) = -skew(fit.gain.row(axis).transpose()) * R_a_u_;
    }
    measured.information.setZero();
    measured.precision.assign(problem_.poses, 0.0);

    Eigen::Vector3d turning = Eigen::Vector3d::Zero();
    for (std::size_t k = 0; k < readings.size(); ++k) {
      const std::size_t pose = readings[k].pose;
      const double precision = fit.precision[k];
      const Eigen::Vector3d weighted = precision * fit.residual_g[k];
      const Eigen::Vector4d r = measured.T * equations_.phi[pose];
      measured.precision[pose] = precision;
      measured.information.noalias() += precision * r * r.transpose();
      turning += sensor_.v_g[k].cross(fit.gain.transpose() * weighted);
      equations_.pose_information[pose].noalias() += precision * measured.G.transpose() * measured.G;
      equations_.gradient_poses.segment<3>(static_cast<Index>(3 * pose)).noalias() += measured.G.transpose() * weighted;
      for (std::size_t axis = 0; axis < 3; ++axis) {
        const double explained = precision * precision * (fit.covariance_root[axis].transpose() * r).squaredNorm();
        equations_.diagonal_poses.segment<3>(static_cast<Index>(3 * pose)) -=
            explained * measured.G.row(static_cast<Index>(axis)).transpose().cwiseAbs2();
      }
    }
    if (measured.moves) {
      const auto at = static_cast<Index>(6 * cell + 3);
      equations_.rest.gradient_cells.segment<3>(at) += R_a_u_.transpose() * turning;
      for (std::size_t axis = 0; axis < 3; ++axis) {
        const Eigen::Matrix<double, 4, 3> K = measured.K.middleRows<4>(static_cast<Index>(4 * axis));
        const Eigen::Matrix<double, 4, 3> mixed = measured.information * K;
        const Eigen::Matrix<double, 4, 3> root = fit.covariance_root[axis].transpose() * mixed;
        equations_.diagonal_cells.segment<3>(at) +=
            (K.cwiseProduct(mixed) - root.cwiseProduct(root)).colwise().sum().transpose();
      }
    }
    sorted_ = measured.precision;
    const auto middle = sorted_.begin() + static_cast<std::ptrdiff_t>(sorted_.size() / 2);
    std::ranges::nth_element(sorted_, middle);
    measured.usual_precision = *middle;
  }

  void findDeviating() {
    const std::vector<MeasuredCell>& measured = equations_.measured;
    equations_.readings.assign(problem_.poses, {});
    for (std::size_t pose = 0; pose < problem_.poses; ++pose) {
      PoseReadings& readings = equations_.readings[pose];
      const auto deviates = [pose](const MeasuredCell& cell) { return cell.precision[pose] != cell.usual_precision; };
      readings.usual = 2 * std::ranges::count_if(measured, deviates) < std::ssize(measured);
      for (std::size_t part = 0; part < measured.size(); ++part) {
        const double excess = measured[part].precision[pose] - (readings.usual ? measured[part].usual_precision : 0);
        if (excess != 0) readings.deviating.push_back({part, excess});
      }
    }
  }

  const JointProblem& problem_;
  const JointState& state_;
  PosesFirstEquations& equations_;
  AccelerometerPrior prior_;
  Eigen::Matrix3d R_a_u_;
  SensorState sensor_;
  std::vector<double> sorted_;
};

/// The links of a problem, for as long as a factor or an inverse lives.
struct LinkEnds {
  std::size_t c = 0;
  std::size_t n = 0;
};

/// The matrix about sensors e, turns x and the gap share, with the forces taken out. With t = e + K x, its blocks are
/// S + P (P: the priors of e), S K and K^T S K + X (X: links and gap share).
class PosesFirstFactor {
 public:
  PosesFirstFactor(const JointProblem& problem)
      : origin_(problem.origin), cells_(problem.cellCount()), estimates_gap_share_(problem.gap.sigma.has_value()) {
    for (const JointLink& link : problem.links) links_.push_back({link.c, link.n});
    const AccelerometerPrior prior(problem.model->accelerometer);
    for (int axis = 0; axis < 3; ++axis) prior_.segment<4>(4 * axis) = prior.precision(axis);
  }

  bool factorize(std::shared_ptr<const PosesFirstEquations> equations, double damping) {
    equations_ = std::move(equations);
    findMoving();
    invertPoses(damping);
    findShared();
    MatrixXd S = reducedInformation();
    const MatrixXd SK = timesK(S);
    const MatrixXd KSK = transposedKTimes(SK);
    for (Index part = 0; part < parts(); ++part) S.diagonal().segment<kSensor>(kSensor * part) += prior_;
    sensors_.compute(S);
    if (sensors_.info() != Eigen::Success) return false;
    lower_ = SK;
    sensors_.matrixL().solveInPlace(lower_);
    MatrixXd left = KSK;
    left.selfadjointView<Eigen::Lower>().rankUpdate(lower_.transpose(), -1);

    MatrixXd X = matrixOfRest(damping);
    for (std::size_t b = 0; b < moving_.size(); ++b) {
      for (std::size_t a = b; a < moving_.size(); ++a) {
        X.block<3, 3>(turnOf(moving_[a]), turnOf(moving_[b])) +=
            left.block<3, 3>(static_cast<Index>(3 * a), static_cast<Index>(3 * b));
      }
    }
    rest_.compute(X);
    return rest_.info() == Eigen::Success && rest_.matrixLLT().diagonal().allFinite();
  }

  /// By the gradient of `at`, which may be a later model than the factor's.
  double step(const PosesFirstEquations& at, VectorXd& cells, VectorXd& border) const {
    // Taking out the forces moves a part of their gradient over to t: r = -sum_p U_p H_p^-1 g_p.
    const std::size_t poses = equations_->phi.size();
    VectorXd moved_to_t = VectorXd::Zero(kSensor * parts());
    for (std::size_t pose = 0; pose < poses; ++pose) {
      const Eigen::Vector3d push = pose_inverse_[pose] * at.gradient_poses.segment<3>(static_cast<Index>(3 * pose));
      for (Index part = 0; part < parts(); ++part) {
        const double precision = equations_->measured[static_cast<std::size_t>(part)].precision[pose];
        if (precision == 0) continue;
        moved_to_t.segment<kSensor>(kSensor * part) += precision * (couplingOf(part, pose) * push);
      }
    }
    VectorXd e = -moved_to_t;
    sensors_.matrixL().solveInPlace(e);
    VectorXd x(6 * static_cast<Index>(cells_) + at.rest.gradient_border.size());
    x << -at.rest.gradient_cells, -at.rest.gradient_border;
    const VectorXd turns = transposedKTimes(moved_to_t) + lower_.transpose() * e;
    for (std::size_t k = 0; k < moving_.size(); ++k) {
      x.segment<3>(turnOf(moving_[k])) -= turns.segment<3>(static_cast<Index>(3 * k));
    }
    rest_.solveInPlace(x);

    VectorXd turned(static_cast<Index>(3 * moving_.size()));
    for (std::size_t k = 0; k < moving_.size(); ++k) {
      turned.segment<3>(static_cast<Index>(3 * k)) = x.segment<3>(turnOf(moving_[k]));
    }
    e -= lower_ * turned;
    sensors_.matrixU().solveInPlace(e);
    for (std::size_t k = 0; k < moving_.size(); ++k) {
      e.segment<kSensor>(kSensor * static_cast<Index>(moving_[k])) +=
          equations_->measured[moving_[k]].K * turned.segment<3>(static_cast<Index>(3 * k));
    }
    cells = x.head(6 * static_cast<Index>(cells_));
    border.resize(static_cast<Index>(3 * poses) + at.rest.gradient_border.size());
    border.tail(at.rest.gradient_border.size()) = x.tail(at.rest.gradient_border.size());
    for (std::size_t pose = 0; pose < poses; ++pose) {
      Eigen::Vector3d gradient = at.gradient_poses.segment<3>(static_cast<Index>(3 * pose));
      for (Index part = 0; part < parts(); ++part) {
        const double precision = equations_->measured[static_cast<std::size_t>(part)].precision[pose];
        if (precision == 0) continue;
        gradient -= precision * (couplingOf(part, pose).transpose() * e.segment<kSensor>(kSensor * part));
      }
      border.segment<3>(static_cast<Index>(3 * pose)) = -pose_inverse_[pose] * gradient;
    }
    return -(at.rest.gradient_cells.dot(cells) + at.gradient_poses.dot(border.head(at.gradient_poses.size())) +
             at.rest.gradient_border.dot(border.tail(at.rest.gradient_border.size()))) /
           2;
  }

  [[nodiscard]] MatrixXd inverseOfRest() const { return rest_.solve(MatrixXd::Identity(rest_.rows(), rest_.rows())); }

  /// What the sensors' and turns' errors do to forces: the covariance C of t, C B and B^T C B.
  struct ForceSpread {
    MatrixXd C;
    MatrixXd CB;
    Eigen::Matrix<double, kShared, kShared, Eigen::DontAlign> BCB;
  };
  [[nodiscard]] ForceSpread forceSpread() const {
    MatrixXd across = MatrixXd::Zero(rest_.rows(), kSensor * parts());
    for (std::size_t k = 0; k < moving_.size(); ++k) {
      across.block<3, kSensor>(turnOf(moving_[k]), kSensor * static_cast<Index>(moving_[k])) =
          equations_->measured[moving_[k]].K.transpose();
    }
    MatrixXd root = MatrixXd::Identity(kSensor * parts(), kSensor * parts());
    sensors_.matrixL().solveInPlace(root);
    const MatrixXd of_turns = lower_.transpose() * root;
    for (std::size_t k = 0; k < moving_.size(); ++k) {
      across.middleRows<3>(turnOf(moving_[k])) -= of_turns.middleRows<3>(static_cast<Index>(3 * k));
    }
    rest_.matrixL().solveInPlace(across);
    ForceSpread spread;
    spread.C = MatrixXd::Zero(root.cols(), root.cols());
    spread.C.selfadjointView<Eigen::Lower>().rankUpdate(root.transpose());
    spread.C.selfadjointView<Eigen::Lower>().rankUpdate(across.transpose());
    spread.C.triangularView<Eigen::StrictlyUpper>() = spread.C.transpose();
    spread.CB = spread.C * shared_;
    spread.BCB = shared_.transpose() * spread.CB;
    return spread;
  }

  /// Cross-covariance of the forces of two poses: H_p^-1 U_p^T C U_q H_q^-1, and H_p^-1 on top where they are one.
  /// U_p = B phi_p + D_p, D_p being that of the deviating readings.
  [[nodiscard]] Eigen::Matrix3d forces(const ForceSpread& spread, std::size_t p, std::size_t q) const {
    const Eigen::Matrix<double, kShared, 3> phi_p = sharedOf(p);
    const Eigen::Matrix<double, kShared, 3> phi_q = sharedOf(q);
    Eigen::Matrix3d seen = phi_p.transpose() * spread.BCB * phi_q;
    const std::vector<Deviation>& deviating_p = equations_->readings[p].deviating;
    const std::vector<Deviation>& deviating_q = equations_->readings[q].deviating;
    std::vector<SensorByForce> D_q;
    for (const Deviation& deviation : deviating_q) D_q.push_back(deviationOf(deviation, q));
    for (std::size_t b = 0; b < deviating_q.size(); ++b) {
      const Index at_b = kSensor * static_cast<Index>(deviating_q[b].part);
      seen += phi_p.transpose() * spread.CB.middleRows<kSensor>(at_b).transpose() * D_q[b];
    }
    for (const Deviation& deviation : deviating_p) {
      const SensorByForce D_p = deviationOf(deviation, p);
      const Index at_a = kSensor * static_cast<Index>(deviation.part);
      seen += D_p.transpose() * spread.CB.middleRows<kSensor>(at_a) * phi_q;
      SensorByForce CD = SensorByForce::Zero();
      for (std::size_t b = 0; b < deviating_q.size(); ++b) {
        const Index at_b = kSensor * static_cast<Index>(deviating_q[b].part);
        CD.noalias() += spread.C.block<kSensor, kSensor>(at_a, at_b).lazyProduct(D_q[b]);
      }
      seen += D_p.transpose() * CD;
    }
    Eigen::Matrix3d covariance = pose_inverse_[p] * seen * pose_inverse_[q];
    if (p == q) covariance = (pose_inverse_[p] + (covariance + covariance.transpose()) / 2).eval();
    return covariance;
  }
  [[nodiscard]] std::size_t poseCount() const { return equations_->phi.size(); }

  [[nodiscard]] std::size_t origin() const { return origin_; }
  [[nodiscard]] std::size_t cellCount() const { return cells_; }
  [[nodiscard]] bool estimatesGapShare() const { return estimates_gap_share_; }
  [[nodiscard]] const std::vector<LinkEnds>& links() const { return links_; }

 private:
  [[nodiscard]] Index parts() const { return static_cast<Index>(equations_->measured.size()); }
  [[nodiscard]] Index turnOf(std::size_t part) const {
    return static_cast<Index>(6 * equations_->measured[part].cell + 3);
  }
  /// r x G, the negative of U for a precision of 1.
  [[nodiscard]] SensorByForce couplingOf(Index part, std::size_t pose) const {
    const MeasuredCell& measured = equations_->measured[static_cast<std::size_t>(part)];
    return coupling(measured.T * equations_->phi[pose], measured.G);
  }
  /// What a reading adds to U beyond its cell's usual precision.
  [[nodiscard]] SensorByForce deviationOf(const Deviation& deviation, std::size_t pose) const {
    return -deviation.excess * couplingOf(static_cast<Index>(deviation.part), pose);
  }
  /// phi x I; zero for a pose in which nothing is usual.
  [[nodiscard]] Eigen::Matrix<double, kShared, 3> sharedOf(std::size_t pose) const {
    Eigen::Matrix<double, kShared, 3> product = Eigen::Matrix<double, kShared, 3>::Zero();
    for (int k = 0; k < 4 && equations_->readings[pose].usual; ++k) {
      product.middleRows<3>(3 * k) = equations_->phi[pose][k] * Eigen::Matrix3d::Identity();
    }
    return product;
  }

  void findMoving() {
    moving_.clear();
    for (std::size_t part = 0; part < equations_->measured.size(); ++part) {
      if (equations_->measured[part].moves) moving_.push_back(part);
    }
  }

  void invertPoses(double damping) {
    pose_inverse_.clear();
    for (std::size_t pose = 0; pose < equations_->phi.size(); ++pose) {
      Eigen::Matrix3d H = equations_->pose_information[pose];
      H.diagonal() += damping * equations_->diagonal_poses.segment<3>(static_cast<Index>(3 * pose));
      // A pose that nothing but priors speaks of is nearly singular; cofactors would lose all digits.
      pose_inverse_.emplace_back(H.llt().solve(Eigen::Matrix3d::Identity()));
    }
  }

  /// B: what all poses have in common, columns phi x I.
  void findShared() {
    shared_.resize(kSensor * parts(), kShared);
    for (Index part = 0; part < parts(); ++part) {
      const MeasuredCell& measured = equations_->measured[static_cast<std::size_t>(part)];
      for (int k = 0; k < 4; ++k) {
        shared_.block<kSensor, 3>(kSensor * part, 3 * k) =
            -measured.usual_precision * coupling(measured.T.col(k), measured.G);
      }
    }
  }

  /// S, both triangles.
  [[nodiscard]] MatrixXd reducedInformation() const {
    Eigen::Matrix<double, kShared, kShared> middle = Eigen::Matrix<double, kShared, kShared>::Zero();
    MatrixXd mixed = MatrixXd::Zero(kSensor * parts(), kShared);
    MatrixXd S = MatrixXd::Zero(kSensor * parts(), kSensor * parts());
    std::vector<Eigen::Vector4d> r;  // of the deviating readings, times their excess
    for (std::size_t pose = 0; pose < equations_->phi.size(); ++pose) {
      const Eigen::Matrix<double, kShared, 3> phi = sharedOf(pose);
      const Eigen::Matrix<double, kShared, 3> phi_H = phi.lazyProduct(pose_inverse_[pose]);
      middle.noalias() += phi_H.lazyProduct(phi.transpose());
      const std::vector<Deviation>& deviating = equations_->readings[pose].deviating;
      r.clear();
      for (const Deviation& deviation : deviating) {
        r.emplace_back(deviation.excess * (equations_->measured[deviation.part].T * equations_->phi[pose]));
        mixed.middleRows<kSensor>(kSensor * static_cast<Index>(deviation.part)).noalias() +=
            deviationOf(deviation, pose).lazyProduct(phi_H.transpose());
      }
      // D_a H^-1 D_b^T = (r_a r_b^T) x (G_a H^-1 G_b^T)
      for (std::size_t b = 0; b < deviating.size(); ++b) {
        const Eigen::Matrix3d H_G = pose_inverse_[pose] * equations_->measured[deviating[b].part].G.transpose();
        for (std::size_t a = b; a < deviating.size(); ++a) {
          const Eigen::Matrix3d forces = equations_->measured[deviating[a].part].G * H_G;
          const Eigen::Matrix4d rows = r[a] * r[b].transpose();
          auto block = S.block<kSensor, kSensor>(kSensor * static_cast<Index>(deviating[a].part),
                                                 kSensor * static_cast<Index>(deviating[b].part));
          for (int j = 0; j < 3; ++j) {
            for (int i = 0; i < 3; ++i) block.block<4, 4>(4 * i, 4 * j) -= forces(i, j) * rows;
          }
        }
      }
    }
    // B M B^T + B Y^T + Y B^T in one product, M: middle, Y: mixed.
    MatrixXd left(shared_.rows(), 2 * kShared);
    MatrixXd right(shared_.rows(), 2 * kShared);
    left << shared_ * middle / 2 + mixed, shared_;
    right << shared_, shared_ * middle / 2 + mixed;
    S.triangularView<Eigen::Lower>() -= left * right.transpose();
    for (Index part = 0; part < parts(); ++part) {
      for (int axis = 0; axis < 3; ++axis) {
        S.block<4, 4>(kSensor * part + 4 * axis, kSensor * part + 4 * axis) +=
            equations_->measured[static_cast<std::size_t>(part)].information;
      }
    }
    S.triangularView<Eigen::StrictlyUpper>() = S.transpose();
    return S;
  }

  [[nodiscard]] MatrixXd timesK(const MatrixXd& left) const {
    MatrixXd product(left.rows(), static_cast<Index>(3 * moving_.size()));
    for (std::size_t k = 0; k < moving_.size(); ++k) {
      product.middleCols<3>(static_cast<Index>(3 * k)).noalias() =
          left.middleCols<kSensor>(kSensor * static_cast<Index>(moving_[k])) * equations_->measured[moving_[k]].K;
    }
    return product;
  }

  [[nodiscard]] MatrixXd transposedKTimes(const MatrixXd& right) const {
    MatrixXd product(static_cast<Index>(3 * moving_.size()), right.cols());
    for (std::size_t k = 0; k < moving_.size(); ++k) {
      product.middleRows<3>(static_cast<Index>(3 * k)).noalias() =
          equations_->measured[moving_[k]].K.transpose() *
          right.middleRows<kSensor>(kSensor * static_cast<Index>(moving_[k]));
    }
    return product;
  }

  /// X; lower triangle.
  [[nodiscard]] MatrixXd matrixOfRest(double damping) const {
    const NormalEquations& rest = equations_->rest;
    const Index rows = rest.gradient_cells.size();
    const Index border = rest.gradient_border.size();
    MatrixXd X = MatrixXd::Zero(rows + border, rows + border);
    for (std::size_t cell = 0; cell < cells_; ++cell) {
      const auto at = static_cast<Index>(6 * cell);
      X.block<6, 6>(at, at) = rest.cells[cell];
      X.diagonal().segment<6>(at) += damping * equations_->diagonal_cells.segment<6>(at);
    }
    for (std::size_t k = 0; k < links_.size(); ++k) {
      const auto c = static_cast<Index>(6 * links_[k].c);
      const auto n = static_cast<Index>(6 * links_[k].n);
      if (c > n) {
        X.block<6, 6>(c, n) += rest.links[k];
      } else {
        X.block<6, 6>(n, c) += rest.links[k].transpose();
      }
    }
    X.bottomLeftCorner(border, rows) = rest.border_cells.transpose();
    X.bottomRightCorner(border, border) = (1 + damping) * rest.border;
    return X;
  }

  std::size_t origin_;
  std::size_t cells_;
  bool estimates_gap_share_;
  std::vector<LinkEnds> links_;
  SensorVector prior_;
  std::shared_ptr<const PosesFirstEquations> equations_;  ///< those that are factorised
  std::vector<std::size_t> moving_;                       ///< places in equations_->measured
  std::vector<Eigen::Matrix3d> pose_inverse_;             ///< H_p^-1
  MatrixXd shared_;
  Eigen::LLT<MatrixXd> sensors_;  ///< of S + P
  MatrixXd lower_;                ///< L^-1 S K
  Eigen::LLT<MatrixXd> rest_;     ///< of turns, positions and the gap share, sensors taken out
};

class PosesFirstInverse : public JointInverse {
 public:
  explicit PosesFirstInverse(std::unique_ptr<const PosesFirstFactor> factor)
      : origin_(factor->origin()), estimates_gap_share_(factor->estimatesGapShare()), factor_(std::move(factor)) {}

  [[nodiscard]] const Matrix6d& cell(std::size_t cell) const override { return parts().cells[cell]; }
  [[nodiscard]] const Matrix6d& link(std::size_t link) const override { return parts().links[link]; }
  [[nodiscard]] Matrix6d between(std::size_t a, std::size_t b) const override { return blockOf(parts().rest, a, b); }
  [[nodiscard]] MatrixXd timesCells(const MatrixXd& B) const override {
    MatrixXd from = B;
    from.middleRows<6>(static_cast<Index>(6 * origin_)).setZero();
    MatrixXd product = parts().rest.topLeftCorner(B.rows(), B.rows()) * from;
    product.middleRows<6>(static_cast<Index>(6 * origin_)).setZero();
    return product;
  }
  [[nodiscard]] Eigen::Matrix3d force(std::size_t pose) const override { return parts().forces[pose]; }
  [[nodiscard]] Eigen::Matrix3d forces(std::size_t a, std::size_t b) const override {
    return factor_->forces(parts().force_spread, a, b);
  }
  [[nodiscard]] Eigen::Matrix3d acceleration(std::size_t) const override {
    throw std::logic_error("no acceleration was estimated");
  }
  [[nodiscard]] double gapShareVariance() const override {
    const MatrixXd& rest = parts().rest;
    return estimates_gap_share_ ? rest(rest.rows() - 1, rest.cols() - 1) : 0;
  }

 private:
  struct Parts {
    MatrixXd rest;
    std::vector<Matrix6d> cells;
    std::vector<Matrix6d> links;
    PosesFirstFactor::ForceSpread force_spread;
    std::vector<Eigen::Matrix3d> forces;
  };

  [[nodiscard]] Matrix6d blockOf(const MatrixXd& rest, std::size_t a, std::size_t b) const {
    if (a == origin_ || b == origin_) return Matrix6d::Zero();
    return rest.block<6, 6>(static_cast<Index>(6 * a), static_cast<Index>(6 * b));
  }

  /// Computed when somebody asks: of several solutions in a row only the last one's is looked at.
  const Parts& parts() const {
    std::call_once(computed_, [this] { parts_ = compute(); });
    return parts_;
  }

  [[nodiscard]] Parts compute() const {
    Parts parts;
    parts.rest = factor_->inverseOfRest();
    parts.rest = (parts.rest + parts.rest.transpose()).eval() / 2;
    for (std::size_t cell = 0; cell < factor_->cellCount(); ++cell) {
      parts.cells.push_back(blockOf(parts.rest, cell, cell));
    }
    for (const LinkEnds& link : factor_->links()) parts.links.push_back(blockOf(parts.rest, link.c, link.n));
    parts.force_spread = factor_->forceSpread();
    for (std::size_t pose = 0; pose < factor_->poseCount(); ++pose) {
      parts.forces.push_back(factor_->forces(parts.force_spread, pose, pose));
    }
    return parts;
  }

  std::size_t origin_;
  bool estimates_gap_share_;
  mutable std::once_flag computed_;
  std::unique_ptr<const PosesFirstFactor> factor_;
  mutable Parts parts_;
};

class PosesFirst : public JointSystem {
 public:
  explicit PosesFirst(const JointProblem& problem)
      : problem_(problem), factor_(std::make_unique<PosesFirstFactor>(problem)) {
    assert(!problem.accelerations);
  }

  double linearize(const JointState& candidate) override {
    auto equations = std::make_shared<PosesFirstEquations>();
    PosesFirstLinearizer(problem_, candidate, *equations).run();
    next_ = std::move(equations);
    return next_->rest.cost;
  }
  void accept() override { equations_ = std::move(next_); }
  bool factorize(double damping) override { return factor_->factorize(equations_, damping); }
  double step(VectorXd& cells, VectorXd& border) const override { return factor_->step(*equations_, cells, border); }
  std::unique_ptr<const JointInverse> inverse() override {
    return std::make_unique<PosesFirstInverse>(std::move(factor_));
  }

 private:
  const JointProblem& problem_;
  std::unique_ptr<PosesFirstFactor> factor_;
  std::shared_ptr<const PosesFirstEquations> equations_;
  std::shared_ptr<const PosesFirstEquations> next_;
};

}  // namespace

std::unique_ptr<JointSystem> makePosesFirst(const JointProblem& problem) {
  return std::make_unique<PosesFirst>(problem);
}

double workOfPosesFirst(const JointProblem& problem) {
  // Two dense matrices are factorised, of twelve errors of a sensor and of six unknowns of a cell, and the first one
  // takes out the turns. A pose costs what its deviating readings cost in pairs: far from the optimum, nearly all.
  const auto cells = static_cast<double>(problem.cellCount());
  const double sensors = 12 * cells;
  const double rest = 6 * cells + 1;
  constexpr double kPerPair = 200;
  return sensors * sensors * sensors / 6 + sensors * sensors * (3 * cells + 24) / 2 + rest * rest * rest / 6 +
         kPerPair * cells * cells * static_cast<double>(problem.poses);
}

}  // namespace hexoderm
