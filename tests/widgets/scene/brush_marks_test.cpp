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

}  // namespace
}  // namespace hexoderm
