#pragma once

// The truth that `hexoderm-cli simulate --robot` writes beside a session.

#include <Eigen/Geometry>
#include <nlohmann/json.hpp>
#include <stdexcept>
#include <vector>

namespace hexoderm {

/// Of nine numbers, row by row.
inline Eigen::Matrix3d matrixOf(const nlohmann::json& numbers) {
  const auto R = numbers.get<std::vector<double>>();
  return Eigen::Map<const Eigen::Matrix<double, 3, 3, Eigen::RowMajor>>(R.data());
}

inline Eigen::Vector3d vectorOf(const nlohmann::json& numbers) {
  const auto t = numbers.get<std::vector<double>>();
  return {t.at(0), t.at(1), t.at(2)};
}

/// The true rotation of a cell in the frame of its link.
inline Eigen::Matrix3d trueRotation(const nlohmann::json& truth, const nlohmann::json& cell) {
  for (const auto& patch : truth.at("patches")) {
    for (const auto& placed : patch.at("cells")) {
      if (placed.at("id") == cell) return matrixOf(placed.at("R"));
    }
  }
  throw std::runtime_error("the truth holds no cell " + cell.dump());
}
/// Of a unit quaternion w, x, y, z, as the programs write it.
inline Eigen::Matrix3d rotationOf(const nlohmann::json& q) {
  return Eigen::Quaterniond(q.at(0), q.at(1), q.at(2), q.at(3)).toRotationMatrix();
}

}  // namespace hexoderm
