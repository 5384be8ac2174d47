#include "app/cli/command.h"
#include "app/cli/solve_batch.h"

#include "hexoderm/base/parallel.h"
#include "hexoderm/base/text.h"
#include "hexoderm/io/calibration_json.h"
#include "hexoderm/solve/checks/evaluation.h"
#include "hexoderm/solve/reconstructor.h"

#include <cstdint>
#include <iostream>
#include <limits>
#include <map>

namespace hexoderm::cli {
namespace {

struct SolveOptions {
  std::vector<std::string> inputs;
  std::string output;
  std::size_t jobs = cores();
  std::map<std::string_view, std::string> choices;  ///< of solverChoices(), by name
  std::vector<std::uint32_t> without;
  double class_threshold = SolverOptions().class_threshold;
};

void printSummary(const Reconstruction& r, const Session& session) {
  std::cout << sizeText(r) << ", " << session.poses().size() << " poses, solved in "
            << formatFixed(r.solve_seconds * 1000, 1) << " ms (" << r.solver << ")\n";
  for (const PatchReconstruction& patch : r.patches) {
    std::cout << "Patch " << patch.id << ": " << counted(patch.cells.size(), "cell") << ", origin cell "
              << patch.origin;
    if (patch.gap_share && patch.gap_share->sigma > 0) {
      std::cout << ", gap share " << formatFixed(patch.gap_share->share, 2) << " +- "
                << formatFixed(patch.gap_share->sigma, 2) << " (0 pivot, 1 arc)";
    }
    std::cout << '\n';
  }
  if (session.truth()) {
    for (const Comparison& comparison : compareToTruth(r, *session.truth())) {
      if (comparison.cells.size() == 1) continue;  // it fits wherever it is
      std::cout << "Against the truth, patch " << comparison.patch << ": position "
                << millimetres(comparison.position_rms_m, 3) << " rms, orientation "
                << degrees(comparison.orientation_rms_rad, 3) << " rms (after alignment)\n";
    }
  }
  printFindings(r.findings);
  printVerdict(r.assessment);
}

int run(const SolveOptions& options, const Common& common) {
  SolverOptions solver;
  for (const SolverChoice& choice : solverChoices()) choice.set(solver, options.choices.at(choice.name));
  for (const std::uint32_t id : options.without) solver.left_out.emplace_back(id);
  solver.class_threshold = options.class_threshold;
  solver.validate();
  if (options.inputs.size() > 1 || options.output.ends_with('/')) {
    return solveBatch({options.inputs, options.output, std::move(solver), options.jobs}, common);
  }
  const Output output(options.output, common);

  const std::string& input = options.inputs.front();
  common.progress("Reading " + input + " ...");
  const Session session = openSession(input);
  common.progress("Solving ...");
  const auto result = reconstruct(*session.snapshot(), solver);
  if (!options.output.empty()) {
    common.progress("Writing " + output.inWords() + " ...");
    output.write([&](const WriteBytes& write) { writeCalibrationJson(*result, write); });
  }
  common.endProgress();
  if (common.json) {
    printJsonText(calibrationToJson(*result));
  } else {
    printSummary(*result, session);
    if (!options.output.empty()) std::cout << "Written to " << forTerminal(output.inWords()) << '\n';
  }
  return exitCodeOf(result->assessment);
}

}  // namespace

void addSolve(CLI::App& app, Common& common) {
  auto [command, options] = addCommand<SolveOptions>(
      app, common, "solve", "Find the placement of every cell of a session",
      "Many sessions are solved at the same time, each as if it were alone. Each gets a line on standard output, with\n"
      "--json an object in a line; the exit code is the largest of all.\n"
      "Example:\n  hexoderm-cli solve arm.session.json -o arm.calibration.json\n"
      "With a mould that stretches, and cell 7 placed through its links:\n"
      "  hexoderm-cli solve arm.session.json --gap-model arc --without 7\n"
      "The paper's own method:\n  hexoderm-cli solve arm.session.json --solver tree --centre off\n"
      "All sessions of a folder, arm.session.json to out/arm.calibration.json:\n"
      "  hexoderm-cli solve *.session.json -o out/",
      run);
  addInput(command, "input", options.inputs, "Session (*.hexo or *.session.json), or many")->required();
  addOutput(command, "-o,--output", options.output,
            "Calibration to write (*.calibration.json; - is standard output); of several sessions, or with "
            "a / at its end, the folder for their calibrations");
  for (const SolverChoice& choice : solverChoices()) {
    std::string& value = options.choices[choice.name];
    value = choice.get(SolverOptions());
    addWithDefault(command, "--" + std::string(choice.name), value, std::string(choice.help));
  }
  takeWholeNumbers(command.add_option("--without", options.without, "Leave this cell's readings out; may be repeated"),
                   0, std::numeric_limits<std::uint32_t>::max());
  takeNumbersAbove(addWithDefault(command, "--class-threshold", options.class_threshold,
                                  "Singular value from which a direction counts as defined; 1 is the paper's"),
                   0, kMaxClassThreshold);
  takeWholeNumbers(
      command.add_option("-j,--jobs", options.jobs,
                         "Of many sessions, so many at the same time (default: as the computer has threads)"),
      1, 1024);
}

}  // namespace hexoderm::cli
