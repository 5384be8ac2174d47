#pragma once

#include "hexoderm/base/message.h"

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <array>
#include <cstddef>
#include <cstdint>
#include <initializer_list>
#include <limits>
#include <nlohmann/json.hpp>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace hexoderm {

/// What is read of a document at most. With its bytes it bounds the memory of what is read: a value takes less than 100
/// bytes beside its text.
inline constexpr std::size_t kMaxJsonLevels = 100;
inline constexpr std::size_t kMaxJsonValues = 20'000'000;
/// Of a session or a calibration, as kMaxSkinBytes.
inline constexpr std::size_t kMaxSkinValues = 60'000'000;

/// Of the magnitude of a number, which is finite.
inline constexpr double kNoLimit = std::numeric_limits<double>::max();

/// A document, and the name of its file in complaints.
struct JsonDocument {
  nlohmann::json root;
  std::string file;
};

/// Parses JSON text. Throws FormatError with line, column and key path for what is not JSON, and with the key path for
/// a key that is there twice and for what is larger than the limits above.
JsonDocument parseJson(std::string_view text, const std::string& file, std::size_t most_values = kMaxJsonValues);

/// The text's top-level "format" without parsing the rest; nullopt if there is none before the text ends or stops being
/// JSON.
std::optional<std::string> findJsonFormat(std::string_view text);

/// A value of a document, which names file, key path and expectation in every complaint:
/// "arm.session.json: cells[3].ports[0].port: expected a whole number from 1 to 4294967295, found "two"".
/// The document must outlive it. Only for use in .cpp files: it carries nlohmann's header.
class JsonReader {
 public:
  /// The whole document.
  explicit JsonReader(const JsonDocument& document) : JsonReader(&document, &document.root) {}

  [[nodiscard]] JsonReader at(std::string_view key) const;                   ///< must be there
  [[nodiscard]] std::optional<JsonReader> find(std::string_view key) const;  ///< absent or null: nullopt
  [[nodiscard]] std::vector<JsonReader> items() const;                       ///< items of an array
  /// Throws FormatError for the first key of an object that is none of these, and names that which was meant.
  void requireKeys(std::initializer_list<std::string_view> known) const;
  [[nodiscard]] bool isObject() const { return value_->is_object(); }
  [[nodiscard]] bool isArray() const { return value_->is_array(); }
  [[nodiscard]] bool isString() const { return value_->is_string(); }
  [[nodiscard]] bool isNull() const { return value_->is_null(); }

  /// An object of fields (json_fields.h), and of others that are passed over.
  template <class... Fields>
  void object(Fields... fields) const {
    (fields.takeFrom(*this), ...);
  }
  /// The same, and throws as requireKeys() for others.
  template <class... Fields>
  void strictObject(Fields... fields) const {
    requireKeys({fields.key...});
    object(std::move(fields)...);
  }

  [[nodiscard]] double number(double most = kNoLimit) const;  ///< finite, at most `most` in magnitude
  [[nodiscard]] double positiveNumber() const;
  [[nodiscard]] double nonNegativeNumber() const;
  [[nodiscard]] std::uint32_t unsignedInteger(std::uint32_t min = 0, std::uint32_t max = UINT32_MAX) const;
  [[nodiscard]] std::int64_t integer() const;  ///< a signed integer of 64 bits
  [[nodiscard]] bool boolean() const;
  [[nodiscard]] std::string string() const;
  /// An array of exactly so many.
  template <std::size_t Count>
  [[nodiscard]] std::array<double, Count> numbers(double most = kNoLimit) const {
    std::array<double, Count> values{};
    readNumbers(values, most);
    return values;
  }
  [[nodiscard]] Eigen::Vector3d vector3(double most = kNoLimit) const;
  [[nodiscard]] Eigen::Matrix3d rotation() const;           ///< nine numbers, row-major, orthogonal to 1e-6, det +1
  [[nodiscard]] Eigen::Quaterniond unitQuaternion() const;  ///< four numbers w, x, y, z of norm 1 (to 1e-6); normalised

  /// Checks `"format": format` and that the version's major number is not newer than `newest`.
  void requireFormat(std::string_view format, std::uint32_t newest) const;

  /// Throws FormatError: file, key path and what was expected.
  [[noreturn]] void fail(const Message& expected) const;
  [[noreturn]] void failAt(std::string_view key, const Message& expected) const { at(key).fail(expected); }

 private:
  JsonReader(const JsonDocument* document, const nlohmann::json* value) : document_(document), value_(value) {}

  /// Null if it is absent.
  [[nodiscard]] const nlohmann::json* member(std::string_view key) const;
  void readNumbers(std::span<double> values, double most) const;
  /// The key path, of this value or of a member of it. It is looked for in the document: only complaints need it.
  [[nodiscard]] std::string path() const;
  [[nodiscard]] std::string pathOf(std::string_view key) const;

  const JsonDocument* document_;
  const nlohmann::json* value_;
};

std::array<double, 4> quaternionWxyz(const Eigen::Matrix3d& R);  ///< w >= 0

/// What unitQuaternion() takes.
bool isUnitQuaternion(const Eigen::Quaterniond& q);

}  // namespace hexoderm
