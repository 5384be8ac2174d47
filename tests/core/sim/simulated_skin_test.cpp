// Placements and links of the simulated skin's cells.

#include "hexoderm/sim/simulated_skin.h"

#include "hexoderm/base/surface.h"
#include "hexoderm/base/units.h"
#include "hexoderm/skin/skin_graph.h"
#include "tests/core/sim/standard_skin.h"
#include "tests/support/options.h"
#include "tests/support/testing.h"

#include <tuple>

namespace hexoderm {
namespace {

const double kReach = kModel.reach_m();

SimulatedSkinOptions ideal(const std::string& patch, const std::string& surface = "", LinkLaw law = LinkLaw::Bend) {
  return test::with(SimulatedSkinOptions::ideal(), &SimulatedSkinOptions::patch, patch, &SimulatedSkinOptions::surface,
                    surface, &SimulatedSkinOptions::link_law, law);
}

const SE3& placement(const SimulatedSkin& skin, CellId id) { return skin.truth().at(id.value() - 1).T_b_u; }

struct TrueLink {
  LinkEnd source, target;
  SE3 T_b_c, T_b_n;
};

/// Every link once.
std::vector<TrueLink> linksOf(const SimulatedSkin& skin) {
  std::vector<TrueLink> links;
  for (const CellReport& cell : skin.neighbors()) {
    for (const NeighborReport& neighbor : cell.neighbors) {
      if (neighbor.cell < cell.id) continue;
      links.push_back({{cell.id, neighbor.port},
                       {neighbor.cell, neighbor.cell_port.value()},
                       placement(skin, cell.id),
                       placement(skin, neighbor.cell)});
    }
  }
  return links;
}

/// Distance between the ends of a link's port vectors, eq. (2).
double misfit(const SimulatedSkin& skin, const TrueLink& link) {
  return (link.T_b_c * skin.model().port(link.source.port).vector_m -
          link.T_b_n * skin.model().port(link.target.port).vector_m)
      .norm();
}

double largestMisfit(const SimulatedSkin& skin) {
  double largest = 0;
  for (const TrueLink& link : linksOf(skin)) largest = std::max(largest, misfit(skin, link));
  return largest;
}

TEST(SimulatedSkin, X17IsTwoStraightLinesThatCrossAtSixtyDegrees) {
  const SimulatedSkin skin(kModel, ideal("x17", "plane"));
  const auto at = [&](unsigned id) { return placement(skin, CellId(id)).t; };
  // Middle cell 1, then the arms 2-5, 6-9, 10-13 and 14-17 from the middle outwards.
  for (const unsigned first : {2U, 6U, 10U, 14U}) {
    for (unsigned k = 0; k < 4; ++k) {
      EXPECT_LT((at(first + k) - at(1) - (k + 1) * (at(first) - at(1))).norm(), 1e-14);
      EXPECT_NEAR((at(first + k) - at(1)).norm(), (k + 1) * 2 * kReach, 1e-14);
    }
  }
  EXPECT_NEAR(angleBetween(at(5) - at(1), at(9) - at(1)), kPi, 1e-12);
  EXPECT_NEAR(angleBetween(at(13) - at(1), at(17) - at(1)), kPi, 1e-12);
  EXPECT_NEAR(toDegrees(angleBetween(at(5) - at(1), at(13) - at(1))), 60, 0.6);
}

TEST(SimulatedSkin, X17WorksForOtherPortNumbersAndShapes) {
  CellModel square = kModel;
  square.ports = {{PortNumber(9), {0.01, 0, 0}},
                  {PortNumber(3), {0, 0.01, 0}},
                  {PortNumber(5), {-0.01, 0, 0}},
                  {PortNumber(4), {0, -0.01, 0}}};
  const SimulatedSkin skin(square, ideal("x17", "plane"));
  EXPECT_EQ(linksOf(skin).size(), 16U);
  EXPECT_LT(largestMisfit(skin), 1e-14);
  EXPECT_NEAR(angleBetween(placement(skin, CellId(5)).t, placement(skin, CellId(13)).t), kPi / 2, 1e-12);
}

class LinkLaws : public testing::TestWithParam<LinkLaw> {};
INSTANTIATE_TEST_SUITE_P(Both, LinkLaws, testing::Values(LinkLaw::Bend, LinkLaw::Surface));

TEST_P(LinkLaws, OnAPlaneEveryLinkObeysEquationTwo) {
  for (const char* patch : {"x17", "ring8", "sheet:7x6", "sheet:1x5", "sheet:5x1", "sheet:1x1"}) {
    EXPECT_LT(largestMisfit(SimulatedSkin(kModel, ideal(patch, "plane", GetParam()))), 1e-13) << patch;
  }
}

TEST_P(LinkLaws, CellsAreTangentToTheSurfaceWithTheirFrontsOutwards) {
  for (const char* where : {"plane", "cylinder:r=0.08", "sphere:r=0.1", "cone:r=0.1,angle=0.2", "torus:R=0.3,r=0.1"}) {
    const auto surface = makeSurface(where);
    for (const char* patch : {"x17", "sheet:5x4"}) {
      const SimulatedSkin skin(kModel, ideal(patch, where, GetParam()));
      for (const TrueCell& cell : skin.truth()) {
        EXPECT_LT((surface->project(cell.T_b_u.t) - cell.T_b_u.t).norm(), 1e-13) << where;
        EXPECT_LT((surface->normal(cell.T_b_u.t) - cell.T_b_u.R.col(2)).norm(), 1e-12) << where;
        EXPECT_LT((cell.T_b_u.R.transpose() * cell.T_b_u.R - Eigen::Matrix3d::Identity()).norm(), 1e-12);
      }
    }
  }
}

TEST(SimulatedSkin, SurfaceLawKeepsThePitchAlongTheSurface) {
  for (const char* where : {"cylinder:r=0.0501", "sphere:r=0.1", "cone:r=0.1,angle=0.2", "torus:R=0.3,r=0.1"}) {
    const auto surface = makeSurface(where);
    for (const TrueLink& link : linksOf(SimulatedSkin(kModel, ideal("x17", where, LinkLaw::Surface)))) {
      const Eigen::Vector3d way = surface->bearing(link.T_b_c.t, link.T_b_n.t);
      EXPECT_NEAR(way.norm(), 2 * kReach, 1e-10) << where;
      EXPECT_LT(angleBetween(way, link.T_b_c.R * kModel.port(link.source.port).vector_m), 1e-8) << where;
    }
  }
}

TEST(SimulatedSkin, BendLawShortensThePitchByTheCurvatureAlongTheLink) {
  const double radius = 0.0501;
  const auto surface = makeSurface("cylinder:r=0.0501");
  const std::vector<TrueLink> links = linksOf(SimulatedSkin(kModel, ideal("x17")));
  ASSERT_EQ(links.size(), 16U);
  for (const TrueLink& link : links) {
    const Eigen::Vector3d along = link.T_b_c.R * kModel.port(link.source.port).vector_m.normalized();
    const double curvature = (1 - along.z() * along.z()) / radius;
    EXPECT_NEAR(surface->bearing(link.T_b_c.t, link.T_b_n.t).norm(), 2 / curvature * std::atan(curvature * kReach),
                1e-12);
  }
}

TEST(SimulatedSkin, BendLawMakesLinkPointsMeet) {
  EXPECT_LT(largestMisfit(SimulatedSkin(kModel, ideal("ring8"))), 1e-13);
  EXPECT_LT(largestMisfit(SimulatedSkin(kModel, ideal("ring8:closed"))), 1e-13);
  EXPECT_LT(largestMisfit(SimulatedSkin(kModel, ideal("x17", "sphere:r=0.1"))), 1e-13);
  EXPECT_LT(largestMisfit(SimulatedSkin(kModel, ideal("sheet:10x10", "cylinder:r=0.1"))), 1e-12);
  // Oblique links of a tree are laid along geodesics, whose torsion keeps the points a little apart.
  const double oblique = largestMisfit(SimulatedSkin(kModel, ideal("x17")));
  EXPECT_GT(oblique, 0.0002);
  EXPECT_LT(oblique, 0.00025);
}

TEST(SimulatedSkin, SurfaceLawKeepsLinkPointsApartAsTheArcModelSays) {
  const SimulatedSkin skin(kModel, ideal("ring8", "", LinkLaw::Surface));
  const double half_bend = kPi / 8;
  ASSERT_FALSE(linksOf(skin).empty());
  for (const TrueLink& link : linksOf(skin)) {
    EXPECT_NEAR(misfit(skin, link) / (2.0 / 3 * kReach * half_bend * half_bend), 1, 0.1);
  }
}

TEST_P(LinkLaws, ClosedRingsLieAsOpenOnesAndAllTheirLinksAreAlike) {
  for (const std::size_t cells : {5U, 8U, 13U}) {
    const std::string patch = "ring" + std::to_string(cells);
    const SimulatedSkin open(kModel, ideal(patch, "", GetParam()));
    const SimulatedSkin closed(kModel, ideal(patch + ":closed", "", GetParam()));
    EXPECT_FALSE(closed.loop().has_value());
    ASSERT_TRUE(open.loop().has_value());
    const std::vector<TrueLink> links = linksOf(closed);
    EXPECT_EQ(links.size(), cells);
    EXPECT_EQ(linksOf(open).size(), cells - 1);
    for (const TrueLink& link : links) {
      EXPECT_NEAR(misfit(closed, link), misfit(open, linksOf(open).front()), 1e-12);
      EXPECT_NEAR(rotationAngle(link.T_b_c.R.transpose() * link.T_b_n.R), 2 * kPi / static_cast<double>(cells), 1e-12);
    }
    for (std::size_t k = 0; k < cells; ++k) {
      EXPECT_EQ(closed.truth()[k].T_b_u.R, open.truth()[k].T_b_u.R);
      EXPECT_EQ(closed.truth()[k].T_b_u.t, open.truth()[k].T_b_u.t);
    }
    // The two ports that an open ring leaves facing each other are joined.
    const auto [first, last] = *open.loop();
    const NeighborReport joined{first.port, last.cell, last.port};
    const std::vector<NeighborReport>& of_first = closed.neighbors().front().neighbors;
    EXPECT_NE(std::ranges::find(of_first, joined), of_first.end());
    EXPECT_TRUE(SkinGraph(closed.model(), closed.neighbors()).findings().empty());
  }
}

TEST(SimulatedSkin, SheetIsARhombicLattice) {
  const SimulatedSkin skin(kModel, ideal("sheet:6x5"));
  const SkinGraph graph(skin.model(), skin.neighbors());
  EXPECT_EQ(graph.cells().size(), 30U);
  EXPECT_EQ(graph.patches().size(), 1U);
  EXPECT_TRUE(graph.findings().empty());
  EXPECT_EQ(graph.links().size(), 6U * 4U + 5U * 4U);  // along the rows, and across between the columns
  for (const TrueCell& cell : skin.truth()) {
    EXPECT_LT((cell.T_b_u.R - Eigen::Matrix3d::Identity()).norm(), 1e-12);
  }
}

TEST(SimulatedSkin, SheetsOnDoublyCurvedSurfacesAreRelaxed) {
  for (const LinkLaw law : {LinkLaw::Bend, LinkLaw::Surface}) {
    const SimulatedSkin skin(kModel, ideal("sheet:10x10", "sphere:r=0.2", law));
    double sum = 0;
    const std::vector<TrueLink> links = linksOf(skin);
    for (const TrueLink& link : links) sum += std::pow(misfit(skin, link), 2);
    // A plane lattice can't lie on a sphere: the misfit is spread over all links instead of piling up at the rim.
    EXPECT_LT(std::sqrt(sum / static_cast<double>(links.size())), 0.0005);
    EXPECT_LT(largestMisfit(skin), 0.001);
    for (const TrueLink& link : links) {
      const LinkAngles angles = linkAngles(link.T_b_c.R.transpose() * link.T_b_n.R, kModel.port(link.source.port),
                                           kModel.port(link.target.port));
      EXPECT_LT(std::abs(angles.yaw_rad), 4 * kDegree);
    }
  }
}

TEST(SimulatedSkin, LargeSheetRaisesTheInterfaceIdAboveItsCells) {
  SimulatedSkinOptions options = ideal("sheet:150x120", "cylinder:r=1.5");
  const SimulatedSkin skin(kModel, options);
  ASSERT_EQ(skin.truth().size(), 18000U);
  EXPECT_EQ(skin.model().interface_id, CellId(18001));
  EXPECT_EQ(SkinGraph(skin.model(), skin.neighbors()).cells().size(), 18000U);
  EXPECT_LT(largestMisfit(skin), 1e-11);
  EXPECT_EQ(SimulatedSkin(kModel, ideal("x17")).model().interface_id, kModel.interface_id);
}

TEST(SimulatedSkin, JitterHasItsSpread) {
  SimulatedSkinOptions options = ideal("sheet:60x50");
  const SimulatedSkin exact(kModel, options);
  options.position_jitter_m = 0.0002;
  options.yaw_jitter_rad = 1 * kDegree;
  options.tilt_jitter_rad = 0.5 * kDegree;
  const SimulatedSkin skin(kModel, options);
  Eigen::Vector3d shift_sq = Eigen::Vector3d::Zero();
  Eigen::Vector3d turn_sq = Eigen::Vector3d::Zero();
  const double count = static_cast<double>(skin.truth().size());
  for (std::size_t k = 0; k < skin.truth().size(); ++k) {
    const SE3 moved = exact.truth()[k].T_b_u.inverse() * skin.truth()[k].T_b_u;
    shift_sq += moved.t.cwiseAbs2() / count;
    turn_sq += logSO3(moved.R).cwiseAbs2() / count;
  }
  const Eigen::Vector3d shift = shift_sq.cwiseSqrt();
  const Eigen::Vector3d turn = turn_sq.cwiseSqrt() / kDegree;
  // 3,000 draws: 5 % is four standard deviations.
  for (int axis = 0; axis < 3; ++axis) EXPECT_NEAR(shift(axis) / 0.0002, 1, 0.05);
  EXPECT_NEAR(turn.x() / 0.5, 1, 0.05);
  EXPECT_NEAR(turn.y() / 0.5, 1, 0.05);
  EXPECT_NEAR(turn.z() / 1, 1, 0.05);
}

TEST(SimulatedSkin, SaysWhatItIs) {
  const auto text = [](const SimulatedSkinOptions& options) {
    return SimulatedSkin(kModel, options).description().english();
  };
  EXPECT_EQ(text({}), "Simulated x17 on cylinder:r=0.0501, link law bend, seed 1");
  EXPECT_EQ(text(test::with(ideal("ring8", "", LinkLaw::Surface), &SimulatedSkinOptions::seed, 7)),
            "Simulated ring8 on cylinder:r=0.0354, link law surface, seed 7");
  EXPECT_EQ(text(ideal("sheet:2x3")), "Simulated sheet:2x3 on plane, link law bend, seed 1");
}

TEST(SimulatedSkin, RefusesWhatCannotBeWithAReason) {
  const std::tuple<const char*, const char*, const char*> impossible[] = {
      {"x18", "", "expected x17, ringN, ringN:closed or sheet:ROWSxCOLS"},
      {"", "", "expected x17, ringN, ringN:closed or sheet:ROWSxCOLS"},
      {"sheet:5", "", "expected sheet:ROWSxCOLS"},
      {"sheet:2x2x2", "", "expected sheet:ROWSxCOLS"},
      {"sheet:0x3", "", "1 to 1000000"},
      {"sheet:-1x3", "", "whole number"},
      {"sheet:ax3", "", "whole number"},
      {"sheet:1000x1001", "", "1 to 1000000"},
      {"sheet:4294967295x4294967295", "", "1 to 1000000"},
      {"x17", "cube", "expected plane"},
      {"x17", "cylinder:r=0.01", "too small"},
      {"ring8", "cylinder:r=0.02", "too small"},
      {"sheet:20x20", "sphere:r=0.06", "too small"},
      {"x17", "cone:r=0.01,angle=0.3", "too small"},
      {"ring2", "", "3 to 100000"},
      {"ring100001", "", "3 to 100000"},
      {"ringo", "", "whole number"},
      {"ring8:open", "", "whole number"},
      {"ring", "", "expected x17"},
      {"ring4", "", "too small"},
      {"ring8:closed", "plane", "does not close"},
      {"ring8:closed", "cylinder:r=0.037", "would be 20.9 mm apart"},
  };
  for (const auto& [patch, surface, reason] : impossible) {
    SCOPED_TRACE(std::string(patch) + " on " + surface);
    EXPECT_THAT(messageOf<InvalidArgument>(
                    [&, patch = patch, surface = surface] { SimulatedSkin(kModel, ideal(patch, surface)); }),
                testing::HasSubstr(reason));
  }
}

TEST(SimulatedSkin, RefusesAModelWithoutOppositePorts) {
  CellModel model = kModel;
  model.ports = {{PortNumber(1), {0.012, 0.007, 0}}, {PortNumber(2), {0.012, -0.007, 0}}};
  EXPECT_THROW(SimulatedSkin(model, ideal("x17")), InvalidArgument);
  EXPECT_THROW(SimulatedSkin(model, ideal("ring8")), InvalidArgument);
  model.ports.push_back({PortNumber(3), {-0.012, -0.007, 0}});
  EXPECT_THROW(SimulatedSkin(model, ideal("sheet:2x2")), InvalidArgument);
  EXPECT_EQ(SimulatedSkin(model, ideal("ring8")).truth().size(), 8U);
}

TEST(SimulatedSkin, RefusesNegativeOptionsByName) {
  EXPECT_NO_THROW(test::with(&SimulatedSkinOptions::joint_angle_rad, -0.1).validate());
  using Option = double SimulatedSkinOptions::*;
  for (const auto& [option, name] : std::vector<std::pair<Option, std::string>>{
           {&SimulatedSkinOptions::position_jitter_m, "position_jitter_m"},
           {&SimulatedSkinOptions::yaw_jitter_rad, "yaw_jitter_rad"},
           {&SimulatedSkinOptions::tilt_jitter_rad, "tilt_jitter_rad"},
           {&SimulatedSkinOptions::hand_orientation_sigma_rad, "hand_orientation_sigma_rad"},
           {&SimulatedSkinOptions::tremor_angle_sigma_rad, "tremor_angle_sigma_rad"},
           {&SimulatedSkinOptions::tremor_acceleration_g, "tremor_acceleration_g"},
           {&SimulatedSkinOptions::joint_angle_rad, "joint_angle_rad"},
           {&SimulatedSkinOptions::drift_rad_per_s, "drift_rad_per_s"}}) {
    for (const double bad : {-1.0, std::numeric_limits<double>::quiet_NaN()}) {
      if (bad < 0 && option == &SimulatedSkinOptions::joint_angle_rad) continue;
      const SimulatedSkinOptions options = test::with(option, bad);
      EXPECT_THAT(messageOf<InvalidArgument>([&] { options.validate(); }), testing::HasSubstr(name));
    }
  }
}

}  // namespace
}  // namespace hexoderm
