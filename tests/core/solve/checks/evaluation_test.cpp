#include "hexoderm/solve/checks/evaluation.h"

#include "hexoderm/base/error.h"
#include "hexoderm/base/units.h"
#include "hexoderm/solve/reconstructor.h"
#include "tests/support/hand_made_skins.h"
#include "tests/support/matchers.h"
#include "tests/support/pin_jointed_skin.h"
#include "tests/support/simulated_skins.h"
#include "tests/support/solvers.h"

namespace hexoderm {
namespace {

using ::testing::SizeIs;

/// By the tree solver, which gives such skins back exactly: what is tested here is the evaluation.
std::shared_ptr<const Reconstruction> solved(const PinJointedSkin& skin, std::size_t poses = 3) {
  return reconstruct(*skin.session(orthogonalUps(poses)).snapshot(), test::by(Solver::Tree));
}

GroundTruth truthOf(const PinJointedSkin& skin) {
  GroundTruth truth;
  for (const auto& [id, T] : skin.truth) truth.cells.push_back({id, T});
  return truth;
}

TEST(Evaluation, CentresOfAnUntwistedRingLieInAPlaneAndOnNoSphere) {
  const auto result = solved(ringOfEight(45 * kDegree));
  EXPECT_THROW(evaluateSurface(result->patches.front(), SurfaceKind::Sphere), InvalidArgument);
  const SurfaceEvaluation plane = evaluateSurface(result->patches.front(), SurfaceKind::Plane);
  EXPECT_LT(plane.rms_m, 1e-9);
  EXPECT_FALSE(plane.radius_m.has_value());
  EXPECT_THROW(evaluateSurface(result->patches.front(), SurfaceKind::Plane, 0.05), InvalidArgument);
}

TEST(Evaluation, PaperMetricsFollowEquations20And21) {
  const auto result = solved(bentX17());
  EXPECT_NO_THROW(evaluateSurface(result->patches.front(), SurfaceKind::Cylinder, 1e6));
  EXPECT_THROW(evaluateSurface(result->patches.front(), SurfaceKind::Cylinder, 1e308), InvalidArgument);
  const SurfaceEvaluation sphere = evaluateSurface(result->patches.front(), SurfaceKind::Sphere, 0.05);
  ASSERT_TRUE(sphere.delta_m && sphere.epsilon_m && sphere.radius_m);
  EXPECT_NEAR(*sphere.delta_m, *sphere.radius_m - 0.05, 1e-15);
  double sum = 0;
  for (const double distance : sphere.distance_m) sum += std::pow(distance + *sphere.delta_m, 2);
  EXPECT_NEAR(*sphere.epsilon_m, std::sqrt(sum / 17), 1e-15);
  EXPECT_THAT(sphere.distance_m, SizeIs(17));
}

TEST(Evaluation, ConeHasAHalfAngleAndNoOneRadius) {
  const auto result = solved(bentX17());
  const SurfaceEvaluation cone = evaluateSurface(result->patches.front(), SurfaceKind::Cone);
  EXPECT_TRUE(cone.half_angle_rad && cone.radius_m);
  EXPECT_THAT(cone.distance_m, SizeIs(17));
  EXPECT_THROW(evaluateSurface(result->patches.front(), SurfaceKind::Cone, 0.05), InvalidArgument);
  EXPECT_EQ(surfaceKindFromName("cone"), SurfaceKind::Cone);
  EXPECT_EQ(surfaceKindName(SurfaceKind::Cone), "cone");
}

/// The largest patch of a simulated skin, solved as a session is.
PatchReconstruction simulated(const char* patch, const char* surface, std::uint64_t seed, std::size_t poses) {
  const Session session = test::simulatedSession(test::skinOptions(patch, surface, seed), poses, 50);
  return *largestPatch(*reconstruct(*session.snapshot()));
}

TEST(Evaluation, ASphereThroughTheCellsOfACylinderIsContradictedByWhereTheyFace) {
  const PatchReconstruction patch = simulated("x17", "cylinder:r=0.0501", 1, 4);
  const SurfaceEvaluation sphere = checkSurface(patch, SurfaceKind::Sphere);
  EXPECT_LT(sphere.rms_m, 1.5 * kMillimetre) << "they lie on it";
  EXPECT_GT(sphere.tilt_rms_rad, 20 * kDegree);
  ASSERT_NE(sphere.better, nullptr);
  EXPECT_EQ(sphere.better->kind, SurfaceKind::Cylinder);
  EXPECT_NEAR(sphere.better->radius_m.value_or(0), 0.0501, 0.001);
  EXPECT_EQ(checkSurface(patch, SurfaceKind::Cylinder).better, nullptr);
}

TEST(Evaluation, TheSimplestSurfaceThatIsNotContradictedIsTaken) {
  for (const char* patch : {"x17", "sheet:5x6"}) {
    for (const auto& [surface, kind] :
         {std::pair("cylinder:r=0.0501", SurfaceKind::Cylinder), std::pair("cylinder:r=0.2", SurfaceKind::Cylinder),
          std::pair("sphere:r=0.06", SurfaceKind::Sphere), std::pair("plane", SurfaceKind::Plane),
          std::pair("cone:r=0.05,angle=0.3", SurfaceKind::Cone)}) {
      for (std::uint64_t seed = 1; seed <= 5; ++seed) {
        const PatchReconstruction reconstruction = simulated(patch, surface, seed, 4);
        const SurfaceEvaluation taken = checkSurface(reconstruction, std::nullopt);
        EXPECT_EQ(taken.kind, kind) << patch << ' ' << surface << ' ' << seed;
        EXPECT_EQ(taken.better, nullptr) << patch << ' ' << surface << ' ' << seed;
        EXPECT_EQ(taken.tilt_rad.size(), reconstruction.cells.size());
      }
    }
  }
}

TEST(Evaluation, WithoutStatedUncertaintiesNoSurfaceIsContradicted) {
  PatchReconstruction patch = simulated("x17", "cylinder:r=0.0501", 1, 4);
  for (CellPlacement& cell : patch.cells) cell.cov_t_r.reset();
  EXPECT_EQ(checkSurface(patch, SurfaceKind::Sphere).better, nullptr);
}

TEST(Evaluation, ASurfaceOfTooFewCellsIsRefusedAndSaysWhy) {
  PatchReconstruction patch = simulated("x17", "cylinder:r=0.0501", 1, 4);
  patch.cells.resize(2);
  EXPECT_THROW(checkSurface(patch, std::nullopt), InvalidArgument);
  patch.cells.resize(1);
  EXPECT_THROW(checkSurface(patch, SurfaceKind::Plane), InvalidArgument);
}

TEST(Evaluation, LoopOfAnOpenRingIsItsGap) {
  const PinJointedSkin skin = ringOfEight(44 * kDegree);
  const LoopEvaluation loop = evaluateLoop(*solved(skin), kRingFirst, kRingLast);
  const auto point = [&](LinkEnd end) { return skin.truth.at(end.cell) * skin.model.port(end.port).vector_m; };
  const double expected = (point(kRingFirst) - point(kRingLast)).norm();
  EXPECT_GT(expected, 0.001);
  EXPECT_NEAR(loop.length_m, expected, 1e-9);
  EXPECT_NEAR(loop.percent, 100 * expected / loop.loop_length_m, 1e-9);
  EXPECT_NEAR(loop.gap_m.norm(), loop.length_m, 1e-15);
}

TEST(Evaluation, LoopRefusesWhatIsNoFreePort) {
  const auto result = solved(ringOfEight(44 * kDegree));
  EXPECT_THROW(evaluateLoop(*result, {CellId(9), PortNumber(2)}, kRingLast), InvalidArgument);
  EXPECT_THROW(evaluateLoop(*result, {CellId(1), PortNumber(5)}, kRingLast), InvalidArgument);
  EXPECT_THROW(evaluateLoop(*result, {CellId(1), PortNumber(2)}, kRingLast), InvalidArgument) << "joined to cell 2";
  EXPECT_THROW(evaluateLoop(*result, kRingLast, kRingLast), InvalidArgument);
}

TEST(Evaluation, ComparisonIgnoresTheFramesAndSeesTheDifference) {
  const PinJointedSkin skin = bentX17();
  const auto result = solved(skin);
  GroundTruth truth = truthOf(skin);
  const SE3 T_body{expSO3({1, 2, 0.5}), {0.3, -0.2, 1}};
  for (TrueCellPlacement& cell : truth.cells) cell.T_b_u = T_body * cell.T_b_u;
  auto comparison = compareToTruth(*result, truth);
  ASSERT_THAT(comparison, SizeIs(1));
  EXPECT_LT(comparison[0].position_rms_m, 1e-9);
  EXPECT_LT(comparison[0].orientation_rms_rad, 1e-9);

  // One of 17 cells turned by 0.1 rad: the best rotation takes up 1/17 of it.
  truth.cells[3].T_b_u.R *= expSO3({0, 0, 0.1});
  comparison = compareToTruth(*result, truth);
  EXPECT_NEAR(comparison[0].cells[3].orientation_rad, 0.1 * 16 / 17, 1e-4);
  EXPECT_NEAR(comparison[0].orientation_rms_rad, 0.1 * std::sqrt(16.0) / 17, 1e-4);
}

TEST(Evaluation, NineteenOfTwentyWithinWhatWasStatedAreEnough) {
  Comparison comparison;
  for (std::uint32_t k = 0; k < 20; ++k) {
    CellDifference cell;
    cell.cell = CellId(k + 1);
    cell.position_m = {0, 0.0019, 0};
    cell.orientation_rad = 0.019;
    cell.sigma_t_m = 0.001;
    cell.sigma_r_rad = 0.01;
    comparison.cells.push_back(cell);
  }
  comparison.cells.emplace_back().sigma_t_m = 0;  // the origin
  comparison.cells.back().sigma_r_rad = 0;
  comparison.cells.emplace_back();  // one that states nothing
  EXPECT_EQ(countWithinStated({comparison}).stated, 20U);
  EXPECT_TRUE(countWithinStated({comparison}).holds());
  comparison.cells[3].position_m.y() = 0.002;
  EXPECT_EQ(countWithinStated({comparison}).position, 19U);
  EXPECT_TRUE(countWithinStated({comparison}).holds());
  comparison.cells[5].orientation_rad = comparison.cells[6].orientation_rad = 0.02;
  EXPECT_EQ(countWithinStated({comparison}).orientation, 18U);
  EXPECT_FALSE(countWithinStated({comparison}).holds());
  EXPECT_FALSE(countWithinStated({}).holds()) << "nothing stated is no statement";
}

TEST(Evaluation, ComparisonsAreSummarisedCellByCellAndAPatchOfOneSharedCellTellsNothing) {
  Comparison large;
  large.cells.resize(3);
  large.position_rms_m = 0.002;
  large.orientation_rms_rad = 0.02;
  Comparison small;
  small.cells.resize(2);
  small.position_rms_m = 0.004;
  small.cells[0].sigma_t_m = 0.001;
  small.cells[0].sigma_r_rad = 0.01;
  Comparison lonely;
  lonely.cells = {small.cells[0]};
  const ComparisonSummary summary = summariseComparisons({large, small, lonely});
  EXPECT_EQ(summary.cells, 5U);
  EXPECT_NEAR(summary.position_rms_m, std::sqrt((3 * 4.0 + 2 * 16.0) / 5) * 1e-3, 1e-12);
  EXPECT_NEAR(summary.orientation_rms_rad, 0.02 * std::sqrt(0.6), 1e-12);
  EXPECT_EQ(summary.within.stated, 1U) << "a lonely cell lies within whatever is stated";
  EXPECT_EQ(summariseComparisons({lonely}).cells, 0U);
  EXPECT_EQ(summariseComparisons({}).position_rms_m, 0);
}

TEST(Evaluation, ASurfaceIsJudgedByItsFurthestCellOnEitherSide) {
  SurfaceEvaluation surface;
  surface.distance_m = {0.0004, -0.0012, 0.0011};
  EXPECT_EQ(surface.furthest(), 1U);
  EXPECT_TRUE(surface.liesWithin(0.0012));
  EXPECT_FALSE(surface.liesWithin(0.0011));
  EXPECT_TRUE(isRemarkable(-0.0012, 0.00039));
  EXPECT_FALSE(isRemarkable(-0.0012, 0.0005));
}

TEST(Evaluation, ReconstructionsComparePatchByPatch) {
  const auto a = solved(bentX17());
  const auto b = solved(bentX17(), 6);
  const auto comparison = compareToReconstruction(*a, *b);
  ASSERT_THAT(comparison, SizeIs(1));
  EXPECT_THAT(comparison[0].cells, SizeIs(17));
  EXPECT_LT(comparison[0].position_rms_m, 1e-9);
  EXPECT_TRUE(comparison[0].cells[5].sigma_t_m.has_value());
  EXPECT_GT(*comparison[0].cells[5].sigma_r_rad, 0);
}

TEST(CellDistance, IsThatOfCentresAndNormals) {
  const Reconstruction demo = demoReconstruction();
  const auto distance = distanceBetween(demo, CellId(2), CellId(6));
  ASSERT_TRUE(distance.has_value());
  EXPECT_NEAR(distance->length_m, (demo.find(CellId(2)).cell->T_o_u.t - demo.find(CellId(6)).cell->T_o_u.t).norm(),
              1e-12);
  EXPECT_NEAR(distance->angle_rad, demo.patches[0].links[0].bend_rad, 1e-9);
  EXPECT_EQ(distance->sigma_m, std::nullopt) << "a calibration from a file does not hold it";
  EXPECT_EQ(distanceBetween(demo, CellId(2), CellId(2))->length_m, 0);
  EXPECT_EQ(distanceBetween(demo, CellId(2), CellId(999)), std::nullopt);

  const Reconstruction two = demoPatches({DemoOptions(), {.first_id = 101}});
  EXPECT_EQ(distanceBetween(two, CellId(1), CellId(101)), std::nullopt);
}

TEST(CellDistance, OfAFreshResultSaysHowSureItIs) {
  const auto result = reconstruct(*bentX17().session(orthogonalUps(3)).snapshot());
  const PatchReconstruction& patch = result->patches.front();
  const CellId far = patch.cells.back().cell;
  const auto distance = distanceBetween(*result, patch.origin, far);
  ASSERT_TRUE(distance && distance->sigma_m);
  const Eigen::Vector3d along = result->find(far).cell->T_o_u.t.normalized();
  const Eigen::Matrix3d cov = result->find(far).cell->cov_t_r->topLeftCorner<3, 3>();
  EXPECT_NEAR(*distance->sigma_m, std::sqrt(along.dot(cov * along)), 1e-9);
}

TEST(DistanceCheck, ATrueDistanceAgreesAndAWrongSizeContradicts) {
  constexpr std::uint64_t kSeeds = 10;
  for (const char* patch : {"x17", "sheet:5x6"}) {
    std::size_t as_stated = 0;
    for (std::uint64_t seed = 1; seed <= kSeeds; ++seed) {
      SimulatedSkin skin = test::simulatedSkin(test::skinOptions(patch, "", seed));
      const auto result = reconstruct(*simulateSession(skin, 4, 50).snapshot());
      const auto [a, b] = farApart(*largestPatch(*result)).value();
      const double truth_m = (test::truePlacement(skin, a).t - test::truePlacement(skin, b).t).norm();
      const DistanceCheck check = checkDistance(*result, a, b, truth_m);
      ASSERT_TRUE(check.sigma_m && check.deviations && check.detectable_scale);
      EXPECT_GT(*check.sigma_m, kCaliperSigma_m);
      EXPECT_NEAR(*check.deviations, (truth_m - check.estimated_m) / *check.sigma_m, 1e-12);
      EXPECT_NE(check.agreement, DistanceAgreement::Contradicts) << patch << ' ' << seed;
      if (check.agreement == DistanceAgreement::AsStated) ++as_stated;
      // Cells a fifth larger or smaller than the model says.
      EXPECT_LT(*check.detectable_scale, 0.1) << patch << ' ' << seed;
      EXPECT_EQ(checkDistance(*result, a, b, 1.2 * truth_m).agreement, DistanceAgreement::Contradicts) << seed;
      EXPECT_EQ(checkDistance(*result, a, b, truth_m / 1.2).agreement, DistanceAgreement::Contradicts) << seed;
    }
    EXPECT_GE(as_stated, kSeeds / 2) << patch;
  }
}

TEST(DistanceCheck, BetweenThemThereIsDoubt) {
  const auto result = reconstruct(*bentX17().session(orthogonalUps(3)).snapshot());
  const auto [a, b] = farApart(result->patches.front()).value();
  const DistanceCheck exact = checkDistance(*result, a, b, distanceBetween(*result, a, b)->length_m);
  EXPECT_NEAR(exact.deviations.value_or(1), 0, 1e-12);
  EXPECT_EQ(exact.agreement, DistanceAgreement::AsStated);
  const double sigma_m = exact.sigma_m.value();
  EXPECT_EQ(checkDistance(*result, a, b, exact.estimated_m - 3 * sigma_m).agreement, DistanceAgreement::Doubtful);
  EXPECT_EQ(checkDistance(*result, a, b, exact.estimated_m + 5 * sigma_m).agreement, DistanceAgreement::Contradicts);
}

TEST(DistanceCheck, OfAFileWhatIsStatedForEachCellBoundsIt) {
  const auto fresh = reconstruct(*bentX17().session(orthogonalUps(3)).snapshot());
  Reconstruction file = *fresh;
  file.patches.front().covariance.reset();
  const auto [a, b] = farApart(file.patches.front()).value();
  EXPECT_GE(checkDistance(file, a, b, 0.1).sigma_m.value_or(0), checkDistance(*fresh, a, b, 0.1).sigma_m.value());
  for (CellPlacement& cell : file.patches.front().cells) cell.cov_t_r.reset();
  const DistanceCheck check = checkDistance(file, a, b, 0.1);
  EXPECT_EQ(check.agreement, DistanceAgreement::NotStated);
  EXPECT_FALSE(check.sigma_m || check.deviations || check.detectable_scale);
}

TEST(DistanceCheck, RefusesWhatIsNoDistance) {
  const auto result = reconstruct(*bentX17().session(orthogonalUps(3)).snapshot());
  EXPECT_THROW(checkDistance(*result, CellId(1), CellId(999), 0.1), InvalidArgument);
  EXPECT_THROW(checkDistance(*result, CellId(999), CellId(1), 0.1), InvalidArgument);
  EXPECT_THROW(checkDistance(*result, CellId(1), CellId(1), 0.1), InvalidArgument);
  EXPECT_THROW(checkDistance(*result, CellId(1), CellId(2), 0), InvalidArgument);
  EXPECT_THROW(checkDistance(*result, CellId(1), CellId(2), std::nan("")), InvalidArgument);
  EXPECT_THROW(checkDistance(demoPatches({DemoOptions(), {.first_id = 101}}), CellId(1), CellId(101), 0.1),
               InvalidArgument);
  PatchReconstruction lonely = result->patches.front();
  lonely.cells.resize(1);
  EXPECT_EQ(farApart(lonely), std::nullopt);
}

}  // namespace
}  // namespace hexoderm
