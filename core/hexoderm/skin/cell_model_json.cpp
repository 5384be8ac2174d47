#include "hexoderm/skin/cell_model_json.h"

#include "hexoderm/base/error.h"
#include "hexoderm/base/file.h"
#include "hexoderm/base/json_fields.h"
#include "hexoderm/base/text.h"
#include "hexoderm/skin/built_in_models.h"
#include "hexoderm/skin/cell_lengths.h"

#include <Eigen/Geometry>
#include <algorithm>

namespace hexoderm {
namespace {

/// Written beside a quaternion that differs from the matrix in the last digits when it is read back, so that a saved
/// model is exactly the same when it is opened again.
constexpr std::string_view kExactRotation = "R_u";

/// validate() refuses what is longer too, but does not know the place in the file.
struct Length : AsItIs {
  double least_m;
  explicit Length(double least = 0) : least_m(least) {}
  void take(const JsonReader& in, double& length_m) const {
    length_m = in.nonNegativeNumber();
    if (length_m < least_m || length_m > kMaxCellLength_m) {
      in.fail(message("a length in metres, from {} to {}", Number{least_m}, Number{kMaxCellLength_m}));
    }
  }
};

/// Two ports that can't be joined.
struct AsPortPair {
  using Pair = std::pair<PortNumber, PortNumber>;
  void take(const JsonReader& in, std::vector<Pair>& pairs) const {
    for (const JsonReader& pair : in.items()) {
      const std::vector<JsonReader> ports = pair.items();
      if (ports.size() != 2) pair.fail(message("two port numbers"));
      pairs.emplace_back(ports[0].unsignedInteger(1), ports[1].unsignedInteger(1));
    }
  }
  void put(JsonWriter& out, const std::vector<Pair>& pairs) const {
    out.array(pairs, [&](const Pair& pair) {
      out.array(std::array{pair.first, pair.second}, [&](PortNumber port) { out.value(port); });
    });
  }
};

/// The fields of something that is placed, of which no others may be there.
template <class Json, class Placement, class... Before>
void placedFields(Json& json, Placement& T_u, Before... before) {
  const auto exact = [&T_u]() -> std::optional<Eigen::Matrix3d> {
    const auto [w, x, y, z] = quaternionWxyz(T_u.R);
    const Eigen::Matrix3d read = Eigen::Quaterniond(w, x, y, z).normalized().toRotationMatrix();
    return read == T_u.R ? std::nullopt : std::optional(T_u.R);
  };
  json.strictObject(before..., defaultedField("t_u_m", T_u.t), defaultedField("q_u_wxyz", T_u.R, AsQuaternion()),
                    derivedField(kExactRotation, exact, [&T_u](auto& in) { T_u.R = in.rotation(); }));
}

/// One number for all axes, or three.
struct AsPerAxis {
  void take(const JsonReader& in, Eigen::Vector3d& sigmas) const {
    if (in.isArray()) return kNonNegativeVector.take(in, sigmas);
    sigmas.setConstant(in.nonNegativeNumber());
  }
  void put(JsonWriter& out, const Eigen::Vector3d& sigmas) const {
    (sigmas.array() == sigmas[0]).all() ? out.value(sigmas[0]) : out.value(sigmas);
  }
};

/// As models had it at first: the lot's part of offset_sigma_g.
void takeSharedPart(const JsonReader& in, Accelerometer& a) {
  const double shared_g = in.nonNegativeNumber();
  if (const double least_g = a.offset_sigma_g.minCoeff(); shared_g > least_g) {
    in.fail(message("at most offset_sigma_g, of which it is a part: {}", Number{least_g}));
  }
  a.offset_shared_sigma_g = shared_g;
  a.offset_sigma_g = (a.offset_sigma_g.array().square() - shared_g * shared_g).sqrt();
}

template <class Json, class Model>
void modelFields(Json& json, Model& model) {
  const auto port = [](auto& item, auto& of_cell) {
    item.strictObject(requiredField("port", of_cell.number, wholeFrom(1)), requiredField("vector_m", of_cell.vector_m));
  };
  const auto sensor = [](auto& item, auto& of_cell) {
    placedFields(item, of_cell.T_u_s, requiredField("name", of_cell.name), requiredField("type", of_cell.type));
  };
  const auto accelerometer = [](auto& item, auto& a) {
    placedFields(item, a.T_u_a, requiredField("range_g", a.range_g, kPositive),
                 requiredField("lsb_g", a.lsb_g, kNonNegative), requiredField("rate_hz", a.rate_hz, kPositive),
                 requiredField("noise_g_per_sqrt_hz", a.noise_g_per_sqrt_hz, kNonNegative),
                 requiredField("offset_sigma_g", a.offset_sigma_g, AsPerAxis()),
                 optionalField("offset_shared_sigma_g", a.offset_shared_sigma_g, kNonNegative),
                 requiredField("scale_sigma", a.scale_sigma, kNonNegative),
                 optionalField("scale_shared_sigma", a.scale_shared_sigma, kNonNegative),
                 defaultedField("cross_axis_sigma", a.cross_axis_sigma, kNonNegative),
                 defaultedField("offset_drift_sigma_g", a.offset_drift_sigma_g, kNonNegative),
                 defaultedField("offset_drift_shared_sigma_g", a.offset_drift_shared_sigma_g, kNonNegative),
                 defaultedField("offset_instability_sigma_g", a.offset_instability_sigma_g, kNonNegative),
                 defaultedField("offset_instability_shared_sigma_g", a.offset_instability_shared_sigma_g, kNonNegative),
                 derivedField(
                     "shared_offset_sigma_g", [] { return std::optional<double>(); },
                     [&a](auto& in) { takeSharedPart(in, a); }));
  };
  json.strictObject(requiredField("name", model.name), requiredField("side_m", model.side_m, Length(kMinCellSide_m)),
                    requiredField("thickness_m", model.thickness_m, Length()),
                    requiredField("gap_m", model.gap_m, Length()), requiredField("ports", model.ports, Described{port}),
                    requiredField("interface_id", model.interface_id, wholeFrom(1)),
                    requiredField("accelerometer", model.accelerometer, Described{accelerometer}),
                    defaultedField("sensors", model.sensors, Described{sensor}),
                    optionalField("forbidden_port_pairs", model.forbidden_port_pairs, AsPortPair()),
                    defaultedField("mounting_sigma_rad", model.mounting_sigma_rad, kNonNegative),
                    defaultedField("side_angle_rad", model.side_angle_rad),
                    defaultedField("link_sigma_m", model.link_sigma_m, kPositive),
                    defaultedField("bend_sigma_rad", model.bend_sigma_rad, kPositive),
                    defaultedField("twist_sigma_rad", model.twist_sigma_rad, kPositive),
                    defaultedField("yaw_sigma_rad", model.yaw_sigma_rad, kPositive));
}

}  // namespace

CellModel readCellModel(const JsonReader& json) {
  CellModel model;
  modelFields(json, model);
  if (!json.at("accelerometer").find("cross_axis_sigma")) {
    // A sensor whose scale is calibrated has calibrated axes too: the default keeps its ratio to an uncalibrated
    // sensor's scale.
    constexpr double kLargestShareOfScale = 0.25;
    Accelerometer& a = model.accelerometer;
    a.cross_axis_sigma = std::min(a.cross_axis_sigma, kLargestShareOfScale * a.scale_sigma);
  }
  try {
    model.validate();
  } catch (const InvalidArgument& error) {
    json.fail(message("a cell model that makes sense ({})", error.message()));
  }
  return model;
}

CellModel cellModelFromJson(std::string_view text, const std::string& file) {
  const JsonDocument document = parseJson(text, file);
  return readCellModel(JsonReader(document));
}

void writeCellModel(const CellModel& model, JsonWriter& json) { modelFields(json, model); }

std::string cellModelToJson(const CellModel& model) {
  return jsonText([&](JsonWriter& json) { writeCellModel(model, json); });
}

CellModel builtInCellModel(std::string_view name) {
  for (const BuiltInModel& model : builtInModels()) {
    if (model.name == name) return cellModelFromJson(model.json, "built-in cell model " + std::string(name));
  }
  std::string known;
  for (const std::string& other : builtInCellModelNames()) known += " " + other;
  throw InvalidArgument(message("there is no built-in cell model \"{}\"; there are:{}", excerptOf(name), known));
}

std::vector<std::string> builtInCellModelNames() {
  std::vector<std::string> names;
  for (const BuiltInModel& model : builtInModels()) names.emplace_back(model.name);
  return names;
}

CellModel loadCellModel(const std::string& name_or_path) {
  const std::vector<std::string> names = builtInCellModelNames();
  if (std::ranges::find(names, name_or_path) != names.end()) return builtInCellModel(name_or_path);
  std::error_code unknown;
  if (!std::filesystem::exists(name_or_path, unknown) && !unknown) {
    throw StorageError(
        located(name_or_path, message("there is no such file, nor such a built-in cell model; built in: {}", names)));
  }
  return cellModelFromJson(readFile(name_or_path), name_or_path);
}

}  // namespace hexoderm
