#include "hexoderm/solve/reconstructor.h"
#include "tests/support/changed_session.h"
#include "tests/support/simulated_skins.h"
#include "tests/support/testing.h"

namespace hexoderm {
namespace {

/// A skin on a cylinder, as its accelerometers read, or with all x and y negated.
Session onCylinder(bool is_mirrored, SkinSide side) {
  const Session fine = test::simulatedSession(test::skinOptions("sheet:5x5", "cylinder:r=0.06"), 4);
  Session session = changed(fine, [&](std::size_t /*pose*/, GravitySample& sample) {
    if (is_mirrored) sample.mean_g.head<2>() *= -1;
  });
  session.setSide(side);
  return session;
}

std::vector<FindingCode> found(bool is_mirrored, SkinSide side) {
  std::vector<FindingCode> codes;
  const auto result = reconstruct(*onCylinder(is_mirrored, side).snapshot());
  for (const Finding& finding : result->findings) codes.push_back(finding.code);
  return codes;
}

TEST(InsideOut, IsAskedWhereTheSessionDoesNotSay) {
  EXPECT_THAT(found(true, SkinSide::Unknown), ElementsAre(FindingCode::InsideOut));
  EXPECT_THAT(found(true, SkinSide::Concave), IsEmpty());
  EXPECT_THAT(found(true, SkinSide::Convex), ElementsAre(FindingCode::ContradictsModel));
  EXPECT_THAT(found(false, SkinSide::Unknown), IsEmpty());
  EXPECT_THAT(found(false, SkinSide::Concave), ElementsAre(FindingCode::ContradictsModel));
}

TEST(InsideOut, SaysNothingOfAFlatSkin) {
  const auto result = reconstruct(*test::simulatedSession(test::skinOptions("sheet:5x5", "plane"), 4).snapshot());
  EXPECT_THAT(result->findings, IsEmpty());
}

}  // namespace
}  // namespace hexoderm
