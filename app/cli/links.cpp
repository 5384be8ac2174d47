#include "app/cli/command.h"

#include "hexoderm/reconstruction/reconstructor.h"
#include "hexoderm/reconstruction/result/uncertainty.h"
#include "hexoderm/robot/links/links.h"
#include "hexoderm/util/text.h"
#include "hexoderm/util/units.h"

#include <algorithm>
#include <cmath>
#include <iostream>

namespace hexoderm::cli {
namespace {

using Json = nlohmann::ordered_json;

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

std::string rollPitchYaw(const Eigen::Matrix3d& R) {
  const Eigen::Vector3d angles = rpyFromRotation(R);
  return formatFixed(toDegrees(angles.x()), 1) + " " + formatFixed(toDegrees(angles.y()), 1) + " " +
         formatFixed(toDegrees(angles.z()), 1) + " deg";
}

void printCandidate(const LinkCandidate& candidate) {
  std::cout << "  misfit " << formatFixed(candidate.chi_squared, 1) << " / " << candidate.freedom << ", p "
            << formatFixed(candidate.probability, 4) << ", odds 10^" << formatFixed(candidate.log10_odds, 1) << '\n';
  for (const PatchTurn& turn : candidate.links) {
    std::cout << "    " << forTerminal(turn.link) << ": turned by roll, pitch, yaw " << rollPitchYaw(turn.R_l_o)
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
  if (!patch.what_would_tell.empty()) {
    std::cout << "  Next: " << forTerminal(patch.what_would_tell.english()) << '\n';
  }
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
  for (const Message& finding : result.findings) {
    std::cout << "Note: " << forTerminal(finding.english()) << '\n';
  }
  for (const PatchId patch : result.not_compared) {
    std::cout << "Not compared: patch " << patch << ", origin cell " << r.patches[patch.value()].origin << '\n';
  }
  for (const PatchLinks& patch : result.patches) printPatch(r, patch);
  if (result.robot) printRobot(*result.robot);
}

// --- as JSON

Json listOf(const Eigen::Vector3d& v) { return {v.x(), v.y(), v.z()}; }

Json rowsOf(const Eigen::Matrix3d& M) {
  Json json = Json::array();
  for (Eigen::Index row = 0; row < 3; ++row) json.push_back(listOf(M.row(row).transpose()));
  return json;
}

Json toJson(const PatchTurn& turn) {
  const Eigen::Quaterniond q(turn.R_l_o);
  return {{"link", turn.link},
          {"q_l_o_wxyz", {q.w(), q.x(), q.y(), q.z()}},
          {"covariance_rad2", rowsOf(turn.covariance)},
          {"sigma_deg", toDegrees(rotationSigma(turn.covariance))}};
}

Json toJson(const LinkCandidate& candidate) {
  Json json = {{"chi_squared", candidate.chi_squared},
               {"freedom", candidate.freedom},
               {"probability", candidate.probability},
               {"log10_odds", candidate.log10_odds},
               {"links", Json::array()}};
  for (const PatchTurn& turn : candidate.links) json["links"].push_back(toJson(turn));
  return json;
}

Json toJson(const Reconstruction& r, const PatchLinks& patch) {
  Json json = {{"id", patch.patch.value()},
               {"origin", patch.origin.value()},
               {"cells", r.patches[patch.patch.value()].cells.size()},
               {"poses", patch.poses},
               {"placed", patch.placed ? toJson(*patch.placed) : Json(nullptr)},
               {"chosen", patch.chosen},
               {"candidates", Json::array()},
               {"nearest", patch.nearest ? toJson(*patch.nearest) : Json(nullptr)},
               {"open_axis_l", patch.open_axis_l ? listOf(*patch.open_axis_l) : Json(nullptr)},
               {"residuals", Json::array()},
               {"why", patch.why.english()},
               {"what_would_tell", patch.what_would_tell.english()}};
  for (const LinkCandidate& candidate : patch.candidates) json["candidates"].push_back(toJson(candidate));
  for (const LinkResidual& residual : patch.residuals) {
    json["residuals"].push_back({{"pose", residual.pose.value()},
                                 {"angle_deg", toDegrees(residual.angle_rad)},
                                 {"sigma_deg", toDegrees(residual.sigma_rad)}});
  }
  return json;
}

Json toJson(const RobotEstimate& robot) {
  Json json = {{"patches", Json::array()},
               {"chi_squared", robot.chi_squared},
               {"freedom", robot.freedom},
               {"probability", robot.probability},
               {"up_w", listOf(robot.up_w)},
               {"up_covariance_rad2", rowsOf(robot.up_covariance)},
               {"tilt_deg", toDegrees(robot.tilt_rad)},
               {"tilt_sigma_deg", toDegrees(robot.tilt_sigma_rad)},
               {"zeros", Json::array()},
               {"residuals", Json::array()},
               {"covariance_rad2", Json::array()}};
  for (const PatchId patch : robot.patches) json["patches"].push_back(patch.value());
  for (const JointZero& zero : robot.zeros) {
    json["zeros"].push_back({{"joint", zero.joint},
                             {"zero_deg", toDegrees(zero.zero_rad)},
                             {"sigma_deg", toDegrees(zero.sigma_rad)},
                             {"prior_sigma_deg", toDegrees(zero.prior_sigma_rad)},
                             {"shown", zero.shown}});
  }
  for (const JointResidual& residual : robot.residuals) {
    json["residuals"].push_back({{"pose", residual.pose.value()},
                                 {"joint", residual.joint},
                                 {"turn_deg", toDegrees(residual.turn_rad)},
                                 {"sigma_deg", toDegrees(residual.sigma_rad)}});
  }
  const std::size_t size = robot.unknowns();
  for (std::size_t row = 0; row < size; ++row) {
    const auto begin = robot.covariance.begin() + static_cast<std::ptrdiff_t>(row * size);
    json["covariance_rad2"].push_back(std::vector<double>(begin, begin + static_cast<std::ptrdiff_t>(size)));
  }
  return json;
}

Json toJson(const Reconstruction& r, const LinksResult& result) {
  Json json = {{"summary", result.summary.english()},
               {"findings", Json::array()},
               {"poses", Json::array()},
               {"patches", Json::array()},
               {"robot", result.robot ? toJson(*result.robot) : Json(nullptr)},
               {"not_compared", Json::array()}};
  for (const Message& finding : result.findings) json["findings"].push_back(finding.english());
  for (const PoseId pose : result.poses) json["poses"].push_back(pose.value());
  for (const PatchLinks& patch : result.patches) json["patches"].push_back(toJson(r, patch));
  for (const PatchId patch : result.not_compared) json["not_compared"].push_back(patch.value());
  return json;
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
  const auto arguments = std::make_shared<LinksArguments>();
  CLI::App* command =
      app.add_subcommand("links", "Tell on which link of a robot each patch is, and how it is turned there");
  command->add_option("session", arguments->session, "Session (*.hexo or *.session.json)")
      ->type_name(kInput)
      ->required();
  command->add_option("--robot", arguments->robot, "The robot as URDF, or demo")->type_name(kInput)->required();
  command
      ->add_option("--joints", arguments->joints,
                   "Joint angles of the poses as CSV (default: those that the session holds)")
      ->type_name(kInput);
  command->add_option("--package", arguments->packages, "NAME=FOLDER of meshes at package://NAME/...; may be repeated");
  command->add_option("--put", arguments->chosen,
                      "CELL=LINK: take the patch of a cell to be on a link, whatever fits; may be repeated");
  takeDirection(command->add_option("--up", arguments->up,
                                    "The direction that points up in the frame of the robot's base: x,y,z"));
  command->add_flag("--exact-joints", arguments->exact_joints, "Joints have no zero errors");
  common.addTo(*command);
  command->footer(
      "From gravity and joint angles: the base stands still, and where on its link a patch lies is not told.\n"
      "Exit code 1: some patch is on no link that is known.\n"
      "Example:\n  hexoderm-cli links robot.session.json --robot robot.urdf --joints robot.joints.csv");
  command->callback([arguments, &common] { common.exit_code = run(*arguments, common); });
}

}  // namespace hexoderm::cli
