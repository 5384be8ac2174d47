#include "app/python/bindings.h"

#include "hexoderm/base/error.h"
#include "hexoderm/sim/fault_names.h"
#include "hexoderm/sim/robot_text.h"
#include "hexoderm/sim/simulated_session.h"
#include "hexoderm/sim/simulated_skin.h"

#include <pybind11/stl/filesystem.h>

namespace hexoderm::python {
namespace {

namespace py = pybind11;

void requireSamples(std::size_t samples) {
  if (samples == 0) throw InvalidArgument("samples: expected at least 1, found 0");
}

using Text = Argument<std::string>;
using Texts = Argument<std::vector<std::string>>;
using Count = Argument<std::size_t>;
constexpr const char* kTexts = "a list of strings";

/// What simulations of a skin and of a robot have in common.
RobotText wordsFrom(const Text& patch, const Text& surface, const Argument<std::uint64_t>& seed, const Text& link_law,
                    const Argument<bool>& ideal) {
  RobotText words;
  words.patch = patch.as("patch");
  words.surface = surface.as("surface");
  words.seed = seed.as("seed");
  words.link_law = linkLawFromName(link_law.as("link_law"));
  words.ideal = ideal.as("ideal");
  return words;
}

Session simulate(const Text& patch, const Text& surface, const Count& poses, const Count& samples,
                 const Argument<std::uint64_t>& seed, const Text& link_law, const Argument<ModelOrName>& cell_model,
                 const Argument<std::optional<double>>& offset_sigma_g, const Text& motion, const Argument<bool>& ideal,
                 const Texts& faults) {
  const std::size_t pose_count = poses.as("poses");
  const std::size_t sample_count = samples.as("samples");
  requireSamples(sample_count);
  CellModel model = modelFrom(cell_model);
  if (const auto sigma = offset_sigma_g.as("offset_sigma_g", "a number"))
    model.accelerometer.offset_sigma_g.setConstant(*sigma);
  model.validate();
  SimulatedSkinOptions options = skinOptions(wordsFrom(patch, surface, seed, link_law, ideal), motion.as("motion"));
  for (const std::string& fault : faults.as("faults", kTexts)) addFault(fault, "faults", options);
  // Between the last pose and the one before it.
  options.reglued_before = pose_count == 0 ? 0 : pose_count - 1;
  const GilRelease unlocked;
  SimulatedSkin skin(std::move(model), options);
  return simulateSession(skin, pose_count, sample_count);
}

Session simulateRobot(const Text& robot, const Count& poses, const Count& samples, const Texts& mounts,
                      const Texts& packages, const Text& base, const Text& patch, const Text& surface,
                      const Argument<std::uint64_t>& seed, const Text& link_law,
                      const Argument<ModelOrName>& cell_model, const Argument<bool>& ideal) {
  const std::size_t pose_count = poses.as("poses");
  const std::size_t sample_count = samples.as("samples");
  requireSamples(sample_count);
  RobotText words = wordsFrom(patch, surface, seed, link_law, ideal);
  words.robot = robot.as("robot");
  words.packages = packages.as("packages", kTexts);
  words.mounts = mounts.as("mounts", kTexts);
  words.base = base.as("base");
  CellModel model = modelFrom(cell_model);
  const GilRelease unlocked;
  SimulatedRobot simulated = makeRobot(std::move(model), words);
  return simulateRobotSession(simulated, pose_count, sample_count).session;
}

}  // namespace

void bindSimulate(py::module_& module) {
  module.def(
      "simulate", &simulate, py::kw_only(), py::arg("patch") = "x17", py::arg("surface") = "", py::arg("poses") = 2,
      py::arg("samples") = 100, py::arg("seed") = 1, py::arg("link_law") = "bend", py::arg("cell_model") = "hex-bma150",
      py::arg("offset_sigma_g") = py::none(), py::arg("motion") = "hand", py::arg("ideal") = false,
      py::arg("faults") = std::vector<std::string>(),
      "A session of a simulated skin, with its truth; as `hexoderm-cli simulate` makes it.\n\n"
      "patch: x17, ringN, ringN:closed or sheet:ROWSxCOLS.\n"
      "surface: plane, cylinder:r=M, sphere:r=M, cone:r=M,angle=RAD or torus:R=M,r=M; what suits the patch\n"
      "without it.\n"
      "samples: averaged in a pose.\n"
      "link_law: how the mould lets neighbours lie: bend, only the gap between two rigid cells bends, as an arc\n"
      "that keeps its length; surface, neighbouring centres keep their distance along the surface.\n"
      "offset_sigma_g: of each accelerometer, beside its lot's; the cell model's without it.\n"
      "motion: what turns the part, hand or robot. ideal: no errors, no noise, no hand.\n"
      "faults: KIND:CELL, KIND:CELL:PORT or KIND, as hexoderm-cli simulate --help lists them.");
  explainMisfits(module, "simulate");
  module.def(
      "simulate_robot", &simulateRobot, py::kw_only(), py::arg("robot") = "demo", py::arg("poses") = 8,
      py::arg("samples") = 100, py::arg("mounts") = std::vector<std::string>(),
      py::arg("packages") = std::vector<std::string>(), py::arg("base") = "fixed", py::arg("patch") = "x17",
      py::arg("surface") = "", py::arg("seed") = 1, py::arg("link_law") = "bend", py::arg("cell_model") = "hex-bma150",
      py::arg("ideal") = false,
      "A session of a simulated robot that wears patches on its links; every pose has the joint angles that the\n"
      "robot reports.\n\n"
      "robot: demo, or a URDF. mounts: LINK:X,Y,Z or LINK:X,Y,Z,ROLL,PITCH,YAW, m and rad. packages:\n"
      "NAME=FOLDER of meshes. base: fixed, motors or hand. The others as of\n"
      "simulate().");
  explainMisfits(module, "simulate_robot");
}

}  // namespace hexoderm::python
