#include "hexoderm/util/json_reader.h"

#include "hexoderm/util/error.h"

#include <Eigen/Geometry>
#include <Eigen/LU>
#include <algorithm>
#include <cmath>

namespace hexoderm {
namespace {

std::string shortened(const nlohmann::json& value) {
  if (value.is_array()) return "an array of " + std::to_string(value.size());
  if (value.is_object()) return "an object";
  constexpr std::size_t kMost = 40;
  std::string text = value.dump(-1, ' ', true, nlohmann::json::error_handler_t::replace);
  if (text.size() > kMost) text = text.substr(0, kMost) + "...";
  return text;
}

}  // namespace

nlohmann::json parseJson(std::string_view text, const std::string& file) {
  try {
    return nlohmann::json::parse(text);
  } catch (const nlohmann::json::parse_error& error) {
    const std::string_view before = text.substr(0, std::min(error.byte == 0 ? 0 : error.byte - 1, text.size()));
    const auto line = std::count(before.begin(), before.end(), '\n') + 1;
    const std::size_t line_start = before.rfind('\n');
    const std::size_t column = before.size() - (line_start == std::string_view::npos ? 0 : line_start + 1) + 1;
    const bool at_end = error.byte > text.size();
    throw FormatError(file + ": line " + std::to_string(line) + ", column " + std::to_string(column) +
                      (at_end ? ": the file ends in the middle (truncated?), expected complete JSON"
                              : ": this is not JSON, expected a JSON value here (numbers must be finite)"));
  } catch (const nlohmann::json::out_of_range&) {
    throw FormatError(file + ": a number is too large, expected finite numbers");
  }
}

void JsonReader::fail(const std::string& expected) const {
  throw FormatError(file_ + ": " + (path_.empty() ? "top level" : path_) + ": expected " + expected + ", found " +
                    shortened(*value_));
}

JsonReader JsonReader::at(const std::string& key) const {
  if (!value_->is_object()) fail("an object");
  const auto found = value_->find(key);
  const std::string path = path_.empty() ? key : path_ + "." + key;
  if (found == value_->end()) throw FormatError(file_ + ": " + path + ": is missing");
  return {*found, file_, path};
}

std::optional<JsonReader> JsonReader::find(const std::string& key) const {
  if (!value_->is_object()) fail("an object");
  const auto found = value_->find(key);
  if (found == value_->end() || found->is_null()) return std::nullopt;
  return JsonReader(*found, file_, path_.empty() ? key : path_ + "." + key);
}

std::vector<JsonReader> JsonReader::items() const {
  if (!value_->is_array()) fail("an array");
  std::vector<JsonReader> items;
  items.reserve(value_->size());
  for (std::size_t i = 0; i < value_->size(); ++i) {
    items.emplace_back((*value_)[i], file_, path_ + "[" + std::to_string(i) + "]");
  }
  return items;
}

double JsonReader::number() const {
  if (!value_->is_number()) fail("a number");
  const auto value = value_->get<double>();
  if (!std::isfinite(value)) fail("a finite number");
  return value;
}

double JsonReader::positiveNumber() const {
  const double value = number();
  if (!(value > 0)) fail("a number above 0");
  return value;
}

double JsonReader::nonNegativeNumber() const {
  const double value = number();
  if (!(value >= 0)) fail("a number of at least 0");
  return value;
}

std::uint32_t JsonReader::unsignedInteger(std::uint32_t min, std::uint32_t max) const {
  const std::string expected = "a whole number from " + std::to_string(min) + " to " + std::to_string(max);
  if (!value_->is_number_integer()) fail(expected);
  if (!value_->is_number_unsigned() && value_->get<std::int64_t>() < 0) fail(expected);
  const auto value = value_->get<std::uint64_t>();
  if (value < min || value > max) fail(expected);
  return static_cast<std::uint32_t>(value);
}

bool JsonReader::boolean() const {
  if (!value_->is_boolean()) fail("true or false");
  return value_->get<bool>();
}

std::string JsonReader::string() const {
  if (!value_->is_string()) fail("a text");
  return value_->get<std::string>();
}

std::vector<double> JsonReader::numbers(std::size_t count) const {
  if (!value_->is_array() || value_->size() != count) fail("an array of " + std::to_string(count) + " numbers");
  std::vector<double> values;
  values.reserve(count);
  for (const JsonReader& item : items()) values.push_back(item.number());
  return values;
}

Eigen::Vector3d JsonReader::vector3() const {
  const std::vector<double> v = numbers(3);
  return {v[0], v[1], v[2]};
}

Eigen::Matrix3d JsonReader::matrix3() const {
  const std::vector<double> v = numbers(9);
  return Eigen::Map<const Eigen::Matrix<double, 3, 3, Eigen::RowMajor>>(v.data());
}

Eigen::Matrix3d JsonReader::rotation() const {
  constexpr double kTolerance = 1e-6;
  const Eigen::Matrix3d R = matrix3();
  if (!(R * R.transpose()).isIdentity(kTolerance) || std::abs(R.determinant() - 1) > kTolerance) {
    fail("a rotation matrix (row-major, orthogonal to 1e-6, determinant +1)");
  }
  return R;
}

void JsonReader::requireFormat(std::string_view format, std::uint32_t newest) const {
  const auto name = find("format");
  if (!name || !name->isString() || name->string() != format) {
    throw FormatError(file_ + ": format: expected \"" + std::string(format) + "\"" +
                      (name ? ", found " + shortened(*name->value_) : ", but there is none"));
  }
  const std::uint32_t version = at("version").unsignedInteger(1);
  if (version > newest) {
    throw FormatError(file_ + ": version: this file has version " + std::to_string(version) +
                      ", this program reads up to version " + std::to_string(newest));
  }
}

nlohmann::json toJson(const Eigen::Vector3d& v) { return {v.x(), v.y(), v.z()}; }

nlohmann::json toJson(const Eigen::Matrix3d& m) {
  return {m(0, 0), m(0, 1), m(0, 2), m(1, 0), m(1, 1), m(1, 2), m(2, 0), m(2, 1), m(2, 2)};
}

nlohmann::json quaternionWxyz(const Eigen::Matrix3d& R) {
  Eigen::Quaterniond q(R);
  q.normalize();
  if (q.w() < 0) q.coeffs() = -q.coeffs();
  return {q.w(), q.x(), q.y(), q.z()};
}

}  // namespace hexoderm
