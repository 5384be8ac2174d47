#include "hexoderm/capture/skin_check.h"

#include "hexoderm/skin/built_in_models.h"
#include "hexoderm/solve/reconstructor.h"
#include "tests/support/simulated_skins.h"
#include "tests/support/testing.h"

namespace hexoderm {
namespace {

using testing::Field;

std::shared_ptr<const Reconstruction> x17() {
  return reconstruct(*beginSimulatedSession(test::simulatedSkin()).snapshot());
}

/// An item whose message matches.
template <class T>
auto says(const T& matcher) {
  return Field(&SkinCheckItem::message, testing::Property(&Message::english, matcher));
}

std::vector<CellSample> readingsOf(const Reconstruction& reconstruction) {
  std::vector<CellSample> readings;
  for (const CellPlacement& cell : reconstruction.patches.front().cells) {
    readings.push_back({cell.cell, Eigen::Vector3d(0, 0.6, 0.8)});
  }
  return readings;
}

TEST(SkinCheck, AHealthySkinIsReadyAndSaysWhatItReads) {
  const auto skin = x17();
  const SkinCheck check = checkSkin(*skin, readingsOf(*skin), {});
  EXPECT_TRUE(check.ready);
  EXPECT_EQ(check.because.english(), "Every cell sends");
  EXPECT_THAT(check.items, SizeIs(3));
  EXPECT_THAT(check.items, Contains(says("All 17 cells send and read 1.00 to 1.00 g")));
  for (const SkinCheckItem& item : check.items) EXPECT_EQ(item.severity, Severity::Info) << item.message.english();
}

TEST(SkinCheck, NamesCellsThatReadNoGravityOrSendNothing) {
  const auto skin = x17();
  std::vector<CellSample> readings = readingsOf(*skin);
  readings[6].acceleration_g *= 0.5;
  readings.pop_back();
  const SkinCheck check = checkSkin(*skin, readings, {});
  EXPECT_TRUE(check.ready) << "one pose more or less of a cell is no reason to stop";
  EXPECT_EQ(check.because.english(), "16 of 17 cells send");
  EXPECT_THAT(check.items, Contains(says(HasSubstr("Cell 7 reads 0.50 g"))));
  EXPECT_THAT(check.items, Contains(says("Nothing comes from cell 17")));
}

TEST(SkinCheck, ADeviceThatSendsAnotherUnitIsOneSentenceAndNotOneForEachCell) {
  const auto skin = x17();
  std::vector<CellSample> readings = readingsOf(*skin);
  for (CellSample& reading : readings) reading.acceleration_g *= 9.81;
  const SkinCheck check = checkSkin(*skin, readings, {});
  ASSERT_THAT(check.items, SizeIs(4));
  EXPECT_THAT(check.items[2].message.english(), HasSubstr("17 cells read 9.81 to 9.81 g: gravity is 1 g"));
  EXPECT_EQ(check.items[2].severity, Severity::Warning);
  EXPECT_THAT(check.items[2].cells, SizeIs(17));
  EXPECT_EQ(check.items[3].message.english(), "All 17 cells send");
}

TEST(SkinCheck, RepeatsWhatTheDetectorComplainsAbout) {
  const auto skin = x17();
  const std::vector<OddCell> odd = {{CellId(3), OddCellKind::Noisy, 0.22}, {CellId(4), OddCellKind::Silent, 2}};
  const SkinCheck check = checkSkin(*skin, readingsOf(*skin), odd);
  EXPECT_THAT(check.items, Contains(Field(&SkinCheckItem::message, describe(odd[0]))));
  EXPECT_THAT(check.items, SizeIs(4));
}

TEST(SkinCheck, WithoutReadingsOrCellsItIsNotReadyAndSaysWhy) {
  const auto skin = x17();
  EXPECT_FALSE(checkSkin(*skin, {}, {}).ready);
  EXPECT_EQ(checkSkin(*skin, {}, {}).because.english(), "No readings have come yet");
  const auto empty = reconstruct(*Session(builtInCellModel("hex-bma150"), {}).snapshot());
  EXPECT_FALSE(checkSkin(*empty, {}, {}).ready);
  EXPECT_EQ(checkSkin(*empty, {}, {}).because.english(), "The skin has no cells");
}

}  // namespace
}  // namespace hexoderm
