#include "hexoderm/mounting/place/placement_search.h"

#include "tests/core/mounting/place/laid_patches.h"

namespace hexoderm {
namespace {

using Kind = FreeDirection::Kind;

/// The points of a free direction's axis and the twist say the same.
void expectTwistAboutAxis(const FreeDirection& free) {
  if (free.kind == Kind::Slide) {
    EXPECT_GT(free.shift_m.norm(), 0.9);
    return;
  }
  const Eigen::Vector3d on_axis = free.shift_m + free.turn_rad.cross(free.through_m);
  EXPECT_LT((on_axis - on_axis.dot(free.axis) * free.axis).norm(), 1e-9);
}

/// From the lowest cell to the highest along an axis of the link.
double extentAlong(const LaidPatch& laid, Eigen::Index axis) {
  double lowest = laid.T_l_o.t[axis];
  double highest = lowest;
  for (const SE3& T_l_u : laid.T_l_u) {
    lowest = std::min(lowest, T_l_u.t[axis]);
    highest = std::max(highest, T_l_u.t[axis]);
  }
  return highest - lowest;
}

TEST(Freedom, AxesAreNamed) {
  EXPECT_EQ(axisText({0, 0.05, -1}).english(), "the link's z axis");
  EXPECT_EQ(axisText({0.6, 0.8, 0}).english(), "the direction (0.60, 0.80, 0.00) of the link");
}

// Turned any way, the patch can slide along a cylinder and turn around it.
TEST(Freedom, ACylinderLeavesASlideAndATurn) {
  const auto& [radius_m, mesh, laid] = OnCylinder();
  PlaceTask task = surfaceTask(mesh, laid);
  // It is known which of its ends is up, but not how it is turned about the cylinder.
  Eigen::Matrix3d covariance_l = std::pow(1 * kDegree, 2) * Eigen::Matrix3d::Identity();
  covariance_l(2, 2) = kPi * kPi;
  const Eigen::Matrix3d R = laid.T_l_o.R;
  task.patches.front().rotation = KnownRotation{R, R.transpose() * covariance_l * R};
  const PlaceResult result = placePatches(task);
  ASSERT_EQ(result.verdict, PlaceVerdict::Open) << result.summary;
  ASSERT_THAT(result.candidates, SizeIs(1));
  const std::vector<FreeDirection>& free = result.candidates[0].patches[0].free;
  ASSERT_THAT(free, SizeIs(2)) << result.summary;
  EXPECT_EQ(free[0].kind, Kind::Slide);
  EXPECT_LT(angleBetween(free[0].axis, Eigen::Vector3d::UnitZ()), 2 * kDegree);
  EXPECT_FALSE(free[0].held_by_rotation);
  // From end to end, less the patch's own length and a cell's width.
  EXPECT_NEAR(free[0].forward_m + free[0].backward_m, 0.4 - extentAlong(laid, 2), 0.02);
  EXPECT_EQ(free[1].kind, Kind::Turn);
  EXPECT_LT(angleBetween(free[1].axis, Eigen::Vector3d::UnitZ()), 3 * kDegree);
  EXPECT_LT(free[1].through_m.head<2>().norm(), 0.006);
  EXPECT_TRUE(free[1].all_the_way) << free[1].words;
  for (const FreeDirection& direction : free) expectTwistAboutAxis(direction);
  EXPECT_THAT(result.summary.english(), ::testing::AllOf(HasSubstr("slide along the link's z axis, by"),
                                                         HasSubstr("turn around an axis along the link's z axis"),
                                                         HasSubstr("all the way round")));
}

// Where gravity says how it is turned, both are named, and that gravity alone holds the turn.
TEST(Freedom, AKnownRotationHoldsTheTurn) {
  const auto& [radius_m, mesh, laid] = OnCylinder();
  const PlaceResult result = placePatches(surfaceTask(mesh, laid));
  ASSERT_EQ(result.verdict, PlaceVerdict::Open) << result.summary;
  const std::vector<FreeDirection>& free = result.candidates[0].patches[0].free;
  ASSERT_THAT(free, SizeIs(2)) << result.summary;
  EXPECT_EQ(free[0].kind, Kind::Slide);
  EXPECT_FALSE(free[0].held_by_rotation);
  EXPECT_EQ(free[1].kind, Kind::Turn);
  EXPECT_TRUE(free[1].held_by_rotation);
  EXPECT_NEAR(free[1].sigma_m, radius_m * kDegree, 0.5 * radius_m * kDegree);
  EXPECT_THAT(free[1].words.english(), HasSubstr("Nothing but its known rotation keeps it from being free to turn"));
}

TEST(Freedom, AFlatFaceLeavesTwoSlides) {
  const TriangleMesh mesh = meshOfBox({0.4, 0.3, 0.1});
  const LaidPatch laid = layPatch(mesh, {Eigen::Matrix3d::Identity(), {0, 0, 0.06}});
  const PlaceResult result = placePatches(surfaceTask(mesh, laid));
  ASSERT_EQ(result.verdict, PlaceVerdict::Open) << result.summary;
  const std::vector<FreeDirection>& free = result.candidates[0].patches[0].free;
  ASSERT_THAT(free, SizeIs(3)) << result.summary;
  EXPECT_LT(angleBetween(free[0].axis, Eigen::Vector3d::UnitX()), 1 * kDegree);
  EXPECT_LT(angleBetween(free[1].axis, Eigen::Vector3d::UnitY()), 1 * kDegree);
  EXPECT_EQ(free[2].kind, Kind::Turn);
  EXPECT_TRUE(free[2].held_by_rotation);
  EXPECT_THAT(free[2].words.english(), HasSubstr("turn on the spot, about the link's z axis"));
  EXPECT_NEAR(free[0].forward_m + free[0].backward_m, 0.4 - extentAlong(laid, 0), 0.02);
  EXPECT_NEAR(free[1].forward_m + free[1].backward_m, 0.3 - extentAlong(laid, 1), 0.02);
}

TEST(Freedom, ASphereLeavesThreeTurnsAboutItsMiddle) {
  const TriangleMesh mesh = meshOfSphere(0.08);
  const PlaceResult result =
      placePatches(surfaceTask(mesh, layPatch(mesh, {rotationFromRpy({0, kPi / 2, 0}), {0.09, 0, 0}})));
  ASSERT_FALSE(result.candidates.empty());
  const std::vector<FreeDirection>& free = result.candidates[0].patches[0].free;
  ASSERT_THAT(free, SizeIs(3)) << result.summary;
  for (const FreeDirection& direction : free) {
    EXPECT_NE(direction.kind, Kind::Slide) << direction.words;
    EXPECT_TRUE(direction.held_by_rotation);
    expectTwistAboutAxis(direction);
    EXPECT_LT(direction.through_m.cross(direction.axis).norm(), 0.01);
  }
}

}  // namespace
}  // namespace hexoderm
