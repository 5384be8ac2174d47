#pragma once

#include <Eigen/Core>
#include <Qt>
#include <optional>

namespace hexoderm {

/// Where an arrow key points, to the right and up; none of other keys.
inline std::optional<Eigen::Vector2d> directionOfKey(int key) {
  switch (key) {
    case Qt::Key_Left:
      return Eigen::Vector2d(-1, 0);
    case Qt::Key_Right:
      return Eigen::Vector2d(1, 0);
    case Qt::Key_Up:
      return Eigen::Vector2d(0, 1);
    case Qt::Key_Down:
      return Eigen::Vector2d(0, -1);
    default:
      return std::nullopt;
  }
}

}  // namespace hexoderm
