#include "app/cli/command.h"

#include "hexoderm/base/file.h"
#include "hexoderm/base/kept_files.h"
#include "hexoderm/base/text.h"
#include "hexoderm/io/open_file.h"
#include "hexoderm/io/session_joint_angles.h"
#include "hexoderm/sim/fault_names.h"
#include "hexoderm/sim/robot_text.h"
#include "hexoderm/sim/robot_truth_json.h"
#include "hexoderm/sim/simulated_session.h"
#include "hexoderm/sim/simulated_skin.h"

#include <cstdint>
#include <iostream>
#include <limits>

namespace hexoderm::cli {
namespace {

/// More than the range of any accelerometer.
constexpr double kMaxOffsetSigma_mg = 100'000;

struct SimulateOptions {
  RobotText words;
  std::string cell_model = "hex-bma150";
  std::string link_law = "bend";
  std::string motion = "hand";
  std::size_t poses = 2;
  std::size_t samples = 100;
  std::optional<double> offset_sigma_mg;
  std::vector<double> lot;  ///< mg, %
  std::vector<std::string> faults;
  std::string joints;  ///< empty: beside the session
  std::string truth;
  std::string output;
};

/// "arm.joints.csv" beside "arm.session.json".
std::string besideOutput(const SimulateOptions& options, const std::string& ending) {
  std::string name = options.output;
  for (const std::string_view known : {".session.json", ".json", ".hexo"}) {
    if (!name.ends_with(known)) continue;
    name.resize(name.size() - known.size());
    break;
  }
  return name + ending;
}

int runRobot(SimulatedRobot robot, const SimulateOptions& options, const Output& output, const Common& common) {
  const bool moves = !robot.robot().freeJointNames().empty();
  if (!moves && !options.joints.empty()) throw InvalidArgument("--joints: no joint of the robot can move");
  const std::string joints = options.joints.empty() ? besideOutput(options, ".joints.csv") : options.joints;
  const std::string truth = options.truth.empty() ? besideOutput(options, ".truth.json") : options.truth;
  for (const std::string& beside : {joints, truth}) {
    if (beside == kStandardOutput) throw InvalidArgument("--joints and --truth: expected the name of a file, found -");
    requireReplaceable(beside, beside);
    requireApart(beside, options.output);
  }
  requireApart(joints, truth);
  common.progress("Taking poses ...");
  const SimulatedRobotSession simulated = simulateRobotSession(robot, options.poses, options.samples);
  common.progress("Writing ...");
  output.write(simulated.session);
  const bool beside = !output.isStandard();
  const bool has_joints = moves && options.poses > 0 && (beside || !options.joints.empty());
  const bool has_truth = beside || !options.truth.empty();
  if (has_joints) writeFileAtomically(joints, jointAnglesCsv(jointAnglesOf(simulated.session), robot.robot()));
  if (has_truth) writeFileAtomically(truth, robotTruthToJson(robot, simulated));
  common.endProgress();
  if (common.json) {
    printJson({{"file", options.output},
               {"joint_angles", has_joints ? nlohmann::ordered_json(joints) : nullptr},
               {"truth", has_truth ? nlohmann::ordered_json(truth) : nullptr},
               {"description", robot.description().english()},
               {"cells", robot.neighbors().size()},
               {"patches", robot.patches().size()},
               {"poses", simulated.session.poses().size()}});
  } else {
    std::cout << robot.description() << ": " << robot.neighbors().size() << " cells in " << robot.patches().size()
              << (robot.patches().size() == 1 ? " patch, " : " patches, ") << simulated.session.poses().size()
              << " poses. Written to " << forTerminal(output.inWords());
    if (has_joints) std::cout << "; joint angles: " << forTerminal(joints);
    if (has_truth) std::cout << "; truth: " << forTerminal(truth);
    std::cout << '\n';
  }
  return kDone;
}

int run(const SimulateOptions& options, const Common& common) {
  const Output output(options.output, common);
  if (!output.isStandard() && !options.output.ends_with(".json") && !isSessionFileName(options.output)) {
    throw InvalidArgument("-o: expected a name that ends in .session.json or .hexo, or -, found \"" + options.output +
                          "\"");
  }
  CellModel model = asInput([&] { return loadCellModel(options.cell_model); });
  if (options.offset_sigma_mg) model.accelerometer.offset_sigma_g.setConstant(*options.offset_sigma_mg / 1000);
  if (!options.lot.empty()) model.accelerometer.offset_shared_sigma_g = options.lot.front() / 1000;
  if (options.lot.size() == 2) model.accelerometer.scale_shared_sigma = options.lot.back() / 100;
  model.validate();
  RobotText words = options.words;
  words.link_law = linkLawFromName(options.link_law);
  if (!words.robot.empty()) {
    common.progress("Laying the skins ...");
    return runRobot(asInput([&] { return makeRobot(std::move(model), words); }), options, output, common);
  }
  SimulatedSkinOptions skin_options = skinOptions(words, options.motion);
  for (const std::string& fault : options.faults) addFault(fault, "--fault", skin_options);
  // Between the last pose and the one before it.
  skin_options.reglued_before = options.poses == 0 ? 0 : options.poses - 1;

  // The skin goes before the session is written: of a million cells both are large.
  const Session session = [&] {
    common.progress("Laying the skin ...");
    SimulatedSkin skin(std::move(model), skin_options);
    common.progress("Taking poses ...");
    return simulateSession(skin, options.poses, options.samples);
  }();
  common.progress("Writing ...");
  output.write(session);
  common.endProgress();
  if (common.json) {
    printJson({{"file", options.output},
               {"description", session.source().text.english()},
               {"cells", session.neighbors().size()},
               {"poses", session.poses().size()}});
  } else {
    std::cout << session.source().text << ": " << session.neighbors().size() << " cells, " << session.poses().size()
              << " poses, with truth. Written to " << forTerminal(output.inWords()) << '\n';
  }
  return kDone;
}

}  // namespace

void addSimulate(CLI::App& app, Common& common) {
  auto [command, options] = addCommand<SimulateOptions>(
      app, common, "simulate", "Make a session of a simulated skin, with the truth beside it",
      "Example:\n  hexoderm-cli simulate --patch x17 --surface cylinder:r=0.0501 --poses 2 --seed 1 "
      "-o arm.session.json\n"
      "  hexoderm-cli simulate --robot demo --poses 8 -o arm.session.json",
      run);
  addWithDefault(command, "--patch", options.words.patch,
                 "x17, ringN, ringN:closed or sheet:ROWSxCOLS (1,000,000 cells at most)");
  command.add_option("--surface", options.words.surface,
                     "plane, cylinder:r=M, sphere:r=M, cone:r=M,angle=RAD or torus:R=M,r=M "
                     "(default: what suits the patch)");
  addWithDefault(command, "--link-law", options.link_law, "How the mould lets neighbours lie: bend or surface")
      ->check(CLI::IsMember({"bend", "surface"}));
  takeWholeNumbers(addWithDefault(command, "--poses", options.poses, "Number of poses"), 0, 1000);
  takeWholeNumbers(addWithDefault(command, "--samples", options.samples, "Samples averaged in a pose"), 1, 100'000);
  takeWholeNumbers(addWithDefault(command, "--seed", options.words.seed, "Seed of everything random"), 0,
                   std::numeric_limits<std::uint64_t>::max());
  addInput(command, "--cell-model", options.cell_model, "Built-in name or JSON file")->capture_default_str();
  takeNumbers(
      command.add_option("--offset-sigma", options.offset_sigma_mg,
                         "Offset of each accelerometer beside its lot's, 1 sigma, in mg (default: the cell model's)"),
      0, kMaxOffsetSigma_mg);
  takeNumbers(
      command
          .add_option("--lot", options.lot,
                      "Errors that the chips of the skin's lot share, 1 sigma: of the offset, in mg, and of the "
                      "scale, in % (default: the cell model's)")
          ->type_name("MG[,PERCENT]")
          ->expected(1, 2)
          ->delimiter(','),
      0, kMaxOffsetSigma_mg);
  CLI::Option* faults = command.add_option("--fault", options.faults, faultSyntax() + "; may be repeated");
  CLI::Option* motion =
      addWithDefault(command, "--motion", options.motion,
                     "What holds and turns the part: hand; or robot, with its motors on: 8 to 35 mg of vibration, 20 "
                     "readings a second, and a single joint")
          ->check(CLI::IsMember({"hand", "robot"}));
  CLI::Option* ideal =
      command.add_flag("--ideal", options.words.ideal, "No jitter, no sensor errors, no noise, no hand")
          ->excludes(motion);
  CLI::Option* robot =
      addInput(command, "--robot", options.words.robot,
               "A robot that wears the skin, as URDF, or demo: an arm with a patch on the upper arm and one on "
               "the forearm. In every pose its joints stand in angles drawn at random")
          ->excludes(motion)
          ->excludes(faults);
  takeTexts(command.add_option(
                "--mount", options.words.mounts,
                "A patch on the robot: " + std::string(kMountSyntax) +
                    ", the place of its middle in the link's frame in m and rad, z out of the skin; without --surface "
                    "it lies on the link's body where that is nearest; may be repeated"),
            requireMount)
      ->needs(robot);
  addWithDefault(command, "--base", options.words.base,
                 "What holds the robot: fixed, on a base that holds still; motors, the same with its motors on, which "
                 "shake it by 8 to 35 mg; or hand, which turns the whole robot anew in every pose")
      ->check(CLI::IsMember({"fixed", "motors", "hand"}))
      ->needs(robot)
      ->excludes(ideal);
  command
      .add_option("--package", options.words.packages, "NAME=FOLDER of meshes at package://NAME/...; may be repeated")
      ->needs(robot);
  addOutput(command, "--joints", options.joints,
            "Joint angles to write (default: *.joints.csv beside the session; none beside -)")
      ->needs(robot);
  addOutput(command, "--truth", options.truth,
            "Truth to write: places of cells on links, errors of joints, links in every pose (default: "
            "*.truth.json beside the session; none beside -)")
      ->needs(robot);
  addOutput(command, "-o,--output", options.output,
            "Session to write (*.session.json, or *.hexo, which must not exist yet; - is standard output)")
      ->required();
}

}  // namespace hexoderm::cli
