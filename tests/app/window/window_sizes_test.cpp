// Large and small skins in the window: one cell, a thousand poses, a hundred thousand cells.

#include "tests/app/window/window_test.h"

namespace hexoderm {
namespace {

class WindowSizesTest : public WindowTest {
 protected:
  /// However busy the computer is.
  template <class Condition>
  static bool waitLong(Condition condition) {
    constexpr int kMilliseconds = 600000;
    return QTest::qWaitFor(condition, kMilliseconds);
  }
  void open(const QString& path) {
    window_->openFile(path);
    ASSERT_TRUE(waitLong([&] { return controller().file().name() == QFileInfo(path).fileName(); }));
    ASSERT_TRUE(waitLong([this] { return controller().isCurrent() && controller().work().activity().isEmpty(); }));
  }
  QString writeSkin(const QString& patch, std::size_t poses, std::size_t frames, SimulatedSkinOptions options = {}) {
    options.patch = patch.toStdString();
    return writeSession("skin.hexo", simulated(poses, options, frames));
  }
  /// The pictures and the keys still do what they are for.
  void expectUsable(CellId cell) {
    press(Qt::Key_F, Qt::ControlModifier);
    QTest::keyClicks(QApplication::focusWidget(), QString::number(cell.value()));
    EXPECT_EQ(window_->selection().cell(), cell);
    QTest::keyClick(QApplication::focusWidget(), Qt::Key_Return);
    EXPECT_FALSE(window_->picture().isNull());
    for (int step = 1; step <= 6; ++step) press(Qt::Key_0 + step, Qt::ControlModifier);
    EXPECT_TRUE(action("actionExport")->isEnabled()) << action("actionExport")->toolTip().toStdString();
  }
};

TEST_F(WindowSizesTest, ASingleCellIsShownAndPicked) {
  ASSERT_NO_FATAL_FAILURE(
      open(writeFile("one.session.json", R"({"format": "hexoderm-session", "version": 1, "cell_model": "hex-bma150",
                                       "cells": [{"id": 5, "ports": []}],
                                       "poses": [{"id": 1, "samples": [{"cell": 5, "mean_g": [0, 0, 1]}]},
                                                 {"id": 2, "samples": [{"cell": 5, "mean_g": [1, 0, 0]}]}]})")));
  ASSERT_TRUE(waitForPoses(2));
  EXPECT_EQ(controller().reconstruction()->cellCount(), 1U);
  ASSERT_NO_FATAL_FAILURE(clickCellInGraph(CellId(5)));
  EXPECT_EQ(window_->selection().cell(), CellId(5));
  ASSERT_NO_FATAL_FAILURE(expectUsable(CellId(5)));
}

TEST_F(WindowSizesTest, AThousandPosesAreLeftForAnotherSessionAndForTheEndWhileTheyAreSolved) {
  const QString many = writeSkin("sheet:10x10", 1000, 2);
  const QString few = writeSession("few.hexo", simulated(3, {}, 2));
  const auto beginSolving = [&] {
    window_->openFile(many);
    ASSERT_TRUE(waitLong([&] { return controller().file().name() == QFileInfo(many).fileName(); }));
    ASSERT_FALSE(controller().isCurrent());
  };
  ASSERT_NO_FATAL_FAILURE(beginSolving());
  ASSERT_NO_FATAL_FAILURE(open(few));
  EXPECT_EQ(posesShown(), 3);
  ASSERT_NO_FATAL_FAILURE(beginSolving());
  window_.reset();
}

TEST_F(WindowSizesTest, AHundredThousandCells) {
  // For a skin without errors the tree is the optimum; for any other the global solver needs many steps, and with so
  // many cells minutes.
  ASSERT_NO_FATAL_FAILURE(open(writeSkin("sheet:400x250", 6, 2, SimulatedSkinOptions::ideal())));
  ASSERT_TRUE(waitLong([this] { return posesShown() == 6; }));
  EXPECT_EQ(controller().reconstruction()->cellCount(), 100000U);
  ASSERT_NO_FATAL_FAILURE(expectUsable(CellId(4711)));
}

}  // namespace
}  // namespace hexoderm
