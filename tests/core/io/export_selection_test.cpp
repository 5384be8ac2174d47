// Which patches a file holds, in which frame, and what its manifest says of them.

#include "hexoderm/io/export_selection.h"

#include "hexoderm/base/sha256.h"
#include "tests/core/io/export_test_folder.h"
#include "tests/support/hand_made_skins.h"

#include <nlohmann/json.hpp>

namespace hexoderm {
namespace {

class ExportSelections : public ExportTest {
 protected:
  const SE3 T_l_o_{rotationFromRpy({0.4, -0.9, 2.5}), {0.03, -0.01, 0.12}};
  Reconstruction reconstruction_ = makeTestReconstruction();
  ExportOptions options_;
};

TEST_F(ExportSelections, PatchesOnOneLinkShareItsFrame) {
  options_.placements = {{CellId(7), "forearm", T_l_o_, {}},
                         {CellId(20), "forearm", {Eigen::Matrix3d::Identity(), {0.5, 0, 0}}, {}}};
  options_.in_link = "forearm";
  for (const ExportFormat format : {ExportFormat::Ply, ExportFormat::Obj, ExportFormat::Vtp, ExportFormat::Urdf}) {
    EXPECT_THAT(patchesLeftOut(reconstruction_, format, options_), IsEmpty());
  }
  const ExportSelection selection =
      selectForExport(reconstruction_, exportFormatDescription(ExportFormat::Ply), options_);
  const Reconstruction part = exportedPart(reconstruction_, selection, options_);
  ASSERT_EQ(part.patches.size(), 2U);
  EXPECT_LT((part.patches[0].cells[0].T_o_u.t - T_l_o_ * reconstruction_.patches[0].cells[0].T_o_u.t).norm(), 1e-15);
  EXPECT_EQ(part.patches[1].cells[0].T_o_u.t.x(), 0.5);
  EXPECT_THAT(exportBytes(reconstruction_, ExportFormat::Ply, options_),
              HasSubstr("comment metres, in the frame of link forearm"));
}

TEST_F(ExportSelections, WhatIsNotOnTheLinkIsLeftOutAndSaid) {
  options_.placements = {{CellId(7), "forearm", T_l_o_, {}}, {CellId(20), "hand", {}, {}}};
  EXPECT_THAT(patchesLeftOut(reconstruction_, ExportFormat::TfYaml, options_), IsEmpty());
  options_.in_link = "hand";
  for (const ExportFormat format : {ExportFormat::Stl, ExportFormat::TfYaml}) {
    const auto left_out = patchesLeftOut(reconstruction_, format, options_);
    ASSERT_EQ(left_out.size(), 1U);
    EXPECT_EQ(
        leftOutText(left_out).english(),
        "Not in the file: the patch of cell 7 (3 cells), because it is not placed on a link that the file holds.");
  }
}

TEST_F(ExportSelections, OptionsThatDoNotGoTogetherAreRefused) {
  const auto refused = [&](ExportFormat format) {
    return messageOf<InvalidArgument>([&] { exportBytes(reconstruction_, format, options_); });
  };
  options_.placements = {{CellId(7), "forearm", {}, {}}, {CellId(20), "hand", {}, {}}};
  for (const ExportFormat format : {ExportFormat::Urdf, ExportFormat::Sdf, ExportFormat::Mjcf}) {
    EXPECT_THAT(refused(format), HasSubstr("placed on 2 links"));
  }
  options_.placements.clear();
  options_.in_link = "hand";
  EXPECT_THAT(refused(ExportFormat::Ply), HasSubstr("in_link: no exported patch is placed on link hand"));
  options_.placements = {{CellId(20), "hand", {}, {}}};
  EXPECT_THAT(refused(ExportFormat::Dot), HasSubstr("in_link: dot holds each patch in a frame of its own"));
  options_.placements.push_back(options_.placements.front());
  EXPECT_THAT(refused(ExportFormat::Ply), HasSubstr("placements: the patch of cell 20 is placed twice"));
  options_.placements = {{CellId(3), "hand", {}, {}}};
  EXPECT_THAT(refused(ExportFormat::Ply), HasSubstr("placements: no patch has cell 3 as its origin"));
  options_.placements = {{CellId(20), "the hand", {}, {}}};
  EXPECT_THAT(refused(ExportFormat::Ply), HasSubstr("\"the hand\""));
  options_.placements = {{CellId(20), "hand", {}, {}}};
  options_.placements[0].T_l_o.t.x() = std::numeric_limits<double>::infinity();
  EXPECT_THAT(refused(ExportFormat::Ply), HasSubstr("finite numbers"));
}

/// A covariance of six numbers with all correlations.
Matrix6d someCovariance(double scale, std::mt19937& random) {
  std::normal_distribution<double> normal;
  Eigen::Matrix<double, 6, 6> root;
  for (double& value : root.reshaped()) value = scale * normal(random);
  return root * root.transpose();
}
SE3 disturbed(const SE3& T, const auto& error) {
  return {T.R * expSO3(error.template tail<3>()), T.t + error.template head<3>()};
}

TEST_F(ExportSelections, CovariancesOfCellAndPatchAddUpInTheLinksFrame) {
  std::mt19937 random(5);
  PatchOnLink place{CellId(7), "forearm", T_l_o_, someCovariance(2e-3, random)};
  CellPlacement cell = reconstruction_.patches[0].cells[0];
  cell.T_o_u.t = {0.3, -0.2, 0.1};
  cell.cov_t_r = someCovariance(1e-3, random);
  const CellPlacement on_link = onLink(cell, place);
  ASSERT_TRUE(on_link.cov_t_r);
  // The errors of both, carried through the product of transforms by differences.
  Eigen::Matrix<double, 12, 12> of_both = Eigen::Matrix<double, 12, 12>::Zero();
  of_both.topLeftCorner<6, 6>() = *place.cov_t_r;
  of_both.bottomRightCorner<6, 6>() = *cell.cov_t_r;
  Eigen::Matrix<double, 6, 12> jacobian;
  for (Eigen::Index k = 0; k < 12; ++k) {
    constexpr double kStep = 1e-6;
    const Eigen::Matrix<double, 12, 1> step = kStep * Eigen::Matrix<double, 12, 1>::Unit(k);
    const SE3 T = disturbed(place.T_l_o, step.head<6>()) * disturbed(cell.T_o_u, step.tail<6>());
    jacobian.col(k) << T.t - on_link.T_o_u.t, logSO3(on_link.T_o_u.R.transpose() * T.R);
    jacobian.col(k) /= kStep;
  }
  const Eigen::Matrix<double, 6, 6> expected = jacobian * of_both * jacobian.transpose();
  EXPECT_LT((*on_link.cov_t_r - expected).norm(), 1e-5 * expected.norm());

  place.cov_t_r.reset();
  EXPECT_FALSE(onLink(cell, place).cov_t_r) << "what is not known does not become certain";
}

TEST_F(ExportSelections, ABundleSaysWhatItsFilesAre) {
  options_.placements = {{CellId(7), "r_forearm", T_l_o_, {}}, {CellId(20), "r_hand", {}, {}}};
  options_.inputs = {{"calibration", "arm.calibration.json", std::string(64, 'a')}};
  const std::vector formats = {ExportFormat::TfYaml, ExportFormat::Skinware, ExportFormat::Stl, ExportFormat::Csv};
  const auto paths = exportBundle(reconstruction_, formats, in("out"), options_);
  EXPECT_EQ(paths.back(), in("out") / "manifest.json");
  const auto manifest = nlohmann::json::parse(readFile(in("out") / "manifest.json"));
  EXPECT_EQ(manifest.at("format"), "hexoderm-manifest");
  EXPECT_THAT(manifest.at("program").get<std::string>(), ::testing::StartsWith("Hexoderm "));
  EXPECT_EQ(manifest.at("inputs").at(0).at("sha256"), std::string(64, 'a'));
  EXPECT_EQ(manifest.at("files").size(), paths.size() - 1);
  std::map<std::string, nlohmann::json> files;
  for (const auto& file : manifest.at("files")) {
    const auto name = file.at("file").get<std::string>();
    files[name] = file;
    EXPECT_EQ(file.at("sha256"), sha256Hex(readFile(in("out") / name))) << name;
  }
  EXPECT_EQ(files.at("skin.stl").at("length_unit"), "mm");
  EXPECT_EQ(files.at("skin.stl").at("coordinates"), "in the frame of cell 7, the origin of the patch");
  EXPECT_THAT(files.at("skin.stl").at("patches_left_out").get<std::vector<int>>(), ElementsAre(20));
  EXPECT_EQ(files.at("skin.skinware.txt").at("length_unit"), "nm");
  EXPECT_THAT(files.at("skin.skinware.txt").at("links").get<std::vector<std::string>>(),
              ElementsAre("r_forearm", "r_hand"));
  EXPECT_THAT(files.at("skin.tf.yaml").at("coordinates").get<std::string>(),
              HasSubstr("the patch of cell 20 placed on link r_hand"));
  EXPECT_EQ(files.at("cells.csv").at("length_unit"), "m");
  EXPECT_TRUE(files.at("cells.csv").contains("coordinates"));
  for (const char* angles : {"links.csv", "residuals.csv"}) {
    EXPECT_TRUE(files.at(angles).at("length_unit").is_null()) << angles;
    EXPECT_FALSE(files.at(angles).contains("coordinates")) << angles;
  }
  const auto wordsOf = [](const nlohmann::json& frame) { return frame.at("words").get<std::string>(); };
  EXPECT_THAT(collect(manifest.at("frames"), wordsOf), Contains("maps points of cell 7 into link r_forearm"));
  const auto& first = manifest.at("frames").at(0);
  EXPECT_EQ(first.at("cell"), 3);
  const Eigen::Vector3d t_l_u = T_l_o_ * reconstruction_.patches[0].cells[0].T_o_u.t;
  for (int axis = 0; axis < 3; ++axis) EXPECT_NEAR(first.at("t_m").at(axis).get<double>(), t_l_u[axis], 1e-12);
}

TEST_F(ExportSelections, ABundleIsWholeOrNotThere) {
  const std::vector formats = {ExportFormat::Ply, ExportFormat::Icub, ExportFormat::RobotUrdf};
  EXPECT_THROW(exportBundle(reconstruction_, formats, in("out"), options_), InvalidArgument);
  options_.robot_urdf = in("missing.urdf");
  EXPECT_THROW(exportBundle(reconstruction_, formats, in("out"), options_), StorageError);
  EXPECT_THAT(names(), IsEmpty());
}

TEST(ExportOptionDescriptions, ReadAndWriteTheirOptions) {
  for (const ExportOptionDescription& option : exportOptions()) {
    ExportOptions options;
    const std::string value = option.get(options);
    EXPECT_FALSE(option.label.empty() || option.help.empty() || option.formats.empty()) << option.name;
    if (option.kind != ExportOptionDescription::Kind::Choice) {
      option.set(options, "other");
      EXPECT_EQ(option.get(options), "other") << option.name;
      continue;
    }
    for (const auto& choice : option.choices) {
      option.set(options, std::string(choice.value));
      EXPECT_EQ(option.get(options), choice.value) << option.name;
    }
    EXPECT_THROW(option.set(options, "none of them"), InvalidArgument) << option.name;
  }
}

}  // namespace
}  // namespace hexoderm
