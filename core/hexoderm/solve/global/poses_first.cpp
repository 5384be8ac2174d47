#include "hexoderm/solve/global/poses_first.h"

#include "hexoderm/solve/global/poses_first_factor.h"

#include <cassert>
#include <cmath>
#include <mutex>
#include <stdexcept>
#include <utility>

namespace hexoderm {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

class PosesFirstCovariance : public GlobalCovariance {
 public:
  explicit PosesFirstCovariance(std::shared_ptr<const poses_first::Factor> factor)
      : origin_(factor->origin()), estimates_gap_share_(factor->estimatesGapShare()), factor_(std::move(factor)) {}

  [[nodiscard]] const Matrix6d& cell(std::size_t cell) const override { return parts().cells[cell]; }
  [[nodiscard]] const Matrix6d& link(std::size_t link) const override { return parts().links[link]; }
  [[nodiscard]] Matrix6d between(std::size_t a, std::size_t b) const override { return blockOf(parts().rest, a, b); }
  [[nodiscard]] MatrixXd timesCells(MatrixXd B) const override {
    B.middleRows<6>(static_cast<Index>(6 * origin_)).setZero();
    MatrixXd product = parts().rest.topLeftCorner(B.rows(), B.rows()) * B;
    product.middleRows<6>(static_cast<Index>(6 * origin_)).setZero();
    return product;
  }
  [[nodiscard]] Eigen::Matrix3d force(std::size_t pose) const override { return parts().forces[pose]; }
  [[nodiscard]] Eigen::Matrix3d forces(std::size_t a, std::size_t b) const override {
    return a == b ? force(a) : factor_->forces(parts().C, a, b);
  }
  [[nodiscard]] Eigen::Matrix3d acceleration(std::size_t) const override {
    throw std::logic_error("no acceleration was estimated");
  }
  [[nodiscard]] double gapShareSigma() const override {
    const MatrixXd& rest = parts().rest;
    return estimates_gap_share_ ? std::sqrt(rest(rest.rows() - 1, rest.cols() - 1)) : 0;
  }

 private:
  struct Parts {
    MatrixXd rest;
    std::vector<Matrix6d> cells;
    std::vector<Matrix6d> links;
    MatrixXd C;  ///< of the sensors' and turns' errors
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
    for (const poses_first::LinkEnds& link : factor_->links())
      parts.links.push_back(blockOf(parts.rest, link.c, link.n));
    parts.C = factor_->sensorCovariance();
    parts.forces = factor_->forceOfEachPose(parts.C);
    return parts;
  }

  std::size_t origin_;
  bool estimates_gap_share_;
  mutable std::once_flag computed_;
  std::shared_ptr<const poses_first::Factor> factor_;
  mutable Parts parts_;
};

class PosesFirst : public GlobalSystem {
 public:
  double linearize(const GlobalProblem& problem, const GlobalState& candidate) override {
    assert(!problem.accelerations);
    if (factor_ == nullptr) factor_ = std::make_shared<poses_first::Factor>(problem);
    next_ = std::make_shared<const poses_first::Equations>(poses_first::linearize(problem, candidate));
    return next_->rest.cost;
  }
  void accept() override { equations_ = std::move(next_); }
  bool factorize(double damping) override { return factor_->factorize(equations_, damping); }
  double step(VectorXd& cells, VectorXd& border) const override { return factor_->step(*equations_, cells, border); }
  std::shared_ptr<const GlobalCovariance> inverse() override {
    return std::make_shared<PosesFirstCovariance>(std::exchange(factor_, nullptr));
  }
  void releaseWorkspace() override {}

 private:
  std::shared_ptr<poses_first::Factor> factor_;
  std::shared_ptr<const poses_first::Equations> equations_;
  std::shared_ptr<const poses_first::Equations> next_;
};

}  // namespace

std::unique_ptr<GlobalSystem> makePosesFirst() { return std::make_unique<PosesFirst>(); }

double workOfPosesFirst(const GlobalProblem& problem) {
  // Two dense matrices are factorised, of twelve errors of a sensor and of six unknowns of a cell, and the first one
  // takes out the turns. A pose costs 60 for every pair of cells.
  const auto cells = static_cast<double>(problem.cellCount());
  const double sensors = 12 * cells;
  const double rest = 6 * cells + 1;
  constexpr double kPerPair = 60;
  return sensors * sensors * sensors / 6 + sensors * sensors * 3 * cells / 2 + rest * rest * rest / 6 +
         kPerPair * cells * cells / 2 * static_cast<double>(problem.poses);
}

}  // namespace hexoderm
