#include "widgets/controls/action_button.h"

#include <gtest/gtest.h>

namespace hexoderm {
namespace {

TEST(ActionButton, ATextThatIsWiderThanItsPlaceStandsInSeveralLines) {
  QAction action("Let the simulated robot take the poses");
  ActionButton button;
  button.setAction(&action);
  const QSize whole = button.sizeHint();
  button.setRoom(whole.width() * 2 / 3);
  EXPECT_LE(button.sizeHint().width(), whole.width() * 2 / 3);
  EXPECT_GT(button.sizeHint().height(), whole.height());
  EXPECT_EQ(button.text(), action.text()) << "what it says is the same";
  button.setRoom(whole.width());
  EXPECT_EQ(button.sizeHint(), whole);
}

}  // namespace
}  // namespace hexoderm
