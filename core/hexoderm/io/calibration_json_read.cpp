#include "hexoderm/io/calibration_json_read.h"

#include "hexoderm/geometry/covariance.h"
#include "hexoderm/graph/cell_model_json.h"
#include "hexoderm/io/calibration_json.h"
#include "hexoderm/session/session_parts_json.h"
#include "hexoderm/util/error.h"
#include "hexoderm/util/file.h"
#include "hexoderm/util/limits.h"
#include "hexoderm/util/message_json.h"
#include "hexoderm/util/units.h"

#include <algorithm>
#include <cmath>
#include <set>
#include <unordered_map>
#include <utility>

namespace hexoderm {
namespace {

/// The value of an enumeration by its name in files; `expected` says which names there are.
template <class In, class FromName, class Expected>
auto named(In&& json, FromName from_name, Expected expected) {
  const auto value = from_name(json.string());
  if (!value) json.fail(expected());
  return *value;
}

std::optional<PlacedBy> placedByFromName(const std::string& name) {
  if (name == "samples") return PlacedBy::Samples;
  return name == "links" ? std::optional(PlacedBy::Links) : std::nullopt;
}

Message aFinding() { return message("the code of a finding"); }

/// Reads a name, with the complaint of its own parser.
template <class FromName>
auto option(const JsonReader& json, FromName from_name) {
  const std::string name = json.string();
  try {
    return from_name(name);
  } catch (const InvalidArgument& error) {
    json.fail(message("one of the solver's settings ({})", error.message()));
  }
}

template <class In>
double nonNegativeAngle(In&& json) {
  return json.nonNegativeNumber() * kDegree;
}

/// Take members in degrees into variables in radians.
auto intoAngle(double& angle_rad) {
  return [&](auto& in) { angle_rad = in.number() * kDegree; };
}
auto intoNonNegativeAngle(double& angle_rad) {
  return [&](auto& in) { angle_rad = nonNegativeAngle(in); };
}

template <class In>
Eigen::Vector3d nonNegativeVector(In& json) {
  const Eigen::Vector3d v = json.vector3();
  if ((v.array() < 0).any()) json.fail(message("three numbers of at least 0"));
  return v;
}

template <class Id>
std::vector<Id> readIds(const JsonReader& json) {
  std::vector<Id> ids;
  for (const JsonReader& item : json.items()) ids.emplace_back(item.unsignedInteger());
  return ids;
}

SolverOptions readOptions(const JsonReader& json) {
  SolverOptions options;
  if (const auto value = json.find("centre")) options.centring = option(*value, centringFromName);
  if (const auto value = json.find("support-axes")) options.support_axes = option(*value, supportAxesFromName);
  if (const auto value = json.find("weights")) options.weights = option(*value, linkWeightsFromName);
  if (const auto value = json.find("class-threshold")) options.class_threshold = value->positiveNumber();
  if (const auto value = json.find("max-bend-deg")) options.max_bend_rad = nonNegativeAngle(*value);
  if (const auto value = json.find("max-twist-deg")) options.max_twist_rad = nonNegativeAngle(*value);
  if (const auto value = json.find("max-yaw-deg")) options.max_yaw_rad = nonNegativeAngle(*value);
  if (const auto value = json.find("max-misfit")) options.max_misfit = value->positiveNumber();
  if (const auto value = json.find("max-opening")) options.max_opening = value->positiveNumber();
  if (const auto value = json.find("without")) options.left_out = readIds<CellId>(*value);
  try {
    options.validate();
  } catch (const InvalidArgument& error) {
    json.fail(message("settings that make sense ({})", error.message()));
  }
  return options;
}

/// The solver and its gap model stand above the options in the file. An imported file's gap model is nobody's option.
void readSolver(const JsonReader& json, Reconstruction& result) {
  const JsonReader name = json.at("solver");
  result.solver = name.string();
  const auto gap_model = json.find("gap_model");
  if (result.solver == "imported") {
    if (gap_model) static_cast<void>(gap_model->string());
    return;
  }
  if (result.solver != "global" && result.solver != "tree") name.fail(message("\"global\", \"tree\" or \"imported\""));
  result.options.solver = option(name, solverFromName);
  if (gap_model) result.options.gap_model = option(*gap_model, gapModelFromName);
}

SourceDescription readSource(const JsonReader& json) {
  SourceDescription source;
  if (const auto file = json.find("file")) source.file = file->string();
  if (const auto hash = json.find("sha256")) source.sha256 = hash->string();
  if (json.find("description")) source.text = readMessage(json, "description");
  return source;
}

PoseSummary readPose(const JsonReader& json) {
  PoseSummary pose;
  pose.pose = PoseId(json.at("id").unsignedInteger());
  if (json.find("label")) pose.label = readMessage(json, "label");
  if (const auto enabled = json.find("enabled")) pose.enabled = enabled->boolean();
  if (const auto cells = json.find("cells_measured")) pose.cells_measured = cells->unsignedInteger();
  if (const auto noise = json.find("noise_g")) pose.noise_g = noise->nonNegativeNumber();
  if (const auto value = json.find("new_by_deg")) pose.new_by_rad = nonNegativeAngle(*value);
  if (const auto residual = json.find("residual_deg")) pose.residual_rad = nonNegativeAngle(*residual);
  return pose;
}

/// Files of other programs need not have our table of poses; the gravity directions name the poses too.
std::vector<PoseSummary> posesOfGravity(const std::vector<PatchReconstruction>& patches) {
  std::vector<PoseSummary> poses;
  for (const PatchReconstruction& patch : patches) {
    for (const GravityDirection& gravity : patch.gravity) {
      if (std::ranges::find(poses, gravity.pose, &PoseSummary::pose) != poses.end()) continue;
      PoseSummary pose;
      pose.pose = gravity.pose;
      poses.push_back(pose);
    }
  }
  return poses;
}

template <class In>
Matrix6d readCovariance(In& json) {
  const Matrix6d cov_t_r = fromUpperTriangle<6>(json.template numbers<21>());
  if ((cov_t_r.diagonal().array() < 0).any()) {
    json.fail(message("an upper triangle with variances of at least 0 on its diagonal"));
  }
  if (!isCovariance(cov_t_r)) json.fail(message("a covariance (positive semidefinite)"));
  return cov_t_r;
}

template <class In>
SensorPlacement readSensor(In& json) {
  SensorPlacement sensor;
  json.object(member("name", into(sensor.name)), optionalMember("type", into(sensor.type)),
              member("q_o_wxyz", [&](auto& in) { sensor.T_o_s.R = in.unitQuaternion().toRotationMatrix(); }),
              member("t_o_m", [&](auto& in) { sensor.T_o_s.t = in.vector3(kMostLength_m); }));
  return sensor;
}

/// Version 1 has the whole path from the origin to the cell instead of its predecessor.
std::optional<CellId> predecessorOfPath(const JsonReader& json) {
  const auto path = json.find("path");
  if (!path) return std::nullopt;
  const std::vector<CellId> cells = readIds<CellId>(*path);
  if (!cells.empty() && cells.back() != CellId(json.at("id").unsignedInteger())) {
    path->fail(message("cells of this patch, from its origin to this cell"));
  }
  return cells.size() > 1 ? std::optional(cells[cells.size() - 2]) : std::nullopt;
}

template <class In>
CellPlacement readCell(In& json) {
  CellPlacement cell;
  std::optional<Eigen::Quaterniond> q;
  const auto placed_by = [&](auto& in) {
    cell.placed_by = named(in, placedByFromName, [] { return message("\"samples\" or \"links\""); });
  };
  const auto sensors = [&](auto& in) {
    in.eachItem([&](auto& sensor) { cell.sensors.push_back(readSensor(sensor)); });
  };
  json.object(
      member("id", into(cell.cell)), optionalMember("body_part", into(cell.body_part)), member("placed_by", placed_by),
      member("R_o_u", [&](auto& in) { cell.T_o_u.R = in.rotation(); }),
      optionalMember("q_o_u_wxyz", [&](auto& in) { q = in.unitQuaternion(); }),
      member("t_o_u_m", [&](auto& in) { cell.T_o_u.t = in.vector3(kMostLength_m); }),
      optionalMember("cov_t_r", [&](auto& in) { cell.cov_t_r = readCovariance(in); }),
      optionalMember("sigma_t_m", [](auto& in) { nonNegativeVector(in); }),
      optionalMember("sigma_r_rad", [](auto& in) { nonNegativeVector(in); }),
      optionalMember("shape_cov_t_r", [&](auto& in) { cell.shape_cov_t_r = readCovariance(in); }),
      optionalMember("accel_offset_g", [&](auto& in) { cell.accel_offset_g = in.vector3(kMostAcceleration_g); }),
      optionalMember("accel_scale", [&](auto& in) { cell.accel_scale = in.vector3(kMostAcceleration_g); }),
      optionalMember("predecessor", into(cell.predecessor)), member("sensors", sensors));
  if (q && rotationAngle(q->toRotationMatrix().transpose() * cell.T_o_u.R) > 1e-5) {
    json.failAt("q_o_u_wxyz", message("the same rotation as R_o_u"));
  }
  return cell;
}

/// With more members that the caller takes.
template <class In, class... More>
void readLink(In& json, LinkEstimate& link, More... more) {
  const auto quality = [&](auto& in) {
    link.quality = named(in, qualityFromName, [] { return message("\"un\", \"partially\", \"fully\" or \"over\""); });
  };
  json.object(member("source", into(link.source.cell)), member("source_port", into(link.source.port)),
              member("target", into(link.target.cell)), member("target_port", into(link.target.port)),
              member("R_c_n", [&](auto& in) { link.R_c_n = in.rotation(); }), member("quality", quality),
              member("singular_values", [&](auto& in) { link.singular_values = nonNegativeVector(in); }),
              member("weight", [&](auto& in) { link.weight = in.positiveNumber(); }),
              member("residual_deg", intoNonNegativeAngle(link.residual_rad)),
              member("sigma_deg", intoNonNegativeAngle(link.sigma_rad)), member("bend_deg", intoAngle(link.bend_rad)),
              member("twist_deg", intoAngle(link.twist_rad)), member("yaw_deg", intoAngle(link.yaw_rad)),
              member("used", into(link.used)),
              optionalMember("muted_by", [&](auto& in) { link.muted_by = named(in, codeFromName, aFinding); }),
              optionalMember("centred", into(link.centred)), optionalMember("supported", into(link.supported)),
              optionalMember("in_tree", into(link.in_tree)), more...);
  if (!(link.source < link.target) || link.source.cell == link.target.cell) {
    json.failAt("source", message("two cells, the smaller (ID, port) as source (target is {})", link.target.cell));
  }
}

/// Null where a link has none in a pose.
template <class In>
std::optional<double> readPoseResidual(In& json) {
  return json.isNull() ? std::nullopt : std::optional(nonNegativeAngle(json));
}

void readPoseResiduals(const JsonReader& json, std::size_t pose_count, LinkEstimate& link) {
  const auto residuals = json.find("pose_residual_deg");
  if (!residuals) {
    link.pose_residual_rad.assign(pose_count, std::nullopt);
    return;
  }
  const std::vector<JsonReader> items = residuals->items();
  if (items.size() != pose_count) residuals->fail(message("one entry for each of the {} poses", pose_count));
  for (const JsonReader& item : items) link.pose_residual_rad.push_back(readPoseResidual(item));
}

Finding readFinding(const JsonReader& json) {
  Finding finding;
  finding.code = named(json.at("code"), codeFromName, aFinding);
  finding.severity =
      named(json.at("severity"), severityFromName, [] { return message("\"info\", \"warning\" or \"error\""); });
  finding.message = readMessage(json, "text");
  finding.cells = readIds<CellId>(json.at("cells"));
  finding.ports = readIds<PortNumber>(json.at("ports"));
  finding.poses = readIds<PoseId>(json.at("poses"));
  return finding;
}

/// Older files state neither what limits the result nor what helps: one that can't be used wanted poses.
Assessment readVerdict(const JsonReader& json) {
  Assessment verdict;
  verdict.level = named(json.at("level"), verdictFromName,
                        [] { return message("\"good\", \"usable\", \"not_enough\" or \"failed\""); });
  verdict.reason = readMessage(json, "reason");
  if (const auto value = json.find("position_95_mm")) verdict.position_95_m = value->nonNegativeNumber() * kMillimetre;
  if (const auto value = json.find("orientation_95_deg")) verdict.orientation_95_rad = nonNegativeAngle(*value);
  verdict.next_action = readMessage(json, "next_action");
  if (const auto limit = json.find("limit"))
    verdict.limit = named(*limit, limitFromName, [] { return message("what limits a result"); });
  if (const auto cells = json.find("limiting_cells")) verdict.limiting_cells = readIds<CellId>(*cells);
  if (const auto poses = json.find("retake")) verdict.retake = readIds<PoseId>(*poses);
  if (const auto remedy = json.find("remedy")) {
    verdict.remedy = named(*remedy, remedyFromName, [] { return message("what helps a result"); });
  } else if (!verdict.isUsable()) {
    verdict.remedy = Remedy::TakePose;
  }
  return verdict;
}

/// Placements, each of a patch by its origin cell.
std::vector<PatchPlacement> readOrigins(const JsonReader& json, const Reconstruction& result) {
  std::vector<PatchPlacement> placements = readPlacements(json);
  const std::vector<JsonReader> items = json.items();
  for (std::size_t k = 0; k < items.size(); ++k) {
    const PatchReconstruction* patch = result.find(placements[k].origin).patch;
    if (patch == nullptr || patch->origin != placements[k].origin) {
      items[k].at("origin_cell").fail(message("the origin cell of a patch"));
    }
  }
  return placements;
}

std::optional<GapShareEstimate> readGapShare(const JsonReader& json) {
  const auto share = json.find("gap_s");
  if (!share) return std::nullopt;
  GapShareEstimate estimate{share->number(), 0};
  if (const auto sigma = json.find("gap_s_sigma")) estimate.sigma = sigma->nonNegativeNumber();
  return estimate;
}

GravityDirection readGravity(const JsonReader& json) {
  GravityDirection gravity;
  gravity.pose = PoseId(json.at("pose").unsignedInteger());
  gravity.g_o = json.at("g_o").vector3();
  if (std::abs(gravity.g_o.norm() - 1) > 1e-6) json.at("g_o").fail(message("a unit vector (to 1e-6)"));
  gravity.sigma_rad = nonNegativeAngle(json.at("sigma_deg"));
  return gravity;
}

/// A cell that has a predecessor, but whose predecessors don't lead to the origin, or that is the origin.
std::optional<std::size_t> cellWithoutWay(const PatchReconstruction& patch) {
  std::unordered_map<CellId, std::size_t> place;
  for (std::size_t k = 0; k < patch.cells.size(); ++k) place.emplace(patch.cells[k].cell, k);
  std::vector<bool> reaches(patch.cells.size(), false);
  reaches[place.at(patch.origin)] = true;
  std::vector<std::size_t> way;
  for (std::size_t k = 0; k < patch.cells.size(); ++k) {
    if (!patch.cells[k].predecessor) continue;
    if (patch.cells[k].cell == patch.origin) return k;
    way.clear();
    for (std::size_t at = k; !reaches[at];) {
      const auto& predecessor = patch.cells[at].predecessor;
      const auto before = predecessor ? place.find(*predecessor) : place.end();
      if (before == place.end() || way.size() >= patch.cells.size()) return k;
      way.push_back(at);
      at = before->second;
    }
    for (const std::size_t cell : way) reaches[cell] = true;
  }
  return std::nullopt;
}

/// From the format to the cell model.
void readHead(const JsonReader& json, Reconstruction& result) {
  json.requireFormat(kCalibrationFormat, kCalibrationVersion);
  if (const auto options = json.find("options")) result.options = readOptions(*options);
  readSolver(json, result);
  if (const auto share = json.find("gap_s")) static_cast<void>(share->number());  // the patches have their own
  if (const auto source = json.find("source")) result.source = readSource(*source);
  result.model = std::make_shared<const CellModel>(readCellModel(json.at("cell_model")));
}

/// The table of poses, for patches that are there.
std::vector<PoseSummary> readPoseTable(const JsonReader& json, const std::vector<PatchReconstruction>& patches) {
  const auto table = json.find("poses");
  if (!table) return posesOfGravity(patches);
  std::vector<PoseSummary> poses;
  for (const JsonReader& pose : table->items()) poses.push_back(readPose(pose));
  return poses;
}

/// From the findings to the placements, and the layout.
void readTail(const JsonReader& json, Reconstruction& result) {
  for (const JsonReader& finding : json.at("findings").items()) result.findings.push_back(readFinding(finding));
  result.assessment = readVerdict(json.at("verdict"));
  if (const auto robot = json.find("robot")) result.robot = readRobot(*robot);
  if (const auto placements = json.find("placements")) result.placements = readOrigins(*placements, result);
  result.layout = computeFlatLayout(*result.model, result.patches);
}

/// Reads the patches and sees to it that what views and exporters look up is there.
class PatchReader {
 public:
  PatchReader(const CellModel& model, const JsonReader& patches) : model_(model), items_(patches.items()) {}

  std::vector<PatchReconstruction> read() {
    for (const JsonReader& item : items_) patches_.push_back(readPatch(item));
    for (std::size_t k = 0; k < patches_.size(); ++k) checkReferences(items_[k], patches_[k]);
    return std::move(patches_);
  }

 private:
  PatchReconstruction readPatch(const JsonReader& json) {
    PatchReconstruction patch;
    patch.id = PatchId(json.at("id").unsignedInteger());
    if (!patch_ids_.insert(patch.id).second) json.at("id").fail(message("each patch once"));
    patch.origin = CellId(json.at("origin").unsignedInteger());
    patch.gap_share = readGapShare(json);
    for (const JsonReader& item : json.at("gravity").items()) patch.gravity.push_back(readGravity(item));
    for (const JsonReader& item : json.at("cells").items()) {
      patch.cells.push_back(readCell(item));
      CellPlacement& cell = patch.cells.back();
      if (!cell.predecessor) cell.predecessor = predecessorOfPath(item);
      if (!patch_of_.try_emplace(cell.cell, patch.id).second) item.at("id").fail(message("each cell once"));
    }
    if (!isIn(patch.origin, patch)) json.at("origin").fail(message("a cell of this patch"));
    for (const JsonReader& item : json.at("links").items()) {
      LinkEstimate& link = patch.links.emplace_back();
      readLink(item, link);
      requirePort(item, "source_port", link.source.port);
      requirePort(item, "target_port", link.target.port);
      if (!isIn(link.source.cell, patch)) item.at("source").fail(message("a cell of this patch"));
      if (!link_ends_.insert({link.source, link.target}).second) item.fail(message("each link once"));
    }
    return patch;
  }

  void requirePort(const JsonReader& link, const char* key, PortNumber port) const {
    if (model_.findPort(port) == nullptr) link.failAt(key, message("a port of cell model {}", model_.name));
  }

  /// Checks references to cells of patches that may come later in the file.
  void checkReferences(const JsonReader& json, PatchReconstruction& patch) const {
    const std::vector<JsonReader> links = json.at("links").items();
    for (std::size_t k = 0; k < links.size(); ++k) {
      if (!patch_of_.contains(patch.links[k].target.cell))
        links[k].at("target").fail(message("a cell of this calibration"));
    }
    if (const auto stray = cellWithoutWay(patch)) {
      const JsonReader cell = json.at("cells").items()[*stray];
      if (const auto path = cell.find("path")) path->fail(message("cells of this patch, from its origin to this cell"));
      cell.at("predecessor").fail(message("a cell of this patch on a path from its origin, which has none itself"));
    }
    std::ranges::sort(patch.cells, {}, &CellPlacement::cell);
  }

  [[nodiscard]] bool isIn(CellId cell, const PatchReconstruction& patch) const {
    const auto found = patch_of_.find(cell);
    return found != patch_of_.end() && found->second == patch.id;
  }

  const CellModel& model_;
  std::vector<JsonReader> items_;
  std::vector<PatchReconstruction> patches_;
  std::set<PatchId> patch_ids_;
  std::unordered_map<CellId, PatchId> patch_of_;
  std::set<std::pair<LinkEnd, LinkEnd>> link_ends_;
};

// --- without a document of cells and links

void requireUsual(bool is_usual) {
  if (!is_usual) throw JsonScanner::Unusual();
}

PatchReconstruction scanPatch(JsonScanner& json, const std::string& file) {
  PatchReconstruction patch;
  const auto cells = [&](auto& items) {
    items.eachItem([&](auto& item) { patch.cells.push_back(readCell(item)); });
    patch.cells.shrink_to_fit();
  };
  const auto links = [&](auto& items) {
    items.eachItem([&](auto& item) {
      LinkEstimate& link = patch.links.emplace_back();
      readLink(item, link, member("pose_residual_deg", [&](auto& residuals) {
                 residuals.eachItem([&](auto& in) { link.pose_residual_rad.push_back(readPoseResidual(in)); });
               }));
    });
    patch.links.shrink_to_fit();
  };
  nlohmann::json rest = nlohmann::json::object();
  json.objectWith([&](std::string_view key) { json.keep(key, rest); }, member("cells", cells), member("links", links));
  const JsonReader reader(rest, file);
  patch.id = PatchId(reader.at("id").unsignedInteger());
  patch.origin = CellId(reader.at("origin").unsignedInteger());
  patch.gap_share = readGapShare(reader);
  for (const JsonReader& item : reader.at("gravity").items()) patch.gravity.push_back(readGravity(item));
  return patch;
}

/// What PatchReader sees to, without the words.
void requireReferences(Reconstruction& result) {
  std::set<PatchId> patch_ids;
  std::unordered_map<CellId, PatchId> patch_of;
  patch_of.reserve(result.cellCount());
  std::vector<std::pair<LinkEnd, LinkEnd>> ends;
  ends.reserve(result.linkCount());
  for (const PatchReconstruction& patch : result.patches) {
    requireUsual(patch_ids.insert(patch.id).second);
    for (const CellPlacement& cell : patch.cells) requireUsual(patch_of.try_emplace(cell.cell, patch.id).second);
    const auto is_here = [&](CellId cell) {
      const auto found = patch_of.find(cell);
      return found != patch_of.end() && found->second == patch.id;
    };
    requireUsual(is_here(patch.origin));
    for (const LinkEstimate& link : patch.links) {
      requireUsual(is_here(link.source.cell));
      ends.emplace_back(link.source, link.target);
    }
  }
  std::ranges::sort(ends);
  requireUsual(std::ranges::adjacent_find(ends) == ends.end());
  for (const auto& [source, target] : ends) {
    requireUsual(patch_of.contains(target.cell));
    requireUsual(result.model->findPort(source.port) != nullptr && result.model->findPort(target.port) != nullptr);
  }
  for (PatchReconstruction& patch : result.patches) {
    requireUsual(!cellWithoutWay(patch));
    std::ranges::sort(patch.cells, {}, &CellPlacement::cell);
  }
}

Reconstruction scanCalibration(JsonScanner& json, const std::string& file) {
  Reconstruction result;
  const auto patches = [&](auto& items) {
    items.eachItem([&](auto& item) { result.patches.push_back(scanPatch(item, file)); });
  };
  nlohmann::json rest = nlohmann::json::object();
  json.objectWith([&](std::string_view key) { json.keep(key, rest); }, member("patches", patches));
  json.finish();
  const JsonReader reader(rest, file);
  readHead(reader, result);
  requireReferences(result);
  result.poses = readPoseTable(reader, result.patches);
  for (const PatchReconstruction& patch : result.patches) {
    for (const LinkEstimate& link : patch.links) requireUsual(link.pose_residual_rad.size() == result.poses.size());
  }
  readTail(reader, result);
  return result;
}

}  // namespace

std::shared_ptr<const Reconstruction> scanCalibrationJson(std::string_view text, const std::string& file) {
  try {
    JsonScanner json(text);
    return std::make_shared<const Reconstruction>(scanCalibration(json, file));
  } catch (const JsonScanner::Unusual&) {
    return nullptr;
  } catch (const Error&) {
    return nullptr;  // the thorough reader says it with its place
  }
}

std::shared_ptr<const Reconstruction> calibrationFromDocument(std::string_view text, const std::string& file) {
  const nlohmann::json document = parseJson(text, file);
  const JsonReader json(document, file);
  Reconstruction result;
  readHead(json, result);
  const JsonReader patches = json.at("patches");
  result.patches = PatchReader(*result.model, patches).read();
  result.poses = readPoseTable(json, result.patches);
  const std::vector<JsonReader> patch_items = patches.items();
  for (std::size_t p = 0; p < patch_items.size(); ++p) {
    const std::vector<JsonReader> links = patch_items[p].at("links").items();
    for (std::size_t k = 0; k < links.size(); ++k) {
      readPoseResiduals(links[k], result.poses.size(), result.patches[p].links[k]);
    }
  }
  readTail(json, result);
  return std::make_shared<const Reconstruction>(std::move(result));
}

std::shared_ptr<const Reconstruction> parseCalibrationJson(std::string_view text, const std::string& file) {
  if (auto calibration = scanCalibrationJson(text, file)) return calibration;
  return calibrationFromDocument(text, file);
}

std::shared_ptr<const Reconstruction> readCalibrationJson(const std::filesystem::path& path) {
  return parseCalibrationJson(readFile(path, kMostSkinBytes), path.string());
}

}  // namespace hexoderm
