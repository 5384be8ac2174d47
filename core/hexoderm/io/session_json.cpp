#include "hexoderm/io/session_json.h"

#include "hexoderm/device/diagnosis/plausibility.h"
#include "hexoderm/geometry/covariance.h"
#include "hexoderm/graph/cell_model_json.h"
#include "hexoderm/session/session_parts_json.h"
#include "hexoderm/util/error.h"
#include "hexoderm/util/file.h"
#include "hexoderm/util/json_reader.h"
#include "hexoderm/util/limits.h"
#include "hexoderm/util/median.h"
#include "hexoderm/util/message_json.h"
#include "hexoderm/util/sha256.h"

#include <algorithm>
#include <cmath>

namespace hexoderm {
namespace {

using Json = nlohmann::ordered_json;

CellModel readModel(const JsonReader& json) {
  if (json.isObject()) return readCellModel(json);
  if (!json.isString()) json.fail(message("the name of a built-in cell model, or a cell model as an object"));
  const std::string name = json.string();
  const std::vector<std::string> known = builtInCellModelNames();
  if (std::ranges::find(known, name) == known.end()) {
    std::string names;
    for (const std::string& other : known) names += " " + other;
    json.fail(message("a built-in cell model (there are:{}) or a cell model as an object", names));
  }
  return builtInCellModel(name);
}

Eigen::Matrix3d readCovariance(const JsonReader& json) {
  const std::vector<double> v = json.numbers(6, kMostVariance_g2);
  if (v[0] < 0 || v[3] < 0 || v[5] < 0) json.fail(message("variances (xx, yy, zz) of at least 0"));
  Eigen::Matrix3d cov_g2;
  cov_g2 << v[0], v[1], v[2], v[1], v[3], v[4], v[2], v[4], v[5];
  if (!isCovariance(cov_g2)) json.fail(message("a covariance (positive semidefinite)"));
  return cov_g2;
}

SessionPose readPose(const JsonReader& json) {
  PoseCapture capture;
  // One below the largest number, so that there is always an ID for the next pose.
  capture.id = PoseId(json.at("id").unsignedInteger(0, UINT32_MAX - 1));
  if (json.find("label")) capture.label = readMessage(json, "label");
  if (const auto taken = json.find("taken_at_ms")) capture.taken_at_ms = taken->integer();
  for (const JsonReader& item : json.at("samples").items()) {
    GravitySample sample;
    sample.cell = CellId(item.at("cell").unsignedInteger());
    sample.mean_g = item.at("mean_g").vector3(kMostAcceleration_g);
    if (const auto cov = item.find("cov_g2")) sample.cov_g2 = readCovariance(*cov);
    if (const auto count = item.find("count")) sample.count = count->unsignedInteger();
    if (const auto temperature = item.find("temperature_c")) sample.temperature_c = temperature->number();
    capture.samples.push_back(sample);
  }
  const auto disabled = json.find("disabled");
  const auto why = json.find("why_disabled");
  const auto joints = json.find("joint_angles");
  return {std::make_shared<const PoseCapture>(std::move(capture)), disabled && disabled->boolean(),
          why ? why->string() : std::string(), joints ? readJointAngles(*joints) : JointAngles()};
}

/// Somebody's program wrote another unit: no reading would count, and nothing would say why. Throws FormatError.
void requireG(const Session& session, const std::string& file) {
  std::vector<double> norms;
  std::optional<std::size_t> first;
  for (std::size_t pose = 0; pose < session.poses().size(); ++pose) {
    for (const GravitySample& sample : session.poses()[pose].capture->samples) norms.push_back(sample.mean_g.norm());
    if (!first && !norms.empty()) first = pose;
  }
  if (!first) return;
  const std::string place = "poses[" + std::to_string(*first) + "].samples[0].mean_g";
  const std::optional<Offence> offence = offenceOfNorm(median(norms), session.model().accelerometer, place.c_str());
  if (offence && offence->kind == OffenceKind::AccelerationUnit) throw FormatError(located(file, offence->reason));
}

Json modelJson(const CellModel& model) {
  const std::vector<std::string> known = builtInCellModelNames();
  const bool is_built_in = std::ranges::find(known, model.name) != known.end() &&
                           cellModelToJson(builtInCellModel(model.name)) == cellModelToJson(model);
  return is_built_in ? Json(model.name) : cellModelJson(model);
}

/// Nothing but +0: a -0 was measured, and comes back as it was.
bool isUnknown(const Eigen::Matrix3d& cov_g2) {
  for (const double value : cov_g2.reshaped()) {
    if (value != 0 || std::signbit(value)) return false;
  }
  return true;
}

Json poseJson(const SessionPose& pose) {
  Json json;
  json["id"] = pose.capture->id.value();
  if (!pose.capture->label.empty()) writeMessage(json, "label", pose.capture->label);
  if (pose.capture->taken_at_ms) json["taken_at_ms"] = *pose.capture->taken_at_ms;
  if (pose.disabled) json["disabled"] = true;
  if (!pose.why_disabled.empty()) json["why_disabled"] = pose.why_disabled;
  if (!pose.joint_angles.positions.empty()) json["joint_angles"] = jointAnglesJson(pose.joint_angles);
  json["samples"] = Json::array();
  for (const GravitySample& sample : pose.capture->samples) {
    Json item;
    item["cell"] = sample.cell.value();
    item["mean_g"] = toJson(sample.mean_g);
    const Eigen::Matrix3d& c = sample.cov_g2;
    if (!isUnknown(c)) item["cov_g2"] = {c(0, 0), c(0, 1), c(0, 2), c(1, 1), c(1, 2), c(2, 2)};
    if (sample.count > 0) item["count"] = sample.count;
    if (sample.temperature_c) item["temperature_c"] = *sample.temperature_c;
    json["samples"].push_back(std::move(item));
  }
  return json;
}

}  // namespace

Session parseSessionJson(std::string_view text, const std::string& file) {
  const nlohmann::json document = parseJson(text, file);
  const JsonReader json(document, file);
  json.requireFormat(kSessionFormat, kSessionVersion);

  SourceDescription source{{}, std::filesystem::path(file).filename().string(), sha256Hex(text)};
  if (json.find("description")) source.text = readMessage(json, "description");
  CellModel model = readModel(json.at("cell_model"));
  NeighborList neighbors = readNeighbors(json.at("cells"));
  Session session(std::move(model), std::move(neighbors), std::move(source));
  for (const JsonReader& pose : json.at("poses").items()) session.addPose(readPose(pose));
  requireG(session, file);
  if (const auto muted = json.find("muted_links")) {
    for (const JsonReader& item : muted->items()) {
      const MutedLink link = readMutedLink(item);
      if (session.findMutedLink(link.source, link.target) != nullptr) item.fail(message("each link once"));
      session.setLinkMuted(link.source, link.target, true, link.why);
    }
  }
  if (const auto robot = json.find("robot")) session.setRobot(readRobot(*robot));
  if (const auto placements = json.find("placements")) {
    for (PatchPlacement& placement : readPlacements(*placements)) session.setPlacement(std::move(placement));
  }
  if (const auto truth = json.find("truth")) session.setTruth(readTruth(*truth));
  return session;
}

Session readSessionJson(const std::filesystem::path& path) { return parseSessionJson(readFile(path), path.string()); }

std::string sessionToJson(const Session& session) {
  Json json;
  json["format"] = kSessionFormat;
  json["version"] = kSessionVersion;
  if (!session.source().text.empty()) writeMessage(json, "description", session.source().text);
  json["cell_model"] = modelJson(session.model());
  json["cells"] = neighborsJson(session.neighbors());
  json["poses"] = Json::array();
  for (const SessionPose& pose : session.poses()) json["poses"].push_back(poseJson(pose));
  if (!session.mutedLinks().empty()) {
    json["muted_links"] = Json::array();
    for (const MutedLink& link : session.mutedLinks()) json["muted_links"].push_back(mutedLinkJson(link));
  }
  if (session.robot()) json["robot"] = robotJson(session.robot());
  if (!session.placements().empty()) json["placements"] = placementsJson(session.placements());
  if (session.truth()) json["truth"] = truthJson(*session.truth());
  return dumpReadable(json);
}

void writeSessionJson(const Session& session, const std::filesystem::path& path) {
  writeFileAtomically(path, sessionToJson(session));
}

}  // namespace hexoderm
