#include "hexoderm/io/calibration_json.h"

#include "hexoderm/geometry/covariance.h"
#include "hexoderm/graph/cell_model_json.h"
#include "hexoderm/session/session_parts_json.h"
#include "hexoderm/util/file.h"
#include "hexoderm/util/message_json.h"
#include "hexoderm/util/units.h"

#include <algorithm>
#include <cmath>

namespace hexoderm {
namespace {

using Json = nlohmann::ordered_json;

/// `value` in `unit`, so that the product with the unit gives the same double again wherever there is such a number; a
/// short one (60, not 59.99999999999999) if possible.
double inUnit(double value, double unit) {
  const double scaled = value / unit;
  constexpr double kShort = 1e9;
  for (const double candidate : {std::round(scaled * kShort) / kShort, scaled, std::nextafter(scaled, HUGE_VAL),
                                 std::nextafter(scaled, -HUGE_VAL)}) {
    if (candidate * unit == value) return candidate;
  }
  return scaled;
}

double inDegrees(double angle_rad) { return inUnit(angle_rad, kDegree); }

template <class Ids>
Json idsJson(const Ids& ids) {
  Json json = Json::array();
  for (const auto id : ids) json.push_back(id.value());
  return json;
}

Json optionsJson(const SolverOptions& options) {
  Json json = {{"centre", centringName(options.centring)},
               {"support-axes", supportAxesName(options.support_axes)},
               {"weights", linkWeightsName(options.weights)},
               {"class-threshold", options.class_threshold},
               {"max-bend-deg", inDegrees(options.max_bend_rad)},
               {"max-twist-deg", inDegrees(options.max_twist_rad)},
               {"max-yaw-deg", inDegrees(options.max_yaw_rad)},
               {"max-misfit", options.max_misfit},
               {"max-opening", options.max_opening}};
  if (!options.left_out.empty()) json["without"] = idsJson(options.left_out);
  return json;
}

Json sourceJson(const SourceDescription& source) {
  Json json = {{"file", source.file}, {"sha256", source.sha256}};
  if (!source.text.empty()) writeMessage(json, "description", source.text);
  return json;
}

Json poseJson(const PoseSummary& pose) {
  Json json;
  json["id"] = pose.pose.value();
  if (!pose.label.empty()) writeMessage(json, "label", pose.label);
  json["enabled"] = pose.enabled;
  json["cells_measured"] = pose.cells_measured;
  json["noise_g"] = pose.noise_g;
  if (pose.new_by_rad) json["new_by_deg"] = inDegrees(*pose.new_by_rad);
  if (pose.residual_rad) json["residual_deg"] = inDegrees(*pose.residual_rad);
  return json;
}

void writeCell(const CellPlacement& cell, JsonWriter& json) {
  json.beginObject();
  json.member("id", cell.cell.value());
  if (!cell.body_part.empty()) json.member("body_part", cell.body_part);
  json.member("placed_by", cell.placed_by == PlacedBy::Samples ? "samples" : "links");
  json.member("R_o_u", cell.T_o_u.R);
  json.member("q_o_u_wxyz", quaternionWxyz(cell.T_o_u.R));
  json.member("t_o_u_m", cell.T_o_u.t);
  if (cell.cov_t_r) {
    json.member("cov_t_r", upperTriangle(*cell.cov_t_r));
    const Eigen::Matrix<double, 6, 1> sigma = cell.cov_t_r->diagonal().cwiseMax(0).cwiseSqrt();
    json.member("sigma_t_m", Eigen::Vector3d(sigma.head<3>()));
    json.member("sigma_r_rad", Eigen::Vector3d(sigma.tail<3>()));
  }
  if (cell.shape_cov_t_r) json.member("shape_cov_t_r", upperTriangle(*cell.shape_cov_t_r));
  if (cell.accel_offset_g) json.member("accel_offset_g", *cell.accel_offset_g);
  if (cell.accel_scale) json.member("accel_scale", *cell.accel_scale);
  if (cell.predecessor) json.member("predecessor", cell.predecessor->value());
  json.arrayMember("sensors", cell.sensors, [&](const SensorPlacement& sensor) {
    json.beginObject();
    json.member("name", sensor.name);
    json.member("type", sensor.type);
    json.member("t_o_m", sensor.T_o_s.t);
    json.member("q_o_wxyz", quaternionWxyz(sensor.T_o_s.R));
    json.endObject();
  });
  json.endObject();
}

void writeLink(const LinkEstimate& link, JsonWriter& json) {
  json.beginObject();
  json.member("source", link.source.cell.value());
  json.member("source_port", link.source.port.value());
  json.member("target", link.target.cell.value());
  json.member("target_port", link.target.port.value());
  json.member("R_c_n", link.R_c_n);
  json.member("quality", qualityName(link.quality));
  json.member("singular_values", link.singular_values);
  json.member("weight", link.weight);
  json.member("residual_deg", inDegrees(link.residual_rad));
  json.member("sigma_deg", inDegrees(link.sigma_rad));
  json.member("bend_deg", inDegrees(link.bend_rad));
  json.member("twist_deg", inDegrees(link.twist_rad));
  json.member("yaw_deg", inDegrees(link.yaw_rad));
  json.member("used", link.used);
  if (link.muted_by) json.member("muted_by", codeName(*link.muted_by));
  json.member("centred", link.centred);
  json.member("supported", link.supported);
  json.member("in_tree", link.in_tree);
  json.arrayMember("pose_residual_deg", link.pose_residual_rad, [&](const std::optional<double>& residual_rad) {
    residual_rad ? json.value(inDegrees(*residual_rad)) : json.null();
  });
  json.endObject();
}

void writePatch(const PatchReconstruction& patch, JsonWriter& json) {
  json.beginObject();
  json.member("id", patch.id.value());
  json.member("origin", patch.origin.value());
  if (patch.gap_share) {
    json.member("gap_s", patch.gap_share->share);
    json.member("gap_s_sigma", patch.gap_share->sigma);
  }
  json.arrayMember("gravity", patch.gravity, [&](const GravityDirection& gravity) {
    json.beginObject();
    json.member("pose", gravity.pose.value());
    json.member("g_o", gravity.g_o);
    json.member("sigma_deg", inDegrees(gravity.sigma_rad));
    json.endObject();
  });
  json.arrayMember("cells", patch.cells, [&](const CellPlacement& cell) { writeCell(cell, json); });
  json.arrayMember("links", patch.links, [&](const LinkEstimate& link) { writeLink(link, json); });
  json.endObject();
}

Json findingJson(const Finding& finding) {
  Json json = {{"code", codeName(finding.code)}, {"severity", severityName(finding.severity)}};
  writeMessage(json, "text", finding.message);
  json["cells"] = idsJson(finding.cells);
  json["ports"] = idsJson(finding.ports);
  json["poses"] = idsJson(finding.poses);
  return json;
}

Json verdictJson(const Assessment& verdict) {
  const auto orNull = [](const std::optional<double>& value, double unit) {
    return value ? Json(inUnit(*value, unit)) : Json(nullptr);
  };
  Json json = {{"level", verdictName(verdict.level)}};
  writeMessage(json, "reason", verdict.reason);
  json["position_95_mm"] = orNull(verdict.position_95_m, kMillimetre);
  json["orientation_95_deg"] = orNull(verdict.orientation_95_rad, kDegree);
  json["limit"] = limitName(verdict.limit);
  json["limiting_cells"] = idsJson(verdict.limiting_cells);
  json["remedy"] = remedyName(verdict.remedy);
  json["retake"] = idsJson(verdict.retake);
  writeMessage(json, "next_action", verdict.next_action);
  return json;
}

}  // namespace

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
  json.member("options", optionsJson(reconstruction.options));
  json.member("source", sourceJson(reconstruction.source));
  json.member("cell_model", cellModelJson(*reconstruction.model));
  json.arrayMember("poses", reconstruction.poses, [&](const PoseSummary& pose) { json.value(poseJson(pose)); });
  json.arrayMember("patches", reconstruction.patches, [&](const PatchReconstruction& p) { writePatch(p, json); });
  json.arrayMember("findings", reconstruction.findings, [&](const Finding& f) { json.value(findingJson(f)); });
  json.member("verdict", verdictJson(reconstruction.assessment));
  if (reconstruction.robot) json.member("robot", robotJson(reconstruction.robot));
  if (!reconstruction.placements.empty()) json.member("placements", placementsJson(reconstruction.placements));
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
