#include "widgets/controls/column_layout.h"

#include <gtest/gtest.h>
#include "tests/support/qt_wait.h"

#include <memory>
#include <set>
#include <vector>

namespace hexoderm {
namespace {

class ColumnLayoutTest : public testing::Test {
 protected:
  ColumnLayoutTest() {
    auto* layout = new ColumnLayout(200, &widget_);
    for (int k = 0; k < 6; ++k) {
      parts_.push_back(new QWidget);
      parts_.back()->setFixedHeight(100);
      layout->addWidget(parts_.back());
    }
    layout->setContentsMargins(0, 0, 0, 0);
    widget_.show();
    EXPECT_TRUE(test::waitUntilExposed(widget_));
  }
  std::size_t columnsAt(int width) {
    widget_.resize(width, 1000);
    widget_.layout()->setGeometry(widget_.rect());
    std::set<int> columns;
    for (const QWidget* part : parts_) columns.insert(part->x());
    return columns.size();
  }

  QWidget widget_;
  std::vector<QWidget*> parts_;
};

TEST_F(ColumnLayoutTest, HasAsManyColumnsAsThereIsRoomForAndThreeAtMost) {
  EXPECT_EQ(columnsAt(250), 1U);
  EXPECT_EQ(columnsAt(500), 2U);
  EXPECT_EQ(columnsAt(800), 3U);
  EXPECT_EQ(columnsAt(3000), 3U);
}

TEST_F(ColumnLayoutTest, GoesDownOneColumnAndThenDownTheNext) {
  ASSERT_EQ(columnsAt(500), 2U);
  for (std::size_t k = 1; k < parts_.size(); ++k) {
    if (parts_[k]->x() == parts_[k - 1]->x()) {
      EXPECT_GT(parts_[k]->y(), parts_[k - 1]->geometry().bottom());
    } else {
      EXPECT_GT(parts_[k]->x(), parts_[k - 1]->geometry().right());
    }
  }
  EXPECT_LT(widget_.layout()->heightForWidth(500), widget_.layout()->heightForWidth(250) * 2 / 3);
}

TEST_F(ColumnLayoutTest, WhatIsHiddenTakesNoRoom) {
  const int all = widget_.layout()->heightForWidth(250);
  parts_[2]->hide();
  EXPECT_LE(widget_.layout()->heightForWidth(250), all - 100);
}

}  // namespace
}  // namespace hexoderm
