// Which findings are pointed out in the 3D view, and where.

#include "widgets/patch/found_places.h"

#include <gmock/gmock.h>

namespace hexoderm {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

constexpr std::size_t kMany = 100;

Finding atCell(FindingCode code, std::uint32_t cell) { return makeFinding(code, {}, {CellId(cell)}); }

Finding atLink(FindingCode code, LinkEnd a, LinkEnd b) {
  return makeFinding(code, {}, {a.cell, b.cell}, {a.port, b.port});
}

FoundPlace cellPlace(std::uint32_t cell, Severity severity) { return {{CellId(cell), std::nullopt}, severity}; }

const LinkEnd kThree{CellId(3), PortNumber(1)};
const LinkEnd kFour{CellId(4), PortNumber(2)};
const FoundPlace kLinkPlace{{std::nullopt, std::pair(kThree, kFour)}, Severity::Warning};

TEST(FoundPlaces, ErrorsComeFirst) {
  const std::vector<Finding> findings = {atCell(FindingCode::NoisySensor, 2),
                                         atLink(FindingCode::LinkDoesNotClose, kThree, kFour),
                                         atCell(FindingCode::DeadSensor, 9), atCell(FindingCode::DeadAxis, 7)};
  EXPECT_THAT(foundPlaces(findings, kMany), ElementsAre(cellPlace(9, Severity::Error), cellPlace(7, Severity::Error),
                                                        cellPlace(2, Severity::Warning), kLinkPlace));
  EXPECT_THAT(foundPlaces(findings, 2), ElementsAre(cellPlace(9, Severity::Error), cellPlace(7, Severity::Error)));
}

TEST(FoundPlaces, ACellIsThereOnceWithTheWorstThatWasFound) {
  EXPECT_THAT(foundPlaces(std::vector{atCell(FindingCode::NoisySensor, 5), atCell(FindingCode::DeadSensor, 5)}, kMany),
              ElementsAre(cellPlace(5, Severity::Error)));
}

TEST(FoundPlaces, ALinkThatFollowsFromItsCellIsNotThere) {
  EXPECT_THAT(
      foundPlaces(std::vector{atLink(FindingCode::LinkDoesNotClose, kThree, kFour), atCell(FindingCode::DeadSensor, 4)},
                  kMany),
      ElementsAre(cellPlace(4, Severity::Error)));
}

TEST(FoundPlaces, ALinkIsThereOnceFromWhicheverEnd) {
  EXPECT_THAT(foundPlaces(std::vector{atLink(FindingCode::LinkDoesNotClose, kThree, kFour),
                                      atLink(FindingCode::LinkNotRigid, kFour, kThree)},
                          kMany),
              ElementsAre(kLinkPlace));
}

TEST(FoundPlaces, BothOfTwoCellsThatWereTakenForEachOtherAreThere) {
  EXPECT_THAT(foundPlaces(std::vector{makeFinding(FindingCode::SwappedReadings, {}, {CellId(2), CellId(3)})}, kMany),
              ElementsAre(cellPlace(2, Severity::Error), cellPlace(3, Severity::Error)));
}

TEST(FoundPlaces, NotesAndWhatIsFoundOfTheWholeSkinAreNot) {
  EXPECT_THAT(
      foundPlaces(std::vector{atCell(FindingCode::MissingSamples, 1),
                              makeFinding(FindingCode::SensorsUnlikeModel, {}, {CellId(1), CellId(2), CellId(3)}),
                              makeFinding(FindingCode::TooFewDirections, {})},
                  kMany),
      IsEmpty());
}

}  // namespace
}  // namespace hexoderm
