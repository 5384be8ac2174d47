#include "hexoderm/mounting/place/place.h"

#include "hexoderm/base/covariance.h"
#include "hexoderm/base/enum_names.h"
#include "hexoderm/io/placements_json.h"
#include "hexoderm/mounting/attachment/links.h"
#include "hexoderm/robots/robot_model.h"
#include "hexoderm/solve/reconstructor.h"

#include "app/cli/command.h"

#include <algorithm>
#include <iostream>
#include <map>

namespace hexoderm::cli {
namespace {

constexpr std::string_view kPointSyntax = "CELL:x,y,z[:sigma]";
constexpr std::string_view kDistanceSyntax = "CELL:CELL:distance[:sigma]";
constexpr std::string_view kRotationSyntax = "[CELL@]roll,pitch,yaw[:sigma]";
constexpr std::string_view kFromLinks = "links";
constexpr double kMinAngleSigma_deg = 0.001;  ///< of a rotation, and of the normals
constexpr double kFullTurn_deg = 360;

struct PlaceCommandOptions {
  std::string input;
  std::string robot;
  std::vector<std::string> packages;
  std::string link;
  std::string body = "any";
  std::vector<std::uint32_t> patches;
  std::vector<std::string> rotations;
  std::string joints;
  std::vector<double> up;
  std::vector<std::string> points;
  std::vector<std::string> distances;
  bool no_surface = false;
  double surface_sigma_mm = 1;
  double normal_sigma_deg = 3;
  double gap_mm = 0;
  std::string output;
};

[[noreturn]] void refuse(std::string_view option, std::string_view expected, const std::string& found) {
  throw InvalidArgument(std::string(option) + ": expected " + std::string(expected) + ", found \"" + found + "\"");
}

/// As many numbers with commas between, each at most `most` in magnitude.
std::vector<double> numbersFrom(const std::string& text, std::size_t count, std::string_view option,
                                std::string_view expected, const std::string& whole, double most) {
  const std::vector<std::string> parts = split(text, ',');
  if (parts.size() != count) refuse(option, expected, whole);
  std::vector<double> numbers;
  for (const std::string& part : parts) numbers.push_back(parseNumberWithin(part, option, -most, most));
  return numbers;
}

KnownPoint pointFrom(const std::string& text) {
  const std::vector<std::string> parts = split(text, ':');
  if (parts.size() != 2 && parts.size() != 3) refuse("--point", kPointSyntax, text);
  KnownPoint point;
  point.cell = CellId(parseUnsigned(parts[0], "--point"));
  const std::vector<double> x = numbersFrom(parts[1], 3, "--point", kPointSyntax, text, kMaxPlaceLength_m);
  point.x_l = {x[0], x[1], x[2]};
  if (parts.size() == 3) point.sigma_m = parseNumberWithin(parts[2], "--point", kMinPlaceSigma_m, kMaxPlaceLength_m);
  return point;
}

KnownDistance distanceFrom(const std::string& text) {
  const std::vector<std::string> parts = split(text, ':');
  if (parts.size() != 3 && parts.size() != 4) refuse("--distance", kDistanceSyntax, text);
  KnownDistance distance;
  distance.a = CellId(parseUnsigned(parts[0], "--distance"));
  distance.b = CellId(parseUnsigned(parts[1], "--distance"));
  distance.distance_m = parseNumberWithin(parts[2], "--distance", kMinPlaceSigma_m, kMaxPlaceLength_m);
  if (parts.size() == 4)
    distance.sigma_m = parseNumberWithin(parts[3], "--distance", kMinPlaceSigma_m, kMaxPlaceLength_m);
  return distance;
}

const PatchReconstruction& patchOf(const Reconstruction& r, std::uint32_t cell) {
  const PatchReconstruction* patch = r.find(CellId(cell)).patch;
  if (patch == nullptr) throw InvalidArgument("no patch holds a cell " + std::to_string(cell));
  return *patch;
}

/// The patches that are asked for, else those of points and distances, else the largest.
std::vector<const PatchReconstruction*> patchesToPlace(const Reconstruction& r, const PlaceCommandOptions& options,
                                                       const PlaceTask& task) {
  std::vector<const PatchReconstruction*> patches;
  const auto add = [&](std::uint32_t cell) {
    const PatchReconstruction& patch = patchOf(r, cell);
    if (std::ranges::find(patches, &patch) == patches.end()) patches.push_back(&patch);
  };
  for (const std::uint32_t cell : options.patches) add(cell);
  for (const KnownDistance& distance : task.distances) {
    add(distance.a.value());
    add(distance.b.value());
  }
  if (patches.empty()) {
    for (const KnownPoint& point : task.points) add(point.cell.value());
  }
  if (patches.empty()) {
    if (const PatchReconstruction* largest = largestPatch(r)) patches.push_back(largest);
  }
  return patches;
}

/// "[CELL@]roll,pitch,yaw[:sigma]" in degrees, R_l_o of the patch of a cell.
void addRotation(const Reconstruction& r, const std::string& text, PlaceTask& task) {
  const std::size_t at = text.find('@');
  const std::string angles = at == std::string::npos ? text : text.substr(at + 1);
  PatchToPlace* patch = &task.patches.front();
  if (at != std::string::npos) {
    const CellId origin = patchOf(r, parseUnsigned(text.substr(0, at), "--rotation")).origin;
    const auto found = std::ranges::find(task.patches, origin, &PatchToPlace::origin);
    if (found == task.patches.end())
      throw InvalidArgument("--rotation \"" + text + "\": that patch is not to be placed");
    patch = &*found;
  } else if (task.patches.size() > 1) {
    throw InvalidArgument("--rotation \"" + text + "\": say with CELL@ of which patch");
  }
  const std::vector<std::string> parts = split(angles, ':');
  if (parts.size() > 2) refuse("--rotation", kRotationSyntax, text);
  const std::vector<double> rpy = numbersFrom(parts[0], 3, "--rotation", kRotationSyntax, text, kFullTurn_deg);
  const double sigma_deg =
      parts.size() == 2 ? parseNumberWithin(parts[1], "--rotation: sigma", kMinAngleSigma_deg, kFullTurn_deg) : 1;
  KnownRotation rotation;
  rotation.R_l_o = rotationFromRpy({rpy[0] * kDegree, rpy[1] * kDegree, rpy[2] * kDegree});
  rotation.covariance = std::pow(sigma_deg * kDegree, 2) * Eigen::Matrix3d::Identity();
  patch->rotation = rotation;
}

/// The link's body, and a remark where its size is that of no link.
TriangleMesh surfaceOf(const PlaceCommandOptions& options, const RobotModel& robot, std::size_t link,
                       const Common& common) {
  const LinkBody body = options.body == "visual"      ? LinkBody::Visual
                        : options.body == "collision" ? LinkBody::Collision
                                                      : LinkBody::Any;
  if (!robot.hasBody(link, body)) {
    throw BadInput(options.robot + ": nothing describes the body of link " + options.link +
                   ". With --no-surface, points and distances say where the patch is");
  }
  TriangleMesh mesh = asInput([&] { return robot.bodyOf(link, body); });
  if (const auto suspected = robot.suspectedUnit(link, mesh)) common.note(suspected->message.english());
  return mesh;
}

struct SolvedInput {
  std::shared_ptr<const Reconstruction> result;
  std::optional<Session> session;  ///< none: the input is a calibration
};

SolvedInput solved(const std::string& input, const Common& common) {
  OpenedFile opened = openInput(input);
  if (auto* calibration = std::get_if<std::shared_ptr<const Reconstruction>>(&opened)) return {*calibration, {}};
  SolvedInput fresh{nullptr, std::move(std::get<Session>(opened))};
  common.progress("Solving ...");
  fresh.result = reconstruct(*fresh.session->snapshot());
  common.endProgress();
  return fresh;
}

bool wantsLinks(const PlaceCommandOptions& options) {
  const bool wants = std::ranges::find(options.rotations, kFromLinks) != options.rotations.end();
  if (!wants && !(options.joints.empty() && options.up.empty())) {
    throw InvalidArgument("--joints and --up go with --rotation links");
  }
  return wants;
}

/// How the patches are turned on the link by gravity and joint angles, as the command `links` finds it. Those of which
/// --rotation says it keep that. Whether all of them fit the link; a remark says so where one does not.
bool takeRotationsOfLinks(const PlaceCommandOptions& options, const SolvedInput& input, const RobotModel& robot,
                          PlaceTask& task, const Common& common) {
  if (!input.session) throw noSession(options.input);
  const std::map<PoseId, JointAngles> angles = anglesOfPoses(*input.session, options.joints, robot);
  if (angles.empty()) {
    throw BadInput(options.input +
                   ": no pose has joint angles, by which --rotation links goes: give a table of them, --joints FILE");
  }
  LinksOptions links_options;
  setUp(options.up, links_options);
  for (const PatchToPlace& patch : task.patches) links_options.chosen[patch.origin] = options.link;
  links_options.validate();
  common.progress("Comparing with the robot ...");
  const LinksResult links = findLinks(*input.result, robot, angles, links_options);
  common.endProgress();
  for (const Message& finding : links.findings) common.note(finding.english());
  bool all_fit = true;
  for (PatchToPlace& patch : task.patches) {
    const auto found = std::ranges::find(links.patches, patch.origin, &PatchLinks::origin);
    if (found == links.patches.end()) {
      throw BadInput(options.input + ": the patch of cell " + std::to_string(patch.origin.value()) +
                     " saw gravity in no pose whose joint angles are known");
    }
    if (found->nearest) {
      common.note(found->why.english());
      all_fit = false;
    }
    if (!patch.rotation) patch.rotation = rotationByGravity(*found, options.link);
  }
  return all_fit;
}

// --- as text

double sigmaOfPosition(const Matrix6d& covariance) { return largestDeviation(covariance.topLeftCorner<3, 3>()); }
double sigmaOfRotation(const Matrix6d& covariance) { return largestDeviation(covariance.bottomRightCorner<3, 3>()); }

void printCandidate(const PlaceCandidate& candidate, std::size_t number) {
  std::cout << "Place " << number << (candidate.fits ? "" : " (does not fit)") << ": misfit "
            << millimetres(candidate.rms_m) << " rms, chi-squared " << formatFixed(candidate.chi_squared, 1) << " / "
            << candidate.freedom << '\n';
  for (const PlacedPatch& patch : candidate.patches) {
    const Matrix6d& covariance = *patch.place.cov_t_r;
    std::cout << "  cell " << patch.place.origin << " on " << forTerminal(patch.place.link) << ": at "
              << inWords(patch.place.T_l_o.t, 4, " ") << " m"
              << " +- " << millimetres(sigmaOfPosition(covariance), 1) << ", roll, pitch, yaw "
              << rollPitchYaw(patch.place.T_l_o.R, 2) << " +- " << degrees(sigmaOfRotation(covariance), 1) << '\n';
    for (const FreeDirection& free : patch.free) std::cout << "    " << forTerminal(free.words.english()) << '\n';
  }
}

// --- as JSON

Json rotationJson(const Eigen::Matrix3d& R) {
  return arrayOf(R.transpose().reshaped(), [](double x) { return x; });
}

constexpr EnumNames<FreeDirection::Kind> kFreeKinds = {{"slide", "turn", "screw"}};

Json freeJson(const FreeDirection& free) {
  return {{"kind", kFreeKinds.of(free.kind)},
          {"words", free.words.english()},
          {"axis", listOf(free.axis)},
          {"through_m", listOf(free.through_m)},
          {"shift_m", listOf(free.shift_m)},
          {"turn_rad", listOf(free.turn_rad)},
          {"sigma_mm", toMillimetres(free.sigma_m)},
          {"held_by_rotation", free.held_by_rotation},
          {"forward_mm", toMillimetres(free.forward_m)},
          {"backward_mm", toMillimetres(free.backward_m)},
          {"forward_deg", toDegrees(free.forward_rad)},
          {"backward_deg", toDegrees(free.backward_rad)},
          {"all_the_way", free.all_the_way}};
}

Json cellJson(const CellOnLink& cell) {
  return {{"id", cell.cell.value()},
          {"R", rotationJson(cell.T_l_u.R)},
          {"t_m", listOf(cell.T_l_u.t)},
          {"cov_t_r", upperTriangle(cell.cov_t_r)},
          {"above_mm", orNull(cell.above_m, toMillimetres)}};
}

Json patchJson(const PlacedPatch& patch) {
  return {{"origin_cell", patch.place.origin.value()},      {"link", patch.place.link},
          {"R", rotationJson(patch.place.T_l_o.R)},         {"t_m", listOf(patch.place.T_l_o.t)},
          {"cov_t_r", upperTriangle(*patch.place.cov_t_r)}, {"free", arrayOf(patch.free, freeJson)},
          {"cells", arrayOf(patch.cells, cellJson)}};
}

Json candidateJson(const PlaceCandidate& candidate) {
  return {{"fits", candidate.fits},
          {"chi_squared", candidate.chi_squared},
          {"freedom", candidate.freedom},
          {"probability", candidate.probability},
          {"rms_mm", toMillimetres(candidate.rms_m)},
          {"patches", arrayOf(candidate.patches, patchJson)}};
}

Json resultJson(const PlaceResult& result) {
  return {{"verdict", placeVerdictName(result.verdict)},
          {"summary", result.summary.english()},
          {"remarks", textsOf(result.remarks)},
          {"candidates", arrayOf(result.candidates, candidateJson)}};
}

PlaceTask taskFrom(const PlaceCommandOptions& options, const Reconstruction& r) {
  PlaceTask task;
  task.link = options.link;
  task.thickness_m = r.model->thickness_m;
  for (const std::string& text : options.points) task.points.push_back(pointFrom(text));
  for (const std::string& text : options.distances) task.distances.push_back(distanceFrom(text));
  for (const PatchReconstruction* patch : patchesToPlace(r, options, task)) {
    task.patches.push_back(patchToPlace(*patch));
  }
  if (task.patches.empty()) throw BadInput(options.input + ": holds no patch");
  for (const std::string& text : options.rotations) {
    if (text != kFromLinks) addRotation(r, text, task);
  }
  return task;
}

PlaceOptions placeOptionsFrom(const PlaceCommandOptions& options) {
  PlaceOptions place_options;
  place_options.surface_sigma_m = options.surface_sigma_mm * kMillimetre;
  place_options.normal_sigma_rad = options.normal_sigma_deg * kDegree;
  place_options.gap_m = options.gap_mm * kMillimetre;
  place_options.validate();
  return place_options;
}

int run(const PlaceCommandOptions& options, const Common& common) {
  std::optional<Output> output;
  if (!options.output.empty()) output.emplace(options.output, common);
  const bool by_links = wantsLinks(options);
  const PlaceOptions place_options = placeOptionsFrom(options);
  const SolvedInput input = solved(options.input, common);
  PlaceTask task = taskFrom(options, *input.result);
  const RobotModel robot = openRobot(options.robot, options.packages);
  const std::size_t link = robot.linkNamed(options.link);
  const bool fits_link = !by_links || takeRotationsOfLinks(options, input, robot, task, common);
  if (!options.no_surface) task.surface = surfaceOf(options, robot, link, common);
  common.progress("Looking for places ...");
  const PlaceResult result = placePatches(task, place_options);
  common.endProgress();

  if (common.json) {
    printJson(resultJson(result));
  } else {
    std::cout << forTerminal(result.summary.english()) << '\n';
    for (const Message& remark : result.remarks) std::cout << forTerminal(remark.english()) << '\n';
    for (std::size_t k = 0; k < result.candidates.size(); ++k) printCandidate(result.candidates[k], k + 1);
  }
  if (output) {
    if (result.candidates.empty() || !result.candidates.front().fits) {
      common.note(output->inWords() + " is not written: no place fits");
    } else {
      std::vector<PatchOnLink> placements;
      for (const PlacedPatch& patch : result.candidates.front().patches) placements.push_back(patch.place);
      output->write(placementsToJson(placements));
      if (!common.json) std::cout << "Place 1 is written to " << forTerminal(output->inWords()) << '\n';
    }
  }
  return result.verdict == PlaceVerdict::Placed && fits_link ? kDone : kNotGoodEnough;
}

}  // namespace

void addPlace(CLI::App& app, Common& common) {
  auto [command, options] = addCommand<PlaceCommandOptions>(
      app, common, "place", "Find where on a link of the robot a patch lies: by the link's surface, points, distances",
      "All places that fit are given, the best first, with what is left open and how far the patch can be moved.\n"
      "Exit code 1: no place fits, several do, or one from which the patch can be moved; or gravity says that\n"
      "the patch is on another link.\n"
      "Example:\n  hexoderm-cli place arm.calibration.json --robot robot.urdf --link r_forearm --rotation 0,90,12:1 "
      "-o placements.json\n"
      "  hexoderm-cli place arm.hexo --robot robot.urdf --link r_forearm --rotation links --joints joints.csv",
      run);
  addInput(command, "skin", options.input,
           "Calibration (*.calibration.json), or session (*.hexo or *.session.json), which says better how "
           "certain the cells are")
      ->required();
  addInput(command, "--robot", options.robot, "URDF of the robot; demo is the built-in arm")->required();
  command.add_option("--package", options.packages, "NAME=FOLDER: where the files of package://NAME/ are");
  command.add_option("--link", options.link, "Link that the patch is on")->required();
  takeWholeNumbers(
      command.add_option("--patch", options.patches,
                         "Cell whose patch is placed; several are placed together. Without it the patches of "
                         "distances and points, or the one with the most cells"));
  command.add_option("--rotation", options.rotations,
                     std::string(kRotationSyntax) +
                         ": how the patch is turned on the link, as rpy of a URDF, in degrees, and 1 sigma about each "
                         "axis (1). Or links: as gravity and the joint angles say, which takes a session. Without it "
                         "any");
  addInput(command, "--joints", options.joints,
           "With --rotation links: joint angles of the poses as CSV (default: those that the session holds)");
  takeDirection(
      command.add_option("--up", options.up, "With --rotation links: what points up in the frame of the base, x,y,z"));
  command.add_option("--point", options.points,
                     std::string(kPointSyntax) +
                         ": the middle of a cell's front is at this point of the link, m; sigma an axis, m (0.001)");
  command.add_option("--distance", options.distances,
                     std::string(kDistanceSyntax) +
                         ": between the middles of the fronts of cells of two patches on the link, m (sigma 0.001)");
  command.add_flag("--no-surface", options.no_surface, "Do without the link's surface");
  addWithDefault(command, "--body", options.body, "Which of the link's descriptions is its surface")
      ->check(CLI::IsMember({"any", "visual", "collision"}));
  takeNumbers(addWithDefault(command, "--surface-sigma", options.surface_sigma_mm,
                             "How far backs of cells are off the mesh, 1 sigma, mm"),
              toMillimetres(kMinPlaceSigma_m), toMillimetres(kMaxPlaceLength_m));
  takeNumbers(addWithDefault(command, "--normal-sigma", options.normal_sigma_deg,
                             "How far cells are tilted against it, 1 sigma, deg"),
              kMinAngleSigma_deg, kFullTurn_deg);
  takeNumbers(addWithDefault(command, "--gap", options.gap_mm, "Glue or cloth between the backs and the mesh, mm"), 0,
              toMillimetres(kMaxPlaceLength_m));
  addOutput(command, "-o,--output", options.output,
            "File for the best place, which export takes with --placements; - is standard output");
}

}  // namespace hexoderm::cli
