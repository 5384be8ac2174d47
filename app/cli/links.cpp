#include "app/cli/command.h"

#include "hexoderm/mounting/attachment/links.h"
#include "hexoderm/solve/reconstructor.h"
#include "hexoderm/solve/result/reconstruction.h"

#include <algorithm>
#include <iostream>

namespace hexoderm::cli {
namespace {

struct LinksArguments {
  std::string session;
  std::string robot;
  std::vector<std::string> packages;
  std::string joints;
  std::vector<std::string> chosen;
  std::vector<double> up;
  bool exact_joints = false;
};

/// "CELL=LINK".
void addChoice(const std::string& text, LinksOptions& options) {
  const std::size_t equals = text.find('=');
  if (equals == 0 || equals == std::string::npos || equals + 1 == text.size()) {
    throw InvalidArgument("--put: expected CELL=LINK, found \"" + text + "\"");
  }
  options.chosen[CellId(parseUnsigned(text.substr(0, equals), "--put " + text))] = text.substr(equals + 1);
}

LinksOptions optionsOf(const LinksArguments& arguments) {
  LinksOptions options;
  options.joint_zeros = !arguments.exact_joints;
  setUp(arguments.up, options);
  for (const std::string& choice : arguments.chosen) addChoice(choice, options);
  options.validate();
  return options;
}

// --- as text

void printCandidate(const LinkCandidate& candidate) {
  std::cout << "  misfit " << formatFixed(candidate.chi_squared, 1) << " / " << candidate.freedom << ", p "
            << formatFixed(candidate.probability, 4) << ", odds 10^" << formatFixed(candidate.log10_odds, 1) << '\n';
  for (const PatchTurn& turn : candidate.links) {
    std::cout << "    " << forTerminal(turn.link) << ": turned by roll, pitch, yaw " << rollPitchYaw(turn.R_l_o, 1)
              << ", +- " << degrees(rotationSigma(turn.covariance), 1) << '\n';
  }
}

void printPatch(const Reconstruction& r, const PatchLinks& patch) {
  std::cout << "Patch " << patch.patch << ", origin cell " << patch.origin << ", "
            << counted(r.patches[patch.patch.value()].cells.size(), "cell") << ", " << counted(patch.poses, "pose")
            << ": " << forTerminal(patch.why.english()) << '\n';
  for (const LinkCandidate& candidate : patch.candidates) printCandidate(candidate);
  if (patch.nearest) {
    std::cout << "  Comes nearest:\n";
    printCandidate(*patch.nearest);
  }
  if (!patch.residuals.empty()) {
    std::cout << "  left over:";
    const char* separator = " ";
    for (const LinkResidual& residual : patch.residuals) {
      std::cout << separator << "pose " << residual.pose << ": " << degrees(residual.angle_rad, 1);
      separator = ", ";
    }
    std::cout << '\n';
  }
  if (!patch.what_would_tell.empty()) std::cout << "  Next: " << forTerminal(patch.what_would_tell.english()) << '\n';
}

void printRobot(const RobotEstimate& robot) {
  std::cout << "All together: misfit " << formatFixed(robot.chi_squared, 1) << " / " << robot.freedom << ", p "
            << formatFixed(robot.probability, 4) << "; the base is tilted by " << degrees(robot.tilt_rad, 1) << " +- "
            << degrees(robot.tilt_sigma_rad, 1) << '\n';
  for (const JointZero& zero : robot.zeros) {
    std::cout << "  joint " << forTerminal(zero.joint) << ": zero " << degrees(zero.zero_rad, 1) << " +- "
              << degrees(zero.sigma_rad, 1) << (zero.shown ? "" : ", not shown by these poses") << '\n';
  }
}

void printAll(const Reconstruction& r, const LinksResult& result) {
  std::cout << forTerminal(result.summary.english()) << '\n';
  for (const Message& finding : result.findings) std::cout << "Note: " << forTerminal(finding.english()) << '\n';
  for (const PatchId patch : result.not_compared) {
    std::cout << "Not compared: patch " << patch << ", origin cell " << r.patches[patch.value()].origin << '\n';
  }
  for (const PatchLinks& patch : result.patches) printPatch(r, patch);
  if (result.robot) printRobot(*result.robot);
}

// --- as JSON

Json toJson(const PatchTurn& turn) {
  return {{"link", turn.link},
          {"q_l_o_wxyz", quaternionOf(turn.R_l_o)},
          {"covariance_rad2", rowsOf(turn.covariance)},
          {"sigma_deg", toDegrees(rotationSigma(turn.covariance))}};
}

Json toJson(const LinkCandidate& candidate) {
  return {{"chi_squared", candidate.chi_squared},
          {"freedom", candidate.freedom},
          {"probability", candidate.probability},
          {"log10_odds", candidate.log10_odds},
          {"links", arrayOf(candidate.links, [](const PatchTurn& turn) { return toJson(turn); })}};
}

Json toJson(const LinkResidual& residual) {
  return {{"pose", residual.pose.value()},
          {"angle_deg", toDegrees(residual.angle_rad)},
          {"sigma_deg", toDegrees(residual.sigma_rad)}};
}

Json toJson(const Reconstruction& r, const PatchLinks& patch) {
  const auto json_of = [](const auto& part) { return toJson(part); };
  return {{"id", patch.patch.value()},
          {"origin", patch.origin.value()},
          {"cells", r.patches[patch.patch.value()].cells.size()},
          {"poses", patch.poses},
          {"placed", orNull(patch.placed, json_of)},
          {"chosen", patch.chosen},
          {"candidates", arrayOf(patch.candidates, json_of)},
          {"nearest", orNull(patch.nearest, json_of)},
          {"open_axis_l", orNull(patch.open_axis_l, listOf)},
          {"residuals", arrayOf(patch.residuals, json_of)},
          {"why", patch.why.english()},
          {"what_would_tell", patch.what_would_tell.english()}};
}

Json toJson(const JointZero& zero) {
  return {{"joint", zero.joint},
          {"zero_deg", toDegrees(zero.zero_rad)},
          {"sigma_deg", toDegrees(zero.sigma_rad)},
          {"prior_sigma_deg", toDegrees(zero.prior_sigma_rad)},
          {"shown", zero.shown}};
}

Json toJson(const JointResidual& residual) {
  return {{"pose", residual.pose.value()},
          {"joint", residual.joint},
          {"turn_deg", toDegrees(residual.turn_rad)},
          {"sigma_deg", toDegrees(residual.sigma_rad)}};
}

Json toJson(const RobotEstimate& robot) {
  const auto json_of = [](const auto& part) { return toJson(part); };
  Json json = {{"patches", numbersOf(robot.patches)},
               {"chi_squared", robot.chi_squared},
               {"freedom", robot.freedom},
               {"probability", robot.probability},
               {"up_w", listOf(robot.up_w)},
               {"up_covariance_rad2", rowsOf(robot.up_covariance)},
               {"tilt_deg", toDegrees(robot.tilt_rad)},
               {"tilt_sigma_deg", toDegrees(robot.tilt_sigma_rad)},
               {"zeros", arrayOf(robot.zeros, json_of)},
               {"residuals", arrayOf(robot.residuals, json_of)},
               {"covariance_rad2", Json::array()}};
  const std::size_t size = robot.unknowns();
  for (std::size_t row = 0; row < size; ++row) {
    const auto begin = robot.covariance.begin() + static_cast<std::ptrdiff_t>(row * size);
    json["covariance_rad2"].push_back(std::vector<double>(begin, begin + static_cast<std::ptrdiff_t>(size)));
  }
  return json;
}

Json toJson(const Reconstruction& r, const LinksResult& result) {
  return {{"summary", result.summary.english()},
          {"findings", textsOf(result.findings)},
          {"poses", numbersOf(result.poses)},
          {"patches", arrayOf(result.patches, [&](const PatchLinks& patch) { return toJson(r, patch); })},
          {"robot", orNull(result.robot, [](const RobotEstimate& robot) { return toJson(robot); })},
          {"not_compared", numbersOf(result.not_compared)}};
}

bool placesAll(const LinksResult& result) {
  return !result.patches.empty() && result.not_compared.empty() &&
         std::ranges::all_of(result.patches, [](const PatchLinks& patch) { return patch.placed.has_value(); });
}

int run(const LinksArguments& arguments, const Common& common) {
  const LinksOptions options = optionsOf(arguments);
  const RobotModel robot = openRobot(arguments.robot, arguments.packages);
  const Session session = openSession(arguments.session);
  const std::map<PoseId, JointAngles> angles = anglesOfPoses(session, arguments.joints, robot);
  common.progress("Solving ...");
  const auto r = reconstruct(*session.snapshot());
  common.progress("Comparing with the robot ...");
  const LinksResult result = findLinks(*r, robot, angles, options);
  common.endProgress();
  if (common.json) {
    printJson(toJson(*r, result));
  } else {
    printAll(*r, result);
  }
  return placesAll(result) ? kDone : kNotGoodEnough;
}

}  // namespace

void addLinks(CLI::App& app, Common& common) {
  auto [command, arguments] = addCommand<LinksArguments>(
      app, common, "links", "Tell on which link of a robot each patch is, and how it is turned there",
      "From gravity and joint angles: the base stands still, and where on its link a patch lies is not told.\n"
      "Exit code 1: some patch is on no link that is known.\n"
      "Example:\n  hexoderm-cli links robot.session.json --robot robot.urdf --joints robot.joints.csv",
      run);
  addInput(command, "session", arguments.session, "Session (*.hexo or *.session.json)")->required();
  addInput(command, "--robot", arguments.robot, "The robot as URDF, or demo")->required();
  addInput(command, "--joints", arguments.joints,
           "Joint angles of the poses as CSV (default: those that the session holds)");
  command.add_option("--package", arguments.packages, "NAME=FOLDER of meshes at package://NAME/...; may be repeated");
  command.add_option("--put", arguments.chosen,
                     "CELL=LINK: take the patch of a cell to be on a link, whatever fits; may be repeated");
  takeDirection(
      command.add_option("--up", arguments.up, "The direction that points up in the frame of the robot's base: x,y,z"));
  command.add_flag("--exact-joints", arguments.exact_joints, "Joints have no zero errors");
}

}  // namespace hexoderm::cli
