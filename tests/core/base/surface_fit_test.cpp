#include "hexoderm/base/surface_fit.h"

#include "hexoderm/base/se3.h"
#include "hexoderm/base/units.h"
#include "tests/support/testing.h"

namespace hexoderm {
namespace {

using Points = std::vector<Eigen::Vector3d>;

const SE3 kSomewhere{expSO3({0.4, -1.1, 0.7}), {0.3, -0.2, 0.5}};

Points moved(const SE3& T, const Points& points) {
  return collect(points, [&T](const Eigen::Vector3d& x) { return Eigen::Vector3d(T * x); });
}

Points scaled(double factor, const Points& points) {
  return collect(points, [factor](const Eigen::Vector3d& x) { return Eigen::Vector3d(factor * x); });
}

Points noisy(double sigma, const Points& points) {
  std::mt19937 random(11);
  std::normal_distribution<double> normal(0, sigma);
  Points result = points;
  for (Eigen::Vector3d& x : result) {
    for (double& value : x) value += normal(random);
  }
  return result;
}

/// An X of 17 points on a cylinder about z, `span_rad` wide: a patch as the paper's.
Points crossOnCylinder(double radius, double span_rad) {
  Points points = {{radius, 0, 0}};
  for (int k = 1; k <= 4; ++k) {
    for (const double side : {-1.0, 1.0}) {
      for (const double height : {-1.0, 1.0}) {
        const double angle = side * span_rad / 2 * k / 4;
        points.emplace_back(radius * std::cos(angle), radius * std::sin(angle), height * 0.014 * k);
      }
    }
  }
  return points;
}

Points onSphere(double radius, double cap_rad) {
  Points points;
  for (int ring = 0; ring <= 3; ++ring) {
    for (int k = 0; k < 6; ++k) {
      const double a = cap_rad * ring / 3;
      const double b = kPi / 3 * k + 0.2 * ring;
      points.emplace_back(radius * std::sin(a) * std::cos(b), radius * std::sin(a) * std::sin(b), radius * std::cos(a));
    }
  }
  return points;
}

Points onPlane() { return {{0, 0, 0}, {0.1, 0, 0}, {0, 0.2, 0}, {0.1, 0.15, 0}, {-0.1, 0.05, 0}, {0.03, -0.1, 0}}; }

double angleBetweenAxes(const Eigen::Vector3d& a, const Eigen::Vector3d& b) {
  return std::asin(std::min(1.0, a.cross(b).norm()));
}

TEST(PlaneFit, IsExactWithoutNoise) {
  const SurfaceFit fit = fitPlane(moved(kSomewhere, onPlane()));
  EXPECT_LT(angleBetweenAxes(fit.axis, kSomewhere.R.col(2)), 1e-14);
  EXPECT_LT(rms(fit.distance_m), 1e-15);
}

TEST(PlaneFit, DistancesAreSignedAndMinimal) {
  Points points = onPlane();
  for (Eigen::Vector3d& x : points) x.z() = 0;
  points.emplace_back(0.02, 0.05, 0.01);
  const SurfaceFit fit = fitPlane(points);
  EXPECT_NEAR(fit.axis.norm(), 1, 1e-14);
  double sum = 0;
  for (std::size_t k = 0; k < points.size(); ++k) {
    EXPECT_NEAR(fit.distance_m[k], fit.axis.dot(points[k] - fit.point), 1e-15);
    sum += fit.distance_m[k];
  }
  EXPECT_NEAR(sum, 0, 1e-15);
  EXPECT_GT(fit.distance_m.back() * fit.axis.z(), 0);
}

TEST(SphereFit, IsExactWithoutNoiseAlsoOnASmallCap) {
  for (const double cap_rad : {0.3, 1.0, 2.5}) {
    const SurfaceFit fit = fitSphere(moved(kSomewhere, onSphere(0.08, cap_rad)));
    EXPECT_NEAR(fit.radius_m, 0.08, 1e-12) << cap_rad;
    EXPECT_LT((fit.point - kSomewhere.t).norm(), 1e-12) << cap_rad;
    EXPECT_LT(rms(fit.distance_m), 1e-13) << cap_rad;
  }
}

TEST(SphereFit, IsGeometricNotAlgebraic) {
  // At the minimum of the orthogonal distances their sum is zero (the radius' derivative).
  const SurfaceFit fit = fitSphere(noisy(0.002, onSphere(0.08, 0.8)));
  double sum = 0;
  for (const double d : fit.distance_m) sum += d;
  EXPECT_NEAR(sum, 0, 1e-10);
  EXPECT_NEAR(fit.radius_m, 0.08, 0.01);
}

class CylinderArc : public testing::TestWithParam<double> {};

TEST_P(CylinderArc, IsExactWithoutNoise) {
  const SurfaceFit fit = fitCylinder(moved(kSomewhere, crossOnCylinder(0.0501, GetParam() * kDegree)));
  EXPECT_NEAR(fit.radius_m, 0.0501, 1e-9);
  EXPECT_LT(angleBetweenAxes(fit.axis, kSomewhere.R.col(2)), 1e-9);
  const Eigen::Vector3d from_axis = kSomewhere.inverse() * fit.point;
  EXPECT_LT(from_axis.head<2>().norm(), 1e-9);
  EXPECT_LT(rms(fit.distance_m), 1e-10);
}

INSTANTIATE_TEST_SUITE_P(Spans, CylinderArc, testing::Values(20, 60, 120, 220, 360));

TEST(CylinderFit, PointIsTheFootOfTheCentroid) {
  const Points points = moved(kSomewhere, crossOnCylinder(0.0501, 2));
  Eigen::Vector3d centroid = Eigen::Vector3d::Zero();
  for (const Eigen::Vector3d& x : points) centroid += x / static_cast<double>(points.size());
  const SurfaceFit fit = fitCylinder(points);
  EXPECT_NEAR(fit.axis.dot(centroid - fit.point), 0, 1e-12);
  EXPECT_NEAR(fit.axis.norm(), 1, 1e-14);
}

/// No cylinder (angle 0) or cone nearby has a smaller sum of squared distances.
void expectMinimum(const Points& points, const SurfaceFit& fit) {
  const double half_angle_rad = fit.half_angle_rad;
  const auto cost = [&](const Eigen::Vector3d& point, const Eigen::Vector3d& axis, double radius, double angle) {
    double sum = 0;
    for (const Eigen::Vector3d& x : points) {
      const Eigen::Vector3d a = axis.normalized();
      sum += std::pow((a.cross(x - point).norm() - radius) * std::cos(angle) - a.dot(x - point) * std::sin(angle), 2);
    }
    return sum;
  };
  const double best = cost(fit.point, fit.axis, fit.radius_m, half_angle_rad);
  EXPECT_NEAR(std::sqrt(best / static_cast<double>(points.size())), rms(fit.distance_m), 1e-12);
  for (const double step : {-1e-5, 1e-5}) {
    EXPECT_GT(cost(fit.point, fit.axis, fit.radius_m + step, half_angle_rad), best);
    if (half_angle_rad > 0) {
      EXPECT_GT(cost(fit.point, fit.axis, fit.radius_m, half_angle_rad + step), best);
    }
    for (int k = 0; k < 3; ++k) {
      const Eigen::Vector3d across = fit.axis.cross(Eigen::Vector3d::Unit(k));
      if (across.norm() < 0.5) continue;
      EXPECT_GT(cost(fit.point + step * across, fit.axis, fit.radius_m, half_angle_rad), best);
      EXPECT_GT(cost(fit.point, fit.axis + step * across, fit.radius_m, half_angle_rad), best);
    }
  }
}

TEST(CylinderFit, FindsALongThinAndAShortWideCylinder) {
  for (const double height : {0.004, 1.0}) {
    Points points;
    for (int k = 0; k < 24; ++k) {
      points.emplace_back(0.05 * std::cos(0.26 * k), 0.05 * std::sin(0.26 * k), height * ((k * 7) % 5 - 2));
    }
    const SurfaceFit fit = fitCylinder(moved(kSomewhere, points));
    EXPECT_NEAR(fit.radius_m, 0.05, 1e-9) << height;
    EXPECT_LT(angleBetweenAxes(fit.axis, kSomewhere.R.col(2)), 1e-8) << height;
  }
}

TEST(CylinderFit, RunsThroughNearlyFlatPoints) { EXPECT_LT(rms(fitCylinder(noisy(1e-6, onPlane())).distance_m), 1e-5); }

/// Points on a cone about z that widens upwards, apex at the origin, over part of its circumference.
Points onCone(double half_angle_rad, double from_z, double span_rad) {
  Points points;
  for (int ring = 0; ring <= 4; ++ring) {
    for (int k = 0; k < 6; ++k) {
      const double z = from_z + 0.015 * ring;
      const double b = span_rad * (k - 2.5) / 5 + 0.05 * ring;
      const double radius = z * std::tan(half_angle_rad);
      points.emplace_back(radius * std::cos(b), radius * std::sin(b), z);
    }
  }
  return points;
}

class ConeAngle : public testing::TestWithParam<std::tuple<double, double>> {};

TEST_P(ConeAngle, IsExactWithoutNoise) {
  const auto& [angle, span] = GetParam();
  const SurfaceFit fit = fitCone(moved(kSomewhere, onCone(angle * kDegree, 0.05, span * kDegree)));
  EXPECT_LT(rms(fit.distance_m), 1e-9);
  EXPECT_NEAR(fit.half_angle_rad, angle * kDegree, 1e-6);
  EXPECT_LT((fit.axis - kSomewhere.R.col(2)).norm(), 1e-6) << "towards the wide end";
  const Eigen::Vector3d apex = fit.point - fit.axis * fit.radius_m / std::tan(fit.half_angle_rad);
  EXPECT_LT((apex - kSomewhere.t).norm(), 1e-6);
}

INSTANTIATE_TEST_SUITE_P(Cones, ConeAngle,
                         testing::Combine(testing::Values(5.0, 20.0, 45.0, 70.0), testing::Values(90.0, 200.0, 300.0)));

TEST(SurfaceFits, OfNoisyPointsAreMinimaWhateverTheirUnitsPlaceAndOrder) {
  for (const auto& [fitted, points, radius_m, half_angle_rad] :
       {std::tuple(&fitCylinder, noisy(0.0005, crossOnCylinder(0.0501, 2)), 0.0501, 0.0),
        std::tuple(&fitCone, noisy(0.0005, onCone(0.4, 0.05, 4)), 0.08 * std::tan(0.4), 0.4)}) {
    const SurfaceFit fit = fitted(points);
    EXPECT_NEAR(fit.radius_m, radius_m, 0.002);
    EXPECT_NEAR(fit.half_angle_rad, half_angle_rad, 0.05);
    EXPECT_LT(angleBetweenAxes(fit.axis, Eigen::Vector3d::UnitZ()), 2 * kDegree);
    expectMinimum(points, fit);
    const auto expectSame = [&](const SurfaceFit& other, double unit_m, const Eigen::Matrix3d& R) {
      EXPECT_NEAR(other.radius_m / unit_m, fit.radius_m, 1e-8);
      EXPECT_NEAR(other.half_angle_rad, fit.half_angle_rad, 1e-7);
      EXPECT_LT(angleBetweenAxes(other.axis, R * fit.axis), 1e-6);
    };
    const Eigen::Matrix3d same = Eigen::Matrix3d::Identity();
    expectSame(fitted(Points(points.rbegin(), points.rend())), 1, same);
    expectSame(fitted(moved(kSomewhere, points)), 1, kSomewhere.R);
    expectSame(fitted(scaled(1e6, points)), 1e6, same);
    expectSame(fitted(scaled(1e-6, points)), 1e-6, same);
  }
}

TEST(ConeFit, OfACylinderIsTheCylinder) {
  const SurfaceFit fit = fitCone(moved(kSomewhere, crossOnCylinder(0.0501, 2)));
  EXPECT_LT(fit.half_angle_rad, 1e-6);
  EXPECT_NEAR(fit.radius_m, 0.0501, 1e-7);
  EXPECT_LT(angleBetweenAxes(fit.axis, kSomewhere.R.col(2)), 1e-6);
}

TEST(ConeFit, IsNeverWorseThanTheCylinder) {
  for (const Points& points : {noisy(0.0005, crossOnCylinder(0.0501, 2)), noisy(0.001, onSphere(0.08, 0.8)),
                               noisy(1e-6, onPlane()), noisy(0.001, onCone(0.3, 0.1, 1))}) {
    const SurfaceFit cylinder = fitCylinder(points);
    const SurfaceFit cone = fitCone(points);
    EXPECT_LE(rms(cone.distance_m), rms(cylinder.distance_m) * (1 + 1e-6));
    for (const SurfaceFit& fit : {cylinder, cone}) {
      EXPECT_TRUE(fit.point.allFinite() && fit.axis.allFinite() && std::isfinite(fit.radius_m));
    }
    EXPECT_GE(cone.half_angle_rad, 0);
  }
}

TEST(SurfaceFits, DistanceIsPositiveOutside) {
  Points sphere = onSphere(0.08, 2.5);
  sphere.emplace_back(0, 0, -0.09);
  EXPECT_GT(fitSphere(sphere).distance_m.back(), 0);
  Points cylinder = crossOnCylinder(0.05, 3);
  cylinder.emplace_back(0.055, 0, 0.01);
  EXPECT_GT(fitCylinder(cylinder).distance_m.back(), 0);
}

TEST(SurfaceFits, RefusePointsThatAreTooFewOrDegenerateOrNotFinite) {
  EXPECT_THROW(fitPlane(Points{{0, 0, 0}, {1, 1, 1}}), InvalidArgument);
  EXPECT_THROW(fitPlane(moved(kSomewhere, Points{{0, 0, 0}, {1, 1, 1}, {2, 2, 2}, {-3, -3, -3}})), InvalidArgument);
  EXPECT_THROW(fitPlane(Points{{1, 2, 3}, {1, 2, 3}, {1, 2, 3}}), InvalidArgument);
  EXPECT_THROW(fitSphere(Points{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}), InvalidArgument);
  EXPECT_THROW(fitCylinder(Points{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}}), InvalidArgument);
  EXPECT_THROW(fitCone(Points{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {1, 1, 1}}), InvalidArgument);
  Points not_finite = crossOnCylinder(0.05, 2);
  not_finite[3].y() = std::numeric_limits<double>::quiet_NaN();
  EXPECT_THROW(fitPlane(not_finite), InvalidArgument);
  for (const Points& points : {not_finite, moved(kSomewhere, onPlane())}) {
    EXPECT_THROW(fitSphere(points), InvalidArgument);
    EXPECT_THROW(fitCylinder(points), InvalidArgument);
    EXPECT_THROW(fitCone(points), InvalidArgument);
  }
}

TEST(Rms, IsTheRootOfTheMeanSquare) {
  EXPECT_EQ(rms(std::vector<double>{}), 0);
  EXPECT_DOUBLE_EQ(rms(std::vector<double>{3, -4}), std::sqrt(12.5));
}

}  // namespace
}  // namespace hexoderm
