#include "hexoderm/solve/global/accelerometer_fit.h"
#include "tests/core/solve/global/joint_case.h"

#include "hexoderm/base/se3.h"
#include "hexoderm/base/units.h"
#include "hexoderm/solve/global/rigidity.h"
#include "tests/support/matchers.h"
#include "tests/support/testing.h"

namespace hexoderm {
namespace {

using Vector12d = Eigen::Matrix<double, 12, 1>;
using Matrix12d = Eigen::Matrix<double, 12, 12>;
using Matrix3x12d = Eigen::Matrix<double, 3, 12>;

constexpr double kSigma_g = 0.003;
const HuberLoss kQuadratic{std::numeric_limits<double>::infinity()};

using Draw = test::NormalDraw;

struct Sensor {
  Eigen::Vector3d offset_g = Eigen::Vector3d::Zero();
  Eigen::Matrix3d gain = Eigen::Matrix3d::Identity();
};

Sensor drawSensor(const Accelerometer& prior, Draw& draw) {
  Sensor sensor;
  sensor.offset_g = prior.offset_sigma_g.cwiseProduct(draw.vector());
  for (int i = 0; i < 3; ++i) {
    for (int j = 0; j < 3; ++j) {
      sensor.gain(i, j) += (i == j ? prior.scale_sigma : prior.cross_axis_sigma) * draw.normal();
    }
  }
  return sensor;
}

/// Specific forces and what a sensor reads of them.
struct Readings {
  std::vector<Eigen::Vector3d> v_g;
  std::vector<CellReading> of;

  void add(const Eigen::Vector3d& v, const Sensor& sensor, const Eigen::Vector3d& noise = Eigen::Vector3d::Zero(),
           double sigma = kSigma_g) {
    of.push_back({of.size(), sensor.gain * v + sensor.offset_g + noise, sigma * sigma});
    v_g.push_back(v);
  }
};

Readings drawReadings(const Sensor& sensor, std::size_t count, Draw& draw) {
  Readings readings;
  for (std::size_t k = 0; k < count; ++k) {
    const double sigma = kSigma_g * (1 + static_cast<double>(k % 3));
    const Eigen::Vector3d v = draw.direction();
    readings.add(v, sensor, sigma * draw.vector(), sigma);
  }
  return readings;
}

AccelerometerFit fit(const Accelerometer& accelerometer, const Readings& readings, const HuberLoss& loss = kQuadratic) {
  AccelerometerFit result;
  fitAccelerometer(AccelerometerPrior(accelerometer), readings.of, readings.v_g, loss, result);
  return result;
}

/// The cost and its derivatives from their definitions, for b and D together: b, then the rows of D.
struct DenseCost {
  const Accelerometer& prior;
  const Readings& readings;
  HuberLoss loss;

  [[nodiscard]] Vector12d priorPrecision() const {
    Vector12d precision;
    for (int k = 0; k < 12; ++k) {
      const bool on_diagonal = k == 3 || k == 7 || k == 11;
      const double sigma = k < 3 ? prior.offset_sigma_g[k] : (on_diagonal ? prior.scale_sigma : prior.cross_axis_sigma);
      precision[k] = 1 / (sigma * sigma);
    }
    return precision;
  }
  [[nodiscard]] static Matrix3x12d jacobian(const Eigen::Vector3d& v) {
    Matrix3x12d J = Matrix3x12d::Zero();
    J.leftCols<3>().setIdentity();
    for (int i = 0; i < 3; ++i) J.block<1, 3>(i, 3 + 3 * i) = v.transpose();
    return J;
  }
  [[nodiscard]] double at(const Vector12d& p) const {
    double twice = p.dot(priorPrecision().cwiseProduct(p));
    for (std::size_t k = 0; k < readings.of.size(); ++k) {
      const Eigen::Vector3d& v = readings.v_g[k];
      twice += loss.cost((readings.of[k].y_g - v - jacobian(v) * p).squaredNorm() / readings.of[k].variance_g2);
    }
    return twice / 2;
  }
  void derivatives(const Vector12d& p, Vector12d& gradient, Matrix12d& hessian) const {
    gradient = priorPrecision().cwiseProduct(p);
    hessian = priorPrecision().asDiagonal();
    for (std::size_t k = 0; k < readings.of.size(); ++k) {
      const Eigen::Vector3d& v = readings.v_g[k];
      const Matrix3x12d J = jacobian(v) / std::sqrt(readings.of[k].variance_g2);
      const Eigen::Vector3d r = (readings.of[k].y_g - v) / std::sqrt(readings.of[k].variance_g2) - J * p;
      const double weight = loss.weight(r.squaredNorm());
      Eigen::Matrix3d inner = weight * Eigen::Matrix3d::Identity();
      if (weight < 1) inner -= weight / r.squaredNorm() * r * r.transpose();
      gradient -= weight * J.transpose() * r;
      hessian += J.transpose() * inner * J;
    }
  }
  /// Newton's method with halved steps, until nothing moves.
  [[nodiscard]] Vector12d minimum() const {
    Vector12d p = Vector12d::Zero();
    for (int round = 0; round < 200; ++round) {
      Vector12d gradient;
      Matrix12d hessian;
      derivatives(p, gradient, hessian);
      Vector12d step = -hessian.ldlt().solve(gradient);
      while (at(p + step) > at(p) && step.norm() > 1e-16) step /= 2;
      p += step;
      if (step.norm() < 1e-15) break;
    }
    return p;
  }
};

Vector12d parametersOf(const AccelerometerFit& result) {
  Vector12d p;
  p.head<3>() = result.offset_g;
  for (int i = 0; i < 3; ++i) p.segment<3>(3 + 3 * i) = (result.gain - Eigen::Matrix3d::Identity()).row(i).transpose();
  return p;
}

TEST(AccelerometerFit, CostAndParametersAreThoseOfTheDenseLeastSquares) {
  Draw draw(2);
  const Accelerometer prior;
  for (const std::size_t count : {0U, 1U, 2U, 3U, 4U, 12U}) {
    const Readings readings = drawReadings(drawSensor(prior, draw), count, draw);
    const DenseCost dense{prior, readings, kQuadratic};
    const Vector12d p = dense.minimum();
    const AccelerometerFit result = fit(prior, readings);
    EXPECT_NEAR(result.cost, dense.at(p), 1e-10 * result.cost) << count << " readings";
    EXPECT_LT((parametersOf(result) - p).norm(), 1e-12) << count << " readings";
    EXPECT_NEAR(result.cost, dense.at(parametersOf(result)), 1e-10 * result.cost);
    for (std::size_t k = 0; k < count; ++k) {
      const Eigen::Vector3d left = readings.of[k].y_g - result.gain * readings.v_g[k] - result.offset_g;
      EXPECT_LT((left - result.residual_g[k]).norm(), 1e-15);
      EXPECT_NEAR(result.precision[k] * readings.of[k].variance_g2, 1, 1e-12);
    }
  }
}

TEST(AccelerometerFit, CovarianceIsTheInverseOfTheDenseInformation) {
  Draw draw(3);
  const Accelerometer prior;
  for (const HuberLoss& loss : {kQuadratic, HuberLoss{}}) {
    Readings readings = drawReadings(drawSensor(prior, draw), 6, draw);
    readings.of[2].y_g.x() += 0.3;  // an outlier, so that weights count
    const AccelerometerFit result = fit(prior, readings, loss);
    Matrix12d information = DenseCost{prior, readings, loss}.priorPrecision().asDiagonal();
    for (std::size_t k = 0; k < readings.of.size(); ++k) {
      const Matrix3x12d J = DenseCost::jacobian(readings.v_g[k]);
      information += result.precision[k] * J.transpose() * J;
    }
    const Matrix12d covariance = information.inverse();
    for (int axis = 0; axis < 3; ++axis) {
      const Eigen::Matrix4d& root = result.covariance_root[static_cast<std::size_t>(axis)];
      const int place[] = {axis, 3 + 3 * axis, 4 + 3 * axis, 5 + 3 * axis};
      const Eigen::Matrix4d expected = covariance(place, place);
      EXPECT_LT((root * root.transpose() - expected).norm(), 1e-6 * expected.norm()) << "axis " << axis;
    }
  }
}

TEST(AccelerometerFit, RobustRoundsReachTheMinimumOfTheHuberCost) {
  Draw draw(4);
  const Accelerometer prior;
  double worst_cost = 0;
  double worst_parameter = 0;
  for (int trial = 0; trial < 100; ++trial) {
    Readings readings = drawReadings(drawSensor(prior, draw), 3 + static_cast<std::size_t>(trial % 6), draw);
    // From none to three readings that are off by up to a right angle.
    for (int outlier = 0; outlier < trial % 4 && outlier < 3; ++outlier) {
      readings.of[static_cast<std::size_t>(outlier)].y_g += 0.05 * (1 + trial % 20) * draw.direction();
    }
    const HuberLoss loss;
    const DenseCost dense{prior, readings, loss};
    const Vector12d p = dense.minimum();
    const AccelerometerFit result = fit(prior, readings, loss);
    worst_cost = std::max(worst_cost, (result.cost - dense.at(p)) / dense.at(p));
    worst_parameter = std::max(worst_parameter, (parametersOf(result) - p).norm());
    EXPECT_GT(result.cost, dense.at(p) * (1 - 1e-9));
  }
  EXPECT_LT(worst_cost, 1e-9);
  EXPECT_LT(worst_parameter, 1e-5) << "g";
}

TEST(AccelerometerFit, WithoutReadingsIsAsUncertainAsThePrior) {
  const Accelerometer prior;
  EXPECT_NEAR(fit(prior, {}).covariance_root[0](0, 0), prior.offset_sigma_g.x(), 1e-12);
}

TEST(AccelerometerFit, SigmaOfZeroPinsTheParameter) {
  Draw draw(5);
  Accelerometer prior;
  const Readings readings = drawReadings(drawSensor(prior, draw), 8, draw);
  prior.offset_sigma_g.setZero();
  prior.cross_axis_sigma = 0;
  const AccelerometerFit result = fit(prior, readings);
  EXPECT_LT(result.offset_g.norm(), 1e-9);
  const Eigen::Matrix3d D = result.gain - Eigen::Matrix3d::Identity();
  EXPECT_LT((D - Eigen::Matrix3d(D.diagonal().asDiagonal())).norm(), 1e-9);
  EXPECT_GT(D.diagonal().norm(), 1e-4) << "the scales are still free";

  prior.scale_sigma = 0;
  const AccelerometerFit pinned = fit(prior, readings);
  double twice = 0;
  for (std::size_t k = 0; k < readings.of.size(); ++k) {
    twice += (readings.of[k].y_g - readings.v_g[k]).squaredNorm() / readings.of[k].variance_g2;
  }
  EXPECT_NEAR(pinned.cost, twice / 2, 1e-6 * twice);
}

/// A cell whose sensor and noise are drawn from the model, and which lies a little off from where it is thought to.
Readings drawTurnedCell(const Accelerometer& prior, const std::vector<Eigen::Vector3d>& forces, Draw& draw) {
  const Sensor sensor = drawSensor(prior, draw);
  const Eigen::Matrix3d turn = expSO3(1 * kDegree * draw.vector());
  Readings readings;
  for (const Eigen::Vector3d& v : forces) {
    readings.add(v, {sensor.offset_g, sensor.gain * turn}, kSigma_g * draw.vector());
  }
  return readings;
}

/// Mean and standard deviation.
std::pair<double, double> spreadOf(const Eigen::ArrayXd& values) {
  return {values.mean(), std::sqrt((values - values.mean()).square().mean())};
}

TEST(Rigidity, ChiSquaredOfTheModelsOwnDataHasItsDegreesOfFreedom) {
  constexpr Eigen::Index kTrials = 2000;
  const Accelerometer prior;
  Draw draw(6);
  for (const std::size_t poses : {2U, 3U, 4U, 6U, 10U}) {
    Eigen::ArrayXd chi_squared(kTrials);
    Eigen::ArrayXd deviates(kTrials);
    const double degrees = 3 * static_cast<double>(poses) - 3;
    for (Eigen::Index trial = 0; trial < kTrials; ++trial) {
      std::vector<Eigen::Vector3d> forces = {draw.direction()};
      // Directions 30 degrees and more apart: nearly parallel ones leave a turn undetermined, and a degree more.
      while (forces.size() < poses) {
        const Eigen::Vector3d next = draw.direction();
        if (std::abs(next.dot(forces.front())) < 0.85) forces.push_back(next);
      }
      const Readings readings = drawTurnedCell(prior, forces, draw);
      const Misfit misfit = testRigidity(AccelerometerPrior(prior), readings.of, readings.v_g);
      EXPECT_EQ(misfit.degrees, degrees);
      chi_squared[trial] = misfit.chi_squared;
      deviates[trial] = misfit.deviate();
    }
    const auto [mean, sigma] = spreadOf(chi_squared);
    EXPECT_NEAR(mean, degrees, 5 * std::sqrt(2 * degrees / kTrials)) << poses << " poses";
    EXPECT_NEAR(sigma, std::sqrt(2 * degrees), 0.1 * std::sqrt(2 * degrees)) << poses << " poses";
    const auto [deviate_mean, deviate_sigma] = spreadOf(deviates);
    EXPECT_NEAR(deviate_mean, 0, 0.12) << poses << " poses";
    EXPECT_NEAR(deviate_sigma, 1, 0.1) << poses << " poses";
  }
}

TEST(Rigidity, AReadingTakenAwayIsAsIfItHadNeverBeen) {
  const Accelerometer prior;
  Draw draw(8);
  std::vector<Eigen::Vector3d> forces;
  for (int k = 0; k < 500; ++k) forces.push_back(draw.direction());
  const Readings readings = drawTurnedCell(prior, forces, draw);
  ReadingSums all;
  for (std::size_t k = 0; k < forces.size(); ++k) all.add(readings.of[k], readings.v_g[k]);
  for (const std::size_t left_out : {0U, 77U, 499U}) {
    ReadingSums others = all;
    others.add(readings.of[left_out], readings.v_g[left_out], -1);
    ReadingSums expected;
    for (std::size_t k = 0; k < forces.size(); ++k) {
      if (k != left_out) expected.add(readings.of[k], readings.v_g[k]);
    }
    const Misfit left = testRigidity(AccelerometerPrior(prior), others);
    const Misfit never = testRigidity(AccelerometerPrior(prior), expected);
    EXPECT_EQ(left.degrees, never.degrees);
    EXPECT_NEAR(left.chi_squared, never.chi_squared, 1e-6 * never.chi_squared);
  }
}

/// The definition: the fit's cost, less what a small turn gains.
TEST(Rigidity, IsWhatTheFitLeavesLessWhatATurnGains) {
  const Accelerometer prior;
  Draw draw(9);
  for (const std::size_t poses : {2U, 3U, 6U, 40U}) {
    std::vector<Eigen::Vector3d> forces;
    for (std::size_t k = 0; k < poses; ++k) forces.push_back(draw.direction());
    const Readings readings = drawTurnedCell(prior, forces, draw);
    AccelerometerFit fit;
    fitAccelerometer(AccelerometerPrior(prior), readings.of, readings.v_g, kQuadratic, fit);
    Eigen::Vector3d gradient = Eigen::Vector3d::Zero();
    for (std::size_t k = 0; k < poses; ++k) {
      gradient += fit.precision[k] * (fit.gain * skew(readings.v_g[k])).transpose() * fit.residual_g[k];
    }
    Eigen::Matrix3d information = attitudeInformation(fit, readings.v_g);
    information.diagonal().array() += 1e-6;
    const double expected = 2 * fit.cost - gradient.dot(information.ldlt().solve(gradient));
    const Misfit misfit = testRigidity(AccelerometerPrior(prior), readings.of, readings.v_g);
    EXPECT_NEAR(misfit.chi_squared, expected, 1e-7 * (1 + expected)) << poses << " poses";
  }
}

TEST(Rigidity, SaysNothingWithFewerThanTwoReadings) {
  const Accelerometer prior;
  Readings readings;
  EXPECT_EQ(testRigidity(AccelerometerPrior(prior), readings.of, readings.v_g).deviate(), 0);
  readings.add(Eigen::Vector3d::UnitZ(), {});
  EXPECT_EQ(testRigidity(AccelerometerPrior(prior), readings.of, readings.v_g).deviate(), 0);
  readings.add(Eigen::Vector3d::UnitZ(), {});
  const Misfit parallel = testRigidity(AccelerometerPrior(prior), readings.of, readings.v_g);
  EXPECT_NEAR(parallel.chi_squared, 0, 1e-9);
  EXPECT_TRUE(std::isfinite(parallel.deviate()));
}

TEST(FindAttitude, FindsWhereTheErrorsOfTheSensorExplainTheReadingsBest) {
  const Accelerometer prior;
  Draw draw(12);
  for (const std::size_t poses : {6U, 20U}) {
    for (int trial = 0; trial < 30; ++trial) {
      std::vector<Eigen::Vector3d> f_o(poses);
      for (Eigen::Vector3d& f : f_o) f = draw.direction();
      const Readings readings = drawTurnedCell(prior, f_o, draw);
      const auto chiSquaredAt = [&](const Eigen::Matrix3d& R) {
        std::vector<Eigen::Vector3d> v_g;
        for (const Eigen::Vector3d& f : f_o) v_g.emplace_back(R.transpose() * f);
        return 2 * fit(prior, {v_g, readings.of}).cost;
      };
      const OwnAttitude own =
          findAttitude(AccelerometerPrior(prior), readings.of, f_o, expSO3(0.1 * draw.vector()), 50);
      EXPECT_LT((own.R.transpose() * own.R - Eigen::Matrix3d::Identity()).norm(), 1e-13);
      const double least = chiSquaredAt(own.R);
      for (int axis = 0; axis < 3; ++axis) {
        const Eigen::Vector3d turn = 1e-3 * Eigen::Vector3d::Unit(axis);
        const double rise = (chiSquaredAt(own.R * expSO3(turn)) + chiSquaredAt(own.R * expSO3(-turn))) / 2 - least;
        EXPECT_GT(rise, 0) << poses << " poses";
        if (poses < 20) continue;  // with few the model is linear in a smaller turn only
        EXPECT_NEAR(rise, turn.dot(own.information * turn), 0.2 * turn.dot(own.information * turn));
      }
    }
  }
}

TEST(FindAttitude, DoesNotTurnAboutTheOnlyDirectionThereIs) {
  const Accelerometer prior;
  Draw draw(13);
  const std::vector<Eigen::Vector3d> f_o = {draw.direction()};
  const Readings readings = drawTurnedCell(prior, f_o, draw);
  const OwnAttitude own = findAttitude(AccelerometerPrior(prior), readings.of, f_o, Eigen::Matrix3d::Identity());
  const Eigen::Vector3d v = own.R.transpose() * f_o[0];
  EXPECT_NEAR(v.dot(logSO3(own.R)), 0, 0.01);
  EXPECT_LT(v.dot(own.information * v), 1e-3 * own.information.norm());
}

}  // namespace
}  // namespace hexoderm
