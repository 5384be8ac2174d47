#include "app/window/presenters/result_presenter.h"

#include "tests/app/window/window_test.h"

namespace hexoderm {
namespace {

struct FakeView {
  std::vector<const FakeView*>& served;
  std::shared_ptr<const Reconstruction> shown;

  void setReconstruction(std::shared_ptr<const Reconstruction> reconstruction) {
    served.push_back(this);
    shown = std::move(reconstruction);
  }
};

class ResultPresenterTest : public WindowTest {
 protected:
  std::vector<const FakeView*> served_;
  FakeView picture_{served_, nullptr};
  FakeView table_{served_, nullptr};
};

TEST_F(ResultPresenterTest, HandsOutOneResultInTheOrderInWhichViewsWereAdded) {
  ResultPresenter results(controller());
  results.addPicture(&picture_);
  results.add(&table_);
  const QSignalSpy handed_out(&results, &ResultPresenter::handedOut);
  ASSERT_NO_FATAL_FAILURE(takeDemoPoses(1));
  EXPECT_EQ(picture_.shown, controller().reconstruction());
  EXPECT_EQ(table_.shown, controller().reconstruction());
  ASSERT_GE(served_.size(), 2U);
  for (std::size_t k = 0; k < served_.size(); ++k) EXPECT_EQ(served_[k], k % 2 == 0 ? &picture_ : &table_);
  EXPECT_EQ(2 * handed_out.count(), static_cast<int>(served_.size()));
}

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

}  // namespace
}  // namespace hexoderm
