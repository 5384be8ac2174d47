#include "app/window/presenters/result_presenter.h"

#include "tests/app/window/window_test.h"
#include "widgets/controls/view_mark.h"
#include "widgets/patch/patch_captions.h"
#include "widgets/words/words.h"

#include <utility>

namespace hexoderm {
namespace {

struct FakeView {
  std::shared_ptr<const Reconstruction> shown;
  void setReconstruction(std::shared_ptr<const Reconstruction> reconstruction) { shown = std::move(reconstruction); }
};

class ResultPresenterTest : public WindowTest {
 protected:
  FakeView picture_;
  FakeView table_;
};

TEST_F(ResultPresenterTest, OnlyPicturesShowTheMomentInLiveMode) {
  ASSERT_NO_FATAL_FAILURE(takeDemoPoses(1));
  ResultPresenter results(controller());
  results.addPicture(&picture_);
  results.add(&table_);
  controller().liveMode().setOn(true);
  ASSERT_TRUE(waitUntil([this] { return picture_.shown && picture_.shown != controller().reconstruction(); }));
  EXPECT_EQ(table_.shown, nullptr);
  controller().liveMode().setOn(false);
  EXPECT_EQ(picture_.shown, controller().reconstruction());
}

/// A skin whose result takes a moment.
class LargeSkinTest : public ResultPresenterTest {
 protected:
  /// Opens it, and calls `then` as soon as its cells are placed for the first time.
  void openLargeSkin(std::function<void()> then, const std::string& patch = "sheet:45x45") {
    SimulatedSkinOptions options;
    options.patch = patch;
    options.surface = "cylinder:r=0.35";
    const QString path = writeSession("large.hexo", simulated(2, options));
    results_.emplace(controller()).addPicture(&picture_);
    results_->add(&table_);
    // Its result comes with a later turn of the event loop.
    QObject::connect(&controller(), &SessionController::firstPlacementsChanged, window_.get(),
                     [this, then = std::move(then)] {
                       if (!std::exchange(is_placed_, true)) then();
                     });
    window_->openFile(path);
  }
  [[nodiscard]] QStringList marks() {
    window_->showChanges();
    QStringList marks;
    for (const ViewMark* mark : window_->findChildren<ViewMark*>()) {
      if (mark->content()) marks << mark->content()->words;
    }
    return marks;
  }

  std::optional<ResultPresenter> results_;
  bool is_placed_ = false;
};

TEST_F(LargeSkinTest, IsSeenAsSoonAsItsCellsArePlaced) {
  openLargeSkin([this] {
    ASSERT_NE(controller().firstPlacements(), nullptr);
    EXPECT_EQ(controller().firstPlacements()->cellCount(), 2025U);
    EXPECT_EQ(picture_.shown, controller().firstPlacements());
    EXPECT_EQ(table_.shown, nullptr) << "there is no result yet";
    EXPECT_EQ(controller().reconstruction(), nullptr);
    EXPECT_TRUE(marks().contains("preliminary: not fully checked yet, without uncertainty"));
    EXPECT_EQ(labelText("bannerSentence"), "2,025 cells are placed for now, and the result is being worked out…");
    // Every view can be asked for a cell that no result has yet.
    window_->selection().selectCell(CellId(7));
    window_->showChanges();
    EXPECT_TRUE(action("actionFit")->isEnabled());
    EXPECT_FALSE(action("actionExport")->isEnabled());
  });
  ASSERT_TRUE(waitForPoses(2));
  EXPECT_TRUE(is_placed_);
  EXPECT_EQ(controller().firstPlacements(), nullptr);
  EXPECT_EQ(picture_.shown, controller().reconstruction());
  EXPECT_EQ(table_.shown, controller().reconstruction());
  EXPECT_EQ(marks(), QStringList());
}

TEST_F(LargeSkinTest, IsSeenNoMoreOnceTheOperatorGivesUpItsResult) {
  openLargeSkin([this] { controller().cancelSolving(); });
  ASSERT_TRUE(waitUntil([this] { return is_placed_; }));
  controller().setSolve(ReconstructionWorker::startingFromTheLast());  // which waits for the one that was stopped
  test::letTurnsPass();                                                // what that has still reported is not shown
  EXPECT_EQ(controller().firstPlacements(), nullptr);
  EXPECT_EQ(picture_.shown, nullptr);
  EXPECT_EQ(marks(), QStringList());
}

TEST_F(LargeSkinTest, IsSeenNoMoreWhereAnotherSessionIsOpened) {
  const QString path = writeSession("other.hexo", simulated(3));
  openLargeSkin([&] { window_->openFile(path); });
  ASSERT_TRUE(waitForPoses(3));
  EXPECT_EQ(controller().firstPlacements(), nullptr);
  EXPECT_EQ(picture_.shown, controller().reconstruction());
  EXPECT_EQ(marks(), QStringList());
}

TEST_F(LargeSkinTest, OfFewerCellsIsNotSeenBeforeItsResult) {
  openLargeSkin([] {}, "sheet:44x45");
  ASSERT_TRUE(waitForPoses(2));
  EXPECT_FALSE(is_placed_);
}

TEST_F(ResultPresenterTest, UntilThereIsAResultEveryViewSaysWhatIsGoingOn) {
  const QString path = writeSession("arm.hexo", simulated(2));
  const auto said = [this] {
    window_->showChanges();
    QStringList texts = {labelText("bannerSentence"), window_->findChild<GraphView*>()->accessibleDescription(),
                         window_->findChild<PatchCaptions*>()->accessibleName()};
    for (const char* table : {"poseView", "findingView", "linkView", "cellView"}) {
      const auto* pages = qobject_cast<QStackedWidget*>(find<QTableView>(table)->parentWidget());
      const auto* hint = pages ? qobject_cast<QLabel*>(pages->currentWidget()) : nullptr;
      texts << (hint ? hint->text() : QString());
    }
    texts.removeDuplicates();
    return texts;
  };
  EXPECT_GT(said().size(), 1) << "each has a hint of its own";
  QStringList while_solving;
  // Its result comes with a later turn of the event loop.
  QObject::connect(&controller(), &SessionController::opened, window_.get(), [&] { while_solving = said(); });
  window_->openFile(path);
  EXPECT_EQ(said(), QStringList{"Opening arm.hexo…"});
  ASSERT_TRUE(waitForPoses(2));
  EXPECT_EQ(while_solving, QStringList{"The placements of 17 cells are being worked out…"});
  EXPECT_TRUE(said().contains(words(controller().reconstruction()->assessment.reason)));
}

}  // namespace
}  // namespace hexoderm
