#include "hexoderm/io/session_json_read.h"

#include "hexoderm/device/diagnosis/plausibility.h"
#include "hexoderm/geometry/covariance.h"
#include "hexoderm/graph/cell_model_json.h"
#include "hexoderm/io/session_json.h"
#include "hexoderm/session/session_parts_json.h"
#include "hexoderm/util/error.h"
#include "hexoderm/util/limits.h"
#include "hexoderm/util/median.h"
#include "hexoderm/util/message_json.h"
#include "hexoderm/util/sha256.h"

#include <algorithm>
#include <array>
#include <filesystem>
#include <span>

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

template <class In>
Eigen::Matrix3d readSampleCovariance(In& json) {
  const Eigen::Matrix3d cov_g2 = fromUpperTriangle<3>(json.template numbers<6>(kMostVariance_g2));
  if ((cov_g2.diagonal().array() < 0).any()) json.fail(message("variances (xx, yy, zz) of at least 0"));
  if (!isCovariance(cov_g2)) json.fail(message("a covariance (positive semidefinite)"));
  return cov_g2;
}

/// `usual`: how many there will be, as a rule.
template <class In>
std::vector<GravitySample> readSamples(In&& json, std::size_t usual) {
  std::vector<GravitySample> samples;
  samples.reserve(usual);
  json.eachItem([&](auto& item) {
    GravitySample& sample = samples.emplace_back();
    item.object(member("cell", into(sample.cell)),
                member("mean_g", [&](auto& in) { sample.mean_g = in.vector3(kMostAcceleration_g); }),
                optionalMember("cov_g2", [&](auto& in) { sample.cov_g2 = readSampleCovariance(in); }),
                optionalMember("count", into(sample.count)),
                optionalMember("temperature_c", into(sample.temperature_c)));
  });
  samples.shrink_to_fit();
  return samples;
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
  if (offence && offence->kind == OffenceKind::AccelerationUnit) throw FormatError(file, offence->reason);
}

SessionPose scanPose(JsonScanner& json, const std::string& file, std::size_t usual_samples) {
  nlohmann::json rest = nlohmann::json::object();
  std::vector<GravitySample> samples;
  json.objectWith([&](std::string_view key) { json.keep(key, rest); },
                  member("samples", [&](auto& in) { samples = readSamples(in, usual_samples); }));
  return readPose(JsonReader(rest, file), "id", [&] { return std::move(samples); });
}

std::vector<SessionPose> scanPoses(JsonScanner& json, const std::string& file) {
  std::vector<SessionPose> poses;
  json.eachItem([&](JsonScanner& item) {
    const std::size_t before = poses.empty() ? 0 : poses.back().capture->samples.size();
    poses.push_back(scanPose(item, file, before));
  });
  return poses;
}

/// What stands in a file in front of cells and poses.
struct SessionHead {
  SourceDescription source;
  CellModel model;
};

SessionHead readHead(const JsonReader& json, std::string_view text, const std::string& file) {
  json.requireFormat(kSessionFormat, kSessionVersion);
  SourceDescription source{{}, std::filesystem::path(file).filename().string(), sha256Hex(text)};
  if (json.find("description")) source.text = readMessage(json, "description");
  return {std::move(source), readModel(json.at("cell_model"))};
}

/// What stands behind them, but for the truth.
void readTail(const JsonReader& json, const std::string& file, Session& session) {
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
}

Session scanSession(JsonScanner& json, std::string_view text, const std::string& file) {
  nlohmann::json rest = nlohmann::json::object();
  NeighborList cells;
  std::vector<SessionPose> poses;
  std::optional<GroundTruth> truth;
  json.objectWith([&](std::string_view key) { json.keep(key, rest); },
                  member("cells", [&] { cells = scanNeighbors(json); }),
                  member("poses", [&] { poses = scanPoses(json, file); }),
                  optionalMember("truth", [&] { truth = scanTruth(json); }));
  json.finish();

  const JsonReader reader(rest, file);
  SessionHead head = readHead(reader, text, file);
  Session session(std::move(head.model), std::move(cells), std::move(head.source));
  for (SessionPose& pose : poses) session.addPose(std::move(pose));
  readTail(reader, file, session);
  if (truth) session.setTruth(std::move(*truth));
  return session;
}

}  // namespace

std::optional<Session> scanSessionJson(std::string_view text, const std::string& file) {
  try {
    JsonScanner json(text);
    return scanSession(json, text, file);
  } catch (const JsonScanner::Unusual&) {
    return std::nullopt;
  } catch (const Error&) {
    return std::nullopt;  // the thorough reader says it with its place
  }
}

Session sessionFromDocument(std::string_view text, const std::string& file) {
  const nlohmann::json document = parseJson(text, file);
  const JsonReader json(document, file);
  SessionHead head = readHead(json, text, file);
  NeighborList neighbors = readNeighbors(json.at("cells"));
  Session session(std::move(head.model), std::move(neighbors), std::move(head.source));
  for (const JsonReader& pose : json.at("poses").items()) {
    session.addPose(readPose(pose, "id", [&] { return readSamples(pose.at("samples"), 0); }));
  }
  readTail(json, file, session);
  if (const auto truth = json.find("truth")) session.setTruth(readTruth(*truth));
  return session;
}

}  // namespace hexoderm
