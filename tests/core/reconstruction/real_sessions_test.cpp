// Sessions of a real robot's leg, whose boards hold accelerometers. There is no truth for positions.

#include "hexoderm/io/session_json.h"
#include "hexoderm/reconstruction/reconstructor.h"
#include "hexoderm/util/units.h"
#include "tests/support/paths.h"

#include <gtest/gtest.h>

#include <string>

namespace hexoderm {
namespace {

std::shared_ptr<const Reconstruction> solve(const std::string& name) {
  const std::string path = std::string(HEXODERM_REFERENCE_DATA) + "/real/icub_leg/" + name + ".session.json";
  return reconstruct(*readSessionJson(path).snapshot());
}

TEST(RealSessions, TheSameInformationCutIntoMorePosesGetsTheSameVerdict) {
  const Assessment three = solve("three_holds")->assessment;
  const Assessment five = solve("three_holds_cut_into_five")->assessment;
  EXPECT_EQ(three.level, five.level) << three.reason << "\n" << five.reason;
  EXPECT_EQ(three.limit, five.limit);
  EXPECT_EQ(three.remedy, five.remedy);
  EXPECT_NEAR(toDegrees(*three.orientation_95_rad), toDegrees(*five.orientation_95_rad),
              0.2 * toDegrees(*three.orientation_95_rad));
}

TEST(RealSessions, ADeadCellMattersAlikeWhateverItsNumber) {
  const auto origin = solve("dead_cell_is_origin");
  const auto other = solve("dead_cell_is_not_origin");
  EXPECT_EQ(origin->assessment.level, other->assessment.level);
  EXPECT_EQ(origin->assessment.limit, other->assessment.limit);
  EXPECT_EQ(origin->assessment.remedy, other->assessment.remedy);
  EXPECT_NEAR(toDegrees(*origin->assessment.orientation_95_rad), toDegrees(*other->assessment.orientation_95_rad),
              0.01 * toDegrees(*other->assessment.orientation_95_rad));
  EXPECT_NEAR(*origin->assessment.position_95_m, *other->assessment.position_95_m,
              0.01 * *other->assessment.position_95_m);
}

}  // namespace
}  // namespace hexoderm
