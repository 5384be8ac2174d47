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

namespace hexoderm {
namespace {

/// The value of an enumeration by its name in files.
template <class FromName>
auto named(const JsonReader& json, FromName from_name, const Message& expected) {
  const auto value = from_name(json.string());
  if (!value) json.fail(expected);
  return *value;
}

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

double angle(const JsonReader& json) { return json.number() * kDegree; }
double nonNegativeAngle(const JsonReader& json) { return json.nonNegativeNumber() * kDegree; }

Eigen::Vector3d nonNegativeVector(const JsonReader& json) {
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

Matrix6d readCovariance(const JsonReader& json) {
  const std::vector<double> values = json.numbers(21);
  Matrix6d cov_t_r;
  std::size_t next = 0;
  for (int row = 0; row < 6; ++row) {
    if (values[next] < 0) json.fail(message("an upper triangle with variances of at least 0 on its diagonal"));
    for (int col = row; col < 6; ++col) cov_t_r(row, col) = cov_t_r(col, row) = values[next++];
  }
  if (!isCovariance(cov_t_r)) json.fail(message("a covariance (positive semidefinite)"));
  return cov_t_r;
}

SensorPlacement readSensor(const JsonReader& json) {
  SensorPlacement sensor;
  sensor.name = json.at("name").string();
  if (const auto type = json.find("type")) sensor.type = type->string();
  sensor.T_o_s = {json.at("q_o_wxyz").unitQuaternion().toRotationMatrix(), json.at("t_o_m").vector3(kMostLength_m)};
  return sensor;
}

/// Version 1 has the whole path from the origin to the cell instead.
std::optional<CellId> readPredecessor(const JsonReader& json) {
  if (const auto predecessor = json.find("predecessor")) return CellId(predecessor->unsignedInteger());
  const auto path = json.find("path");
  if (!path) return std::nullopt;
  const std::vector<CellId> cells = readIds<CellId>(*path);
  if (!cells.empty() && cells.back() != CellId(json.at("id").unsignedInteger())) {
    path->fail(message("cells of this patch, from its origin to this cell"));
  }
  return cells.size() > 1 ? std::optional(cells[cells.size() - 2]) : std::nullopt;
}

CellPlacement readCell(const JsonReader& json) {
  CellPlacement cell;
  cell.cell = CellId(json.at("id").unsignedInteger());
  if (const auto part = json.find("body_part")) cell.body_part = part->string();
  const std::string placed_by = json.at("placed_by").string();
  if (placed_by != "samples" && placed_by != "links") json.at("placed_by").fail(message("\"samples\" or \"links\""));
  cell.placed_by = placed_by == "samples" ? PlacedBy::Samples : PlacedBy::Links;
  cell.T_o_u = {json.at("R_o_u").rotation(), json.at("t_o_u_m").vector3(kMostLength_m)};
  if (const auto q = json.find("q_o_u_wxyz")) {
    if (rotationAngle(q->unitQuaternion().toRotationMatrix().transpose() * cell.T_o_u.R) > 1e-5) {
      q->fail(message("the same rotation as R_o_u"));
    }
  }
  if (const auto cov = json.find("cov_t_r")) cell.cov_t_r = readCovariance(*cov);
  if (const auto cov = json.find("shape_cov_t_r")) cell.shape_cov_t_r = readCovariance(*cov);
  if (const auto sigma = json.find("sigma_t_m")) static_cast<void>(nonNegativeVector(*sigma));
  if (const auto sigma = json.find("sigma_r_rad")) static_cast<void>(nonNegativeVector(*sigma));
  if (const auto offset = json.find("accel_offset_g")) cell.accel_offset_g = offset->vector3(kMostAcceleration_g);
  if (const auto scale = json.find("accel_scale")) cell.accel_scale = scale->vector3(kMostAcceleration_g);
  cell.predecessor = readPredecessor(json);
  for (const JsonReader& sensor : json.at("sensors").items()) cell.sensors.push_back(readSensor(sensor));
  return cell;
}

LinkEnd readEnd(const JsonReader& json, const std::string& key, const CellModel& model) {
  const LinkEnd end{CellId(json.at(key).unsignedInteger()), PortNumber(json.at(key + "_port").unsignedInteger())};
  if (model.findPort(end.port) == nullptr) json.at(key + "_port").fail(message("a port of cell model {}", model.name));
  return end;
}

LinkEstimate readLink(const JsonReader& json, const CellModel& model) {
  LinkEstimate link;
  link.source = readEnd(json, "source", model);
  link.target = readEnd(json, "target", model);
  if (!(link.source < link.target) || link.source.cell == link.target.cell) {
    json.at("source").fail(message("two cells, the smaller (ID, port) as source (target is {})", link.target.cell));
  }
  link.R_c_n = json.at("R_c_n").rotation();
  link.quality = named(json.at("quality"), qualityFromName, message("\"un\", \"partially\", \"fully\" or \"over\""));
  link.singular_values = nonNegativeVector(json.at("singular_values"));
  link.weight = json.at("weight").positiveNumber();
  link.residual_rad = nonNegativeAngle(json.at("residual_deg"));
  link.sigma_rad = nonNegativeAngle(json.at("sigma_deg"));
  link.bend_rad = angle(json.at("bend_deg"));
  link.twist_rad = angle(json.at("twist_deg"));
  link.yaw_rad = angle(json.at("yaw_deg"));
  link.used = json.at("used").boolean();
  if (const auto code = json.find("muted_by"))
    link.muted_by = named(*code, codeFromName, message("the code of a finding"));
  if (const auto value = json.find("centred")) link.centred = value->boolean();
  if (const auto value = json.find("supported")) link.supported = value->boolean();
  if (const auto value = json.find("in_tree")) link.in_tree = value->boolean();
  return link;
}

void readPoseResiduals(const JsonReader& json, std::size_t pose_count, LinkEstimate& link) {
  const auto residuals = json.find("pose_residual_deg");
  if (!residuals) {
    link.pose_residual_rad.assign(pose_count, std::nullopt);
    return;
  }
  const std::vector<JsonReader> items = residuals->items();
  if (items.size() != pose_count) residuals->fail(message("one entry for each of the {} poses", pose_count));
  for (const JsonReader& item : items) {
    link.pose_residual_rad.push_back(item.isNull() ? std::nullopt : std::optional(nonNegativeAngle(item)));
  }
}

Finding readFinding(const JsonReader& json) {
  Finding finding;
  finding.code = named(json.at("code"), codeFromName, message("the code of a finding"));
  finding.severity = named(json.at("severity"), severityFromName, message("\"info\", \"warning\" or \"error\""));
  finding.message = readMessage(json, "text");
  finding.cells = readIds<CellId>(json.at("cells"));
  finding.ports = readIds<PortNumber>(json.at("ports"));
  finding.poses = readIds<PoseId>(json.at("poses"));
  return finding;
}

/// Older files state neither what limits the result nor what helps: one that can't be used wanted poses.
Assessment readVerdict(const JsonReader& json) {
  Assessment verdict;
  verdict.level =
      named(json.at("level"), verdictFromName, message("\"good\", \"usable\", \"not_enough\" or \"failed\""));
  verdict.reason = readMessage(json, "reason");
  if (const auto value = json.find("position_95_mm")) verdict.position_95_m = value->nonNegativeNumber() * kMillimetre;
  if (const auto value = json.find("orientation_95_deg")) verdict.orientation_95_rad = nonNegativeAngle(*value);
  verdict.next_action = readMessage(json, "next_action");
  if (const auto limit = json.find("limit"))
    verdict.limit = named(*limit, limitFromName, message("what limits a result"));
  if (const auto cells = json.find("limiting_cells")) verdict.limiting_cells = readIds<CellId>(*cells);
  if (const auto poses = json.find("retake")) verdict.retake = readIds<PoseId>(*poses);
  if (const auto remedy = json.find("remedy")) {
    verdict.remedy = named(*remedy, remedyFromName, message("what helps a result"));
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
      if (!patch_of_.try_emplace(patch.cells.back().cell, patch.id).second)
        item.at("id").fail(message("each cell once"));
    }
    if (!isIn(patch.origin, patch)) json.at("origin").fail(message("a cell of this patch"));
    for (const JsonReader& item : json.at("links").items()) {
      patch.links.push_back(readLink(item, model_));
      const LinkEstimate& link = patch.links.back();
      if (!isIn(link.source.cell, patch)) item.at("source").fail(message("a cell of this patch"));
      if (!link_ends_.insert({link.source, link.target}).second) item.fail(message("each link once"));
    }
    return patch;
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

}  // namespace

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

void readCalibrationHead(const JsonReader& json, Reconstruction& result) {
  json.requireFormat(kCalibrationFormat, kCalibrationVersion);
  if (const auto options = json.find("options")) result.options = readOptions(*options);
  readSolver(json, result);
  if (const auto share = json.find("gap_s")) static_cast<void>(share->number());  // the patches have their own
  if (const auto source = json.find("source")) result.source = readSource(*source);
  result.model = std::make_shared<const CellModel>(readCellModel(json.at("cell_model")));
}

std::vector<PoseSummary> readPoseTable(const JsonReader& json, const std::vector<PatchReconstruction>& patches) {
  const auto table = json.find("poses");
  if (!table) return posesOfGravity(patches);
  std::vector<PoseSummary> poses;
  for (const JsonReader& pose : table->items()) poses.push_back(readPose(pose));
  return poses;
}

void readCalibrationTail(const JsonReader& json, Reconstruction& result) {
  for (const JsonReader& finding : json.at("findings").items()) result.findings.push_back(readFinding(finding));
  result.assessment = readVerdict(json.at("verdict"));
  if (const auto robot = json.find("robot")) result.robot = readRobot(*robot);
  if (const auto placements = json.find("placements")) result.placements = readOrigins(*placements, result);
  result.layout = computeFlatLayout(*result.model, result.patches);
}

std::shared_ptr<const Reconstruction> calibrationFromDocument(std::string_view text, const std::string& file) {
  const nlohmann::json document = parseJson(text, file);
  const JsonReader json(document, file);
  Reconstruction result;
  readCalibrationHead(json, result);
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
  readCalibrationTail(json, result);
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
