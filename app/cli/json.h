#pragma once

// What commands have in common where they say their results as JSON and as text.

#include "hexoderm/base/message.h"
#include "hexoderm/base/se3.h"
#include "hexoderm/base/text.h"
#include "hexoderm/base/units.h"

#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace hexoderm::cli {

using Json = nlohmann::ordered_json;

/// An array of what `say` makes of each item.
template <class Items, class Say>
Json arrayOf(const Items& items, const Say& say) {
  Json array = Json::array();
  for (const auto& item : items) array.push_back(say(item));
  return array;
}
/// The numbers of IDs.
template <class Ids>
Json numbersOf(const Ids& ids) {
  return arrayOf(ids, [](const auto& id) { return id.value(); });
}
inline Json textsOf(const std::vector<Message>& messages) {
  return arrayOf(messages, [](const Message& message) { return message.english(); });
}
/// null where there is nothing, else what `say` makes of it.
template <class Value, class Say>
Json orNull(const std::optional<Value>& value, const Say& say) {
  return value ? Json(say(*value)) : Json(nullptr);
}
inline Json orNull(const std::optional<double>& value, double factor = 1) {
  return value ? Json(*value * factor) : Json(nullptr);
}

inline Json listOf(const Eigen::Vector3d& v) { return {v.x(), v.y(), v.z()}; }
inline Json rowsOf(const Eigen::Matrix3d& M) {
  return {listOf(M.row(0).transpose()), listOf(M.row(1).transpose()), listOf(M.row(2).transpose())};
}
/// w, x, y, z.
inline Json quaternionOf(const Eigen::Matrix3d& R) {
  const Eigen::Quaterniond q(R);
  return {q.w(), q.x(), q.y(), q.z()};
}

/// The three numbers of a vector.
inline std::string inWords(const Eigen::Vector3d& v, int decimals, std::string_view separator) {
  return formatFixed(v.x(), decimals).append(separator) + formatFixed(v.y(), decimals).append(separator) +
         formatFixed(v.z(), decimals);
}
/// "1.0 2.0 3.0 deg": roll, pitch and yaw.
inline std::string rollPitchYaw(const Eigen::Matrix3d& R, int decimals) {
  return inWords(rpyFromRotation(R) / kDegree, decimals, " ") + " deg";
}

}  // namespace hexoderm::cli
