#include "tests/app/window/presenters/presenter_test.h"
#include "widgets/controls/card_dock.h"
#include "widgets/plot/plot_view.h"

#include <qwt_plot.h>

namespace hexoderm {
namespace {

class PlotPresenterTest : public PresenterTest {
 protected:
  PlotView* plot() { return find<PlotView>("plotView"); }
  void openPlot() {
    press(Qt::Key_P);
    ASSERT_TRUE(waitUntil([&] { return plot()->isVisible() && plot()->plot()->canvas()->hasFocus(); }));
  }
};

TEST_F(PlotPresenterTest, PShowsThePlotOfTheResultAndClosesItAgain) {
  ASSERT_NO_FATAL_FAILURE(takeDemoPoses(2));
  EXPECT_FALSE(plot()->isVisible()) << "closed until it is asked for";
  ASSERT_NO_FATAL_FAILURE(openPlot());
  EXPECT_EQ(plot()->data().points.size(), 17U);
  press(Qt::Key_P);
  EXPECT_FALSE(plot()->isVisible());
}

TEST_F(PlotPresenterTest, WhatIsBrushedIsMarkedInTheGraphUntilAnotherSkinIsOpened) {
  ASSERT_NO_FATAL_FAILURE(takeDemoPoses(2));
  ASSERT_NO_FATAL_FAILURE(openPlot());
  auto* graph = window_->findChild<GraphView*>();
  const QImage before = graph->grab().toImage();
  QTest::keyClick(plot()->plot()->canvas(), Qt::Key_A, Qt::ControlModifier);
  EXPECT_EQ(window_->selection().brushed().size(), 17U);
  EXPECT_NE(graph->grab().toImage(), before);
  keepPicture(window_->picture(), "plot-brushed-in-window");
  controller().liveSession().startDemo();
  EXPECT_TRUE(waitUntil([&] { return window_->selection().brushed().empty(); }));
}

TEST_F(PlotPresenterTest, ReadingsArePlottedWhileTheSkinSends) {
  ASSERT_NO_FATAL_FAILURE(takeDemoPoses(1));
  ASSERT_NO_FATAL_FAILURE(openPlot());
  plot()->setChoice({PlotSubject::Cells, std::nullopt, Coloring::ReadingNorm, false});
  EXPECT_TRUE(waitUntil([&] { return plot()->data().points.size() == 17; }));
  controller().liveSession().disconnectSource();
  EXPECT_TRUE(waitUntil([&] { return plot()->data().points.empty(); }));
}

}  // namespace
}  // namespace hexoderm
