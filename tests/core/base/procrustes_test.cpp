#include "hexoderm/base/procrustes.h"

#include "hexoderm/base/se3.h"
#include "hexoderm/base/units.h"
#include "tests/support/random_vector.h"
#include "tests/support/testing.h"

namespace hexoderm {
namespace {

Eigen::Matrix3Xd columns(std::initializer_list<Eigen::Vector3d> vectors) {
  Eigen::Matrix3Xd matrix(3, static_cast<Eigen::Index>(vectors.size()));
  Eigen::Index k = 0;
  for (const Eigen::Vector3d& v : vectors) matrix.col(k++) = v;
  return matrix;
}

const Eigen::Matrix3Xd kTwoPoses = columns({{0, 0, 1}, {1, 0, 0}});

// Of N in C: the transpose, in which the convention is the other one, is another rotation.
TEST(Procrustes, RecoversAnyRotationFromTwoOrthogonalVectorsWithoutNoise) {
  for (const double angle : {0.0, 1e-8, 0.3, 1.5, 3.0, kPi}) {
    const Eigen::Matrix3d R = expSO3(angle * Eigen::Vector3d(0.6, 0, 0.8));
    EXPECT_LT((solveProcrustes(kTwoPoses, R * kTwoPoses).R_c_n - R).norm(), 1e-14) << angle;
  }
}

TEST(Procrustes, AgreesWithAGeneralSvd) {
  std::mt19937 random(5);
  std::normal_distribution<double> normal;
  for (int trial = 0; trial < 2000; ++trial) {
    // Vectors in all of space, near a plane and near a line.
    const Eigen::Vector3d extent(1, trial % 2 == 0 ? 1 : std::pow(10, -normal(random) * normal(random)),
                                 trial % 3 == 0 ? 1 : 1e-6 * normal(random));
    const Eigen::Matrix3d turned = expSO3({normal(random), normal(random), normal(random)});
    Eigen::Matrix3Xd N(3, 5);
    Eigen::Matrix3Xd C(3, 5);
    for (Eigen::Index p = 0; p < 5; ++p) {
      const Eigen::Vector3d v = test::randomVector([&] { return normal(random); });
      N.col(p) = v.cwiseProduct(extent);
      C.col(p) = turned * N.col(p) + 0.02 * extent.y() * test::randomVector([&] { return normal(random); });
    }
    const Eigen::Matrix3d H = N * C.transpose();
    const Eigen::JacobiSVD<Eigen::Matrix3d> svd(H, Eigen::ComputeFullU | Eigen::ComputeFullV);
    const double det = (svd.matrixV() * svd.matrixU().transpose()).determinant();
    const Eigen::Matrix3d expected =
        svd.matrixV() * Eigen::Vector3d(1, 1, det).asDiagonal() * svd.matrixU().transpose();
    const Eigen::Vector3d s = svd.singularValues();
    const ProcrustesSolution solution = solveProcrustes(N, C);
    EXPECT_LT((solution.singular_values - s).norm(), 1e-12 * s.x());
    EXPECT_LT((solution.R_c_n * solution.R_c_n.transpose() - Eigen::Matrix3d::Identity()).norm(), 1e-12);
    // If two singular values nearly cancel each other, the rotation about the first axis is undetermined.
    const double certain = s.y() + det * s.z();
    EXPECT_LT((solution.R_c_n - expected).norm(), 1e-13 * s.x() / certain) << "trial " << trial;
  }
}

TEST(Procrustes, NeverReflects) {
  // The best orthogonal matrix here is a mirror; the best rotation is asked for.
  const Eigen::Matrix3Xd N = Eigen::Matrix3d::Identity();
  const Eigen::Matrix3Xd C = Eigen::Vector3d(1, 1, -1).asDiagonal();
  const ProcrustesSolution solution = solveProcrustes(N, C);
  EXPECT_NEAR(solution.R_c_n.determinant(), 1, 1e-14);
  EXPECT_LT((solution.singular_values - Eigen::Vector3d::Ones()).norm(), 1e-14);
}

TEST(Procrustes, WithoutVectorsGivesTheIdentity) {
  const ProcrustesSolution solution = solveProcrustes(Eigen::Matrix3Xd(3, 0), Eigen::Matrix3Xd(3, 0));
  EXPECT_EQ(solution.R_c_n, Eigen::Matrix3d::Identity());
  EXPECT_EQ(solution.singular_values, Eigen::Vector3d::Zero());
}

TEST(Procrustes, DegenerateVectorsStillGiveARotationThatFitsThem) {
  const Eigen::Matrix3d R = expSO3({0.3, 0.4, 0.5});
  for (const Eigen::Matrix3Xd& N : {columns({{0, 0, 1}}), columns({{0, 0, 1}, {0, 0, 1}}),
                                    columns({{0, 0, 1}, {0, 0, -1}}), columns({{0, 0, 0}, {0, 0, 0}})}) {
    const ProcrustesSolution solution = solveProcrustes(N, R * N);
    ASSERT_TRUE(solution.R_c_n.allFinite());
    EXPECT_NEAR(solution.R_c_n.determinant(), 1, 1e-14);
    EXPECT_LT((solution.R_c_n * N - R * N).norm(), 1e-14);
    EXPECT_LT(solution.singular_values.y(), 1e-14);
  }
}

TEST(Procrustes, RefusesDifferentShapesAndValuesThatAreNotFinite) {
  EXPECT_THROW(solveProcrustes(kTwoPoses, Eigen::Matrix3Xd::Zero(3, 3)), InvalidArgument);
  Eigen::Matrix3Xd bad = kTwoPoses;
  bad(1, 1) = std::numeric_limits<double>::quiet_NaN();
  EXPECT_THROW(solveProcrustes(bad, kTwoPoses), InvalidArgument);
  EXPECT_THROW(solveProcrustes(kTwoPoses, bad), InvalidArgument);
}

}  // namespace
}  // namespace hexoderm
