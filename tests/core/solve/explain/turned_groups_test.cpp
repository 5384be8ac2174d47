#include "hexoderm/base/units.h"
#include "hexoderm/solve/hold_out.h"
#include "hexoderm/solve/reconstructor.h"
#include "tests/support/changed_session.h"
#include "tests/support/matchers.h"
#include "tests/support/simulated_skins.h"
#include "tests/support/testing.h"

#include <set>

namespace hexoderm {
namespace {

struct TurnedCase {
  const char* name;
  const char* surface;
  std::uint32_t first;  ///< of the cells that are turned
  std::uint32_t last;
  Eigen::Matrix3d turn;
};

Eigen::Matrix3d turned(const Eigen::Vector3d& axis, double degrees) { return expSO3(axis * degrees * kDegree); }
Eigen::Matrix3d mirrored(int axis) {
  Eigen::Matrix3d M = Eigen::Matrix3d::Identity();
  M(axis, axis) = -1;
  return M;
}

Session withTurned(const Session& session, const std::set<CellId>& cells, const Eigen::Matrix3d& turn) {
  return changed(session, [&](std::size_t /*pose*/, GravitySample& sample) {
    if (cells.contains(sample.cell)) sample.mean_g = (turn * sample.mean_g).eval();
  });
}

class TurnedGroup : public ::testing::TestWithParam<TurnedCase> {};

INSTANTIATE_TEST_SUITE_P(
    Turns, TurnedGroup,
    ::testing::Values(TurnedCase{"TwoCellsAboutY", "cylinder:r=0.08", 7, 8, turned(Eigen::Vector3d::UnitY(), 180)},
                      TurnedCase{"ThirdAboutX", "sphere:r=0.12", 1, 8, turned(Eigen::Vector3d::UnitX(), 90)},
                      TurnedCase{"HalfAboutZ", "cylinder:r=0.08", 14, 25, turned(Eigen::Vector3d::UnitZ(), 180)},
                      TurnedCase{"HalfReflected", "torus:R=0.2,r=0.08", 1, 12, mirrored(1)}),
    [](const auto& test) { return test.param.name; });

TEST_P(TurnedGroup, IsOneFindingAndItsReadingsAreTurnedBack) {
  const TurnedCase& turned = GetParam();
  std::set<CellId> cells;
  for (std::uint32_t id = turned.first; id <= turned.last; ++id) cells.insert(CellId(id));
  for (const std::uint64_t seed : {1U, 2U}) {
    SCOPED_TRACE(seed);
    const Session fine = test::simulatedSession(test::skinOptions("sheet:5x5", turned.surface, seed), 4);
    const Session session = withTurned(fine, cells, turned.turn);
    const auto result = reconstruct(*session.snapshot());
    ASSERT_THAT(result->findings, ElementsAre(Field(&Finding::code, FindingCode::TurnedGroup)));
    EXPECT_THAT(result->findings[0].cells, ::testing::ElementsAreArray(cells));
    const auto of_fine = reconstruct(*fine.snapshot());
    for (const CellPlacement& cell : of_fine->patches.at(0).cells) {
      const CellPlacement& found = *result->find(cell.cell).cell;
      EXPECT_EQ(found.placed_by, PlacedBy::Samples);
      EXPECT_LT(rotationAngle(found.T_o_u.R.transpose() * cell.T_o_u.R), 2 * kDegree) << cell.cell;
    }
    const HoldOutResult held_out = evaluateHoldOut(*session.snapshot(), PoseId(1));
    EXPECT_EQ(held_out.cells.size(), 25 - cells.size()) << "what was turned back is not foretold";
    EXPECT_NE(held_out.agreement, HoldOutAgreement::FarWorse);
  }
}

/// A flat sheet, half of which is turned about z: either half may be.
TEST(TurnedGroups, SayThatItIsOpenWhichHalfIsTurned) {
  const Session fine = test::simulatedSession(test::skinOptions("sheet:4x4", "plane"), 4);
  std::set<CellId> half;
  for (std::uint32_t id = 1; id <= 8; ++id) half.insert(CellId(id));
  const auto result = reconstruct(*withTurned(fine, half, turned(Eigen::Vector3d::UnitZ(), 180)).snapshot());
  ASSERT_THAT(result->findings, ElementsAre(Field(&Finding::code, FindingCode::TurnedGroup)));
  EXPECT_EQ(result->findings[0].severity, Severity::Error);
}

TEST(TurnedGroups, LeaveASingleCellToOthers) {
  const Session fine = test::simulatedSession(test::skinOptions("sheet:5x5", "cylinder:r=0.08"), 4);
  const auto result = reconstruct(*withTurned(fine, {CellId(8)}, turned(Eigen::Vector3d::UnitY(), 180)).snapshot());
  EXPECT_THAT(result->findings, Each(Field(&Finding::code, ::testing::Ne(FindingCode::TurnedGroup))));
  EXPECT_THAT(result->findings, Each(Field(&Finding::cells, Contains(CellId(8)))));
}

}  // namespace
}  // namespace hexoderm
