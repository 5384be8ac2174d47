// What a capture says of waits: after a while, and then ever more rarely.

#include "app/cli/capture_events.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <optional>
#include <vector>

namespace hexoderm::cli {
namespace {

using testing::ElementsAre;
using testing::Optional;

/// When it is said, if somebody looks every half second from `begin_s` on.
std::vector<double> saidAt(LastingWait& wait, double begin_s, double end_s) {
  std::vector<double> times;
  for (double now_s = begin_s; now_s <= end_s; now_s += 0.5) {
    if (wait.toBeSaid(now_s)) times.push_back(now_s);
  }
  return times;
}

TEST(LastingWait, IsSaidEverMoreRarely) {
  LastingWait wait(3);
  wait.begin(100);
  EXPECT_THAT(saidAt(wait, 100, 150), ElementsAre(103, 106, 112, 124, 148));
}

TEST(LastingWait, BeginsAnewWhenWhatWasWaitedForCame) {
  LastingWait wait(3);
  wait.begin(0);
  EXPECT_THAT(saidAt(wait, 0, 7), ElementsAre(3, 6));
  wait.begin(7);
  EXPECT_THAT(saidAt(wait, 7, 14), ElementsAre(10, 13));
}

TEST(LastingWait, SaysHowLongItWas) {
  LastingWait wait(5);
  wait.begin(1);
  EXPECT_EQ(wait.toBeSaid(5.5), std::nullopt);
  EXPECT_THAT(wait.toBeSaid(8.5), Optional(7.5));
  EXPECT_EQ(wait.toBeSaid(15.5), std::nullopt) << "twice as long as it was is not over yet";
  EXPECT_THAT(wait.toBeSaid(16), Optional(15.0));
}

}  // namespace
}  // namespace hexoderm::cli
