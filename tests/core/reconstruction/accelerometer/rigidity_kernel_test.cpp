#include "hexoderm/reconstruction/accelerometer/rigidity_kernel.h"

#include "hexoderm/geometry/se3.h"
#include "hexoderm/reconstruction/accelerometer/rigidity.h"

#include <gmock/gmock.h>

#include <random>

namespace hexoderm {
namespace {

/// kLanes pairs of cells with errors of their sensors; the readings of one are those of the other, turned.
struct Pairs {
  int poses = 0;
  std::vector<double> c_g;
  std::vector<double> n_g;
  std::vector<double> variance_g2;
  std::vector<double> R_c_n;
  std::array<std::vector<Eigen::Vector3d>, kLanes> c;
  std::array<std::vector<Eigen::Vector3d>, kLanes> n;
  std::array<Eigen::Matrix3d, kLanes> R;

  [[nodiscard]] RigidityKernelInput input() const {
    return {poses, c_g.data(), n_g.data(), variance_g2.data(), R_c_n.data()};
  }
};

Pairs drawPairs(int poses, std::mt19937& random) {
  std::normal_distribution<double> normal;
  const auto draw = [&](double sigma) -> Eigen::Vector3d {
    return Eigen::Vector3d::NullaryExpr([&] { return sigma * normal(random); });
  };
  Pairs pairs;
  pairs.poses = poses;
  const auto count = static_cast<std::size_t>(poses * kLanes);
  pairs.c_g.resize(3 * count);
  pairs.n_g.resize(3 * count);
  pairs.variance_g2.resize(count);
  pairs.R_c_n.resize(9 * kLanes);
  for (int lane = 0; lane < kLanes; ++lane) {
    const auto l = static_cast<std::size_t>(lane);
    pairs.R[l] = expSO3(draw(1));
    for (int k = 0; k < 9; ++k) pairs.R_c_n[static_cast<std::size_t>(kLanes * k + lane)] = pairs.R[l](k / 3, k % 3);
    const Eigen::Vector3d offset_c = draw(0.06);
    const Eigen::Vector3d offset_n = draw(0.06);
    for (int pose = 0; pose < poses; ++pose) {
      const Eigen::Vector3d up = draw(1).normalized();
      pairs.c[l].push_back(up + offset_c + draw(0.005));
      pairs.n[l].push_back(pairs.R[l].transpose() * expSO3(draw(0.02)) * up + offset_n + draw(0.005));
      for (int axis = 0; axis < 3; ++axis) {
        const auto at = static_cast<std::size_t>(kLanes * (3 * pose + axis) + lane);
        pairs.c_g[at] = pairs.c[l].back()[axis];
        pairs.n_g[at] = pairs.n[l].back()[axis];
      }
      pairs.variance_g2[static_cast<std::size_t>(kLanes * pose + lane)] = 2e-5 * (1 + lane);
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
      testRigidityByOne(options, pairs.input(), one);
      RigidityKernelOutput four = one;
      if (hasFourLanes()) testRigidityByFour(options, pairs.input(), four);
      for (int lane = 0; lane < kLanes; ++lane) {
        const auto l = static_cast<std::size_t>(lane);
        EXPECT_EQ(four.usual[lane], one.usual[lane]);
        if (one.usual[lane] == 0) continue;
        ++usual;
        RigidityTest test(prior);
        for (std::size_t pose = 0; pose < static_cast<std::size_t>(poses); ++pose) {
          test.add({pose, R_a_u * pairs.c[l][pose], 2e-5 * (1 + lane)}, R_a_u * pairs.R[l] * pairs.n[l][pose]);
        }
        // What is left is the difference of sums that are up to some ten thousand.
        const double expected = test.misfit().chi_squared;
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
  for (int pose = 1; pose < 3; ++pose) {
    for (int axis = 0; axis < 3; ++axis) {
      pairs.c_g[static_cast<std::size_t>(kLanes * (3 * pose + axis) + 2)] =
          pairs.c_g[static_cast<std::size_t>(kLanes * axis + 2)];
      pairs.n_g[static_cast<std::size_t>(kLanes * (3 * pose + axis) + 2)] =
          pairs.n_g[static_cast<std::size_t>(kLanes * axis + 2)];
    }
  }
  const RigidityKernelOptions options =
      rigidityKernelOptions(AccelerometerPrior(pairOf(Accelerometer{})), Eigen::Matrix3d::Identity());
  for (const auto kernel : {testRigidityByOne, hasFourLanes() ? testRigidityByFour : testRigidityByOne}) {
    RigidityKernelOutput out{};
    kernel(options, pairs.input(), out);
    for (int lane = 0; lane < kLanes; ++lane) EXPECT_EQ(out.usual[lane], lane == 2 ? 0 : 1) << lane;
  }
}

}  // namespace
}  // namespace hexoderm
