#include "widgets/coloring/scale_ranges.h"

#include <gtest/gtest.h>
#include <QSignalSpy>
#include <limits>

namespace hexoderm {
namespace {

TEST(ScaleRanges, KeepsARangeForEachColouringUntilItIsReleased) {
  ScaleRanges ranges;
  int changes = 0;
  Coloring last = Coloring::Residual;
  QObject::connect(&ranges, &ScaleRanges::changed, &ranges, [&](Coloring changed) {
    ++changes;
    last = changed;
  });
  EXPECT_EQ(ranges.fixed(Coloring::Bend), std::nullopt);
  ranges.fix(Coloring::Bend, {-5, 5});
  EXPECT_EQ(ranges.fixed(Coloring::Bend), (ColorRange{-5, 5}));
  EXPECT_EQ(ranges.fixed(Coloring::Twist), std::nullopt);
  EXPECT_EQ(last, Coloring::Bend);
  ranges.fix(Coloring::Bend, {-5, 5});
  EXPECT_EQ(changes, 1) << "nothing has changed";
  ranges.release(Coloring::Bend);
  ranges.release(Coloring::Bend);
  EXPECT_EQ(changes, 2);
  EXPECT_EQ(ranges.fixed(Coloring::Bend), std::nullopt);
}

TEST(ScaleRanges, TakesNoRangeThatIsNone) {
  ScaleRanges ranges;
  const double infinity = std::numeric_limits<double>::infinity();
  const double nan = std::numeric_limits<double>::quiet_NaN();
  for (const ColorRange& none :
       {ColorRange{1, 1}, ColorRange{2, 1}, ColorRange{0, infinity}, ColorRange{nan, 1}, ColorRange{0, nan}}) {
    ranges.fix(Coloring::Residual, none);
    EXPECT_EQ(ranges.fixed(Coloring::Residual), std::nullopt);
  }
  ranges.fix(Coloring::Patch, {0, 1});
  EXPECT_EQ(ranges.fixed(Coloring::Patch), std::nullopt) << "classes have no range";
}

}  // namespace
}  // namespace hexoderm
