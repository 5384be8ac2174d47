// Signs on cells and links that findings are about.
#include "widgets/scene/cell_meshes.h"

#include "tests/widgets/scene/patch_scene_test.h"

namespace hexoderm {
namespace {

Finding about(FindingCode code, std::vector<CellId> cells, std::vector<PortNumber> ports = {}) {
  return makeFinding(code, Message::verbatim("made for a test"), std::move(cells), std::move(ports));
}

vtkIdType polygonsOf(const Reconstruction& skin) {
  const auto content = makeSceneContent(shared(skin));
  const std::vector<Rgb> faces(content->layout.cells.size(), Rgb{0.3, 0.3, 0.6});
  const auto signs = makeSigns(*content, faces, testColors(true));
  return signs == nullptr ? 0 : signs->GetNumberOfPolys();
}

Reconstruction withFinding(const Finding& finding) {
  Reconstruction demo = demoReconstruction();
  demo.findings.push_back(finding);
  return demo;
}

TEST(SceneSigns, ASkinWithoutFindingsHasNone) { EXPECT_EQ(polygonsOf(demoReconstruction()), 0); }

TEST(SceneSigns, EachKindOfFindingHasASignOfItsOwn) {
  Reconstruction by_links = demoReconstruction();
  by_links.patches[0].cells[4].placed_by = PlacedBy::Links;
  const LinkEstimate& link = by_links.patches[0].links[3];
  const vtkIdType hatched = polygonsOf(by_links);
  const vtkIdType crossed = polygonsOf(withFinding(about(FindingCode::TurnedSensor, {CellId(5)})));
  const vtkIdType triangle = polygonsOf(withFinding(about(FindingCode::NoisySensor, {CellId(5)})));
  const vtkIdType ports = polygonsOf(withFinding(
      about(FindingCode::ImplausibleBend, {link.source.cell, link.target.cell}, {link.source.port, link.target.port})));
  EXPECT_EQ(crossed, 2 * 4) << "four bars on each of both faces";
  EXPECT_EQ(triangle, 2 * 3);
  EXPECT_EQ(ports, 2 * 2 * 3) << "a disc and two bars, at both ports";
  EXPECT_GT(hatched, 2 * 8);
  by_links.findings.push_back(about(FindingCode::TurnedSensor, {CellId(5)}));
  EXPECT_EQ(polygonsOf(by_links), hatched + crossed);
}

TEST(SceneSigns, LieOnTheirCellsFacesAndLeaveTheirMiddleFree) {
  Reconstruction demo = demoReconstruction();
  demo.patches[0].cells[4].placed_by = PlacedBy::Links;
  demo.findings.push_back(about(FindingCode::TurnedSensor, {CellId(5)}));
  const auto content = makeSceneContent(shared(demo));
  const std::vector<Rgb> faces(17, Rgb{0.3, 0.3, 0.6});
  const auto signs = makeSigns(*content, faces, testColors(true));
  ASSERT_NE(signs, nullptr);
  const double side_m = demo.model->side_m;
  const SE3 T_u_s = content->layout.find(CellId(5))->T_s_u.inverse();
  for (vtkIdType k = 0; k < signs->GetNumberOfPoints(); ++k) {
    const Eigen::Vector3d p = T_u_s * Eigen::Vector3d(signs->GetPoint(k));
    const double from_middle = std::hypot(p.x(), p.y());
    EXPECT_LT(from_middle, 1.01 * side_m);
    EXPECT_GT(from_middle, 0.4 * side_m) << "where the ID stands";
    EXPECT_TRUE(std::abs(p.z() - 0.02 * side_m) < 0.02 * side_m ||
                std::abs(p.z() + demo.model->thickness_m + 0.02 * side_m) < 0.02 * side_m)
        << p.z();
  }
}

TEST(SceneSigns, LargeSkinsHaveThemOnTheirFrontFacesAlone) {
  Reconstruction sheet = cylinderSheet(60, 40);
  sheet.findings.push_back(about(FindingCode::TurnedSensor, {CellId(700)}));
  EXPECT_EQ(polygonsOf(sheet), 4);
}

TEST_F(PatchSceneTest, ASignIsSeenInThePicture) {
  const Reconstruction demo = demoReconstruction();
  scene.setReconstruction(shared(demo));
  scene.showStandardView(PatchScene::View::Front);
  const auto before = picture();
  scene.setReconstruction(shared(withFinding(about(FindingCode::TurnedSensor, {CellId(1)}))));
  EXPECT_GT(differingShare(before, picture()), 0.001);
  scene.setReconstruction(shared(withFinding(about(FindingCode::LeftOut, {CellId(1)}))));
  EXPECT_LE(differingShare(before, picture()), 0) << "what the operator wanted is no fault";
}

}  // namespace
}  // namespace hexoderm
