#include "tests/app/window/presenters/presenter_test.h"
#include "widgets/patch/patch_controls.h"
#include "widgets/patch/patch_legend_view.h"
#include "widgets/patch/patch_view.h"

namespace hexoderm {
namespace {

class ColoringPresenterTest : public PresenterTest {
 protected:
  /// A session of the X17 in three poses, all links of which are of one class.
  void openSession() {
    const QString path = pathTo("one_class.hexo");
    ASSERT_NO_FATAL_FAILURE(openFile(QFile::exists(path) ? path : writeSession(path, 3)));
    ASSERT_TRUE(waitUntil([this] { return patch().isUpToDate(); }));
  }
  PatchView& patch() { return *window_->findChild<PatchView*>(); }
  StepPanel& steps() { return *window_->findChild<StepPanel*>(); }
  void choose(Coloring coloring) { window_->findChild<PatchControls*>()->action(coloring)->trigger(); }
  PatchLegendView& legend() { return *find<PatchLegendView>("patchLegend"); }
};

TEST_F(ColoringPresenterTest, ReviewShowsHowWellTheShapeIsKnownOnceTheClassIsTheSameEverywhere) {
  EXPECT_EQ(patch().coloring(), Coloring::LinkQuality) << "there is no skin yet";
  ASSERT_NO_FATAL_FAILURE(openSession());
  ASSERT_EQ(steps().openIndex(), static_cast<int>(GuideStep::Review));
  EXPECT_EQ(patch().coloring(), Coloring::ShapeUncertainty);
  openStep(GuideStep::Capture);
  EXPECT_EQ(patch().coloring(), Coloring::LinkQuality) << "while poses are taken, classes change";
  openStep(GuideStep::Verify);
  EXPECT_EQ(patch().coloring(), Coloring::ShapeUncertainty);
}

TEST_F(ColoringPresenterTest, AMomentThatSaysNothingOfUncertaintyIsColouredByTheLinks) {
  ASSERT_NO_FATAL_FAILURE(takeDemoPoses(3));
  openStep(GuideStep::Verify);
  ASSERT_EQ(patch().coloring(), Coloring::ShapeUncertainty);
  window_->controller().liveMode().setOn(true);
  EXPECT_EQ(patch().coloring(), Coloring::LinkQuality);
  window_->controller().liveMode().setOn(false);
  EXPECT_EQ(patch().coloring(), Coloring::ShapeUncertainty);
}

TEST_F(ColoringPresenterTest, WhatTheOperatorChoosesStands) {
  ASSERT_NO_FATAL_FAILURE(openSession());
  choose(Coloring::Residual);
  openStep(GuideStep::Capture);
  openStep(GuideStep::Review);
  EXPECT_EQ(patch().coloring(), Coloring::Residual);
  ASSERT_NO_FATAL_FAILURE(openFile(writeSession(pathTo("another.hexo"), 4)));
  EXPECT_EQ(patch().coloring(), Coloring::Residual);
}

TEST_F(ColoringPresenterTest, AFixedRangeStaysWithOtherResultsAndStartsUntilItIsReleased) {
  ASSERT_NO_FATAL_FAILURE(openSession());
  choose(Coloring::PositionUncertainty);
  EXPECT_THAT(legend().accessibleDescription(), HasText("range fitted"));
  emit legend().rangeFixed({0, 5});
  EXPECT_TRUE(legend().accessibleDescription().contains("range fixed"));
  ASSERT_NO_FATAL_FAILURE(openFile(writeSession(pathTo("another.hexo"), 4)));
  EXPECT_THAT(legend().accessibleDescription(), HasText("from 0.00 to 5.00 mm, range fixed"));
  reopenWindow();
  ASSERT_NO_FATAL_FAILURE(openSession());
  choose(Coloring::PositionUncertainty);
  EXPECT_THAT(legend().accessibleDescription(), HasText("from 0.00 to 5.00 mm, range fixed"));
  window_->preferences().restoreDefaults();
  EXPECT_TRUE(legend().accessibleDescription().contains("range fitted"));
  emit legend().rangeFixed({0, 5});
  emit legend().rangeReleased();
  reopenWindow();
  ASSERT_NO_FATAL_FAILURE(openSession());
  choose(Coloring::PositionUncertainty);
  EXPECT_TRUE(legend().accessibleDescription().contains("range fitted"));
}

TEST_F(ColoringPresenterTest, SettingsThatMakeNoSenseFixNothing) {
  window_.reset();
  QSettings().setValue("colours/position_uncertainty", QStringList{"5", "x"});
  QSettings().setValue("colours/residual", QStringList{"3", "1"});
  openWindow();
  ASSERT_NO_FATAL_FAILURE(openSession());
  for (const Coloring coloring : {Coloring::PositionUncertainty, Coloring::Residual}) {
    choose(coloring);
    EXPECT_TRUE(legend().accessibleDescription().contains("range fitted"));
  }
}

}  // namespace
}  // namespace hexoderm
