#include "hexoderm/session/session.h"

#include "tests/support/options.h"
#include "tests/support/testing.h"

namespace hexoderm {
namespace {

SessionPose pose(std::uint32_t id) {
  return {std::make_shared<const PoseCapture>(PoseCapture{PoseId(id), {}, {}}), false};
}

Session emptySession() { return {builtInCellModel("hex-bma150"), {{CellId(1), "", {}}}}; }

TEST(Session, RefusesACellModelThatMakesNoSense) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const std::pair<std::string, std::function<void(CellModel&)>> faults[] = {
      {"name must not be empty", [](CellModel& model) { model = {}; }},
      {"interface_id must be above 0", [](CellModel& model) { model.interface_id = {}; }},
      {"side_m must be from", [&](CellModel& model) { model.side_m = nan; }},
      {"port 2: vector_m must point", [&](CellModel& model) { model.ports.at(1).vector_m.x() = nan; }},
      {"bend_sigma_rad must be above 0", [](CellModel& model) { model.bend_sigma_rad = 0; }},
      {"yaw_sigma_rad must be above 0", [&](CellModel& model) { model.yaw_sigma_rad = nan; }},
      {"accelerometer.offset_sigma_g must not be negative",
       [](CellModel& model) { model.accelerometer.offset_sigma_g.z() = -1; }},
      {"accelerometer.R_u must be a rotation", [&](CellModel& model) { model.accelerometer.T_u_a.R(0, 0) = nan; }},
  };
  Session session = emptySession();
  const auto before = session.snapshot();
  for (const auto& [words, spoil] : faults) {
    CellModel model = builtInCellModel("hex-bma150");
    spoil(model);
    EXPECT_THAT(test::messageOf<InvalidArgument>([&] { Session made(model, {}); }), testing::HasSubstr(words));
    EXPECT_THAT(test::messageOf<InvalidArgument>([&] { session.setSkin(model, {}); }), testing::HasSubstr(words));
  }
  EXPECT_EQ(session.snapshot()->model, before->model);
  EXPECT_EQ(session.revision(), before->revision);
}

TEST(Session, APoseIsDisabledForAReasonAsLongAsItIsDisabled) {
  Session session = emptySession();
  session.addPose(pose(1));
  session.setPoseDisabled(0, true, "the arm moved");
  EXPECT_EQ(session.poses()[0].why_disabled, "the arm moved");
  session.setPoseDisabled(0, false);
  EXPECT_EQ(session.poses()[0].why_disabled, "");
}

TEST(Session, ALinkIsSetAsideInEitherOrderOfItsEndsAndTakenBack) {
  const LinkEnd a{CellId(1), PortNumber(2)};
  const LinkEnd b{CellId(1), PortNumber(3)};
  const LinkEnd c{CellId(2), PortNumber(1)};
  Session session = emptySession();
  session.setLinkMuted(c, b, true, "a cable");
  session.setLinkMuted(a, c, true);
  EXPECT_THAT(session.mutedLinks(), testing::ElementsAre(MutedLink{a, c, ""}, MutedLink{b, c, "a cable"}));
  ASSERT_NE(session.findMutedLink(c, b), nullptr);
  EXPECT_EQ(session.findMutedLink(b, c)->why, "a cable");
  EXPECT_EQ(session.findMutedLink(a, b), nullptr);

  const auto before = session.snapshot();
  session.setLinkMuted(b, c, true, "a joint");
  EXPECT_EQ(session.findMutedLink(b, c)->why, "a joint");
  session.setLinkMuted(b, c, false, "not kept");
  EXPECT_THAT(session.mutedLinks(), testing::ElementsAre(MutedLink{a, c, ""}));
  EXPECT_THAT(before->muted_links, testing::SizeIs(2)) << "a snapshot stays as it was";
  EXPECT_LT(before->revision, session.revision());
  EXPECT_THROW(session.setLinkMuted(a, a, true), InvalidArgument);
}

TEST(Session, ANewSkinLeavesEverythingElse) {
  Session session(builtInCellModel("hex-bma150"), {{CellId(1), "", {}}},
                  {Message::verbatim("an arm"), "arm.hexo", "abc"});
  session.setTruth({"arm", {}});
  for (std::uint32_t id = 1; id <= 3; ++id) session.addPose(pose(id));
  session.setPoseDisabled(0, true, "the arm moved");
  session.removePose(2);
  const auto before = session.snapshot();

  session.setSkin(test::with(builtInCellModel("hex-bma150"), &CellModel::name, "another"),
                  {{CellId(1), "", {}}, {CellId(2), "", {}}});
  const auto after = session.snapshot();
  EXPECT_LT(before->revision, after->revision);
  EXPECT_EQ(before->model->name, "hex-bma150");
  EXPECT_EQ(before->neighbors->size(), 1U);
  EXPECT_EQ(after->model->name, "another");
  EXPECT_EQ(after->neighbors->size(), 2U);
  EXPECT_EQ(session.poses().size(), 2U);
  EXPECT_EQ(session.poses()[0].capture, before->poses[0].capture);
  EXPECT_EQ(session.poses()[0].why_disabled, "the arm moved");
  EXPECT_EQ(session.truth(), before->truth);
  EXPECT_EQ(session.source().text.english(), "an arm");
  EXPECT_EQ(session.nextPoseId(), PoseId(4)) << "the number of a pose that was removed is not used again";
}

}  // namespace
}  // namespace hexoderm
