#pragma once

#include "hexoderm/base/json_scanner.h"
#include "hexoderm/base/message.h"

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cstdint>
#include <initializer_list>
#include <memory>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace hexoderm {

/// What is read of a document at most. With its bytes, at most kMaxFileBytes, it bounds the memory of what is read: a
/// value takes less than 100 bytes beside its text.
inline constexpr std::size_t kMaxJsonLevels = 100;
inline constexpr std::size_t kMaxJsonValues = 20'000'000;
/// Without a document in between (JsonScanner), a value takes no more memory than its text.
inline constexpr std::size_t kMaxScannedValues = 60'000'000;

/// Parses JSON text; `file` is named in errors. Throws FormatError with line, column and key path for what is not JSON,
/// and with the key path for a key that is there twice and for what is larger than the limits above. Of a text that is
/// a part of a document, `levels_above` are the levels around it.
nlohmann::json parseJson(std::string_view text, const std::string& file, std::size_t most_values = kMaxJsonValues,
                         std::size_t levels_above = 0);

/// The text's top-level "format" without parsing the rest; nullopt if there is none before the text ends or stops being
/// JSON.
std::optional<std::string> findJsonFormat(std::string_view text);

/// A JSON value that knows where it is, so that every complaint names file, key path and expectation:
/// "arm.session.json: cells[3].ports[0].port: expected a whole number from 1 to 4294967295, found "two"".
/// Only for use in .cpp files: it carries nlohmann's header.
class JsonReader {
 public:
  JsonReader(const nlohmann::json& value, std::string file, std::string path = "")
      : JsonReader(value, std::make_shared<const std::string>(std::move(file)), std::move(path)) {}

  [[nodiscard]] JsonReader at(const std::string& key) const;                   ///< must be there
  [[nodiscard]] std::optional<JsonReader> find(const std::string& key) const;  ///< absent or null: nullopt
  [[nodiscard]] std::vector<JsonReader> items() const;                         ///< items of an array
  /// Throws FormatError for the first key of an object that is none of these, and names that which was meant.
  void requireKeys(std::initializer_list<std::string_view> known) const;
  [[nodiscard]] bool isObject() const { return value_->is_object(); }
  [[nodiscard]] bool isArray() const { return value_->is_array(); }
  [[nodiscard]] bool isString() const { return value_->is_string(); }
  [[nodiscard]] bool isNull() const { return value_->is_null(); }

  // As those of JsonScanner, so that a template reads both; that says how they differ.
  template <class... Members>
  void object(Members... members) const {
    (takeMember(members), ...);
  }
  /// The same, and throws as requireKeys() for others.
  template <class... Members>
  void strictObject(Members... members) const {
    requireKeys({members.key...});
    object(std::move(members)...);
  }
  template <class Take>
  void eachItem(Take take) const {
    for (const JsonReader& item : items()) take(item);
  }

  [[nodiscard]] double number(double most = kNoLimit) const;  ///< finite, at most `most` in magnitude
  [[nodiscard]] double positiveNumber() const;
  [[nodiscard]] double nonNegativeNumber() const;
  [[nodiscard]] std::uint32_t unsignedInteger(std::uint32_t min = 0, std::uint32_t max = UINT32_MAX) const;
  [[nodiscard]] std::int64_t integer() const;  ///< a signed integer of 64 bits
  [[nodiscard]] bool boolean() const;
  [[nodiscard]] std::string string() const;
  /// Exactly `count` numbers.
  [[nodiscard]] std::vector<double> numbers(std::size_t count, double most = kNoLimit) const;
  template <std::size_t Count>
  [[nodiscard]] std::array<double, Count> numbers(double most = kNoLimit) const {
    std::array<double, Count> array{};
    std::ranges::copy(numbers(Count, most), array.begin());
    return array;
  }
  [[nodiscard]] Eigen::Vector3d vector3(double most = kNoLimit) const;
  [[nodiscard]] Eigen::Matrix3d rotation() const;           ///< nine numbers, row-major, orthogonal to 1e-6, det +1
  [[nodiscard]] Eigen::Quaterniond unitQuaternion() const;  ///< four numbers w, x, y, z of norm 1 (to 1e-6); normalised
  [[nodiscard]] const std::string& path() const { return path_; }

  /// Checks `"format": format` and that the version's major number is not newer than `newest`.
  void requireFormat(std::string_view format, std::uint32_t newest) const;

  /// Throws FormatError: file, key path and what was expected.
  [[noreturn]] void fail(const Message& expected) const;
  [[noreturn]] void failAt(const std::string& key, const Message& expected) const { at(key).fail(expected); }

 private:
  template <class Member>
  void takeMember(Member& member) const {
    if constexpr (requires { member.takeFromObject(*this); }) {
      member.takeFromObject(*this);
    } else {
      const std::string key(member.key);
      const std::optional<JsonReader> value = member.is_required ? at(key) : find(key);
      if (value) member.takeFrom(*value);
    }
  }
  [[nodiscard]] JsonReader itemAt(std::size_t index) const;

  /// "FILE: PATH: what is wrong there".
  [[nodiscard]] Message here(Message what) const;

  JsonReader(const nlohmann::json& value, std::shared_ptr<const std::string> file, std::string path)
      : value_(&value), file_(std::move(file)), path_(std::move(path)) {}

  const nlohmann::json* value_;
  std::shared_ptr<const std::string> file_;
  std::string path_;
};

std::array<double, 4> quaternionWxyz(const Eigen::Matrix3d& R);  ///< w >= 0

/// What unitQuaternion() takes.
bool isUnitQuaternion(const Eigen::Quaterniond& q);

}  // namespace hexoderm
