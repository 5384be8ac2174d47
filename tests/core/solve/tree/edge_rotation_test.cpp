#include "hexoderm/solve/tree/edge_rotation.h"

#include "hexoderm/base/procrustes.h"
#include "hexoderm/base/units.h"
#include "tests/support/matchers.h"
#include "tests/support/options.h"

#include <random>

namespace hexoderm {
namespace {

using ::testing::DoubleNear;

const CellModel& model() {
  static const CellModel kModel = builtInCellModel("hex-bma150");
  return kModel;
}
const Port& portOut() { return model().port(PortNumber(1)); }
const Port& portIn() { return model().port(PortNumber(4)); }

EdgeReadings readingsFor(const Eigen::Matrix3d& R_c_n, const std::vector<Eigen::Vector3d>& ups_c) {
  EdgeReadings readings;
  const auto count = static_cast<Eigen::Index>(ups_c.size());
  readings.c_g.resize(3, count);
  readings.n_g.resize(3, count);
  for (Eigen::Index p = 0; p < count; ++p) {
    readings.c_g.col(p) = ups_c[static_cast<std::size_t>(p)].normalized();
    readings.n_g.col(p) = R_c_n.transpose() * readings.c_g.col(p);
    readings.variance_g2.push_back(2e-6);
  }
  return readings;
}

EdgeRotation estimate(const EdgeReadings& readings, const SolverOptions& options = {}) {
  return estimateEdgeRotation(model(), portOut(), portIn(), readings, options);
}

Eigen::Matrix3d someRotation() { return expSO3({0.05, 0.35, -0.08}) * nominalAlignment(portOut(), portIn()); }

const std::vector<Eigen::Vector3d> kTwo = {{0, 0, 1}, {1, 0, 0}};
const std::vector<Eigen::Vector3d> kTetrahedron = {{1, 1, 1}, {1, -1, -1}, {-1, 1, -1}, {-1, -1, 1}};

TEST(EdgeRotation, RecoversKnownRotationFromTwoOrthogonalPoses) {
  const EdgeRotation edge = estimate(readingsFor(someRotation(), kTwo));
  EXPECT_THAT(edge.R_c_n, RotationNear(someRotation(), 1e-9));
  EXPECT_EQ(edge.quality, EdgeQuality::Fully);
  EXPECT_THAT(edge.residual_rad, DoubleNear(0, 1e-9));
  EXPECT_FALSE(edge.supported);
}

TEST(EdgeRotation, ClassesFollowEquation17) {
  EXPECT_EQ(classifyEdge({0.9, 0.2, 0}, 1), EdgeQuality::Undefined);
  EXPECT_EQ(classifyEdge({1.0, 0.99, 0}, 1), EdgeQuality::Partially);
  EXPECT_EQ(classifyEdge({1.0, 1.0, 0.5}, 1), EdgeQuality::Fully);
  EXPECT_EQ(classifyEdge({2, 1.5, 1.0}, 1), EdgeQuality::Over);
  EXPECT_EQ(classifyEdge({1.02, 0.98, 0}, 0.5), EdgeQuality::Fully) << "the paper's own recipe, a hair off orthogonal";
  EXPECT_EQ(paperWeight(EdgeQuality::Undefined), 3);
  EXPECT_EQ(paperWeight(EdgeQuality::Partially), 2);
  EXPECT_EQ(paperWeight(EdgeQuality::Fully), 1);
  EXPECT_EQ(paperWeight(EdgeQuality::Over), 1);
}

TEST(EdgeRotation, CentringRemovesOffsetsExactlyAndAutoChoosesIt) {
  EdgeReadings readings = readingsFor(someRotation(), kTetrahedron);
  readings.c_g.colwise() += Eigen::Vector3d(0.06, -0.09, 0.04);
  readings.n_g.colwise() += Eigen::Vector3d(-0.05, 0.02, 0.08);
  const EdgeRotation plain = estimate(readings, test::with(&SolverOptions::centring, Centring::Off));
  EXPECT_GT(rotationAngle(plain.R_c_n.transpose() * someRotation()), 1e-4);
  const EdgeRotation centred = estimate(readings);
  EXPECT_TRUE(centred.centred);
  EXPECT_THAT(centred.R_c_n, RotationNear(someRotation(), 1e-9));
  EXPECT_THAT(centred.residual_rad, DoubleNear(0, 1e-9));
  EXPECT_THAT(centred.singular_values, VectorNear(plain.singular_values, 1e-12)) << "classes use the uncentred values";
}

TEST(EdgeRotation, IsNotCentredWhereThatWouldLeaveALine) {
  const auto isCentred = [](const std::vector<Eigen::Vector3d>& ups, const SolverOptions& options = {}) {
    return estimate(readingsFor(someRotation(), ups), options).centred;
  };
  EXPECT_FALSE(isCentred(kTwo));
  EXPECT_FALSE(isCentred(kTwo, test::with(&SolverOptions::centring, Centring::On)));
  EXPECT_FALSE(isCentred({{0, 0, 1}, {0, 0, 1}, {1, 0, 0}})) << "a pose taken twice and another one";
}

TEST(EdgeRotation, WithoutPosesSupportAxesGiveTheNominalAlignment) {
  const EdgeRotation edge = estimate(readingsFor(someRotation(), {}));
  EXPECT_THAT(edge.R_c_n, RotationNear(nominalAlignment(portOut(), portIn()), 1e-12));
  EXPECT_TRUE(edge.supported);
  EXPECT_EQ(edge.quality, EdgeQuality::Undefined);
  // The prior is all there is: 30 degrees of bend.
  EXPECT_NEAR(std::sqrt(edge.covariance.trace()),
              std::sqrt(std::pow(30 * kDegree, 2) + std::pow(10 * kDegree, 2) + std::pow(2 * kDegree, 2)), 1e-9);
}

TEST(EdgeRotation, OnePoseFixesTiltAndSupportAxesTheTurnAboutGravity) {
  // Bent about z x u and seen with gravity along z: the bend shows, the yaw about gravity stays nominal.
  const Eigen::Vector3d u = portOut().vector_m.normalized();
  const Eigen::Matrix3d R = expSO3(0.3 * Eigen::Vector3d::UnitZ().cross(u)) * nominalAlignment(portOut(), portIn());
  const EdgeRotation edge = estimate(readingsFor(R, {Eigen::Vector3d::UnitZ()}));
  EXPECT_EQ(edge.quality, EdgeQuality::Partially);
  EXPECT_TRUE(edge.supported);
  // The support axes pull the bend back by 2 % of a unit vector's information, no more.
  EXPECT_THAT(edge.R_c_n, RotationNear(R, 0.3 * 0.03));
}

TEST(EdgeRotation, ParallelAndOppositePosesStayPartiallyDefinedAndFinite) {
  for (const Eigen::Vector3d& second : {Eigen::Vector3d(0, 0, 1), Eigen::Vector3d(0, 0, -1)}) {
    for (const SupportAxes axes : {SupportAxes::Auto, SupportAxes::On, SupportAxes::Off}) {
      const EdgeRotation edge = estimate(readingsFor(someRotation(), {Eigen::Vector3d::UnitZ(), second}),
                                         test::with(&SolverOptions::support_axes, axes));
      EXPECT_EQ(edge.quality, EdgeQuality::Partially);
      EXPECT_TRUE(edge.R_c_n.allFinite() && edge.covariance.allFinite());
      EXPECT_GT(std::sqrt(edge.covariance.trace()), 2 * kDegree) << "what is not known must not look known";
    }
  }
}

TEST(EdgeRotation, PredictedDeviationAgreesWithSimulatedSensors) {
  // Monte Carlo against the first-order prediction, offsets, scales, cross-axis and noise drawn from the priors.
  std::mt19937_64 random(11);
  std::normal_distribution<double> normal;
  const Accelerometer& a = model().accelerometer;
  // (Uncentred tetrahedra are left out: their offsets cancel to first order, and the prediction is one of first order.)
  const std::vector<Eigen::Vector3d> three = {{0, 0, 1}, {1, 0, 0}, {0, 1, 0}};
  const std::pair<std::vector<Eigen::Vector3d>, Centring> cases[] = {
      {kTwo, Centring::Off}, {three, Centring::Off}, {three, Centring::On}, {kTetrahedron, Centring::On}};
  for (const auto& entry : cases) {
    const auto options = test::with(&SolverOptions::centring, entry.second);
    constexpr int kTrials = 4000;
    double squared = 0;
    double predicted = 0;
    const auto corrupt = [&](Eigen::Matrix3Xd& g) {
      Eigen::Matrix3d gain = Eigen::Matrix3d::Identity();
      Eigen::Vector3d offset;
      for (int i = 0; i < 3; ++i) {
        offset(i) = a.offset_sigma_g[i] * normal(random);
        for (int j = 0; j < 3; ++j) gain(i, j) += (i == j ? a.scale_sigma : a.cross_axis_sigma) * normal(random);
      }
      g = ((gain * g).colwise() + offset).eval();
      for (Eigen::Index k = 0; k < g.size(); ++k) g.data()[k] += 1e-3 * normal(random);
    };
    for (int trial = 0; trial < kTrials; ++trial) {
      EdgeReadings readings = readingsFor(someRotation(), entry.first);
      corrupt(readings.c_g);
      corrupt(readings.n_g);
      const EdgeRotation edge = estimate(readings, options);
      squared += logSO3(someRotation() * edge.R_c_n.transpose()).squaredNorm();
      predicted += edge.covariance.trace();
    }
    EXPECT_NEAR(std::sqrt(squared / predicted), 1, 0.05);
  }
}

}  // namespace
}  // namespace hexoderm
