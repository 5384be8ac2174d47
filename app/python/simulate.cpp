#include "app/python/bindings.h"

#include "hexoderm/device/simulation/fault_names.h"
#include "hexoderm/device/simulation/robot_in_words.h"
#include "hexoderm/device/simulation/simulated_skin.h"
#include "hexoderm/session/simulated_session.h"
#include "hexoderm/util/error.h"

#include <pybind11/stl.h>

namespace hexoderm::python {
namespace {

namespace py = pybind11;

LinkLaw linkLawFromName(const std::string& name) {
  if (name == "bend") return LinkLaw::Bend;
  if (name == "surface") return LinkLaw::Surface;
  throw InvalidArgument("link_law: expected bend or surface, found \"" + name + "\"");
}

SimulatedSkinOptions optionsFor(const std::string& motion, bool ideal) {
  if (motion != "hand" && motion != "robot") {
    throw InvalidArgument("motion: expected hand or robot, found \"" + motion + "\"");
  }
  if (ideal) return SimulatedSkinOptions::ideal();
  return motion == "robot" ? SimulatedSkinOptions::robot() : SimulatedSkinOptions();
}

void requireSamples(std::size_t samples) {
  if (samples == 0) throw InvalidArgument("samples: expected at least 1, found 0");
}

Session simulate(const std::string& patch, const std::string& surface, std::size_t poses, std::size_t samples,
                 std::uint64_t seed, const std::string& link_law, const ModelOrName& cell_model,
                 std::optional<double> offset_sigma_g, const std::string& motion, bool ideal,
                 const std::vector<std::string>& faults) {
  requireSamples(samples);
  CellModel model = modelFrom(cell_model);
  if (offset_sigma_g) model.accelerometer.offset_sigma_g = *offset_sigma_g;
  model.validate();
  SimulatedSkinOptions options = optionsFor(motion, ideal);
  options.patch = patch;
  options.surface = surface;
  options.seed = seed;
  options.link_law = linkLawFromName(link_law);
  for (const std::string& fault : faults) addFault(fault, "faults", options);
  // Between the last pose and the one before it.
  options.reglued_before = poses == 0 ? 0 : poses - 1;
  SimulatedSkin skin(std::move(model), options);
  return simulateSession(skin, poses, samples);
}

Session simulateRobot(const std::string& robot, std::size_t poses, std::size_t samples,
                      const std::vector<std::string>& mounts, const std::vector<std::string>& packages,
                      const std::string& base, const std::string& patch, const std::string& surface, std::uint64_t seed,
                      const std::string& link_law, const ModelOrName& cell_model, bool ideal) {
  requireSamples(samples);
  RobotInWords words;
  words.robot = robot;
  words.packages = packages;
  words.mounts = mounts;
  words.base = base;
  words.patch = patch;
  words.surface = surface;
  words.seed = seed;
  words.link_law = linkLawFromName(link_law);
  words.ideal = ideal;
  SimulatedRobot simulated = makeRobot(modelFrom(cell_model), words);
  return simulateRobotSession(simulated, poses, samples).session;
}

}  // namespace

void bindSimulate(py::module_& module) {
  module.def("simulate", &simulate, py::kw_only(), py::arg("patch") = "x17", py::arg("surface") = "",
             py::arg("poses") = 2, py::arg("samples") = 100, py::arg("seed") = 1, py::arg("link_law") = "bend",
             py::arg("cell_model") = "hex-bma150", py::arg("offset_sigma_g") = py::none(), py::arg("motion") = "hand",
             py::arg("ideal") = false, py::arg("faults") = std::vector<std::string>(),
             py::call_guard<py::gil_scoped_release>(),
             "A session of a simulated skin, with its truth; as `hexoderm-cli simulate` makes it.\n\n"
             "patch: x17, ringN, ringN:closed or sheet:ROWSxCOLS.\n"
             "surface: plane, cylinder:r=M, sphere:r=M, cone:r=M,angle=RAD or torus:R=M,r=M; what suits the patch\n"
             "without it.\n"
             "samples: averaged in a pose. link_law: how the mould lets neighbours lie, bend or surface.\n"
             "offset_sigma_g: of the accelerometers; the cell model's without it.\n"
             "motion: what turns the part, hand or robot. ideal: no errors, no noise, no hand.\n"
             "faults: KIND:CELL, KIND:CELL:PORT or KIND, as hexoderm-cli simulate --help lists them.");
  module.def(
      "simulate_robot", &simulateRobot, py::kw_only(), py::arg("robot") = "demo", py::arg("poses") = 8,
      py::arg("samples") = 100, py::arg("mounts") = std::vector<std::string>(),
      py::arg("packages") = std::vector<std::string>(), py::arg("base") = "fixed", py::arg("patch") = "x17",
      py::arg("surface") = "", py::arg("seed") = 1, py::arg("link_law") = "bend", py::arg("cell_model") = "hex-bma150",
      py::arg("ideal") = false, py::call_guard<py::gil_scoped_release>(),
      "A session of a simulated robot that wears patches on its links; every pose has the joint angles that the\n"
      "robot reports.\n\n"
      "robot: demo, or a URDF. mounts: LINK:X,Y,Z or LINK:X,Y,Z,ROLL,PITCH,YAW, m and rad. packages:\n"
      "NAME=FOLDER of meshes. base: fixed, motors or hand.");
}

}  // namespace hexoderm::python
