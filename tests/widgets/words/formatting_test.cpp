#include "widgets/words/formatting.h"

#include <gmock/gmock.h>

namespace hexoderm {
namespace {

TEST(Formatting, KeepMetricsToTheirUnits) {
  EXPECT_EQ(unbroken("±2.1 mm (95 %), 4 poses, 3 mg of 1 g"),
            "±2.1\u00a0mm (95\u00a0%), 4 poses, 3\u00a0mg of 1\u00a0g");
  EXPECT_EQ(unbroken("cell 7 sends, 3 messages"), "cell 7 sends, 3 messages");
}

}  // namespace
}  // namespace hexoderm
