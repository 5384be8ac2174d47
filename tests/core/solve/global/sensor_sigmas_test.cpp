// The statistics alone, with made-up evidence; what sessions make of it is tested in sensor_statistics_test.

#include "hexoderm/solve/global/sensor_sigmas.h"

#include "tests/support/normal_draw.h"
#include "tests/support/testing.h"

#include <Eigen/Cholesky>
#include <Eigen/LU>

namespace hexoderm {
namespace {

using test::NormalDraw;

Eigen::MatrixXd drawMatrix(NormalDraw& draw, Eigen::Index rows, Eigen::Index cols = 1) {
  return Eigen::MatrixXd::NullaryExpr(rows, cols, [&] { return draw.normal(); });
}

/// `offset_g`: of all of it.
Accelerometer accelerometer(double offset_g, double shared_g, double scale, double cross_axis) {
  Accelerometer result;
  result.offset_sigma_g.setConstant(std::sqrt(offset_g * offset_g - shared_g * shared_g));
  result.offset_shared_sigma_g = shared_g;
  result.scale_sigma = scale;
  result.cross_axis_sigma = cross_axis;
  return result;
}

/// Errors of so many sensors of one lot.
Eigen::VectorXd drawErrors(const Accelerometer& sigmas, std::size_t sensors, const Eigen::Vector3d& lot_g,
                           double lot_scale, NormalDraw& draw) {
  const Eigen::VectorXd prior = priorVariances(sigmas, sensors);
  Eigen::VectorXd errors = prior.cwiseSqrt().cwiseProduct(drawMatrix(draw, prior.size()));
  for (Eigen::Index k = 0; k < errors.size(); ++k) {
    if (kindOfParameter(k) == SensorError::Offset) errors[k] += lot_g[(k % kSensorParameters) / 4];
    if (kindOfParameter(k) == SensorError::Scale) errors[k] += lot_scale;
  }
  return errors;
}

SensorEvidence seen(const Eigen::MatrixXd& information, const Eigen::VectorXd& errors, NormalDraw& draw) {
  const Eigen::LLT<Eigen::MatrixXd> factor(information);
  const Eigen::VectorXd noise = factor.matrixL() * drawMatrix(draw, errors.size());
  return {information, information * errors + noise};
}

/// As of readings of which each says something about several errors of neighbouring sensors, of 3 mg each.
Eigen::MatrixXd mixedInformation(Eigen::Index parameters, NormalDraw& draw) {
  const Eigen::MatrixXd rows =
      drawMatrix(draw, 2 * parameters, parameters) / std::sqrt(2.0 * static_cast<double>(parameters));
  return (rows.transpose() * rows + 0.01 * Eigen::MatrixXd::Identity(parameters, parameters)) / std::pow(0.003, 2);
}

TEST(SensorEvidence, WeighingIsTheInverseOfTheErrorsCovariance) {
  for (const std::size_t sensors : {1U, 2U}) {  // they are computed in different ways
    NormalDraw draw(1);
    const Eigen::VectorXd prior = priorVariances(accelerometer(0.06, 0, 0.02, 0.005), sensors);
    const Eigen::MatrixXd M = mixedInformation(prior.size(), draw);
    const SensorEvidence evidence{M, drawMatrix(draw, prior.size())};
    const WeighedEvidence weighed = weigh(evidence, prior);
    const Eigen::MatrixXd expected = (Eigen::MatrixXd(M.inverse()) + Eigen::MatrixXd(prior.asDiagonal())).inverse();
    EXPECT_TRUE(weighed.precision.isApprox(expected, 1e-9)) << sensors;
    EXPECT_TRUE(weighed.weighted.isApprox(expected * M.ldlt().solve(evidence.weighted), 1e-8)) << sensors;
    const WeighedEvidence without_prior = weigh(evidence, Eigen::VectorXd::Zero(prior.size()));
    EXPECT_EQ(without_prior.precision, M);
    EXPECT_EQ(without_prior.weighted, evidence.weighted);
  }
  EXPECT_TRUE(ownEvidence({}, {}).information.isZero());
  EXPECT_TRUE(ownEvidence({}, {}).weighted.isZero());
}

TEST(SensorEvidence, ReadingsOfACellSayWhatASmallTurnDoesNotExplain) {
  // Readings of the cube's six directions that are only turned tell of no error; the symmetric part of the cross-axis
  // sensitivity, scale and offset are seen.
  std::vector<Eigen::Vector3d> forces;
  for (int axis = 0; axis < 3; ++axis) {
    forces.push_back(Eigen::Vector3d::Unit(axis));
    forces.push_back(-Eigen::Vector3d::Unit(axis));
  }
  const Eigen::Vector3d turn(1e-6, -2e-6, 3e-6);
  std::vector<CellReading> turned;
  std::vector<CellReading> wrong;
  Eigen::VectorXd errors = Eigen::VectorXd::Zero(kSensorParameters);
  errors << 0.01, 0.002, 0.003, 0, -0.02, 0.003, 0.001, 0, 0.03, 0, 0, -0.004;  // symmetric cross-axis sensitivity
  for (std::size_t k = 0; k < forces.size(); ++k) {
    const Eigen::Vector4d row(1, forces[k].x(), forces[k].y(), forces[k].z());
    Eigen::Vector3d error;
    for (Eigen::Index axis = 0; axis < 3; ++axis) error[axis] = errors.segment<4>(4 * axis).dot(row);
    turned.push_back({k, forces[k] + forces[k].cross(turn), 1e-6});
    wrong.push_back({k, forces[k] + error, 1e-6});
  }
  EXPECT_LT(ownEvidence(turned, forces).weighted.norm(), 1e-6 * 1e6 * turn.norm());
  const SensorEvidence evidence = ownEvidence(wrong, forces);
  EXPECT_TRUE(evidence.weighted.isApprox(evidence.information * errors, 1e-9));
  const Eigen::VectorXd found = evidence.information.completeOrthogonalDecomposition().solve(evidence.weighted);
  for (Eigen::Index axis = 0; axis < 3; ++axis) {
    EXPECT_NEAR(found[4 * axis], errors[4 * axis], 1e-9);
    for (Eigen::Index other = 0; other < 3; ++other) {
      const auto symmetric = [&](const Eigen::VectorXd& x) {
        return x[4 * axis + 1 + other] + x[4 * other + 1 + axis];
      };
      EXPECT_NEAR(symmetric(found), symmetric(errors), 1e-9);
    }
  }
}

/// The root of the mean of the squares of a kind of errors.
double rootMeanOf(SensorError kind, const Eigen::VectorXd& squares) {
  double sum = 0;
  double count = 0;
  for (Eigen::Index k = 0; k < squares.size(); ++k) {
    if (kindOfParameter(k) != kind) continue;
    sum += squares[k];
    ++count;
  }
  return std::sqrt(sum / count);
}

TEST(SensorSigmas, OfErrorsThatAreKnownExactlyAreTheirSpread) {
  NormalDraw draw(3);
  constexpr std::size_t kSensors = 20;
  const Eigen::VectorXd x =
      drawErrors(accelerometer(0.05, 0.03, 0.02, 0.006), kSensors, {0.02, -0.035, 0.03}, 0.1, draw);
  const Eigen::MatrixXd exact = 1e10 * Eigen::MatrixXd::Identity(x.size(), x.size());
  const SensorSigmas sigmas =
      estimateSensorSigmas(std::vector{SensorEvidence{exact, exact * x}}, accelerometer(0.1, 0, 0.01, 0.01));

  const double cross_axis = rootMeanOf(SensorError::CrossAxis, x.cwiseAbs2());
  Eigen::Vector3d mean = Eigen::Vector3d::Zero();  // of the offsets
  for (Eigen::Index k = 0; k < x.size(); k += 4) mean[(k % kSensorParameters) / 4] += x[k] / kSensors;
  double within = 0;  // of one-way random effects
  for (Eigen::Index k = 0; k < x.size(); k += 4) {
    within += std::pow(x[k] - mean[(k % kSensorParameters) / 4], 2) / (3 * (kSensors - 1));
  }
  const double shared = mean.squaredNorm() / 3 - within / kSensors;
  double mean_scale = 0;
  double scale = 0;  // about it
  for (Eigen::Index k = 0; k < x.size(); ++k) {
    if (kindOfParameter(k) == SensorError::Scale) mean_scale += x[k] / (3 * kSensors);
  }
  for (Eigen::Index k = 0; k < x.size(); ++k) {
    if (kindOfParameter(k) == SensorError::Scale) scale += std::pow(x[k] - mean_scale, 2) / (3 * kSensors - 1);
  }
  const double shared_scale = std::sqrt(mean_scale * mean_scale - scale / (3 * kSensors));
  scale = std::sqrt(scale);
  const double lot_scale = 1 + mean_scale;  // own errors come before it
  EXPECT_NEAR(sigmas.scale.sigma * lot_scale, scale, 1e-4 * scale);
  EXPECT_NEAR(sigmas.shared_scale.sigma, shared_scale, 1e-3 * shared_scale);
  EXPECT_NEAR(sigmas.cross_axis.sigma * lot_scale, cross_axis, 1e-4 * cross_axis);
  EXPECT_NEAR(sigmas.shared_offset_g.sigma, std::sqrt(shared), 1e-3 * std::sqrt(shared));
  EXPECT_NEAR(sigmas.offset_g.sigma, std::sqrt(within + shared), 1e-3 * std::sqrt(within + shared));
  ASSERT_TRUE(sigmas.lot);
  EXPECT_TRUE(sigmas.lot->offset_g.isApprox(mean, 1e-6));
  EXPECT_NEAR(sigmas.lot->offset_sigma_g[0], std::sqrt(within / kSensors), 1e-3 * std::sqrt(within / kSensors));
  EXPECT_NEAR(sigmas.lot->scale, lot_scale, 1e-4);
  EXPECT_NEAR(sigmas.lot->scale_sigma, scale / std::sqrt(3 * kSensors) / lot_scale, 1e-5);
  // Each exactly known error is worth one; a lot has three offsets and one scale, to which one goes.
  EXPECT_NEAR(sigmas.scale.worth, 3 * kSensors - 1, 0.1);
  EXPECT_NEAR(sigmas.cross_axis.worth, 6 * kSensors, 0.1);
  EXPECT_GT(sigmas.shared_offset_g.worth, 2);
  EXPECT_LT(sigmas.shared_offset_g.worth, 3);
  EXPECT_NEAR(sigmas.shared_scale.worth, 1, 0.01);
  EXPECT_NEAR(sigmas.shared_scale.low_95, shared_scale / 2.2414, 1e-3 * shared_scale);
  EXPECT_GT(sigmas.shared_scale.high_95, 30 * shared_scale) << "one number says little of others";
}

TEST(SensorSigmas, AreWhereExpectationMaximisationSettles) {
  NormalDraw draw(4);
  const Accelerometer truth = accelerometer(0.03, 0.02, 0.01, 0.008);
  const Eigen::VectorXd x = drawErrors(truth, 8, {0.03, -0.02, 0.01}, 0.05, draw);
  const SensorEvidence evidence = seen(mixedInformation(x.size(), draw), x, draw);
  const SensorSigmas sigmas = estimateSensorSigmas(std::vector{evidence}, accelerometer(0.06, 0, 0.02, 0.005));
  const double shared = std::pow(sigmas.shared_offset_g.sigma, 2);
  const double own = std::pow(sigmas.offset_g.sigma, 2) - shared;
  ASSERT_TRUE(sigmas.lot);  // own errors come before its scale
  const double scale = sigmas.scale.sigma * sigmas.lot->scale;
  const double cross_axis = sigmas.cross_axis.sigma * sigmas.lot->scale;
  Eigen::VectorXd D(x.size());  // variances of the sensors' own errors
  Eigen::MatrixXd U = Eigen::MatrixXd::Zero(x.size(), 4);
  for (Eigen::Index k = 0; k < x.size(); ++k) {
    const SensorError kind = kindOfParameter(k);
    D[k] = kind == SensorError::Offset  ? own
           : kind == SensorError::Scale ? std::pow(scale, 2)
                                        : std::pow(cross_axis, 2);
    if (kind == SensorError::Offset) U(k, (k % kSensorParameters) / 4) = 1;
    if (kind == SensorError::Scale) U(k, 3) = 1;
  }
  const Eigen::Vector4d w(shared, shared, shared, std::pow(sigmas.shared_scale.sigma, 2));
  const Eigen::MatrixXd L = Eigen::MatrixXd(D.asDiagonal()) + U * w.asDiagonal() * U.transpose();
  const Eigen::MatrixXd covariance = (evidence.information + L.inverse()).inverse();
  const Eigen::VectorXd mean = covariance * evidence.weighted;
  // What of an error x is B x in the mean, with B = S L^-1 and S its covariance with x; a priori it has the variance P.
  const auto momentsOf = [&](const Eigen::MatrixXd& S, const Eigen::MatrixXd& P) -> Eigen::VectorXd {
    const Eigen::MatrixXd B = S * L.inverse();
    return (B * mean).cwiseAbs2() + (P - B * S.transpose() + B * covariance * B.transpose()).diagonal();
  };
  const Eigen::VectorXd moments = momentsOf(D.asDiagonal(), D.asDiagonal());
  EXPECT_NEAR(rootMeanOf(SensorError::Offset, moments), std::sqrt(own), 1e-3 * std::sqrt(own));
  EXPECT_NEAR(rootMeanOf(SensorError::Scale, moments), scale, 1e-3 * scale);
  EXPECT_NEAR(rootMeanOf(SensorError::CrossAxis, moments), cross_axis, 1e-3 * cross_axis);
  const Eigen::VectorXd of_lot = momentsOf(w.asDiagonal() * U.transpose(), w.asDiagonal());
  EXPECT_NEAR(std::sqrt(of_lot.head<3>().mean()), std::sqrt(shared), 2e-3 * std::sqrt(shared));
  EXPECT_NEAR(std::sqrt(of_lot[3]), sigmas.shared_scale.sigma, 2e-3 * sigmas.shared_scale.sigma);
}

TEST(SensorSigmas, WithoutInformationStayTheModelsAndSaySo) {
  const SensorEvidence nothing{Eigen::MatrixXd::Zero(60, 60), Eigen::VectorXd::Zero(60)};
  Accelerometer model = accelerometer(0.06, 0.01, 0.02, 0.005);
  model.scale_shared_sigma = 0.03;
  const SensorSigmas sigmas = estimateSensorSigmas(std::vector{nothing}, model);
  for (const SigmaEstimate& sigma :
       {sigmas.offset_g, sigmas.shared_offset_g, sigmas.scale, sigmas.shared_scale, sigmas.cross_axis}) {
    EXPECT_EQ(sigma.knowledge, SigmaKnowledge::Unknown);
    EXPECT_LT(sigma.worth, 0.01);  // the model counts as a thousandth of an error
  }
  EXPECT_FALSE(sigmas.lot);
  const Accelerometer written = sigmas.inModel(model);
  EXPECT_TRUE(written.offset_sigma_g.isApprox(model.offset_sigma_g, 1e-12));
  EXPECT_DOUBLE_EQ(written.offset_shared_sigma_g, model.offset_shared_sigma_g);
  EXPECT_EQ(written.scale_sigma, model.scale_sigma);
  EXPECT_DOUBLE_EQ(written.scale_shared_sigma, model.scale_shared_sigma);
  EXPECT_EQ(written.cross_axis_sigma, model.cross_axis_sigma);
  EXPECT_EQ(estimateSensorSigmas({}, model).offset_g.knowledge, SigmaKnowledge::Unknown);
}

TEST(SensorSigmas, AScaleWhoseSharedPartCannotBeToldStandsAsAWhole) {
  SensorSigmas sigmas;
  sigmas.scale = {.knowledge = SigmaKnowledge::AtMost, .sigma = 0.003, .high_95 = 0.004};
  const Accelerometer written = sigmas.inModel(accelerometer(0.06, 0, 0.02, 0.005));
  EXPECT_EQ(written.scale_sigma, 0.004);
  EXPECT_DOUBLE_EQ(written.ofUnknownLot().scale_sigma, 0.02);
}

TEST(SensorSigmas, ErrorsBelowWhatReadingsShowAreBounded) {
  NormalDraw draw(5);
  const Eigen::VectorXd x = Eigen::VectorXd::Zero(120);
  const SensorEvidence evidence = seen(mixedInformation(120, draw), x, draw);
  const Accelerometer model = accelerometer(0.06, 0, 0.02, 0.02);
  const SensorSigmas sigmas = estimateSensorSigmas(std::vector{evidence}, model);
  for (const SigmaEstimate& sigma : {sigmas.offset_g, sigmas.scale, sigmas.shared_scale, sigmas.cross_axis}) {
    ASSERT_NE(sigma.knowledge, SigmaKnowledge::Unknown);
    EXPECT_GT(sigma.forModel(), 0);
    EXPECT_LT(sigma.high_95, 0.01);
  }
  EXPECT_EQ(sigmas.inModel(model).scale_shared_sigma, 0) << "not measured";
}

TEST(SensorSigmas, LieWithinTheirRangesAsOftenAsStated) {
  constexpr int kTrials = 200;
  const Accelerometer truth = accelerometer(0.03, 0, 0.01, 0.008);
  NormalDraw draw(6);
  int within = 0;
  int measured = 0;
  for (int trial = 0; trial < kTrials; ++trial) {
    // Two skins.
    std::vector<SensorEvidence> evidence;
    for (int skin = 0; skin < 2; ++skin) {
      const Eigen::VectorXd x = drawErrors(truth, 4, Eigen::Vector3d::Zero(), 0, draw);
      evidence.push_back(seen(mixedInformation(x.size(), draw), x, draw));
    }
    const SensorSigmas sigmas = estimateSensorSigmas(evidence, accelerometer(0.06, 0, 0.02, 0.005));
    const auto count = [&](const SigmaEstimate& estimate, double sigma) {
      if (estimate.knowledge != SigmaKnowledge::Measured) return;
      ++measured;
      within += estimate.low_95 <= sigma && sigma <= estimate.high_95 ? 1 : 0;
    };
    count(sigmas.offset_g, truth.largestOffsetSigma_g());
    count(sigmas.scale, truth.scale_sigma);
    count(sigmas.cross_axis, truth.cross_axis_sigma);
  }
  EXPECT_GT(measured, 2 * kTrials);
  EXPECT_GT(within, 0.92 * measured) << within << " of " << measured;
  EXPECT_LT(within, 0.985 * measured) << within << " of " << measured;
}

}  // namespace
}  // namespace hexoderm
