// Faults of topology and poses: bad reports and bad sensors become findings, the rest is solved, and nothing is NaN.

#include "hexoderm/base/units.h"
#include "hexoderm/solve/reconstructor.h"
#include "tests/support/changed_session.h"
#include "tests/support/matchers.h"
#include "tests/support/neighbor_lists.h"
#include "tests/support/pin_jointed_skin.h"
#include "tests/support/slow_build.h"
#include "tests/support/solvers.h"
#include "tests/support/testing.h"

namespace hexoderm {
namespace {

/// A finding whose message matches.
template <class T>
auto says(const T& matcher) {
  return Field(&Finding::message, InEnglish(matcher));
}

/// Every fault is one for every solver.
class SkinFaults : public test::EverySolverTest {};

const auto kEverySolver = ::testing::Values(Solver::Global, Solver::Tree);
INSTANTIATE_TEST_SUITE_P(Solvers, SkinFaults, kEverySolver, test::solverOfTest);

/// Cell 3 of X17 lies on an arm: 1 - 2 - 3 - 4 - 5.
constexpr CellId kBad{3};

class BadCell : public test::EverySolverTest {
 protected:
  void expectPlacedThroughLinks(const Session& session, FindingCode code) {
    const auto result = solve(session);
    EXPECT_THAT(*result, IsFinite());
    EXPECT_THAT(*result, HasFinding(code, Field(&Finding::cells, ElementsAre(kBad))));
    ASSERT_THAT(result->patches, SizeIs(1));
    EXPECT_EQ(result->find(kBad).cell->placed_by, PlacedBy::Links);
    // Beyond the bad cell orientations are still measured: the chain is not cut.
    const SE3 T_origin_root = skin_.truth.at(result->patches.front().origin).inverse();
    for (const CellPlacement& cell : result->patches.front().cells) {
      if (cell.cell == kBad) continue;
      EXPECT_THAT(cell.T_o_u.R, RotationNear((T_origin_root * skin_.truth.at(cell.cell)).R, exactOr(0.03 * kDegree)))
          << cell.cell;
      EXPECT_EQ(cell.placed_by, PlacedBy::Samples);
    }
    // The bad cell itself lies between its neighbours: half of each joint's bend is what it can be wrong by.
    EXPECT_THAT(result->find(kBad).cell->T_o_u,
                SE3Near(T_origin_root * skin_.truth.at(kBad), 10 * kDegree, 3 * kMillimetre));
  }

  PinJointedSkin skin_ = bentX17();
  Session session_ = skin_.session(orthogonalUps(4));
};

INSTANTIATE_TEST_SUITE_P(Solvers, BadCell, kEverySolver, test::solverOfTest);

TEST_P(BadCell, WithBadReadingsIsNamedAndPlacedThroughItsLinks) {
  using Change = std::function<void(Eigen::Vector3d&)>;
  const auto always = [](const Eigen::Vector3d& y) { return [y](Eigen::Vector3d& reading) { reading = y; }; };
  const auto always_along = [](Eigen::Index axis) {
    return [axis](Eigen::Vector3d& reading) { reading[axis] = 0.03; };
  };
  const std::vector<std::pair<FindingCode, Change>> changes = {
      {FindingCode::DeadSensor, always({0.01, -0.02, 0.004})},
      {FindingCode::DeadAxis, always_along(0)},
      {FindingCode::DeadAxis, always_along(1)},
      {FindingCode::DeadAxis, always_along(2)},
      {FindingCode::StuckSensor, always({0.04, -1.02, 0.02})},
      {FindingCode::SaturatedSensor, always({2.0, 0.1, 0.3})},
      {FindingCode::WrongNorm, [](Eigen::Vector3d& reading) { reading *= 1.6; }}};
  for (const auto& [code, change] : changes) {
    SCOPED_TRACE(codeName(code));
    expectPlacedThroughLinks(changed(session_,
                                     [&, change = change](std::size_t, GravitySample& sample) {
                                       if (sample.cell == kBad) change(sample.mean_g);
                                     }),
                             code);
  }
}

TEST_P(BadCell, WithoutAnyReadingIsNamedAndPlacedThroughItsLinks) {
  expectPlacedThroughLinks(withoutReadings(session_, kBad), FindingCode::NoSamples);
}

TEST_P(BadCell, AnAxisAlongWhichGravityDoesNotChangeIsNotDead) {
  const auto expectAlive = [this](const std::vector<double>& angles, double scale) {
    // Gravity goes round the cell's z axis, and its sensor has an offset of three sigma across.
    std::vector<Eigen::Vector3d> ups;
    for (const double angle : angles) {
      ups.push_back(skin_.truth.at(kBad).R * Eigen::Vector3d(0.99 * std::cos(angle), 0.99 * std::sin(angle), -0.14));
    }
    const auto result = solve(changed(skin_.session(ups), [&](std::size_t, GravitySample& sample) {
      if (sample.cell == kBad) sample.mean_g = scale * sample.mean_g + Eigen::Vector3d(0.17, 0, 0);
    }));
    EXPECT_THAT(*result, Not(HasFinding(FindingCode::DeadAxis))) << angles.size() << " poses";
    EXPECT_EQ(result->find(kBad).cell->placed_by, PlacedBy::Samples);
  };
  expectAlive({0.0, 120 * kDegree, 180 * kDegree}, 1);
  std::vector<double> round;
  for (int k = 0; k < 24; ++k) round.push_back(k * 15 * kDegree);
  expectAlive(round, 1.04);
}

TEST_P(BadCell, NoisySensorIsNamedAndTheCellPlacedThroughItsLinks) {
  const Session session = changed(session_, [](std::size_t, GravitySample& sample) {
    const double sigma_g = sample.cell == kBad ? 0.3 : 0.012;
    sample.count = 100;
    sample.cov_g2 = Eigen::Matrix3d::Identity() * sigma_g * sigma_g / sample.count;
  });
  expectPlacedThroughLinks(session, FindingCode::NoisySensor);
}

TEST_P(BadCell, NotANumberIsNoReading) {
  const Session session = changed(session_, [](std::size_t, GravitySample& sample) {
    if (sample.cell == kBad) sample.mean_g.y() = std::numeric_limits<double>::quiet_NaN();
  });
  expectPlacedThroughLinks(session, FindingCode::NoSamples);
  EXPECT_THAT(*solve(session),
              HasFinding(FindingCode::NoSamples,
                         says("The readings of cell 3 are no finite numbers; it is placed through its links. It alone "
                              "connects parts of the patch, whose relative placement is less certain.")));
}

TEST_P(BadCell, NotANumberInOnePoseIsNamedWithIt) {
  const auto result = solve(changed(session_, [](std::size_t pose, GravitySample& sample) {
    if (sample.cell == kBad && pose == 1) sample.mean_g.y() = std::numeric_limits<double>::quiet_NaN();
  }));
  EXPECT_THAT(
      *result,
      HasFinding(FindingCode::MissingSamples,
                 AllOf(says("The reading of cell 3 is no finite number in pose 2; it is placed from the other poses."),
                       Field(&Finding::poses, ElementsAre(PoseId(2))))));
}

TEST_P(SkinFaults, ACellWithoutReadingsAndLinksIsNotSaidToBePlacedThroughThem) {
  for (const bool is_sent : {false, true}) {
    Session session(builtInCellModel("hex-bma150"), {{CellId(1), "", {}}});
    PoseCapture capture{session.nextPoseId(), {}, {}};
    if (is_sent) capture.samples.push_back({CellId(1), {0, std::numeric_limits<double>::quiet_NaN(), 1}});
    session.addPose({std::make_shared<const PoseCapture>(capture)});
    EXPECT_THAT(
        *solve(session),
        HasFinding(FindingCode::NoSamples,
                   says(is_sent ? "The readings of cell 1 are no finite numbers, and no link joins it to another cell."
                                : "Cell 1 delivered no reading in any pose, and no link joins it to another cell.")));
  }
}

TEST_P(SkinFaults, ASnapshotWithACellModelThatMakesNoSenseIsRefused) {
  const Session session = bentX17().session({});
  SessionSnapshot snapshot = *session.snapshot();
  CellModel model = session.model();
  model.bend_sigma_rad = model.twist_sigma_rad = model.yaw_sigma_rad = 0;
  snapshot.model = std::make_shared<const CellModel>(model);
  EXPECT_THAT(messageOf<InvalidArgument>([&] { reconstruct(snapshot, test::by(GetParam())); }),
              HasSubstr("bend_sigma_rad must be above 0"));
}

TEST_P(BadCell, CellWithoutASampleInOnePoseIsPlacedFromTheOthers) {
  const auto result = solve(withCaptures(session_, [](std::size_t pose, PoseCapture& capture) {
    if (pose != 1) return;
    std::erase_if(capture.samples, [](const GravitySample& sample) { return sample.cell == kBad; });
  }));
  EXPECT_THAT(*result, HasFinding(FindingCode::MissingSamples, AllOf(Field(&Finding::cells, ElementsAre(kBad)),
                                                                     Field(&Finding::poses, ElementsAre(PoseId(2))))));
  EXPECT_EQ(result->find(kBad).cell->placed_by, PlacedBy::Samples);
  const SE3 T_origin_root = skin_.truth.at(result->patches.front().origin).inverse();
  // The poses that are left show this cell's offset along one line only, so the priors count for more.
  EXPECT_THAT(result->find(kBad).cell->T_o_u,
              SE3Near(T_origin_root * skin_.truth.at(kBad), exactOr(0.08 * kDegree), exactOr(0.05 * kMillimetre)));
}

TEST_P(SkinFaults, ALeafWithoutReadingsIsPlacedByItsOneLink) {
  const PinJointedSkin skin({{1, 1, 2, 4, 0.2, 0, 0}, {2, 1, 3, 4, 0.2, 0, 0}});
  const Session session = changed(skin.session(orthogonalUps(3)), [](std::size_t, GravitySample& sample) {
    if (sample.cell == CellId(3)) sample.mean_g.setZero();
  });
  const auto result = solve(session);
  const CellPlacement* cell = result->find(CellId(3)).cell;
  EXPECT_EQ(cell->placed_by, PlacedBy::Links);
  EXPECT_THAT(*result, IsFinite());
  // Placed straight on, and as uncertain as the elastomer: 30 degrees of bend.
  EXPECT_NEAR(rotationAngle(result->find(CellId(2)).cell->T_o_u.R.transpose() * cell->T_o_u.R), 0, 1e-9);
  EXPECT_GT(std::sqrt(cell->cov_t_r->bottomRightCorner<3, 3>().trace()), 25 * kDegree);
}

TEST_P(SkinFaults, AllCellsDeadIsAFlatSheetAndFails) {
  const Session session =
      changed(bentX17().session(orthogonalUps(3)), [](std::size_t, GravitySample& sample) { sample.mean_g.setZero(); });
  const auto result = solve(session);
  EXPECT_THAT(*result, IsFinite());
  EXPECT_EQ(result->assessment.level, VerdictLevel::Failed);
}

TEST_P(SkinFaults, APartThatMovedIsThePosesFaultNotTheCells) {
  const Session session = changed(bentX17().session(orthogonalUps(3)), [](std::size_t pose, GravitySample& sample) {
    sample.count = 100;
    const double sigma_g = pose == 1 ? 0.4 : 0.012;
    sample.cov_g2 = Eigen::Matrix3d::Identity() * sigma_g * sigma_g / sample.count;
  });
  const auto result = solve(session);
  EXPECT_THAT(*result, HasFinding(FindingCode::PartMoved, Field(&Finding::poses, ElementsAre(PoseId(2)))));
  EXPECT_THAT(*result, Not(HasFinding(FindingCode::NoisySensor)));
}

TEST_P(SkinFaults, SamplesOfUnknownCellsAndDoubledSamplesAreNamed) {
  const Session exact = bentX17().session(orthogonalUps(2));
  const auto result = solve(withCaptures(exact, [](std::size_t pose, PoseCapture& capture) {
    if (pose != 0) return;
    capture.samples.push_back({CellId(99), {0, 0, 1}, Eigen::Matrix3d::Zero(), 0});
    capture.samples.push_back({CellId(5), {1, 0, 0}, Eigen::Matrix3d::Zero(), 0});
  }));
  EXPECT_THAT(*result, HasFinding(FindingCode::SampleOfUnknownCell, Field(&Finding::cells, ElementsAre(CellId(99)))));
  EXPECT_THAT(*result, HasFinding(FindingCode::DuplicateSample));
  EXPECT_THAT(*result, ReconstructionNear(*solve(exact), 1e-12, 1e-12)) << "the first sample counts";
}

TEST_P(SkinFaults, BadReportsAreMutedAndTheRestIsSolved) {
  const PinJointedSkin skin = bentX17();
  const Session exact = skin.session(orthogonalUps(3));
  NeighborList neighbors = exact.neighbors();
  const auto cell = [&](std::uint32_t id) -> CellReport& {
    return *std::ranges::find(neighbors, CellId(id), &CellReport::id);
  };
  // Cell 17's side of its only link is gone; 9 reports itself; 13 an unknown port; 5 a cell that was never found.
  cell(17).neighbors.clear();
  cell(9).neighbors.push_back({PortNumber(2), CellId(9), PortNumber(3)});
  cell(13).neighbors.push_back({PortNumber(7), CellId(12), PortNumber(1)});
  cell(5).neighbors.push_back({PortNumber(3), CellId(77), PortNumber(1)});
  cell(4).body_part = "hand";
  neighbors.push_back(neighbors.front());
  const auto result = solve(withNeighbors(exact, neighbors));
  for (const FindingCode code : {FindingCode::OneSidedLink, FindingCode::SelfLink, FindingCode::UnknownPort,
                                 FindingCode::UnknownCell, FindingCode::DuplicateCell}) {
    EXPECT_THAT(*result, HasFinding(code));
  }
  ASSERT_THAT(result->patches, SizeIs(2));
  EXPECT_THAT(result->patches[0].cells, SizeIs(16));
  EXPECT_THAT(result->patches[1].cells, SizeIs(1));
  EXPECT_EQ(result->find(CellId(4)).cell->body_part, "hand");
  const LinkEstimate* muted = result->findLink({CellId(16), PortNumber(3)}, {CellId(17), PortNumber(2)});
  ASSERT_NE(muted, nullptr) << "a muted link is still shown";
  EXPECT_FALSE(muted->used);
  EXPECT_EQ(muted->muted_by, FindingCode::OneSidedLink);
  EXPECT_THAT(*result, IsFinite());
}

TEST_P(SkinFaults, ALinkSetAsideByHandIsNotUsedAndSplitsThePatch) {
  Session session = bentX17().session(orthogonalUps(4));
  const LinkEnd a{CellId(3), PortNumber(1)};
  const LinkEnd b{CellId(4), PortNumber(4)};
  NeighborList without = session.neighbors();
  for (CellReport& report : without) {
    std::erase_if(report.neighbors, [&](const NeighborReport& n) {
      return (report.id == a.cell && n.port == a.port) || (report.id == b.cell && n.port == b.port);
    });
  }
  const auto expected = solve(withNeighbors(session, without));
  session.setLinkMuted(b, a, true, "a cable");
  const auto result = solve(session);

  ASSERT_THAT(expected->patches, SizeIs(2));
  EXPECT_THAT(*result, ReconstructionNear(*expected, 1e-12, 1e-12));
  const LinkEstimate* link = result->findLink(a, b);
  ASSERT_NE(link, nullptr);
  EXPECT_FALSE(link->used);
  EXPECT_FALSE(link->in_tree);
  EXPECT_EQ(link->muted_by, FindingCode::LinkSetAside);
  EXPECT_THAT(
      *result,
      HasFinding(FindingCode::LinkSetAside,
                 AllOf(Field(&Finding::cells, ElementsAre(CellId(3), CellId(4))),
                       Field(&Finding::ports, ElementsAre(PortNumber(1), PortNumber(4))),
                       says(saysAll("link 3 port 1 - 4 port 4", "by hand (a cable)", "the patch is split there.")))));
  session.setLinkMuted(a, b, false);
  EXPECT_THAT(solve(session)->patches, SizeIs(1));
}

TEST_P(SkinFaults, ALinkSetAsideThatIsNotThereIsSaidAndChangesNothing) {
  Session session = bentX17().session(orthogonalUps(4));
  session.setLinkMuted({CellId(3), PortNumber(4)}, {CellId(99), PortNumber(1)}, true);
  const auto result = solve(session);
  EXPECT_THAT(result->patches, SizeIs(1));
  EXPECT_THAT(*result, HasFinding(FindingCode::LinkSetAside, says(HasSubstr("no such link"))));
}

TEST_P(SkinFaults, ACableIsMutedByItsBendAndSplitsThePatch) {
  PinJointedSkin skin({{1, 1, 2, 4, 0.2, 0, 0}, {2, 1, 3, 4, 100 * kDegree, 0, 0}, {3, 1, 4, 4, 0.2, 0, 0}});
  const auto result = solve(skin.session(orthogonalUps(4)));
  EXPECT_THAT(*result,
              HasFinding(FindingCode::ImplausibleBend, Field(&Finding::cells, ElementsAre(CellId(2), CellId(3)))));
  ASSERT_THAT(result->patches, SizeIs(2));
  EXPECT_EQ(result->assessment.level, VerdictLevel::Usable);
}

TEST_P(SkinFaults, AJointThatTurnedBetweenPosesIsFoundByItsResidualAndMuted) {
  const PinJointedSkin skin = bentX17();
  // Cells 4 and 5, the end of an arm, are on another body part that turns by 50 degrees in poses 3 and 4.
  const Session session = changed(skin.session(orthogonalUps(4)), [&](std::size_t pose, GravitySample& sample) {
    if (sample.cell != CellId(4) && sample.cell != CellId(5)) return;
    const Eigen::Matrix3d& R = skin.truth.at(sample.cell).R;
    const Eigen::Matrix3d turn = expSO3(Eigen::Vector3d(pose >= 2 ? 50 * kDegree : 0, 0, 0));
    sample.mean_g = (R.transpose() * turn * R * sample.mean_g).eval();
  });
  const auto result = solve(session);
  EXPECT_THAT(*result,
              HasFinding(FindingCode::LinkNotRigid, Field(&Finding::cells, ElementsAre(CellId(3), CellId(4)))));
  EXPECT_THAT(result->patches, SizeIs(2));
  EXPECT_EQ(std::ranges::count(result->findings, FindingCode::LinkNotRigid, &Finding::code), 1);
}

TEST_P(SkinFaults, APoseInWhichCellsContradictEachOtherIsLeftOutNotTheCells) {
  // Readings as of a part that is turned while its cells are read one after the other.
  const PinJointedSkin skin = bentX17();
  const Session session = changed(skin.session(orthogonalUps(6)), [](std::size_t pose, GravitySample& sample) {
    if (pose != 3) return;
    const double turn = 8 * kDegree * std::sin(2.0 * sample.cell.value());
    sample.mean_g = expSO3(turn * Eigen::Vector3d(0.6, 0.64, 0.48)) * sample.mean_g;
  });
  const auto result = solve(session);
  EXPECT_THAT(*result, HasFinding(FindingCode::InconsistentPose, Field(&Finding::poses, ElementsAre(PoseId(4)))));
  EXPECT_THAT(result->patches, SizeIs(1));
  EXPECT_THAT(*result, Not(HasFinding(FindingCode::LinkNotRigid)));
  EXPECT_THAT(*result, Not(HasFinding(FindingCode::InconsistentSensor)));
}

TEST_P(SkinFaults, TensOfThousandsOfCellsWithSixPosesWork) {
  // A flat sheet of rhombic lattice: 250 rows of 400 cells for the tree and 50 for the global solver, all links 1-4 and
  // 2-3.
  const bool global = GetParam() == Solver::Global;
  const std::uint32_t fast_rows = global ? 50 : 250;
  const std::uint32_t rows = test::kSlowBuild ? 12 : fast_rows;
  const std::uint32_t columns = test::kSlowBuild ? 20 : 400;
  CellModel model = builtInCellModel("hex-bma150");
  model.interface_id = CellId(rows * columns + 1);
  const NeighborList neighbors = test::listOfSheet(rows, columns);
  Session session(model, neighbors);
  for (const Eigen::Vector3d& up : orthogonalUps(6)) {
    PoseCapture pose{session.nextPoseId(), {}, {}};
    for (const CellReport& report : neighbors) pose.samples.push_back({report.id, up, Eigen::Matrix3d::Zero(), 0});
    session.addPose({std::make_shared<const PoseCapture>(std::move(pose)), false});
  }
  const auto result = solve(session);
  ASSERT_THAT(result->patches, SizeIs(1));
  EXPECT_EQ(result->cellCount(), rows * columns);
  const CellPlacement* corner = result->find(CellId(rows * columns)).cell;
  const CellPlacement* first = result->find(CellId(1)).cell;
  const Eigen::Vector3d expected =
      (columns - 1.0) * Eigen::Vector3d(0.024, 0.014, 0) + (rows - 1.0) * Eigen::Vector3d(0.024, -0.014, 0);
  EXPECT_THAT(corner->T_o_u.t - first->T_o_u.t, VectorNear(expected, 1e-9));
}

}  // namespace
}  // namespace hexoderm
