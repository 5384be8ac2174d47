#include "hexoderm/solve/metrics/overlays.h"

#include "tests/support/hand_made_skins.h"
#include "tests/support/matchers.h"

namespace hexoderm {
namespace {

const SE3 kBody{expSO3({0.4, -1.1, 0.7}), {0.3, -0.2, 0.5}};

/// The demo's own placements, as a body frame elsewhere sees them.
GroundTruth truthOf(const Reconstruction& reconstruction) {
  GroundTruth truth;
  for (const PatchReconstruction& patch : reconstruction.patches) {
    for (const CellPlacement& cell : patch.cells) truth.cells.push_back({cell.cell, kBody * cell.T_o_u});
  }
  return truth;
}

/// So many cells, each where the reconstruction has it.
void expectAligned(const std::vector<AlignedCell>& aligned, std::size_t count, const Reconstruction& reconstruction) {
  ASSERT_EQ(aligned.size(), count);
  for (const AlignedCell& cell : aligned) {
    EXPECT_THAT(cell.T_o_u, SE3Near(reconstruction.find(cell.cell).cell->T_o_u, 1e-9, 1e-9));
  }
}

TEST(AlignedTruth, OfAPerfectReconstructionLiesOnIt) {
  const Reconstruction demo = demoReconstruction();
  GroundTruth truth = truthOf(demo);
  truth.cells.erase(truth.cells.begin() + 3);  // cell 4
  const std::vector<AlignedCell> aligned = alignTruth(demo, truth);
  expectAligned(aligned, 16, demo);
  for (const AlignedCell& cell : aligned) {
    EXPECT_NE(cell.cell, CellId(4));
    EXPECT_EQ(cell.patch, 0U);
  }
}

TEST(AlignedTruth, CentresOnALineTakeTheTurnFromTheOrientations) {
  const Reconstruction single = demoReconstruction({.arm_cells = 0});
  expectAligned(alignTruth(single, truthOf(single)), 1, single);
  const Reconstruction row = sheetReconstruction(6, 1);
  expectAligned(alignTruth(row, truthOf(row)), 6, row);
}

TEST(AlignedTruth, IsMovedPatchByPatch) {
  const Reconstruction two = demoPatches({DemoOptions(), {.first_id = 101}});
  GroundTruth truth = truthOf(two);
  for (std::size_t k = 17; k < 34; ++k) truth.cells[k].T_b_u = kBody * truth.cells[k].T_b_u;
  const std::vector<AlignedCell> aligned = alignTruth(two, truth);
  expectAligned(aligned, 34, two);
  EXPECT_EQ(aligned.at(20).patch, 1U);
}

TEST(CellShifts, LeadFromTheReferenceToTheCell) {
  const Reconstruction now = demoReconstruction();
  Reconstruction before = now;
  before.patches[0].cells[5].T_o_u.t += Eigen::Vector3d(0.001, 0.002, -0.003);
  for (CellPlacement& cell : before.patches[0].cells) cell.T_o_u = kBody * cell.T_o_u;
  const std::vector<Comparison> comparisons = compareToReconstruction(now, before);
  const std::vector<CellShift> shifts = shiftsOf(now, comparisons);
  ASSERT_EQ(shifts.size(), 17U);
  for (std::size_t k = 0; k < shifts.size(); ++k) {
    EXPECT_EQ(shifts[k].now_o, now.find(shifts[k].cell).cell->T_o_u.t);
    EXPECT_NEAR((shifts[k].before_o - shifts[k].now_o).norm(), comparisons[0].cells[k].position_m.norm(), 1e-12);
  }
  // The fit shares a sixteenth of the moved cell's shift with the others; its direction is kept.
  const Eigen::Vector3d moved = shifts[5].before_o - shifts[5].now_o;
  EXPECT_LT(angleBetween(moved, Eigen::Vector3d(0.001, 0.002, -0.003)), 10 * kDegree);

  Reconstruction other = now;
  other.patches[0].id = PatchId(7);
  EXPECT_TRUE(shiftsOf(other, comparisons).empty());
}

TEST(Enlargement, IsTheLargestRoundFactorThatFits) {
  EXPECT_EQ(enlargement(0.001, 0.012), 10);
  EXPECT_EQ(enlargement(0.001, 0.0049), 2);
  EXPECT_EQ(enlargement(0.001, 0.005), 5);
  EXPECT_EQ(enlargement(0.02, 0.01), 1) << "nothing is made smaller than it is";
  EXPECT_EQ(enlargement(0, 0.01), 1000) << "nothing to see at any size";
}

}  // namespace
}  // namespace hexoderm
