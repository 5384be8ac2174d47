#include "hexoderm/base/units.h"
#include "hexoderm/solve/result/reconstruction.h"
#include "tests/support/result_builder.h"
#include "tests/support/testing.h"

namespace hexoderm {
namespace {

using test::ResultBuilder;

const test::SheetOptions kTube{.origin = 1, .closed = true};

const FlatCell& cellOf(const FlatLayout& layout, std::uint32_t id) {
  return *std::ranges::find(layout.cells, CellId(id), &FlatCell::cell);
}

double smallestDistance(const FlatLayout& layout) {
  double smallest = std::numeric_limits<double>::infinity();
  for (std::size_t a = 0; a < layout.cells.size(); ++a) {
    for (std::size_t b = 0; b < a; ++b) {
      smallest = std::min(smallest, (layout.cells[a].center - layout.cells[b].center).norm());
    }
  }
  return smallest;
}

std::size_t countCuts(const FlatLayout& layout) {
  return static_cast<std::size_t>(std::ranges::count_if(layout.links, &FlatLink::cut));
}

/// Every link starts and ends at the port points of its cells, and those of a link that is not cut meet.
void expectLinksAtPorts(const FlatLayout& layout, const CellModel& model,
                        const std::vector<PatchReconstruction>& patches, double tolerance_m) {
  for (const FlatLink& flat : layout.links) {
    const LinkEstimate& link = patches.at(flat.patch.value()).links.at(flat.link);
    const auto point = [&](LinkEnd end) -> Eigen::Vector2d {
      const FlatCell& cell = cellOf(layout, end.cell.value());
      return cell.center + Eigen::Rotation2Dd(cell.angle_rad) * model.port(end.port).vector_m.head<2>();
    };
    EXPECT_LT((flat.from - point(link.source)).norm(), 1e-12);
    EXPECT_LT((flat.to - point(link.target)).norm(), 1e-12);
    if (link.used && !flat.cut) {
      EXPECT_LT((flat.to - flat.from).norm(), tolerance_m) << link.source.cell << '-' << link.target.cell;
    }
  }
}

class FlatLayoutTest : public testing::Test {
 protected:
  const CellModel model_ = builtInCellModel("hex-bma150");
  /// Centre to side of two cells that touch, without the gap.
  const double width_m_ = 2 * model_.side_m * std::cos(kPi / 6);
};

TEST_F(FlatLayoutTest, IsEmptyForAnEmptySkin) {
  EXPECT_TRUE(computeFlatLayout(model_, {}).cells.empty());
  const FlatLayout layout = computeFlatLayout(model_, {PatchReconstruction()});
  EXPECT_TRUE(layout.cells.empty());
  EXPECT_TRUE(layout.links.empty());
}

TEST_F(FlatLayoutTest, PutsASingleCellUprightAtZero) {
  const FlatLayout layout = computeFlatLayout(model_, ResultBuilder().patch(7).cell(7).build().patches);
  ASSERT_EQ(layout.cells.size(), 1u);
  EXPECT_EQ(layout.cells[0].cell, CellId(7));
  EXPECT_EQ(layout.cells[0].center, Eigen::Vector2d::Zero());
  EXPECT_EQ(layout.cells[0].angle_rad, 0);
}

TEST_F(FlatLayoutTest, TurnsNeighboursByTheNominalAlignmentFromEitherEnd) {
  for (const std::uint32_t origin : {1u, 2u}) {
    for (const Port& a : model_.ports) {
      for (const Port& b : model_.ports) {
        const auto patches =
            ResultBuilder().patch(origin).cells(1, 2).link(1, a.number.value(), 2, b.number.value()).build().patches;
        const FlatLayout layout = computeFlatLayout(model_, patches);
        const Eigen::Matrix2d R_1 = Eigen::Rotation2Dd(cellOf(layout, 1).angle_rad).toRotationMatrix();
        const Eigen::Matrix2d R_2 = Eigen::Rotation2Dd(cellOf(layout, 2).angle_rad).toRotationMatrix();
        EXPECT_TRUE((R_1.transpose() * R_2).isApprox(nominalAlignment(a, b).topLeftCorner<2, 2>(), 1e-12));
        EXPECT_EQ(cellOf(layout, origin).angle_rad, 0);
        expectLinksAtPorts(layout, model_, patches, 1e-12);
      }
    }
  }
}

TEST_F(FlatLayoutTest, KeepsASheetWholeWithAllLinksMeeting) {
  const auto patches = ResultBuilder().sheet(12, 9).build().patches;
  const FlatLayout layout = computeFlatLayout(model_, patches);
  ASSERT_EQ(layout.cells.size(), 108u);
  ASSERT_EQ(layout.links.size(), patches[0].links.size());
  EXPECT_EQ(countCuts(layout), 0u);
  EXPECT_GT(smallestDistance(layout), width_m_);
  expectLinksAtPorts(layout, model_, patches, 1e-12);
}

TEST_F(FlatLayoutTest, CutsAClosedRingOnceFarFromItsOrigin) {
  ResultBuilder ring;
  ring.patch(3).cells(1, 8);
  for (std::uint32_t id = 1; id <= 8; ++id) ring.link(id, 2, id % 8 + 1, 3);
  const FlatLayout layout = computeFlatLayout(model_, ring.build().patches);
  EXPECT_EQ(countCuts(layout), 1u);
  const FlatLink& cut = *std::ranges::find(layout.links, true, &FlatLink::cut);
  EXPECT_THAT(cut.link, testing::AnyOf(5u, 6u));  // between 6, 7 and 8, across from 3
  EXPECT_GT(smallestDistance(layout), width_m_);
}

TEST_F(FlatLayoutTest, CutsAClosedTubeAlongOneSeam) {
  const auto patches = ResultBuilder().sheet(7, 10, kTube).build().patches;
  const FlatLayout layout = computeFlatLayout(model_, patches);
  EXPECT_GE(countCuts(layout), 7u);
  EXPECT_LE(countCuts(layout), 14u);
  EXPECT_GT(smallestDistance(layout), width_m_);
  expectLinksAtPorts(layout, model_, patches, 1e-12);
}

TEST_F(FlatLayoutTest, NeverPutsTwoHexagonsOnOneSpotEvenWhereAChainCurlsUp) {
  // Ports 1 and 3 turn each cell by 60 degrees: the seventh would lie on the first.
  ResultBuilder chain;
  chain.patch(1).cells(1, 40);
  for (std::uint32_t id = 1; id < 40; ++id) chain.link(id, 1, id + 1, 3);
  const auto patches = chain.build().patches;
  const FlatLayout layout = computeFlatLayout(model_, patches);
  EXPECT_EQ(layout.cells.size(), 40u);
  EXPECT_GT(smallestDistance(layout), 0.84 * width_m_);
  EXPECT_GE(countCuts(layout), 6u);
  EXPECT_LE(countCuts(layout), 8u);
  expectLinksAtPorts(layout, model_, patches, 1e-3);
}

TEST_F(FlatLayoutTest, LaysPatchesApart) {
  const auto patches =
      ResultBuilder().sheet(4, 4).patch(201).cells(201, 203).link(201, 1, 202, 4).link(202, 1, 203, 4).build().patches;
  const FlatLayout layout = computeFlatLayout(model_, patches);
  Eigen::AlignedBox2d first_box;
  Eigen::AlignedBox2d second_box;
  for (const FlatCell& cell : layout.cells) (cell.cell < CellId(100) ? first_box : second_box).extend(cell.center);
  EXPECT_GT(first_box.exteriorDistance(second_box), 1.3 * width_m_);
  EXPECT_EQ(cellOf(layout, 1).center, Eigen::Vector2d::Zero());
}

TEST_F(FlatLayoutTest, DrawsMutedLinksBetweenTheirPortsWithoutFollowingThem) {
  const auto patches = ResultBuilder()
                           .patch(1)
                           .cells(1, 2)
                           .link(1, 1, 2, 4)
                           .link(2, 1, 3, 4, test::mutedLink())
                           .patch(3)
                           .cell(3)
                           .build()
                           .patches;
  const FlatLayout layout = computeFlatLayout(model_, patches);
  ASSERT_EQ(layout.links.size(), 2u);
  EXPECT_FALSE(layout.links[1].cut);
  EXPECT_GT((layout.links[1].to - layout.links[1].from).norm(), model_.reach_m());
  expectLinksAtPorts(layout, model_, patches, 1e-12);
}

TEST_F(FlatLayoutTest, MeetsAtPortsOfDifferentLength) {
  CellModel model = model_;
  model.ports = {{PortNumber(1), {0.020, 0, 0}}, {PortNumber(2), {-0.014, 0.001, 0}}, {PortNumber(5), {0, 0.016, 0}}};
  const auto patches =
      ResultBuilder(model).patch(2).cells(1, 4).link(1, 1, 2, 2).link(2, 5, 3, 1).link(3, 2, 4, 5).build().patches;
  const FlatLayout layout = computeFlatLayout(model, patches);
  EXPECT_EQ(countCuts(layout), 0u);
  EXPECT_NEAR((cellOf(layout, 2).center - cellOf(layout, 3).center).norm(), 0.036, 1e-12);
  expectLinksAtPorts(layout, model, patches, 1e-12);
}

TEST_F(FlatLayoutTest, PlacesCellsThatNoLinkReaches) {
  const FlatLayout layout =
      computeFlatLayout(model_, ResultBuilder().patch(99).cells(1, 5).link(4, 1, 5, 4).build().patches);
  EXPECT_EQ(layout.cells.size(), 5u);
  EXPECT_GT(smallestDistance(layout), width_m_);
}

TEST_F(FlatLayoutTest, LaysAHundredThousandCells) {
  const auto patches = ResultBuilder().sheet(250, 400, kTube).build().patches;
  const FlatLayout layout = computeFlatLayout(model_, patches);
  EXPECT_EQ(layout.cells.size(), 100'000u);
  EXPECT_EQ(layout.links.size(), patches[0].links.size());
  EXPECT_GE(countCuts(layout), 250u);
  EXPECT_LE(countCuts(layout), 500u);
}

}  // namespace
}  // namespace hexoderm
