#include "hexoderm/reconstruction/accelerometer/rigidity_kernel.h"
#include "tests/core/reconstruction/accelerometer/lanes.h"

#include "hexoderm/geometry/se3.h"
#include "hexoderm/reconstruction/accelerometer/rigidity.h"
#include "hexoderm/util/vector_instructions.h"

#include <gmock/gmock.h>

#include <random>

namespace hexoderm {
namespace {

/// kLanes pairs of cells with errors of their sensors; the readings of one are those of the other, turned.
struct Pairs {
  Lanes c_g;
  Lanes n_g;
  Lanes variance_g2;
  Lanes R_c_n;
  std::array<Eigen::Matrix3d, kLanes> R;

  [[nodiscard]] RigidityKernelInput input() const {
    return {static_cast<int>(variance_g2.rows()), c_g.data(), n_g.data(), variance_g2.data(), R_c_n.data()};
  }
};

Pairs drawPairs(Eigen::Index poses, std::mt19937& random) {
  std::normal_distribution<double> normal;
  const auto draw = [&](double sigma) -> Eigen::Vector3d {
    return Eigen::Vector3d::NullaryExpr([&] { return sigma * normal(random); });
  };
  Pairs pairs{Lanes(3 * poses, kLanes), Lanes(3 * poses, kLanes), Lanes(poses, kLanes), Lanes(9, kLanes), {}};
  for (Eigen::Index lane = 0; lane < kLanes; ++lane) {
    Eigen::Matrix3d& R = pairs.R[static_cast<std::size_t>(lane)];
    R = expSO3(draw(1));
    pairs.R_c_n.col(lane) = columnOf(R);
    pairs.variance_g2.col(lane).setConstant(2e-5 * static_cast<double>(1 + lane));
    const Eigen::Vector3d offset_c = draw(0.06);
    const Eigen::Vector3d offset_n = draw(0.06);
    for (Eigen::Index pose = 0; pose < poses; ++pose) {
      const Eigen::Vector3d up = draw(1).normalized();
      pairs.c_g.col(lane).segment<3>(3 * pose) = up + offset_c + draw(0.005);
      pairs.n_g.col(lane).segment<3>(3 * pose) = R.transpose() * expSO3(draw(0.02)) * up + offset_n + draw(0.005);
    }
  }
  return pairs;
}

TEST(RigidityKernel, AgreesWithTheTestOfOnePair) {
  std::mt19937 random(1);
  const AccelerometerPrior prior(pairOf(Accelerometer{}));
  const Eigen::Matrix3d R_a_u = expSO3({0.3, -0.2, 1.4});
  const RigidityKernelOptions options = rigidityKernelOptions(prior, R_a_u);
  int usual = 0;
  for (int trial = 0; trial < 200; ++trial) {
    for (const int poses : {2, 3, 4, 9}) {
      const Pairs pairs = drawPairs(poses, random);
      RigidityKernelOutput one{};
      testRigidityByTwo(options, pairs.input(), one);
      RigidityKernelOutput four = one;
      if (hasVectorInstructions()) testRigidityByFour(options, pairs.input(), four);
      for (int lane = 0; lane < kLanes; ++lane) {
        const auto l = static_cast<std::size_t>(lane);
        EXPECT_EQ(four.usual[lane], one.usual[lane]);
        if (one.usual[lane] == 0) continue;
        ++usual;
        ReadingSums sums;
        for (int pose = 0; pose < poses; ++pose) {
          const Eigen::Vector3d c = pairs.c_g.col(lane).segment<3>(3 * pose);
          const Eigen::Vector3d n = pairs.n_g.col(lane).segment<3>(3 * pose);
          sums.add({static_cast<std::size_t>(pose), R_a_u * c, 2e-5 * (1 + lane)}, R_a_u * pairs.R[l] * n);
        }
        // What is left is the difference of sums that are up to some ten thousand.
        const double expected = testRigidity(prior, sums).chi_squared;
        EXPECT_NEAR(one.chi_squared[lane], expected, 1e-9 * (1 + expected));
        EXPECT_NEAR(four.chi_squared[lane], one.chi_squared[lane], 1e-9 * (1 + expected));
      }
    }
  }
  EXPECT_GT(usual, 200 * 4 * kLanes * 9 / 10);
}

TEST(RigidityKernel, LeavesPairsThatDoNotShowATurnToTheCarefulWay) {
  std::mt19937 random(2);
  Pairs pairs = drawPairs(3, random);
  // Lane 2 reads one direction in all poses.
  for (Lanes* readings : {&pairs.c_g, &pairs.n_g}) {
    for (int pose = 1; pose < 3; ++pose) readings->col(2).segment<3>(3 * pose) = readings->col(2).head<3>();
  }
  const RigidityKernelOptions options =
      rigidityKernelOptions(AccelerometerPrior(pairOf(Accelerometer{})), Eigen::Matrix3d::Identity());
  for (const auto kernel : {testRigidityByTwo, hasVectorInstructions() ? testRigidityByFour : testRigidityByTwo}) {
    RigidityKernelOutput out{};
    kernel(options, pairs.input(), out);
    for (int lane = 0; lane < kLanes; ++lane) EXPECT_EQ(out.usual[lane], lane == 2 ? 0 : 1) << lane;
  }
}

}  // namespace
}  // namespace hexoderm
