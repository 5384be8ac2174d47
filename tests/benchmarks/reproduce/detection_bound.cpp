#include "tests/benchmarks/reproduce/detection_bound.h"

#include "hexoderm/base/units.h"

#include <Eigen/Cholesky>
#include <algorithm>
#include <boost/math/distributions/chi_squared.hpp>
#include <boost/math/distributions/non_central_chi_squared.hpp>
#include <boost/math/distributions/normal.hpp>
#include <cmath>
#include <optional>

namespace hexoderm::cli {
namespace {

constexpr double kFalseAlarms = 0.002;
constexpr double kSamples = 100;  // simulateSession()
constexpr double kTremor_g = 0.003;
constexpr double kUnknown = 3;  // deviation of what nothing is known of: a direction of gravity, rad or g
constexpr double kNorm_g = 0.003;

std::size_t indexOf(const SimulatedSkin& skin, CellId cell) {
  return static_cast<std::size_t>(std::ranges::find(skin.truth(), cell, &TrueCell::id) - skin.truth().begin());
}

/// The readings of all cells, pose by pose for each, and how they depend on what the test does not know, each in units
/// of its deviation.
class Readings {
 public:
  Readings(const SimulatedSkin& skin, std::size_t poses)
      : skin_(skin), ups_(scriptedUpDirections(poses)), attitudes_(attitudes()) {}

  [[nodiscard]] Eigen::VectorXd change(const CellFault& fault) const {
    Eigen::VectorXd change = Eigen::VectorXd::Zero(size());
    const std::size_t cell = indexOf(skin_, fault.cell);
    if (fault.kind == SkinFault::Swapped) {
      const std::size_t other = indexOf(skin_, linksOf(skin_, fault.cell).front().cell);
      for (std::size_t p = 0; p < ups_.size(); ++p) {
        change.segment<3>(row(cell, p)) = ideal(other, p) - ideal(cell, p);
        change.segment<3>(row(other, p)) = ideal(cell, p) - ideal(other, p);
      }
      return change;
    }
    const std::size_t from = fault.kind == SkinFault::Reglued ? skin_.options().reglued_before : 0;
    for (std::size_t p = from; p < ups_.size(); ++p) {
      change.segment<3>(row(cell, p)) = skin_.turnOf(fault.cell).transpose() * ideal(cell, p) - ideal(cell, p);
    }
    return change;
  }

  [[nodiscard]] Eigen::MatrixXd covariance() const {
    const Accelerometer& a = skin_.model().accelerometer;
    const double noise_g2 =
        kTremor_g * kTremor_g +
        (a.noise_g_per_sqrt_hz * a.noise_g_per_sqrt_hz * a.rate_hz / 2 + a.lsb_g * a.lsb_g / 12) / kSamples;
    const Eigen::MatrixXd shared = byGravity();
    Eigen::MatrixXd covariance = shared * shared.transpose();
    covariance.diagonal().array() += noise_g2;
    const Eigen::MatrixXd turned = byAttitude();
    covariance += turned * turned.transpose();
    for (std::size_t cell = 0; cell < attitudes_.size(); ++cell) {
      for (std::size_t p = 0; p < ups_.size(); ++p) {
        for (std::size_t q = 0; q < ups_.size(); ++q) {
          covariance.block<3, 3>(row(cell, p), row(cell, q)) += ofSensor(a, ideal(cell, p), ideal(cell, q));
        }
      }
    }
    return covariance;
  }

 private:
  [[nodiscard]] Eigen::Index size() const { return row(skin_.truth().size(), 0); }
  [[nodiscard]] Eigen::Index row(std::size_t cell, std::size_t pose) const {
    return static_cast<Eigen::Index>(3 * (cell * ups_.size() + pose));
  }
  [[nodiscard]] Eigen::Vector3d ideal(std::size_t cell, std::size_t pose) const {
    return skin_.truth()[cell].T_b_u.R.transpose() * ups_[pose];
  }

  static Eigen::Matrix3d ofSensor(const Accelerometer& a, const Eigen::Vector3d& v, const Eigen::Vector3d& w) {
    const double cross = a.cross_axis_sigma * a.cross_axis_sigma;
    Eigen::Matrix3d block = (cross * v.dot(w) + std::pow(a.largestOffsetSigma_g(), 2)) * Eigen::Matrix3d::Identity();
    block.diagonal() += (a.scale_sigma * a.scale_sigma - cross) * v.cwiseProduct(w);
    return block;
  }

  /// Of a force that may be turned freely and is 1 g long but for a hand's motion.
  [[nodiscard]] Eigen::MatrixXd byGravity() const {
    Eigen::MatrixXd of_force = Eigen::MatrixXd::Zero(size(), static_cast<Eigen::Index>(3 * ups_.size()));
    for (std::size_t p = 0; p < ups_.size(); ++p) {
      const Eigen::Matrix3d along = ups_[p] * ups_[p].transpose();
      const Eigen::Matrix3d free = kUnknown * (Eigen::Matrix3d::Identity() - along) + kNorm_g * along;
      for (std::size_t cell = 0; cell < skin_.truth().size(); ++cell) {
        of_force.block<3, 3>(row(cell, p), static_cast<Eigen::Index>(3 * p)) =
            skin_.truth()[cell].T_b_u.R.transpose() * free;
      }
    }
    return of_force;
  }

  [[nodiscard]] Eigen::MatrixXd byAttitude() const {
    Eigen::MatrixXd turned(size(), attitudes_.front().cols());
    for (std::size_t cell = 0; cell < attitudes_.size(); ++cell) {
      for (std::size_t p = 0; p < ups_.size(); ++p) {
        turned.middleRows<3>(row(cell, p)) = skew(ideal(cell, p)) * attitudes_[cell];
      }
    }
    return turned;
  }

  /// Errors of the cells' attitudes, each in its own frame, by the angles of all links on the way from the first cell.
  [[nodiscard]] std::vector<Eigen::MatrixXd> attitudes() const {
    const CellModel& model = skin_.model();
    const Eigen::Vector3d sigmas_rad(model.twist_sigma_rad, model.bend_sigma_rad, model.yaw_sigma_rad);
    const std::vector<TrueCell>& cells = skin_.truth();
    const auto columns = static_cast<Eigen::Index>(3 * (cells.size() - 1));
    std::vector<std::optional<Eigen::MatrixXd>> known(cells.size());
    known.front() = Eigen::MatrixXd::Zero(3, columns);
    std::vector<std::size_t> order = {0};
    Eigen::Index link = 0;
    for (std::size_t next = 0; next < order.size(); ++next) {
      const std::size_t cell = order[next];
      for (const NeighborReport& report : linksOf(skin_, cells[cell].id)) {
        const std::size_t other = indexOf(skin_, report.cell);
        if (known[other]) continue;
        Eigen::MatrixXd error = *known[cell];
        error.middleCols<3>(3 * link++) += linkAxes(model.port(report.port)) * sigmas_rad.asDiagonal();
        known[other] = cells[other].T_b_u.R.transpose() * cells[cell].T_b_u.R * error;
        order.push_back(other);
      }
    }
    std::vector<Eigen::MatrixXd> all;
    for (const auto& of_cell : known) all.push_back(of_cell.value());
    return all;
  }

  const SimulatedSkin& skin_;
  std::vector<Eigen::Vector3d> ups_;
  std::vector<Eigen::MatrixXd> attitudes_;  ///< 3 x links per cell
};

/// Phi(e - z), in percent, with z exceeded with the given probability.
double percentBeyond(double e, double probability) {
  const boost::math::normal normal;
  return 100 * cdf(normal, e - quantile(complement(normal, probability)));
}

/// The probability, in percent, that a plane normal vector about (e, 0) is longer than one about 0 is with the given
/// probability.
double percentBeyondInPlane(double e, double probability) {
  const double limit = quantile(complement(boost::math::chi_squared(2), probability));
  return 100 * cdf(complement(boost::math::non_central_chi_squared(2, e * e), limit));
}
}  // namespace

double bestDetection(double deviations, std::size_t places) {
  return percentBeyond(deviations, kFalseAlarms / static_cast<double>(places));
}

BestDetection bestDetection(const SimulatedSkin& skin, const CellFault& fault, std::size_t poses) {
  const Readings readings(skin, poses);
  const Eigen::VectorXd change = readings.change(fault);
  const double e = std::sqrt(change.dot(readings.covariance().ldlt().solve(change)));
  const double each = kFalseAlarms / static_cast<double>(skin.truth().size());
  return {percentBeyond(e, kFalseAlarms),
          fault.kind == SkinFault::Reglued ? percentBeyondInPlane(e, each) : percentBeyond(e, each)};
}

}  // namespace hexoderm::cli
