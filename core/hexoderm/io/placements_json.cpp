#include "hexoderm/io/placements_json.h"

#include "hexoderm/session/session_parts_json.h"
#include "hexoderm/util/error.h"
#include "hexoderm/util/file.h"
#include "hexoderm/util/json_reader.h"

#include <set>

namespace hexoderm {
namespace {

nlohmann::ordered_json placeJson(const PatchOnLink& place) {
  nlohmann::ordered_json json = {{"origin_cell", place.origin.value()}, {"link", place.link}};
  writePlace(place, json);
  return json;
}

PatchOnLink placeFromJson(const JsonReader& json) {
  PatchOnLink place;
  place.origin = CellId(json.at("origin_cell").unsignedInteger(1));
  place.link = json.at("link").string();
  if (place.link.empty()) json.at("link").fail(message("the name of a link"));
  readPlace(json, place);
  return place;
}

}  // namespace

std::string placementsToJson(const std::vector<PatchOnLink>& placements) {
  nlohmann::ordered_json json = {
      {"format", kPlacementsFormat}, {"version", kPlacementsVersion}, {"placements", nlohmann::ordered_json::array()}};
  for (const PatchOnLink& place : placements) json["placements"].push_back(placeJson(place));
  return dumpReadable(json);
}

std::vector<PatchOnLink> placementsFromJson(std::string_view text, const std::string& file) {
  const nlohmann::json document = parseJson(text, file);
  const JsonReader json(document, file);
  json.requireFormat(kPlacementsFormat, kPlacementsVersion);
  std::vector<PatchOnLink> placements;
  std::set<CellId> origins;
  for (const JsonReader& item : json.at("placements").items()) {
    placements.push_back(placeFromJson(item));
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
