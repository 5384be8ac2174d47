#include "hexoderm/mounting/parts/rigid_fit.h"

#include "tests/core/mounting/parts/gravity_draw.h"

namespace hexoderm {
namespace {

constexpr double kMinProbable = 1e-3;

/// Of what two bodies see, drawn for b first: inside a call the order would be the compiler's choice.
Hinge fitDrawn(GravityDraw& draw, const std::vector<Eigen::Vector3d>& up_a, const std::vector<Eigen::Vector3d>& up_b,
               const GravityErrors& errors = {}, double scale = 1) {
  const GravitySeen b = draw.see(up_b, errors, scale);
  return fitHinge(draw.see(up_a, errors, scale), b, kMinProbable);
}

/// Angle between an axis and the true one, either sign.
double missOf(const Eigen::Vector3d& u, const Eigen::Vector3d& truth) {
  const double angle = angleBetween(u, truth);
  return std::min(angle, kPi - angle);
}

/// How far each angle is off, with its sigma; not of poses that show none, nor of the reference.
std::vector<std::pair<double, double>> angleErrorsOf(const Hinge& hinge, const DrawnHinge& truth) {
  const double sign = hinge.a.u.dot(truth.u_a) < 0 ? -1 : 1;
  const double at_reference = truth.angle[hinge.reference->value() - 1];
  std::vector<std::pair<double, double>> errors;
  for (const HingeAngle& angle : hinge.angles) {
    if (!angle.angle_rad || angle.pose == *hinge.reference) continue;
    const double expected = sign * (truth.angle[angle.pose.value() - 1] - at_reference);
    errors.emplace_back(std::remainder(*angle.angle_rad - expected, 2 * kPi), angle.sigma_rad);
  }
  return errors;
}

TEST(Hinge, ExactDirectionsGiveTheExactAxisAndAngles) {
  for (const std::size_t poses : {6U, 8U, 12U}) {
    for (std::uint64_t seed = 1; seed <= 10; ++seed) {
      GravityDraw draw(seed);
      const DrawnHinge truth = drawHinge(draw, poses, 0.7);
      const GravityErrors errors{1e-5, 1e-5, 1e-5};
      const Hinge hinge = fitDrawn(draw, truth.up_a, truth.up_b, errors, 0);
      ASSERT_EQ(hinge.knowledge, HingeKnowledge::Found) << poses << ", " << seed << ": " << hinge.why;
      EXPECT_LE(missOf(hinge.a.u, truth.u_a), 1e-6);
      EXPECT_LE(missOf(hinge.b.u, truth.u_b), 1e-6);
      EXPECT_LE((hinge.R_a_b * hinge.b.u - hinge.a.u).norm(), 1e-9);
      for (const auto& [error, sigma] : angleErrorsOf(hinge, truth)) EXPECT_LE(std::abs(error), 1e-4);
      EXPECT_EQ(hinge.freedom, static_cast<int>(poses) - 4);
    }
  }
}

TEST(Hinge, ErrorsAndMisfitsAreAsLargeAsStated) {
  constexpr int kSeeds = 200;
  double axes = 0;
  double angles = 0;
  double angle_count = 0;
  double misfit = 0;
  int found = 0;
  for (int seed = 0; seed < kSeeds; ++seed) {
    GravityDraw draw(static_cast<std::uint64_t>(seed));
    const DrawnHinge truth = drawHinge(draw, 8, 0.7);
    const Hinge hinge = fitDrawn(draw, truth.up_a, truth.up_b);
    if (hinge.knowledge != HingeKnowledge::Found) continue;
    ++found;
    axes += neesOfAxis(hinge.a.u, hinge.a.covariance, truth.u_a) / 2;
    axes += neesOfAxis(hinge.b.u, hinge.b.covariance, truth.u_b) / 2;
    misfit += hinge.chi_squared / hinge.freedom;
    for (const auto& [error, sigma] : angleErrorsOf(hinge, truth)) {
      angles += error * error / (sigma * sigma);
      ++angle_count;
    }
  }
  EXPECT_GE(found, 0.9 * kSeeds);
  EXPECT_NEAR(axes / found, 1, 0.25);
  EXPECT_NEAR(misfit / found, 1, 0.2);
  EXPECT_NEAR(angles / angle_count, 1, 0.3);
}

TEST(Hinge, IsTheSameFromBothSides) {
  GravityDraw draw(5);
  const DrawnHinge truth = drawHinge(draw, 8, 0.7);
  const GravitySeen a = draw.see(truth.up_a, {});
  const GravitySeen b = draw.see(truth.up_b, {});
  const Hinge hinge = fitHinge(a, b, kMinProbable);
  const Hinge back = fitHinge(b, a, kMinProbable);
  ASSERT_EQ(hinge.knowledge, HingeKnowledge::Found) << hinge.why;
  ASSERT_EQ(back.knowledge, HingeKnowledge::Found) << back.why;
  EXPECT_LE(missOf(hinge.a.u, back.b.u), 1e-3);
  EXPECT_LE(missOf(hinge.b.u, back.a.u), 1e-3);
  EXPECT_NEAR(hinge.chi_squared, back.chi_squared, 0.05 * hinge.chi_squared + 1e-3);
  EXPECT_NEAR(hinge.a.sigma_rad, back.b.sigma_rad, 0.05 * hinge.a.sigma_rad);
}

TEST(Hinge, FourPosesAreTooFew) {
  GravityDraw draw(6);
  const DrawnHinge truth = drawHinge(draw, 4, 0.7);
  const Hinge hinge = fitDrawn(draw, truth.up_a, truth.up_b);
  EXPECT_EQ(hinge.knowledge, HingeKnowledge::NotDetermined);
  EXPECT_FALSE(hinge.reference.has_value());
  EXPECT_EQ(hinge.why.english(), "An axis between two parts takes at least 5 poses, and there are 4.");
}

TEST(Hinge, TwoJointsHaveNoAxis) {
  constexpr int kSeeds = 100;
  int none = 0;
  int found = 0;
  for (int seed = 0; seed < kSeeds; ++seed) {
    GravityDraw draw(static_cast<std::uint64_t>(seed));
    const std::vector<Eigen::Vector3d> up = draw.directions(8);
    std::vector<Eigen::Vector3d> up_b;  // as across a ball joint
    for (const Eigen::Vector3d& g : up) up_b.emplace_back(expSO3(0.5 * draw.vector()) * g);
    const Hinge hinge = fitDrawn(draw, up, up_b);
    none += hinge.knowledge == HingeKnowledge::NoAxis ? 1 : 0;
    found += hinge.knowledge == HingeKnowledge::Found ? 1 : 0;
  }
  EXPECT_GE(none, 95);
  EXPECT_LE(found, 2);
}

// A base that stands still sees gravity from one direction: the axis may be anywhere at the right angle to it.
TEST(Hinge, ABaseThatStandsStillLeavesTheAxisOpenThere) {
  for (std::uint64_t seed = 1; seed <= 20; ++seed) {
    GravityDraw draw(seed);
    DrawnHinge truth = drawHinge(draw, seed <= 10 ? 8 : 40, 0.9);
    const Eigen::Vector3d up = draw.direction();
    const Eigen::Matrix3d R_0 = Eigen::Quaterniond::FromTwoVectors(truth.u_b, truth.u_a).toRotationMatrix();
    for (std::size_t k = 0; k < truth.up_a.size(); ++k) {
      truth.up_a[k] = up;
      truth.up_b[k] = (expSO3(truth.angle[k] * truth.u_a) * R_0).transpose() * up;
    }
    const Hinge hinge = fitDrawn(draw, truth.up_a, truth.up_b);
    EXPECT_EQ(hinge.knowledge, HingeKnowledge::NotDetermined) << hinge.why;
    EXPECT_GT(hinge.a.sigma_rad, kKnownAxis_rad);
    EXPECT_FALSE(hinge.what_would_tell.empty());
  }
}

TEST(Hinge, AJointThatStoodStillHasNoAxisThatIsKnown) {
  GravityDraw draw(8);
  const DrawnHinge truth = drawHinge(draw, 8, 0);
  const Hinge hinge = fitDrawn(draw, truth.up_a, truth.up_b);
  EXPECT_EQ(hinge.knowledge, HingeKnowledge::NotDetermined) << hinge.why;
  EXPECT_TRUE(hinge.a.covariance.allFinite() && hinge.b.covariance.allFinite());
}

TEST(Hinge, GravityAlongTheAxisShowsNoAngle) {
  GravityDraw draw(9);
  DrawnHinge truth = drawHinge(draw, 9, 0.7);
  truth.up_a[4] = truth.u_a;
  truth.up_b[4] = truth.u_b;
  const Hinge hinge = fitDrawn(draw, truth.up_a, truth.up_b);
  ASSERT_EQ(hinge.knowledge, HingeKnowledge::Found) << hinge.why;
  EXPECT_FALSE(hinge.angles[4].angle_rad.has_value());
  EXPECT_EQ(hinge.angles[4].sigma_rad, 0);
}

}  // namespace
}  // namespace hexoderm
