#include "hexoderm/mounting/place/place.h"

#include "tests/core/mounting/place/laid_patches.h"
#include "tests/support/nearest_place.h"
#include "tests/support/options.h"
#include "tests/support/slow_build.h"

namespace hexoderm {
namespace {

constexpr int kPlaceSeeds = test::kSlowBuild ? 2 : 6;

const SE3 kOnForearm{rotationFromRpy({0, 0, kPi / 2}), {0.08, 0, 0.12}};
const SE3 kOnUpperArm{Eigen::Matrix3d::Identity(), {0, 0.08, 0.14}};

TEST(Place, FindsThePlaceExactlyWithoutErrors) {
  const TriangleMesh mesh = demoBody("forearm");
  const LaidPatch laid = layPatch(mesh, kOnForearm);
  const PlaceResult result = placePatches(surfaceTask(mesh, laid));
  ASSERT_FALSE(result.candidates.empty()) << result.summary;
  const PlaceCandidate& best = result.candidates.front();
  EXPECT_LT(best.chi_squared, 1e-3);
  EXPECT_LT(best.rms_m, 2e-5);
  EXPECT_LT(cellError(best.patches[0].place.T_l_o, laid), 5e-4);
  EXPECT_THAT(result.remarks, IsEmpty());
}

TEST(Place, WithErrorsTheTruePlaceIsAmongTheCandidates) {
  for (const std::string link : {"forearm", "upper_arm"}) {
    const TriangleMesh mesh = demoBody(link);
    int among = 0;
    for (int seed = 1; seed <= kPlaceSeeds; ++seed) {
      const LaidPatch laid = layPatch(mesh, link == "forearm" ? kOnForearm : kOnUpperArm,
                                      static_cast<std::uint64_t>(seed), {0.0007, 0.7 * kDegree, 1 * kDegree});
      const PlaceResult result = placePatches(surfaceTask(mesh, laid));
      // 99.9 % of chi-squared with six degrees of freedom.
      among += test::nearestPlace(result, laid.T_l_o).squared_deviates < 22.46 ? 1 : 0;
    }
    EXPECT_EQ(among, kPlaceSeeds) << link;
  }
}

TEST(Place, PointsDecideWhatTheSurfaceLeavesOpen) {
  const auto& [radius_m, mesh, laid] = OnCylinder();
  PlaceTask task = surfaceTask(mesh, laid);
  task.patches.front().rotation.reset();
  task.points = {{CellId(4), laid.T_l_u[3].t, 0.001}, {CellId(9), laid.T_l_u[8].t, 0.001}};
  const PlaceResult result = placePatches(task);
  EXPECT_EQ(result.verdict, PlaceVerdict::Placed) << result.summary;
  ASSERT_THAT(result.candidates, SizeIs(1)) << result.summary;
  EXPECT_LT(cellError(result.candidates[0].patches[0].place.T_l_o, laid), 5e-4);
  EXPECT_THAT(result.candidates[0].patches[0].free, IsEmpty());
}

TEST(Place, OnePointAndTheRotationPlaceAPatchWithoutASurface) {
  const auto& [radius_m, mesh, laid] = OnCylinder();
  PlaceTask task = surfaceTask(mesh, laid);
  task.surface.reset();
  task.points = {{CellId(4), laid.T_l_u[3].t, 0.001}};
  const PlaceResult result = placePatches(task);
  EXPECT_EQ(result.verdict, PlaceVerdict::Placed) << result.summary;
  ASSERT_THAT(result.candidates, SizeIs(1));
  EXPECT_LT(cellError(result.candidates[0].patches[0].place.T_l_o, laid), 1e-6);
  EXPECT_FALSE(result.candidates[0].patches[0].cells[0].above_m.has_value());
}

TEST(Place, DistancesPlaceASecondPatchBesideTheFirst) {
  const TriangleMesh mesh = meshOfBox({0.5, 0.4, 0.1});
  const LaidPatch a = layPatch(mesh, {Eigen::Matrix3d::Identity(), {-0.1, 0.02, 0.06}});
  const LaidPatch b = layPatch(mesh, {rotationFromRpy({0, 0, 0.4}), {0.12, -0.03, 0.06}}, 1, {}, 101);
  PlaceTask task = surfaceTask(mesh, a);
  task.patches.push_back(b.patch);
  task.points = {{CellId(1), a.T_l_u[0].t, 0.0005}};
  const auto distance = [&](std::size_t i, std::size_t j) {
    return KnownDistance{a.patch.cells[i], b.patch.cells[j], (a.T_l_u[i].t - b.T_l_u[j].t).norm(), 0.0005};
  };
  task.distances = {distance(3, 5), distance(8, 2)};
  const PlaceResult result = placePatches(task);
  // Two distances are met on either side of the line between the cells; the box's end decides it or leaves two.
  ASSERT_FALSE(result.candidates.empty()) << result.summary;
  double least_m = 1;
  for (const PlaceCandidate& candidate : result.candidates) {
    EXPECT_LT(cellError(candidate.patches[0].place.T_l_o, a), 0.001);
    least_m = std::min(least_m, cellError(candidate.patches[1].place.T_l_o, b));
  }
  EXPECT_LT(least_m, 0.001) << result.summary;
}

// The frame of the link is a matter of its maker, the origin of the patch one of the solver.
TEST(Place, ResultsGoWithTheFrameOfTheLink) {
  const TriangleMesh mesh = demoBody("forearm");
  const PlaceErrors errors{0.0007, 0.7 * kDegree, 1 * kDegree};
  const LaidPatch laid = layPatch(mesh, kOnForearm, 3, errors);
  const PlaceResult result = placePatches(surfaceTask(mesh, laid));
  const SE3 T_m_l{rotationFromRpy({0.4, -1.1, 2.0}), {0.3, -0.1, 0.2}};
  PlaceTask other = surfaceTask(transformed(mesh, T_m_l), laid);
  other.patches[0].rotation->R_l_o = T_m_l.R * laid.patch.rotation->R_l_o;
  const PlaceResult moved_result = placePatches(other);
  ASSERT_FALSE(result.candidates.empty());
  ASSERT_EQ(result.candidates.size(), moved_result.candidates.size());
  const PlacedPatch& a = result.candidates[0].patches[0];
  const PlacedPatch& b = moved_result.candidates[0].patches[0];
  EXPECT_NEAR(result.candidates[0].chi_squared, moved_result.candidates[0].chi_squared, 0.02);
  EXPECT_LT(cellError(T_m_l.inverse() * b.place.T_l_o, laid), cellError(a.place.T_l_o, laid) + 0.0005);
  const auto trace = [](const PlacedPatch& patch) {
    const Eigen::Matrix3d of_position = patch.place.cov_t_r->topLeftCorner<3, 3>();
    return of_position.trace();
  };
  EXPECT_NEAR(trace(b), trace(a), 0.1 * trace(a));
}

TEST(Place, ResultsDoNotDependOnTheOriginCell) {
  const TriangleMesh mesh = demoBody("forearm");
  const PlaceErrors errors{0.0007, 0.7 * kDegree, 1 * kDegree};
  const LaidPatch laid = layPatch(mesh, kOnForearm, 4, errors);
  PlaceTask task = surfaceTask(mesh, laid);
  // How certain the rotation is, is stated of the origin: equally, for all cells, only where cells are certain.
  const PlaceResult result = placePatches(task);
  PatchToPlace& patch = task.patches[0];
  const SE3 T_o_q = patch.T_o_u[6];
  patch.origin = patch.cells[6];
  for (SE3& cell : patch.T_o_u) cell = T_o_q.inverse() * cell;
  patch.rotation->R_l_o = patch.rotation->R_l_o * T_o_q.R;
  const PlaceResult other = placePatches(task);
  ASSERT_FALSE(result.candidates.empty());
  ASSERT_EQ(result.candidates.size(), other.candidates.size());
  const SE3 back = other.candidates[0].patches[0].place.T_l_o * T_o_q.inverse();
  const SE3& first = result.candidates[0].patches[0].place.T_l_o;
  double sum = 0;
  for (const SE3& T_o_u : laid.patch.T_o_u) sum += (back * T_o_u.t - first * T_o_u.t).squaredNorm();
  EXPECT_LT(std::sqrt(sum / 17), 0.001);
  EXPECT_EQ(other.candidates[0].patches[0].place.origin, laid.patch.cells[6]);
}

TEST(Place, SaysWhenNothingFits) {
  const PlaceResult flat = placePatches(surfaceTask(meshOfBox({0.4, 0.4, 0.4}), OnCylinder().laid));
  EXPECT_EQ(flat.verdict, PlaceVerdict::NoneFits);
  EXPECT_THAT(flat.summary.english(), saysAll("The patch of cell 1: no place on link link fits", "rms"));
  ASSERT_FALSE(flat.candidates.empty());
  EXPECT_FALSE(flat.candidates[0].fits);
  EXPECT_THAT(flat.candidates[0].patches[0].free, IsEmpty());
}

TEST(Place, SaysWhenThePatchIsLargerThanTheLink) {
  const LaidPatch laid = layPatch(meshOfBox({0.5, 0.5, 0.1}), {Eigen::Matrix3d::Identity(), {0, 0, 0.06}});
  const PlaceResult result = placePatches(surfaceTask(meshOfBox({0.05, 0.05, 0.05}), laid));
  EXPECT_EQ(result.verdict, PlaceVerdict::TooLarge);
  EXPECT_THAT(result.candidates, IsEmpty());
  EXPECT_THAT(result.summary.english(), saysAll("is larger than link link", "from corner to corner"));
}

TEST(Place, SaysWhenTheLinkIsTooLargeToBeSearched) {
  const LaidPatch laid = layPatch(meshOfBox({0.5, 0.5, 0.1}), {Eigen::Matrix3d::Identity(), {0, 0, 0.06}});
  TriangleMesh far_away = meshOfBox({1, 1, 1});
  far_away.points.back() *= 1e6;
  for (const TriangleMesh& mesh :
       {meshOfCylinder(50, 280), TriangleMesh{{{0, 0, 0}, {100, 0, 0}, {0, 100, 0}}, {{0, 1, 2}}},
        meshOfBox({1000, 1000, 1000}), far_away}) {
    const PlaceResult result = placePatches(surfaceTask(mesh, laid));
    EXPECT_EQ(result.verdict, PlaceVerdict::TooLarge);
    EXPECT_THAT(result.candidates, IsEmpty());
    EXPECT_THAT(result.summary.english(), saysAll("Link link is too large", " m from corner to corner",
                                                  " mm from cell to cell", "scale=\"0.001 0.001 0.001\""));
  }
}

TEST(Place, NoticesAMeshThatIsInsideOut) {
  TriangleMesh mesh = demoBody("forearm");
  const LaidPatch laid = layPatch(mesh, kOnForearm);
  for (auto& triangle : mesh.triangles) std::swap(triangle[0], triangle[1]);
  const PlaceResult result = placePatches(surfaceTask(mesh, laid));
  ASSERT_THAT(result.remarks, SizeIs(1));
  EXPECT_THAT(result.remarks[0].english(), HasSubstr("is inside out"));
  ASSERT_FALSE(result.candidates.empty());
  EXPECT_LT(cellError(result.candidates[0].patches[0].place.T_l_o, laid), 5e-4);
}

TEST(Place, RefusesTasksThatMakeNone) {
  const TriangleMesh mesh = meshOfBox({0.4, 0.4, 0.4});
  const LaidPatch laid = layPatch(mesh, {Eigen::Matrix3d::Identity(), {0, 0, 0.21}});
  const PlaceTask good = surfaceTask(mesh, laid);
  const auto refusal = [](const PlaceTask& task) { return messageOf<InvalidArgument>([&] { placePatches(task); }); };
  const auto says = [&](const auto& change) {
    PlaceTask task = good;
    change(task);
    return refusal(task);
  };
  EXPECT_THAT(says([](PlaceTask& task) { task.patches.clear(); }), HasSubstr("no patch to place"));
  EXPECT_THAT(says([](PlaceTask& task) { task.surface.reset(); }), HasSubstr("nothing says where on the link"));
  EXPECT_THAT(says([](PlaceTask& task) { task.surface->triangles.clear(); }),
              HasSubstr("the mesh of link link has no triangle with an area"));
  EXPECT_THAT(refusal(test::with(good, &PlaceTask::points, {{CellId(99), {0, 0, 0}, 0.001}})),
              HasSubstr("none of the patches to place holds a cell 99"));
  EXPECT_THAT(refusal(test::with(good, &PlaceTask::points, {{CellId(1), {0, 0, 0}, 0}})),
              HasSubstr("the sigma of the point of cell 1 must be from 1e-06 to 100 m, found 0 m"));
  EXPECT_THAT(refusal(test::with(good, &PlaceTask::distances, {{CellId(1), CellId(2), 0.1, 0.001}})),
              HasSubstr("cells 1 and 2 are of one patch"));
  EXPECT_THAT(says([](PlaceTask& task) { task.patches.push_back(task.patches[0]); }),
              HasSubstr("cell 1 is there twice"));
  EXPECT_THAT(says([](PlaceTask& task) { task.patches[0].covariance.pop_back(); }), HasSubstr("needs a covariance of"));
  EXPECT_THAT(says([](PlaceTask& task) { task.patches[0].covariance[0] = -1; }), HasSubstr("positive semidefinite"));
  EXPECT_THAT(says([](PlaceTask& task) { task.patches[0].rotation->R_l_o *= 2; }), HasSubstr("must be a rotation"));
  EXPECT_THAT(says([](PlaceTask& task) { task.patches[0].T_o_u[3].t.x() = std::nan(""); }), HasSubstr("not finite"));
}

TEST(Place, RefusesLengthsOutOfTheirRanges) {
  const auto says = [](double PlaceOptions::*option, double value) {
    PlaceOptions options;
    options.*option = value;
    return messageOf<InvalidArgument>([&] { options.validate(); });
  };
  EXPECT_EQ(says(&PlaceOptions::gap_m, 1e160), "the gap must be from 0 to 100 m, found 1e+160 m");
  EXPECT_EQ(says(&PlaceOptions::gap_m, -0.001), "the gap must be from 0 to 100 m, found -0.001 m");
  EXPECT_EQ(says(&PlaceOptions::gap_m, std::nan("")), "the gap must be from 0 to 100 m, found nan m");
  EXPECT_EQ(says(&PlaceOptions::surface_sigma_m, 0), "the sigma of the surface must be from 1e-06 to 100 m, found 0 m");
  EXPECT_THAT(says(&PlaceOptions::free_m, 101), HasSubstr("must be from 1e-06 to 100 m, found 101 m"));
  EXPECT_THAT(says(&PlaceOptions::normal_sigma_rad, 1e200),
              HasSubstr("the sigma of the normals must be from 0.001° to 360°"));
  const auto point = [](const Eigen::Vector3d& x_l, double sigma_m) {
    return messageOf<InvalidArgument>([&] { requirePlaceable(KnownPoint{CellId(1), x_l, sigma_m}); });
  };
  EXPECT_EQ(point({0, 1e100, 0}, 0.001),
            "each coordinate of the point of cell 1 must be from -100 to 100 m, found 1e+100 m");
  EXPECT_THAT(point({0, 0, 0}, 1e200), HasSubstr("the sigma of the point of cell 1 must be from 1e-06 to 100 m"));
  const auto distance = [](double distance_m, double sigma_m) {
    return messageOf<InvalidArgument>([&] {
      requirePlaceable(KnownDistance{CellId(1), CellId(101), distance_m, sigma_m});
    });
  };
  EXPECT_THAT(distance(101, 0.001), HasSubstr("the distance between cells 1 and 101 must be from 1e-06 to 100 m"));
  EXPECT_THAT(distance(1, 0), HasSubstr("the sigma of the distance between cells 1 and 101 must be from 1e-06"));
}

TEST(Place, ASingleCellCanLieAlmostAnywhere) {
  const TriangleMesh mesh = meshOfBox({0.2, 0.2, 0.2});
  LaidPatch laid = layPatch(mesh, {Eigen::Matrix3d::Identity(), {0, 0, 0.11}});
  laid.patch.cells.resize(1);
  laid.patch.T_o_u.resize(1);
  Eigen::MatrixXd C = Eigen::MatrixXd::Identity(6, 6) * 1e-6;
  laid.patch.covariance.assign(C.data(), C.data() + 36);
  const PlaceResult result = placePatches(surfaceTask(mesh, laid));
  ASSERT_FALSE(result.candidates.empty()) << result.summary;
  EXPECT_NE(result.verdict, PlaceVerdict::Placed);
  EXPECT_TRUE(result.candidates[0].patches[0].place.cov_t_r->allFinite());
}

}  // namespace
}  // namespace hexoderm
