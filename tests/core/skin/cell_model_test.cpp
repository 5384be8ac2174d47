#include "hexoderm/skin/cell_model.h"

#include "hexoderm/base/units.h"
#include "tests/support/temporary_folder.h"
#include "tests/support/testing.h"

namespace hexoderm {
namespace {

CellModel hex() { return builtInCellModel("hex-bma150"); }

/// Five ports, some out of the plane's symmetry, with everything optional given.
CellModel ownModel() {
  CellModel model = hex();
  model.name = "own";
  model.ports.push_back({PortNumber(9), {0, 0.0141, 0}});
  model.accelerometer.T_u_a = {expSO3({0, 0, kPi}), {0.001, -0.002, -0.003}};
  model.accelerometer.cross_axis_sigma = 0.001;
  model.accelerometer.offset_shared_sigma_g = 0.008;
  model.accelerometer.scale_shared_sigma = 0.1;
  model.sensors = {{"force 1", "force", {expSO3({kPi, 0, 0}), {0.004, 0.1 / 3, 0}}}};
  model.forbidden_port_pairs = {{PortNumber(1), PortNumber(9)}};
  model.side_angle_rad = 0.1;
  model.link_sigma_m = 0.0007;
  model.bend_sigma_rad = 0.3;
  model.twist_sigma_rad = 0.2;
  model.yaw_sigma_rad = 0.1;
  return model;
}

TEST(CellModel, BuiltInHexAgreesWithThePaper) {
  const CellModel model = hex();
  ASSERT_EQ(model.ports.size(), 4U);
  EXPECT_EQ(model.port(PortNumber(2)).vector_m, Eigen::Vector3d(0.012, -0.007, 0));
  EXPECT_NEAR(16 * model.reach_m(), 0.22228, 1e-5);
  EXPECT_NEAR(model.side_m * std::sqrt(3.0) / 2, 0.013007, 1e-6) << "centre to side";
  EXPECT_NEAR(model.reach_m() - model.gap_m / 2, 0.013007, 1e-6);
  EXPECT_EQ(model.interface_id, CellId(16383));
  EXPECT_FALSE(model.isForbidden(PortNumber(2), PortNumber(3)));
  EXPECT_FALSE(model.isForbidden(PortNumber(3), PortNumber(3)));
}

TEST(CellModel, NamesTheBuiltInOnesWhenAskedForAnother) {
  EXPECT_THAT(messageOf<InvalidArgument>([] { builtInCellModel("oct"); }), saysAll("\"oct\"", "hex-bma150"));
  EXPECT_THAT(messageOf<StorageError>([] { loadCellModel("hex20"); }),
              saysAll("hex20: there is no such file", "hex-bma150"));
}

TEST(CellModel, KnowsItsPorts) {
  EXPECT_EQ(hex().findPort(PortNumber(5)), nullptr);
  EXPECT_THAT(messageOf<InvalidArgument>([] { static_cast<void>(hex().port(PortNumber(5))); }),
              saysAll("hex-bma150", "port 5"));
}

TEST(CellModel, OutlineRunsCounterClockwiseFromX) {
  const CellModel model = hex();
  const auto corners = model.outline();
  EXPECT_TRUE(corners[0].isApprox(Eigen::Vector3d(model.side_m, 0, 0)));
  double area = 0;
  for (std::size_t k = 0; k < 6; ++k) area += corners[k].cross(corners[(k + 1) % 6]).z() / 2;
  EXPECT_NEAR(area, 1.5 * std::sqrt(3.0) * model.side_m * model.side_m, 1e-12);
}

TEST(CellModelJson, ComesBackAsItWas) {
  const CellModel model = ownModel();
  const std::string text = cellModelToJson(model);
  const CellModel back = cellModelFromJson(text, "own.json");
  EXPECT_EQ(cellModelToJson(back), text);
  EXPECT_EQ(back.name, "own");
  EXPECT_EQ(collect(back.ports, &Port::number), collect(model.ports, &Port::number));
  EXPECT_EQ(collect(back.ports, &Port::vector_m), collect(model.ports, &Port::vector_m));
  EXPECT_EQ(back.forbidden_port_pairs, model.forbidden_port_pairs);
  ASSERT_EQ(back.sensors.size(), 1U);
  EXPECT_EQ(back.sensors[0].name, "force 1");
  EXPECT_EQ(back.sensors[0].type, "force");
  EXPECT_EQ(back.sensors[0].T_u_s.t, model.sensors[0].T_u_s.t);
  EXPECT_TRUE(back.sensors[0].T_u_s.R.isApprox(model.sensors[0].T_u_s.R, 1e-15));
  EXPECT_EQ(back.accelerometer.T_u_a.t, model.accelerometer.T_u_a.t);
  EXPECT_EQ(back.accelerometer.cross_axis_sigma, 0.001);
  EXPECT_EQ(back.accelerometer.offset_shared_sigma_g, 0.008);
  EXPECT_EQ(back.accelerometer.scale_shared_sigma, 0.1);
  for (const auto value : {&CellModel::side_angle_rad, &CellModel::link_sigma_m, &CellModel::bend_sigma_rad,
                           &CellModel::twist_sigma_rad, &CellModel::yaw_sigma_rad}) {
    EXPECT_EQ(back.*value, model.*value);
  }
}

/// Only the keys that every file has; `scale_sigma` as text.
CellModel sparseModel(const std::string& scale_sigma) {
  return cellModelFromJson(R"({"name": "sparse", "side_m": 0.015, "thickness_m": 0.003, "gap_m": 0.002,
      "ports": [{"port": 1, "vector_m": [0.014, 0, 0]}], "interface_id": 16383,
      "accelerometer": {"range_g": 2, "lsb_g": 0.004, "rate_hz": 1000, "noise_g_per_sqrt_hz": 0.0005,
                        "offset_sigma_g": 0.06, "scale_sigma": )" +
                               scale_sigma + "}}",
                           "sparse.json");
}

TEST(CellModelJson, FillsInWhatAFileMayLeaveOut) {
  const CellModel model = sparseModel("0.02");
  EXPECT_EQ(model.accelerometer.cross_axis_sigma, 0.005);
  const CellModel made;  // in a program: the same
  for (const auto& [sigma, value] :
       {std::pair(&CellModel::link_sigma_m, 0.0005), std::pair(&CellModel::bend_sigma_rad, 30 * kDegree),
        std::pair(&CellModel::twist_sigma_rad, 10 * kDegree), std::pair(&CellModel::yaw_sigma_rad, 2 * kDegree)}) {
    EXPECT_EQ(model.*sigma, value);
    EXPECT_EQ(made.*sigma, value);
  }
}

TEST(CellModelJson, TakesCalibratedScalesForCalibratedAxes) {
  EXPECT_EQ(sparseModel("0").accelerometer.cross_axis_sigma, 0);
  EXPECT_DOUBLE_EQ(sparseModel("0.004").accelerometer.cross_axis_sigma, 0.001);
  EXPECT_EQ(sparseModel("0.2").accelerometer.cross_axis_sigma, 0.005);
}

/// The complaint about the built-in model with one text replaced.
std::string complaintWith(const std::string& from, const std::string& to) {
  return messageOf<FormatError>([&] { cellModelFromJson(replaced(cellModelToJson(hex()), from, to), "m.json"); });
}

TEST(CellModelJson, RefusesPortsThatMakeNoSense) {
  EXPECT_THAT(complaintWith("\"port\": 2", "\"port\": 1"), saysAll("m.json", "port 1 is listed twice"));
  EXPECT_THAT(complaintWith("[0.012, -0.007, 0.0]", "[0, 0, 0]"), saysAll("m.json", "port 2", "vector_m"));
}

TEST(CellModelJson, RefusesLengthsThatNoCellHas) {
  EXPECT_THAT(complaintWith("\"side_m\": 0.01502", "\"side_m\": 15"),
              saysAll("m.json: side_m: expected a length in metres, from 0.001 to 1, found 15"));
  EXPECT_THAT(complaintWith("\"side_m\": 0.01502", "\"side_m\": 1e-9"), saysAll("metres, from 0.001 to 1"));
  EXPECT_THAT(complaintWith("\"gap_m\": ", "\"gap_m\": 2"), saysAll("gap_m: expected", "from 0 to 1, found 2"));
  EXPECT_THAT(complaintWith("[0.012, -0.007, 0.0]", "[12, -7, 0]"), saysAll("port 2: vector_m", "at most 1 m"));
}

TEST(CellModelJson, SaysTheLengthOfAQuaternionThatIsNone) {
  const std::string q = "\"q_u_wxyz\": [1.0, 0.0, 0.0, 0.0]";
  EXPECT_THAT(complaintWith(q, "\"q_u_wxyz\": [0.99, 0, 0, 0]"),
              saysAll("accelerometer.q_u_wxyz: expected a unit quaternion", "the length of this one is 0.9900000"));
}

TEST(CellModelJson, StatesTheErrorsOfItsChip) {
  const CellModel model = sparseModel("0.02");
  EXPECT_EQ(model.accelerometer.offset_sigma_g, Eigen::Vector3d::Constant(0.06));
  EXPECT_FALSE(model.accelerometer.sharesErrors());
  EXPECT_EQ(cellModelToJson(model).find("offset_shared_sigma_g"), std::string::npos);
  EXPECT_THAT(complaintWith("\"offset_sigma_g\": ", "\"shared_offset_sigma_g\": 0.5, \"offset_sigma_g\": "),
              saysAll("m.json: accelerometer.shared_offset_sigma_g: expected at most",
                      "of which it is a part: 0.04, found 0.5"));
}

TEST(CellModelJson, OfOldHasTheLotsOffsetAsAPartOfTheWhole) {
  std::string text = cellModelToJson(sparseModel("0.02"));
  const std::string key = "\"offset_sigma_g\": ";
  text.insert(text.find(key), "\"shared_offset_sigma_g\": 0.036, ");
  const Accelerometer a = cellModelFromJson(text, "m.json").accelerometer;
  EXPECT_DOUBLE_EQ(a.offset_shared_sigma_g, 0.036);
  EXPECT_DOUBLE_EQ(a.offset_sigma_g.x(), 0.048);
  EXPECT_DOUBLE_EQ(a.ofUnknownLot().offset_sigma_g.x(), 0.06);
}

TEST(CellModelJson, RefusesKeysThatItDoesNotKnowAndNamesWhatWasMeant) {
  EXPECT_THAT(complaintWith("\"side_m\"", "\"sidem\""),
              saysAll("m.json: sidem: there is no such key; did you mean side_m?"));
  EXPECT_THAT(complaintWith("\"yaw_sigma_rad\"", "\"yaw_sigma\""),
              saysAll("m.json: yaw_sigma:", "mean yaw_sigma_rad?"));
  EXPECT_THAT(complaintWith("\"lsb_g\"", "\"LSB_g\""), saysAll("m.json: accelerometer.LSB_g:", "mean lsb_g?"));
  EXPECT_THAT(complaintWith("\"vector_m\"", "\"vector\""), saysAll("m.json: ports[0].vector:", "mean vector_m?"));
  EXPECT_THAT(complaintWith("\"type\"", "\"kind\""),
              saysAll("m.json: sensors[0].kind: there is no such key; there are name, type, t_u_m"));
  EXPECT_THAT(complaintWith("\"side_m\"", "\"a\\u001b[31m\""), saysAll("m.json: a\\x1b[31m: there is no such key"));
}

/// Level ports, and such as look up, down and nearly upright, whose cells fold, form steps and lie one on the other.
std::vector<Port> portsWithHeight() {
  std::vector<Port> ports = ownModel().ports;
  for (const Eigen::Vector3d& vector_m : {Eigen::Vector3d(0.012, 0.007, 0.004), Eigen::Vector3d(-0.012, -0.007, -0.004),
                                          Eigen::Vector3d(-0.003, 0.013, -0.011), Eigen::Vector3d(1e-8, -1e-8, 0.5)}) {
    ports.push_back({PortNumber(9), vector_m});
  }
  return ports;
}

TEST(NominalAlignment, OfPortsWithHeightFoldsTheLinkUntilTheyFaceEachOther) {
  for (const Port& source : portsWithHeight()) {
    for (const Port& target : portsWithHeight()) {
      const Eigen::Matrix3d axes_c = linkAxes(source);
      const Eigen::Matrix3d axes_n = linkAxes(target);
      EXPECT_LT((axes_c.transpose() * axes_c - Eigen::Matrix3d::Identity()).norm(), 1e-14);
      EXPECT_LT((axes_c.col(0) - source.vector_m.normalized()).norm(), 1e-15);
      EXPECT_EQ(axes_c(2, 1), 0) << "links fold about a line in the cell's plane";
      EXPECT_GT(axes_c(2, 2), 0);
      // So a positive bend leans the neighbour's z away from the source, as around a convex body.
      EXPECT_GT(axes_c.determinant(), 0);
      // Seen from the target, u and z x u point the other way.
      const Eigen::Matrix3d R = nominalAlignment(source, target);
      EXPECT_LT((R * axes_n - axes_c * Eigen::Vector3d(-1, -1, 1).asDiagonal()).norm(), 1e-14);
      EXPECT_LT((nominalAlignment(target, source) - R.transpose()).norm(), 1e-14);
      if (source.vector_m.z() != 0 || target.vector_m.z() != 0) continue;
      EXPECT_NEAR((R * target.vector_m.normalized() + source.vector_m.normalized()).norm(), 0, 1e-15);
      EXPECT_EQ(R.col(2), Eigen::Vector3d(Eigen::Vector3d::UnitZ()));
    }
  }
}

TEST(NominalAlignment, OfPortsOfOppositeHeightIsAStep) {
  const std::vector<Port> ports = portsWithHeight();
  EXPECT_LT((nominalAlignment(ports[5], ports[6]) - Eigen::Matrix3d::Identity()).norm(), 1e-15);
}

TEST(LinkAngles, AreTheSameFromBothEndsButForTheSenseOfYaw) {
  const Eigen::Vector3d expected(0.1, 0.4, -0.2);
  for (const Port& source : portsWithHeight()) {
    for (const Port& target : portsWithHeight()) {
      const Eigen::Matrix3d R_c_n = expSO3(linkAxes(source) * expected) * nominalAlignment(source, target);
      const LinkAngles there = linkAngles(R_c_n, source, target);
      const LinkAngles back = linkAngles(R_c_n.transpose(), target, source);
      EXPECT_LT((Eigen::Vector3d(there.twist_rad, there.bend_rad, there.yaw_rad) - expected).norm(), 1e-13);
      EXPECT_LT((Eigen::Vector3d(back.twist_rad, back.bend_rad, -back.yaw_rad) - expected).norm(), 1e-13);
    }
  }
}

TEST(LinkTransform, LetsBothExtendedPortVectorsEndInOnePoint) {
  const CellModel model = ownModel();
  const Port& source = model.port(PortNumber(9));
  const Port& target = model.port(PortNumber(1));
  const SE3 T_c_n = linkTransform(expSO3({0.3, -0.2, 1.0}), source, target);
  EXPECT_NEAR((T_c_n * target.vector_m - source.vector_m).norm(), 0, 1e-17);
}

}  // namespace
}  // namespace hexoderm
