#include "tests/core/robots/mesh_test.h"

namespace hexoderm {
namespace {

/// A square of side 1 with these primitives, below these nodes of the scene and library.
std::string dae(const std::string& primitives,
                const std::string& nodes = R"(<node><instance_geometry url="#g"/></node>)",
                const std::string& library = "") {
  return R"(<?xml version="1.0"?><!DOCTYPE COLLADA [<!ENTITY a "1 2"><!ENTITY b "&a;&a;">]>
<COLLADA version="1.4.1"><asset><unit meter="2"/></asset><library_geometries><geometry id="g"><mesh>
<source id="n"><float_array id="na" count="3">0 0 1</float_array><technique_common>
<accessor source="#na" count="1" stride="3"/></technique_common></source>
<source id="s"><float_array id="sa">9 -1 0 0 0 -1 1 0 0 <!-- rest --> -1 1 1 0 -1 0 1 0</float_array><technique_common>
<accessor source="#sa" count="4" offset="1" stride="4"><param type="float"/><param name="X"/><param name="Y"/>
<param name="Z"/></accessor></technique_common></source>
<vertices id="v"><input semantic="NORMAL" source="#n"/><input semantic="POSITION" source="#s"/></vertices>)" +
         primitives + "</mesh></geometry></library_geometries>" + library +
         R"(<library_visual_scenes><visual_scene id="vs">)" + nodes +
         R"(</visual_scene></library_visual_scenes><scene><instance_visual_scene url="#vs"/></scene></COLLADA>)";
}

constexpr auto kInputs =
    R"(<input semantic="NORMAL" source="#n" offset="0"/><input semantic="VERTEX" source="#v" offset="1"/>)";
const std::string kTwoTriangles = std::string("<triangles>") + kInputs + "<p>0 0 0 1 0 2 0 0 0 2 0 3</p></triangles>";

TEST(Collada, ReadsAllKindsOfPolygons) {
  const std::string in = kInputs;
  for (const std::string& primitives :
       {kTwoTriangles, "<polylist>" + in + "<vcount>4 2</vcount><p>0 0 0 1 0 2 0 3 0 0 0 1</p></polylist>",
        "<polygons>" + in + "<p>0 0 0 1 0 2</p><p>0 0 0 2 0 3</p></polygons>",
        "<trifans>" + in + "<p>0 0 0 1 0 2 0 3</p></trifans>",
        "<tristrips>" + in + "<p>0 0 0 1 0 3 0 2</p></tristrips>",
        "<lines>" + in + "<p>0 0 0 1</p></lines><triangles/>" + kTwoTriangles}) {
    const TriangleMesh mesh = readMesh(dae(primitives), "m");
    EXPECT_EQ(mesh.triangles.size(), 2U) << primitives;
    EXPECT_EQ(mesh.points.size(), 4U) << primitives;
    EXPECT_DOUBLE_EQ(areaOf(mesh), 4) << "in metres: " << primitives;
    EXPECT_EQ(boundingBox(mesh).high, Eigen::Vector3d(2, 2, 0)) << primitives;
  }
}

TEST(Collada, AppliesTheTransformsOfNodesInTheirOrder) {
  const auto box = [](const std::string& transforms) {
    return boundingBox(
        readMesh(dae(kTwoTriangles, "<node>" + transforms + R"(<instance_geometry url="#g"/></node>)"), "m"));
  };
  EXPECT_EQ(box("<translate>1 0 0</translate><scale>3 1 1</scale>").high, Eigen::Vector3d(8, 2, 0));
  EXPECT_EQ(box("<scale>3 1 1</scale><translate>1 0 0</translate>").high, Eigen::Vector3d(12, 2, 0));
  EXPECT_LT((box("<rotate>0 0 2 90</rotate>").low - Eigen::Vector3d(-2, 0, 0)).norm(), 1e-15);
  EXPECT_EQ(box("<matrix>1 0 0 5 0 1 0 0 0 0 1 0 0 0 0 1</matrix>").low, Eigen::Vector3d(10, 0, 0));
  // From (0, 0, 3) towards the origin: the axes of the eye are those of the file.
  EXPECT_LT((box("<lookat>0 0 3 0 0 0 0 1 0</lookat>").high - Eigen::Vector3d(2, 2, 6)).norm(), 1e-15);
  EXPECT_EQ(box("<node/><extra/><asset/>").high, Eigen::Vector3d(2, 2, 0));
}

TEST(Collada, UsesNodesAndControllersSeveralTimes) {
  const std::string library = R"(<library_nodes><node id="twice"><node><instance_geometry url="#g"/></node>
      <node><translate>0 0 1</translate><instance_controller url="#c"/></node></node></library_nodes>
      <library_controllers><controller id="c"><skin source="#d"/></controller>
      <controller id="d"><morph source="#g"/></controller></library_controllers>)";
  const std::string nodes = R"(<node id="twice2"><instance_node url="#twice"/></node>
      <node><scale>-1 1 1</scale><instance_node url="#twice2"/></node>)";
  const TriangleMesh mesh = readMesh(dae(kTwoTriangles, nodes, library), "m");
  EXPECT_EQ(mesh.triangles.size(), 8U);
  EXPECT_DOUBLE_EQ(areaOf(mesh), 16);
  for (const auto& [a, b, c] : mesh.triangles) {
    EXPECT_GT((mesh.points[b] - mesh.points[a]).cross(mesh.points[c] - mesh.points[a]).z(), 0)
        << "mirrored, not inside out";
  }
}

/// Nodes n0, with something in it, to n`levels`, each of which has the one before twice.
std::string doublingNodes(int levels, const std::string& inner) {
  std::string library = "<library_nodes><node id=\"n0\">" + inner + "</node>";
  for (int k = 1; k <= levels; ++k) {
    const std::string below = "<instance_node url=\"#n" + std::to_string(k - 1) + "\"/>";
    library += "<node id=\"n" + std::to_string(k) + "\">" + below + below + "</node>";
  }
  return library + "</library_nodes>";
}

TEST(Collada, RefusesNodesThatContainThemselvesAndScenesThatExplode) {
  EXPECT_THAT(refusalOf("m", dae(kTwoTriangles, R"(<node id="n"><instance_node url="#n"/></node>)")),
              saysAll("contain themselves"));
  EXPECT_THAT(
      refusalOf("m", dae(kTwoTriangles, R"(<node id="n"><instance_node url="#n"/><instance_node url="#n"/></node>)")),
      saysAll("contain themselves"));
  EXPECT_THAT(refusalOf("m", dae(kTwoTriangles, R"(<node><instance_controller url="#c"/></node>)",
                                 R"(<controller id="c"><skin source="#c"/></controller>)")),
              saysAll("contain themselves"));
  for (const char* inner : {R"(<instance_geometry url="#g"/>)", ""}) {
    EXPECT_THAT(refusalOf("m", dae(kTwoTriangles, R"(<instance_node url="#n30"/>)", doublingNodes(30, inner))),
                saysAll("100000 nodes"));
  }
}

TEST(Collada, RefusesAPartThatIsRepeatedTooOften) {
  std::string corners;
  for (int k = 0; k < 100; ++k) corners += "0 0 0 1 0 2 ";
  EXPECT_THAT(
      refusalOf("m", dae(std::string("<triangles>") + kInputs + "<p>" + corners + "</p></triangles>",
                         R"(<instance_node url="#n14"/>)", doublingNodes(14, R"(<instance_geometry url="#g"/>)"))),
      saysAll("more than 50", "triangles"));
}

TEST(Collada, RefusesReferencesAndNumbersThatLeadNowhere) {
  const auto complaint = [](const std::string& primitives) { return refusalOf("m.dae", dae(primitives)); };
  const std::string in = kInputs;
  EXPECT_THAT(complaint("<triangles>" + in + "<p>0 0 0 1 0 4</p></triangles>"),
              saysAll("m.dae", "point 4", "4 points"));
  EXPECT_THAT(complaint("<triangles>" + in + "<p>0 0 0 1 0 4294967295</p></triangles>"), saysAll("point 4294967295"));
  EXPECT_THAT(complaint("<triangles>" + in + "<p>0 0 0 1 0 -2</p></triangles>"), saysAll("<p>"));
  EXPECT_THAT(complaint("<triangles>" + in + "<p>0 0 0 1 0</p></triangles>"), saysAll("<p>"));
  EXPECT_THAT(complaint("<triangles>" + in + "<p>0 0 0 1</p></triangles>"), saysAll("<p>"));
  EXPECT_THAT(complaint("<triangles><p>0 1 2</p></triangles>"), saysAll("positions", "<triangles>"));
  EXPECT_THAT(complaint("<polylist>" + in + "<vcount>4000000000</vcount><p>0 0</p></polylist>"), saysAll("<polylist>"));
  EXPECT_THAT(complaint("<polylist>" + in + "<p>0 0 0 1 0 2</p></polylist>"), saysAll("<polylist>"));
  EXPECT_THAT(complaint("<polygons>" + in + "<ph><p>0 0 0 1 0 2</p></ph></polygons>"), saysAll("holes"));
  EXPECT_THAT(complaint(R"(<triangles><input semantic="VERTEX" source="#x" offset="0"/></triangles>)"),
              saysAll("<vertices>", "#x"));
  EXPECT_THAT(complaint(R"(<triangles><input semantic="VERTEX" source="#v" offset="4294967295"/><p>1</p></triangles>)"),
              saysAll("<p>"));
  EXPECT_THAT(refusalOf("m", dae(kTwoTriangles, R"(<node><instance_geometry url="other.dae#g"/></node>)")),
              saysAll("<geometry>", "other.dae#g"));
  EXPECT_THAT(refusalOf("m", dae(kTwoTriangles, "<node><matrix>1 2 3</matrix></node>")), saysAll("<matrix>"));
  EXPECT_THAT(refusalOf("m", dae(kTwoTriangles, "<node><skew>1 2 3 4 5 6 7</skew></node>")), saysAll("skew"));
}

TEST(Collada, RefusesXmlThatIsNoSceneOfCollada) {
  EXPECT_THAT(refusalOf("m.dae", "<robot name='r'/>"), saysAll("m.dae", "COLLADA", "robot"));
  EXPECT_THAT(refusalOf("m.dae", "<COLLADA/>"), saysAll("m.dae", "scene"));
  EXPECT_THAT(refusalOf("m.dae", "<COLLADA><asset>"), saysAll("m.dae", "well-formed"));
  EXPECT_THAT(refusalOf("m.dae", ""), saysAll("m.dae", "well-formed"));
  EXPECT_THAT(refusalOf("m.dae",
                        "<COLLADA><asset><unit meter='-1'/></asset><visual_scene id='a'/><scene><instance_visual_scene "
                        "url='#a'/></scene></COLLADA>"),
              saysAll("<unit>"));
}

TEST(Collada, ReadsElementsThatAreNestedDeeplyWithoutRecursion) {
  std::string nodes;
  constexpr int kDepth = 20'000;
  for (int k = 0; k < kDepth; ++k) nodes += "<node>";
  nodes += R"(<instance_geometry url="#g"/>)";
  for (int k = 0; k < kDepth; ++k) nodes += "</node>";
  EXPECT_EQ(readMesh(dae(kTwoTriangles, nodes), "m").triangles.size(), 2U);
}

}  // namespace
}  // namespace hexoderm
