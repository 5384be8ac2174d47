#include "tests/core/robot/links/simulated_links.h"
#include "tests/support/slow_build.h"

#include <gmock/gmock.h>

namespace hexoderm {
namespace {

// links_figures has 100.
constexpr int kSimulatedRobots = test::kSlowBuild ? 1 : 20;

// Sensors of 60 mg, joints off by 0.5 degrees and a base tilted by 1 degree (1 sigma each), three
// patches.
TEST(LinksOnSimulatedRobot, AreRightAndStateHowWellTheyKnow) {
  struct Case {
    std::string name;
    std::size_t poses;
    bool motors;
  };
  for (const Case& c :
       {Case{"still, 4 poses", 4, false}, Case{"still, 8 poses", 8, false}, Case{"motors, 8 poses", 8, true}}) {
    SimulatedLinksOptions options;
    options.poses = c.poses;
    options.motors = c.motors;
    const LinksTally tally = tallySimulatedLinks(options, kSimulatedRobots);
    RecordProperty(c.name, inWords(tally));
    EXPECT_EQ(tally.wrong, 0) << c.name;
    EXPECT_LE(tally.none, 0.01 * tally.patches) << c.name;
    if (test::kSlowBuild) continue;
    EXPECT_GT(meanOf(tally.turn_nees), 0.7) << c.name;
    EXPECT_LT(meanOf(tally.turn_nees), 1.5) << c.name;
    EXPECT_LE(median(tally.errors_rad), 1.2 * median(tally.stated_rad)) << c.name;
    EXPECT_LT(meanOf(tally.zero_nees), 1.8) << c.name;
    EXPECT_LT(meanOf(tally.tilt_nees), 1.8) << c.name;
  }
}

}  // namespace
}  // namespace hexoderm
