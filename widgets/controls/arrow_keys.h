#pragma once

#include <Eigen/Core>
#include <Qt>
#include <map>
#include <optional>

namespace hexoderm {

/// Where an arrow key points, to the right and up; none of other keys.
inline std::optional<Eigen::Vector2d> directionOfKey(int key) {
  static const std::map<int, Eigen::Vector2d> kDirections = {
      {Qt::Key_Left, {-1, 0}}, {Qt::Key_Right, {1, 0}}, {Qt::Key_Up, {0, 1}}, {Qt::Key_Down, {0, -1}}};
  const auto found = kDirections.find(key);
  return found == kDirections.end() ? std::nullopt : std::optional(found->second);
}

}  // namespace hexoderm
