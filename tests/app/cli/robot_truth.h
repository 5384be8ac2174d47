#pragma once

// The truth that `hexoderm-cli simulate --robot` writes beside a session.

#include <Eigen/Geometry>
#include <nlohmann/json.hpp>
#include <stdexcept>
#include <vector>

namespace hexoderm {

/// The true rotation of a cell in the frame of its link.
inline Eigen::Matrix3d trueRotation(const nlohmann::json& truth, const nlohmann::json& cell) {
  for (const auto& patch : truth.at("patches")) {
    for (const auto& placed : patch.at("cells")) {
      if (placed.at("id") != cell) continue;
      const auto R = placed.at("R").get<std::vector<double>>();
      return Eigen::Map<const Eigen::Matrix<double, 3, 3, Eigen::RowMajor>>(R.data());
    }
  }
  throw std::runtime_error("the truth holds no cell " + cell.dump());
}
/// Of a unit quaternion w, x, y, z, as the programs write it.
inline Eigen::Matrix3d rotationOf(const nlohmann::json& q) {
  return Eigen::Quaterniond(q.at(0), q.at(1), q.at(2), q.at(3)).toRotationMatrix();
}

}  // namespace hexoderm
