#include "hexoderm/io/calibration_json.h"

#include "hexoderm/base/enum_names.h"
#include "hexoderm/base/error.h"
#include "hexoderm/base/file.h"
#include "hexoderm/base/units.h"
#include "hexoderm/session/session_parts_json.h"
#include "hexoderm/skin/cell_model_json.h"

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>
#include <set>
#include <unordered_map>
#include <utility>

namespace hexoderm {
namespace {

constexpr InUnit kAngle{kDegree};
constexpr InUnit kSignedAngle{kDegree, true};

constexpr EnumNames<PlacedBy> kPlacedBy = {{"samples", "links"}};
constexpr Named kPlacedByName{[](PlacedBy by) { return kPlacedBy.of(by); },
                              [](const std::string& name) { return kPlacedBy.find(name); },
                              [] { return message("\"samples\" or \"links\""); }};
constexpr Named kQualityName{qualityName, qualityFromName,
                             [] { return message("\"un\", \"partially\", \"fully\" or \"over\""); }};
constexpr Named kFindingName{codeName, codeFromName, [] { return message("the code of a finding"); }};

/// Of the solver's settings by its name, with the complaint of its own parser.
template <class NameOf, class FromName>
struct Setting {
  NameOf name_of;
  FromName from_name;
  template <class Value>
  void take(const JsonReader& in, Value& value) const {
    const std::string name = in.string();
    try {
      value = from_name(name);
    } catch (const InvalidArgument& error) {
      in.fail(message("one of the solver's settings ({})", error.message()));
    }
  }
  template <class Value>
  void put(JsonWriter& out, const Value& value) const {
    out.value(name_of(value));
  }
};
template <class NameOf, class FromName>
Setting(NameOf, FromName) -> Setting<NameOf, FromName>;

template <class Json, class Options>
void optionFields(Json& json, Options& options) {
  std::optional<Goal> goal;
  if (options.goal != Goal()) goal = options.goal;
  const auto goalFields = [](auto& item, auto& of_options) {
    item.object(requiredField("mm", of_options.position_m, InUnit{kMillimetre}),
                requiredField("deg", of_options.orientation_rad, kAngle));
  };
  json.object(defaultedField("centre", options.centring, Setting{centringName, centringFromName}),
              defaultedField("support-axes", options.support_axes, Setting{supportAxesName, supportAxesFromName}),
              defaultedField("weights", options.weights, Setting{linkWeightsName, linkWeightsFromName}),
              defaultedField("class-threshold", options.class_threshold, kPositive),
              defaultedField("max-bend-deg", options.max_bend_rad, kAngle),
              defaultedField("max-twist-deg", options.max_twist_rad, kAngle),
              defaultedField("max-yaw-deg", options.max_yaw_rad, kAngle),
              defaultedField("max-misfit", options.max_misfit, kPositive),
              defaultedField("max-opening", options.max_opening, kPositive),
              optionalField("goal", goal, Described{goalFields}), optionalField("without", options.left_out));
  if constexpr (kIsRead<Json>) options.goal = goal.value_or(Goal());
}

template <class Json, class Source>
void sourceFields(Json& json, Source& source) {
  json.object(defaultedField("file", source.file), defaultedField("sha256", source.sha256),
              optionalMessage("description", source.text));
}

template <class Json, class Pose>
void poseFields(Json& json, Pose& pose) {
  json.object(
      requiredField("id", pose.pose), optionalMessage("label", pose.label), defaultedField("enabled", pose.enabled),
      defaultedField("cells_measured", pose.cells_measured), defaultedField("noise_g", pose.noise_g, kNonNegative),
      optionalField("new_by_deg", pose.new_by_rad, kAngle), optionalField("residual_deg", pose.residual_rad, kAngle));
}

template <class Json, class Cell>
void cellFields(Json& json, Cell& cell) {
  const auto sensor = [](auto& item, auto& on_cell) {
    item.object(requiredField("name", on_cell.name), defaultedField("type", on_cell.type),
                requiredField("t_o_m", on_cell.T_o_s.t, vectorWithin(kMaxLength_m)),
                requiredField("q_o_wxyz", on_cell.T_o_s.R, AsQuaternion()));
  };
  std::optional<Eigen::Quaterniond> q;
  const auto quaternion = [&] { return std::optional(quaternionWxyz(cell.T_o_u.R)); };
  const auto sigma = [&](Eigen::Index from) -> std::optional<Eigen::Vector3d> {
    if (!cell.cov_t_r) return std::nullopt;
    return Eigen::Vector3d(cell.cov_t_r->diagonal().segment(from, 3).cwiseMax(0).cwiseSqrt());
  };
  const auto look_at_sigma = [](const JsonReader& in) {
    Eigen::Vector3d ignored;
    kNonNegativeVector.take(in, ignored);
  };
  json.object(
      requiredField("id", cell.cell), optionalField("body_part", cell.body_part),
      requiredField("placed_by", cell.placed_by, kPlacedByName), requiredField("R_o_u", cell.T_o_u.R, kRotation),
      derivedField("q_o_u_wxyz", quaternion, [&](const JsonReader& in) { q = in.unitQuaternion(); }),
      requiredField("t_o_u_m", cell.T_o_u.t, vectorWithin(kMaxLength_m)),
      optionalField("cov_t_r", cell.cov_t_r, AsCovariance()),
      derivedField(
          "sigma_t_m", [&] { return sigma(0); }, look_at_sigma),
      derivedField(
          "sigma_r_rad", [&] { return sigma(3); }, look_at_sigma),
      optionalField("shape_cov_t_r", cell.shape_cov_t_r, AsCovariance()),
      optionalField("accel_offset_g", cell.accel_offset_g, vectorWithin(kMaxAcceleration_g)),
      optionalField("accel_scale", cell.accel_scale, vectorWithin(kMaxAcceleration_g)),
      optionalField("predecessor", cell.predecessor), requiredField("sensors", cell.sensors, Described{sensor}));
  if constexpr (kIsRead<Json>) {
    const bool is_same = !q || rotationAngle(q->toRotationMatrix().transpose() * cell.T_o_u.R) <= 1e-5;
    if (!is_same) json.failAt("q_o_u_wxyz", message("the same rotation as R_o_u"));
  }
}

/// An entry for each pose, null where a link has no residual in it.
struct AsResiduals {
  using Residuals = std::vector<std::optional<double>>;
  void take(const JsonReader& in, Residuals& residuals_rad) const {
    for (const JsonReader& item : in.items()) {
      std::optional<double>& residual_rad = residuals_rad.emplace_back();
      if (!item.isNull()) kAngle.take(item, residual_rad.emplace());
    }
  }
  void put(JsonWriter& out, const Residuals& residuals_rad) const {
    out.array(residuals_rad, [&](const std::optional<double>& residual_rad) {
      residual_rad ? kAngle.put(out, *residual_rad) : out.null();
    });
  }
};

template <class Json, class Link>
void linkFields(Json& json, Link& link) {
  json.object(requiredField("source", link.source.cell), requiredField("source_port", link.source.port),
              requiredField("target", link.target.cell), requiredField("target_port", link.target.port),
              requiredField("R_c_n", link.R_c_n, kRotation), requiredField("quality", link.quality, kQualityName),
              requiredField("singular_values", link.singular_values, kNonNegativeVector),
              requiredField("weight", link.weight, kPositive), requiredField("residual_deg", link.residual_rad, kAngle),
              requiredField("sigma_deg", link.sigma_rad, kAngle),
              requiredField("bend_deg", link.bend_rad, kSignedAngle),
              requiredField("twist_deg", link.twist_rad, kSignedAngle),
              requiredField("yaw_deg", link.yaw_rad, kSignedAngle), requiredField("used", link.used),
              optionalField("muted_by", link.muted_by, kFindingName), defaultedField("centred", link.centred),
              defaultedField("supported", link.supported), defaultedField("in_tree", link.in_tree),
              defaultedField("pose_residual_deg", link.pose_residual_rad, AsResiduals()));
  if constexpr (kIsRead<Json>) {
    if (link.source < link.target && link.source.cell != link.target.cell) return;
    json.failAt("source", message("two cells, the smaller (ID, port) as source (target is {})", link.target.cell));
  }
}

template <class Json, class Gravity>
void gravityFields(Json& json, Gravity& gravity) {
  json.object(requiredField("pose", gravity.pose), requiredField("g_o", gravity.g_o),
              requiredField("sigma_deg", gravity.sigma_rad, kAngle));
  if constexpr (kIsRead<Json>) {
    if (std::abs(gravity.g_o.norm() - 1) > 1e-6) json.failAt("g_o", message("a unit vector (to 1e-6)"));
  }
}

template <class Json, class Lot>
void lotFields(Json& json, Lot& lot) {
  json.object(requiredField("offset_g", lot.offset_g, vectorWithin(kMaxAcceleration_g)),
              requiredField("offset_sigma_g", lot.offset_sigma_g, kNonNegativeVector),
              requiredField("scale", lot.scale, kPositive),
              requiredField("scale_sigma", lot.scale_sigma, kNonNegative));
}

template <class Json, class Patch>
void patchFields(Json& json, Patch& patch) {
  const auto gravity = [](auto& item, auto& in_pose) { gravityFields(item, in_pose); };
  const auto cell = [](auto& item, auto& of_patch) { cellFields(item, of_patch); };
  const auto link = [](auto& item, auto& of_patch) { linkFields(item, of_patch); };
  const auto lot = [](auto& item, auto& of_patch) { lotFields(item, of_patch); };
  std::optional<double> share;
  std::optional<double> sigma;
  if (patch.gap_share) {
    share = patch.gap_share->share;
    sigma = patch.gap_share->sigma;
  }
  json.object(requiredField("id", patch.id), requiredField("origin", patch.origin), optionalField("gap_s", share),
              optionalField("gap_s_sigma", sigma, kNonNegative), optionalField("lot", patch.lot, Described{lot}),
              requiredField("gravity", patch.gravity, Described{gravity}),
              requiredField("cells", patch.cells, Described{cell}),
              requiredField("links", patch.links, Described{link}));
  if constexpr (kIsRead<Json>) {
    if (share) patch.gap_share = GapShareEstimate{*share, sigma.value_or(0)};
  }
}

template <class Json, class Found>
void findingFields(Json& json, Found& finding) {
  const Named severity{severityName, severityFromName, [] { return message("\"info\", \"warning\" or \"error\""); }};
  json.object(requiredField("code", finding.code, kFindingName), requiredField("severity", finding.severity, severity),
              requiredMessage("text", finding.message), requiredField("cells", finding.cells),
              requiredField("ports", finding.ports), requiredField("poses", finding.poses));
}

template <class Json, class Verdict>
void verdictFields(Json& json, Verdict& verdict) {
  const Named level{verdictName, verdictFromName, [] {
                      return message("\"good\", \"usable\", \"coarse\", \"not_enough\", \"not_trusted\" or \"failed\"");
                    }};
  const Named limit{limitName, limitFromName, [] { return message("what limits a result"); }};
  const Named remedy{remedyName, remedyFromName, [] { return message("what helps a result"); }};
  json.object(requiredField("level", verdict.level, level), requiredMessage("reason", verdict.reason),
              defaultedField("position_95_mm", verdict.position_95_m, InUnit{kMillimetre}),
              defaultedField("orientation_95_deg", verdict.orientation_95_rad, kAngle),
              defaultedField("limit", verdict.limit, limit), defaultedField("limiting_cells", verdict.limiting_cells),
              defaultedField("remedy", verdict.remedy, remedy), defaultedField("retake", verdict.retake),
              requiredMessage("next_action", verdict.next_action));
}

/// Older files state neither what limits the result nor what helps: one that can't be used wanted poses.
Assessment readVerdict(const JsonReader& json) {
  Assessment verdict;
  verdictFields(json, verdict);
  if (!json.find("remedy") && !verdict.isUsable()) verdict.remedy = Remedy::TakePose;
  return verdict;
}

SolverOptions readOptions(const JsonReader& json) {
  SolverOptions options;
  optionFields(json, options);
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
  Setting{solverName, solverFromName}.take(name, result.options.solver);
  if (gap_model) Setting{gapModelName, gapModelFromName}.take(*gap_model, result.options.gap_model);
}

/// Files of other programs need not have our table of poses; the gravity directions name the poses too.
std::vector<PoseSummary> posesOfGravity(const std::vector<PatchReconstruction>& patches) {
  std::vector<PoseSummary> poses;
  for (const PatchReconstruction& patch : patches) {
    for (const GravityDirection& gravity : patch.gravity) {
      if (std::ranges::find(poses, gravity.pose, &PoseSummary::pose) != poses.end()) continue;
      poses.emplace_back().pose = gravity.pose;
    }
  }
  return poses;
}

[[noreturn]] void refusePath(const JsonReader& path) {
  path.fail(message("cells of this patch, from its origin to this cell"));
}

/// Version 1 has the whole path from the origin to the cell instead of its predecessor.
std::optional<CellId> predecessorOfPath(const JsonReader& json) {
  const auto path = json.find("path");
  if (!path) return std::nullopt;
  std::vector<CellId> cells;
  takeValue(*path, cells);
  if (!cells.empty() && cells.back() != CellId(json.at("id").unsignedInteger())) refusePath(*path);
  return cells.size() > 1 ? std::optional(cells[cells.size() - 2]) : std::nullopt;
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

/// Sees to it that what views and exporters look up is there, and sorts the cells. `json`: the patches in the file.
void requireReferences(const std::vector<JsonReader>& json, Reconstruction& result) {
  const auto item = [&](std::size_t p, const char* list, std::size_t k) { return json[p].at(list).items()[k]; };
  std::set<PatchId> patch_ids;
  std::unordered_map<CellId, PatchId> patch_of;
  patch_of.reserve(result.cellCount());
  struct Ends {
    std::pair<LinkEnd, LinkEnd> ends;
    std::pair<std::size_t, std::size_t> place;  ///< the patch, and the link in it
  };
  std::vector<Ends> links;
  links.reserve(result.linkCount());
  for (std::size_t p = 0; p < result.patches.size(); ++p) {
    const PatchReconstruction& patch = result.patches[p];
    if (!patch_ids.insert(patch.id).second) json[p].failAt("id", message("each patch once"));
    if (patch.cells.empty()) json[p].failAt("cells", message("at least one cell"));
    for (std::size_t k = 0; k < patch.cells.size(); ++k) {
      const bool is_new = patch_of.try_emplace(patch.cells[k].cell, patch.id).second;
      if (!is_new) item(p, "cells", k).failAt("id", message("each cell once"));
    }
    const auto is_here = [&](CellId cell) {
      const auto found = patch_of.find(cell);
      return found != patch_of.end() && found->second == patch.id;
    };
    if (!is_here(patch.origin)) json[p].failAt("origin", message("a cell of this patch"));
    for (std::size_t k = 0; k < patch.links.size(); ++k) {
      const LinkEstimate& link = patch.links[k];
      const auto requirePort = [&](const char* key, PortNumber port) {
        if (result.model->findPort(port) != nullptr) return;
        item(p, "links", k).failAt(key, message("a port of cell model {}", result.model->name));
      };
      requirePort("source_port", link.source.port);
      requirePort("target_port", link.target.port);
      if (!is_here(link.source.cell)) item(p, "links", k).failAt("source", message("a cell of this patch"));
      links.push_back({{link.source, link.target}, {p, k}});
    }
  }
  std::ranges::sort(links, {}, [](const Ends& link) { return std::pair(link.ends, link.place); });
  for (std::size_t k = 0; k < links.size(); ++k) {
    const auto [p, link] = links[k].place;
    if (k > 0 && links[k].ends == links[k - 1].ends) item(p, "links", link).fail(message("each link once"));
    if (patch_of.contains(links[k].ends.second.cell)) continue;
    item(p, "links", link).failAt("target", message("a cell of this calibration"));
  }
  for (std::size_t p = 0; p < result.patches.size(); ++p) {
    if (const auto stray = cellWithoutWay(result.patches[p])) {
      const JsonReader cell = item(p, "cells", *stray);
      if (const auto path = cell.find("path")) refusePath(*path);
      cell.failAt("predecessor", message("a cell of this patch on a path from its origin, which has none itself"));
    }
    std::ranges::sort(result.patches[p].cells, {}, &CellPlacement::cell);
  }
}

/// From the format to the cell model.
void readHead(const JsonReader& json, Reconstruction& result) {
  json.requireFormat(kCalibrationFormat, kCalibrationVersion);
  if (const auto options = json.find("options")) result.options = readOptions(*options);
  readSolver(json, result);
  if (const auto share = json.find("gap_s")) static_cast<void>(share->number());  // the patches have their own
  if (const auto source = json.find("source")) sourceFields(*source, result.source);
  result.model = std::make_shared<const CellModel>(readCellModel(json.at("cell_model")));
}

/// From the table of poses to the placements, and the layout. The patches are there.
void readTail(const JsonReader& json, Reconstruction& result) {
  if (const auto table = json.find("poses")) {
    for (const JsonReader& pose : table->items()) poseFields(pose, result.poses.emplace_back());
  } else {
    result.poses = posesOfGravity(result.patches);
  }
  for (const JsonReader& finding : json.at("findings").items()) findingFields(finding, result.findings.emplace_back());
  result.assessment = readVerdict(json.at("verdict"));
  if (const auto robot = json.find("robot")) result.robot = readRobot(*robot);
  if (const auto placements = json.find("placements")) result.placements = readOrigins(*placements, result);
  result.layout = computeFlatLayout(*result.model, result.patches);
}

}  // namespace

std::shared_ptr<const Reconstruction> parseCalibrationJson(std::string_view text, const std::string& file) {
  const JsonDocument document = parseJson(text, file, kMaxSkinValues);
  const JsonReader json(document);
  Reconstruction result;
  readHead(json, result);
  const std::vector<JsonReader> patches = json.at("patches").items();
  for (const JsonReader& item : patches) {
    PatchReconstruction& patch = result.patches.emplace_back();
    patchFields(item, patch);
    const std::vector<JsonReader> cells = item.at("cells").items();
    for (std::size_t k = 0; k < cells.size(); ++k) {
      if (!patch.cells[k].predecessor) patch.cells[k].predecessor = predecessorOfPath(cells[k]);
    }
  }
  requireReferences(patches, result);
  readTail(json, result);
  const std::size_t poses = result.poses.size();
  for (std::size_t p = 0; p < patches.size(); ++p) {
    const std::vector<JsonReader> links = patches[p].at("links").items();
    for (std::size_t k = 0; k < links.size(); ++k) {
      auto& residuals_rad = result.patches[p].links[k].pose_residual_rad;
      const auto given = links[k].find("pose_residual_deg");
      if (given && residuals_rad.size() != poses) given->fail(message("one entry for each of the {} poses", poses));
      residuals_rad.resize(poses);
    }
  }
  return std::make_shared<const Reconstruction>(std::move(result));
}

std::shared_ptr<const Reconstruction> readCalibrationJson(const std::filesystem::path& path) {
  return parseCalibrationJson(readFile(path, kMaxSkinBytes), path.string());
}

void writeCalibrationJson(const Reconstruction& reconstruction, const WriteBytes& write) {
  JsonWriter json(write);
  json.beginObject();
  json.member("format", kCalibrationFormat);
  json.member("version", kCalibrationVersion);
  json.member("solver", reconstruction.solver);
  const bool is_imported = reconstruction.solver != "tree" && reconstruction.solver != "global";
  if (!is_imported) json.member("gap_model", gapModelName(reconstruction.options.gap_model));
  const PatchReconstruction* const largest = largestPatch(reconstruction);
  if (largest != nullptr && largest->gap_share) json.member("gap_s", largest->gap_share->share);
  json.key("options");
  optionFields(json, reconstruction.options);
  json.key("source");
  sourceFields(json, reconstruction.source);
  json.key("cell_model");
  writeCellModel(*reconstruction.model, json);
  json.arrayMember("poses", reconstruction.poses, [&](const PoseSummary& pose) { poseFields(json, pose); });
  json.arrayMember("patches", reconstruction.patches, [&](const PatchReconstruction& p) { patchFields(json, p); });
  json.arrayMember("findings", reconstruction.findings, [&](const Finding& f) { findingFields(json, f); });
  json.key("verdict");
  verdictFields(json, reconstruction.assessment);
  writeRobotMembers(reconstruction.robot, reconstruction.placements, json);
  json.endObject();
  json.finish();
}

void writeCalibrationJson(const Reconstruction& reconstruction, const std::filesystem::path& path) {
  writeFileAtomically(path, [&](const WriteBytes& write) { writeCalibrationJson(reconstruction, write); });
}

std::string calibrationToJson(const Reconstruction& reconstruction) {
  std::string text;
  writeCalibrationJson(reconstruction, [&](std::string_view piece) { text += piece; });
  return text;
}

}  // namespace hexoderm
