// Links that the operator sets aside, as a cable for example, and takes back.

#include "hexoderm/io/session_json.h"
#include "hexoderm/session/session_store.h"
#include "tests/app/window/window_test.h"
#include "tests/support/paths.h"
#include "widgets/tables/link_table.h"

#include <QClipboard>
#include <QContextMenuEvent>
#include <QImage>
#include <QMenu>

namespace hexoderm {
namespace {

class WindowLinksTest : public WindowTest {
 protected:
  /// The first link of the newest result; the demo skin is a tree, so that without it there are two patches.
  [[nodiscard]] Selection::Link firstLink() {
    const LinkEstimate& link = controller().reconstruction()->patches.front().links.front();
    return {link.source, link.target};
  }
  [[nodiscard]] GraphView* graph() { return window_->findChild<GraphView*>(); }
  void clickLinkInGraph(const Selection::Link& link) {
    const std::optional<QPoint> position = graph()->positionOf(link.first, link.second);
    ASSERT_TRUE(position.has_value());
    QTest::mouseClick(graph(), Qt::LeftButton, Qt::NoModifier, *position);
    ASSERT_EQ(window_->selection().link(), link);
  }
  bool waitForPatches(std::size_t count) {
    return waitUntilIdle() && waitUntil([&] { return controller().reconstruction()->patches.size() == count; });
  }
  [[nodiscard]] const LinkEstimate* shown(const Selection::Link& link) {
    return controller().reconstruction()->findLink(link.first, link.second);
  }
  bool waitUntilKept() {
    return waitUntil([this] { return !controller().file().isWriting() && !controller().file().hasUnsavedChanges(); });
  }
};

TEST_F(WindowLinksTest, ThePickedLinkIsSetAsideByMUndoneAndDoneAgain) {
  ASSERT_NO_FATAL_FAILURE(takeDemoPoses(2));
  EXPECT_FALSE(action("actionMuteLink")->isEnabled());
  EXPECT_TRUE(action("actionMuteLink")->toolTip().contains("Pick a link"));
  const Selection::Link link = firstLink();
  ASSERT_NO_FATAL_FAILURE(clickLinkInGraph(link));
  EXPECT_TRUE(action("actionMuteLink")->isEnabled());
  EXPECT_FALSE(action("actionMuteLink")->autoRepeat()) << "a key that is held must not switch to and fro";

  press(Qt::Key_M);
  ASSERT_TRUE(waitForPatches(2));
  ASSERT_NE(shown(link), nullptr);
  EXPECT_FALSE(shown(link)->used);
  EXPECT_EQ(shown(link)->muted_by, FindingCode::LinkSetAside);
  EXPECT_EQ(window_->selection().link(), link) << "it stays picked";
  EXPECT_EQ(action("actionMuteLink")->text().remove('&'), "Take link back");
  EXPECT_TRUE(action("actionUndo")->text().contains("aside"));

  press(Qt::Key_Z, Qt::ControlModifier);
  ASSERT_TRUE(waitForPatches(1));
  EXPECT_TRUE(shown(link)->used);
  press(Qt::Key_Z, Qt::ControlModifier | Qt::ShiftModifier);
  ASSERT_TRUE(waitForPatches(2));
  press(Qt::Key_M);
  ASSERT_TRUE(waitForPatches(1));
  EXPECT_TRUE(controller().session()->mutedLinks().empty());
}

TEST_F(WindowLinksTest, ASessionKeepsWhatWasSetAside) {
  ASSERT_NO_FATAL_FAILURE(takeDemoPoses(1));
  const Selection::Link link = firstLink();
  ASSERT_NO_FATAL_FAILURE(clickLinkInGraph(link));
  press(Qt::Key_M);
  ASSERT_TRUE(waitForPatches(2));
  const QString path = pathTo("cable.session.json");
  press(Qt::Key_S, Qt::ControlModifier);
  ASSERT_NO_FATAL_FAILURE(typeIntoFileDialog("saveDialog", path));
  ASSERT_TRUE(waitForMessage("Saved to " + path)) << message().toStdString();
  EXPECT_NE(readSessionJson(path.toStdString()).findMutedLink(link.first, link.second), nullptr);

  openWindow();
  window_->openFile(path);
  ASSERT_TRUE(waitForPoses(1));
  EXPECT_EQ(controller().reconstruction()->patches.size(), 2U);
  ASSERT_NO_FATAL_FAILURE(clickLinkInGraph(link));
  press(Qt::Key_M);
  EXPECT_TRUE(waitForPatches(1));
}

TEST_F(WindowLinksTest, AJournalKeepsEveryChangeAsItHappens) {
  ASSERT_NO_FATAL_FAILURE(takeDemoPoses(1));
  press(Qt::Key_S, Qt::ControlModifier);
  const QString path = pathTo("demo.hexo");
  ASSERT_NO_FATAL_FAILURE(typeIntoFileDialog("saveDialog", path));
  ASSERT_TRUE(waitForMessage("Saved to " + path)) << message().toStdString();
  ASSERT_TRUE(waitUntil([&] { return controller().file().isKept(); }));
  const Selection::Link link = firstLink();
  ASSERT_NO_FATAL_FAILURE(clickLinkInGraph(link));
  press(Qt::Key_M);
  ASSERT_TRUE(waitForPatches(2));
  ASSERT_TRUE(waitUntilKept());
  EXPECT_NE(readSessionStore(path.toStdString()).findMutedLink(link.first, link.second), nullptr);
  press(Qt::Key_Z, Qt::ControlModifier);
  ASSERT_TRUE(waitForPatches(1));
  ASSERT_TRUE(waitUntilKept());
  EXPECT_EQ(readSessionStore(path.toStdString()).findMutedLink(link.first, link.second), nullptr);
}

TEST_F(WindowLinksTest, TheMenusOfGraphAndTableOfferIt) {
  ASSERT_NO_FATAL_FAILURE(takeDemoPoses(1));
  const Selection::Link link = firstLink();
  const QPoint at = graph()->positionOf(link.first, link.second).value();
  QContextMenuEvent event(QContextMenuEvent::Mouse, at, graph()->mapToGlobal(at));
  QApplication::sendEvent(graph(), &event);
  EXPECT_EQ(window_->selection().link(), link) << "what was clicked is picked, so that the menu is about it";
  auto* menu = window_->findChild<QMenu*>("graphMenu");
  ASSERT_NE(menu, nullptr);
  EXPECT_TRUE(menu->actions().contains(action("actionMuteLink")));
  QTest::keyClick(menu, Qt::Key_Escape);
  EXPECT_TRUE(find<QTableView>("linkView")->actions().contains(action("actionMuteLink")));
  action("actionMuteLink")->trigger();
  ASSERT_TRUE(waitForPatches(2));
  auto* table = window_->findChild<LinkTable*>();
  ASSERT_NE(table, nullptr);
  const int row = table->rowOf(link.first, link.second);
  ASSERT_GE(row, 0);
  EXPECT_EQ(table->index(row, table->columnCount() - 1).data(), "set aside");
}

TEST_F(WindowLinksTest, ACalibrationSaysWhyItsLinksStayAsTheyAre) {
  window_->openFile(QStringLiteral(HEXODERM_TEST_DATA "/two_patches.tum.xml"));
  ASSERT_TRUE(waitUntilIdle());
  const LinkEstimate& link = controller().reconstruction()->patches.front().links.front();
  window_->selection().selectLink(link.source, link.target);
  EXPECT_FALSE(action("actionMuteLink")->isEnabled());
  EXPECT_TRUE(action("actionMuteLink")->toolTip().contains("calibration"));
  press(Qt::Key_M);
  EXPECT_EQ(controller().undoStack()->count(), 0);
}

TEST_F(WindowLinksTest, ThePictureOfTheGraphIsWritten) {
  ASSERT_NO_FATAL_FAILURE(takeDemoPoses(1));
  for (const QString& name : {QStringLiteral("graph.svg"), QStringLiteral("graph.png")}) {
    emit graph()->pictureWanted();
    ASSERT_NO_FATAL_FAILURE(typeIntoFileDialog("saveDialog", pathTo(name)));
    ASSERT_TRUE(waitForMessage("Exported to " + pathTo(name))) << message().toStdString();
    EXPECT_GT(QFileInfo(pathTo(name)).size(), 2000);
    click(find<QWidget>("messageClose"));
  }
  EXPECT_FALSE(QImage(pathTo("graph.png")).isNull());
}

}  // namespace
}  // namespace hexoderm
