#include "hexoderm/skin/skin_graph.h"

#include "tests/support/options.h"
#include "tests/support/testing.h"

namespace hexoderm {
namespace {

const CellModel& model() {
  static const CellModel kModel = builtInCellModel("hex-bma150");
  return kModel;
}

NeighborReport to(std::uint32_t port, std::uint32_t cell, std::uint32_t cell_port) {
  return {PortNumber(port), CellId(cell), PortNumber(cell_port)};
}
NeighborReport to(std::uint32_t port, std::uint32_t cell) { return {PortNumber(port), CellId(cell), std::nullopt}; }
CellReport cell(std::uint32_t id, std::vector<NeighborReport> neighbors, std::string body_part = "") {
  return {CellId(id), std::move(body_part), std::move(neighbors)};
}

std::vector<FindingCode> codes(const SkinGraph& graph) { return collect(graph.findings(), &Finding::code); }

std::size_t usedLinks(const SkinGraph& graph) {
  return static_cast<std::size_t>(std::ranges::count(graph.links(), false, &GraphLink::muted));
}

/// 1 - 2 - 3 in a line, ports 1 -> 4.
NeighborList line() { return {cell(1, {to(1, 2, 4)}), cell(2, {to(4, 1, 1), to(1, 3, 4)}), cell(3, {to(4, 2, 1)})}; }

TEST(SkinGraph, ALinkReportedByBothSidesIsOneLinkWithTheSmallerEndAsSource) {
  const SkinGraph graph(model(), line());
  EXPECT_THAT(graph.findings(), IsEmpty());
  ASSERT_THAT(graph.links(), SizeIs(2));
  EXPECT_EQ(graph.sourceEnd(graph.links()[0]), (LinkEnd{CellId(1), PortNumber(1)}));
  EXPECT_EQ(graph.targetEnd(graph.links()[0]), (LinkEnd{CellId(2), PortNumber(4)}));
  EXPECT_THAT(graph.linksAt(1), ElementsAre(0, 1));
  EXPECT_THAT(graph.patches(), ElementsAre(ElementsAre(0, 1, 2)));
}

TEST(SkinGraph, PatchesAreNumberedByTheirSmallestCell) {
  const SkinGraph graph(model(), {cell(9, {to(1, 4, 4)}), cell(4, {to(4, 9, 1)}), cell(7, {to(1, 2, 4)}),
                                  cell(2, {to(4, 7, 1)}), cell(30, {})});
  ASSERT_THAT(graph.patches(), SizeIs(3));
  EXPECT_EQ(graph.cells()[*graph.indexOf(CellId(7))].patch, PatchId(0));
  EXPECT_EQ(graph.cells()[*graph.indexOf(CellId(9))].patch, PatchId(1));
  EXPECT_EQ(graph.cells()[*graph.indexOf(CellId(30))].patch, PatchId(2));
}

TEST(SkinGraph, MissingPortsAreCompletedFromTheOtherSide) {
  const SkinGraph graph(model(), {cell(1, {to(1, 2)}), cell(2, {to(4, 1)})});
  EXPECT_THAT(graph.findings(), IsEmpty());
  ASSERT_THAT(graph.links(), SizeIs(1));
  EXPECT_EQ(graph.links()[0].target_port, PortNumber(4));
}

TEST(SkinGraph, TwoLinksWithoutPortsBetweenTheSameCellsCannotBeToldApart) {
  const SkinGraph graph(model(), {cell(1, {to(1, 2), to(2, 2)}), cell(2, {to(4, 1), to(3, 1)})});
  EXPECT_EQ(usedLinks(graph), 0);
  EXPECT_THAT(codes(graph), ::testing::Each(FindingCode::ContradictoryLink));
  EXPECT_FALSE(graph.findings().empty());
}

TEST(SkinGraph, OneSidedLinkIsMutedAndNamesCellsAndPorts) {
  NeighborList neighbors = line();
  neighbors[2].neighbors.clear();
  const SkinGraph graph(model(), neighbors);
  ASSERT_THAT(codes(graph), ElementsAre(FindingCode::OneSidedLink));
  EXPECT_THAT(graph.findings()[0].cells, ElementsAre(CellId(2), CellId(3)));
  EXPECT_THAT(graph.findings()[0].ports, ElementsAre(PortNumber(1), PortNumber(4)));
  EXPECT_EQ(usedLinks(graph), 1);
  EXPECT_THAT(graph.links(), SizeIs(2)) << "the muted link is kept to be shown";
  EXPECT_THAT(graph.patches(), SizeIs(2));
}

TEST(SkinGraph, ContradictoryPortsMuteBothReports) {
  // 1 says its port 1 meets port 4 of 2; 2 says its port 4 meets port 2 of 1.
  const SkinGraph graph(model(), {cell(1, {to(1, 2, 4)}), cell(2, {to(4, 1, 2)})});
  EXPECT_EQ(usedLinks(graph), 0);
  EXPECT_THAT(codes(graph), ::testing::Contains(FindingCode::ContradictoryLink));
  EXPECT_THAT(graph.patches(), SizeIs(2));
}

TEST(SkinGraph, APortThatMeetsTwoCellsIsUsedForNeither) {
  const SkinGraph graph(model(), {cell(1, {to(1, 2, 4), to(1, 3, 4)}), cell(2, {to(4, 1, 1)}), cell(3, {to(4, 1, 1)})});
  EXPECT_EQ(usedLinks(graph), 0);
  EXPECT_EQ(std::ranges::count(codes(graph), FindingCode::ContradictoryLink), 1);
}

TEST(SkinGraph, SelfUnknownPortUnknownCellAndZeroAreFindings) {
  const SkinGraph graph(
      model(), {cell(1, {to(1, 1, 4), to(9, 2, 4), to(2, 50, 3), to(3, 0), to(4, 2, 8)}), cell(2, {}), cell(0, {})});
  EXPECT_THAT(codes(graph),
              UnorderedElementsAre(FindingCode::SelfLink, FindingCode::UnknownPort, FindingCode::UnknownPort,
                                   FindingCode::UnknownCell, FindingCode::ReservedCellId));
  EXPECT_THAT(graph.links(), IsEmpty());
  EXPECT_THAT(graph.cells(), SizeIs(2));
}

TEST(SkinGraph, InterfacesAreNoCells) {
  const SkinGraph graph(model(), {cell(1, {to(1, 16383, 1)}), cell(16383, {to(1, 1, 1)})});
  EXPECT_THAT(graph.cells(), SizeIs(1));
  ASSERT_THAT(codes(graph), ElementsAre(FindingCode::InterfaceLink));
  EXPECT_EQ(graph.findings()[0].severity, Severity::Info);
}

TEST(SkinGraph, WhatIsReportedTwiceOrByOneSideIsNamedOnce) {
  NeighborList cell_twice = line();
  cell_twice.push_back(cell(2, {to(2, 3, 3)}));
  NeighborList report_twice = line();
  report_twice[0].neighbors.push_back(report_twice[0].neighbors.front());
  const NeighborList joined_twice = {cell(1, {to(1, 2, 4), to(2, 2, 3)}), cell(2, {to(4, 1, 1), to(3, 1, 2)})};
  const NeighborList without_port = {cell(1, {to(1, 2)}), cell(2, {})};
  for (const auto& [neighbors, code, used] : {std::tuple(cell_twice, FindingCode::DuplicateCell, 2U),
                                              std::tuple(report_twice, FindingCode::DuplicateLink, 2U),
                                              std::tuple(joined_twice, FindingCode::DuplicateLink, 0U),
                                              std::tuple(without_port, FindingCode::OneSidedLink, 0U)}) {
    const SkinGraph graph(model(), neighbors);
    EXPECT_THAT(codes(graph), ElementsAre(code));
    EXPECT_EQ(usedLinks(graph), used);
  }
  EXPECT_THAT(SkinGraph(model(), without_port).links(), IsEmpty());
}

TEST(SkinGraph, ForbiddenPortPairsAreMuted) {
  const CellModel strict = test::with(model(), &CellModel::forbidden_port_pairs, {{PortNumber(4), PortNumber(1)}});
  const SkinGraph graph(strict, line());
  EXPECT_EQ(codes(graph), (std::vector{FindingCode::ForbiddenPortPair, FindingCode::ForbiddenPortPair}));
  EXPECT_EQ(usedLinks(graph), 0);
}

TEST(SkinGraph, BodyPartsEndAPatchOnlyWhereBothAreKnown) {
  NeighborList neighbors = line();
  neighbors[0].body_part = "arm";
  neighbors[1].body_part = "hand";
  const SkinGraph graph(model(), neighbors);
  EXPECT_THAT(codes(graph), ElementsAre(FindingCode::BodyPartBoundary));
  EXPECT_THAT(graph.patches(), ElementsAre(ElementsAre(0), ElementsAre(1, 2)));
}

}  // namespace
}  // namespace hexoderm
