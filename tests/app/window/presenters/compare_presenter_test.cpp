#include "tests/app/window/presenters/presenter_test.h"
#include "widgets/patch/compare_view.h"
#include "widgets/patch/patch_view.h"

namespace hexoderm {
namespace {

class ComparePresenterTest : public PresenterTest {
 protected:
  CompareView* openComparison() {
    press(Qt::Key_C);
    waitForDialog("compareDialog");
    return window_->findChild<CompareView*>();
  }
};

TEST_F(ComparePresenterTest, ComparesWithTheResultBeforeTheLastChange) {
  ASSERT_NO_FATAL_FAILURE(takeDemoPoses(3));
  controller().liveSession().disconnectSource();
  EXPECT_EQ(window_->findChild<CompareView*>(), nullptr) << "made only when it is asked for";
  CompareView* compare = openComparison();
  ASSERT_NE(compare, nullptr);
  auto* source = compare->findChild<QComboBox*>("compareSource");
  EXPECT_EQ(source->currentText(), "the result before the last change");
  auto* summary = compare->findChild<QLabel*>("compareSummary");
  EXPECT_TRUE(waitUntil([&] { return summary->text().startsWith("17 cells in common."); }));
  const QString before = summary->text();
  // What changes while it is open is compared anew.
  controller().setPoseDisabled(0, true);
  EXPECT_TRUE(waitUntil([&] { return summary->text() != before; }));
  QTest::keyClick(compare, Qt::Key_Escape);
  EXPECT_FALSE(compare->isVisible());
}

TEST_F(ComparePresenterTest, WithoutAnEarlierResultItSaysHowToGetOne) {
  window_->openFile(writeSession(pathTo("one.hexo"), 3));
  ASSERT_TRUE(waitUntilIdle());
  CompareView* compare = openComparison();
  ASSERT_NE(compare, nullptr);
  EXPECT_TRUE(compare->findChild<QLabel*>("compareSummary")->text().startsWith("There is nothing to compare with yet"));
  EXPECT_FALSE(compare->findChild<QComboBox*>("compareSource")->isEnabled());
}

}  // namespace
}  // namespace hexoderm
