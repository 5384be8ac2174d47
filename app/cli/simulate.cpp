#include "app/cli/command.h"

#include "hexoderm/device/simulation/fault_names.h"
#include "hexoderm/device/simulation/simulated_skin.h"
#include "hexoderm/io/open_file.h"
#include "hexoderm/io/session_json.h"
#include "hexoderm/session/simulated_session.h"
#include "hexoderm/util/text.h"

#include <iostream>

namespace hexoderm::cli {
namespace {

struct SimulateOptions {
  SimulatedSkinOptions skin;
  std::string cell_model = "hex-bma150";
  std::string link_law = "bend";
  std::string motion = "hand";
  std::size_t poses = 2;
  std::size_t samples = 100;
  double offset_sigma_mg = -1;
  bool ideal = false;
  std::vector<std::string> faults;
  std::string output;
};

template <class Kinds>
std::string namesOf(const Kinds& kinds) {
  std::string names;
  for (std::size_t k = 0; k < kinds.size(); ++k) {
    names += std::string(k == 0 ? "" : k + 1 == kinds.size() ? " or " : ", ") + std::string(kinds[k].first);
  }
  return names;
}

std::string faultSyntax() {
  return "KIND:CELL with KIND " + namesOf(skinFaultNames()) + ", or KIND:CELL:PORT with KIND " +
         namesOf(linkFaultNames()) + ", or KIND alone, of the whole skin: " + namesOf(wholeSkinFaultNames());
}

void addFault(const std::string& text, SimulatedSkinOptions& skin) {
  const std::vector<std::string> parts = split(text, ':');
  const auto number = [&](std::size_t part) { return parseUnsigned(parts[part], "--fault " + text); };
  for (const auto& [name, kind] : skinFaultNames()) {
    if (parts.size() != 2 || parts[0] != name) continue;
    skin.faults.push_back({kind, CellId(number(1))});
    return;
  }
  for (const auto& [name, kind] : wholeSkinFaultNames()) {
    if (parts.size() != 1 || parts[0] != name) continue;
    skin.whole_skin_faults.push_back(kind);
    return;
  }
  for (const auto& [name, kind] : linkFaultNames()) {
    if (parts.size() != 3 || parts[0] != name) continue;
    skin.link_faults.push_back({kind, {CellId(number(1)), PortNumber(number(2))}});
    return;
  }
  throw InvalidArgument("--fault: expected " + faultSyntax() + ", found \"" + text + "\"");
}

int run(const SimulateOptions& options, const Common& common) {
  const Output output(options.output, common);
  if (!output.isStandard() && !options.output.ends_with(".json") && !isSessionFileName(options.output)) {
    throw InvalidArgument("-o: expected a name that ends in .session.json or .hexo, or -, found \"" + options.output +
                          "\"");
  }
  CellModel model = asInput([&] { return loadCellModel(options.cell_model); });
  if (options.offset_sigma_mg >= 0) model.accelerometer.offset_sigma_g = options.offset_sigma_mg / 1000;
  model.validate();
  SimulatedSkinOptions skin_options = options.ideal               ? SimulatedSkinOptions::ideal()
                                      : options.motion == "robot" ? SimulatedSkinOptions::robot()
                                                                  : SimulatedSkinOptions();
  skin_options.patch = options.skin.patch;
  skin_options.surface = options.skin.surface;
  skin_options.seed = options.skin.seed;
  skin_options.link_law = options.link_law == "surface" ? LinkLaw::Surface : LinkLaw::Bend;
  for (const std::string& fault : options.faults) addFault(fault, skin_options);
  // Between the last pose and the one before it.
  skin_options.reglued_before = options.poses == 0 ? 0 : options.poses - 1;

  common.progress("Laying the skin ...");
  SimulatedSkin skin(std::move(model), skin_options);
  common.progress("Taking poses ...");
  const Session session = simulateSession(skin, options.poses, options.samples);
  common.progress("Writing ...");
  if (output.isStandard()) {
    output.write(sessionToJson(session));
  } else {
    saveSession(session, options.output);
  }
  common.endProgress();
  if (common.json) {
    printJson({{"file", options.output},
               {"description", skin.description().english()},
               {"cells", skin.truth().size()},
               {"poses", session.poses().size()}});
  } else {
    std::cout << skin.description() << ": " << skin.truth().size() << " cells, " << session.poses().size()
              << " poses, with truth. Written to " << forTerminal(output.inWords()) << '\n';
  }
  return kDone;
}

}  // namespace

void addSimulate(CLI::App& app, Common& common) {
  const auto options = std::make_shared<SimulateOptions>();
  CLI::App* command = app.add_subcommand("simulate", "Make a session of a simulated skin, with the truth beside it");
  command->add_option("--patch", options->skin.patch, "x17, ringN, ringN:closed or sheet:ROWSxCOLS")
      ->capture_default_str();
  command->add_option("--surface", options->skin.surface,
                      "plane, cylinder:r=M, sphere:r=M, cone:r=M,angle=RAD or torus:R=M,r=M "
                      "(default: what suits the patch)");
  command->add_option("--link-law", options->link_law, "How the mould lets neighbours lie: bend or surface")
      ->check(CLI::IsMember({"bend", "surface"}))
      ->capture_default_str();
  command->add_option("--poses", options->poses, "Number of poses")->check(CLI::Range(0, 1000))->capture_default_str();
  command->add_option("--samples", options->samples, "Samples averaged in a pose")
      ->check(CLI::Range(1, 100000))
      ->capture_default_str();
  command->add_option("--seed", options->skin.seed, "Seed of everything random")->capture_default_str();
  command->add_option("--cell-model", options->cell_model, "Built-in name or JSON file")->capture_default_str();
  command
      ->add_option("--offset-sigma", options->offset_sigma_mg,
                   "Accelerometer offsets, 1 sigma, in mg (default: the cell model's)")
      ->check(CLI::NonNegativeNumber);
  command->add_option("--fault", options->faults, faultSyntax() + "; may be repeated");
  CLI::Option* motion =
      command
          ->add_option("--motion", options->motion,
                       "What holds and turns the part: hand; or robot, with its motors on: 8 to 35 mg of vibration, 20 "
                       "readings a second, and a single joint")
          ->check(CLI::IsMember({"hand", "robot"}))
          ->capture_default_str();
  command->add_flag("--ideal", options->ideal, "No jitter, no sensor errors, no noise, no hand")->excludes(motion);
  command
      ->add_option("-o,--output", options->output,
                   "Session to write (*.session.json, or *.hexo, which must not exist yet; - is standard output)")
      ->required();
  common.addTo(*command);
  command->footer(
      "Example:\n  hexoderm-cli simulate --patch x17 --surface cylinder:r=0.0501 --poses 2 --seed 1 "
      "-o arm.session.json");
  command->callback([options, &common] { common.exit_code = run(*options, common); });
}

}  // namespace hexoderm::cli
