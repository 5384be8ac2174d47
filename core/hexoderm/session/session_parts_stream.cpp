// The parts of a session that are large where the skin is: read and written without a document of them.

#include "hexoderm/session/session_parts_json.h"
#include "hexoderm/util/limits.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace hexoderm {
namespace {

/// What a cell has, as a rule.
constexpr std::size_t kUsualPorts = 6;

NeighborReport scanPort(JsonScanner& json) {
  NeighborReport neighbor;
  json.object(JsonScanner::required("port", [&] { neighbor.port = PortNumber(json.unsignedInteger()); }),
              JsonScanner::required("cell", [&] { neighbor.cell = CellId(json.unsignedInteger()); }),
              JsonScanner::optional("cell_port", [&] { neighbor.cell_port = PortNumber(json.unsignedInteger()); }));
  return neighbor;
}

CellReport scanReport(JsonScanner& json) {
  CellReport report;
  const auto ports = [&] {
    report.neighbors.reserve(kUsualPorts);
    json.beginArray();
    while (json.nextItem()) report.neighbors.push_back(scanPort(json));
  };
  json.object(JsonScanner::required("id", [&] { report.id = CellId(json.unsignedInteger()); }),
              JsonScanner::optional("body_part", [&] { report.body_part = json.string(); }),
              JsonScanner::required("ports", ports));
  return report;
}

TrueCellPlacement scanTrueCell(JsonScanner& json) {
  TrueCellPlacement cell;
  json.object(JsonScanner::required("id", [&] { cell.id = CellId(json.unsignedInteger()); }),
              JsonScanner::required("R", [&] { cell.T_b_u.R = scanRotation(json); }),
              JsonScanner::required("t_m", [&] { cell.T_b_u.t = scanVector3(json, kMostLength_m); }));
  return cell;
}

}  // namespace

Eigen::Vector3d scanVector3(JsonScanner& json, double most) {
  Eigen::Vector3d v;
  json.numbers({v.data(), 3});
  if (!isWithin(v, most)) throw JsonScanner::Unusual();
  return v;
}

Eigen::Matrix3d scanRotation(JsonScanner& json) {
  std::array<double, 9> by_rows{};
  json.numbers(by_rows);
  const Eigen::Matrix3d R = Eigen::Map<const Eigen::Matrix<double, 3, 3, Eigen::RowMajor>>(by_rows.data());
  if (!isRotation(R)) throw JsonScanner::Unusual();
  return R;
}

NeighborList scanNeighbors(JsonScanner& json) {
  NeighborList neighbors;
  json.beginArray();
  while (json.nextItem()) neighbors.push_back(scanReport(json));
  neighbors.shrink_to_fit();
  return neighbors;
}

void writeNeighbors(const NeighborList& neighbors, JsonWriter& json) {
  json.beginArray();
  for (const CellReport& report : neighbors) {
    json.beginObject();
    json.member("id", report.id.value());
    if (!report.body_part.empty()) json.member("body_part", report.body_part);
    json.key("ports");
    json.beginArray();
    for (const NeighborReport& neighbor : report.neighbors) {
      json.beginObject();
      json.member("port", neighbor.port.value());
      json.member("cell", neighbor.cell.value());
      if (neighbor.cell_port) json.member("cell_port", neighbor.cell_port->value());
      json.endObject();
    }
    json.endArray();
    json.endObject();
  }
  json.endArray();
}

GroundTruth scanTruth(JsonScanner& json) {
  GroundTruth truth;
  const auto cells = [&] {
    json.beginArray();
    while (json.nextItem()) truth.cells.push_back(scanTrueCell(json));
  };
  json.object(JsonScanner::optional("frame", [&] { truth.frame = json.string(); }),
              JsonScanner::required("cells", cells));
  truth.cells.shrink_to_fit();
  std::vector<CellId> ids;
  ids.reserve(truth.cells.size());
  for (const TrueCellPlacement& cell : truth.cells) ids.push_back(cell.id);
  std::ranges::sort(ids);
  if (std::ranges::adjacent_find(ids) != ids.end()) throw JsonScanner::Unusual();
  return truth;
}

void writeTruth(const GroundTruth& truth, JsonWriter& json) {
  json.beginObject();
  json.member("frame", truth.frame);
  json.key("cells");
  json.beginArray();
  for (const TrueCellPlacement& cell : truth.cells) {
    json.beginObject();
    json.member("id", cell.id.value());
    json.member("R", cell.T_b_u.R);
    json.member("t_m", cell.T_b_u.t);
    json.endObject();
  }
  json.endArray();
  json.endObject();
}

}  // namespace hexoderm
