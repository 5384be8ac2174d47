#include "hexoderm/device/topology_check.h"

#include "tests/support/testing.h"

namespace hexoderm {
namespace {

const CellModel kModel = builtInCellModel("hex-bma150");

NeighborReport toCell(std::uint32_t port, std::uint32_t cell, std::uint32_t cell_port) {
  return {PortNumber(port), CellId(cell), PortNumber(cell_port)};
}

TEST(TopologyCheck, TakesAWholeTopologyWithItsInterface) {
  const NeighborList neighbors = {
      {CellId(1), "arm", {toCell(1, 2, 3), {PortNumber(2), CellId(16383), {}}, {PortNumber(3), CellId(0), {}}}},
      {CellId(2), "hand", {toCell(3, 1, 1)}}};
  EXPECT_THAT(offencesOf(kModel, neighbors), IsEmpty());
}

TEST(TopologyCheck, NamesEachFaultAndWhatIsExpected) {
  const NeighborList neighbors = {
      {CellId(0), "", {}}, {CellId(1), "", {toCell(1, 2, 3), toCell(9, 2, 4)}}, {CellId(2), "", {}}};
  const std::vector<ProtocolViolation> offences = offencesOf(kModel, neighbors);
  ASSERT_EQ(offences.size(), 3U);
  EXPECT_EQ(offences[0].kind, ProtocolViolationKind::CellIdZero);
  EXPECT_THAT(offences[0].reason.english(), HasSubstr("Expected: IDs of cells begin with 1"));
  EXPECT_EQ(offences[1].kind, ProtocolViolationKind::UnknownPort);
  EXPECT_THAT(offences[1].reason.english(), HasSubstr("Expected: the model's ports are 1, 2, 3 and 4"));
  EXPECT_EQ(offences[2].kind, ProtocolViolationKind::OneSidedLink);
  ASSERT_EQ(offencesOf(kModel, {}).size(), 1U);
  EXPECT_EQ(offencesOf(kModel, {})[0].kind, ProtocolViolationKind::NoCells);
}

}  // namespace
}  // namespace hexoderm
