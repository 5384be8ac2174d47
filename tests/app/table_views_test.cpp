#include "app/window/table_views.h"
#include "app/window/theme.h"
#include "support/qt_wait.h"

#include <gtest/gtest.h>

#include <QHeaderView>
#include <QStandardItemModel>
#include <QTableView>
#include <memory>

namespace hexoderm {
namespace {

TEST(TableViews, ATextIsWrappedBeforeItIsElidedAtWhateverWidthItsColumnIsGiven) {
  applyTheme(Theme::Light);
  const QString text = QStringLiteral("There is no pose yet: the shape shown follows from the ports alone.");
  QStandardItemModel model(1, 1);
  model.setItem(0, 0, new QStandardItem(text));
  const std::unique_ptr<QTableView> view(makeTable(&model, "view", QStringLiteral("Findings")));
  wrapRows(view.get());
  view->horizontalHeader()->setSectionResizeMode(QHeaderView::Fixed);
  view->resize(700, 200);
  view->show();
  ASSERT_TRUE(test::waitUntilExposed(*view));
  const QFontMetrics metrics = view->fontMetrics();
  const int width = metrics.horizontalAdvance(text);
  // What the style sheet and the style keep free at the sides of a text.
  const int sides = 6 + 2 * (view->style()->pixelMetric(QStyle::PM_FocusFrameHMargin, nullptr, view.get()) + 1);
  view->setColumnWidth(0, width + 60);
  const int one_line =
      test::waitUntil([&] { return view->rowHeight(0) < 2 * metrics.height(); }) ? view->rowHeight(0) : 0;
  ASSERT_GT(one_line, 0);
  for (int spare = -30; spare <= 30; spare += 2) {
    view->setColumnWidth(0, width + spare);
    const bool fits = spare >= sides;
    EXPECT_TRUE(test::waitUntil([&] { return fits || view->rowHeight(0) > one_line; })) << spare;
  }
}

}  // namespace
}  // namespace hexoderm
