// Links that the operator sets aside, as a cable for example, and takes back.

#include "tests/app/window/window_test.h"
#include "widgets/tables/link_table.h"

namespace hexoderm {
namespace {

class WindowLinksTest : public WindowTest {
 protected:
  [[nodiscard]] const LinkEstimate& firstLink() { return controller().reconstruction()->patches.front().links.front(); }
  [[nodiscard]] GraphView* graph() { return window_->findChild<GraphView*>(); }
};

TEST_F(WindowLinksTest, ThePickedLinkIsSetAsideByItsMenuOrByM) {
  ASSERT_NO_FATAL_FAILURE(openSession("arm.hexo", simulated(2)));
  expectDisabled("actionExcludeLink", "Pick a link");
  const Selection::Link link(firstLink().source, firstLink().target);
  const QPoint at = graph()->positionOf(link.first, link.second).value();
  QContextMenuEvent event(QContextMenuEvent::Mouse, at, graph()->mapToGlobal(at));
  QApplication::sendEvent(graph(), &event);
  EXPECT_EQ(window_->selection().link(), link) << "what was clicked is picked, so that the menu is about it";
  auto* menu = window_->findChild<QMenu*>("graphMenu");
  ASSERT_NE(menu, nullptr);
  EXPECT_TRUE(menu->actions().contains(action("actionExcludeLink")));
  QTest::keyClick(menu, Qt::Key_Escape);
  EXPECT_TRUE(find<QTableView>("linkView")->actions().contains(action("actionExcludeLink")));
  EXPECT_TRUE(action("actionExcludeLink")->isEnabled());
  EXPECT_FALSE(action("actionExcludeLink")->autoRepeat()) << "a key that is held must not switch to and fro";

  press(Qt::Key_M);
  ASSERT_TRUE(waitUntilIdle());
  const LinkEstimate* shown = controller().reconstruction()->findLink(link.first, link.second);
  ASSERT_NE(shown, nullptr);
  EXPECT_EQ(shown->muted_by, FindingCode::LinkSetAside);
  EXPECT_EQ(window_->selection().link(), link) << "it stays picked";
  EXPECT_EQ(action("actionExcludeLink")->text().remove('&'), "Take link back");
  auto* table = window_->findChild<LinkTable*>();
  ASSERT_NE(table, nullptr);
  const int row = table->rowOf(link.first, link.second);
  ASSERT_GE(row, 0);
  EXPECT_EQ(table->index(row, table->columnCount() - 1).data(), "set aside");
}

TEST_F(WindowLinksTest, ACalibrationSaysWhyItsLinksStayAsTheyAre) {
  ASSERT_NO_FATAL_FAILURE(openFile(HEXODERM_TEST_DATA "/two_patches.tum.xml"));
  window_->selection().selectLink(firstLink().source, firstLink().target);
  expectDisabled("actionExcludeLink", "calibration");
  press(Qt::Key_M);
  EXPECT_EQ(controller().undoStack()->count(), 0);
}

TEST_F(WindowLinksTest, ThePictureOfTheGraphIsWritten) {
  ASSERT_NO_FATAL_FAILURE(openSession("arm.hexo", simulated(1)));
  for (const char* const name : {"graph.svg", "graph.png"}) {
    emit graph()->pictureWanted();
    ASSERT_NO_FATAL_FAILURE(typeIntoFileDialog("saveDialog", pathTo(name)));
    ASSERT_TRUE(waitForMessage("Exported to " + pathTo(name)));
    EXPECT_GT(QFileInfo(pathTo(name)).size(), 2000);
    closeMessage();
  }
  EXPECT_FALSE(QImage(pathTo("graph.png")).isNull());
}

}  // namespace
}  // namespace hexoderm
