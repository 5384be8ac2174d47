#include "hexoderm/sim/emulated_device.h"

#include "hexoderm/base/units.h"
#include "hexoderm/device/skinwire/codec.h"
#include "hexoderm/device/skinwire/description.h"
#include "hexoderm/sim/simulated_robot.h"
#include "hexoderm/sim/simulated_skin.h"
#include "tests/support/options.h"
#include "tests/support/paths.h"
#include "tests/support/testing.h"

namespace hexoderm {
namespace {

using test::with;
using Messages = EmulatedDevice::Messages;

/// A device and a host that asks and listens, without anything between them.
struct ColdBench {
  explicit ColdBench(SimulatedSkinOptions skin = SimulatedSkinOptions::ideal(), EmulatedDeviceOptions options = {})
      : device(std::make_unique<SimulatedSkin>(builtInCellModel("hex-bma150"), std::move(skin)), std::move(options)) {}
  explicit ColdBench(SimulatedRobot robot, EmulatedDeviceOptions options = {})
      : device(std::make_unique<SimulatedRobot>(std::move(robot)), std::move(options)) {}

  void explore() {
    while (device.isExploring()) device.tick(heard);
  }
  void tick(int count) {
    for (int k = 0; k < count; ++k) device.tick(heard);
  }
  template <class Kind>
  std::vector<Kind> take() {
    std::vector<Kind> found;
    Messages rest;
    for (skinwire::Message& message : heard) {
      EXPECT_TRUE(skinwire::complaint(message).empty());
      if (Kind* kind = std::get_if<Kind>(&message)) {
        found.push_back(std::move(*kind));
      } else {
        rest.push_back(std::move(message));
      }
    }
    heard = std::move(rest);
    return found;
  }

  /// The only one of its kind.
  template <class Kind>
  Kind takeOne() {
    const std::vector<Kind> found = take<Kind>();
    EXPECT_THAT(found, SizeIs(1));
    return found.at(0);
  }
  /// The next samples, as they are read at first.
  SampleFrame nextFrame() {
    take<skinwire::Samples>();
    tick(10);
    SampleFrame frame;
    skinwire::decodeTick(take<skinwire::Samples>().back(), 0, 0.004, frame);
    return frame;
  }
  std::size_t nextCells() { return nextFrame().samples.size(); }
  /// Lets a command that was begun come to its end, which every acknowledgement up to then leads to.
  std::vector<skinwire::Ack> acksUntilItIsDone(int* ticks = nullptr) {
    std::vector<skinwire::Ack> acks;
    for (int count = 1; count < 20'000 && (acks.empty() || acks.back().working); ++count) {
      tick(1);
      std::ranges::move(take<skinwire::Ack>(), std::back_inserter(acks));
      if (ticks != nullptr) *ticks = count;
    }
    return acks;
  }

  EmulatedDevice device;
  Messages heard;
};

/// One that has explored its cells.
struct Bench : ColdBench {
  template <class... Arguments>
  explicit Bench(Arguments&&... arguments) : ColdBench(std::forward<Arguments>(arguments)...) {
    device.greet(heard);
    explore();
  }
};

/// With readings in LSB.
SimulatedSkinOptions quantised() {
  return with(SimulatedSkinOptions::ideal(), &SimulatedSkinOptions::sensor_noise, true);
}

std::size_t samplesIn(const std::vector<skinwire::Samples>& messages) {
  std::size_t count = 0;
  for (const skinwire::Samples& message : messages) count += message.ticks() * message.cells.size();
  return count;
}

TEST(EmulatedDevice, ExploresFirstAndThenDescribesItself) {
  ColdBench bench;
  bench.device.greet(bench.heard);
  EXPECT_THAT(bench.take<skinwire::Topology>(), SizeIs(0));
  const skinwire::Status status = bench.takeOne<skinwire::Status>();
  EXPECT_TRUE(status.exploring);
  const skinwire::Hello hello = bench.takeOne<skinwire::Hello>();
  EXPECT_TRUE(hello.can_turn && hello.can_light_cells);
  EXPECT_EQ(hello.rate_hz, 1000);
  EXPECT_EQ(hello.cell_model, "hex-bma150");

  bench.explore();
  EXPECT_NEAR(bench.device.time_s(), bench.device.exploration().duration_s, 0.001);
  const skinwire::Topology topology = bench.takeOne<skinwire::Topology>();
  EXPECT_EQ(topology.cells, bench.device.exploration().cells);
  EXPECT_THAT(bench.take<skinwire::Samples>(), SizeIs(0));
}

TEST(EmulatedDevice, SendsEverySampleAsTheSkinReadIt) {
  Bench bench(quantised());
  const double began_s = bench.device.time_s();
  bench.tick(100);
  const auto messages = bench.take<skinwire::Samples>();
  EXPECT_THAT(messages, SizeIs(10)) << "ten ticks together";
  EXPECT_THAT(bench.take<skinwire::Joints>(), SizeIs(0)) << "a skin alone has none";
  const GroundTruth truth = bench.device.body().groundTruth();
  SampleFrame frame;
  std::size_t sequence = 0;
  std::size_t ticks = 0;
  for (const skinwire::Samples& message : messages) {
    EXPECT_EQ(message.sequence, sequence);
    sequence += message.ticks() * message.cells.size();
    for (std::size_t tick = 0; tick < message.ticks(); ++tick, ++ticks) {
      skinwire::decodeTick(message, tick, 0.004, frame);
      EXPECT_NEAR(frame.time_s, began_s + static_cast<double>(ticks) / 1000, 1e-9);
      for (std::size_t k = 0; k < frame.samples.size(); ++k) {
        const Eigen::Vector3d up_b = truth.cells[k].T_b_u.R * frame.samples[k].acceleration_g;
        EXPECT_LT((up_b - Eigen::Vector3d::UnitZ()).norm(), 0.15);
      }
    }
  }
  EXPECT_EQ(sequence, 1700U);
  EXPECT_EQ(bench.device.status().samples_sent, 1700U);
  EXPECT_EQ(bench.device.status().samples_dropped, 0U);
}

TEST(EmulatedDevice, MessagesAndTopologiesFitDatagrams) {
  Bench bench(with(quantised(), &SimulatedSkinOptions::patch, "sheet:15x20"),
              with(&EmulatedDeviceOptions::max_body, skinwire::kMaxDatagram));
  bench.tick(20);
  for (const skinwire::Message& message : bench.heard) {
    EXPECT_LE(skinwire::encodeBody(message).size(), skinwire::kMaxDatagram);
  }
  EXPECT_EQ(samplesIn(bench.take<skinwire::Samples>()), 20U * 300U);
  skinwire::TopologyAssembler assembler;
  std::optional<NeighborList> whole;
  for (const skinwire::Topology& part : bench.take<skinwire::Topology>()) whole = assembler.add(part);
  ASSERT_TRUE(whole.has_value());
  EXPECT_EQ(*whole, bench.device.exploration().cells);
}

TEST(EmulatedDevice, CellsAverageByThemselves) {
  Bench bench(quantised(), with(&EmulatedDeviceOptions::means_of, 50));
  bench.tick(100);
  const auto messages = bench.take<skinwire::Samples>();
  ASSERT_THAT(messages, SizeIs(2));
  SampleFrame frame;
  skinwire::decodeTick(messages[1], 0, 0.004, frame);
  ASSERT_THAT(frame.means, SizeIs(17));
  for (const CellMean& mean : frame.means) {
    EXPECT_EQ(mean.count, 50U);
    EXPECT_NEAR(mean.mean_g.norm(), 1, 0.01);
    // 0.5 mg per root hertz at 1 kHz are 11.2 mg; an LSB of 4 mg adds little.
    for (const double variance_g2 : mean.variance_g2) {
      EXPECT_GT(std::sqrt(variance_g2), 0.006);
      EXPECT_LT(std::sqrt(variance_g2), 0.018);
    }
  }
  EXPECT_EQ(messages[1].time_us - messages[0].time_us, 50'000U);
}

TEST(EmulatedDevice, TurnsUntilTheCellLooksUp) {
  Bench bench;
  const Eigen::Vector3d up_u = Eigen::Vector3d(1, -2, 2).normalized();
  bench.device.take({7, skinwire::TurnTo{5, up_u}}, bench.heard);
  EXPECT_THAT(bench.take<skinwire::Ack>(), ElementsAre(skinwire::Ack{7, false, "", true}));
  int ticks = 0;
  const std::vector<skinwire::Ack> acks = bench.acksUntilItIsDone(&ticks);
  EXPECT_GT(ticks, 300);
  EXPECT_LT(ticks, 5000);
  EXPECT_EQ(acks.back(), (skinwire::Ack{7, true, "", false}));
  EXPECT_EQ(acks.size(), 1U + static_cast<std::size_t>(ticks) / 1001U) << "word once a second";
  EXPECT_LT((bench.nextFrame().samples[4].acceleration_g - up_u).norm(), 1e-6);
  bench.device.take({7, skinwire::TurnTo{5, up_u}}, bench.heard);
  EXPECT_THAT(bench.take<skinwire::Ack>(), ElementsAre(skinwire::Ack{7, true, "", false}))
      << "answered, not done again";
  EXPECT_FALSE(bench.device.body().turning());
}

TEST(EmulatedDevice, TheNewerTurnWins) {
  Bench bench;
  bench.device.take({1, skinwire::TurnTo{5, Eigen::Vector3d::UnitX()}}, bench.heard);
  bench.device.take({2, skinwire::TurnTo{5, -Eigen::Vector3d::UnitX()}}, bench.heard);
  const auto acks = bench.take<skinwire::Ack>();
  ASSERT_THAT(acks, SizeIs(3));
  EXPECT_EQ(acks[1].command, 1U);
  EXPECT_FALSE(acks[1].done || acks[1].working);
  EXPECT_TRUE(acks[2].working);
}

TEST(EmulatedDevice, AnswersEveryCommand) {
  Bench bench;
  const auto ask = [&](skinwire::Request request) {
    static std::uint32_t number = 100;
    bench.take<skinwire::Ack>();
    bench.device.take({++number, std::move(request)}, bench.heard);
    const skinwire::Ack ack = bench.takeOne<skinwire::Ack>();
    EXPECT_EQ(ack.command, number);
    return ack;
  };
  EXPECT_TRUE(ask(skinwire::SetLed{7, 255, 0, 16}).done);
  EXPECT_THAT(bench.device.led(CellId(7)), ElementsAre(255, 0, 16));
  EXPECT_THAT(bench.device.led(CellId(8)), ElementsAre(0, 0, 0));
  EXPECT_THAT(ask(skinwire::SetLed{18, 1, 1, 1}).text, HasSubstr("no cell 18"));
  EXPECT_FALSE(ask(skinwire::TurnTo{18, Eigen::Vector3d::UnitX()}).done);
  EXPECT_THAT(ask(skinwire::TurnTo{5, Eigen::Vector3d::Zero()}).text, HasSubstr("must be a finite vector"));
  EXPECT_FALSE(ask(std::monostate{}).done);
  EXPECT_FALSE(ask(skinwire::SetRate{5000}).done);

  bench.take<skinwire::Hello>();
  EXPECT_TRUE(ask(skinwire::SetRate{250}).done);
  const skinwire::Hello hello = bench.takeOne<skinwire::Hello>();
  EXPECT_EQ(hello.rate_hz, 250);
  bench.take<skinwire::Samples>();
  bench.take<skinwire::Status>();
  bench.tick(1000);
  EXPECT_NEAR(static_cast<double>(samplesIn(bench.take<skinwire::Samples>())), 250 * 17, 3 * 17);
  EXPECT_THAT(bench.take<skinwire::Status>(), SizeIs(2)) << "twice a second";
  bench.take<skinwire::Topology>();
  bench.take<skinwire::Hello>();
  bench.device.take({0, skinwire::Describe{}}, bench.heard);
  const skinwire::Topology topology = bench.takeOne<skinwire::Topology>();
  bench.device.take({0, skinwire::Describe{topology.id}}, bench.heard);
  EXPECT_THAT(bench.take<skinwire::Topology>(), SizeIs(0));
  EXPECT_THAT(bench.take<skinwire::Hello>(), SizeIs(2));
}

TEST(EmulatedDevice, ExploresAgainAndLosesWhatDoesNotAnswer) {
  Bench bench(quantised());
  const auto before = bench.take<skinwire::Topology>();
  bench.device.breakController(CellId(5));  // the end of an arm of x17
  bench.device.take({1, skinwire::ExploreAgain{}}, bench.heard);
  EXPECT_TRUE(bench.device.isExploring());
  EXPECT_TRUE(bench.take<skinwire::Status>().back().exploring);
  EXPECT_TRUE(bench.take<skinwire::Ack>().back().working);
  bench.take<skinwire::Samples>();
  bench.explore();
  EXPECT_TRUE(bench.take<skinwire::Ack>().back().done);
  EXPECT_THAT(bench.take<skinwire::Samples>(), SizeIs(0));
  const skinwire::Topology after = bench.takeOne<skinwire::Topology>();
  EXPECT_NE(after.id, before.at(0).id);
  EXPECT_THAT(after.cells, SizeIs(16));
  EXPECT_EQ(bench.nextCells(), 16U);

  bench.device.mendCell(CellId(5));
  bench.device.breakPort({PortFaultKind::Cut, {CellId(2), bench.device.body().neighbors()[1].neighbors[0].port}});
  bench.device.take({2, skinwire::ExploreAgain{}}, bench.heard);
  bench.explore();
  EXPECT_LT(bench.take<skinwire::Topology>().at(0).cells.size(), 17U);
}

TEST(EmulatedDevice, AnotherMouldIsAnotherStart) {
  Bench bench(quantised());
  bench.tick(50);
  bench.device.breakCell({SkinFault::NoSamples, CellId(17)});
  const auto first = bench.take<skinwire::Hello>().back();
  const NeighborList before = bench.take<skinwire::Topology>().back().cells;
  bench.take<skinwire::Samples>();
  bench.device.take({3, skinwire::TurnTo{5, Eigen::Vector3d::UnitX()}}, bench.heard);
  const LinkEnd at{CellId(3), PortNumber(1)};
  bench.device.breakLink({LinkFaultKind::WrongPort, at}, bench.heard);
  EXPECT_FALSE(bench.take<skinwire::Ack>().back().working);
  EXPECT_NE(bench.take<skinwire::Hello>().at(0).stream, first.stream);
  bench.explore();
  EXPECT_NE(bench.take<skinwire::Topology>().back().cells, before);
  bench.take<skinwire::Samples>();
  bench.tick(10);
  const auto samples = bench.take<skinwire::Samples>();
  EXPECT_EQ(samples.at(0).sequence, 0U);
  EXPECT_THAT(samples.at(0).cells, SizeIs(16)) << "its broken cell stays broken";
  EXPECT_THROW(bench.device.breakLink({LinkFaultKind::WrongPort, at}, bench.heard), InvalidArgument);
  EXPECT_FALSE(bench.device.mendLink({CellId(1), PortNumber(1)}, bench.heard));
  EXPECT_TRUE(bench.device.mendLink(at, bench.heard));
  bench.explore();
  EXPECT_EQ(bench.take<skinwire::Topology>().back().cells, before);
}

TEST(EmulatedDevice, CountsWhatItCouldNotSend) {
  Bench bench(quantised());
  bench.tick(10);
  bench.device.countDropped(bench.take<skinwire::Samples>().at(0));
  EXPECT_EQ(bench.device.status().samples_dropped, 170U);
  EXPECT_EQ(bench.device.status().samples_sent, 0U);
  bench.device.skip(30, bench.heard);
  EXPECT_EQ(bench.device.status().samples_dropped, 170U + 30U * 17U);
  EXPECT_EQ(bench.device.status().samples_sent, 0U);
  bench.tick(10);
  const auto messages = bench.take<skinwire::Samples>();
  EXPECT_EQ(messages.at(0).sequence, 40U * 17U) << "the host sees the loss in the numbering";
  EXPECT_EQ(bench.device.status().samples_sent, 170U);
}

TEST(EmulatedDevice, MeansKeepUpWithFewerSamples) {
  Bench bench(quantised(), with(&EmulatedDeviceOptions::means_of, 10));
  for (int k = 0; k < 10; ++k) {
    bench.tick(1);
    bench.device.skip(1, bench.heard);
  }
  const auto messages = bench.take<skinwire::Samples>();
  ASSERT_THAT(messages, SizeIs(2));
  for (const skinwire::Samples& message : messages) EXPECT_EQ(message.count.at(0), 5U);
  EXPECT_EQ(messages[1].time_us - messages[0].time_us, 10'000U);
  EXPECT_EQ(bench.device.status().samples_dropped, 0U);
  bench.tick(1);
  bench.device.skip(29, bench.heard);  // three means, one of which has a sample
  EXPECT_THAT(bench.take<skinwire::Samples>(), SizeIs(1));
  EXPECT_EQ(bench.device.status().samples_dropped, 34U);
  bench.tick(10);
  EXPECT_EQ(bench.take<skinwire::Samples>().at(0).sequence, 85U);
}

/// The made-up arm with ideal skins on two links.
SimulatedRobot skinnedArm() {
  return {builtInCellModel("hex-bma150"), RobotModel::read(HEXODERM_DEMO_ROBOT),
          with(SimulatedRobotOptions::ideal(), &SimulatedRobotOptions::mounts, demoMounts())};
}

TEST(EmulatedDevice, ARobotHasAllItsPatchesOnOneInterface) {
  Bench bench(skinnedArm());
  EXPECT_TRUE(bench.take<skinwire::Hello>().at(0).can_turn);
  NeighborList cells = bench.take<skinwire::Topology>().at(0).cells;
  ASSERT_THAT(cells, SizeIs(34));
  const CellId interface_id = bench.device.body().model().interface_id;
  std::vector<PortNumber> of_interface;
  for (CellReport& cell : cells) {
    std::erase_if(cell.neighbors, [&](const NeighborReport& link) {
      if (link.cell != interface_id) return false;
      of_interface.push_back(link.cell_port.value());
      return true;
    });
  }
  EXPECT_THAT(of_interface, ElementsAre(PortNumber(1), PortNumber(2)));
  EXPECT_EQ(cells, bench.device.body().neighbors());
  EXPECT_EQ(bench.nextCells(), 34U);

  // Faults, too, go by the robot's numbers.
  bench.device.breakCell({SkinFault::NoSamples, CellId(21)});
  bench.device.breakLink({LinkFaultKind::WrongPort, {CellId(20), PortNumber(1)}}, bench.heard);
  bench.explore();
  EXPECT_EQ(bench.nextCells(), 33U) << "its broken cell stays broken";
}

TEST(EmulatedDevice, ARobotSaysWhereItsJointsStand) {
  Bench bench(skinnedArm());
  EXPECT_THAT(bench.take<skinwire::Joints>(), SizeIs(0)) << "nobody knows its cells yet";
  bench.tick(1000);
  const auto standing = bench.take<skinwire::Joints>();
  ASSERT_THAT(standing, SizeIs(10));
  EXPECT_THAT(standing[0].names, ElementsAre("elbow", "grip", "shoulder_pitch", "shoulder_roll", "wrist_yaw"));
  for (std::size_t k = 1; k < standing.size(); ++k) {
    EXPECT_THAT(standing[k].names, SizeIs(0));
    EXPECT_EQ(standing[k].position, standing[0].position);
  }
  bench.device.take({0, skinwire::Describe{}}, bench.heard);
  bench.tick(100);
  EXPECT_THAT(bench.take<skinwire::Joints>().at(0).names, SizeIs(5)) << "after Describe";

  // To where it could stand.
  const SimulatedRobot same = skinnedArm();
  JointAngles angles;
  for (const std::string& name : same.robot().freeJointNames()) angles.positions[name] = 0;
  angles.positions["elbow"] = 1;
  angles.positions["shoulder_pitch"] = 1;
  const MountedPatch& patch = same.patches().at(1);
  const SE3 T_w_l = same.robot().forward(angles)[same.robot().linkNamed(patch.link)];
  const Eigen::Vector3d up_u = (T_w_l.R * patch.T_l_u.at(2).R).transpose() * Eigen::Vector3d::UnitZ();
  bench.device.take({5, skinwire::TurnTo{patch.cells.at(2).value(), up_u}}, bench.heard);
  EXPECT_TRUE(bench.take<skinwire::Ack>().at(0).working);
  EXPECT_TRUE(bench.acksUntilItIsDone().back().done);
  const auto moving = bench.take<skinwire::Joints>();
  ASSERT_GT(moving.size(), 5U);
  EXPECT_NE(moving.front().position, moving.back().position);
  bench.tick(1);
  const auto arrived = bench.take<skinwire::Joints>();
  ASSERT_THAT(arrived, SizeIs(1)) << "at once";
  std::vector<double> stands;
  for (const auto& [name, position] : bench.device.body().jointAngles().positions) stands.push_back(position);
  EXPECT_EQ(arrived[0].position, stands);
  EXPECT_NE(stands, standing[0].position);
}

TEST(EmulatedDevice, NamesOfJointsHaveToFitIntoAMessage) {
  std::string urdf = "<robot name='long'><link name='link0'/>";
  for (int k = 1; k <= 40; ++k) {
    const std::string number = std::to_string(k);
    urdf += "<joint name='a_joint_with_quite_a_long_name_" + number + "' type='continuous'><parent link='link" +
            std::to_string(k - 1) + "'/><child link='link" + number + "'/><axis xyz='0 0 1'/></joint><link name='link" +
            number + "'/>";
  }
  const RobotModel robot = RobotModel::parse(urdf + "</robot>", "long.urdf");
  const auto options =
      with(SimulatedRobotOptions::ideal(), &SimulatedRobotOptions::mounts, {{"link3", {}, "sheet:1x1", "plane"}});
  const auto make = [&] { return SimulatedRobot(builtInCellModel("hex-bma150"), robot, options); };
  EXPECT_NO_THROW(Bench{make()});
  EXPECT_THROW(Bench(make(), with(&EmulatedDeviceOptions::max_body, skinwire::kMaxDatagram)), InvalidArgument);
}

TEST(EmulatedDevice, RefusesOptionsThatMakeNoSense) {
  for (const EmulatedDeviceOptions& options :
       {with(&EmulatedDeviceOptions::rate_hz, -1), with(&EmulatedDeviceOptions::rate_hz, 2000),
        with(&EmulatedDeviceOptions::max_body, 10), with(&EmulatedDeviceOptions::status_every_s, 0)}) {
    EXPECT_THROW(Bench(SimulatedSkinOptions::ideal(), options), InvalidArgument);
  }
}

}  // namespace
}  // namespace hexoderm
