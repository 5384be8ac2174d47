// Effects of faulty links on a simulated skin's reports, readings and truth.

#include "hexoderm/base/units.h"
#include "hexoderm/sim/simulated_skin.h"
#include "hexoderm/skin/skin_graph.h"
#include "tests/core/sim/standard_skin.h"
#include "tests/support/options.h"
#include "tests/support/testing.h"

#include <tuple>

namespace hexoderm {
namespace {

using test::with;
using Cells = std::set<unsigned>;
using Skin = SimulatedSkinOptions;

LinkFault fault(LinkFaultKind kind, unsigned cell, unsigned port) { return {kind, {CellId(cell), PortNumber(port)}}; }

SimulatedSkin ideal(const std::string& patch, const std::vector<LinkFault>& faults, const std::string& surface = "") {
  return {kModel, with(Skin::ideal(), &Skin::link_faults, faults, &Skin::patch, patch, &Skin::surface, surface)};
}

/// An X17 with all of its other errors.
SimulatedSkin realX17(const std::vector<LinkFault>& faults = {}, std::uint64_t seed = 1) {
  return {kModel, with(Skin(), &Skin::link_faults, faults, &Skin::seed, seed)};
}

const SE3& placement(const SimulatedSkin& skin, unsigned id) { return skin.truth().at(id - 1).T_b_u; }

/// Cells that do not lie alike.
Cells movedCells(const SimulatedSkin& a, const SimulatedSkin& b) {
  Cells moved;
  for (unsigned id = 1; id <= a.truth().size(); ++id) {
    const SE3& one = placement(a, id);
    const SE3& other = placement(b, id);
    if (one.R != other.R || one.t != other.t) moved.insert(id);
  }
  return moved;
}

/// Cells that read otherwise at the end of the next recording of both.
Cells cellsThatReadOtherwise(SimulatedSkin& a, SimulatedSkin& b) {
  const SampleFrame one = a.record(kUp, 5).back();
  const SampleFrame other = b.record(kUp, 5).back();
  Cells differing;
  for (unsigned k = 0; k < one.samples.size(); ++k) {
    if (one.samples[k].acceleration_g != other.samples[k].acceleration_g) differing.insert(k + 1);
  }
  return differing;
}

const NeighborReport* reportAt(const SimulatedSkin& skin, unsigned cell, unsigned port) {
  for (const NeighborReport& report : skin.neighbors().at(cell - 1).neighbors) {
    if (report.port == PortNumber(port)) return &report;
  }
  return nullptr;
}

/// The hinge at a link of two cells: a point of it, its direction, along the link, and the normal.
struct Hinge {
  Eigen::Vector3d point, axis, along, normal;
};

Hinge hingeBetween(const SimulatedSkin& skin, unsigned near, unsigned near_port, unsigned far, unsigned far_port) {
  const SE3& a = placement(skin, near);
  const SE3& b = placement(skin, far);
  Hinge hinge;
  hinge.point = (a * kModel.port(PortNumber(near_port)).vector_m + b * kModel.port(PortNumber(far_port)).vector_m) / 2;
  hinge.normal = (a.R.col(2) + b.R.col(2)).normalized();
  hinge.axis = hinge.normal.cross(b.t - a.t).normalized();
  hinge.along = hinge.axis.cross(hinge.normal);
  return hinge;
}

/// The up direction that each cell saw in the first frame, with the cell placed as in the truth.
std::vector<Eigen::Vector3d> upSeen(const SimulatedSkin& skin, const std::vector<SampleFrame>& frames) {
  std::vector<Eigen::Vector3d> up;
  for (std::size_t k = 0; k < skin.truth().size(); ++k) {
    up.push_back(skin.truth()[k].T_b_u.R * frames.front().samples[k].acceleration_g);
  }
  return up;
}

/// Cells that see something else than `up` in a bent recording.
Cells turnedCells(SimulatedSkin& skin) {
  skin.record(kUp, 1);
  Cells turned;
  for (const Eigen::Vector3d& up : {Eigen::Vector3d(1, 0, 0), Eigen::Vector3d(0, 1, 0), Eigen::Vector3d(0, 0, 1)}) {
    const std::vector<Eigen::Vector3d> seen = upSeen(skin, skin.record(up, 1));
    for (unsigned k = 0; k < seen.size(); ++k) {
      if ((seen[k] - up).norm() > 1e-9) turned.insert(k + 1);
    }
    skin.record(up, 1);
  }
  return turned;
}

TEST(SimulatedJoint, TurnsTheReadingsOfItsFarSideInEverySecondRecording) {
  const Hinge hinge = hingeBetween(ideal("x17", {}), 3, 1, 4, 4);
  for (const double angle : {20 * kDegree, -7 * kDegree}) {
    // Far: the arm's last two cells.
    SimulatedSkin skin(kModel, with(Skin::ideal(), &Skin::link_faults, {fault(LinkFaultKind::Joint, 3, 1)},
                                    &Skin::joint_angle_rad, angle));
    const Eigen::Vector3d tipped = std::cos(angle) * hinge.normal - std::sin(angle) * hinge.along;
    for (const auto& [up, when_bent] :
         {std::pair(hinge.normal, tipped), std::pair(Eigen::Vector3d(hinge.axis), hinge.axis)}) {
      for (const bool bent : {false, true}) {
        const std::vector<Eigen::Vector3d> seen = upSeen(skin, skin.record(up, 1));
        for (unsigned id = 1; id <= 17; ++id) {
          const bool turned = bent && (id == 4 || id == 5);
          EXPECT_LT((seen[id - 1] - (turned ? when_bent : up)).norm(), 1e-12) << "cell " << id;
        }
      }
    }
  }
}

TEST(SimulatedJoint, LeavesTruthReportsAndTheNearSidesReadingsAsTheyWere) {
  SimulatedSkin whole = realX17();
  SimulatedSkin broken = realX17({fault(LinkFaultKind::Joint, 3, 1)});
  EXPECT_EQ(broken.neighbors(), whole.neighbors());
  EXPECT_EQ(movedCells(whole, broken), Cells{});
  for (int recording = 0; recording < 4; ++recording) {
    EXPECT_EQ(cellsThatReadOtherwise(whole, broken), recording % 2 == 0 ? Cells{} : (Cells{4, 5}));
  }
}

TEST(SimulatedJoint, IsTheSameFromEitherEndAndTheMiddleStays) {
  for (const auto& named : {fault(LinkFaultKind::Joint, 1, 1), fault(LinkFaultKind::Joint, 2, 4)}) {
    SimulatedSkin skin = ideal("x17", {named});
    EXPECT_EQ(turnedCells(skin), (Cells{2, 3, 4, 5}));
  }
  SimulatedSkin ring = ideal("ring8", {fault(LinkFaultKind::Joint, 2, 3)});
  EXPECT_EQ(turnedCells(ring), (Cells{1, 2}));
}

TEST(SimulatedJoint, MovesItsFarSideThroughTheHandsField) {
  // Accelerations of a rigid body are affine in position: the near side says which, the far side must agree where it
  // is.
  SimulatedSkin skin(kModel, with(Skin::ideal(), &Skin::link_faults, {fault(LinkFaultKind::Joint, 3, 1)},
                                  &Skin::hand_held, true, &Skin::tremor_angle_sigma_rad, 1 * kDegree));
  const Hinge hinge = hingeBetween(skin, 3, 1, 4, 4);
  const Eigen::Vector3d turn = 20 * kDegree * hinge.axis;
  const Eigen::Matrix3d R = expSO3(turn);
  skin.record(kUp, 1);
  const std::vector<SampleFrame> frames = skin.record(kUp, 20);
  ASSERT_EQ(frames.size(), 20U);
  for (const SampleFrame& frame : frames) {
    Eigen::Matrix4d H = Eigen::Matrix4d::Zero();
    Eigen::Matrix<double, 4, 3> b = Eigen::Matrix<double, 4, 3>::Zero();
    for (unsigned id = 1; id <= 17; ++id) {
      if (id == 4 || id == 5) continue;
      const Eigen::Vector4d at = placement(skin, id).t.homogeneous();
      H += at * at.transpose();
      b += at * (placement(skin, id).R * frame.samples[id - 1].acceleration_g).transpose();
    }
    const Eigen::Matrix<double, 4, 3> field = H.fullPivLu().solve(b);
    for (const unsigned id : {4U, 5U}) {
      const Eigen::Vector3d moved = hinge.point + R * (placement(skin, id).t - hinge.point);
      const Eigen::Vector3d expected = field.transpose() * moved.homogeneous();
      EXPECT_LT((R * placement(skin, id).R * frame.samples[id - 1].acceleration_g - expected).norm(), 1e-9);
      const Eigen::Vector3d unmoved = field.transpose() * placement(skin, id).t.homogeneous();
      EXPECT_GT((expected - unmoved).norm(), 1e-6);
    }
  }
}

TEST(SimulatedJoint, OneBehindAnotherIsCarriedAlong) {
  SimulatedSkin skin = ideal("x17", {fault(LinkFaultKind::Joint, 4, 1), fault(LinkFaultKind::Joint, 2, 1)}, "plane");
  const Hinge hinge = hingeBetween(skin, 2, 1, 3, 4);
  skin.record(kUp, 1);
  const std::vector<Eigen::Vector3d> seen = upSeen(skin, skin.record(hinge.normal, 1));
  const auto tip = [&](unsigned id) {
    return toDegrees(std::atan2(-seen[id - 1].dot(hinge.along), seen[id - 1].dot(hinge.normal)));
  };
  EXPECT_NEAR(tip(2), 0, 1e-9);
  EXPECT_NEAR(tip(3), 20, 1e-9);
  EXPECT_NEAR(tip(4), 20, 1e-9);
  EXPECT_NEAR(tip(5), 40, 1e-9);
}

TEST(SimulatedJoint, CutsASheetAlongTheLineThroughItsLink) {
  const SimulatedSkin flat = ideal("sheet:6x7", {}, "plane");
  for (const char* surface : {"plane", "cylinder:r=0.06"}) {
    for (const unsigned port : {1U, 2U}) {
      const unsigned cell = 17;
      SimulatedSkin skin = ideal("sheet:6x7", {fault(LinkFaultKind::Joint, cell, port)}, surface);
      const NeighborReport* report = reportAt(skin, cell, port);
      ASSERT_NE(report, nullptr);
      const Hinge hinge = hingeBetween(flat, cell, port, report->cell.value(), report->cell_port->value());
      const auto side = [&](std::size_t k) { return hinge.along.dot(flat.truth()[k].T_b_u.t - hinge.point) > 0; };
      const Cells turned = turnedCells(skin);
      const unsigned middle = 3 * 7 + 3 + 1;
      EXPECT_FALSE(turned.contains(middle));
      EXPECT_TRUE(turned.contains(cell) != turned.contains(report->cell.value()));
      for (unsigned k = 0; k < 42; ++k) EXPECT_EQ(turned.contains(k + 1), side(k) != side(middle - 1)) << k + 1;
    }
  }
}

TEST(SimulatedJoint, OfASheetsLastCellBendsThatCellOnly) {
  SimulatedSkin skin = ideal("sheet:3x3", {}, "plane");
  ASSERT_EQ(skin.neighbors().front().neighbors.size(), 1U);
  SimulatedSkin bent = ideal("sheet:3x3", {{LinkFaultKind::Joint, {CellId(1), skin.neighbors()[0].neighbors[0].port}}});
  EXPECT_EQ(turnedCells(bent), Cells{1});
}

TEST(SimulatedCable, LetsTheFarSideLieElsewhereAsOnePiece) {
  double least = 180;
  double most = 0;
  for (unsigned seed = 1; seed <= 40; ++seed) {
    const SimulatedSkin broken = realX17({fault(LinkFaultKind::Cable, 7, 1)}, seed);
    const SimulatedSkin from_other_end = realX17({fault(LinkFaultKind::Cable, 6, 4)}, seed);
    const SimulatedSkin whole = realX17({}, seed);
    EXPECT_EQ(broken.neighbors(), whole.neighbors());

    // Arm 6 to 9 leaves the middle through port 4 and enters through port 1.
    const Hinge hinge = hingeBetween(whole, 6, 4, 7, 1);
    const SE3 motion = placement(broken, 7) * placement(whole, 7).inverse();
    const double angle = toDegrees(rotationAngle(motion.R));
    least = std::min(least, angle);
    most = std::max(most, angle);
    EXPECT_NEAR((motion * hinge.point - hinge.point).norm(), 0.1, 1e-12);
    EXPECT_EQ(movedCells(broken, from_other_end), Cells{});
    EXPECT_EQ(movedCells(broken, whole), (Cells{7, 8, 9}));
    for (const unsigned id : {7U, 8U, 9U}) {
      const SE3 expected = motion * placement(whole, id);
      EXPECT_LT((placement(broken, id).t - expected.t).norm(), 1e-12);
      EXPECT_LT((placement(broken, id).R - expected.R).norm(), 1e-12);
    }
  }
  EXPECT_GE(least, 40 - 1e-9);
  EXPECT_LT(least, 50);
  EXPECT_LE(most, 120 + 1e-9);
  EXPECT_GT(most, 110);
}

TEST(SimulatedCable, IsReadInEveryRecordingAndTheNearSideReadsAsBefore) {
  SimulatedSkin exact = ideal("x17", {fault(LinkFaultKind::Cable, 7, 1)});
  for (const Eigen::Vector3d& up : scriptedUpDirections(4)) {
    for (const Eigen::Vector3d& seen : upSeen(exact, exact.record(up, 1))) EXPECT_LT((seen - up).norm(), 1e-12);
  }
  SimulatedSkin whole = realX17();
  SimulatedSkin broken = realX17({fault(LinkFaultKind::Cable, 7, 1)});
  for (int recording = 0; recording < 3; ++recording) {
    EXPECT_EQ(cellsThatReadOtherwise(whole, broken), (Cells{7, 8, 9}));
  }
}

TEST(SimulatedWrongPort, IsInBothReportsAndInNoTruth) {
  std::set<unsigned> drawn;
  for (unsigned seed = 1; seed <= 20; ++seed) {
    SimulatedSkin broken = realX17({fault(LinkFaultKind::WrongPort, 3, 1)}, seed);
    SimulatedSkin whole = realX17({}, seed);
    EXPECT_EQ(reportAt(broken, 3, 1), nullptr);
    const NeighborReport* wrong = reportAt(broken, 4, 4);
    ASSERT_NE(wrong, nullptr);
    EXPECT_EQ(wrong->cell, CellId(3));
    const PortNumber port = wrong->cell_port.value();
    EXPECT_TRUE(port == PortNumber(2) || port == PortNumber(3)) << port;
    drawn.insert(port.value());
    ASSERT_NE(reportAt(broken, 3, port.value()), nullptr);
    EXPECT_EQ(*reportAt(broken, 3, port.value()), (NeighborReport{port, CellId(4), PortNumber(4)}));

    const SkinGraph graph(broken.model(), broken.neighbors());
    EXPECT_TRUE(graph.findings().empty());
    EXPECT_EQ(graph.links().size(), 16U);
    EXPECT_EQ(movedCells(broken, whole), Cells{});
    EXPECT_EQ(cellsThatReadOtherwise(broken, whole), Cells{});
    for (std::size_t k = 0; k < 17; ++k) {
      if (k != 2 && k != 3) {
        EXPECT_EQ(broken.neighbors()[k], whole.neighbors()[k]);
      }
    }
  }
  EXPECT_EQ(drawn.size(), 2U);
}

TEST(SimulatedWrongPort, AtBothEndsOfALinkAndOfAClosedRing) {
  const SimulatedSkin both =
      ideal("x17", {fault(LinkFaultKind::WrongPort, 3, 1), fault(LinkFaultKind::WrongPort, 4, 4)});
  EXPECT_EQ(reportAt(both, 3, 1), nullptr);
  EXPECT_EQ(reportAt(both, 4, 4), nullptr);
  EXPECT_TRUE(SkinGraph(both.model(), both.neighbors()).findings().empty());
  const SimulatedSkin ring = ideal("ring8:closed", {fault(LinkFaultKind::WrongPort, 8, 3)});
  const NeighborReport* report = reportAt(ring, 1, 2);
  ASSERT_NE(report, nullptr);
  EXPECT_EQ(report->cell, CellId(8));
  EXPECT_TRUE(report->cell_port == PortNumber(1) || report->cell_port == PortNumber(4));
}

TEST(SimulatedWrongPort, IsNotDrawnWhereTheModelForbidsThePair) {
  CellModel model = kModel;
  model.forbidden_port_pairs = {{PortNumber(2), PortNumber(4)}};
  for (unsigned seed = 1; seed <= 10; ++seed) {
    const Skin options = with(Skin(), &Skin::link_faults, {fault(LinkFaultKind::WrongPort, 3, 1)}, &Skin::seed, seed);
    EXPECT_NE(reportAt(SimulatedSkin(model, options), 3, 3), nullptr);
  }
}

TEST(SimulatedSkin, RefusesLinkFaultsThatCannotBeAndSaysWhy) {
  constexpr auto kWrongPort = LinkFaultKind::WrongPort;
  constexpr auto kJoint = LinkFaultKind::Joint;
  constexpr auto kCable = LinkFaultKind::Cable;
  const std::tuple<const char*, std::vector<LinkFault>, const char*> refused[] = {
      {"x17", {fault(kJoint, 18, 1)}, "there is no cell 18"},
      {"x17", {fault(kCable, 0, 1)}, "there is no cell 0"},
      {"x17", {fault(kJoint, 3, 2)}, "cell 3, port 2 has no link"},
      {"x17", {fault(kJoint, 3, 2)}, "the ports 1 and 4"},
      {"x17", {fault(kWrongPort, 5, 9)}, "cell 5, port 9 has no link"},
      {"sheet:1x1", {fault(kJoint, 1, 1)}, "has links at no port"},
      {"x17", {fault(kWrongPort, 1, 1)}, "no other port of the cell is free"},
      {"x17", {fault(kWrongPort, 3, 1), fault(kWrongPort, 3, 1)}, "broken already"},
      {"x17", {fault(kJoint, 3, 1), fault(kJoint, 4, 4)}, "broken already"},
      {"x17", {fault(kJoint, 3, 1), fault(kCable, 3, 1)}, "broken already"},
      {"ring8:closed", {fault(kJoint, 3, 3)}, "holds both its sides together"},
      {"ring8:closed", {fault(kCable, 8, 3)}, "holds both its sides together"},
  };
  for (const auto& [patch, faults, reason] : refused) {
    EXPECT_THAT(messageOf<InvalidArgument>([&, patch = patch, &faults = faults] { ideal(patch, faults); }),
                testing::HasSubstr(reason));
  }
}

}  // namespace
}  // namespace hexoderm
