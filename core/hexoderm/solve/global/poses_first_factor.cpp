#include "hexoderm/solve/global/poses_first_factor.h"

#include <array>
#include <utility>

namespace hexoderm::poses_first {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

namespace {

// phi phi^T x H, both symmetric: entry 6 k + l is the k-th of phi phi^T's upper half times the l-th of H's.
constexpr Index kCouple = 60;
using Couple = Eigen::Matrix<double, kCouple, 1>;
using SensorBySensor = Eigen::Matrix<double, kSensor, kSensor>;

/// Runs over the upper half of a symmetric matrix, row by row.
template <int Size, typename Visit>
void forUpperHalf(Visit visit) {
  Index at = 0;
  for (Index i = 0; i < Size; ++i) {
    for (Index j = i; j < Size; ++j, ++at) visit(at, i, j);
  }
}

Couple coupleOf(const Eigen::Vector4d& phi, const Eigen::Matrix3d& H) {
  Couple couple;
  forUpperHalf<4>([&](Index k, Index m, Index n) {
    forUpperHalf<3>([&](Index l, Index u, Index v) { couple[6 * k + l] = phi[m] * phi[n] * H(u, v); });
  });
  return couple;
}

/// (T_a x G_a) couple (T_b x G_b)^T, in the order of t: per axis of the sensor its offset and gains.
SensorBySensor unfoldCouple(const MeasuredCell& a, const Couple& couple, const MeasuredCell& b) {
  std::array<Eigen::Matrix4d, 9> turned;  // per axes of two forces; T_a couple T_b^T
  forUpperHalf<3>([&](Index l, Index u, Index v) {
    Eigen::Matrix4d of_phi;
    forUpperHalf<4>([&](Index k, Index m, Index n) { of_phi(m, n) = of_phi(n, m) = couple[6 * k + l]; });
    const Eigen::Matrix4d product = a.T * of_phi * b.T.transpose();
    turned[static_cast<std::size_t>(3 * u + v)] = turned[static_cast<std::size_t>(3 * v + u)] = product;
  });
  SensorBySensor unfolded = SensorBySensor::Zero();
  for (Index u = 0; u < 3; ++u) {
    for (Index j = 0; j < 3; ++j) {
      Eigen::Matrix4d by_G = Eigen::Matrix4d::Zero();
      for (Index v = 0; v < 3; ++v) by_G += b.G(j, v) * turned[static_cast<std::size_t>(3 * u + v)];
      for (Index i = 0; i < 3; ++i) unfolded.block<4, 4>(4 * i, 4 * j) += a.G(i, u) * by_G;
    }
  }
  return unfolded;
}

/// Q = (T_a x G_a)^T C (T_b x G_b) with its transposed, as far as a couple's product with it shows it.
Couple foldCouple(const MeasuredCell& a, const SensorBySensor& C, const MeasuredCell& b) {
  std::array<Eigen::Matrix4d, 9> of_forces;
  of_forces.fill(Eigen::Matrix4d::Zero());
  for (Index i = 0; i < 3; ++i) {
    for (Index v = 0; v < 3; ++v) {
      Eigen::Matrix4d by_G = Eigen::Matrix4d::Zero();
      for (Index j = 0; j < 3; ++j) by_G += b.G(j, v) * C.block<4, 4>(4 * i, 4 * j);
      for (Index u = 0; u < 3; ++u) of_forces[static_cast<std::size_t>(3 * u + v)] += a.G(i, u) * by_G;
    }
  }
  Couple folded;
  forUpperHalf<3>([&](Index l, Index u, Index v) {
    // Of the transposed Q, the element of v and u.
    const Eigen::Matrix4d both =
        a.T.transpose() *
        (of_forces[static_cast<std::size_t>(3 * u + v)] + of_forces[static_cast<std::size_t>(3 * v + u)]) * b.T;
    forUpperHalf<4>(
        [&](Index k, Index m, Index n) { folded[6 * k + l] = (both(m, n) + both(n, m)) / (m == n ? 2 : 1); });
  });
  return folded;
}

/// (phi x I)^T folded (phi x I).
Eigen::Matrix3d contractWith(const Eigen::Vector4d& phi, const Couple& folded) {
  Eigen::Matrix3d contracted = Eigen::Matrix3d::Zero();
  forUpperHalf<4>([&](Index k, Index m, Index n) {
    forUpperHalf<3>([&](Index l, Index u, Index v) { contracted(u, v) += phi[m] * phi[n] * folded[6 * k + l]; });
  });
  contracted.triangularView<Eigen::StrictlyLower>() = contracted.transpose();
  return contracted;
}

}  // namespace

Factor::Factor(const GlobalProblem& problem)
    : origin_(problem.origin), cells_(problem.cellCount()), estimates_gap_share_(problem.gap.sigma.has_value()) {
  for (const GlobalLink& link : problem.links) links_.push_back({link.c, link.n});
  const AccelerometerPrior prior(problem.model->accelerometer);
  for (int axis = 0; axis < 3; ++axis) prior_.segment<4>(4 * axis) = prior.precision(axis);
}

bool Factor::factorize(std::shared_ptr<const Equations> equations, double damping) {
  equations_ = std::move(equations);
  findMoving();
  invertPoses(damping);
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
  MatrixXd push(12, static_cast<Index>(poses));  // phi_p x H_p^-1 g_p, as a matrix of 4 x 3
  for (std::size_t pose = 0; pose < poses; ++pose) {
    const Eigen::Vector3d g = pose_inverse_[pose] * at.gradient_poses.segment<3>(static_cast<Index>(3 * pose));
    const Eigen::Matrix<double, 4, 3> couple = equations_->phi[pose] * g.transpose();
    push.col(static_cast<Index>(pose)) = couple.reshaped();
  }
  const MatrixXd pushed = push * equations_->precision.transpose();
  VectorXd moved_to_t(kSensor * parts());
  for (Index part = 0; part < parts(); ++part) {
    const Eigen::Matrix<double, 4, 3> in_cell =
        measured(part).T * pushed.col(part).reshaped(4, 3) * measured(part).G.transpose();
    moved_to_t.segment<kSensor>(kSensor * part) = in_cell.reshaped();
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
  // U_p^T e is linear in phi_p.
  MatrixXd pulled(12, parts());
  for (Index part = 0; part < parts(); ++part) {
    const Eigen::Matrix<double, 4, 3> of_cell =
        measured(part).T.transpose() * e.segment<kSensor>(kSensor * part).reshaped(4, 3) * measured(part).G;
    pulled.col(part) = of_cell.reshaped();
  }
  const MatrixXd pull = pulled * equations_->precision;
  for (std::size_t pose = 0; pose < poses; ++pose) {
    const auto column = static_cast<Index>(pose);
    const Eigen::Vector3d gradient =
        at.gradient_poses.segment<3>(3 * column) - pull.col(column).reshaped(4, 3).transpose() * equations_->phi[pose];
    border.segment<3>(3 * column) = -pose_inverse_[pose] * gradient;
  }
  return -(at.rest.gradient_cells.dot(cells) + at.gradient_poses.dot(border.head(at.gradient_poses.size())) +
           at.rest.gradient_border.dot(border.tail(at.rest.gradient_border.size()))) /
         2;
}

MatrixXd Factor::sensorCovariance() const {
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
  MatrixXd C = MatrixXd::Zero(root.cols(), root.cols());
  C.selfadjointView<Eigen::Lower>().rankUpdate(root.transpose());
  C.selfadjointView<Eigen::Lower>().rankUpdate(across.transpose());
  C.triangularView<Eigen::StrictlyUpper>() = C.transpose();
  return C;
}

std::vector<Eigen::Matrix3d> Factor::forceOfEachPose(const MatrixXd& C) const {
  // U_p^T C U_p = sum_ab w_ap w_bp (phi_p x I)^T Q_ab (phi_p x I), with Q_ab = (T_a x G_a)^T C_ab (T_b x G_b).
  MatrixXd seen = MatrixXd::Zero(kCouple, static_cast<Index>(pose_inverse_.size()));
  for (Index b = 0; b < parts(); ++b) {
    MatrixXd Q(kCouple, parts() - b);
    for (Index a = b; a < parts(); ++a) {
      Q.col(a - b) = foldCouple(measured(a), C.block<kSensor, kSensor>(kSensor * a, kSensor * b), measured(b));
      // The pair the other way round is the transposed.
      if (a == b) Q.col(0) /= 2;
    }
    seen.noalias() += Q * precisionsOfPairs(b);
  }
  std::vector<Eigen::Matrix3d> forces;
  for (std::size_t pose = 0; pose < pose_inverse_.size(); ++pose) {
    const Eigen::Matrix3d of_t = contractWith(equations_->phi[pose], seen.col(static_cast<Index>(pose)));
    forces.emplace_back(pose_inverse_[pose] + pose_inverse_[pose] * of_t * pose_inverse_[pose]);
  }
  return forces;
}

Eigen::Matrix3d Factor::forces(const MatrixXd& C, std::size_t p, std::size_t q) const {
  return pose_inverse_[p] * (couplingOf(p).transpose() * (C * couplingOf(q))) * pose_inverse_[q];
}

Index Factor::turnOf(std::size_t part) const { return static_cast<Index>(6 * equations_->measured[part].cell + 3); }

MatrixXd Factor::couplingOf(std::size_t pose) const {
  MatrixXd U(kSensor * parts(), 3);
  for (Index part = 0; part < parts(); ++part) {
    const Eigen::Vector4d wr =
        -equations_->precision(part, static_cast<Index>(pose)) * (measured(part).T * equations_->phi[pose]);
    for (int axis = 0; axis < 3; ++axis) {
      U.middleRows<4>(kSensor * part + 4 * axis).noalias() = wr * measured(part).G.row(axis);
    }
  }
  return U;
}

/// w_ap w_bp of the cells from b on, per pose.
MatrixXd Factor::precisionsOfPairs(Index b) const {
  const MatrixXd& w = equations_->precision;
  return w.bottomRows(w.rows() - b).array().rowwise() * w.row(b).array();
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

MatrixXd Factor::reducedInformation() const {
  MatrixXd couples(static_cast<Index>(pose_inverse_.size()), kCouple);
  for (std::size_t pose = 0; pose < pose_inverse_.size(); ++pose) {
    couples.row(static_cast<Index>(pose)) = coupleOf(equations_->phi[pose], pose_inverse_[pose]).transpose();
  }
  MatrixXd S = MatrixXd::Zero(kSensor * parts(), kSensor * parts());
  for (Index b = 0; b < parts(); ++b) {
    const MatrixXd sums = precisionsOfPairs(b) * couples;
    for (Index a = b; a < parts(); ++a) {
      S.block<kSensor, kSensor>(kSensor * a, kSensor * b) =
          -unfoldCouple(measured(a), sums.row(a - b).transpose(), measured(b));
    }
    for (int axis = 0; axis < 3; ++axis) {
      S.block<4, 4>(kSensor * b + 4 * axis, kSensor * b + 4 * axis) += measured(b).information;
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
