#include "hexoderm/io/session_json.h"

#include "hexoderm/graph/cell_model_json.h"
#include "hexoderm/util/error.h"
#include "hexoderm/util/file.h"
#include "hexoderm/util/json_reader.h"

#include <algorithm>
#include <set>

namespace hexoderm {
namespace {

using Json = nlohmann::ordered_json;

constexpr std::string_view kFormat = "hexoderm-session";
constexpr std::uint32_t kVersion = 1;

CellModel readModel(const JsonReader& json) {
  if (json.isObject()) return readCellModel(json);
  if (!json.isString()) json.fail("the name of a built-in cell model, or a cell model as an object");
  const std::string name = json.string();
  const std::vector<std::string> known = builtInCellModelNames();
  if (std::ranges::find(known, name) == known.end()) {
    std::string names;
    for (const std::string& other : known) names += " " + other;
    json.fail("a built-in cell model (there are:" + names + ") or a cell model as an object");
  }
  return builtInCellModel(name);
}

CellReport readCell(const JsonReader& json) {
  CellReport report;
  report.id = CellId(json.at("id").unsignedInteger());
  if (const auto part = json.find("body_part")) report.body_part = part->string();
  for (const JsonReader& port : json.at("ports").items()) {
    NeighborReport neighbor{PortNumber(port.at("port").unsignedInteger()), CellId(port.at("cell").unsignedInteger()),
                            std::nullopt};
    if (const auto cell_port = port.find("cell_port")) neighbor.cell_port = PortNumber(cell_port->unsignedInteger());
    report.neighbors.push_back(neighbor);
  }
  return report;
}

Eigen::Matrix3d readCovariance(const JsonReader& json) {
  const std::vector<double> v = json.numbers(6);
  if (v[0] < 0 || v[3] < 0 || v[5] < 0) json.fail("variances (xx, yy, zz) of at least 0");
  Eigen::Matrix3d cov_g2;
  cov_g2 << v[0], v[1], v[2], v[1], v[3], v[4], v[2], v[4], v[5];
  return cov_g2;
}

SessionPose readPose(const JsonReader& json) {
  PoseCapture capture;
  // One below the largest number, so that there is always an ID for the next pose.
  capture.id = PoseId(json.at("id").unsignedInteger(0, UINT32_MAX - 1));
  if (const auto label = json.find("label")) capture.label = label->string();
  for (const JsonReader& item : json.at("samples").items()) {
    GravitySample sample;
    sample.cell = CellId(item.at("cell").unsignedInteger());
    sample.mean_g = item.at("mean_g").vector3();
    if (const auto cov = item.find("cov_g2")) sample.cov_g2 = readCovariance(*cov);
    if (const auto count = item.find("count")) sample.count = count->unsignedInteger();
    capture.samples.push_back(sample);
  }
  const auto disabled = json.find("disabled");
  return {std::make_shared<const PoseCapture>(std::move(capture)), disabled && disabled->boolean()};
}

GroundTruth readTruth(const JsonReader& json) {
  GroundTruth truth;
  if (const auto frame = json.find("frame")) truth.frame = frame->string();
  std::set<CellId> known;
  for (const JsonReader& cell : json.at("cells").items()) {
    const CellId id(cell.at("id").unsignedInteger());
    if (!known.insert(id).second) cell.at("id").fail("each cell once");
    truth.cells.push_back({id, {cell.at("R").rotation(), cell.at("t_m").vector3()}});
  }
  return truth;
}

Json modelJson(const CellModel& model) {
  const std::vector<std::string> known = builtInCellModelNames();
  const bool is_built_in = std::ranges::find(known, model.name) != known.end() &&
                           cellModelToJson(builtInCellModel(model.name)) == cellModelToJson(model);
  return is_built_in ? Json(model.name) : cellModelJson(model);
}

Json cellJson(const CellReport& report) {
  Json json;
  json["id"] = report.id.value();
  if (!report.body_part.empty()) json["body_part"] = report.body_part;
  json["ports"] = Json::array();
  for (const NeighborReport& neighbor : report.neighbors) {
    Json port;
    port["port"] = neighbor.port.value();
    port["cell"] = neighbor.cell.value();
    if (neighbor.cell_port) port["cell_port"] = neighbor.cell_port->value();
    json["ports"].push_back(std::move(port));
  }
  return json;
}

Json poseJson(const SessionPose& pose) {
  Json json;
  json["id"] = pose.capture->id.value();
  if (!pose.capture->label.empty()) json["label"] = pose.capture->label;
  if (pose.disabled) json["disabled"] = true;
  json["samples"] = Json::array();
  for (const GravitySample& sample : pose.capture->samples) {
    Json item;
    item["cell"] = sample.cell.value();
    item["mean_g"] = toJson(sample.mean_g);
    const Eigen::Matrix3d& c = sample.cov_g2;
    if (!c.isZero(0)) item["cov_g2"] = {c(0, 0), c(0, 1), c(0, 2), c(1, 1), c(1, 2), c(2, 2)};
    if (sample.count > 0) item["count"] = sample.count;
    json["samples"].push_back(std::move(item));
  }
  return json;
}

Json truthJson(const GroundTruth& truth) {
  Json json;
  json["frame"] = truth.frame;
  json["cells"] = Json::array();
  for (const TrueCellPlacement& cell : truth.cells) {
    json["cells"].push_back({{"id", cell.id.value()}, {"R", toJson(cell.T_b_u.R)}, {"t_m", toJson(cell.T_b_u.t)}});
  }
  return json;
}

}  // namespace

Session parseSessionJson(std::string_view text, const std::string& file) {
  const nlohmann::json document = parseJson(text, file);
  const JsonReader json(document, file);
  json.requireFormat(kFormat, kVersion);

  SourceDescription source{"", std::filesystem::path(file).filename().string(), sha256Hex(text)};
  if (const auto description = json.find("description")) source.text = description->string();
  CellModel model = readModel(json.at("cell_model"));
  NeighborList neighbors;
  for (const JsonReader& cell : json.at("cells").items()) neighbors.push_back(readCell(cell));
  Session session(std::move(model), std::move(neighbors), std::move(source));
  for (const JsonReader& pose : json.at("poses").items()) session.addPose(readPose(pose));
  if (const auto truth = json.find("truth")) session.setTruth(readTruth(*truth));
  return session;
}

Session readSessionJson(const std::filesystem::path& path) { return parseSessionJson(readFile(path), path.string()); }

std::string sessionToJson(const Session& session) {
  Json json;
  json["format"] = kFormat;
  json["version"] = kVersion;
  if (!session.source().text.empty()) json["description"] = session.source().text;
  json["cell_model"] = modelJson(session.model());
  json["cells"] = Json::array();
  for (const CellReport& report : session.neighbors()) json["cells"].push_back(cellJson(report));
  json["poses"] = Json::array();
  for (const SessionPose& pose : session.poses()) json["poses"].push_back(poseJson(pose));
  if (session.truth()) json["truth"] = truthJson(*session.truth());
  return dumpReadable(json);
}

void writeSessionJson(const Session& session, const std::filesystem::path& path) {
  writeFileAtomically(path, sessionToJson(session));
}

}  // namespace hexoderm
