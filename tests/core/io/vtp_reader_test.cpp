#include "hexoderm/io/exporter.h"
#include "tests/support/hand_made_skins.h"

#include <gtest/gtest.h>
#include <vtkCellData.h>
#include <vtkDataArray.h>
#include <vtkFieldData.h>
#include <vtkNew.h>
#include <vtkPolyData.h>
#include <vtkStringArray.h>
#include <vtkXMLPolyDataReader.h>

#include <cmath>
#include <filesystem>

namespace hexoderm {
namespace {

TEST(VtpReader, VtkReadsWhatTheExporterMeant) {
  const Reconstruction reconstruction = makeTestReconstruction();
  const std::filesystem::path path = std::filesystem::path(::testing::TempDir()) / "vtp_reader_test.vtp";
  ExportOptions options;
  options.all_patches = true;
  exportReconstruction(reconstruction, ExportFormat::Vtp, path, options);
  const vtkNew<vtkXMLPolyDataReader> reader;
  reader->SetFileName(path.c_str());
  reader->Update();
  std::filesystem::remove(path);

  vtkPolyData* mesh = reader->GetOutput();
  ASSERT_EQ(mesh->GetNumberOfVerts(), 4);
  ASSERT_EQ(mesh->GetNumberOfPolys(), 32);
  ASSERT_EQ(mesh->GetNumberOfPoints(), 52);
  const Eigen::Vector3d corner = reconstruction.patches[0].cells[0].T_o_u * Eigen::Vector3d(0.01502, 0, 0);
  EXPECT_EQ(Eigen::Map<const Eigen::Vector3d>(mesh->GetPoint(0)), corner);

  vtkCellData* cells = mesh->GetCellData();
  EXPECT_EQ(cells->GetNumberOfArrays(), 12);
  ASSERT_NE(cells->GetArray("cell_id"), nullptr);
  EXPECT_EQ(cells->GetArray("cell_id")->GetTuple1(20), 12);
  EXPECT_EQ(cells->GetArray("quality")->GetTuple1(20), 3);
  EXPECT_EQ(cells->GetArray("position_m")->GetComponent(20, 0), 0.0123456789012345);
  EXPECT_TRUE(std::isnan(cells->GetArray("sigma_position_m")->GetComponent(20, 0)));
  auto* body_part = vtkStringArray::SafeDownCast(cells->GetAbstractArray("body_part"));
  ASSERT_NE(body_part, nullptr);
  EXPECT_EQ(body_part->GetValue(20), kAwkwardText);
  EXPECT_EQ(body_part->GetValue(35), "");

  auto* units = vtkStringArray::SafeDownCast(mesh->GetFieldData()->GetAbstractArray("units"));
  ASSERT_NE(units, nullptr);
  EXPECT_EQ(units->GetValue(0), "positions in metres, rotations in radians");
  ASSERT_NE(mesh->GetFieldData()->GetArray("cov_t_r"), nullptr);
  EXPECT_EQ(mesh->GetFieldData()->GetArray("cov_t_r")->GetNumberOfTuples(), 4);
}

}  // namespace
}  // namespace hexoderm
