#pragma once

#include "hexoderm/io/exporter.h"

#include <string>
#include <string_view>
#include <vector>

namespace hexoderm {

/// A cylinder drawn for a cell.
struct UrdfVisual {
  std::string name;
  SE3 T_link_center;
  std::string material;
};
/// A link and where it hangs. `T_root_link` says where it is meant to be in the parent link that the options name: it
/// is what chaining the joints of the file must give.
struct UrdfLink {
  std::string name;
  std::string parent;  ///< empty: the root
  SE3 T_parent_link;
  SE3 T_root_link;
  std::vector<UrdfVisual> visuals;
};
/// A sensor that has no link of its own.
struct UrdfSensor {
  std::string name;
  std::string link;
  SE3 T_link_sensor;
};
struct UrdfModel {
  std::string robot;
  double radius_m = 0;  ///< of every cell's cylinder
  double length_m = 0;
  std::vector<UrdfLink> links;  ///< the root first, parents before children
  std::vector<UrdfSensor> sensors;
};

/// parent link -> PREFIXpatchK -> PREFIXcellN -> PREFIXcellN_SENSOR, all joints fixed and named after their child. Of
/// several patches the frames would coincide: exportReconstruction() gives it one. With one link per patch the cells
/// are its visuals and the sensors are <sensor> elements. Throws InvalidArgument if the parent link's name is also that
/// of a link made here.
UrdfModel urdfModel(const Reconstruction& reconstruction, const ExportOptions& options);

std::string urdfBytes(const UrdfModel& model);

/// Chains the joints of the file and compares where every link, visual and sensor ends up, to 1e-9 (m and matrix
/// elements). Throws FormatError.
void verifyUrdf(std::string_view bytes, const UrdfModel& model, const std::string& file);

/// Not empty, and only letters, digits and _ - . / with no slash in front: what URDF and TF accept.
bool isUrdfName(std::string_view name);

}  // namespace hexoderm
