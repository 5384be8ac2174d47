#include "hexoderm/io/export_formats.h"

#include "hexoderm/base/covariance.h"
#include "hexoderm/base/csv.h"
#include "hexoderm/base/error.h"
#include "hexoderm/base/text.h"
#include "hexoderm/base/units.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

namespace hexoderm {
namespace {

// Tables without lengths.
constexpr const char* kLinks = "links.csv";
constexpr const char* kPoses = "poses.csv";
constexpr const char* kResiduals = "residuals.csv";

using Row = std::vector<CsvField>;

template <class Tag>
CsvField number(StrongId<Tag> id) {
  return std::uint64_t{id.value()};
}
CsvField flag(bool value) { return std::uint64_t{value ? 1U : 0U}; }
CsvField degrees(double angle_rad) { return toDegrees(angle_rad); }
CsvField degrees(const std::optional<double>& angle_rad) {
  if (!angle_rad) return {};
  return toDegrees(*angle_rad);
}
CsvField text(std::string_view value) {
  if (value.empty()) return {};
  return std::string(value);
}

template <class Vector>
void append(Row& row, const Vector& values) {
  for (const double value : values) row.emplace_back(value);
}

void appendRotation(Row& row, const Eigen::Matrix3d& R) {
  Eigen::Quaterniond q(projectToSO3(R));
  if (q.w() < 0) q.coeffs() = -q.coeffs();
  for (const double value : {q.w(), q.x(), q.y(), q.z()}) row.emplace_back(value);
}

void appendSigmas(Row& row, const std::optional<Matrix6d>& cov_t_r) {
  for (Eigen::Index k = 0; k < 6; ++k) {
    if (!cov_t_r) {
      row.emplace_back();
      continue;
    }
    const double sigma = std::sqrt(std::max(0.0, (*cov_t_r)(k, k)));
    row.emplace_back(k < 3 ? sigma : toDegrees(sigma));
  }
}

CsvTable cellTable(const Reconstruction& reconstruction) {
  CsvTable table{"cells.csv",
                 split("patch,patch_origin_cell,cell,body_part,placed_by,x_m,y_m,z_m,qw,qx,qy,qz,sigma_x_m,"
                       "sigma_y_m,sigma_z_m,sigma_rx_deg,sigma_ry_deg,sigma_rz_deg,shape_sigma_x_m,"
                       "shape_sigma_y_m,shape_sigma_z_m,shape_sigma_rx_deg,shape_sigma_ry_deg,shape_sigma_rz_deg,"
                       "accel_offset_x_g,accel_offset_y_g,accel_offset_z_g,accel_scale_x,accel_scale_y,"
                       "accel_scale_z,predecessor",
                       ','),
                 {}};
  for (const PatchReconstruction& patch : reconstruction.patches) {
    for (const CellPlacement& cell : patch.cells) {
      Row row{number(patch.id), number(patch.origin), number(cell.cell), text(cell.body_part),
              std::string(cell.placed_by == PlacedBy::Samples ? "samples" : "links")};
      append(row, cell.T_o_u.t);
      appendRotation(row, cell.T_o_u.R);
      for (const std::optional<Matrix6d>& covariance : {cell.cov_t_r, cell.shape_cov_t_r}) {
        appendSigmas(row, covariance);
      }
      for (const std::optional<Eigen::Vector3d>& values : {cell.accel_offset_g, cell.accel_scale}) {
        if (values) {
          append(row, *values);
        } else {
          row.resize(row.size() + 3);
        }
      }
      row.push_back(cell.predecessor ? number(*cell.predecessor) : CsvField());
      table.rows.push_back(std::move(row));
    }
  }
  return table;
}

/// The upper triangle of each cell's covariance, in SI units throughout: a covariance mixes positions and rotations.
CsvTable covarianceTable(const Reconstruction& reconstruction) {
  constexpr std::array kAxes = {"x", "y", "z", "rx", "ry", "rz"};
  CsvTable table{"covariances.csv", {"patch", "patch_origin_cell", "cell"}, {}};
  for (std::size_t i = 0; i < 6; ++i) {
    for (std::size_t j = i; j < 6; ++j) {
      const char* unit = j < 3 ? "_m2" : i < 3 ? "_m_rad" : "_rad2";
      table.header.push_back("cov_" + std::string(kAxes.at(i)) + "_" + kAxes.at(j) + unit);
    }
  }
  for (const PatchReconstruction& patch : reconstruction.patches) {
    for (const CellPlacement& cell : patch.cells) {
      Row row{number(patch.id), number(patch.origin), number(cell.cell)};
      if (cell.cov_t_r) append(row, upperTriangle(*cell.cov_t_r));
      row.resize(table.header.size());
      table.rows.push_back(std::move(row));
    }
  }
  return table;
}

CsvTable sensorTable(const Reconstruction& reconstruction) {
  CsvTable table{"sensors.csv",
                 {"patch", "patch_origin_cell", "cell", "sensor", "type", "x_m", "y_m", "z_m", "qw", "qx", "qy", "qz"},
                 {}};
  for (const PatchReconstruction& patch : reconstruction.patches) {
    for (const CellPlacement& cell : patch.cells) {
      for (const SensorPlacement& sensor : cell.sensors) {
        Row row{number(patch.id), number(patch.origin), number(cell.cell), text(sensor.name), text(sensor.type)};
        append(row, sensor.T_o_s.t);
        appendRotation(row, sensor.T_o_s.R);
        table.rows.push_back(std::move(row));
      }
    }
  }
  return table;
}

CsvTable linkTable(const Reconstruction& reconstruction) {
  CsvTable table{kLinks,
                 split("patch,source_cell,source_port,target_cell,target_port,quality,used,muted_by,in_tree,"
                       "centred,supported,weight,singular_1,singular_2,singular_3,residual_deg,sigma_deg,bend_deg,"
                       "twist_deg,yaw_deg,qw_source_target,qx_source_target,qy_source_target,qz_source_target",
                       ','),
                 {}};
  for (const PatchReconstruction& patch : reconstruction.patches) {
    for (const LinkEstimate& link : patch.links) {
      Row row{number(patch.id),         number(link.source.cell),
              number(link.source.port), number(link.target.cell),
              number(link.target.port), std::string(qualityName(link.quality)),
              flag(link.used),          text(link.muted_by ? codeName(*link.muted_by) : std::string_view()),
              flag(link.in_tree),       flag(link.centred),
              flag(link.supported),     link.weight};
      append(row, link.singular_values);
      for (const double angle_rad : {link.residual_rad, link.sigma_rad, link.bend_rad, link.twist_rad, link.yaw_rad}) {
        row.push_back(degrees(angle_rad));
      }
      appendRotation(row, link.R_c_n);
      table.rows.push_back(std::move(row));
    }
  }
  return table;
}

/// One row a pose; the up direction of each patch stands in columns of its own.
CsvTable poseTable(const Reconstruction& reconstruction) {
  CsvTable table{kPoses, {"pose", "label", "enabled", "cells_measured", "noise_g", "new_by_deg", "residual_deg"}, {}};
  for (const PatchReconstruction& patch : reconstruction.patches) {
    const std::string prefix = "patch" + toString(patch.id) + "_up_";
    for (const char* name : {"x", "y", "z", "sigma_deg"}) table.header.push_back(prefix + name);
  }
  for (const PoseSummary& pose : reconstruction.poses) {
    Row row{
        number(pose.pose), text(pose.label.english()), flag(pose.enabled),        std::uint64_t{pose.cells_measured},
        pose.noise_g,      degrees(pose.new_by_rad),   degrees(pose.residual_rad)};
    for (const PatchReconstruction& patch : reconstruction.patches) {
      const auto gravity = std::ranges::find(patch.gravity, pose.pose, &GravityDirection::pose);
      if (gravity == patch.gravity.end() || !pose.enabled) {
        row.resize(row.size() + 4);
        continue;
      }
      append(row, gravity->g_o);
      row.push_back(degrees(gravity->sigma_rad));
    }
    table.rows.push_back(std::move(row));
  }
  return table;
}

CsvTable residualTable(const Reconstruction& reconstruction) {
  CsvTable table{kResiduals, {"source_cell", "source_port", "target_cell", "target_port"}, {}};
  for (const PoseSummary& pose : reconstruction.poses) table.header.push_back("pose" + toString(pose.pose) + "_deg");
  for (const PatchReconstruction& patch : reconstruction.patches) {
    for (const LinkEstimate& link : patch.links) {
      Row row{number(link.source.cell), number(link.source.port), number(link.target.cell), number(link.target.port)};
      for (std::size_t p = 0; p < reconstruction.poses.size(); ++p) {
        row.push_back(p < link.pose_residual_rad.size() ? degrees(link.pose_residual_rad[p]) : CsvField());
      }
      table.rows.push_back(std::move(row));
    }
  }
  return table;
}

std::string fieldText(const CsvField& field) {
  if (const auto* value = std::get_if<std::string>(&field)) return csvQuoted(*value);
  if (const auto* value = std::get_if<std::uint64_t>(&field)) return std::to_string(*value);
  if (const auto* value = std::get_if<double>(&field)) return formatExact(*value);
  return {};
}

/// A table could hold such a number, but no reader could use it.
void requireFinite(const CsvTable& table, std::size_t row, std::size_t column) {
  const auto* value = std::get_if<double>(&table.rows[row][column]);
  if (value == nullptr || std::isfinite(*value)) return;
  throw InvalidArgument(table.file,
                        message("row {}, {} is not a finite number, nothing written", row + 1, table.header[column]));
}

}  // namespace

CsvContents csvContents(std::string_view file) {
  if (file == kLinks || file == kResiduals) return {false, false};
  return {file != kPoses, true};
}

std::vector<CsvTable> csvTables(const Reconstruction& reconstruction) {
  return {cellTable(reconstruction), sensorTable(reconstruction),   linkTable(reconstruction),
          poseTable(reconstruction), residualTable(reconstruction), covarianceTable(reconstruction)};
}

std::string csvText(const CsvTable& table) {
  std::string result;
  for (std::size_t k = 0; k < table.header.size(); ++k) result += (k == 0 ? "" : ",") + csvQuoted(table.header[k]);
  result += '\n';
  for (std::size_t row = 0; row < table.rows.size(); ++row) {
    for (std::size_t k = 0; k < table.rows[row].size(); ++k) {
      requireFinite(table, row, k);
      if (k > 0) result += ',';
      result += fieldText(table.rows[row][k]);
    }
    result += '\n';
  }
  return result;
}

}  // namespace hexoderm
