#include "app/window/toolkit/table_views.h"
#include "app/window/settings/theme.h"
#include "tests/support/qt_wait.h"

#include <gtest/gtest.h>

#include <memory>

namespace hexoderm {
namespace {

/// A table of one text, at the top of its row, in a column of a width that the test chooses.
std::unique_ptr<QTableView> makeWrappingTable(QStandardItemModel& model) {
  std::unique_ptr<QTableView> view(makeTable(&model, "view", "Findings"));
  wrapRows(view.get());
  view->horizontalHeader()->setSectionResizeMode(QHeaderView::Fixed);
  view->resize(700, 300);
  view->show();
  return view;
}

QImage firstLine(QTableView& view) {
  const QPoint at = view.visualRect(view.model()->index(0, 0)).topLeft();
  return view.viewport()->grab(QRect(at, QSize(view.columnWidth(0), view.fontMetrics().height()))).toImage();
}

TEST(TableViews, ATextIsWrappedBeforeItIsElidedAtWhateverWidthItsColumnIsGiven) {
  applyTheme(Theme::Light);
  const QString text = "There is no pose yet: the shape shown follows from the ports alone.";
  QStandardItemModel model(1, 1);
  auto* item = new QStandardItem(text);
  item->setTextAlignment(Qt::AlignLeft | Qt::AlignTop);
  model.setItem(0, 0, item);
  const auto view = makeWrappingTable(model);
  // Has room for all lines, whatever it thinks that the text needs.
  const auto tall = makeWrappingTable(model);
  tall->verticalHeader()->setSectionResizeMode(QHeaderView::Fixed);
  ASSERT_TRUE(test::waitUntilExposed(*view) && test::waitUntilExposed(*tall));

  const int width = view->fontMetrics().horizontalAdvance(text);
  // From wide to narrow: a row that was measured for less width has room for more lines than it needs.
  for (int spare = 30; spare >= -30; --spare) {
    for (QTableView* each : {view.get(), tall.get()}) each->setColumnWidth(0, width + spare);
    EXPECT_TRUE(test::waitUntil([&] {
      tall->setRowHeight(0, 120);
      return firstLine(*view) == firstLine(*tall);
    })) << spare;
  }
}

}  // namespace
}  // namespace hexoderm
