#include "hexoderm/io/calibration_json.h"

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

Json covarianceJson(const Matrix6d& cov_t_r) {
  Json json = Json::array();
  for (int row = 0; row < 6; ++row) {
    for (int col = row; col < 6; ++col) json.push_back(cov_t_r(row, col));
  }
  return json;
}

Json cellJson(const CellPlacement& cell) {
  Json json;
  json["id"] = cell.cell.value();
  if (!cell.body_part.empty()) json["body_part"] = cell.body_part;
  json["placed_by"] = cell.placed_by == PlacedBy::Samples ? "samples" : "links";
  json["R_o_u"] = toJson(cell.T_o_u.R);
  json["q_o_u_wxyz"] = quaternionWxyz(cell.T_o_u.R);
  json["t_o_u_m"] = toJson(cell.T_o_u.t);
  if (cell.cov_t_r) {
    json["cov_t_r"] = covarianceJson(*cell.cov_t_r);
    const Eigen::Matrix<double, 6, 1> sigma = cell.cov_t_r->diagonal().cwiseMax(0).cwiseSqrt();
    json["sigma_t_m"] = toJson(Eigen::Vector3d(sigma.head<3>()));
    json["sigma_r_rad"] = toJson(Eigen::Vector3d(sigma.tail<3>()));
  }
  if (cell.shape_cov_t_r) json["shape_cov_t_r"] = covarianceJson(*cell.shape_cov_t_r);
  if (cell.accel_offset_g) json["accel_offset_g"] = toJson(*cell.accel_offset_g);
  if (cell.accel_scale) json["accel_scale"] = toJson(*cell.accel_scale);
  if (cell.predecessor) json["predecessor"] = cell.predecessor->value();
  json["sensors"] = Json::array();
  for (const SensorPlacement& sensor : cell.sensors) {
    json["sensors"].push_back({{"name", sensor.name},
                               {"type", sensor.type},
                               {"t_o_m", toJson(sensor.T_o_s.t)},
                               {"q_o_wxyz", quaternionWxyz(sensor.T_o_s.R)}});
  }
  return json;
}

Json linkJson(const LinkEstimate& link) {
  Json json;
  json["source"] = link.source.cell.value();
  json["source_port"] = link.source.port.value();
  json["target"] = link.target.cell.value();
  json["target_port"] = link.target.port.value();
  json["R_c_n"] = toJson(link.R_c_n);
  json["quality"] = qualityName(link.quality);
  json["singular_values"] = toJson(link.singular_values);
  json["weight"] = link.weight;
  json["residual_deg"] = inDegrees(link.residual_rad);
  json["sigma_deg"] = inDegrees(link.sigma_rad);
  json["bend_deg"] = inDegrees(link.bend_rad);
  json["twist_deg"] = inDegrees(link.twist_rad);
  json["yaw_deg"] = inDegrees(link.yaw_rad);
  json["used"] = link.used;
  if (link.muted_by) json["muted_by"] = codeName(*link.muted_by);
  json["centred"] = link.centred;
  json["supported"] = link.supported;
  json["in_tree"] = link.in_tree;
  json["pose_residual_deg"] = Json::array();
  for (const std::optional<double>& residual_rad : link.pose_residual_rad) {
    json["pose_residual_deg"].push_back(residual_rad ? Json(inDegrees(*residual_rad)) : Json(nullptr));
  }
  return json;
}

Json patchJson(const PatchReconstruction& patch) {
  Json json;
  json["id"] = patch.id.value();
  json["origin"] = patch.origin.value();
  if (patch.gap_share) {
    json["gap_s"] = patch.gap_share->share;
    json["gap_s_sigma"] = patch.gap_share->sigma;
  }
  json["gravity"] = Json::array();
  for (const GravityDirection& gravity : patch.gravity) {
    json["gravity"].push_back(
        {{"pose", gravity.pose.value()}, {"g_o", toJson(gravity.g_o)}, {"sigma_deg", inDegrees(gravity.sigma_rad)}});
  }
  json["cells"] = Json::array();
  for (const CellPlacement& cell : patch.cells) json["cells"].push_back(cellJson(cell));
  json["links"] = Json::array();
  for (const LinkEstimate& link : patch.links) json["links"].push_back(linkJson(link));
  return json;
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

std::string calibrationToJson(const Reconstruction& reconstruction) {
  Json json;
  json["format"] = kCalibrationFormat;
  json["version"] = kCalibrationVersion;
  json["solver"] = reconstruction.solver;
  // The tree lets both extended port vectors of a link end in one point, eq. (3); an imported file doesn't say.
  if (reconstruction.solver == "tree") json["gap_model"] = gapModelName(GapModel::Pivot);
  if (reconstruction.solver == "global") json["gap_model"] = gapModelName(reconstruction.options.gap_model);
  const PatchReconstruction* const largest = largestPatch(reconstruction);
  if (largest != nullptr && largest->gap_share) json["gap_s"] = largest->gap_share->share;
  json["options"] = optionsJson(reconstruction.options);
  json["source"] = sourceJson(reconstruction.source);
  json["cell_model"] = cellModelJson(*reconstruction.model);
  json["poses"] = Json::array();
  for (const PoseSummary& pose : reconstruction.poses) json["poses"].push_back(poseJson(pose));
  json["patches"] = Json::array();
  for (const PatchReconstruction& patch : reconstruction.patches) json["patches"].push_back(patchJson(patch));
  json["findings"] = Json::array();
  for (const Finding& finding : reconstruction.findings) json["findings"].push_back(findingJson(finding));
  json["verdict"] = verdictJson(reconstruction.assessment);
  if (reconstruction.robot) json["robot"] = robotJson(reconstruction.robot);
  if (!reconstruction.placements.empty()) json["placements"] = placementsJson(reconstruction.placements);
  return dumpReadable(json);
}

void writeCalibrationJson(const Reconstruction& reconstruction, const std::filesystem::path& path) {
  writeFileAtomically(path, calibrationToJson(reconstruction));
}

}  // namespace hexoderm
