// Sessions that make no sense, in part or as a whole, are named, and healthy ones are not. Simulated.

#include "hexoderm/solve/reconstructor.h"
#include "tests/support/changed_session.h"
#include "tests/support/matchers.h"
#include "tests/support/simulated_skins.h"
#include "tests/support/solvers.h"
#include "tests/support/testing.h"

namespace hexoderm {
namespace {

using ::testing::AnyOf;

constexpr std::uint64_t kSeeds = 6;

struct SkinCase {
  std::string patch = "x17";
  std::string surface = {};
  std::vector<CellFault> faults = {};
  std::vector<WholeSkinFault> whole = {};
  LinkLaw law = LinkLaw::Bend;
};

std::shared_ptr<const Reconstruction> solved(const SkinCase& skin, std::uint64_t seed, std::size_t poses,
                                             const SolverOptions& solver = {}) {
  SimulatedSkinOptions options = test::skinOptions(skin.patch, skin.surface, seed);
  options.faults = skin.faults;
  options.whole_skin_faults = skin.whole;
  options.link_law = skin.law;
  options.reglued_before = poses - 1;
  return reconstruct(*test::simulatedSession(options, poses).snapshot(), solver);
}

/// Cells that findings above an information are about.
std::set<CellId> namedCells(const Reconstruction& result) {
  std::set<CellId> cells;
  for (const Finding& finding : result.findings) {
    if (finding.severity != Severity::Info) cells.insert(finding.cells.begin(), finding.cells.end());
  }
  return cells;
}

TEST(Garbage, ACellThatEchoesItsNeighbourIsNamedWithIt) {
  for (std::uint64_t seed = 1; seed <= kSeeds; ++seed) {
    for (const std::size_t poses : {2U, 4U}) {
      const auto result = solved({.faults = {{SkinFault::Echo, CellId(3)}}}, seed, poses);
      EXPECT_THAT(*result, HasFinding(FindingCode::IdenticalReadings,
                                      Field(&Finding::cells, AllOf(SizeIs(2), Contains(CellId(3))))))
          << "seed " << seed;
      EXPECT_EQ(result->find(CellId(3)).cell->placed_by, PlacedBy::Links);
      EXPECT_NE(result->assessment.level, VerdictLevel::Good);
    }
  }
}

TEST(Garbage, CellsThatAllSendTheSameAreNoSkin) {
  const auto result = solved({.whole = {WholeSkinFault::Identical}}, 1, 4);
  EXPECT_THAT(*result, HasFinding(FindingCode::IdenticalReadings, Field(&Finding::cells, SizeIs(17))));
  EXPECT_EQ(result->assessment.level, VerdictLevel::Failed);
  EXPECT_THAT(*result, IsFinite());
}

TEST(Garbage, ReadingsOfAnIdealFlatSkinAreTheSameAndNoFault) {
  SimulatedSkinOptions options = SimulatedSkinOptions::ideal();
  options.patch = "sheet:3x3";
  EXPECT_THAT(namedCells(*reconstruct(*test::simulatedSession(options, 3).snapshot())), ::testing::IsEmpty());
}

TEST(Garbage, MeansOfEightBitsMayBeTheSame) {
  constexpr double kStep_g = 4.0 / 256;
  constexpr std::uint64_t kSkins = 50;
  for (std::uint64_t seed = 1; seed <= kSkins; ++seed) {
    const Session fine = test::simulatedSession(test::skinOptions("sheet:5x5", {}, seed), 4);
    const Session coarse = changed(fine, [&](std::size_t /*pose*/, GravitySample& sample) {
      sample.mean_g = kStep_g * (sample.mean_g / kStep_g).array().round();
    });
    EXPECT_THAT(*reconstruct(*coarse.snapshot()), ::testing::Not(HasFinding(FindingCode::IdenticalReadings)))
        << "seed " << seed;
  }
}

TEST(Garbage, SwappedNeighboursAreNamed) {
  for (std::uint64_t seed = 1; seed <= kSeeds; ++seed) {
    for (const std::size_t poses : {2U, 3U, 6U}) {
      const auto result = solved({.faults = {{SkinFault::Swapped, CellId(3)}}}, seed, poses);
      EXPECT_THAT(*result,
                  HasFinding(FindingCode::SwappedReadings,
                             Field(&Finding::cells, UnorderedElementsAre(CellId(3), AnyOf(CellId(2), CellId(4))))))
          << "seed " << seed << ", " << poses << " poses";
      EXPECT_NE(result->assessment.level, VerdictLevel::Good);
    }
  }
}

TEST(Garbage, ASkinWithSwappedNeighboursIsPlacedAsWithoutThem) {
  for (std::uint64_t seed = 1; seed <= kSeeds; ++seed) {
    SimulatedSkinOptions skin;
    skin.seed = seed;
    skin.faults = {{SkinFault::Swapped, CellId(3)}};
    const auto snapshot = test::simulatedSession(skin, 3).snapshot();
    const auto found = reconstruct(*snapshot);
    SolverOptions options;
    const std::set<CellId> named = namedCells(*found);
    options.left_out.assign(named.begin(), named.end());
    const auto without = reconstruct(*snapshot, options);
    ASSERT_EQ(found->patches.size(), without->patches.size());
    EXPECT_EQ(found->patches.front().origin, without->patches.front().origin) << "seed " << seed;
    for (const CellPlacement& cell : found->patches.front().cells) {
      const CellPlacement& other = *without->find(cell.cell).cell;
      EXPECT_EQ(cell.predecessor, other.predecessor) << "seed " << seed << ", cell " << cell.cell;
      EXPECT_LT((cell.T_o_u.t - other.T_o_u.t).norm(), 1e-6) << "seed " << seed << ", cell " << cell.cell;
    }
  }
}

TEST(Garbage, ASensorTurnedInTheSurfaceIsNamedInTheMiddleAndAtALeaf) {
  for (const CellId cell : {CellId(3), CellId(17)}) {
    for (std::uint64_t seed = 1; seed <= kSeeds; ++seed) {
      const auto result = solved({.faults = {{SkinFault::Yawed, cell}}}, seed, 3);
      EXPECT_THAT(namedCells(*result), Contains(cell)) << "seed " << seed;
      EXPECT_NE(result->assessment.level, VerdictLevel::Good);
    }
  }
}

TEST(Garbage, ALeafThatIsGluedAnewBeforeTheLastPoseIsNamed) {
  std::size_t found = 0;
  for (std::uint64_t seed = 1; seed <= 20; ++seed) {
    const auto result = solved({.faults = {{SkinFault::Reglued, CellId(17)}}}, seed, 6);
    if (namedCells(*result).contains(CellId(17)) && result->assessment.level != VerdictLevel::Good) ++found;
  }
  EXPECT_GE(found, 18U) << "an axis along gravity does not show";
}

TEST(Garbage, AxesAndPortsThatAreNotTheModelsAreNamed) {
  for (const WholeSkinFault fault :
       {WholeSkinFault::AxesSwapped, WholeSkinFault::AxesPermuted, WholeSkinFault::PortsRotated}) {
    for (std::uint64_t seed = 1; seed <= kSeeds; ++seed) {
      const auto result = solved({.whole = {fault}}, seed, 3);
      EXPECT_NE(result->assessment.level, VerdictLevel::Good)
          << "fault " << static_cast<int>(fault) << ", seed " << seed;
      EXPECT_GE(namedCells(*result).size(), 2U);
    }
  }
  EXPECT_THAT(*solved({.whole = {WholeSkinFault::AxesSwapped}}, 1, 3), HasFinding(FindingCode::ContradictsModel));
  EXPECT_THAT(*solved({.whole = {WholeSkinFault::PortsRotated}}, 1, 3), HasFinding(FindingCode::ContradictsModel));
}

TEST(Garbage, NoiseLeavesNothingToUse) {
  for (const WholeSkinFault fault : {WholeSkinFault::Shuffled, WholeSkinFault::Random}) {
    for (std::uint64_t seed = 1; seed <= kSeeds; ++seed) {
      const auto result = solved({.whole = {fault}}, seed, 3);
      EXPECT_EQ(result->assessment.level, VerdictLevel::Failed)
          << "fault " << static_cast<int>(fault) << ", seed " << seed;
      EXPECT_THAT(*result, IsFinite());
    }
  }
}

TEST(Garbage, TheTreeFindsItToo) {
  const SolverOptions tree = test::by(Solver::Tree);
  const auto swapped = solved({.faults = {{SkinFault::Swapped, CellId(3)}}}, 1, 4, tree);
  EXPECT_THAT(namedCells(*swapped), Contains(CellId(3)));
  const auto yawed = solved({.faults = {{SkinFault::Yawed, CellId(3)}}}, 1, 4, tree);
  EXPECT_THAT(namedCells(*yawed), Contains(CellId(3)));
  EXPECT_THAT(*solved({.whole = {WholeSkinFault::AxesSwapped}}, 1, 4, tree), HasFinding(FindingCode::ContradictsModel));
}

/// The rates are `hexoderm-reproduce --only detection`'s to measure.
TEST(Garbage, HealthySkinsHaveNone) {
  const std::vector<SkinCase> skins = {
      {},
      {.surface = "sphere:r=0.1"},
      {.patch = "ring8"},
      {.patch = "ring8:closed"},
      {.patch = "sheet:3x4"},
      {.patch = "sheet:5x5"},
      {.patch = "sheet:5x5", .surface = "cylinder:r=0.08"},
      {.patch = "sheet:5x5", .surface = "torus:R=0.2,r=0.1"},
      {.patch = "sheet:4x5", .surface = "cone:r=0.06,angle=0.3", .law = LinkLaw::Surface}};
  for (const SkinCase& skin : skins) {
    for (std::uint64_t seed = 1; seed <= 3; ++seed) {
      for (const std::size_t poses : {2U, 3U, 4U, 6U}) {
        const auto result = solved(skin, seed, poses);
        EXPECT_EQ(findingOf(*result, FindingCode::SensorsUnlikeModel), nullptr) << skin.patch;
        EXPECT_THAT(namedCells(*result), ::testing::IsEmpty())
            << skin.patch << " on " << skin.surface << ", seed " << seed << ", " << poses << " poses";
      }
    }
  }
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

TEST(Garbage, ACableAcrossASheetIsFoundAndTheRestStaysWhereItIs) {
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

TEST(Garbage, AnyLinkOfASingleLoopMayBeTheCable) {
  const Session session = test::simulatedSession(test::skinOptions("sheet:1x8"), 4);
  const std::vector<NeighborReport>& of_first = session.neighbors().front().neighbors;
  const NeighborReport& link = *std::ranges::find(of_first, CellId(2), &NeighborReport::cell);
  const Session with_cable = withLink(session, {CellId(1), link.cell_port.value()}, {CellId(8), link.port});
  const auto result = reconstruct(*with_cable.snapshot());
  const auto found = std::ranges::find(result->findings, FindingCode::LinkDoesNotClose, &Finding::code);
  ASSERT_NE(found, result->findings.end());
  EXPECT_THAT(found->message.english(), HasSubstr("All of its loops have 8 links in common"));
}

/// A hand turns the part while it is sampled. Over so few samples that does not average out, and far from the middle
/// cells read another force than near it: no cell is to blame for that. A reading of more than 1.3 g or less than 0.7 g
/// is another matter.
TEST(Garbage, WhatAHandDoesWithinFewSamplesIsNone) {
  for (const Solver solver : {Solver::Global, Solver::Tree}) {
    for (std::uint64_t seed = 1; seed <= 12; ++seed) {
      const Session session = test::simulatedSession(test::skinOptions("sheet:10x12", "cylinder:r=0.1", seed), 4, 10);
      const auto result = reconstruct(*session.snapshot(), test::by(solver));
      for (const Finding& finding : result->findings) {
        EXPECT_TRUE(finding.code == FindingCode::WrongNorm || finding.severity == Severity::Info)
            << finding.message << ", " << solverName(solver) << ", seed " << seed;
      }
    }
  }
}

}  // namespace
}  // namespace hexoderm
