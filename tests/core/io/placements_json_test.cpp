#include "hexoderm/io/placements_json.h"

#include "tests/support/session_matchers.h"
#include "tests/support/testing.h"

namespace hexoderm {
namespace {

std::vector<PatchOnLink> somePlacements() {
  PatchOnLink a{
      CellId(7), "r_forearm", {rotationFromRpy({0.1, -0.2, 0.3}), {0.1, 1.0 / 3, -2e-5}}, Matrix6d::Identity()};
  (*a.cov_t_r)(0, 4) = (*a.cov_t_r)(4, 0) = 0.25;
  return {a, {CellId(20), "a \"link\"", {}, std::nullopt}};
}

TEST(PlacementsJson, ReadsBackWhatWasWritten) {
  const std::vector<PatchOnLink> before = somePlacements();
  const std::vector<PatchOnLink> after = placementsFromJson(placementsToJson(before), "a.json");
  test::expectSameItems(after, before, test::expectSamePlace);
}

TEST(PlacementsJson, SaysWhatIsWrongAndWhere) {
  const auto says = [](const std::string& from, const std::string& to) {
    const std::string text = replaced(placementsToJson(somePlacements()), from, to);
    return messageOf<FormatError>([&] { placementsFromJson(text, "a.json"); });
  };
  EXPECT_THAT(says("hexoderm-placements", "hexoderm-session"), saysAll("a.json", "hexoderm-placements"));
  EXPECT_THAT(says("\"origin_cell\": 20", "\"origin_cell\": 7"),
              saysAll("placements[1].origin_cell", "each patch once"));
  EXPECT_THAT(says("\"r_forearm\"", "\"\""), saysAll("placements[0].link", "the name of a link"));
  EXPECT_THAT(says("0.25", "7"), saysAll("placements[0].cov_t_r", "a covariance"));
  EXPECT_THAT(says("\"version\": 1", "\"version\": 2"), saysAll("version"));
}

TEST(PlacementsJson, WritesNoNumberThatIsNotFinite) {
  std::vector<PatchOnLink> placements = somePlacements();
  placements[0].T_l_o.t.x() = std::nan("");
  EXPECT_THROW(placementsToJson(placements), InvalidArgument);
}

}  // namespace
}  // namespace hexoderm
