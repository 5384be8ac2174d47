// Links that look like skin links in their angles, and leave their loops open: cables.

#include "hexoderm/device/simulation/simulated_skin.h"
#include "hexoderm/reconstruction/reconstructor.h"
#include "hexoderm/session/simulated_session.h"
#include "tests/support/matchers.h"

#include <algorithm>
#include <iterator>

namespace hexoderm {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::SizeIs;

SimulatedSkin skinOf(const std::string& patch, const std::string& surface, std::uint64_t seed, LinkLaw law) {
  SimulatedSkinOptions options;
  options.patch = patch;
  options.surface = surface;
  options.seed = seed;
  options.link_law = law;
  return {builtInCellModel("hex-bma150"), options};
}

Session withLink(const Session& session, LinkEnd a, LinkEnd b) {
  NeighborList neighbors = session.neighbors();
  for (CellReport& report : neighbors) {
    for (const auto& [from, to] : {std::pair(a, b), std::pair(b, a)}) {
      if (report.id != from.cell) continue;
      std::erase_if(report.neighbors, [port = from.port](const NeighborReport& n) { return n.port == port; });
      report.neighbors.push_back({from.port, to.cell, to.port});
    }
  }
  Session result(session.model(), neighbors);
  for (const SessionPose& pose : session.poses()) result.addPose(pose);
  return result;
}

/// A free port like the source's (target's) of the sheet's first link, at the cell with the largest (smallest) ID that
/// has one: the two are far apart, and joined they are turned against each other like any neighbours. Only cells with
/// two more links count: for a cell that hangs by a single other one, nobody could tell which of the two is the cable.
std::pair<LinkEnd, LinkEnd> farFreePorts(const NeighborList& neighbors) {
  const auto linked = [](const NeighborReport& n) { return n.cell.value() != 0; };
  const auto first = std::ranges::find_if(neighbors.front().neighbors, linked);
  std::pair<LinkEnd, LinkEnd> ends;
  for (const CellReport& report : neighbors) {
    if (std::ranges::count_if(report.neighbors, linked) < 2) continue;
    const auto isFree = [&](PortNumber port) {
      return std::ranges::none_of(report.neighbors,
                                  [&](const NeighborReport& n) { return n.port == port && linked(n); });
    };
    if (isFree(first->port)) ends.first = {report.id, first->port};
    if (ends.second.cell.value() == 0 && isFree(*first->cell_port)) ends.second = {report.id, *first->cell_port};
  }
  return ends;
}

TEST(OpenLinks, ACableAcrossASheetIsFoundAndTheRestStaysWhereItIs) {
  for (const std::uint64_t seed : {1U, 2U, 3U}) {
    SimulatedSkin skin = skinOf("sheet:6x6", "cylinder:r=0.3", seed, LinkLaw::Bend);
    const Session session = simulateSession(skin, 4);
    const auto [a, b] = farFreePorts(session.neighbors());
    const auto without = reconstruct(*session.snapshot());
    const auto with = reconstruct(*withLink(session, a, b).snapshot());

    std::vector<Finding> found;
    std::ranges::copy_if(with->findings, std::back_inserter(found),
                         [](const Finding& f) { return f.code == FindingCode::LinkDoesNotClose; });
    ASSERT_THAT(found, SizeIs(1));
    EXPECT_THAT(found.front().cells, ElementsAre(std::min(a.cell, b.cell), std::max(a.cell, b.cell)));
    EXPECT_THAT(found.front().message.english(), HasSubstr("no other link is in all of its loops"));
    ASSERT_THAT(with->patches, SizeIs(1));
    const CellPlacement& origin = without->patches.front().cells.front();
    for (const CellPlacement& cell : without->patches.front().cells) {
      // From one cell to another: the two patches may have different origins.
      const SE3 expected = origin.T_o_u.inverse() * cell.T_o_u;
      const SE3 T = with->find(origin.cell).cell->T_o_u.inverse() * with->find(cell.cell).cell->T_o_u;
      EXPECT_THAT(T, SE3Near(expected, 1e-4, 1e-5));
    }
  }
}

TEST(OpenLinks, AnyLinkOfASingleLoopMayBeTheCable) {
  SimulatedSkin skin = skinOf("sheet:1x8", "", 1, LinkLaw::Bend);
  const Session session = simulateSession(skin, 4);
  const std::vector<NeighborReport>& of_first = session.neighbors().front().neighbors;
  const NeighborReport& link = *std::ranges::find(of_first, CellId(2), &NeighborReport::cell);
  const Session with_cable = withLink(session, {CellId(1), link.cell_port.value()}, {CellId(8), link.port});
  const auto result = reconstruct(*with_cable.snapshot());
  const auto found = std::ranges::find(result->findings, FindingCode::LinkDoesNotClose, &Finding::code);
  ASSERT_NE(found, result->findings.end());
  EXPECT_THAT(found->message.english(), HasSubstr("All of its loops have 8 links in common"));
}

TEST(OpenLinks, ACableSetAsideByHandChangesNothing) {
  SimulatedSkin skin = skinOf("sheet:6x6", "cylinder:r=0.3", 1, LinkLaw::Bend);
  const Session session = simulateSession(skin, 4);
  const auto [a, b] = farFreePorts(session.neighbors());
  const auto without = reconstruct(*session.snapshot());
  Session with_cable = withLink(session, a, b);
  with_cable.setLinkMuted(a, b, true);
  const auto result = reconstruct(*with_cable.snapshot());
  EXPECT_TRUE(
      std::ranges::none_of(result->findings, [](const Finding& f) { return f.code == FindingCode::LinkDoesNotClose; }));
  ASSERT_THAT(result->patches, SizeIs(1));
  EXPECT_EQ(result->patches.front().origin, without->patches.front().origin);
  for (const CellPlacement& cell : without->patches.front().cells) {
    EXPECT_THAT(result->find(cell.cell).cell->T_o_u, SE3Near(cell.T_o_u, 1e-9, 1e-9));
  }
  EXPECT_EQ(result->findLink(a, b)->muted_by, FindingCode::LinkSetAside);
}

class HealthyLinks : public ::testing::TestWithParam<std::tuple<const char*, const char*, LinkLaw>> {};

TEST_P(HealthyLinks, CloseTheirLoops) {
  const auto& [patch, surface, law] = GetParam();
  for (std::uint64_t seed = 1; seed <= 5; ++seed) {
    SimulatedSkin skin = skinOf(patch, surface, seed, law);
    for (const std::size_t poses : {2U, 3U, 6U}) {
      const auto result = reconstruct(*simulateSession(skin, poses).snapshot());
      EXPECT_EQ(std::ranges::count(result->findings, FindingCode::LinkDoesNotClose, &Finding::code), 0)
          << "seed " << seed << ", " << poses << " poses";
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Skins, HealthyLinks,
                         ::testing::Combine(::testing::Values("sheet:6x6", "ring8:closed"), ::testing::Values(""),
                                            ::testing::Values(LinkLaw::Bend, LinkLaw::Surface)));
INSTANTIATE_TEST_SUITE_P(CurvedSheets, HealthyLinks,
                         ::testing::Combine(::testing::Values("sheet:6x6"),
                                            ::testing::Values("cylinder:r=0.08", "sphere:r=0.15", "torus:R=0.2,r=0.1"),
                                            ::testing::Values(LinkLaw::Bend, LinkLaw::Surface)));

}  // namespace
}  // namespace hexoderm
