#include "hexoderm/device/skinwire/description.h"

#include "hexoderm/device/skinwire/codec.h"
#include "tests/core/device/skinwire/wire_messages.h"
#include "tests/support/neighbor_lists.h"
#include "tests/support/testing.h"

namespace hexoderm::skinwire {
namespace {

TEST(TopologyParts, FitDatagramsAndComeTogetherInAnyOrder) {
  const NeighborList cells = test::listOfSheet(1, 500);
  std::vector<Topology> parts = topologyParts(cells, 9, kMaxDatagram);
  ASSERT_GT(parts.size(), 5U);
  for (const Topology& part : parts) EXPECT_LE(encodeBody(part).size(), kMaxDatagram);
  // The parts are full: the next cell would not have fitted.
  EXPECT_GT(encodeBody(parts[0]).size(), kMaxDatagram - 60);

  std::ranges::reverse(parts);
  TopologyAssembler assembler;
  for (std::size_t k = 0; k + 1 < parts.size(); ++k) {
    EXPECT_FALSE(assembler.add(parts[k]).has_value());
    EXPECT_FALSE(assembler.add(parts[k]).has_value()) << "twice";
  }
  const auto whole = assembler.add(parts.back());
  ASSERT_TRUE(whole.has_value());
  EXPECT_EQ(*whole, cells);
}

TEST(TopologyParts, OfAnEmptySkinAreOne) {
  const std::vector<Topology> parts = topologyParts({}, 1);
  ASSERT_EQ(parts.size(), 1U);
  TopologyAssembler assembler;
  const auto whole = assembler.add(parts[0]);
  ASSERT_TRUE(whole.has_value());
  EXPECT_TRUE(whole->empty());
}

TEST(TopologyParts, ACellTooLargeForAPartIsNamed) {
  const NeighborList cells = {{CellId(7), std::string(1000, 'x'), {}}};
  EXPECT_THAT(test::messageOf<InvalidArgument>([&] { topologyParts(cells, 1, 500); }), testing::HasSubstr("cell 7"));
}

TEST(TopologyAssembler, APartOfAnotherTopologyStartsAnew) {
  const std::vector<Topology> old_parts = topologyParts(test::listOfSheet(1, 200), 1, kMaxDatagram);
  const std::vector<Topology> new_parts = topologyParts(test::listOfSheet(1, 201), 2, kMaxDatagram);
  TopologyAssembler assembler;
  for (std::size_t k = 0; k + 1 < old_parts.size(); ++k) EXPECT_FALSE(assembler.add(old_parts[k]).has_value());
  std::optional<NeighborList> whole;
  for (const Topology& part : new_parts) whole = assembler.add(part);
  ASSERT_TRUE(whole.has_value());
  EXPECT_EQ(whole->size(), 201U);
}

TEST(TopologyAssembler, DoesNotGrowBeyondItsLimit) {
  TopologyAssembler assembler;
  const NeighborList many(kMaxCells / 2 + 1);
  EXPECT_FALSE(assembler.add({1, 0, 3, many}).has_value());
  EXPECT_FALSE(assembler.add({1, 1, 3, many}).has_value());
  EXPECT_FALSE(assembler.add({1, 2, 3, {}}).has_value());
}

TEST(Hello, CarriesBuiltInModelsByNameAndOthersWhole) {
  SkinDescription skin{hexoderm::Message::verbatim("arm"),
                       std::make_shared<const CellModel>(builtInCellModel("hex-bma150")),
                       {},
                       true,
                       false};
  EXPECT_EQ(helloOf(skin).cell_model, "hex-bma150");
  EXPECT_EQ(cellModelToJson(cellModelOf(helloOf(skin))), cellModelToJson(*skin.model));
  CellModel own = *skin.model;
  own.gap_m *= 2;
  skin.model = std::make_shared<const CellModel>(own);
  EXPECT_EQ(cellModelToJson(cellModelOf(helloOf(skin))), cellModelToJson(own));
}

TEST(Hello, OpensNoFilesForTheDevice) {
  EXPECT_THROW(cellModelOf(helloWith(&Hello::cell_model, "/etc/passwd")), InvalidArgument);
  EXPECT_THROW(cellModelOf(helloWith(&Hello::cell_model, "{\"name\": 3}")), FormatError);
}

}  // namespace
}  // namespace hexoderm::skinwire
