#include "hexoderm/geometry/covariance.h"
#include "hexoderm/io/calibration_json_read.h"
#include "hexoderm/session/session_parts_json.h"
#include "hexoderm/util/error.h"
#include "hexoderm/util/limits.h"
#include "hexoderm/util/units.h"

#include <algorithm>
#include <array>
#include <set>
#include <unordered_map>
#include <utility>

namespace hexoderm {
namespace {

void requireUsual(bool is_usual) {
  if (!is_usual) throw JsonScanner::Unusual();
}

double scanNonNegative(JsonScanner& json) {
  const double value = json.number();
  requireUsual(value >= 0);
  return value;
}

double scanAngle(JsonScanner& json) { return json.number() * kDegree; }
double scanNonNegativeAngle(JsonScanner& json) { return scanNonNegative(json) * kDegree; }

Eigen::Vector3d scanNonNegativeVector(JsonScanner& json) {
  Eigen::Vector3d v;
  json.numbers({v.data(), 3});
  requireUsual((v.array() >= 0).all());
  return v;
}

Eigen::Quaterniond scanUnitQuaternion(JsonScanner& json) {
  std::array<double, 4> v{};
  json.numbers(v);
  const Eigen::Quaterniond q(v[0], v[1], v[2], v[3]);
  requireUsual(isUnitQuaternion(q));
  return q.normalized();
}

Matrix6d scanPlacementCovariance(JsonScanner& json) {
  std::array<double, 21> values{};
  json.numbers(values);
  Matrix6d cov_t_r;
  std::size_t next = 0;
  for (int row = 0; row < 6; ++row) {
    for (int col = row; col < 6; ++col) cov_t_r(row, col) = cov_t_r(col, row) = values.at(next++);
  }
  requireUsual((cov_t_r.diagonal().array() >= 0).all() && isCovariance(cov_t_r));
  return cov_t_r;
}

/// The value of a name in a file.
template <class FromName>
auto scanNamed(JsonScanner& json, FromName from_name) {
  const auto value = from_name(json.string());
  requireUsual(value.has_value());
  return *value;
}

std::optional<PlacedBy> placedByFromName(const std::string& name) {
  if (name == "samples") return PlacedBy::Samples;
  return name == "links" ? std::optional(PlacedBy::Links) : std::nullopt;
}

SensorPlacement scanSensor(JsonScanner& json) {
  SensorPlacement sensor;
  json.object(JsonScanner::required("name", [&] { sensor.name = json.string(); }),
              JsonScanner::optional("type", [&] { sensor.type = json.string(); }),
              JsonScanner::required("t_o_m", [&] { sensor.T_o_s.t = scanVector3(json, kMostLength_m); }),
              JsonScanner::required("q_o_wxyz", [&] { sensor.T_o_s.R = scanUnitQuaternion(json).toRotationMatrix(); }));
  return sensor;
}

CellPlacement scanCell(JsonScanner& json) {
  CellPlacement cell;
  std::optional<Eigen::Quaterniond> q;
  const auto sensors = [&] {
    json.beginArray();
    while (json.nextItem()) cell.sensors.push_back(scanSensor(json));
  };
  json.object(
      JsonScanner::required("id", [&] { cell.cell = CellId(json.unsignedInteger()); }),
      JsonScanner::optional("body_part", [&] { cell.body_part = json.string(); }),
      JsonScanner::required("placed_by", [&] { cell.placed_by = scanNamed(json, placedByFromName); }),
      JsonScanner::required("R_o_u", [&] { cell.T_o_u.R = scanRotation(json); }),
      JsonScanner::optional("q_o_u_wxyz", [&] { q = scanUnitQuaternion(json); }),
      JsonScanner::required("t_o_u_m", [&] { cell.T_o_u.t = scanVector3(json, kMostLength_m); }),
      JsonScanner::optional("cov_t_r", [&] { cell.cov_t_r = scanPlacementCovariance(json); }),
      JsonScanner::optional("sigma_t_m", [&] { scanNonNegativeVector(json); }),
      JsonScanner::optional("sigma_r_rad", [&] { scanNonNegativeVector(json); }),
      JsonScanner::optional("shape_cov_t_r", [&] { cell.shape_cov_t_r = scanPlacementCovariance(json); }),
      JsonScanner::optional("accel_offset_g", [&] { cell.accel_offset_g = scanVector3(json, kMostAcceleration_g); }),
      JsonScanner::optional("accel_scale", [&] { cell.accel_scale = scanVector3(json, kMostAcceleration_g); }),
      JsonScanner::optional("predecessor", [&] { cell.predecessor = CellId(json.unsignedInteger()); }),
      JsonScanner::required("sensors", sensors));
  if (q) requireUsual(rotationAngle(q->toRotationMatrix().transpose() * cell.T_o_u.R) <= 1e-5);
  return cell;
}

LinkEstimate scanLink(JsonScanner& json) {
  LinkEstimate link;
  const auto cell = [&json](CellId& id) { return [&json, &id] { id = CellId(json.unsignedInteger()); }; };
  const auto port = [&json](PortNumber& number) {
    return [&json, &number] { number = PortNumber(json.unsignedInteger()); };
  };
  const auto weight = [&] {
    link.weight = json.number();
    requireUsual(link.weight > 0);
  };
  const auto pose_residuals = [&] {
    json.beginArray();
    while (json.nextItem()) {
      link.pose_residual_rad.push_back(json.takeNull() ? std::nullopt : std::optional(scanNonNegativeAngle(json)));
    }
  };
  json.object(JsonScanner::required("source", cell(link.source.cell)),
              JsonScanner::required("source_port", port(link.source.port)),
              JsonScanner::required("target", cell(link.target.cell)),
              JsonScanner::required("target_port", port(link.target.port)),
              JsonScanner::required("R_c_n", [&] { link.R_c_n = scanRotation(json); }),
              JsonScanner::required("quality", [&] { link.quality = scanNamed(json, qualityFromName); }),
              JsonScanner::required("singular_values", [&] { link.singular_values = scanNonNegativeVector(json); }),
              JsonScanner::required("weight", weight),
              JsonScanner::required("residual_deg", [&] { link.residual_rad = scanNonNegativeAngle(json); }),
              JsonScanner::required("sigma_deg", [&] { link.sigma_rad = scanNonNegativeAngle(json); }),
              JsonScanner::required("bend_deg", [&] { link.bend_rad = scanAngle(json); }),
              JsonScanner::required("twist_deg", [&] { link.twist_rad = scanAngle(json); }),
              JsonScanner::required("yaw_deg", [&] { link.yaw_rad = scanAngle(json); }),
              JsonScanner::required("used", [&] { link.used = json.boolean(); }),
              JsonScanner::optional("muted_by", [&] { link.muted_by = scanNamed(json, codeFromName); }),
              JsonScanner::optional("centred", [&] { link.centred = json.boolean(); }),
              JsonScanner::optional("supported", [&] { link.supported = json.boolean(); }),
              JsonScanner::optional("in_tree", [&] { link.in_tree = json.boolean(); }),
              JsonScanner::required("pose_residual_deg", pose_residuals));
  return link;
}

PatchReconstruction scanPatch(JsonScanner& json, const std::string& file) {
  PatchReconstruction patch;
  const auto cells = [&] {
    json.beginArray();
    while (json.nextItem()) patch.cells.push_back(scanCell(json));
    patch.cells.shrink_to_fit();
  };
  const auto links = [&] {
    json.beginArray();
    while (json.nextItem()) patch.links.push_back(scanLink(json));
    patch.links.shrink_to_fit();
  };
  nlohmann::json rest = nlohmann::json::object();
  json.objectWith([&](std::string_view key) { json.keep(key, rest); }, JsonScanner::required("cells", cells),
                  JsonScanner::required("links", links));
  const JsonReader reader(rest, file);
  patch.id = PatchId(reader.at("id").unsignedInteger());
  patch.origin = CellId(reader.at("origin").unsignedInteger());
  patch.gap_share = readGapShare(reader);
  for (const JsonReader& item : reader.at("gravity").items()) patch.gravity.push_back(readGravity(item));
  return patch;
}

/// What PatchReader in calibration_json_read.cpp sees to, without the words.
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
    requireUsual(source < target && source.cell != target.cell && patch_of.contains(target.cell));
    requireUsual(result.model->findPort(source.port) != nullptr && result.model->findPort(target.port) != nullptr);
  }
  for (PatchReconstruction& patch : result.patches) {
    requireUsual(!cellWithoutWay(patch));
    std::ranges::sort(patch.cells, {}, &CellPlacement::cell);
  }
}

Reconstruction scanCalibration(JsonScanner& json, const std::string& file) {
  Reconstruction result;
  const auto patches = [&] {
    json.beginArray();
    while (json.nextItem()) result.patches.push_back(scanPatch(json, file));
  };
  nlohmann::json rest = nlohmann::json::object();
  json.objectWith([&](std::string_view key) { json.keep(key, rest); }, JsonScanner::required("patches", patches));
  json.finish();
  const JsonReader reader(rest, file);
  readCalibrationHead(reader, result);
  requireReferences(result);
  result.poses = readPoseTable(reader, result.patches);
  for (const PatchReconstruction& patch : result.patches) {
    for (const LinkEstimate& link : patch.links) {
      requireUsual(link.pose_residual_rad.size() == result.poses.size());
    }
  }
  readCalibrationTail(reader, result);
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

}  // namespace hexoderm
