#include "widgets/scene/brush_marks.h"

#include "tests/widgets/scene/patch_scene_test.h"

namespace hexoderm {
namespace {

TEST_F(PatchSceneTest, BrushedCellsCarryARingUntilTheyAreBrushedNoMore) {
  const Reconstruction demo = demoReconstruction(mixedQualities());
  scene.setReconstruction(shared(demo));
  const auto plain = picture();
  scene.setBrushed({CellId(1), CellId(2), CellId(3)});
  const auto three = picture();
  EXPECT_GT(differingShare(plain, three), kMaxDifferingShare);
  scene.setReconstruction(nullptr);
  scene.setReconstruction(shared(demo));
  EXPECT_LT(differingShare(three, picture()), differingShare(plain, three)) << "the next result is marked, too";
  scene.setBrushed({CellId(2)});
  const double one = differingShare(plain, picture());
  EXPECT_GT(one, 0);
  EXPECT_LT(one, differingShare(plain, three));
  scene.setBrushed({CellId(99)});
  EXPECT_EQ(differingShare(plain, picture()), 0) << "a cell that is not there";
  scene.setBrushed({});
  EXPECT_EQ(differingShare(plain, picture()), 0);
}

TEST(BrushMarks, ARingHasSixSidesAndLiesOnTheFace) {
  const auto content = makeSceneContent(shared(demoReconstruction()));
  const std::vector<Rgb> faces(content->layout.cells.size(), Rgb{0.1, 0.1, 0.1});
  const auto mesh = makeBrushMarks(*content, {CellId(2), CellId(99)}, faces, testColors(false));
  EXPECT_EQ(mesh->GetNumberOfPolys(), 6);
  const SceneCell* cell = content->layout.find(CellId(2));
  ASSERT_NE(cell, nullptr);
  const double side_m = content->reconstruction->model->side_m;
  for (vtkIdType k = 0; k < mesh->GetNumberOfPoints(); ++k) {
    const Eigen::Vector3d in_cell = cell->T_s_u.inverse() * Eigen::Vector3d(mesh->GetPoint(k));
    EXPECT_GT(in_cell.z(), 0) << "above the face";
    EXPECT_LT(in_cell.z(), 0.05 * side_m);
    EXPECT_LT(in_cell.head<2>().norm(), 0.75 * side_m) << "inside of the cell";
  }
}

}  // namespace
}  // namespace hexoderm
