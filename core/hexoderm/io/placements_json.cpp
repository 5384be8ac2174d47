#include "hexoderm/io/placements_json.h"

#include "hexoderm/base/file.h"
#include "hexoderm/session/session_parts_json.h"

#include <set>

namespace hexoderm {
namespace {

template <class Json, class Place>
void linkPlaceFields(Json& json, Place& place) {
  placeFields(json, place, requiredField("origin_cell", place.origin, wholeFrom(1)), requiredField("link", place.link));
}

}  // namespace

std::string placementsToJson(const std::vector<PatchOnLink>& placements) {
  return jsonText([&](JsonWriter& json) {
    json.beginObject();
    json.member("format", kPlacementsFormat);
    json.member("version", kPlacementsVersion);
    json.arrayMember("placements", placements, [&](const PatchOnLink& place) { linkPlaceFields(json, place); });
    json.endObject();
  });
}

std::vector<PatchOnLink> placementsFromJson(std::string_view text, const std::string& file) {
  const JsonDocument document = parseJson(text, file);
  const JsonReader json(document);
  json.requireFormat(kPlacementsFormat, kPlacementsVersion);
  std::vector<PatchOnLink> placements;
  std::set<CellId> origins;
  for (const JsonReader& item : json.at("placements").items()) {
    PatchOnLink& place = placements.emplace_back();
    linkPlaceFields(item, place);
    if (place.link.empty()) item.failAt("link", message("the name of a link"));
    requireOriginOnce(item, place.origin, origins);
  }
  return placements;
}

std::vector<PatchOnLink> readPlacementsJson(const std::filesystem::path& path) {
  return placementsFromJson(readFile(path), path.string());
}

}  // namespace hexoderm
