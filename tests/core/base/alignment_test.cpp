#include "hexoderm/base/procrustes.h"

#include "tests/support/testing.h"

namespace hexoderm {
namespace {

const std::vector<Eigen::Vector3d> kPoints = {{0, 0, 0}, {1, 0, 0}, {0, 2, 0}, {0, 0, 3}, {1, 1, -1}};

std::vector<Eigen::Vector3d> mapped(const SE3& T, const std::vector<Eigen::Vector3d>& points) {
  return collect(points, [&T](const Eigen::Vector3d& x) { return Eigen::Vector3d(T * x); });
}

TEST(AlignPoints, RecoversTheTransformFromTheSecondSetToTheFirst) {
  const SE3 T_a_b{expSO3({0.3, -2, 0.4}), {10, -20, 30}};
  const SE3 found = alignPoints(mapped(T_a_b, kPoints), kPoints);
  EXPECT_LT((found.R - T_a_b.R).norm(), 1e-14);
  EXPECT_LT((found.t - T_a_b.t).norm(), 1e-13);
}

TEST(AlignPoints, DoesNotMirrorAMirroredSet) {
  std::vector<Eigen::Vector3d> mirrored = kPoints;
  for (Eigen::Vector3d& x : mirrored) x.x() = -x.x();
  EXPECT_NEAR(alignPoints(kPoints, mirrored).R.determinant(), 1, 1e-14);
}

TEST(AlignPoints, FitsAFlatPatchExactly) {
  const std::vector<Eigen::Vector3d> flat = {{0, 0, 0}, {1, 0, 0}, {0, 2, 0}};
  const SE3 T{expSO3({1, 1, 1}), {1, 2, 3}};
  EXPECT_LT((alignPoints(mapped(T, flat), flat).R - T.R).norm(), 1e-14);
}

TEST(AlignPoints, FewPointsAreStillMappedOntoEachOther) {
  const SE3 T{expSO3({0.1, 0.2, 0.3}), {1, 2, 3}};
  for (std::size_t count = 1; count <= 2; ++count) {
    const std::vector<Eigen::Vector3d> b(kPoints.begin(), kPoints.begin() + static_cast<std::ptrdiff_t>(count));
    const std::vector<Eigen::Vector3d> a = mapped(T, b);
    const SE3 found = alignPoints(a, b);
    for (std::size_t k = 0; k < count; ++k) EXPECT_LT((found * b[k] - a[k]).norm(), 1e-14);
  }
  const SE3 none = alignPoints({}, {});
  EXPECT_EQ(none.R, Eigen::Matrix3d::Identity());
  EXPECT_EQ(none.t, Eigen::Vector3d::Zero());
}

TEST(AlignPoints, RefusesSetsOfDifferentSize) {
  EXPECT_THROW(alignPoints(kPoints, std::span(kPoints).first(2)), InvalidArgument);
}

TEST(ChordalMean, OfSymmetricDeviationsIsTheMiddle) {
  const Eigen::Matrix3d R = expSO3({0.5, -0.4, 1.2});
  const std::vector<Eigen::Matrix3d> rotations = {R * expSO3({0.2, 0, 0}), R * expSO3({-0.2, 0, 0}),
                                                  R * expSO3({0, 0.1, 0}), R * expSO3({0, -0.1, 0})};
  EXPECT_LT((chordalMean(rotations) - R).norm(), 1e-14);
}

TEST(ChordalMean, OfNothingIsTheIdentity) { EXPECT_EQ(chordalMean({}), Eigen::Matrix3d::Identity()); }

}  // namespace
}  // namespace hexoderm
