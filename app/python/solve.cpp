#include "app/python/bindings.h"

#include "hexoderm/solve/reconstructor.h"

namespace hexoderm::python {
namespace {

namespace py = pybind11;

Calibration solve(const Argument<Session>& session, const Argument<std::string>& solver,
                  const Argument<std::string>& centre, const Argument<std::string>& support_axes,
                  const Argument<std::string>& weights, const Argument<std::string>& gap_model,
                  const Argument<std::vector<std::uint32_t>>& without, const Argument<double>& class_threshold,
                  const Argument<std::pair<double, double>>& goal, const Argument<Reconstruction>& earlier) {
  const Session& measured = session.as("session", "a Session, as read_session() reads it from a file");
  SolverOptions options;
  options.solver = solverFromName(solver.as("solver"));
  options.centring = centringFromName(centre.as("centre", "auto, on or off"));
  options.support_axes = supportAxesFromName(support_axes.as("support_axes", "auto, on or off"));
  options.weights = linkWeightsFromName(weights.as("weights"));
  options.gap_model = gapModelFromName(gap_model.as("gap_model"));
  for (const std::uint32_t id : without.as("without", "a list of cells' IDs")) options.left_out.emplace_back(id);
  options.class_threshold = class_threshold.as("class_threshold");
  const auto [goal_m, goal_rad] = goal.as("goal", "two numbers, m and rad");
  options.goal = {goal_m, goal_rad};
  options.validate();
  const std::shared_ptr<const SessionSnapshot> snapshot = measured.snapshot();
  const Reconstruction* start = earlier.object().is_none() ? nullptr : &earlier.as("earlier", "a Calibration");
  return calibrationOf(
      interruptible([&](const std::stop_token& stop) { return reconstruct(*snapshot, options, start, stop); }));
}

}  // namespace

void bindSolve(py::module_& module) {
  const SolverOptions usual;
  module.def(
      "solve", &solve, py::arg("session"), py::kw_only(), py::arg("solver") = std::string(solverName(usual.solver)),
      py::arg("centre") = std::string(centringName(usual.centring)),
      py::arg("support_axes") = std::string(supportAxesName(usual.support_axes)),
      py::arg("weights") = std::string(linkWeightsName(usual.weights)),
      py::arg("gap_model") = std::string(gapModelName(usual.gap_model)),
      py::arg("without") = std::vector<std::uint32_t>(), py::arg("class_threshold") = usual.class_threshold,
      py::arg("goal") = std::pair(usual.goal.position_m, usual.goal.orientation_rad), py::arg("earlier") = py::none(),
      "Finds the placement of every cell; the options are those of `hexoderm-cli solve`.\n\n"
      "solver: global, all cells, poses and links together; tree, the paper's way, along shortest paths.\n"
      "centre: subtract each cell's mean reading: auto, on or off.\n"
      "support_axes: support weakly defined edges by the gap's axes: auto, on or off.\n"
      "weights: what makes a path short: paper or residual.\n"
      "gap_model: what the mould does when it is bent: arc (the pitch stays), pivot (nothing stretches, and two port\n"
      "vectors end in one point), or fit, which finds what lies between. The tree places as pivot does, and counts\n"
      "what this leaves open in its uncertainty. A ring or tube that bends alike everywhere does not tell it: there\n"
      "fit states a large uncertainty, and who knows the mould says so.\n"
      "without: cells whose readings are left out.\n"
      "class_threshold: singular value from which a direction counts as defined; 1 is the paper's.\n"
      "goal: how well every cell is to be known (95 %), m and rad: the verdict is good within it, usable within three\n"
      "times as much, and coarse beyond.\n"
      "earlier: a result of the same skin from which the global solver starts, which may be quicker.\n\n"
      "Other threads go on meanwhile, and Ctrl+C ends it. Whatever is wrong with the skin or its poses is a\n"
      "finding of the result and no exception.");
  explainMisfits(module, "solve");
}

}  // namespace hexoderm::python
