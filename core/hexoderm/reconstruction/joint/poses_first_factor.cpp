#include "hexoderm/reconstruction/joint/poses_first_factor.h"

#include <algorithm>
#include <utility>

namespace hexoderm::poses_first {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

Factor::Factor(const JointProblem& problem)
    : origin_(problem.origin), cells_(problem.cellCount()), estimates_gap_share_(problem.gap.sigma.has_value()) {
  for (const JointLink& link : problem.links) links_.push_back({link.c, link.n});
  const AccelerometerPrior prior(problem.model->accelerometer);
  for (int axis = 0; axis < 3; ++axis) prior_.segment<4>(4 * axis) = prior.precision(axis);
}

bool Factor::factorize(std::shared_ptr<const Equations> equations, double damping) {
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

double Factor::step(const Equations& at, VectorXd& cells, VectorXd& border) const {
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

Factor::ForceSpread Factor::forceSpread() const {
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

Eigen::Matrix3d Factor::forces(const ForceSpread& spread, std::size_t p, std::size_t q) const {
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

Index Factor::turnOf(std::size_t part) const { return static_cast<Index>(6 * equations_->measured[part].cell + 3); }

SensorByForce Factor::couplingOf(Index part, std::size_t pose) const {
  const MeasuredCell& measured = equations_->measured[static_cast<std::size_t>(part)];
  return coupling(measured.T * equations_->phi[pose], measured.G);
}

SensorByForce Factor::deviationOf(const Deviation& deviation, std::size_t pose) const {
  return -deviation.excess * couplingOf(static_cast<Index>(deviation.part), pose);
}

Eigen::Matrix<double, kShared, 3> Factor::sharedOf(std::size_t pose) const {
  Eigen::Matrix<double, kShared, 3> product = Eigen::Matrix<double, kShared, 3>::Zero();
  for (int k = 0; k < 4 && equations_->readings[pose].usual; ++k) {
    product.middleRows<3>(3 * k) = equations_->phi[pose][k] * Eigen::Matrix3d::Identity();
  }
  return product;
}

void Factor::findMoving() {
  moving_.clear();
  for (std::size_t part = 0; part < equations_->measured.size(); ++part) {
    if (equations_->measured[part].moves) moving_.push_back(part);
  }
}

void Factor::invertPoses(double damping) {
  pose_inverse_.clear();
  for (std::size_t pose = 0; pose < equations_->phi.size(); ++pose) {
    Eigen::Matrix3d H = equations_->pose_information[pose];
    H.diagonal() += damping * equations_->diagonal_poses.segment<3>(static_cast<Index>(3 * pose));
    // A pose that nothing but priors speaks of is nearly singular; cofactors would lose all digits.
    pose_inverse_.emplace_back(H.llt().solve(Eigen::Matrix3d::Identity()));
  }
}

void Factor::findShared() {
  shared_.resize(kSensor * parts(), kShared);
  for (Index part = 0; part < parts(); ++part) {
    const MeasuredCell& measured = equations_->measured[static_cast<std::size_t>(part)];
    for (int k = 0; k < 4; ++k) {
      shared_.block<kSensor, 3>(kSensor * part, 3 * k) =
          -measured.usual_precision * coupling(measured.T.col(k), measured.G);
    }
  }
}

void Factor::subtractDeviations(MatrixXd& S) const {
  // A square of S that fast memory holds takes what all poses have for it, before the next.
  constexpr std::size_t kCellsOfSquare = 8;
  const auto cells = static_cast<std::size_t>(parts());
  const std::size_t poses = equations_->phi.size();
  std::vector<std::vector<Eigen::Vector4d>> r(poses);  // of the deviating readings, times their excess
  for (std::size_t pose = 0; pose < poses; ++pose) {
    for (const Deviation& deviation : equations_->readings[pose].deviating) {
      r[pose].emplace_back(deviation.excess * (equations_->measured[deviation.part].T * equations_->phi[pose]));
    }
  }
  // Of a pose those of a square's rows or columns; a pose's deviations are in the order of the cells.
  const auto within = [&](const std::vector<Deviation>& deviating, std::size_t from) {
    const auto first = std::ranges::lower_bound(deviating, from, {}, &Deviation::part);
    const auto last = std::ranges::lower_bound(first, deviating.end(), from + kCellsOfSquare, {}, &Deviation::part);
    return std::pair(static_cast<std::size_t>(first - deviating.begin()),
                     static_cast<std::size_t>(last - deviating.begin()));
  };
  for (std::size_t columns = 0; columns < cells; columns += kCellsOfSquare) {
    for (std::size_t rows = columns; rows < cells; rows += kCellsOfSquare) {
      for (std::size_t pose = 0; pose < poses; ++pose) {
        const std::vector<Deviation>& deviating = equations_->readings[pose].deviating;
        const auto [first_a, last_a] = within(deviating, rows);
        const auto [first_b, last_b] = within(deviating, columns);
        for (std::size_t b = first_b; b < last_b; ++b) {
          const Eigen::Matrix3d H_G = pose_inverse_[pose] * equations_->measured[deviating[b].part].G.transpose();
          for (std::size_t a = std::max(b, first_a); a < last_a; ++a) {
            // D_a H^-1 D_b^T = (r_a r_b^T) x (G_a H^-1 G_b^T)
            const Eigen::Matrix3d forces = equations_->measured[deviating[a].part].G * H_G;
            const Eigen::Matrix4d couple = r[pose][a] * r[pose][b].transpose();
            auto block = S.block<kSensor, kSensor>(kSensor * static_cast<Index>(deviating[a].part),
                                                   kSensor * static_cast<Index>(deviating[b].part));
            for (int j = 0; j < 3; ++j) {
              for (int i = 0; i < 3; ++i) block.block<4, 4>(4 * i, 4 * j) -= forces(i, j) * couple;
            }
          }
        }
      }
    }
  }
}

MatrixXd Factor::reducedInformation() const {
  Eigen::Matrix<double, kShared, kShared> middle = Eigen::Matrix<double, kShared, kShared>::Zero();
  MatrixXd mixed = MatrixXd::Zero(kSensor * parts(), kShared);
  MatrixXd S = MatrixXd::Zero(kSensor * parts(), kSensor * parts());
  for (std::size_t pose = 0; pose < equations_->phi.size(); ++pose) {
    const Eigen::Matrix<double, kShared, 3> phi = sharedOf(pose);
    const Eigen::Matrix<double, kShared, 3> phi_H = phi.lazyProduct(pose_inverse_[pose]);
    middle.noalias() += phi_H.lazyProduct(phi.transpose());
    for (const Deviation& deviation : equations_->readings[pose].deviating) {
      mixed.middleRows<kSensor>(kSensor * static_cast<Index>(deviation.part)).noalias() +=
          deviationOf(deviation, pose).lazyProduct(phi_H.transpose());
    }
  }
  subtractDeviations(S);
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

MatrixXd Factor::timesK(const MatrixXd& left) const {
  MatrixXd product(left.rows(), static_cast<Index>(3 * moving_.size()));
  for (std::size_t k = 0; k < moving_.size(); ++k) {
    product.middleCols<3>(static_cast<Index>(3 * k)).noalias() =
        left.middleCols<kSensor>(kSensor * static_cast<Index>(moving_[k])) * equations_->measured[moving_[k]].K;
  }
  return product;
}

MatrixXd Factor::transposedKTimes(const MatrixXd& right) const {
  MatrixXd product(static_cast<Index>(3 * moving_.size()), right.cols());
  for (std::size_t k = 0; k < moving_.size(); ++k) {
    product.middleRows<3>(static_cast<Index>(3 * k)).noalias() =
        equations_->measured[moving_[k]].K.transpose() *
        right.middleRows<kSensor>(kSensor * static_cast<Index>(moving_[k]));
  }
  return product;
}

MatrixXd Factor::matrixOfRest(double damping) const {
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

}  // namespace hexoderm::poses_first
