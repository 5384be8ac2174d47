#include "widgets/controls/folding_row.h"

#include <gtest/gtest.h>
#include "tests/support/qt_wait.h"

#include <algorithm>
#include <vector>

namespace hexoderm {
namespace {

class FoldingRowTest : public testing::Test {
 protected:
  FoldingRowTest() : row_(new FoldingRow(&bar_)) {
    for (const char* text : {"Colour", "Show", "Fit", "Front", "Side"}) {
      auto* button = new QToolButton;
      button->setText(QLatin1String(text));
      button->setFocusPolicy(Qt::TabFocus);
      row_->addWidget(button);
      buttons_.push_back(button);
      if (buttons_.size() == 2) row_->beginSecondGroup();
    }
    row_->setContentsMargins(0, 0, 0, 0);
    bar_.show();
    EXPECT_TRUE(test::waitUntilExposed(bar_));
  }
  void resizeTo(int width) {
    bar_.resize(width, row_->sizeHint().height());
    row_->setGeometry(bar_.rect());
  }
  int folded() const {
    return static_cast<int>(
        std::count_if(buttons_.begin(), buttons_.end(), [this](auto* each) { return row_->isFolded(each); }));
  }

  QWidget bar_;
  FoldingRow* row_;
  std::vector<QToolButton*> buttons_;
};

TEST_F(FoldingRowTest, TheLastOnesFoldFirstIntoOneRowThatKeepsItsHeight) {
  const int height = row_->sizeHint().height();
  int before = 0;
  for (int width = row_->sizeHint().width() - 1; width > row_->minimumSize().width(); width -= 10) {
    resizeTo(width);
    EXPECT_GE(folded(), before) << width;
    before = folded();
    EXPECT_TRUE(row_->moreButton()->isVisible());
    EXPECT_LE(row_->moreButton()->geometry().right(), bar_.rect().right()) << width;
    EXPECT_EQ(row_->sizeHint().height(), height);
    for (std::size_t k = 0; k < buttons_.size(); ++k) {
      EXPECT_EQ(row_->isFolded(buttons_[k]), k + static_cast<std::size_t>(before) >= buttons_.size()) << width;
      if (row_->isFolded(buttons_[k])) continue;
      EXPECT_LE(buttons_[k]->geometry().right(), row_->moreButton()->geometry().left()) << width;
      EXPECT_EQ(buttons_[k]->y(), buttons_[0]->y()) << "one row";
    }
  }
  EXPECT_GE(before, 4);
}

TEST_F(FoldingRowTest, TheMenuDoesWhatTheFoldedButtonsDo) {
  auto* inner = new QMenu(buttons_[1]);
  inner->addAction("Ports");
  buttons_[1]->setMenu(inner);
  buttons_[3]->setCheckable(true);
  resizeTo(row_->minimumSize().width() + 1);
  ASSERT_EQ(folded(), 5);
  EXPECT_EQ(buttons_[4]->focusPolicy(), Qt::NoFocus) << "the keyboard passes by what can't be seen";
  QMenu* menu = row_->moreButton()->menu();
  emit menu->aboutToShow();
  ASSERT_EQ(menu->actions().size(), 5);
  EXPECT_EQ(menu->actions()[1]->menu(), inner);
  const QSignalSpy clicked(buttons_[2], &QToolButton::clicked);
  menu->actions()[2]->trigger();
  EXPECT_EQ(clicked.count(), 1);
  menu->actions()[3]->trigger();
  EXPECT_TRUE(buttons_[3]->isChecked());
  resizeTo(row_->sizeHint().width());
  EXPECT_EQ(buttons_[4]->focusPolicy(), Qt::TabFocus);
}

TEST_F(FoldingRowTest, WhatItsOwnerHidesIsNeitherInTheRowNorInTheMenu) {
  buttons_[0]->hide();
  resizeTo(row_->minimumSize().width() + 1);
  buttons_[4]->hide();
  emit row_->moreButton()->menu()->aboutToShow();
  EXPECT_EQ(row_->moreButton()->menu()->actions().size(), 3);
  buttons_[4]->show();
  resizeTo(row_->sizeHint().width());
  EXPECT_TRUE(buttons_[4]->isVisible());
  EXPECT_EQ(folded(), 0);
  EXPECT_FALSE(row_->moreButton()->isVisible());
}

}  // namespace
}  // namespace hexoderm
