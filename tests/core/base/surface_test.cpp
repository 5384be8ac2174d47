#include "hexoderm/base/surface.h"

#include "hexoderm/base/units.h"
#include "tests/support/testing.h"

namespace hexoderm {
namespace {

class AnySurface : public testing::TestWithParam<const char*> {
 protected:
  const std::unique_ptr<Surface> surface_ = makeSurface(GetParam());
  const SE3 middle_ = surface_->middle();

  /// A unit tangent at the middle, `angle_rad` from "around".
  [[nodiscard]] Eigen::Vector3d tangent(double angle_rad) const {
    return middle_.R * Eigen::Vector3d(std::cos(angle_rad), std::sin(angle_rad), 0);
  }
};

INSTANTIATE_TEST_SUITE_P(Surfaces, AnySurface,
                         testing::Values("plane", "cylinder:r=0.05", "sphere:r=0.08", "cone:r=0.06,angle=0.3",
                                         "torus:R=0.2,r=0.05"));

TEST_P(AnySurface, MiddleIsARightHandedFrameOnTheSurface) {
  EXPECT_LT((middle_.R.transpose() * middle_.R - Eigen::Matrix3d::Identity()).norm(), 1e-14);
  EXPECT_NEAR(middle_.R.determinant(), 1, 1e-14);
  EXPECT_LT((surface_->project(middle_.t) - middle_.t).norm(), 1e-15);
  EXPECT_LT((surface_->normal(middle_.t) - middle_.R.col(2)).norm(), 1e-14);
}

TEST_P(AnySurface, NormalIsPerpendicularToTheSurfaceAndPointsOutOfTheBody) {
  const Eigen::Vector3d x = surface_->walk(middle_.t, tangent(0.7), 0.03).position;
  const Eigen::Vector3d n = surface_->normal(x);
  EXPECT_NEAR(n.norm(), 1, 1e-14);
  const Eigen::Vector3d raised = x + 0.001 * n;
  EXPECT_LT((surface_->project(raised) - x).norm(), 1e-14);
  EXPECT_LT((surface_->normal(raised) - n).norm(), 1e-12);
}

TEST_P(AnySurface, WeingartenMapIsTheDerivativeOfTheNormal) {
  const Eigen::Vector3d x = surface_->walk(middle_.t, tangent(0.7), 0.03).position;
  const Eigen::Vector3d n = surface_->normal(x);
  const Eigen::Matrix3d W = surface_->weingarten(x);
  EXPECT_LT((W * n).norm(), 1e-12);
  EXPECT_LT((W - W.transpose()).norm(), 1e-12);
  for (const double angle : {0.0, 1.0, 2.0}) {
    const Eigen::Vector3d u = expSO3(angle * n) * n.unitOrthogonal();
    const double step = 1e-5;
    const Eigen::Vector3d dn =
        surface_->normal(surface_->walk(x, u, step).position) - surface_->normal(surface_->walk(x, u, -step).position);
    EXPECT_LT((dn / (2 * step) - W * u).norm(), 1e-6);
  }
}

TEST_P(AnySurface, WalksAreOnTheSurfaceHaveTheirLengthAndDoNotTurn) {
  for (const double angle : {0.0, 0.5, 1.6, 2.9, -2.0}) {
    const double length = 0.06;
    const int steps = 2000;
    Eigen::Vector3d before = middle_.t;
    Eigen::Vector3d direction_before = tangent(angle);
    double travelled = 0;
    for (int k = 1; k <= steps; ++k) {
      const GeodesicPoint now = surface_->walk(middle_.t, tangent(angle), length * k / steps);
      EXPECT_LT((surface_->project(now.position) - now.position).norm(), 1e-14);
      const Eigen::Vector3d n = surface_->normal(now.position);
      EXPECT_NEAR(now.direction.norm(), 1, 1e-12);
      EXPECT_NEAR(now.direction.dot(n), 0, 1e-12);
      travelled += (now.position - before).norm();
      // A geodesic's direction changes along the normal only.
      const Eigen::Vector3d change = now.direction - direction_before;
      EXPECT_NEAR(change.dot(n.cross(now.direction)), 0, 1e-6);
      before = now.position;
      direction_before = now.direction;
    }
    EXPECT_NEAR(travelled, length, 1e-7);
  }
}

TEST_P(AnySurface, BearingInvertsAWalk) {
  for (const double angle : {0.0, 0.6, -1.5, 2.8}) {
    const GeodesicPoint end = surface_->walk(middle_.t, tangent(angle), 0.03);
    EXPECT_LT((surface_->bearing(middle_.t, end.position) - 0.03 * tangent(angle)).norm(), 1e-11);
    EXPECT_LT((surface_->bearing(end.position, middle_.t) + 0.03 * end.direction).norm(), 1e-9);
  }
  EXPECT_EQ(surface_->bearing(middle_.t, middle_.t).norm(), 0);
}

TEST(Surface, TorusMeridianAndOuterEquatorAreCircles) {
  const auto surface = makeSurface("torus:R=0.2,r=0.05");
  const SE3 middle = surface->middle();
  const GeodesicPoint meridian = surface->walk(middle.t, middle.R.col(1), kPi / 2 * 0.05);
  EXPECT_LT((meridian.position - Eigen::Vector3d(0.2, 0, 0.05)).norm(), 1e-9);
  const GeodesicPoint equator = surface->walk(middle.t, middle.R.col(0), kPi / 2 * 0.25);
  EXPECT_LT((equator.position - Eigen::Vector3d(0, 0.25, 0)).norm(), 1e-8);
}

TEST(Surface, ConeNarrowsUpwards) {
  const auto surface = makeSurface("cone:r=0.06,angle=0.3");
  const SE3 middle = surface->middle();
  const Eigen::Vector3d up = surface->walk(middle.t, middle.R.col(1), 0.05).position;
  EXPECT_NEAR(up.z(), 0.05 * std::cos(0.3), 1e-15);
  EXPECT_NEAR(up.x(), 0.06 - 0.05 * std::sin(0.3), 1e-15);
}

class BadSurface : public testing::TestWithParam<std::pair<const char*, const char*>> {};

TEST_P(BadSurface, IsRefusedWithAReason) {
  const auto& [description, reason] = GetParam();
  EXPECT_THAT(test::messageOf<InvalidArgument>([d = description] { makeSurface(d); }),
              test::saysAll(description, reason));
}

INSTANTIATE_TEST_SUITE_P(
    Descriptions, BadSurface,
    testing::Values(std::pair("", "expected plane"), std::pair("cube:a=1", "expected plane"),
                    std::pair("plane:r=1", "there is no \"r\""), std::pair("cylinder", "r is missing"),
                    std::pair("cylinder:", "r is missing"), std::pair("cylinder:r", "not name=value"),
                    std::pair("cylinder:r=", "expected a number"), std::pair("cylinder:r=5cm", "expected a number"),
                    std::pair("cylinder:r=nan", "finite"), std::pair("cylinder:r=inf", "finite"),
                    std::pair("cylinder:r=0", "above 0"), std::pair("sphere:r=-1", "above 0"),
                    std::pair("sphere:r=1,r=2", "given twice"),
                    std::pair("torus:R=1e6,r=1", "R must be above 0 and at most 100000"),
                    std::pair("cone:r=1", "angle is missing"), std::pair("cone:r=1,angle=1.6", "below pi/2"),
                    std::pair("torus:R=1,r=2", "larger than r")));

}  // namespace
}  // namespace hexoderm
