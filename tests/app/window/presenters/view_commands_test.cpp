#include "tests/app/window/presenters/presenter_test.h"
#include "widgets/controls/card_dock.h"
#include "widgets/patch/patch_view.h"

namespace hexoderm {
namespace {

class ViewCommandsTest : public PresenterTest {};

TEST_F(ViewCommandsTest, GSwapsTheViewsAndTheNextStartRemembers) {
  ASSERT_NO_FATAL_FAILURE(takeDemoPoses(2));
  auto* dock = find<CardDock>("graphDock");
  auto* patch = window_->findChild<PatchView*>();
  auto* graph = window_->findChild<GraphView*>();
  ASSERT_TRUE(dock->isAncestorOf(graph));
  press(Qt::Key_G);
  EXPECT_TRUE(dock->isAncestorOf(patch));
  EXPECT_FALSE(dock->isAncestorOf(graph));
  EXPECT_TRUE(graph->isVisible());
  EXPECT_EQ(dock->windowTitle(), "Skin patch");
  // Both still draw: what they show in their middle differs from their corner.
  ASSERT_TRUE(waitUntil([&] { return patch->width() > 100 && graph->width() > 100; }));
  ASSERT_TRUE(waitUntil([&] { return patch->isUpToDate(); }));
  keepPicture(window_->picture(), "swapped-light");
  EXPECT_GT(coloursIn(patch->screenshot()), 50U) << "the patch is not drawn";
  ASSERT_NO_FATAL_FAILURE(clickCellInGraph(CellId(7)));
  EXPECT_EQ(window_->selection().cell(), CellId(7));

  reopenWindow();
  EXPECT_TRUE(find<CardDock>("graphDock")->isAncestorOf(window_->findChild<PatchView*>()));
  press(Qt::Key_G);
  EXPECT_TRUE(find<CardDock>("graphDock")->isAncestorOf(window_->findChild<GraphView*>()));
}

TEST_F(ViewCommandsTest, StepsAboveGiveWayToOneThatDoesNotFitBelowThemUntilSomebodyScrolls) {
  window_->resize(1280, 800);
  ASSERT_NO_FATAL_FAILURE(takeDemoPoses(1));
  auto* panel = find<StepPanel>("stepPanel");
  const auto is_seen = [panel](const QWidget* part) {
    return panel->viewport()->rect().contains(QRect(part->mapTo(panel->viewport(), QPoint()), part->size()));
  };
  panel->openStep(2);
  const auto* skip = find<QAbstractButton>("captureSkip");
  // As high as the step needs and half of the one before it, whatever the font.
  const auto top_of = [panel](const QWidget* part) { return part->mapTo(panel->widget(), QPoint()).y(); };
  const auto* head = find<QAbstractButton>("stepHead3");
  ASSERT_TRUE(waitUntil([&] { return skip->isVisible() && top_of(skip) > top_of(head); }));
  const int needed = top_of(skip) + skip->height() - top_of(head) + find<QAbstractButton>("stepHead2")->height() / 2;
  const int high = window_->height() + needed - panel->viewport()->height();
  window_->resize(1280, high);
  ASSERT_TRUE(waitUntil([&] { return panel->viewport()->height() == needed; }));
  panel->openStep(0);
  panel->openStep(2);
  EXPECT_TRUE(waitUntil([&] { return is_seen(find<QAbstractButton>("stepHead3")) && is_seen(skip); }));
  EXPECT_FALSE(is_seen(find<QAbstractButton>("stepHead1")));

  panel->verticalScrollBar()->setValue(0);
  const int height = panel->height();
  window_->resize(1280, window_->height() + 30);
  ASSERT_TRUE(waitUntil([&] { return panel->height() > height; }));
  QCoreApplication::processEvents();
  EXPECT_EQ(panel->verticalScrollBar()->value(), 0);
  panel->openStep(0);
  EXPECT_TRUE(waitUntil([&] { return is_seen(find<QAbstractButton>("stepHead1")); }));
}

}  // namespace
}  // namespace hexoderm
