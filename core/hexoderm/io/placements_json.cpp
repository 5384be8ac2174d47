#include "hexoderm/io/placements_json.h"

#include "hexoderm/geometry/covariance.h"
#include "hexoderm/util/error.h"
#include "hexoderm/util/file.h"
#include "hexoderm/util/json_reader.h"
#include "hexoderm/util/limits.h"

#include <set>

namespace hexoderm {
namespace {

nlohmann::ordered_json placementJson(const PatchOnLink& place) {
  nlohmann::ordered_json json = {{"origin_cell", place.origin.value()},
                                 {"link", place.link},
                                 {"R", toJson(place.T_l_o.R)},
                                 {"t_m", toJson(place.T_l_o.t)}};
  if (!place.cov_t_r) return json;
  json["cov_t_r"] = nlohmann::ordered_json::array();
  for (Eigen::Index row = 0; row < 6; ++row) {
    for (Eigen::Index column = row; column < 6; ++column) json["cov_t_r"].push_back((*place.cov_t_r)(row, column));
  }
  return json;
}

PatchOnLink placementFromJson(const JsonReader& json) {
  PatchOnLink place;
  place.origin = CellId(json.at("origin_cell").unsignedInteger(1));
  place.link = json.at("link").string();
  if (place.link.empty()) json.at("link").fail(message("the name of a link"));
  place.T_l_o = {json.at("R").rotation(), json.at("t_m").vector3(kMostLength_m)};
  const auto cov = json.find("cov_t_r");
  if (!cov) return place;
  const std::vector<double> values = cov->numbers(21);
  Matrix6d cov_t_r;
  std::size_t next = 0;
  for (Eigen::Index row = 0; row < 6; ++row) {
    for (Eigen::Index column = row; column < 6; ++column) {
      cov_t_r(row, column) = cov_t_r(column, row) = values[next++];
    }
  }
  if (!isCovariance(cov_t_r)) cov->fail(message("a covariance (positive semidefinite)"));
  place.cov_t_r = cov_t_r;
  return place;
}

}  // namespace

std::string placementsToJson(const std::vector<PatchOnLink>& placements) {
  nlohmann::ordered_json json = {
      {"format", kPlacementsFormat}, {"version", kPlacementsVersion}, {"placements", nlohmann::ordered_json::array()}};
  for (const PatchOnLink& place : placements) json["placements"].push_back(placementJson(place));
  return dumpReadable(json);
}

std::vector<PatchOnLink> placementsFromJson(std::string_view text, const std::string& file) {
  const nlohmann::json document = parseJson(text, file);
  const JsonReader json(document, file);
  json.requireFormat(kPlacementsFormat, kPlacementsVersion);
  std::vector<PatchOnLink> placements;
  std::set<CellId> origins;
  for (const JsonReader& item : json.at("placements").items()) {
    placements.push_back(placementFromJson(item));
    if (!origins.insert(placements.back().origin).second) {
      item.at("origin_cell").fail(message("each patch once; that of cell {} is there twice", placements.back().origin));
    }
  }
  return placements;
}

std::vector<PatchOnLink> readPlacementsJson(const std::filesystem::path& path) {
  return placementsFromJson(readFile(path), path.string());
}

}  // namespace hexoderm
