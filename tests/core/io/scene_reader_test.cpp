// OBJ and glTF, as VTK's readers see them.

#include "hexoderm/io/exporter.h"
#include "hexoderm/reconstruction/figures/patch_mesh.h"
#include "tests/core/io/export_test_folder.h"
#include "tests/support/hand_made_skins.h"

#include <gmock/gmock.h>
#include <vtkCompositeDataIterator.h>
#include <vtkGLTFReader.h>
#include <vtkMultiBlockDataSet.h>
#include <vtkNew.h>
#include <vtkOBJReader.h>
#include <vtkPolyData.h>
#include <vtkSmartPointer.h>

#include <algorithm>
#include <vector>

namespace hexoderm {
namespace {

class SceneReader : public ExportTest {
 protected:
  static void addPoints(vtkPolyData& data, std::vector<Eigen::Vector3d>& points) {
    for (vtkIdType k = 0; k < data.GetNumberOfPoints(); ++k) points.emplace_back(data.GetPoint(k));
  }
  static std::vector<Eigen::Vector3d> prisms() {
    Reconstruction one = makeTestReconstruction();
    one.patches.resize(1);
    return makePatchMesh(one).points;
  }
  static void expectSamePoints(const std::vector<Eigen::Vector3d>& found, const std::vector<Eigen::Vector3d>& meant) {
    const auto nearIn = [](const std::vector<Eigen::Vector3d>& points, const Eigen::Vector3d& point) {
      return std::ranges::any_of(points, [&](const Eigen::Vector3d& other) { return (other - point).norm() < 1e-6; });
    };
    EXPECT_FALSE(found.empty());
    for (const Eigen::Vector3d& point : found) EXPECT_TRUE(nearIn(meant, point)) << point.transpose();
    for (const Eigen::Vector3d& point : meant) EXPECT_TRUE(nearIn(found, point)) << point.transpose();
  }
};

TEST_F(SceneReader, FindsThePrismsOfAnObj) {
  exportReconstruction(makeTestReconstruction(), ExportFormat::Obj, in("skin.obj"));
  const vtkNew<vtkOBJReader> reader;
  reader->SetFileName(in("skin.obj").c_str());
  reader->Update();
  std::vector<Eigen::Vector3d> points;
  addPoints(*reader->GetOutput(), points);
  EXPECT_EQ(reader->GetOutput()->GetNumberOfPolys(), 3 * 8);
  expectSamePoints(points, prisms());
}

TEST_F(SceneReader, FindsThePrismsOfAGltfUpright) {
  exportReconstruction(makeTestReconstruction(), ExportFormat::Gltf, in("skin.glb"));
  const vtkNew<vtkGLTFReader> reader;
  reader->SetFileName(in("skin.glb").c_str());
  reader->Update();
  std::vector<Eigen::Vector3d> points;
  const auto blocks = vtkSmartPointer<vtkCompositeDataIterator>::Take(reader->GetOutput()->NewIterator());
  for (blocks->InitTraversal(); !blocks->IsDoneWithTraversal(); blocks->GoToNextItem()) {
    if (auto* data = vtkPolyData::SafeDownCast(blocks->GetCurrentDataObject())) addPoints(*data, points);
  }
  std::vector<Eigen::Vector3d> meant;
  for (const Eigen::Vector3d& p : prisms()) meant.emplace_back(p.x(), p.z(), -p.y());
  expectSamePoints(points, meant);
}

}  // namespace
}  // namespace hexoderm
