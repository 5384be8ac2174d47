#include "hexoderm/io/session_json.h"

#include "hexoderm/geometry/covariance.h"
#include "hexoderm/graph/cell_model_json.h"
#include "hexoderm/io/session_json_read.h"
#include "hexoderm/session/session_parts_json.h"
#include "hexoderm/session/storable.h"
#include "hexoderm/util/error.h"
#include "hexoderm/util/file.h"
#include "hexoderm/util/message_json.h"

#include <algorithm>
#include <cmath>

namespace hexoderm {
namespace {

using Json = nlohmann::ordered_json;

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

void writeSample(const GravitySample& sample, JsonWriter& json) {
  requireStorable(sample);
  json.beginObject();
  json.member("cell", sample.cell.value());
  json.member("mean_g", sample.mean_g);
  if (!isUnknown(sample.cov_g2)) json.member("cov_g2", upperTriangle(sample.cov_g2));
  if (sample.count > 0) json.member("count", sample.count);
  if (sample.temperature_c) json.member("temperature_c", *sample.temperature_c);
  json.endObject();
}

void writePose(const SessionPose& pose, JsonWriter& json) {
  json.beginObject();
  json.member("id", pose.capture->id.value());
  if (!pose.capture->label.empty()) writeMessage(json, "label", pose.capture->label);
  if (pose.capture->taken_at_ms) json.member("taken_at_ms", *pose.capture->taken_at_ms);
  if (pose.disabled) json.member("disabled", true);
  if (!pose.why_disabled.empty()) json.member("why_disabled", pose.why_disabled);
  if (!pose.joint_angles.positions.empty()) json.member("joint_angles", jointAnglesJson(pose.joint_angles));
  try {
    json.arrayMember("samples", pose.capture->samples, [&](const GravitySample& s) { writeSample(s, json); });
  } catch (const InvalidArgument& error) {
    throw InvalidArgument(message("pose {}", pose.capture->id), error.message());
  }
  json.endObject();
}

}  // namespace

Session parseSessionJson(std::string_view text, const std::string& file) {
  if (std::optional<Session> session = scanSessionJson(text, file)) return std::move(*session);
  return sessionFromDocument(text, file);
}

Session readSessionJson(const std::filesystem::path& path) {
  return parseSessionJson(readFile(path, kMostSkinBytes), path.string());
}

void writeSessionJson(const Session& session, const WriteBytes& write) {
  JsonWriter json(write);
  json.beginObject();
  json.member("format", kSessionFormat);
  json.member("version", kSessionVersion);
  if (!session.source().text.empty()) writeMessage(json, "description", session.source().text);
  json.member("cell_model", modelJson(session.model()));
  json.key("cells");
  writeNeighbors(session.neighbors(), json);
  json.arrayMember("poses", session.poses(), [&](const SessionPose& pose) { writePose(pose, json); });
  if (!session.mutedLinks().empty()) {
    json.arrayMember("muted_links", session.mutedLinks(),
                     [&](const MutedLink& link) { json.value(mutedLinkJson(link)); });
  }
  if (session.robot()) json.member("robot", robotJson(session.robot()));
  if (!session.placements().empty()) json.member("placements", placementsJson(session.placements()));
  if (session.truth()) {
    json.key("truth");
    writeTruth(*session.truth(), json);
  }
  json.endObject();
  json.finish();
}

void writeSessionJson(const Session& session, const std::filesystem::path& path) {
  try {
    writeFileAtomically(path, [&](const WriteBytes& write) { writeSessionJson(session, write); });
  } catch (const InvalidArgument& error) {
    throw InvalidArgument(path.string(), error.message());
  }
}

std::string sessionToJson(const Session& session) {
  std::string text;
  writeSessionJson(session, [&](std::string_view piece) { text += piece; });
  return text;
}

}  // namespace hexoderm
