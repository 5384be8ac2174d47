#include "hexoderm/io/export_formats.h"
#include "hexoderm/io/exporter.h"
#include "tests/support/hand_made_skins.h"
#include "tests/support/options.h"
#include "tests/support/testing.h"

#include <vtkCellData.h>
#include <vtkDataArray.h>
#include <vtkFieldData.h>
#include <vtkNew.h>
#include <vtkPolyData.h>
#include <vtkVariant.h>
#include <vtkXMLPolyDataReader.h>

namespace hexoderm {
namespace {

/// VTK has these arrays and no others, every number to the last bit.
void expectArrays(vtkFieldData& found, const std::vector<VtpArray>& meant) {
  EXPECT_EQ(found.GetNumberOfArrays(), static_cast<int>(meant.size()));
  for (const VtpArray& array : meant) {
    vtkAbstractArray* const of_vtk = found.GetAbstractArray(array.name.c_str());
    ASSERT_NE(of_vtk, nullptr) << array.name;
    EXPECT_EQ(of_vtk->GetNumberOfComponents(), static_cast<int>(array.components)) << array.name;
    if (const auto* texts = std::get_if<std::vector<std::string>>(&array.values)) {
      ASSERT_EQ(of_vtk->GetNumberOfValues(), static_cast<vtkIdType>(texts->size())) << array.name;
      for (std::size_t k = 0; k < texts->size(); ++k) {
        const std::string text = of_vtk->GetVariantValue(static_cast<vtkIdType>(k)).ToString();
        EXPECT_EQ(text, (*texts)[k]) << array.name;
      }
      continue;
    }
    std::vector<double> numbers;
    if (const auto* doubles = std::get_if<std::vector<double>>(&array.values)) numbers = *doubles;
    if (const auto* integers = std::get_if<std::vector<std::int64_t>>(&array.values)) {
      numbers.assign(integers->begin(), integers->end());
    }
    ASSERT_EQ(of_vtk->GetNumberOfValues(), static_cast<vtkIdType>(numbers.size())) << array.name;
    for (std::size_t k = 0; k < numbers.size(); ++k) {
      const double number = of_vtk->GetVariantValue(static_cast<vtkIdType>(k)).ToDouble();
      EXPECT_TRUE(number == numbers[k] || (std::isnan(number) && std::isnan(numbers[k]))) << array.name << " " << k;
    }
  }
}

TEST(VtpReader, VtkReadsWhatTheExporterMeant) {
  const Reconstruction reconstruction = makeTestReconstruction();
  const std::filesystem::path path = std::filesystem::path(::testing::TempDir()) / "vtp_reader_test.vtp";
  exportReconstruction(reconstruction, ExportFormat::Vtp, path, test::with(&ExportOptions::all_patches, true));
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

  const VtpData meant = vtpData(reconstruction);
  expectArrays(*mesh->GetFieldData(), meant.field_data);
  const auto cell_data = std::ranges::find(meant.sections, std::string("CellData"), &VtpSection::name);
  ASSERT_NE(cell_data, meant.sections.end());
  expectArrays(*mesh->GetCellData(), cell_data->arrays);
  const auto numbersOf = [&meant](const std::string& section, std::size_t array) {
    return std::ranges::find(meant.sections, section, &VtpSection::name)->arrays.at(array).values;
  };
  const auto points = std::get<std::vector<double>>(numbersOf("Points", 0));
  for (vtkIdType k = 0; k < mesh->GetNumberOfPoints(); ++k) {
    const Eigen::Map<const Eigen::Vector3d> meant_point(&points.at(3 * static_cast<std::size_t>(k)));
    EXPECT_EQ(Eigen::Map<const Eigen::Vector3d>(mesh->GetPoint(k)), meant_point) << k;
  }
}

}  // namespace
}  // namespace hexoderm
