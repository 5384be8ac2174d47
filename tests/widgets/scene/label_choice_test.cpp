// Which cells have their IDs written on them, without drawing any.
#include "widgets/scene/label_choice.h"

#include "tests/support/hand_made_skins.h"

#include <gmock/gmock.h>
#include <map>
#include <set>

namespace hexoderm {
namespace {

constexpr std::array kWindow = {800, 600};

std::shared_ptr<const SceneContent> contentOf(Reconstruction skin) { return makeSceneContent(shared(std::move(skin))); }

/// Looks at `target` from this direction, with letters of so many pixels where it is (at 72 dpi).
SceneSight looking(const SceneContent& content, const Eigen::Vector3d& target, const Eigen::Vector3d& from,
                   double letters_px) {
  SceneSight sight;
  sight.window = kWindow;
  sight.middle_px = {0.5 * kWindow[0], 0.5 * kWindow[1]};
  sight.back = from.normalized();
  sight.right = sight.back.unitOrthogonal();
  sight.up = sight.back.cross(sight.right);
  sight.parallel = true;
  const double distance_m = 1;
  sight.eye = target + distance_m * sight.back;
  sight.pixels_per_m = letters_px / (0.52 * content.reconstruction->model->side_m);
  return sight;
}

class LabelChoiceTest : public testing::Test {
 protected:
  std::vector<CellId> chosen(const SceneSight& sight, const std::optional<SceneCut>& cut = std::nullopt) {
    std::vector<CellId> ids;
    for (const PlacedLabel& label : choice.choose(sight, cut)) {
      ids.push_back(choice.content()->layout.cells[label.cell].id);
    }
    return ids;
  }
  void show(Reconstruction skin) {
    content = contentOf(std::move(skin));
    choice.setContent(content);
  }
  [[nodiscard]] Eigen::Vector3d middle() const { return content->layout.boxes[0].center(); }

  LabelChoice choice;
  std::shared_ptr<const SceneContent> content;
};

TEST_F(LabelChoiceTest, EveryCellOfASmallSkinThatIsLargeEnoughHasItsId) {
  show(sheetReconstruction(6, 5));
  EXPECT_EQ(chosen(looking(*content, middle(), Eigen::Vector3d::UnitZ(), 14)).size(), 30U);
  EXPECT_TRUE(chosen(looking(*content, middle(), Eigen::Vector3d::UnitZ(), 4)).empty()) << "too small to be read";
}

TEST_F(LabelChoiceTest, ALongIdNeedsALargerCell) {
  DemoOptions lonely;
  lonely.arm_cells = 0;
  lonely.first_id = 123456789;
  show(demoReconstruction(lonely));
  EXPECT_TRUE(chosen(looking(*content, middle(), Eigen::Vector3d::UnitZ(), 8)).empty());
  const auto& labels = choice.choose(looking(*content, middle(), Eigen::Vector3d::UnitZ(), 16), {});
  ASSERT_EQ(labels.size(), 1U);
  EXPECT_LT(labels.front().font_px, 16);
}

TEST_F(LabelChoiceTest, OnlyFacesThatLookAtTheViewerHaveIds) {
  show(cylinderSheet(60, 40));
  const SceneSight sight = looking(*content, middle(), Eigen::Vector3d::UnitZ(), 6);
  const auto ids = chosen(sight);
  ASSERT_FALSE(ids.empty());
  for (const CellId id : ids) {
    EXPECT_GT(content->layout.find(id)->T_s_u.R.col(2).dot(sight.back), LabelChoice::kMinFacing) << "cell " << id;
  }
}

TEST_F(LabelChoiceTest, WhereTwoWouldCoverEachOtherTheRounderNumberStands) {
  Reconstruction skin = sheetReconstruction(6, 5);
  for (CellPlacement& cell : skin.patches[0].cells) {  // 7 and 10 in one place, the others far away
    if (cell.cell == CellId(7) || cell.cell == CellId(10)) cell.T_o_u.t.setZero();
  }
  show(skin);
  const auto ids = chosen(looking(*content, Eigen::Vector3d::Zero(), Eigen::Vector3d::UnitZ(), 14));
  EXPECT_THAT(ids, testing::Contains(CellId(10)));
  EXPECT_THAT(ids, testing::Not(testing::Contains(CellId(7))));
}

TEST_F(LabelChoiceTest, NoTwoLabelsCoverEachOther) {
  show(cylinderSheet(60, 40));
  for (const double letters_px : {6.0, 9.0, 15.0}) {
    const auto labels = choice.choose(looking(*content, middle(), Eigen::Vector3d(0.4, 0.3, 1), letters_px), {});
    ASSERT_GT(labels.size(), 10U);
    for (std::size_t a = 0; a < labels.size(); ++a) {
      for (std::size_t b = 0; b < a; ++b) {
        const Eigen::Vector2d apart = (labels[a].at_px - labels[b].at_px).cwiseAbs();
        EXPECT_TRUE(apart.y() > 0.8 * labels[a].font_px - 1e-6 ||
                    apart.x() > LabelChoice::kDigitAdvance * labels[a].font_px - 1e-6)
            << "labels " << a << " and " << b;
      }
    }
  }
}

TEST_F(LabelChoiceTest, ThereAreNoMoreThanABudgetAndRoundNumbersComeFirst) {
  show(sheetReconstruction(100, 100));
  SceneSight sight = looking(*content, middle(), Eigen::Vector3d::UnitZ(), 6);
  sight.window = {3000, 3000};
  sight.middle_px = {1500, 1500};
  const auto ids = chosen(sight);
  EXPECT_EQ(ids.size(), LabelChoice::kMax);
  // 10,000 cells have 100 round hundreds and as many fifties: all of them that are in the picture.
  EXPECT_THAT(ids, testing::Contains(CellId(5000)));
  EXPECT_TRUE(std::ranges::all_of(ids, [](CellId id) { return id.value() % 10 == 0; }));
}

TEST_F(LabelChoiceTest, WhatACutRemovesHasNoId) {
  show(sheetReconstruction(6, 5));
  SceneCut cut;
  cut.normal = Eigen::Vector3d::UnitX();
  cut.offset_m = middle().x();
  const auto ids = chosen(looking(*content, middle(), Eigen::Vector3d::UnitZ(), 14), cut);
  EXPECT_FALSE(ids.empty());
  EXPECT_LT(ids.size(), 30U);
  for (const CellId id : ids) EXPECT_LE(content->layout.find(id)->T_s_u.t.x(), cut.offset_m) << "cell " << id;
}

TEST_F(LabelChoiceTest, WhileTheSkinTurnsOnceAnIdComesAndGoesButOnceOrTwice) {
  show(cylinderSheet(60, 12));
  std::set<CellId> before;
  std::map<CellId, int> changes;
  constexpr int kSteps = 720;
  for (int step = 0; step <= kSteps; ++step) {
    const double angle = 2 * kPi * step / kSteps;
    SceneSight sight = looking(*content, middle(), Eigen::Vector3d(std::sin(angle), 0, std::cos(angle)), 12);
    sight.up = Eigen::Vector3d::UnitY();
    sight.right = sight.up.cross(sight.back);
    const auto ids = chosen(sight);
    const std::set<CellId> now(ids.begin(), ids.end());
    if (step > 0) {
      for (const SceneCell& cell : content->layout.cells)
        changes[cell.id] += now.contains(cell.id) != before.contains(cell.id);
    }
    before = now;
  }
  for (const auto& [cell, count] : changes) EXPECT_LE(count, 4) << "the ID of cell " << cell << " flickers";
  EXPECT_TRUE(std::ranges::any_of(changes, [](const auto& change) { return change.second > 1; }));
}

}  // namespace
}  // namespace hexoderm
