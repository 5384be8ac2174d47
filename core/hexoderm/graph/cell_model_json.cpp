#include "hexoderm/graph/cell_model_json.h"

#include "hexoderm/graph/built_in_models.h"
#include "hexoderm/graph/cell_lengths.h"
#include "hexoderm/util/error.h"
#include "hexoderm/util/file.h"
#include "hexoderm/util/text.h"

#include <Eigen/Geometry>
#include <algorithm>

namespace hexoderm {
namespace {

/// Written beside a quaternion that differs from the matrix in the last digits when it is read back, so that a saved
/// model is exactly the same when it is opened again.
const std::string kExactRotation = "R_u";

/// validate() refuses what is longer too, but does not know the place in the file.
double readLength(const JsonReader& json, double least_m) {
  const double length_m = json.nonNegativeNumber();
  if (length_m < least_m || length_m > kMostCellLength_m) {
    json.fail(message("a length in metres, from {} to {}", Number{least_m}, Number{kMostCellLength_m}));
  }
  return length_m;
}

SE3 readPlacement(const JsonReader& json, const std::string& t_key, const std::string& q_key) {
  SE3 T;
  if (const auto t = json.find(t_key)) T.t = t->vector3();
  if (const auto q = json.find(q_key)) T.R = q->unitQuaternion().toRotationMatrix();
  if (const auto R = json.find(kExactRotation)) T.R = R->rotation();
  return T;
}

void addPlacement(const SE3& T_u, nlohmann::ordered_json& json) {
  json["t_u_m"] = toJson(T_u.t);
  json["q_u_wxyz"] = quaternionWxyz(T_u.R);
  const nlohmann::json written = json["q_u_wxyz"];
  if (JsonReader(written, "").unitQuaternion().toRotationMatrix() != T_u.R) json[kExactRotation] = toJson(T_u.R);
}

Accelerometer readAccelerometer(const JsonReader& json) {
  json.requireKeys({"range_g", "lsb_g", "rate_hz", "noise_g_per_sqrt_hz", "offset_sigma_g", "shared_offset_sigma_g",
                    "scale_sigma", "cross_axis_sigma", "t_u_m", "q_u_wxyz", kExactRotation});
  Accelerometer a;
  a.range_g = json.at("range_g").positiveNumber();
  a.lsb_g = json.at("lsb_g").nonNegativeNumber();
  a.rate_hz = json.at("rate_hz").positiveNumber();
  a.noise_g_per_sqrt_hz = json.at("noise_g_per_sqrt_hz").nonNegativeNumber();
  a.offset_sigma_g = json.at("offset_sigma_g").nonNegativeNumber();
  if (const auto sigma = json.find("shared_offset_sigma_g")) a.shared_offset_sigma_g = sigma->nonNegativeNumber();
  a.scale_sigma = json.at("scale_sigma").nonNegativeNumber();
  if (const auto sigma = json.find("cross_axis_sigma")) {
    a.cross_axis_sigma = sigma->nonNegativeNumber();
  } else {
    // A sensor whose scale is calibrated has calibrated axes too: the default keeps its ratio to an uncalibrated
    // sensor's scale.
    constexpr double kLargestShareOfScale = 0.25;
    a.cross_axis_sigma = std::min(a.cross_axis_sigma, kLargestShareOfScale * a.scale_sigma);
  }
  a.T_u_a = readPlacement(json, "t_u_m", "q_u_wxyz");
  return a;
}

}  // namespace

CellModel readCellModel(const JsonReader& json) {
  json.requireKeys({"name", "side_m", "thickness_m", "gap_m", "ports", "interface_id", "accelerometer", "sensors",
                    "forbidden_port_pairs", "side_angle_rad", "link_sigma_m", "bend_sigma_rad", "twist_sigma_rad",
                    "yaw_sigma_rad"});
  CellModel model;
  model.name = json.at("name").string();
  model.side_m = readLength(json.at("side_m"), kLeastCellSide_m);
  model.thickness_m = readLength(json.at("thickness_m"), 0);
  model.gap_m = readLength(json.at("gap_m"), 0);
  for (const JsonReader& port : json.at("ports").items()) {
    port.requireKeys({"port", "vector_m"});
    model.ports.push_back({PortNumber(port.at("port").unsignedInteger(1)), port.at("vector_m").vector3()});
  }
  model.interface_id = CellId(json.at("interface_id").unsignedInteger(1));
  model.accelerometer = readAccelerometer(json.at("accelerometer"));
  if (const auto sensors = json.find("sensors")) {
    for (const JsonReader& sensor : sensors->items()) {
      sensor.requireKeys({"name", "type", "t_u_m", "q_u_wxyz", kExactRotation});
      model.sensors.push_back(
          {sensor.at("name").string(), sensor.at("type").string(), readPlacement(sensor, "t_u_m", "q_u_wxyz")});
    }
  }
  if (const auto pairs = json.find("forbidden_port_pairs")) {
    for (const JsonReader& pair : pairs->items()) {
      const std::vector<JsonReader> ports = pair.items();
      if (ports.size() != 2) pair.fail(message("two port numbers"));
      model.forbidden_port_pairs.emplace_back(ports[0].unsignedInteger(1), ports[1].unsignedInteger(1));
    }
  }
  if (const auto angle = json.find("side_angle_rad")) model.side_angle_rad = angle->number();
  const auto sigma = [&](const std::string& key, double fallback) {
    const auto value = json.find(key);
    return value ? value->positiveNumber() : fallback;
  };
  model.link_sigma_m = sigma("link_sigma_m", model.link_sigma_m);
  model.bend_sigma_rad = sigma("bend_sigma_rad", model.bend_sigma_rad);
  model.twist_sigma_rad = sigma("twist_sigma_rad", model.twist_sigma_rad);
  model.yaw_sigma_rad = sigma("yaw_sigma_rad", model.yaw_sigma_rad);
  try {
    model.validate();
  } catch (const InvalidArgument& error) {
    json.fail(message("a cell model that makes sense ({})", error.message()));
  }
  return model;
}

CellModel cellModelFromJson(std::string_view text, const std::string& file) {
  const nlohmann::json json = parseJson(text, file);
  return readCellModel(JsonReader(json, file));
}

nlohmann::ordered_json cellModelJson(const CellModel& model) {
  nlohmann::ordered_json json;
  json["name"] = model.name;
  json["side_m"] = model.side_m;
  json["thickness_m"] = model.thickness_m;
  json["gap_m"] = model.gap_m;
  json["ports"] = nlohmann::ordered_json::array();
  for (const Port& port : model.ports) {
    json["ports"].push_back({{"port", port.number.value()}, {"vector_m", toJson(port.vector_m)}});
  }
  json["interface_id"] = model.interface_id.value();
  const Accelerometer& a = model.accelerometer;
  json["accelerometer"] = {{"range_g", a.range_g},
                           {"lsb_g", a.lsb_g},
                           {"rate_hz", a.rate_hz},
                           {"noise_g_per_sqrt_hz", a.noise_g_per_sqrt_hz},
                           {"offset_sigma_g", a.offset_sigma_g},
                           {"scale_sigma", a.scale_sigma},
                           {"cross_axis_sigma", a.cross_axis_sigma}};
  if (a.shared_offset_sigma_g > 0) json["accelerometer"]["shared_offset_sigma_g"] = a.shared_offset_sigma_g;
  addPlacement(a.T_u_a, json["accelerometer"]);
  json["sensors"] = nlohmann::ordered_json::array();
  for (const CellSensor& sensor : model.sensors) {
    nlohmann::ordered_json entry = {{"name", sensor.name}, {"type", sensor.type}};
    addPlacement(sensor.T_u_s, entry);
    json["sensors"].push_back(std::move(entry));
  }
  if (!model.forbidden_port_pairs.empty()) {
    json["forbidden_port_pairs"] = nlohmann::ordered_json::array();
    for (const auto& [a_port, b_port] : model.forbidden_port_pairs) {
      json["forbidden_port_pairs"].push_back({a_port.value(), b_port.value()});
    }
  }
  json["side_angle_rad"] = model.side_angle_rad;
  json["link_sigma_m"] = model.link_sigma_m;
  json["bend_sigma_rad"] = model.bend_sigma_rad;
  json["twist_sigma_rad"] = model.twist_sigma_rad;
  json["yaw_sigma_rad"] = model.yaw_sigma_rad;
  return json;
}

std::string cellModelToJson(const CellModel& model) { return dumpReadable(cellModelJson(model)); }

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
