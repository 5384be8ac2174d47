#include "widgets/controls/elided_label.h"

#include <gtest/gtest.h>

namespace hexoderm {
namespace {

const QString kLong =
    QStringLiteral("A sentence about a cell, its links and its poses that goes on and on. ").repeated(6);

TEST(ElidedLabel, IsAsHighAndAsNarrowAsBeforeWhateverItSays) {
  for (const int lines : {1, 2}) {
    ElidedLabel label(lines);
    label.resize(300, label.sizeHint().height());
    label.setText("Short");
    const int height = label.heightForWidth(300);
    const QSize least = label.minimumSizeHint();
    EXPECT_FALSE(label.isElided());
    label.setText(kLong);
    EXPECT_EQ(label.heightForWidth(300), height);
    EXPECT_EQ(label.minimumSizeHint(), least);
    EXPECT_TRUE(label.isElided());
    EXPECT_EQ(label.text(), kLong) << "the whole is still there";
  }
}

TEST(ElidedLabel, TwoLinesHoldMoreThanOne) {
  const QString text = "Usable: so many millimetres at the worst cell";
  ElidedLabel one(1);
  ElidedLabel two(2);
  for (ElidedLabel* label : {&one, &two}) {
    label->setText(text);
    label->resize(label->fontMetrics().horizontalAdvance(text) * 3 / 4, label->sizeHint().height());
  }
  EXPECT_TRUE(one.isElided());
  EXPECT_FALSE(two.isElided());
}

}  // namespace
}  // namespace hexoderm
