#include "hexoderm/sim/exploration.h"

#include "hexoderm/sim/simulated_skin.h"
#include "tests/support/options.h"
#include "tests/support/testing.h"

namespace hexoderm {
namespace {

using test::with;

struct Explored {
  NeighborList truth;
  CellModel model;
  LinkEnd interface_at;
  Exploration result;
};

/// Report of a perfect exploration: the skin's own list, and the interface at its port.
NeighborList withInterface(NeighborList cells, const LinkEnd& at, const CellModel& model) {
  for (CellReport& cell : cells) {
    if (cell.id == at.cell) cell.neighbors.push_back({at.port, model.interface_id, PortNumber(1)});
    std::ranges::sort(cell.neighbors, {}, &NeighborReport::port);
  }
  return cells;
}

Explored explore(const std::string& patch, const ExplorationOptions& options = {}) {
  const SimulatedSkin skin(builtInCellModel("hex-bma150"),
                           with(SimulatedSkinOptions::ideal(), &SimulatedSkinOptions::patch, patch));
  Explored explored{skin.neighbors(), skin.model(), firstFreePorts(skin.neighbors(), skin.model()).at(0), {}};
  explored.result = exploreNetwork(explored.truth, explored.model, {explored.interface_at}, options);
  return explored;
}

const CellReport* find(const NeighborList& cells, std::uint32_t id) {
  const auto found = std::ranges::find(cells, CellId(id), &CellReport::id);
  return found == cells.end() ? nullptr : &*found;
}

/// The same skin with its cells numbered as one meets them who walks along the ports from the interface.
NeighborList renumbered(const NeighborList& cells, const CellModel& model) {
  std::map<CellId, CellId> numbers = {{model.interface_id, model.interface_id}};
  std::vector<const CellReport*> met;
  const auto meet = [&](CellId id) {
    if (numbers.try_emplace(id, CellId(static_cast<std::uint32_t>(numbers.size()))).second)
      met.push_back(find(cells, id.value()));
  };
  for (const CellReport& cell : cells) {
    if (std::ranges::count(cell.neighbors, model.interface_id, &NeighborReport::cell) > 0) meet(cell.id);
  }
  NeighborList walked;
  for (std::size_t k = 0; k < met.size(); ++k) {
    walked.push_back(*met[k]);
    walked.back().id = numbers.at(met[k]->id);
    for (NeighborReport& link : walked.back().neighbors) {
      meet(link.cell);
      link.cell = numbers.at(link.cell);
    }
  }
  return walked;
}

TEST(Exploration, FindsEveryLinkOfEveryPatch) {
  for (const std::string patch : {"x17", "ring5:closed", "ring8", "ring31:closed", "sheet:1x1", "sheet:1x2",
                                  "sheet:5x1", "sheet:2x2", "sheet:7x9", "sheet:20x30"}) {
    const Explored explored = explore(patch);
    EXPECT_EQ(explored.result.cells, withInterface(explored.truth, explored.interface_at, explored.model)) << patch;
  }
}

TEST(Exploration, FindsTheSameWhateverTheCellsWakeUp) {
  const Explored first = explore("sheet:6x6");
  std::set<double> durations;
  for (std::uint64_t seed = 1; seed <= 20; ++seed) {
    const Explored other = explore("sheet:6x6", with(&ExplorationOptions::seed, seed));
    EXPECT_EQ(other.result.cells, first.result.cells) << seed;
    durations.insert(other.result.duration_s);
  }
  EXPECT_GT(durations.size(), 10U);
}

TEST(Exploration, TakesThePapersTimeFor31CellsAndWaitsMostOfIt) {
  const Exploration result = explore("ring31:closed").result;
  EXPECT_GT(result.duration_s, 0.117);
  EXPECT_LT(result.duration_s, 0.143);  // the paper: roughly 130 ms
  EXPECT_GT(result.waiting_s, 0.8 * result.duration_s);
  EXPECT_LT(result.waiting_s, result.duration_s);
}

TEST(Exploration, RoutesAreTheShortest) {
  const Exploration one = explore("sheet:1x1").result;
  EXPECT_EQ(one.longest_route, 1U);
  EXPECT_GT(one.messages, 10U) << "both sides say hello at two ports";
  EXPECT_EQ(explore("ring8").result.longest_route, 8U);
  EXPECT_EQ(explore("ring8:closed").result.longest_route, 5U);
  EXPECT_EQ(explore("ring9:closed").result.longest_route, 5U);
}

TEST(Exploration, CellsThatForgotTheirIdsGetNewOnes) {
  const ExplorationOptions options = with(&ExplorationOptions::ids_remembered, false);
  for (const std::string patch : {"x17", "ring8:closed", "sheet:5x6"}) {
    const Explored explored = explore(patch, options);
    const NeighborList truth = withInterface(explored.truth, explored.interface_at, explored.model);
    ASSERT_EQ(explored.result.cells.size(), truth.size());
    for (std::size_t k = 0; k < truth.size(); ++k) EXPECT_EQ(explored.result.cells[k].id.value(), k + 1);
    EXPECT_EQ(renumbered(explored.result.cells, explored.model), renumbered(truth, explored.model)) << patch;
  }
}

TEST(Exploration, ADeadCellIsMissingAndSoIsWhatLiesBehindIt) {
  ExplorationOptions options;
  options.dead_cells = {CellId(3)};
  const Explored chain = explore("ring8", options);  // the interface is at cell 1
  ASSERT_EQ(chain.result.cells.size(), 2U);
  EXPECT_EQ(chain.result.cells[1].neighbors.size(), 1U) << "cell 2 hears cell 1 alone";

  const Explored ring = explore("ring8:closed", options);
  EXPECT_EQ(ring.result.cells.size(), 7U) << "the others are reached the other way round";
  EXPECT_EQ(find(ring.result.cells, 3), nullptr);
  EXPECT_EQ(ring.result.longest_route, 6U);

  options.dead_cells = {CellId(1)};
  EXPECT_THAT(explore("ring8", options).result.cells, IsEmpty());
}

TEST(Exploration, APortThatWorksInOneDirectionGivesAOneSidedLink) {
  // A closed ring, so that both cells are reached in any case.
  const Explored whole = explore("ring8:closed");
  const NeighborReport link = *std::ranges::find(find(whole.truth, 5)->neighbors, CellId(6), &NeighborReport::cell);
  const auto sees = [](const Explored& explored, std::uint32_t who, std::uint32_t whom) {
    const CellReport* cell = find(explored.result.cells, who);
    return cell != nullptr &&
           std::ranges::find(cell->neighbors, CellId(whom), &NeighborReport::cell) != cell->neighbors.end();
  };
  const auto explored_with = [&](PortFaultKind kind) {
    const Explored explored =
        explore("ring8:closed", with(&ExplorationOptions::port_faults, {{kind, {CellId(5), link.port}}}));
    EXPECT_EQ(explored.result.cells.size(), 8U);
    return std::pair(sees(explored, 5, 6), sees(explored, 6, 5));
  };
  EXPECT_EQ(explored_with(PortFaultKind::Deaf), std::pair(false, true));
  EXPECT_EQ(explored_with(PortFaultKind::Mute), std::pair(true, false));
  EXPECT_EQ(explored_with(PortFaultKind::Cut), std::pair(false, false));
}

TEST(Exploration, AWrongPortIsExploredAsTheCellsKnowIt) {
  SimulatedSkinOptions options = SimulatedSkinOptions::ideal();
  options.link_faults = {{LinkFaultKind::WrongPort, {CellId(3), PortNumber(1)}}};
  const SimulatedSkin skin(builtInCellModel("hex-bma150"), options);
  const LinkEnd at = firstFreePorts(skin.neighbors(), skin.model()).at(0);
  EXPECT_EQ(exploreNetwork(skin.neighbors(), skin.model(), {at}).cells,
            withInterface(skin.neighbors(), at, skin.model()));
}

TEST(Exploration, AnInterfaceWithAPortForEachPatchFindsThemAll) {
  const CellModel model = builtInCellModel("hex-bma150");
  NeighborList cells = explore("ring8").truth;
  // The same ring again, with other numbers, and one cell alone.
  for (CellReport cell : NeighborList(cells)) {
    cell.id = CellId(cell.id.value() + 8);
    for (NeighborReport& link : cell.neighbors) link.cell = CellId(link.cell.value() + 8);
    cells.push_back(cell);
  }
  cells.push_back({CellId(17), "", {}});
  const std::vector<LinkEnd> at = firstFreePorts(cells, model);
  ASSERT_EQ(at.size(), 3U);
  EXPECT_EQ(at[1].cell, CellId(9));
  EXPECT_EQ(at[2], (LinkEnd{CellId(17), PortNumber(1)}));
  NeighborList expected = cells;
  for (std::uint32_t k = 0; k < 3; ++k) {
    CellReport& cell = expected.at(at[k].cell.value() - 1);
    cell.neighbors.push_back({at[k].port, model.interface_id, PortNumber(k + 1)});
    std::ranges::sort(cell.neighbors, {}, &NeighborReport::port);
  }
  EXPECT_EQ(exploreNetwork(cells, model, at).cells, expected);
  EXPECT_EQ(exploreNetwork(cells, model, {at[1]}).cells.size(), 8U) << "the others are not reached";
  // One end that says so joins patches.
  cells[16].neighbors = {{PortNumber(2), CellId(16), PortNumber(4)}};
  EXPECT_EQ(firstFreePorts(cells, model).size(), 2U);
}

TEST(Exploration, NoCellsAreNoSkin) {
  const CellModel model = builtInCellModel("hex-bma150");
  const Exploration result = exploreNetwork({}, model, {});
  EXPECT_THAT(result.cells, IsEmpty());
  EXPECT_EQ(result.longest_route, 0U);
  EXPECT_THROW(firstFreePorts({}, model), InvalidArgument);
}

TEST(Exploration, RefusesWiringThatCantBe) {
  const CellModel model = builtInCellModel("hex-bma150");
  const auto link = [](std::uint32_t port, std::uint32_t cell, std::uint32_t cell_port) {
    return NeighborReport{PortNumber(port), CellId(cell), PortNumber(cell_port)};
  };
  const std::vector<LinkEnd> at = {{CellId(1), PortNumber(4)}};
  EXPECT_EQ(exploreNetwork({{CellId(1), "", {link(1, 2, 3)}}, {CellId(2), "", {}}}, model, at).cells.size(), 2U)
      << "one end of a link is enough";
  const std::vector<NeighborList> wirings = {
      {{CellId(1), "", {link(9, 2, 3)}}, {CellId(2), "", {}}},                             // port
      {{CellId(1), "", {link(1, 7, 3)}}, {CellId(2), "", {}}},                             // cell
      {{CellId(1), "", {link(1, 2, 3), link(2, 2, 3)}}, {CellId(2), "", {}}},              // twice
      {{CellId(1), "", {}}, {CellId(1), "", {}}},                                          // same ID
      {{CellId(1), "", {}}, {CellId(16383), "", {}}},                                      // interface's
      {{CellId(1), "", {link(4, 2, 3)}}, {CellId(2), "", {}}},                             // not free
      {{CellId(1), "", {{PortNumber(1), CellId(2), std::nullopt}}}, {CellId(2), "", {}}},  // unknown
      {{CellId(2), "", {}}},                                                               // no cell 1
  };
  for (const NeighborList& wiring : wirings) EXPECT_THROW(exploreNetwork(wiring, model, at), InvalidArgument);
  for (const ExplorationOptions& options :
       {with(&ExplorationOptions::hellos, 0), with(&ExplorationOptions::bits_per_s, 0)}) {
    EXPECT_THROW(exploreNetwork({}, model, at, options), InvalidArgument);
  }
  EXPECT_THROW(exploreNetwork({{CellId(1), "", {}}}, model, at, with(&ExplorationOptions::dead_cells, {CellId(4)})),
               InvalidArgument);
}

}  // namespace
}  // namespace hexoderm
