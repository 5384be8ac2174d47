#include "app/cli/command.h"

#include "hexoderm/solve/metrics/review_summary.h"
#include "hexoderm/solve/reconstructor.h"

#include <iostream>

namespace hexoderm::cli {
namespace {

struct InspectOptions {
  std::string input;
  std::string cell_model = "hex-bma150";
  std::string solver = "global";
};

std::size_t freePorts(const Reconstruction& r) {
  std::size_t joined = 0;
  for (const PatchReconstruction& patch : r.patches) {
    for (const LinkEstimate& link : patch.links) joined += link.used ? 2 : 0;
  }
  return r.cellCount() * r.model->ports.size() - joined;
}

Json describe(const Reconstruction& r, const std::string& kind) {
  const auto patch_json = [](const PatchReconstruction& patch) -> Json {
    return {{"id", patch.id.value()},
            {"cells", patch.cells.size()},
            {"origin", patch.origin.value()},
            {"lot", patch.lot ? cli::toJson(*patch.lot) : Json()}};
  };
  const auto pose_json = [](const PoseSummary& pose) {
    Json json = {{"id", pose.pose.value()},
                 {"label", pose.label.english()},
                 {"enabled", pose.enabled},
                 {"cells_measured", pose.cells_measured},
                 {"noise_mg", pose.noise_g * 1000}};
    if (pose.new_by_rad) json["new_by_deg"] = toDegrees(*pose.new_by_rad);
    if (pose.residual_rad) json["residual_deg"] = toDegrees(*pose.residual_rad);
    return json;
  };
  return {{"kind", kind},
          {"cell_model", r.model->name},
          {"cells", r.cellCount()},
          {"links", r.linkCount()},
          {"free_ports", freePorts(r)},
          {"patches", arrayOf(r.patches, patch_json)},
          {"poses", arrayOf(r.poses, pose_json)},
          {"solver", r.solver},
          {"findings", cli::toJson(r.findings)},
          {"verdict", cli::toJson(r.assessment)}};
}

void print(const Reconstruction& r, const std::string& path, const std::string& kind) {
  std::cout << forTerminal(path) << ": " << kind << " of cell model " << forTerminal(r.model->name) << '\n';
  if (!r.source.text.empty()) std::cout << "Source: " << forTerminal(r.source.text.english()) << '\n';
  std::cout << "Skin: " << sizeText(r) << ", " << freePorts(r) << " free ports\n";
  for (const PatchReconstruction& patch : r.patches) {
    std::cout << "  patch " << patch.id << ": " << counted(patch.cells.size(), "cell") << ", origin cell "
              << patch.origin << '\n';
    if (patch.lot) std::cout << "    lot: " << lotText(*patch.lot) << '\n';
  }
  std::cout << "Poses: " << r.poses.size() << '\n';
  for (const PoseSummary& pose : r.poses) {
    std::cout << "  " << pose.pose << (pose.label.empty() ? "" : " \"" + forTerminal(pose.label.english()) + "\"")
              << (pose.enabled ? "" : " (disabled)") << ": " << pose.cells_measured << " of " << r.cellCount()
              << " cells, noise " << formatFixed(pose.noise_g * 1000, 1) << " mg";
    if (pose.new_by_rad) std::cout << ", new by " << degrees(*pose.new_by_rad, 0);
    if (pose.residual_rad) std::cout << ", residual " << degrees(*pose.residual_rad, 1);
    std::cout << '\n';
  }
  printFindings(r.findings);
  printVerdict(r.assessment);
  if (r.solver == solverName(Solver::Tree)) {
    std::cout
        << "Judged link by link, along a tree. Weighing all links and poses together (--solver global) finds more, "
           "and its uncertainty is another.\n";
  }
}

int run(const InspectOptions& options, const Common& common) {
  const OpenedFile opened = openInput(options.input, options.cell_model);
  const auto* session = std::get_if<Session>(&opened);
  const std::string kind = session != nullptr ? "session" : "calibration";
  SolverOptions solver;
  solver.solver = solverFromName(options.solver);
  const auto result = session != nullptr ? reconstruct(*session->snapshot(), solver)
                                         : std::get<std::shared_ptr<const Reconstruction>>(opened);
  if (common.json) {
    printJson(describe(*result, kind));
  } else {
    print(*result, options.input, kind);
  }
  return kDone;
}

}  // namespace

void addInspect(CLI::App& app, Common& common) {
  auto [command, options] = addCommand<InspectOptions>(
      app, common, "inspect", "Say what is in a file, what is wrong with it and what to do next",
      "Example:\n  hexoderm-cli inspect arm.session.json", run);
  addInput(command, "input", options.input, "Session, calibration or TUM XML")->required();
  addInput(command, "--cell-model", options.cell_model, "Of a TUM file: built-in name or JSON file")
      ->capture_default_str();
  addWithDefault(command, "--solver", options.solver,
                 "Of a session: global, as 'solve' does; or tree, which is quicker and finds less");
}

}  // namespace hexoderm::cli
