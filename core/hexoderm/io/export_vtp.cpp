#include "hexoderm/io/export_formats.h"

#include "hexoderm/base/covariance.h"
#include "hexoderm/io/export_selection.h"
#include "hexoderm/io/xml_writing.h"
#include "hexoderm/solve/metrics/patch_mesh.h"

#include <openssl/evp.h>
#include <pugixml.hpp>

#include <Eigen/Geometry>
#include <algorithm>
#include <bit>
#include <cmath>
#include <cstring>
#include <limits>
#include <utility>

namespace hexoderm {
namespace {

static_assert(std::endian::native == std::endian::little, "the file says LittleEndian and takes bytes as they are");

constexpr double kUnknown = std::numeric_limits<double>::quiet_NaN();

/// The cell arrays while they grow; one call of `add` per vertex or polygon.
class CellArrays {
 public:
  void add(const PatchReconstruction& patch, const CellPlacement& cell, std::int64_t quality,
           const SensorPlacement* sensor) {
    const SE3 T = rigid(sensor != nullptr ? sensor->T_o_s : cell.T_o_u);
    cell_id_.push_back(cell.cell.value());
    patch_.push_back(patch.id.value());
    patch_origin_.push_back(patch.origin.value());
    placed_by_.push_back(cell.placed_by == PlacedBy::Samples ? 0 : 1);
    quality_.push_back(quality);
    body_part_.push_back(cell.body_part);
    sensor_.push_back(sensor != nullptr ? sensor->name : "");
    sensor_type_.push_back(sensor != nullptr ? sensor->type : "");
    position_.insert(position_.end(), T.t.begin(), T.t.end());
    Eigen::Quaterniond q(T.R);
    if (q.w() < 0) q.coeffs() = -q.coeffs();
    for (const double value : {q.w(), q.x(), q.y(), q.z()}) orientation_.push_back(value);
    for (Eigen::Index k = 0; k < 6; ++k) {
      (k < 3 ? sigma_t_ : sigma_r_)
          .push_back(cell.cov_t_r ? std::sqrt(std::max(0.0, (*cell.cov_t_r)(k, k))) : kUnknown);
    }
  }

  std::vector<VtpArray> take() {
    return {{"cell_id", 1, std::move(cell_id_)},
            {"patch", 1, std::move(patch_)},
            {"patch_origin", 1, std::move(patch_origin_)},
            {"placed_by", 1, std::move(placed_by_)},
            {"quality", 1, std::move(quality_)},
            {"position_m", 3, std::move(position_)},
            {"orientation_wxyz", 4, std::move(orientation_)},
            {"sigma_position_m", 3, std::move(sigma_t_)},
            {"sigma_rotation_rad", 3, std::move(sigma_r_)},
            {"body_part", 1, std::move(body_part_)},
            {"sensor", 1, std::move(sensor_)},
            {"sensor_type", 1, std::move(sensor_type_)}};
  }

 private:
  std::vector<std::int64_t> cell_id_, patch_, patch_origin_, placed_by_, quality_;
  std::vector<double> position_, orientation_, sigma_t_, sigma_r_;
  std::vector<std::string> body_part_, sensor_, sensor_type_;
};

/// Points of vertices or polygons, as VTK stores cells.
struct Cells {
  std::vector<std::int64_t> connectivity;
  std::vector<std::int64_t> offsets;
  VtpSection take(std::string name) {
    return {std::move(name), {{"connectivity", 1, std::move(connectivity)}, {"offsets", 1, std::move(offsets)}}};
  }
};

/// OpenSSL counts in int: large arrays go block by block, each a whole number of base64 groups.
constexpr std::size_t kBlockGroups = std::size_t{1} << 24U;

std::string base64(std::string_view bytes) {
  std::string text;
  for (; !bytes.empty(); bytes.remove_prefix(std::min(bytes.size(), 3 * kBlockGroups))) {
    const std::string_view block = bytes.substr(0, 3 * kBlockGroups);
    std::string encoded((block.size() + 2) / 3 * 4 + 1, '\0');
    const int length =
        EVP_EncodeBlock(reinterpret_cast<unsigned char*>(encoded.data()),
                        reinterpret_cast<const unsigned char*>(block.data()), static_cast<int>(block.size()));
    text.append(encoded, 0, static_cast<std::size_t>(length));
  }
  return text;
}

/// Length as UInt64, then the values; strings end in a zero byte.
std::string arrayBytes(const VtpArray& array) {
  std::string values;
  if (const auto* strings = std::get_if<std::vector<std::string>>(&array.values)) {
    for (const std::string& value : *strings) values.append(value.c_str(), std::strlen(value.c_str()) + 1);
  } else if (const auto* doubles = std::get_if<std::vector<double>>(&array.values)) {
    values.assign(reinterpret_cast<const char*>(doubles->data()), doubles->size() * sizeof(double));
  } else {
    const auto& integers = std::get<std::vector<std::int64_t>>(array.values);
    values.assign(reinterpret_cast<const char*>(integers.data()), integers.size() * sizeof(std::int64_t));
  }
  const std::uint64_t length = values.size();
  std::string bytes(sizeof length, '\0');
  std::memcpy(bytes.data(), &length, sizeof length);
  return bytes + values;
}

const char* typeName(const VtpArray& array) {
  if (std::holds_alternative<std::vector<double>>(array.values)) return "Float64";
  return std::holds_alternative<std::vector<std::int64_t>>(array.values) ? "Int64" : "String";
}

std::size_t tuples(const VtpArray& array) {
  return std::visit([](const auto& values) { return values.size(); }, array.values) / array.components;
}

void appendArrays(pugi::xml_node parent, const std::vector<VtpArray>& arrays, bool field_data) {
  for (const VtpArray& array : arrays) {
    const bool is_string = std::holds_alternative<std::vector<std::string>>(array.values);
    // Only the numbers are DataArrays; VTK calls everything else Array.
    pugi::xml_node node = parent.append_child(is_string ? "Array" : "DataArray");
    node.append_attribute("type") = typeName(array);
    node.append_attribute("Name") = array.name.c_str();
    if (array.components != 1) node.append_attribute("NumberOfComponents") = array.components;
    if (field_data) node.append_attribute("NumberOfTuples") = tuples(array);
    node.append_attribute("format") = "binary";
    node.text() = base64(arrayBytes(array)).c_str();
  }
}

VtpArray textArray(std::string name, std::string text) {
  return {std::move(name), 1, std::vector<std::string>{std::move(text)}};
}

}  // namespace

VtpData vtpData(const Reconstruction& reconstruction, const ExportSelection& selection) {
  const PatchMesh prisms = makePatchMesh(reconstruction);
  const auto quality = worstUsedQuality(reconstruction);
  const auto qualityOf = [&](CellId cell) {
    const auto found = quality.find(cell);
    return found == quality.end() ? std::int64_t{-1} : static_cast<std::int64_t>(found->second);
  };

  std::vector<double> points;
  for (const Eigen::Vector3d& point : prisms.points) points.insert(points.end(), point.begin(), point.end());
  CellArrays cell_arrays;
  // VTK orders cell data by kind: all vertices come before all polygons.
  Cells verts;
  std::vector<std::pair<const PatchReconstruction*, const CellPlacement*>> cells;
  for (const PatchReconstruction& patch : reconstruction.patches) {
    for (const CellPlacement& cell : patch.cells) {
      cells.emplace_back(&patch, &cell);
      for (const SensorPlacement& sensor : cell.sensors) {
        verts.connectivity.push_back(static_cast<std::int64_t>(points.size() / 3));
        verts.offsets.push_back(static_cast<std::int64_t>(verts.connectivity.size()));
        points.insert(points.end(), sensor.T_o_s.t.begin(), sensor.T_o_s.t.end());
        cell_arrays.add(patch, cell, qualityOf(cell.cell), &sensor);
      }
    }
  }
  // Once a cell is enough: on every polygon these would be most of the file.
  std::vector<std::int64_t> ids;
  std::vector<double> covariances, accel_offsets, accel_scales;
  for (const auto& [patch, cell] : cells) {
    ids.push_back(cell->cell.value());
    for (Eigen::Index axis = 0; axis < 3; ++axis) {
      accel_offsets.push_back(cell->accel_offset_g ? (*cell->accel_offset_g)(axis) : kUnknown);
      accel_scales.push_back(cell->accel_scale ? (*cell->accel_scale)(axis) : kUnknown);
    }
    const auto covariance = upperTriangle(cell->cov_t_r.value_or(Matrix6d::Constant(kUnknown)));
    covariances.insert(covariances.end(), covariance.begin(), covariance.end());
  }
  Cells polys;
  for (const PatchMesh::Polygon& polygon : prisms.polygons) {
    polys.connectivity.insert(polys.connectivity.end(), polygon.points.begin(), polygon.points.end());
    polys.offsets.push_back(static_cast<std::int64_t>(polys.connectivity.size()));
    const auto& [patch, cell] = cells.at(polygon.cell);
    cell_arrays.add(*patch, *cell, qualityOf(cell->cell), nullptr);
  }

  VtpData data;
  data.points = points.size() / 3;
  data.verts = verts.offsets.size();
  data.polys = polys.offsets.size();
  data.field_data = {textArray("units", "positions in metres, rotations in radians"),
                     textArray("frame", frameText(reconstruction, selection)),
                     textArray("cell_model", reconstruction.model->name),
                     textArray("solver", reconstruction.solver),
                     textArray("verdict", std::string(verdictName(reconstruction.assessment.level))),
                     textArray("source", reconstruction.source.text.english()),
                     textArray("source_file", reconstruction.source.file),
                     textArray("source_sha256", reconstruction.source.sha256),
                     {"cells", 1, std::move(ids)},
                     {"cov_t_r", 21, std::move(covariances)},
                     {"accel_offset_g", 3, std::move(accel_offsets)},
                     {"accel_scale", 3, std::move(accel_scales)}};
  data.sections.push_back({"CellData", cell_arrays.take()});
  data.sections.push_back({"Points", {{"Points", 3, std::move(points)}}});
  data.sections.push_back(verts.take("Verts"));
  data.sections.push_back(polys.take("Polys"));
  return data;
}

std::string vtpBytes(const VtpData& data) {
  pugi::xml_document document;
  pugi::xml_node root = appendElement(
      document, "VTKFile",
      {{"type", "PolyData"}, {"version", "1.0"}, {"byte_order", "LittleEndian"}, {"header_type", "UInt64"}});
  pugi::xml_node poly_data = root.append_child("PolyData");
  appendArrays(poly_data.append_child("FieldData"), data.field_data, true);
  pugi::xml_node piece = appendElement(poly_data, "Piece",
                                       {{"NumberOfPoints", std::to_string(data.points)},
                                        {"NumberOfVerts", std::to_string(data.verts)},
                                        {"NumberOfLines", "0"},
                                        {"NumberOfStrips", "0"},
                                        {"NumberOfPolys", std::to_string(data.polys)}});
  for (const VtpSection& section : data.sections) {
    appendArrays(piece.append_child(section.name.c_str()), section.arrays, false);
  }
  return xmlText(document, " ");
}

}  // namespace hexoderm
