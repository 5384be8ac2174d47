#include "hexoderm/robots/robot_model.h"

#include "hexoderm/base/units.h"
#include "tests/support/paths.h"
#include "tests/support/temporary_folder.h"
#include "tests/support/testing.h"

namespace hexoderm {
namespace {

using test::TemporaryFolder;

const RobotModel& readDemoArm() {
  static const RobotModel arm = RobotModel::read(HEXODERM_DEMO_ROBOT);
  return arm;
}

RobotModel parsed(const std::string& urdf) { return RobotModel::parse(urdf, "r.urdf"); }
std::string complaint(const std::string& urdf) {
  return messageOf<FormatError>([&] { parsed(urdf); });
}
std::string complaintAboutBody(const RobotModel& robot) {
  return messageOf<FormatError>([&] { static_cast<void>(robot.bodyOf(0)); });
}
/// A robot of two links and whatever stands in the joint between them.
std::string twoLinks(const std::string& joint, const std::string& type = "revolute") {
  return "<robot name=\"r\"><link name=\"a\"/><link name=\"b\"/>\n<joint name=\"j\" type=\"" + type +
         "\"><parent link=\"a\"/><child link=\"b\"/>" + joint + "</joint></robot>";
}
const std::string kLimit = "<limit lower=\"-1\" upper=\"1\" effort=\"1\" velocity=\"1\"/>";
/// A robot of one link with a shape.
std::string oneLink(const std::string& geometry) {
  return "<robot name=\"r\"><link name=\"a\"><visual><geometry>" + geometry + "</geometry></visual></link></robot>";
}

TEST(RobotModel, ReadsTheDemoArm) {
  const RobotModel& arm = readDemoArm();
  EXPECT_EQ(arm.name(), "demo_arm");
  EXPECT_EQ(arm.links()[arm.rootLink()].name, "base");
  EXPECT_EQ(arm.links().size(), 7U);
  EXPECT_EQ(arm.freeJointNames(),
            (std::vector<std::string>{"shoulder_pitch", "shoulder_roll", "elbow", "wrist_yaw", "grip"}));
  const RobotJoint& elbow = arm.joints()[arm.jointNamed("elbow")];
  EXPECT_EQ(elbow.type, JointType::Revolute);
  EXPECT_EQ(elbow.axis, Eigen::Vector3d(0, -1, 0));
  EXPECT_EQ(elbow.limits->upper, 2.3);
  EXPECT_TRUE(arm.notes().empty());
  EXPECT_EQ(arm.sha256().size(), 64U);
}

/// The same by plain products of URDF's definitions.
SE3 byHand(const RobotModel& robot, std::size_t link, const JointAngles& angles) {
  if (!robot.links()[link].joint) return {};
  const RobotJoint& joint = robot.joints()[*robot.links()[link].joint];
  const auto position = [&](const std::string& name) {
    const auto found = angles.positions.find(name);
    return found == angles.positions.end() ? 0 : found->second;
  };
  const double q =
      joint.mimic ? joint.mimic->multiplier * position(robot.joints()[joint.mimic->joint].name) + joint.mimic->offset
                  : position(joint.name);
  SE3 T_joint_child;
  if (joint.type == JointType::Prismatic) {
    T_joint_child.t = q * joint.axis;
  } else if (joint.type != JointType::Fixed) {
    T_joint_child.R = Eigen::AngleAxisd(q, joint.axis).toRotationMatrix();
  }
  return byHand(robot, joint.parent, angles) * joint.T_parent_joint * T_joint_child;
}

TEST(RobotModel, LinksAreWhereProductsByHandPutThem) {
  const RobotModel& arm = readDemoArm();
  std::mt19937_64 random(1);
  std::uniform_real_distribution<double> angle(-3, 3);
  for (int trial = 0; trial < 20; ++trial) {
    JointAngles angles;
    for (const std::string& name : arm.freeJointNames()) angles.positions[name] = angle(random);
    const std::vector<SE3> T_w_l = arm.forward(angles);
    for (std::size_t link = 0; link < arm.links().size(); ++link) {
      const SE3 expected = byHand(arm, link, angles);
      EXPECT_LT((T_w_l[link].R - expected.R).norm(), 1e-12) << arm.links()[link].name;
      EXPECT_LT((T_w_l[link].t - expected.t).norm(), 1e-12) << arm.links()[link].name;
    }
  }
}

TEST(RobotModel, AMimickingJointFollowsUnlessItIsGivenItself) {
  const RobotModel& arm = readDemoArm();
  const std::size_t finger = arm.linkNamed("right_finger");
  const auto inHand = [&](const JointAngles& angles) {
    const std::vector<SE3> T_w_l = arm.forward(angles);
    return (T_w_l[arm.linkNamed("hand")].inverse() * T_w_l[finger]).t.x();
  };
  EXPECT_NEAR(inHand({{{"grip", 0.02}}}), -0.03, 1e-12);
  EXPECT_NEAR(inHand({{{"grip", 0.02}, {"grip_other", 0.01}}}), -0.02, 1e-12);
}

TEST(RobotModel, KnowsTheJointsThatMoveALink) {
  const RobotModel& arm = readDemoArm();
  const auto names = [&](const char* link) {
    return collect(arm.freeJointsTo(arm.linkNamed(link)), [&](std::size_t joint) { return arm.joints()[joint].name; });
  };
  EXPECT_TRUE(names("base").empty());
  EXPECT_EQ(names("forearm"), (std::vector<std::string>{"shoulder_pitch", "shoulder_roll", "elbow"}));
  EXPECT_EQ(names("right_finger"), names("left_finger"));
}

TEST(RobotModel, BodiesAreClosedMeshesOfTheLinksSize) {
  const RobotModel& arm = readDemoArm();
  const TriangleMesh forearm = arm.bodyOf(arm.linkNamed("forearm"));
  EXPECT_NEAR(boundingBox(forearm).high.z(), 0.27, 1e-6);
  EXPECT_GT(enclosedVolume(forearm), 0.0008);
  EXPECT_LT(enclosedVolume(forearm), 0.0020);
  const TriangleMesh upper_arm = arm.bodyOf(arm.linkNamed("upper_arm"));
  EXPECT_LT((boundingBox(upper_arm).size() - Eigen::Vector3d(0.15, 0.13, 0.28)).norm(), 1e-3);
  EXPECT_GT(enclosedVolume(upper_arm), 0.004);
  // The base's box and post, each where its origin says.
  const BoundingBox base = boundingBox(arm.bodyOf(arm.rootLink()));
  EXPECT_NEAR(base.low.z(), 0, 1e-12);
  EXPECT_NEAR(base.high.z(), 0.57, 1e-12);
  for (std::size_t link = 0; link < arm.links().size(); ++link) {
    EXPECT_FALSE(arm.suspectedUnit(link, arm.bodyOf(link))) << arm.links()[link].name;
  }
}

TEST(RobotModel, TakesTheBodyThatIsAskedFor) {
  const RobotModel robot = parsed(
      "<robot name=\"r\"><link name=\"a\"><visual><geometry><box size=\"1 1 1\"/></geometry></visual>"
      "<collision><geometry><sphere radius=\"2\"/></geometry></collision></link><link name=\"b\"/>"
      "<joint name=\"j\" type=\"fixed\"><parent link=\"a\"/><child link=\"b\"/></joint></robot>");
  EXPECT_NEAR(boundingBox(robot.bodyOf(0)).size().x(), 1, 1e-12);
  EXPECT_NEAR(boundingBox(robot.bodyOf(0, LinkBody::Collision)).size().x(), 4, 1e-12);
  EXPECT_TRUE(robot.hasBody(0));
  EXPECT_FALSE(robot.hasBody(1));
  EXPECT_TRUE(robot.bodyOf(1).empty());
  EXPECT_FALSE(robot.suspectedUnit(1, robot.bodyOf(1)));
}

TEST(RobotModel, TakesFloatingAndPlanarJointsAsFixedAndSaysSo) {
  const RobotModel robot = parsed(twoLinks("<origin xyz=\"0 0 1\"/>", "floating"));
  ASSERT_EQ(robot.notes().size(), 1U);
  EXPECT_THAT(robot.notes()[0].english(), saysAll("oint j", "floating", "fixed"));
  EXPECT_EQ(robot.forward({})[1].t.z(), 1);
}

TEST(RobotModel, NamesWhatIsNoUrdf) {
  EXPECT_THAT(complaint(""), saysAll("r.urdf", "line 1", "XML"));
  EXPECT_THAT(complaint("<robot name=\"r\"><link"), saysAll("r.urdf", "line 1", "XML", "URDF"));
  EXPECT_THAT(complaint("<sdf version=\"1.6\"/>"), saysAll("line 1", "<robot>", "<sdf>"));
  EXPECT_THAT(complaint("<robot name=\"r\"/>"), saysAll("links"));
  EXPECT_THAT(complaint("<robot><link name=\"a\"/></robot>"), saysAll("r.urdf", "urdfdom"));
  EXPECT_THAT(messageOf<StorageError>([] { RobotModel::read("/nowhere/r.urdf"); }), saysAll("/nowhere/r.urdf"));
}

TEST(RobotModel, RecognisesXacro) {
  EXPECT_THAT(complaint("<robot name=\"r\">\n<xacro:include filename=\"x\"/><link name=\"a\"/></robot>"),
              saysAll("line 2", "xacro:include", "run xacro first"));
  EXPECT_THAT(complaint("<robot name=\"r\"><link name=\"${side}_arm\"/></robot>"), saysAll("${side}_arm", "run xacro"));
  // What xacro writes may still name its namespace.
  EXPECT_NO_THROW(parsed("<robot name=\"r\" xmlns:xacro=\"http://ros.org/wiki/xacro\"><link name=\"a\"/></robot>"));
}

TEST(RobotModel, NamesWhatIsNoTree) {
  const std::string links = "<robot name=\"r\"><link name=\"a\"/><link name=\"b\"/><link name=\"c\"/>";
  const auto joint = [](const std::string& name, const std::string& parent, const std::string& child) {
    return "\n<joint name=\"" + name + "\" type=\"fixed\"><parent link=\"" + parent + "\"/><child link=\"" + child +
           "\"/></joint>";
  };
  EXPECT_THAT(complaint(links + joint("j", "b", "c") + joint("k", "c", "b") + "</robot>"),
              saysAll("r.urdf", "line", "j", "k", "form a loop"));
  EXPECT_THAT(complaint(links + joint("j", "a", "a") + "</robot>"), saysAll("loop", "j"));
  EXPECT_THAT(complaint(links + joint("j", "a", "c") + joint("k", "b", "c") + "</robot>"),
              saysAll("line 3", "link c", "two parents", "j", "k"));
  EXPECT_THAT(complaint(links + joint("j", "a", "c") + "</robot>"), saysAll("link b", "link a", "one root"));
  EXPECT_THAT(complaint(links + joint("j", "aa", "c") + "</robot>"), saysAll("line 2", "parent", "joint j", "\"aa\""));
  EXPECT_THAT(complaint(links + joint("forearm", "a", "") + "</robot>"), saysAll("forearm", "child"));
  EXPECT_THAT(complaint(links + joint("j", "a", "b") + joint("j", "a", "c") + "</robot>"),
              saysAll("line 3", "joint j", "line 2"));
  EXPECT_THAT(complaint("<robot name=\"r\"><link name=\"a\"/><link name=\"a\"/></robot>"), saysAll("link a"));
  EXPECT_THAT(complaint("<robot name=\"r\"><link/></robot>"), saysAll("<link>", "name"));
}

TEST(RobotModel, ADeepChainIsReadAndADeepNestIsRefused) {
  std::string chain = "<robot name=\"r\"><link name=\"l0\"/>";
  constexpr int kLinks = 2000;
  for (int k = 1; k <= kLinks; ++k) {
    chain += "<link name=\"l" + std::to_string(k) + "\"/><joint name=\"j" + std::to_string(k) +
             "\" type=\"fixed\"><parent link=\"l" + std::to_string(k - 1) + "\"/><child link=\"l" + std::to_string(k) +
             "\"/><origin xyz=\"0 0 0.1\"/></joint>";
  }
  EXPECT_NEAR(parsed(chain + "</robot>").forward({})[kLinks].t.z(), 0.1 * kLinks, 1e-9);

  std::string nest;
  for (int k = 0; k < 5000; ++k) nest += "<x>";
  for (int k = 0; k < 5000; ++k) nest += "</x>";
  EXPECT_THAT(complaint("<robot name=\"r\"><link name=\"a\"/>" + nest + "</robot>"), saysAll("nested too deeply"));
}

TEST(RobotModel, NamesNumbersThatMakeNoRobot) {
  EXPECT_THAT(complaint(twoLinks("<origin xyz=\"0 0 1e9\"/>", "fixed")), saysAll("line 2", "joint j", "1000"));
  EXPECT_THAT(complaint(twoLinks("<origin xyz=\"0 0 nan\"/>", "fixed")), saysAll("r.urdf"));
  EXPECT_THAT(complaint(twoLinks("<origin xyz=\"0 0 1e999\"/>", "fixed")), saysAll("r.urdf"));
  EXPECT_THAT(complaint(twoLinks("<origin xyz=\"0 zero 0\"/>", "fixed")), saysAll("r.urdf", "zero"));
  EXPECT_THAT(complaint(twoLinks("<axis xyz=\"0 0 0\"/>" + kLimit)), saysAll("joint j", "axis", "0"));
  EXPECT_THAT(complaint(twoLinks("")), saysAll("j"));  // a revolute joint needs limits
  EXPECT_THAT(complaint(twoLinks("", "ball")), saysAll("j", "ball"));
  EXPECT_THAT(complaint(twoLinks("<mimic joint=\"k\"/>" + kLimit)), saysAll("joint j", "mimics joint k"));
  EXPECT_THAT(complaint(twoLinks("<mimic joint=\"j\"/>" + kLimit)), saysAll("joint j", "circle"));
}

TEST(RobotModel, NamesNumbersThatAreTooLarge) {
  const auto limits = [](const std::string& lower, const std::string& upper) {
    return "<limit lower=\"" + lower + "\" upper=\"" + upper + "\" effort=\"1\" velocity=\"1\"/>";
  };
  const std::string too_wide =
      "r.urdf: line 2: joint j: expected limits within 1000000; a joint without limits is of the "
      "type continuous";
  EXPECT_EQ(complaint(twoLinks(limits("-1e300", "1e300"))), too_wide);
  EXPECT_EQ(complaint(twoLinks(limits("0", "1e300"))), too_wide);
  EXPECT_EQ(complaint(twoLinks(limits("1", "-1"))),
            "r.urdf: line 2: joint j: expected limits of which the lower is not above the upper");
  EXPECT_EQ(complaint(twoLinks("<axis xyz=\"0 0 1e300\"/>" + kLimit)),
            "r.urdf: line 2: joint j: expected an axis of three numbers within 1000000");
  EXPECT_EQ(complaint(twoLinks("<mimic joint=\"j\" multiplier=\"1e300\"/>" + kLimit)),
            "r.urdf: line 2: joint j: expected a multiplier and an offset within 1000000");
  EXPECT_EQ(
      complaint(twoLinks("<origin rpy=\"1e300 0 0\"/>", "fixed")),
      "r.urdf: line 2: joint j: <origin rpy=\"1e300 0 0\">: expected three angles within 1000000 rad, separated by "
      "blanks");
}

TEST(RobotModel, NamesAnAttributeThatIsThereTwice) {
  EXPECT_EQ(complaint("<robot name='r'>\n<link name='a' name='b'/></robot>"),
            "r.urdf: line 2: <link> has the attribute name twice: expected each attribute once");
  EXPECT_THAT(complaint("<robot name='r'>\n<link name='a'>\n<visual><geometry><box size='1 1 1' size='2 2 2'/>"
                        "</geometry></visual></link></robot>"),
              saysAll("r.urdf: line 3", "<box> has the attribute size twice"));
}

TEST(RobotModel, RefusesDefinitionsInADoctype) {
  const std::string robot = "<robot name='r'><link name='a'/></robot>";
  EXPECT_EQ(parsed("<!DOCTYPE robot>\n" + robot).links().size(), 1U);
  EXPECT_THAT(complaint("<?xml version='1.0'?>\n<!DOCTYPE robot [<!ENTITY n 'a'>]>\n" + robot),
              saysAll("r.urdf: line 2", "DOCTYPE", "entities", "expected a URDF without them"));
}

TEST(RobotModel, AMalformedShapeIsRefusedWithItsPlaceOnceItsBodyIsAskedFor) {
  struct Malformed {
    const char* geometry;
    std::string says;
  };
  const std::string length = "expected a length above 0 and at most 1000 m";
  const std::string lengths = "expected three lengths above 0 and at most 1000 m, separated by blanks";
  const std::string scale = "expected three numbers within 1000000, none of them 0, separated by blanks";
  for (const Malformed& shape : std::vector<Malformed>{
           {"<box size='0 1 1'/>", "<box size=\"0 1 1\">: " + lengths},
           {"<box size='0,3 0,3 0,3'/>", "<box size=\"0,3 0,3 0,3\">: " + lengths},
           {"<box size='1 1 1 1'/>", "<box size=\"1 1 1 1\">: " + lengths},
           {"<box/>", "<box> has no size: " + lengths},
           {"<sphere radius='-1'/>", "<sphere radius=\"-1\">: " + length},
           {"<sphere radius='x'/>", "<sphere radius=\"x\">: " + length},
           {"<cylinder radius='1' length='1e9'/>", "<cylinder length=\"1e9\">: " + length},
           {"<cylinder radius='1'/>", "<cylinder> has no length: " + length},
           {"<mesh filename='m.stl' scale='0 1 1'/>", "<mesh scale=\"0 1 1\">: " + scale},
           {"<mesh filename='m.stl' scale='nan nan nan'/>", "<mesh scale=\"nan nan nan\">: " + scale},
           {"<mesh filename='m.stl' scale='1 1'/>", "<mesh scale=\"1 1\">: " + scale},
           {"<mesh filename='m.stl' scale='a b c'/>", "<mesh scale=\"a b c\">: " + scale},
           {"<mesh/>", "<mesh> has no filename: expected package://NAME/FILE, file:///FILE or a path"},
           {"<capsule radius='1' length='1'/>", "<capsule>: expected a box, cylinder, sphere or mesh"},
           {"<!-- none -->", "<visual> has no <geometry> with a box, cylinder, sphere or mesh"},
           {"<box size='1 1 1'/></geometry><origin xyz='nan 0 0'/><geometry>",
            "<origin xyz=\"nan 0 0\">: expected three coordinates within 1000 m, separated by blanks"},
           {"<box size='1 1 1'/></geometry><origin rpy='0,5 0 0'/><geometry>",
            "<origin rpy=\"0,5 0 0\">: expected three angles within 1000000 rad, separated by blanks"},
           {"<box size='1 1 1'/></geometry><origin rpy='1e300 0 0'/><geometry>",
            "<origin rpy=\"1e300 0 0\">: expected three angles within 1000000 rad, separated by blanks"},
           {"<mesh filename='m.stl' scale='1e300 1 1'/>", "<mesh scale=\"1e300 1 1\">: " + scale},
           {"<box size='1 1 1'/><!-- and --><sphere radius='1'/>",
            "<geometry> has a second shape, <sphere>: expected one, and another <visual> for each further shape"},
           {"<box size='1 1 1'/></geometry><geometry><sphere radius='1'/>",
            "<visual> has a second <geometry>: expected one, and another <visual> for each further shape"}}) {
    const RobotModel robot = parsed(oneLink(shape.geometry));
    EXPECT_TRUE(robot.hasBody(0));
    EXPECT_EQ(complaintAboutBody(robot), "r.urdf: line 1: link a: " + shape.says);
  }
}

TEST(RobotModel, AMalformedShapeStandsInTheWayOfNothingElse) {
  const std::string box = "<geometry><box size='1 1 1'/></geometry>";
  const RobotModel robot =
      parsed("<robot name='r'><link name='a'>\n<visual>" + box + "</visual>\n<visual><origin xyz='0,5 0 0'/>" + box +
             "</visual><collision>" + box + "</collision></link>\n<link name='b'><inertial/><visual><material/>" + box +
             "</visual></link><joint name='j' type='fixed'><parent link='a'/><child link='b'/></joint></robot>");
  EXPECT_THAT(complaintAboutBody(robot), saysAll("line 3", "link a", "<origin xyz=\"0,5 0 0\">"));
  EXPECT_EQ(robot.bodyOf(0, LinkBody::Collision).triangles.size(), 12U);
  EXPECT_EQ(robot.bodyOf(1).triangles.size(), 12U) << "what is no shape may be malformed";
}

TEST(RobotModel, TheTrianglesOfALinkAreLimitedHoweverOftenShapesRepeat) {
  std::string link = "<robot name='r'><link name='a'>";
  for (int k = 0; k < 1000; ++k) link += "<visual><geometry><sphere radius='1'/></geometry></visual>";
  EXPECT_THAT(complaintAboutBody(parsed(link + "</link></robot>")),
              saysAll("r.urdf: link a", "2208000 triangles", "at most 2000000"));
}

TEST(RobotModel, AbsurdSizesOfElementsAreRefused) {
  std::string attributes;
  for (int k = 0; k < 101; ++k) attributes += " a" + std::to_string(k) + "='1'";
  EXPECT_THAT(complaint("<robot name='r'>\n<link name='a'" + attributes + "/></robot>"),
              saysAll("r.urdf: line 2", "more than 100 attributes"));
  const std::string name(1'000'000, 'n');
  for (const std::string& urdf :
       {"<robot name='" + name + "'><link name='a'/></robot>", "<robot name='r'><link name='" + name + "'/></robot>"}) {
    const std::string what = complaint(urdf);
    EXPECT_THAT(what, saysAll("r.urdf: line 1", "at most 1000 characters"));
    EXPECT_LT(what.size(), 200U);
  }
}

TEST(RobotModel, RefusesAnglesOfUnknownJointsAndThoseThatAreNoNumbers) {
  const RobotModel& arm = readDemoArm();
  EXPECT_THAT(messageOf<InvalidArgument>([&] {
                static_cast<void>(arm.forward({{{"elbo", 1}}}));
              }),
              saysAll("demo_arm.urdf", "elbo", "did you mean elbow?"));
  EXPECT_THAT(messageOf<InvalidArgument>([&] {
                static_cast<void>(arm.forward({{{"elbow", std::numeric_limits<double>::quiet_NaN()}}}));
              }),
              saysAll("elbow", "finite"));
  EXPECT_THAT(messageOf<InvalidArgument>([&] { static_cast<void>(arm.linkNamed("fore_arm")); }),
              saysAll("did you mean forearm?"));
}

constexpr const char* kTriangleObj = "v 0 0 0\nv 0.1 0 0\nv 0 0.1 0\nv 0 0 0.1\nf 1 3 2\nf 1 2 4\nf 1 4 3\nf 2 3 4\n";

TEST(RobotModel, FindsMeshesByPackageFileAndPath) {
  const TemporaryFolder folder;
  std::filesystem::create_directories(folder.path() / "arm_description" / "urdf");
  std::filesystem::create_directories(folder.path() / "arm_description" / "meshes");
  const std::filesystem::path mesh = folder.put("arm_description/meshes/m.obj", kTriangleObj);
  const auto size = [&](const std::string& address, PackageFolders packages = {}) {
    const std::filesystem::path urdf =
        folder.put("arm_description/urdf/r.urdf", oneLink("<mesh filename=\"" + address + "\"/>"));
    const RobotModel robot = RobotModel::read(urdf, std::move(packages));
    return boundingBox(robot.bodyOf(0)).size().x();
  };
  EXPECT_NEAR(size("package://arm_description/meshes/m.obj"), 0.1, 1e-6);  // the folder above of that name
  EXPECT_NEAR(size("package://other/m.obj", {{"other", mesh.parent_path()}}), 0.1, 1e-6);
  EXPECT_NEAR(size("model://other/m.obj", {{"other", mesh.parent_path()}}), 0.1, 1e-6);
  EXPECT_NEAR(size("../meshes/m.obj"), 0.1, 1e-6);
  EXPECT_NEAR(size(mesh.string()), 0.1, 1e-6);
  EXPECT_NEAR(size("file://" + mesh.string()), 0.1, 1e-6);

  EXPECT_THAT(messageOf<FormatError>([&] { size("package://other/m.obj"); }),
              saysAll("r.urdf", "link a", "package://other/m.obj", "--package other=FOLDER"));
  EXPECT_THAT(messageOf<FormatError>([&] { size("http://x/m.obj"); }),
              saysAll("http://x/m.obj", "expected package://"));
}

TEST(RobotModel, OpensMeshesOnlyWhenTheyAreAskedForAndNamesThemThen) {
  const TemporaryFolder folder;
  const auto body = [&](const std::string& file) {
    const RobotModel robot = RobotModel::read(folder.put("r.urdf", oneLink("<mesh filename=\"" + file + "\"/>")));
    return robot.bodyOf(0);
  };
  EXPECT_NO_THROW(parsed(oneLink("<mesh filename=\"missing.stl\"/>")));
  EXPECT_THAT(messageOf<StorageError>([&] { body("missing.stl"); }),
              saysAll("r.urdf", "link a", "missing.stl", "no such"));
  folder.put("text.stl", "no mesh at all");
  EXPECT_THAT(messageOf<FormatError>([&] { body("text.stl"); }), saysAll("link a", "text.stl"));
  folder.put("points.obj", "v 0 0 0\nv 1 0 0\n");
  EXPECT_THAT(messageOf<FormatError>([&] { body("points.obj"); }), saysAll("link a", "points.obj"));
  EXPECT_THAT(messageOf<StorageError>([&] { body("."); }), saysAll("link a", "expected a mesh file"));
}

TEST(RobotModel, RefusesABodyOfTrianglesWithoutAnArea) {
  const TemporaryFolder folder;
  folder.put("flat.obj", "v 0 0 0\nv 1 0 0\nv 2 0 0\nf 1 2 3\n");
  folder.put("m.obj", kTriangleObj);
  const std::string flat = "<mesh filename=\"flat.obj\"/>";
  const RobotModel alone = RobotModel::read(folder.put("r.urdf", oneLink(flat)));
  EXPECT_THAT(complaintAboutBody(alone), saysAll("r.urdf: link a", "flat.obj", "no triangle with an area"));
  const RobotModel beside = RobotModel::read(
      folder.put("r.urdf", oneLink(flat + "</geometry></visual><visual><geometry><mesh filename=\"m.obj\"/>")));
  EXPECT_EQ(beside.bodyOf(0).triangles.size(), 5U);
}

TEST(RobotModel, ScalesMeshesAndKeepsTheOutsideOfMirroredOnes) {
  const TemporaryFolder folder;
  folder.put("m.obj", kTriangleObj);
  const auto volume = [&](const std::string& scale) {
    const RobotModel robot =
        RobotModel::read(folder.put("r.urdf", oneLink("<mesh filename=\"m.obj\" scale=\"" + scale + "\"/>")));
    return enclosedVolume(robot.bodyOf(0));
  };
  EXPECT_NEAR(volume("1 1 1"), 1e-3 / 6, 1e-9);
  EXPECT_NEAR(volume("2 1 1"), 2e-3 / 6, 1e-9);
  EXPECT_NEAR(volume("1 -1 1"), 1e-3 / 6, 1e-9);
}

TEST(RobotModel, NoticesMeshesInMillimetres) {
  const RobotModel& arm = readDemoArm();
  const std::size_t forearm = arm.linkNamed("forearm");
  TriangleMesh body = arm.bodyOf(forearm);
  const auto scaledBy = [&](double factor) {
    TriangleMesh mesh = body;
    for (Eigen::Vector3d& point : mesh.points) point *= factor;
    return arm.suspectedUnit(forearm, mesh);
  };
  const auto suspicion = scaledBy(1000);
  ASSERT_TRUE(suspicion);
  EXPECT_EQ(suspicion->factor, 0.001);
  EXPECT_NEAR(suspicion->size_m, 270, 1e-3);
  EXPECT_THAT(suspicion->message.english(), saysAll("forearm", "270.0 m", "millimetres", "0.001", "270 mm"));
  EXPECT_FALSE(scaledBy(1));
  EXPECT_FALSE(scaledBy(3));
  const auto tiny = scaledBy(0.001);
  ASSERT_TRUE(tiny);
  EXPECT_EQ(tiny->factor, 1000);
}

}  // namespace
}  // namespace hexoderm
