#include "hexoderm/io/session_json.h"

#include "hexoderm/base/error.h"
#include "hexoderm/base/file.h"
#include "hexoderm/base/median.h"
#include "hexoderm/base/sha256.h"
#include "hexoderm/device/plausibility.h"
#include "hexoderm/session/session_parts_json.h"
#include "hexoderm/session/storable.h"
#include "hexoderm/skin/cell_model_json.h"

#include <algorithm>
#include <cmath>
#include <filesystem>

namespace hexoderm {
namespace {

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

void writeModel(const CellModel& model, JsonWriter& json) {
  const std::vector<std::string> known = builtInCellModelNames();
  const bool is_built_in = std::ranges::find(known, model.name) != known.end() &&
                           cellModelToJson(builtInCellModel(model.name)) == cellModelToJson(model);
  is_built_in ? json.value(model.name) : writeCellModel(model, json);
}

/// Nothing but +0: a -0 was measured, and comes back as it was.
bool isUnknown(const Eigen::Matrix3d& cov_g2) {
  for (const double value : cov_g2.reshaped()) {
    if (value != 0 || std::signbit(value)) return false;
  }
  return true;
}

const Described kSamples{[](auto& json, auto& sample) {
  const auto covariance = [&] {
    return isUnknown(sample.cov_g2) ? std::nullopt : std::optional(upperTriangle(sample.cov_g2));
  };
  const auto take_covariance = [&](auto& in) { AsCovariance(kMaxVariance_g2).take(in, sample.cov_g2); };
  if constexpr (!kIsRead<std::remove_cvref_t<decltype(json)>>) requireStorable(sample);
  json.object(requiredField("cell", sample.cell),
              requiredField("mean_g", sample.mean_g, vectorWithin(kMaxAcceleration_g)),
              derivedField("cov_g2", covariance, take_covariance), optionalField("count", sample.count),
              optionalField("temperature_c", sample.temperature_c));
}};

void writePose(const SessionPose& pose, JsonWriter& json) {
  try {
    poseFields(json, "id", *pose.capture, pose, requiredField("samples", pose.capture->samples, kSamples));
  } catch (const InvalidArgument& error) {
    throw InvalidArgument(message("pose {}", pose.capture->id), error.message());
  }
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
  const std::optional<ProtocolViolation> offence =
      offenceOfNorm(median(norms), session.model().accelerometer, place.c_str());
  if (offence && offence->kind == ProtocolViolationKind::AccelerationUnit) throw FormatError(file, offence->reason);
}

void readMutedLinks(const JsonReader& json, Session& session) {
  for (const JsonReader& item : json.items()) {
    const MutedLink link = readMutedLink(item);
    if (session.findMutedLink(link.source, link.target) != nullptr) item.fail(message("each link once"));
    session.setLinkMuted(link.source, link.target, true, link.why);
  }
}

}  // namespace

Session parseSessionJson(std::string_view text, const std::string& file) {
  const JsonDocument document = parseJson(text, file, kMaxSkinValues);
  const JsonReader json(document);
  json.requireFormat(kSessionFormat, kSessionVersion);
  SourceDescription source{{}, std::filesystem::path(file).filename().string(), sha256Hex(text)};
  if (json.find("description")) source.text = readMessage(json, "description");
  CellModel model = readModel(json.at("cell_model"));
  Session session(std::move(model), readNeighbors(json.at("cells")), std::move(source));
  for (const JsonReader& pose : json.at("poses").items()) {
    session.addPose(readPose(pose, "id", [&] {
      std::vector<GravitySample> samples;
      kSamples.take(pose.at("samples"), samples);
      return samples;
    }));
  }
  requireG(session, file);
  if (const auto muted = json.find("muted_links")) readMutedLinks(*muted, session);
  if (const SkinSide side = readSkinSide(json); side != SkinSide::Unknown) session.setSide(side);
  if (const auto robot = json.find("robot")) session.setRobot(readRobot(*robot));
  if (const auto placements = json.find("placements")) {
    for (PatchPlacement& placement : readPlacements(*placements)) session.setPlacement(std::move(placement));
  }
  if (const auto truth = json.find("truth")) session.setTruth(readTruth(*truth));
  return session;
}

Session readSessionJson(const std::filesystem::path& path) {
  return parseSessionJson(readFile(path, kMaxSkinBytes), path.string());
}

void writeSessionJson(const Session& session, const WriteBytes& write) {
  JsonWriter json(write);
  json.beginObject();
  json.member("format", kSessionFormat);
  json.member("version", kSessionVersion);
  if (!session.source().text.empty()) writeMessage(json, "description", session.source().text);
  json.key("cell_model");
  writeModel(session.model(), json);
  json.key("cells");
  writeNeighbors(session.neighbors(), json);
  json.arrayMember("poses", session.poses(), [&](const SessionPose& pose) { writePose(pose, json); });
  if (!session.mutedLinks().empty()) {
    json.arrayMember("muted_links", session.mutedLinks(), [&](const MutedLink& link) { writeMutedLink(link, json); });
  }
  writeSkinSide(session.side(), json);
  writeRobotMembers(session.robot(), session.placements(), json);
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
