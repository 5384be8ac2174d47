#include "hexoderm/solve/checks/calibration_check.h"

#include "hexoderm/base/units.h"
#include "hexoderm/solve/reconstructor.h"
#include "tests/support/changed_session.h"
#include "tests/support/matchers.h"
#include "tests/support/pin_jointed_skin.h"
#include "tests/support/simulated_skins.h"
#include "tests/support/solvers.h"
#include "tests/support/testing.h"

namespace hexoderm {

void PrintTo(CellChange change, std::ostream* out) { *out << cellChangeName(change); }

namespace {

using ::testing::Lt;

using Ups = std::vector<Eigen::Vector3d>;

/// Two directions that no pose of the calibration had.
const Ups kToday = {Eigen::Vector3d(1, 1, 0.2).normalized(), Eigen::Vector3d(-0.3, 0.5, 1).normalized()};

std::shared_ptr<const Reconstruction> calibrated(const PinJointedSkin& skin, std::size_t poses = 6,
                                                 const SolverOptions& options = {}) {
  return reconstruct(*skin.session(orthogonalUps(poses)).snapshot(), options);
}

PinJointedSkin turned(PinJointedSkin skin, CellId cell, const Eigen::Vector3d& turn_u) {
  skin.truth.at(cell).R = skin.truth.at(cell).R * expSO3(turn_u);
  return skin;
}

CalibrationCheck check(const Reconstruction& calibration, const Session& today) {
  return checkCalibration(calibration, *today.snapshot());
}

const CheckedCell& cellOf(const CalibrationCheck& check, CellId cell) {
  return *std::ranges::find(check.cells, cell, &CheckedCell::cell);
}

std::vector<CellId> changedCells(const CalibrationCheck& check) {
  std::vector<CellId> cells;
  for (const CheckedCell& cell : check.cells) {
    if (cell.change != CellChange::None) cells.push_back(cell.cell);
  }
  return cells;
}

class CalibratedX17 : public ::testing::Test {
 protected:
  const PinJointedSkin skin = bentX17();
  const std::shared_ptr<const Reconstruction> calibration = calibrated(skin);
};

TEST_F(CalibratedX17, ExactReadingsOfTheSameSkinAreAsCalibratedHoweverThePartIsHeld) {
  const CalibrationCheck result = check(*calibration, skin.session(kToday));
  ASSERT_THAT(result.cells, SizeIs(17));
  EXPECT_THAT(result.cells, Each(AllOf(Field(&CheckedCell::change, CellChange::None),
                                       Field(&CheckedCell::deviate, Lt(0.0)), Field(&CheckedCell::poses, 2U))));
  for (const CheckedCell& cell : result.cells) {
    ASSERT_TRUE(cell.noticed_turn_rad) << cell.cell;
    EXPECT_LT(*cell.noticed_turn_rad, 10 * kDegree) << cell.cell;
  }
  EXPECT_FALSE(result.changed);
  EXPECT_TRUE(result.compared);
  EXPECT_EQ(result.summary.english(), "All 17 cells are as calibrated, as far as these poses show.");
  EXPECT_EQ(result.advice.english(), "The calibration still holds: it can be used as before.");
  // All cells turned alike: the part sits otherwise on the robot.
  const Eigen::Matrix3d R = expSO3({0.4, 1.2, -0.7});
  EXPECT_THAT(changedCells(check(*calibration, skin.session({R * kToday[0], R * kToday[1]}))), IsEmpty());
}

TEST_F(CalibratedX17, ATurnedCellIsNamedWithItsAngle) {
  const auto checkTurned = [&](double angle_rad) {
    const Eigen::Vector3d axis = Eigen::Vector3d(1, 2, -1).normalized();
    return check(*calibration, turned(skin, CellId(8), angle_rad * axis).session(kToday));
  };
  for (const double angle_rad : {90 * kDegree, 170 * kDegree}) {
    const CheckedCell cell = cellOf(checkTurned(angle_rad), CellId(8));
    EXPECT_EQ(cell.change, CellChange::Turned);
    EXPECT_NEAR(cell.turn.value().angle_rad, angle_rad, 0.1 * kDegree);
  }
  const CalibrationCheck result = checkTurned(10 * kDegree);
  EXPECT_THAT(changedCells(result), ElementsAre(CellId(8)));
  EXPECT_TRUE(result.changed);
  const CheckedCell& cell = cellOf(result, CellId(8));
  EXPECT_EQ(cell.change, CellChange::Turned);
  ASSERT_TRUE(cell.turn);
  EXPECT_NEAR(cell.turn->angle_rad, 10 * kDegree, 0.1 * kDegree);
  EXPECT_FALSE(cell.turn->at_least);
  EXPECT_LT(cell.turn->sigma_rad, 1.5 * kDegree);
  EXPECT_THAT(cell.words.english(), HasSubstr("turned by 10.0° +- "));
  EXPECT_EQ(result.summary.english(), "Not as calibrated: cell 8.");
  EXPECT_EQ(result.advice.english(),
            "A cell that turned came loose or was fixed anew: see that it sits firmly, then calibrate anew.");
}

TEST_F(CalibratedX17, TheOriginIsACellLikeAnyOther) {
  const CellId origin = calibration->patches.front().origin;
  const CalibrationCheck result = check(*calibration, turned(skin, origin, {0, 0.3, 0.2}).session(kToday));
  EXPECT_THAT(changedCells(result), ElementsAre(origin));
}

TEST_F(CalibratedX17, ADriftOfAnOffsetIsToldFromATurnWhereThePosesAllowIt) {
  const Eigen::Matrix3d R_o_u = skin.truth.at(CellId(5)).R;
  const auto drifted = [&](const Eigen::Vector3d& drift_g) {
    return changed(skin.session(kToday), [&](std::size_t, GravitySample& sample) {
      if (sample.cell == CellId(5)) sample.mean_g += drift_g;
    });
  };
  const Eigen::Vector3d along = R_o_u.transpose() * (0.06 * (kToday[0] + kToday[1]).normalized());
  const CheckedCell cell = cellOf(check(*calibration, drifted(along)), CellId(5));
  EXPECT_EQ(cell.change, CellChange::Drifted);
  ASSERT_TRUE(cell.drift);
  EXPECT_THAT(cell.drift->offset_g, VectorNear(along, 0.003));
  EXPECT_THAT(cell.words.english(), HasSubstr("its sensor's offset drifted by 60 mg"));
  // Across gravity in both poses it is what a turn by 4.9 degrees reads.
  const Eigen::Vector3d across = R_o_u.transpose() * (0.06 * kToday[0].cross(kToday[1]).normalized());
  const CalibrationCheck with_either = check(*calibration, drifted(across));
  EXPECT_THAT(with_either.advice.english(), HasSubstr("Another pose, with the part turned by 45° or more"));
  const CheckedCell either = cellOf(with_either, CellId(5));
  EXPECT_EQ(either.change, CellChange::TurnedOrDrifted);
  ASSERT_TRUE(either.turn && either.drift);
  EXPECT_NEAR(either.drift->offset_g.norm(), 0.06, 0.003);
  EXPECT_NEAR(toDegrees(either.turn->angle_rad), 4.9, 1.5);
  EXPECT_THAT(either.words.english(), AllOf(HasSubstr("turned by"), HasSubstr("offset drifted by 60 mg"),
                                            HasSubstr("these poses can't tell which")));
}

TEST_F(CalibratedX17, OffsetsThatDriftedTogetherAreARemarkAndNoChange) {
  const auto drifted = [&](const Eigen::Vector3d& drift_g, const std::function<bool(CellId)>& of) {
    return check(*calibration, changed(skin.session(kToday), [&](std::size_t, GravitySample& sample) {
      if (of(sample.cell)) sample.mean_g += drift_g;
    }));
  };
  const Eigen::Vector3d drift_g(0.020, -0.010, 0.020);
  const CalibrationCheck all = drifted(drift_g, [](CellId) { return true; });
  EXPECT_FALSE(all.changed);
  EXPECT_EQ(all.count(CellChange::None), 17U);
  ASSERT_THAT(all.remarks, SizeIs(1));
  EXPECT_THAT(all.remarks.front().english(), HasSubstr("The offsets of all sensors drifted together by "));
  // Every other one drifted by no more than chips do by themselves.
  const CalibrationCheck some = drifted(drift_g / 4, [](CellId cell) { return cell.value() % 2 == 0; });
  EXPECT_FALSE(some.changed);
  EXPECT_EQ(some.summary.english(), "All 17 cells are as calibrated, as far as these poses show.");
}

TEST_F(CalibratedX17, OnePoseShowsSomeChangesAndSaysWhatItDoesNotShow) {
  const Ups up = {kToday[0]};
  const Eigen::Matrix3d R_u_o = skin.truth.at(CellId(4)).R.transpose();
  const CalibrationCheck same = check(*calibration, skin.session(up));
  EXPECT_FALSE(same.changed);
  EXPECT_THAT(same.summary.english(), HasSubstr("don't show every turn"));
  EXPECT_EQ(same.advice.english(), "As far as it could be compared, the calibration still holds.");
  EXPECT_THAT(same.cells, Each(Field(&CheckedCell::noticed_turn_rad, std::optional<double>())));
  const Eigen::Vector3d about_gravity = R_u_o * up[0];
  EXPECT_FALSE(check(*calibration, turned(skin, CellId(4), 0.5 * about_gravity).session(up)).changed);
  const Eigen::Vector3d across = R_u_o * up[0].unitOrthogonal();
  const CalibrationCheck tilted = check(*calibration, turned(skin, CellId(4), 10 * kDegree * across).session(up));
  EXPECT_THAT(changedCells(tilted), ElementsAre(CellId(4)));
  EXPECT_THAT(tilted.advice.english(),
              AllOf(HasSubstr("came loose"), HasSubstr("offset drifted"), Not(HasSubstr("Another pose"))))
      << "the summary asks for it";
  const CheckedCell& cell = cellOf(tilted, CellId(4));
  EXPECT_EQ(cell.change, CellChange::TurnedOrDrifted) << "one reading is as well explained by an offset";
  ASSERT_TRUE(cell.turn);
  EXPECT_NEAR(cell.turn->angle_rad, 10 * kDegree, 0.3 * kDegree);
  EXPECT_TRUE(cell.turn->at_least);
  EXPECT_THAT(cell.words.english(), HasSubstr("or more"));
}

TEST_F(CalibratedX17, ASensorThatReadsNoGravityIsBroken) {
  const Session today = skin.session(kToday);
  const auto of = [&](const Session& session) {
    const CalibrationCheck result = check(*calibration, session);
    EXPECT_THAT(changedCells(result), ElementsAre(CellId(3)));
    EXPECT_EQ(cellOf(result, CellId(3)).change, CellChange::Broken);
    EXPECT_TRUE(result.changed);
    EXPECT_THAT(result.advice.english(), HasSubstr("Check the sensor, plug and cable"));
    return cellOf(result, CellId(3)).words.english();
  };
  const auto reading = [&](const auto& read) {
    return of(changed(today, [&](std::size_t, GravitySample& sample) {
      if (sample.cell == CellId(3)) sample.mean_g = read(sample.mean_g);
    }));
  };
  EXPECT_EQ(of(withoutReadings(today, CellId(3))), "dead: it sends no reading");
  EXPECT_EQ(reading([](const Eigen::Vector3d&) { return Eigen::Vector3d(0.01, 0, -0.02); }),
            "dead: it reads no gravity");
  EXPECT_EQ(reading([](const Eigen::Vector3d&) { return Eigen::Vector3d(0.6, 0.1, 0.8); }),
            "dead: it reads the same in all poses");
  EXPECT_EQ(reading([](const Eigen::Vector3d& y) -> Eigen::Vector3d { return 3 * y; }),
            "broken: it reads the end of its range");
  EXPECT_THAT(reading([](const Eigen::Vector3d& y) -> Eigen::Vector3d {
                return {-y.x(), y.y(), 0.4 * y.z()};
              }),
              HasSubstr("neither a turn nor a drift"));
}

TEST_F(CalibratedX17, ACellThatIsGoneIsNamedAndALinkThatIsGoneToo) {
  PinJointedSkin rest = skin;
  rest.truth.erase(CellId(5));  // the end of an arm
  std::erase_if(rest.neighbors.at(CellId(4)), [](const NeighborReport& n) { return n.cell == CellId(5); });
  const CalibrationCheck result = check(*calibration, rest.session(kToday));
  EXPECT_THAT(changedCells(result), ElementsAre(CellId(5)));
  EXPECT_EQ(cellOf(result, CellId(5)).words.english(), "gone: it is no longer among the skin's cells");
  EXPECT_TRUE(result.changed);

  PinJointedSkin unplugged = skin;
  std::erase_if(unplugged.neighbors.at(CellId(4)), [](const NeighborReport& n) { return n.cell == CellId(5); });
  std::erase_if(unplugged.neighbors.at(CellId(5)), [](const NeighborReport& n) { return n.cell == CellId(4); });
  const CalibrationCheck without_link = check(*calibration, unplugged.session(kToday));
  EXPECT_THAT(changedCells(without_link), IsEmpty()) << "how the cells are turned does not hang on their links";
  EXPECT_TRUE(without_link.changed);
  ASSERT_THAT(without_link.remarks, SizeIs(1));
  EXPECT_THAT(without_link.remarks.front().english(), HasSubstr("4 port"));
  EXPECT_EQ(without_link.advice.english(), "See that the cells are still joined where a link is no longer reported.");
}

TEST_F(CalibratedX17, AnotherSkinIsRefusedWithWhatDiffers) {
  const auto complaint = [&](const Session& today) {
    return messageOf<InvalidArgument>([&] { check(*calibration, today); });
  };
  PinJointedSkin more = skin;
  more.truth[CellId(40)] = SE3();
  EXPECT_THAT(complaint(more.session(kToday)), saysAll("another skin", "cell 40"));
  PinJointedSkin rewired = skin;
  for (auto& [cell, reports] : rewired.neighbors) {
    for (NeighborReport& report : reports) {
      if (cell == CellId(5)) report.port = PortNumber(report.port.value() == 1 ? 2 : 1);
      if (report.cell == CellId(5)) report.cell_port = PortNumber(report.cell_port->value() == 1 ? 2 : 1);
    }
  }
  EXPECT_THAT(complaint(rewired.session(kToday)), saysAll("joined otherwise", "link 4 port 1 - 5 port 1"));
  PinJointedSkin few = skin;
  std::erase_if(few.truth, [](const auto& cell) { return cell.first > CellId(7); });
  EXPECT_THAT(complaint(few.session(kToday)), saysAll("10 of its 17 cells are not there"));
  PinJointedSkin larger = skin;
  for (Port& port : larger.model.ports) port.vector_m *= 1.5;
  EXPECT_THAT(complaint(larger.session(kToday)), saysAll("another kind of cell", "port 1", "hex-bma150"));
}

TEST_F(CalibratedX17, NeedsPosesAndACalibrationThatWasMadeOfPoses) {
  EXPECT_THAT(messageOf<InvalidArgument>([&] { check(*calibration, skin.session({})); }), HasSubstr("no pose"));
  Session today = turned(skin, CellId(8), {0.5, 0.5, 0}).session(kToday);
  today.setPoseDisabled(0, true);
  today.setPoseDisabled(1, true);
  EXPECT_THAT(messageOf<InvalidArgument>([&] { check(*calibration, today); }), HasSubstr("no pose"));
  today.setPoseDisabled(1, false);
  EXPECT_EQ(check(*calibration, today).poses, std::vector{PoseId(2)});
  Reconstruction imported = *calibration;
  imported.solver = "imported";
  EXPECT_THAT(messageOf<InvalidArgument>([&] { check(imported, skin.session(kToday)); }), HasSubstr("imported"));
}

TEST(CalibrationCheck, WhereNoMajorityAgreesNoCellIsNamed) {
  const PinJointedSkin pair({{1, 1, 2, 4, 0.3, 0.02, 0.01}});
  const auto calibration = calibrated(pair);
  EXPECT_FALSE(check(*calibration, pair.session(kToday)).changed);
  const CalibrationCheck result = check(*calibration, turned(pair, CellId(2), {0.4, 0.4, 0}).session(kToday));
  EXPECT_TRUE(result.changed);
  EXPECT_THAT(result.cells, Each(Field(&CheckedCell::change, CellChange::NotTold)));
  EXPECT_THAT(result.summary.english(), HasSubstr("contradict each other"));
  EXPECT_TRUE(result.advice.empty()) << "the summary says what to do";

  PinJointedSkin skin = bentX17();
  const auto whole = calibrated(skin);
  std::mt19937 random(1);
  std::uniform_real_distribution<double> any(-2, 2);
  for (auto& [cell, T] : skin.truth) T.R = T.R * expSO3({any(random), any(random), any(random)});
  const CalibrationCheck shuffled = check(*whole, skin.session(kToday));
  EXPECT_TRUE(shuffled.changed);
  EXPECT_EQ(shuffled.count(CellChange::None), 0U);
}

TEST(CalibrationCheck, ACellAloneTellsNothing) {
  const PinJointedSkin pair({{1, 1, 2, 4, 0.3, 0.02, 0.01}});
  const auto calibration = calibrated(pair);
  const CalibrationCheck result = check(*calibration, withoutReadings(pair.session(kToday), CellId(2)));
  EXPECT_EQ(cellOf(result, CellId(1)).change, CellChange::NotTold);
  EXPECT_EQ(cellOf(result, CellId(2)).change, CellChange::Broken);
  EXPECT_THAT(result.summary.english(), HasSubstr("Not as calibrated: cell 2."));
  Session silent = pair.session(kToday);
  for (const CellId cell : {CellId(1), CellId(2)}) silent = withoutReadings(silent, cell);
  EXPECT_TRUE(check(*calibration, silent).changed) << "both are dead";
}

TEST(CalibrationCheck, ACellThatWasPlacedByItsLinksIsCheckedAsFarAsItIsKnown) {
  const PinJointedSkin skin = bentX17();
  const auto calibration = reconstruct(*withoutReadings(skin.session(orthogonalUps(6)), CellId(5)).snapshot());
  const CheckedCell silent = cellOf(check(*calibration, withoutReadings(skin.session(kToday), CellId(5))), CellId(5));
  EXPECT_EQ(silent.change, CellChange::NotTold);
  EXPECT_THAT(silent.words.english(), HasSubstr("as when it was calibrated"));
  const CalibrationCheck heard = check(*calibration, skin.session(kToday));
  EXPECT_FALSE(heard.changed);
  EXPECT_TRUE(heard.compared);
  EXPECT_GT(cellOf(heard, CellId(5)).noticed_turn_rad.value_or(kPi), 15 * kDegree);
  EXPECT_LT(cellOf(heard, CellId(4)).noticed_turn_rad.value_or(kPi), 10 * kDegree);
}

TEST(CalibrationCheck, ACalibrationThatIsTooUncertainTellsNothingAndSaysSo) {
  PinJointedSkin skin = bentX17();
  skin.model.accelerometer.offset_sigma_g.setConstant(0.3);
  const CalibrationCheck result = check(*calibrated(skin, 2, test::by(Solver::Tree)), skin.session({kToday[0]}));
  EXPECT_FALSE(result.changed);
  EXPECT_FALSE(result.compared);
  EXPECT_THAT(result.cells, Each(Field(&CheckedCell::change, CellChange::NotTold)));
  EXPECT_THAT(result.summary.english(), HasSubstr("Nothing can be told of any cell"));
  EXPECT_THAT(result.advice.english(), HasSubstr("three poses or more"));
}

TEST_F(CalibratedX17, ACellThatTurnedBetweenThePosesIsNamedAndTheLaterPosesTellHow) {
  const Session after = turned(skin, CellId(8), 20 * kDegree * Eigen::Vector3d(1, 2, -1).normalized()).session(kToday);
  Session all = skin.session(orthogonalUps(4));
  for (const SessionPose& pose : after.poses()) {
    PoseCapture capture = *pose.capture;
    capture.id = all.nextPoseId();
    all.addPose({std::make_shared<const PoseCapture>(std::move(capture))});
  }
  const CalibrationCheck mixed = check(*calibration, all);
  EXPECT_THAT(changedCells(mixed), ElementsAre(CellId(8)));
  EXPECT_EQ(cellOf(mixed, CellId(8)).change, CellChange::Broken);
  EXPECT_THAT(mixed.advice.english(), HasSubstr("compare only those that were taken since"));
  for (std::size_t k = 0; k < 4; ++k) all.setPoseDisabled(k, true);
  EXPECT_EQ(cellOf(check(*calibration, all), CellId(8)).change, CellChange::Turned);
}

TEST_F(CalibratedX17, TheOrderOfPosesAndReadingsDoesNotMatter) {
  const PinJointedSkin today = turned(skin, CellId(8), {0.1, 0.1, 0});
  const CalibrationCheck one = check(*calibration, today.session(kToday));
  const Session reversed = withCaptures(today.session({kToday[1], kToday[0]}), [](std::size_t, PoseCapture& capture) {
    std::ranges::reverse(capture.samples);
  });
  const CalibrationCheck other = check(*calibration, reversed);
  for (std::size_t k = 0; k < one.cells.size(); ++k) {
    EXPECT_EQ(one.cells[k].change, other.cells[k].change);
    EXPECT_NEAR(one.cells[k].deviate, other.cells[k].deviate, 1e-6);
  }
}

TEST(CalibrationCheck, ManyMayChangeAtOnce) {
  PinJointedSkin skin = bentX17();
  const auto calibration = calibrated(skin);
  const std::vector<CellId> changed = {CellId(2), CellId(6), CellId(7), CellId(11), CellId(12), CellId(16)};
  for (const CellId cell : changed) {
    skin = turned(skin, cell, 10 * kDegree * Eigen::Vector3d(cell.value() % 3, 1, cell.value() % 2).normalized());
  }
  const CalibrationCheck result = check(*calibration, skin.session(kToday));
  EXPECT_EQ(changedCells(result), changed);
  EXPECT_THAT(result.summary.english(), HasSubstr("should be calibrated anew"));
  EXPECT_TRUE(result.advice.empty()) << "the summary says what to do";
}

TEST_F(CalibratedX17, ACalibrationByTheTreeHoldsNoOffsetsAndShowsLess) {
  const auto by_tree = calibrated(skin, 4, test::by(Solver::Tree));
  const CalibrationCheck same = check(*by_tree, skin.session(kToday));
  EXPECT_FALSE(same.changed);
  EXPECT_GT(cellOf(same, CellId(8)).noticed_turn_rad.value_or(kPi),
            2 * *cellOf(check(*calibration, skin.session(kToday)), CellId(8)).noticed_turn_rad);
  EXPECT_THAT(changedCells(check(*by_tree, turned(skin, CellId(8), {0, 1.2, 0.9}).session(kToday))),
              ElementsAre(CellId(8)));
}

/// Of a simulated skin, calibrated in four poses before cells are reglued and offsets drift.
CalibrationCheck simulatedCheck(SimulatedSkinOptions options) {
  options.reglued_before = 4;
  options.drifts_after = 4;
  SimulatedSkin skin = test::simulatedSkin(options);
  const auto calibration = reconstruct(*simulateSession(skin, options.reglued_before).snapshot());
  Session today = beginSimulatedSession(skin);
  for (const Eigen::Vector3d& up : kToday) {
    today.addPose({std::make_shared<const PoseCapture>(averageFrames(skin.record(up), today.nextPoseId(), {}))});
  }
  return check(*calibration, today);
}

// How many are found, with which error, and how many healthy cells are blamed: `hexoderm-reproduce --only check`
// counts it on hundreds of skins in a hand.
TEST(CalibrationCheck, NamesTheRegluedCellOfASimulatedSkinAndNoOther) {
  for (const bool hand_held : {false, true}) {
    for (std::uint64_t seed = 1; seed <= 3; ++seed) {
      const CellId reglued(static_cast<std::uint32_t>(1 + seed % 17));
      SimulatedSkinOptions options = test::skinOptions("x17", "", seed);
      options.hand_held = hand_held;
      options.faults = {{SkinFault::Reglued, reglued}};
      EXPECT_THAT(changedCells(simulatedCheck(options)), ElementsAre(reglued)) << "seed " << seed;
    }
  }
}

TEST(CalibrationCheck, BlamesHardlyAnyHealthyCellOnARobotThatVibrates) {
  SimulatedSkinOptions options = SimulatedSkinOptions::robot();
  std::size_t blamed = 0;
  for (options.seed = 101; options.seed <= 160; ++options.seed) {
    const CalibrationCheck result = simulatedCheck(options);
    ASSERT_THAT(result.cells, SizeIs(17));
    blamed += 17 - result.count(CellChange::None) - result.count(CellChange::NotTold);
  }
  EXPECT_LE(blamed, 2U);
}

}  // namespace
}  // namespace hexoderm
