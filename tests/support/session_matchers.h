#pragma once

#include "hexoderm/session/session.h"
#include "tests/support/sample_matchers.h"
#include "tests/support/testing.h"

namespace hexoderm::test {

inline void expectSamePose(const SessionPose& a, const SessionPose& b) {
  EXPECT_EQ(a.disabled, b.disabled);
  EXPECT_EQ(a.why_disabled, b.why_disabled);
  EXPECT_EQ(a.joint_angles, b.joint_angles);
  EXPECT_EQ(a.capture->id, b.capture->id);
  EXPECT_EQ(a.capture->label, b.capture->label);
  EXPECT_EQ(a.capture->taken_at_ms, b.capture->taken_at_ms);
  expectSameItems(a.capture->samples, b.capture->samples, [](const GravitySample& x, const GravitySample& y) {
    EXPECT_EQ(x.cell, y.cell);
    EXPECT_EQ(x.count, y.count);
    EXPECT_EQ(x.temperature_c, y.temperature_c);
    EXPECT_TRUE(sameBits(x.mean_g, y.mean_g));
    EXPECT_TRUE(sameBits(x.cov_g2, y.cov_g2));
  });
}

inline void expectSamePlace(const PatchOnLink& a, const PatchOnLink& b) {
  EXPECT_EQ(a.origin, b.origin);
  EXPECT_EQ(a.link, b.link);
  EXPECT_TRUE(sameBits(a.T_l_o.R, b.T_l_o.R));
  EXPECT_TRUE(sameBits(a.T_l_o.t, b.T_l_o.t));
  ASSERT_EQ(a.cov_t_r.has_value(), b.cov_t_r.has_value());
  if (a.cov_t_r) {
    EXPECT_TRUE(sameBits(*a.cov_t_r, *b.cov_t_r));
  }
}

inline void expectSamePlacement(const PatchPlacement& a, const PatchPlacement& b) {
  EXPECT_EQ(a.origin, b.origin);
  EXPECT_EQ(a.link, b.link);
  EXPECT_EQ(a.link_chosen, b.link_chosen);
  EXPECT_EQ(a.by_surface, b.by_surface);
  expectSameItems(a.points, b.points, [](const auto& x, const auto& y) {
    EXPECT_EQ(x.cell, y.cell);
    EXPECT_TRUE(sameBits(x.x_l, y.x_l));
    EXPECT_EQ(x.sigma_m, y.sigma_m);
  });
  expectSameItems(a.distances, b.distances, [](const auto& x, const auto& y) {
    EXPECT_EQ(std::pair(x.a, x.b), std::pair(y.a, y.b));
    EXPECT_EQ(x.distance_m, y.distance_m);
    EXPECT_EQ(x.sigma_m, y.sigma_m);
  });
  ASSERT_EQ(a.place.has_value(), b.place.has_value());
  if (a.place) expectSamePlace(*a.place, *b.place);
}

/// A placement with everything that one can have, and numbers that are hard to keep.
inline PatchPlacement placementWithEverything(CellId origin) {
  PatchPlacement placement;
  placement.origin = origin;
  placement.link = "a \"forearm\"";
  placement.link_chosen = true;
  placement.by_surface = false;
  placement.points = {{origin, {1.0 / 3, -0.0, 5e-324}, 1e-3 / 7}};
  placement.distances = {{origin, CellId(origin.value() + 1), 0.1 + 0.2, 1e-3 / 3}};
  Matrix6d A;
  for (Eigen::Index k = 0; k < 36; ++k) A(k / 6, k % 6) = 1e-3 / (static_cast<double>(k) + 1.7);
  Matrix6d covariance = A * A.transpose();
  covariance = (0.5 * (covariance + covariance.transpose())).eval();
  placement.place = PatchOnLink{origin, placement.link, {expSO3({0.1, 2, -0.3}), {0.1, -1.0 / 7, 0}}, covariance};
  return placement;
}

/// Everything that is measured or decided, bit for bit; the source's text, but not the file it was read from.
inline void expectSameSession(const Session& a, const Session& b) {
  EXPECT_EQ(cellModelToJson(a.model()), cellModelToJson(b.model()));
  EXPECT_TRUE(sameBits(a.model().accelerometer.T_u_a.R, b.model().accelerometer.T_u_a.R));
  expectSameItems(a.model().sensors, b.model().sensors,
                  [](const auto& x, const auto& y) { EXPECT_TRUE(sameBits(x.T_u_s.R, y.T_u_s.R)); });
  EXPECT_EQ(a.neighbors(), b.neighbors());
  EXPECT_EQ(a.source().text, b.source().text);
  expectSameItems(a.poses(), b.poses(), expectSamePose);
  EXPECT_EQ(a.mutedLinks(), b.mutedLinks());
  EXPECT_EQ(a.side(), b.side());
  EXPECT_EQ(a.robot(), b.robot());
  expectSameItems(a.placements(), b.placements(), expectSamePlacement);
  ASSERT_EQ(a.truth() == nullptr, b.truth() == nullptr);
  if (!a.truth()) return;
  EXPECT_EQ(a.truth()->frame, b.truth()->frame);
  expectSameItems(a.truth()->cells, b.truth()->cells, [](const auto& x, const auto& y) {
    EXPECT_EQ(x.id, y.id);
    EXPECT_TRUE(sameBits(x.T_b_u.R, y.T_b_u.R));
    EXPECT_TRUE(sameBits(x.T_b_u.t, y.T_b_u.t));
  });
}

/// A session that uses everything a session has, with numbers that are hard to keep.
inline Session sessionWithEverything() {
  CellModel model = builtInCellModel("hex-bma150");
  model.accelerometer.offset_sigma_g.setConstant(1.0 / 3.0);
  model.accelerometer.T_u_a = {expSO3({0.3, -0.7, 1.1}), {1e-3 / 3, -0.0, 1}};
  model.sensors.push_back({"skin temperature", "temperature", {expSO3({-2.1, 0.2, 0.9}), {0.1 + 0.2, 0, 0}}});
  Session session(std::move(model),
                  {{CellId(1), "forearm", {{PortNumber(2), CellId(2), PortNumber(3)}}},
                   {CellId(2), "", {{PortNumber(3), CellId(1), std::nullopt}, {PortNumber(1), CellId(16383), {}}}}},
                  {Message::verbatim("A \"test\" of ümläut"), "", ""});
  GroundTruth truth;
  truth.frame = "arm";
  truth.cells.push_back({CellId(1), {expSO3({0.1, -0.2, 0.3}), {1.0 / 7, -0.0, 5e-324}}});
  truth.cells.push_back({CellId(2), {expSO3({3.0, 0.1, -0.7}), {0.1 + 0.2, 1e-17, -2}}});
  session.setTruth(std::move(truth));
  for (std::uint32_t id = 1; id <= 3; ++id) {
    PoseCapture capture;
    capture.id = PoseId(id);
    if (id != 2) capture.label = Message::verbatim("pose\n" + std::to_string(id));
    if (id != 2) capture.taken_at_ms = 1'700'000'000'123 + id;
    GravitySample a{CellId(1), {0.1 * id, -0.0, 1.0 / 3}, Eigen::Matrix3d::Zero(), 100 * id};
    a.cov_g2 << 1e-6, 1e-160 / 3, -0.0, 1e-160 / 3, 2e-300, -5e-324, -0.0, -5e-324, 0;
    if (id == 1) a.temperature_c = 36.6;
    GravitySample b{CellId(2), {999999.9999999999, -5e-324, 0.0}, Eigen::Matrix3d::Zero(), 0};
    if (id == 3) b.cov_g2(2, 1) = b.cov_g2(1, 2) = -0.0;
    capture.samples = {a, b};
    session.addPose({std::make_shared<const PoseCapture>(capture), id == 2, id == 2 ? "the arm moved" : ""});
    if (id != 1) session.setJointAngles(id - 1, {{{"elbow", id / 3.0}, {"a \"wrist\"", -1e-17}}});
  }
  session.setLinkMuted({CellId(2), PortNumber(3)}, {CellId(1), PortNumber(2)}, true, "a \"cable\"\n");
  session.setLinkMuted({CellId(7), PortNumber(1)}, {CellId(7), PortNumber(4)}, true);
  session.setRobot(RobotDescription{"a \"robot\".urdf", "00ff", {{"arm", "/opt/ärm"}, {"hand", "hand"}}});
  session.setPlacement(placementWithEverything(CellId(2)));
  PatchPlacement begun;
  begun.origin = CellId(1);
  begun.link = "upper_arm";
  session.setPlacement(begun);
  return session;
}

/// A session that no file takes: cell 1 reads no number in pose 7.
inline Session sessionWithABadReading() {
  Session session(builtInCellModel("hex-bma150"), {});
  const Eigen::Vector3d bad_g(0, std::numeric_limits<double>::quiet_NaN(), 1);
  session.addPose({std::make_shared<const PoseCapture>(
      PoseCapture{PoseId(7), {}, {{CellId(1), bad_g, Eigen::Matrix3d::Zero(), 1}}})});
  return session;
}

}  // namespace hexoderm::test
