#include "hexoderm/mounting/place/by_hand.h"

#include "hexoderm/base/mesh_feet.h"
#include "tests/core/mounting/place/laid_patches.h"

namespace hexoderm {
namespace {

double thickness() { return builtInCellModel("hex-bma150").thickness_m; }

/// Rms height of the backs of all cells over the mesh, and the largest angle between a cell and its normal.
std::pair<double, double> offSurface(const TriangleMesh& mesh, const LaidPatch& laid, const SE3& T_l_o) {
  const MeshFeet feet(mesh);
  double sum_m2 = 0;
  double worst_rad = 0;
  for (const SE3& T_o_u : laid.patch.T_o_u) {
    const SE3 T_l_u = T_l_o * T_o_u;
    const Eigen::Vector3d back = T_l_u * Eigen::Vector3d(0, 0, -thickness());
    const MeshFoot foot = feet.footOf(back);
    sum_m2 += (back - foot.position).squaredNorm();
    worst_rad = std::max(worst_rad, angleBetween(T_l_u.R.col(2), foot.normal));
  }
  return {std::sqrt(sum_m2 / static_cast<double>(laid.patch.T_o_u.size())), worst_rad};
}

/// The origin's place around the cylinder and along it.
std::pair<double, double> onCylinder(const SE3& T_l_o) { return {std::atan2(T_l_o.t.y(), T_l_o.t.x()), T_l_o.t.z()}; }

class PatchByHandTest : public ::testing::Test, protected OnCylinder {
 protected:
  PatchByHand hand{mesh, laid.patch, thickness()};
  PlaceTask task = surfaceTask(mesh, laid);

  /// The same of a patch whose rotation nobody knows.
  [[nodiscard]] PatchByHand withoutRotation() const {
    PatchToPlace unknown = laid.patch;
    unknown.rotation.reset();
    return {mesh, unknown, thickness()};
  }
  void expectOnSurface(const SE3& T_l_o) const {
    const auto [height_m, tilt_rad] = offSurface(mesh, laid, T_l_o);
    EXPECT_LT(height_m, 0.0005);
    EXPECT_LT(tilt_rad, 3 * kDegree) << "the cells' z points along the normal";
  }
};

TEST_F(PatchByHandTest, SnapsToTheSurfaceFromAside) {
  // Lifted by 20 mm and tilted by 15 degrees.
  SE3 off = laid.T_l_o;
  off.t += 0.020 * laid.T_l_o.R.col(2);
  off.R = expSO3({0, 15 * kDegree, 0}) * off.R;
  const SE3 snapped = hand.laid(off);
  expectOnSurface(snapped);
  EXPECT_LT(rotationAngle(hand.laid(snapped).R.transpose() * snapped.R), 0.1 * kDegree) << "once is enough";
  // What lies on the surface stays where it is.
  EXPECT_LT(cellError(hand.laid(laid.T_l_o), laid), 0.0005);
}

TEST_F(PatchByHandTest, SlidesAlongAndAroundByWhatItIsTold) {
  SE3 along = laid.T_l_o;
  for (int k = 0; k < 30; ++k) along = hand.slid(along, {0, 0, 0.001});
  expectOnSurface(along);
  const auto [around_0, z_0] = onCylinder(laid.T_l_o);
  const auto [around_along, z_along] = onCylinder(along);
  EXPECT_NEAR(z_along - z_0, 0.030, 0.001);
  EXPECT_NEAR(around_along, around_0, 1 * kDegree);
  EXPECT_LT(rotationAngle(along.R.transpose() * laid.T_l_o.R), 1 * kDegree);

  // Around by 10 mm a step, always across the normal and the axis: its backs are at the radius.
  SE3 around = laid.T_l_o;
  const double turn = 0.010 / radius_m;
  for (int k = 0; k < 8; ++k) {
    const auto [angle, z] = onCylinder(around);
    around = hand.slid(around, 0.010 * Eigen::Vector3d(-std::sin(angle), std::cos(angle), 0));
  }
  expectOnSurface(around);
  const auto [around_now, z_now] = onCylinder(around);
  EXPECT_NEAR(std::remainder(around_now - around_0 - 8 * turn, 2 * kPi), 0, 0.05 * 8 * turn);
  EXPECT_NEAR(z_now, z_0, 0.002);
}

TEST_F(PatchByHandTest, TurnsAboutTheNormal) {
  const SE3 turned = hand.turned(laid.T_l_o, 180 * kDegree);
  expectOnSurface(turned);
  EXPECT_NEAR(rotationAngle(turned.R.transpose() * laid.T_l_o.R), kPi, 3 * kDegree);
}

TEST_F(PatchByHandTest, OnAPlaneItGoesExactlyAsFarAsItIsTold) {
  const TriangleMesh plate = meshOfBox({0.5, 0.5, 0.1});
  const LaidPatch flat = layPatch(plate, {Eigen::Matrix3d::Identity(), {0, 0, 0.06}});
  const PatchByHand on_plate(plate, flat.patch, thickness());
  const SE3 turned = on_plate.turned(flat.T_l_o, 5 * kDegree);
  const Eigen::Matrix3d turn = turned.R * flat.T_l_o.R.transpose();
  EXPECT_LT((logSO3(turn) - Eigen::Vector3d(0, 0, 5 * kDegree)).norm(), 1e-6) << "counter-clockwise from outside";
  const SE3 slid = on_plate.slid(flat.T_l_o, {0.006, 0.008, 0});
  EXPECT_LT((slid.t - flat.T_l_o.t - Eigen::Vector3d(0.006, 0.008, 0)).norm(), 1e-6);
  // A way that is seen obliquely counts with its whole length, as it does on the screen.
  EXPECT_NEAR((on_plate.slid(flat.T_l_o, {0.006, 0, -0.008}).t - flat.T_l_o.t).norm(), 0.010, 1e-6);
  const SE3 pressed = on_plate.slid(flat.T_l_o, {0, 0, -0.010});
  EXPECT_LT((pressed.t - flat.T_l_o.t).norm(), 1e-6) << "straight into the link it goes nowhere";
}

TEST_F(PatchByHandTest, IsPulledByTheCellThatIsGripped) {
  // Gripped at its fifth cell and pulled to the other side of the cylinder.
  const Eigen::Vector3d grip_o = laid.patch.T_o_u[4].t;
  const Eigen::Vector3d target(-radius_m * std::cos(0.3), radius_m * std::sin(0.3), -0.05);
  const SE3 pulled = hand.pulled(laid.T_l_o, grip_o, target);
  expectOnSurface(pulled);
  const Eigen::Vector3d gripped = pulled * grip_o;
  EXPECT_NEAR((gripped - target).norm(), thickness(), 0.001) << "its front is that far above the point";
  // Where it is gripped and not pulled it stays.
  const Eigen::Vector3d below = laid.T_l_o * laid.patch.T_o_u[4] * Eigen::Vector3d(0, 0, -thickness());
  EXPECT_LT(cellError(hand.pulled(laid.T_l_o, grip_o, below), laid), 0.001);
}

TEST_F(PatchByHandTest, BeginsOnTheSideThatGravitySays) {
  const SE3 begun = hand.somewhere();
  expectOnSurface(begun);
  EXPECT_LT(std::abs(std::remainder(onCylinder(begun).first - onCylinder(laid.T_l_o).first, 2 * kPi)), 10 * kDegree);
  // How it is turned about the normal nobody knows then, so that it may stand off at its ends.
  const SE3 anywhere = withoutRotation().somewhere();
  EXPECT_NEAR(anywhere.t.head<2>().norm(), radius_m, 0.025);
  EXPECT_LT(std::abs(anywhere.t.z()), 0.05) << "on no end";
}

TEST_F(PatchByHandTest, GravityObjectsToATurnThatIsNotItsOwn) {
  EXPECT_FALSE(hand.objection(laid.T_l_o));
  const auto said = hand.objection(hand.turned(laid.T_l_o, 40 * kDegree));
  ASSERT_TRUE(said);
  EXPECT_THAT(said->english(), HasSubstr("turned by 40° against what gravity says"));
  EXPECT_FALSE(withoutRotation().objection(withoutRotation().turned(laid.T_l_o, 40 * kDegree)));
}

TEST_F(PatchByHandTest, TakesAMeshThatIsInsideOutTheOtherWayRound) {
  TriangleMesh inside_out = mesh;
  turnInsideOut(inside_out);
  EXPECT_LT(cellError(PatchByHand(inside_out, laid.patch, thickness()).laid(laid.T_l_o), laid), 0.0005);
  EXPECT_THAT(messageOf<InvalidArgument>([&] { PatchByHand({}, laid.patch, thickness()); }),
              HasSubstr("no surface on which a patch could lie"));
  EXPECT_THAT(messageOf<InvalidArgument>([&] { PatchByHand(mesh, PatchToPlace{}, thickness()); }),
              HasSubstr("no patch to place"));
}

// --- the fit from there

TEST_F(PatchByHandTest, WhatIsOpenStaysWhereItWasPut) {
  const PlaceResult without = placePatches(task);
  ASSERT_FALSE(without.candidates.empty());
  ASSERT_EQ(without.verdict, PlaceVerdict::Open) << without.summary;

  // 83 mm along the cylinder, where nothing but the operator says that it is.
  SE3 put = laid.T_l_o;
  put.t.z() -= 0.083;
  put.t += 0.001 * put.R.col(2);
  task.patches[0].start = put;
  const PlaceResult result = placePatches(task);
  EXPECT_EQ(result.verdict, PlaceVerdict::Open) << "a way leads to it: " << result.summary;
  ASSERT_THAT(result.candidates, SizeIs(without.candidates.size() + 1));
  const auto by_hand = std::ranges::find(result.candidates, true, &PlaceCandidate::by_hand);
  ASSERT_NE(by_hand, result.candidates.end());
  EXPECT_TRUE(by_hand->fits);
  const SE3& placed = by_hand->patches[0].place.T_l_o;
  EXPECT_NEAR(placed.t.z(), put.t.z(), 0.002);
  EXPECT_LT(offSurface(mesh, laid, placed).first, 0.0005) << "it was put 1 mm above the surface";
  EXPECT_TRUE(result.remarks.empty());
  EXPECT_TRUE(std::ranges::is_sorted(result.candidates, {}, &PlaceCandidate::chi_squared));
}

TEST(PlaceByHand, APlaceThatWasFoundAnywayIsMarked) {
  const TriangleMesh mesh = demoBody("forearm");
  const LaidPatch laid = layPatch(mesh, {rotationFromRpy({0, 0, kPi / 2}), {0.08, 0, 0.12}});
  PlaceTask task = surfaceTask(mesh, laid);
  task.points = {{CellId(1), laid.T_l_u[0].t, 0.001}};
  const PlaceResult without = placePatches(task);
  ASSERT_FALSE(without.candidates.empty());
  task.patches[0].start = without.candidates.front().patches[0].place.T_l_o;
  const PlaceResult result = placePatches(task);
  ASSERT_EQ(result.candidates.size(), without.candidates.size());
  EXPECT_TRUE(result.candidates.front().by_hand);
  EXPECT_EQ(result.verdict, without.verdict);
}

TEST_F(PatchByHandTest, GravityTurnsThePatchBackInTheFitAndSaysSo) {
  task.patches[0].start = hand.turned(laid.T_l_o, 30 * kDegree);
  const PlaceResult result = placePatches(task);
  ASSERT_THAT(result.remarks, SizeIs(1));
  EXPECT_THAT(result.remarks[0].english(),
              testing::AllOf(HasSubstr("put by hand"), HasSubstr("turned by 30° against what gravity says")));
  const auto by_hand = std::ranges::find(result.candidates, true, &PlaceCandidate::by_hand);
  ASSERT_NE(by_hand, result.candidates.end());
  EXPECT_LT(rotationAngle(by_hand->patches[0].place.T_l_o.R.transpose() * laid.T_l_o.R), 5 * kDegree);
}

TEST_F(PatchByHandTest, WhatFitsNowhereIsGivenWhereItWasPutToo) {
  task.surface = meshOfBox({0.4, 0.4, 0.4});
  task.patches[0].start = SE3{laid.T_l_o.R, {0.21, 0.05, 0.05}};
  const PlaceResult result = placePatches(task);
  EXPECT_EQ(result.verdict, PlaceVerdict::NoneFits);
  const auto by_hand = std::ranges::find(result.candidates, true, &PlaceCandidate::by_hand);
  ASSERT_NE(by_hand, result.candidates.end());
  EXPECT_FALSE(by_hand->fits);
  task.patches[0].start->R *= 2;
  EXPECT_THAT(messageOf<InvalidArgument>([&] { placePatches(task); }),
              HasSubstr("the place at which the patch of cell 1 was put is none"));
}

}  // namespace
}  // namespace hexoderm
