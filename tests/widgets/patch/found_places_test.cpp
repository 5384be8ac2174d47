// Which findings are pointed out in the 3D view, and where.

#include "widgets/patch/found_places.h"

#include <gmock/gmock.h>

namespace hexoderm {
namespace {

using testing::ElementsAre;

constexpr std::size_t kMany = 100;

Finding atCell(FindingCode code, std::uint32_t cell) { return makeFinding(code, {}, {CellId(cell)}); }

Finding atLink(FindingCode code, LinkEnd a, LinkEnd b) {
  return makeFinding(code, {}, {a.cell, b.cell}, {a.port, b.port});
}

FoundPlace cellPlace(std::uint32_t cell, Severity severity) { return {{CellId(cell), std::nullopt}, severity}; }

const LinkEnd kThree{CellId(3), PortNumber(1)};
const LinkEnd kFour{CellId(4), PortNumber(2)};
const FoundPlace kLinkPlace{{std::nullopt, std::pair(kThree, kFour)}, Severity::Warning};

TEST(FoundPlaces, AreThoseOfErrorsAndWarningsOfACellOrALinkTheWorstFirst) {
  const Finding does_not_close = atLink(FindingCode::LinkDoesNotClose, kThree, kFour);
  const std::vector<Finding> mixed = {atCell(FindingCode::NoisySensor, 2), does_not_close,
                                      atCell(FindingCode::DeadSensor, 9), atCell(FindingCode::DeadAxis, 7)};
  const FoundPlace nine = cellPlace(9, Severity::Error);
  const FoundPlace seven = cellPlace(7, Severity::Error);
  EXPECT_THAT(foundPlaces(mixed, 2), ElementsAre(nine, seven));
  const struct {
    const char* name;
    std::vector<Finding> findings;
    std::vector<FoundPlace> places;
  } cases[] = {
      {"errors come first", mixed, {nine, seven, cellPlace(2, Severity::Warning), kLinkPlace}},
      {"a cell is there once, with the worst",
       {atCell(FindingCode::NoisySensor, 9), atCell(FindingCode::DeadSensor, 9)},
       {nine}},
      {"a link that follows from its cell",
       {does_not_close, atCell(FindingCode::DeadSensor, 4)},
       {cellPlace(4, Severity::Error)}},
      {"a link from both ends", {does_not_close, atLink(FindingCode::LinkNotRigid, kFour, kThree)}, {kLinkPlace}},
      {"two cells that were taken for each other",
       {makeFinding(FindingCode::SwappedReadings, {}, {CellId(7), CellId(9)})},
       {seven, nine}},
      {"notes, and what is found of the whole skin",
       {atCell(FindingCode::MissingSamples, 1), makeFinding(FindingCode::TooFewDirections, {}),
        makeFinding(FindingCode::SensorsUnlikeModel, {}, {CellId(1), CellId(2), CellId(3)})},
       {}},
  };
  for (const auto& [name, findings, places] : cases) EXPECT_EQ(foundPlaces(findings, kMany), places) << name;
}

}  // namespace
}  // namespace hexoderm
