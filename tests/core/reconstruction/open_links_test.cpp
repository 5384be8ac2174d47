// Links that look like skin links in their angles, and leave their loops open: cables. That healthy links are not taken
// for such is shown by Garbage.HealthySkinsHaveNone, and counted by `hexoderm-cli reproduce --only detection`.

#include "hexoderm/reconstruction/reconstructor.h"
#include "tests/support/changed_session.h"
#include "tests/support/matchers.h"
#include "tests/support/simulated_skins.h"

#include <algorithm>
#include <iterator>

namespace hexoderm {
namespace {

using ::testing::ElementsAre;
using ::testing::SizeIs;

Session withLink(const Session& session, LinkEnd a, LinkEnd b) {
  NeighborList neighbors = session.neighbors();
  for (CellReport& report : neighbors) {
    for (const auto& [from, to] : {std::pair(a, b), std::pair(b, a)}) {
      if (report.id != from.cell) continue;
      std::erase_if(report.neighbors, [port = from.port](const NeighborReport& n) { return n.port == port; });
      report.neighbors.push_back({from.port, to.cell, to.port});
    }
  }
  return withNeighbors(session, neighbors);
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
    const Session session = test::simulatedSession(test::skinOptions("sheet:6x6", "cylinder:r=0.3", seed), 4);
    const auto [a, b] = farFreePorts(session.neighbors());
    const auto without = reconstruct(*session.snapshot());
    const auto with = reconstruct(*withLink(session, a, b).snapshot());

    std::vector<Finding> found;
    std::ranges::copy_if(with->findings, std::back_inserter(found),
                         [](const Finding& f) { return f.code == FindingCode::LinkDoesNotClose; });
    ASSERT_THAT(found, SizeIs(1));
    EXPECT_THAT(found.front().cells, ElementsAre(std::min(a.cell, b.cell), std::max(a.cell, b.cell)));
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

}  // namespace
}  // namespace hexoderm
