#include "hexoderm/base/json_reader.h"

#include "hexoderm/base/error.h"
#include "hexoderm/base/file.h"
#include "hexoderm/base/is_rotation.h"
#include "hexoderm/base/spelling_suggestion.h"
#include "hexoderm/base/text.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace hexoderm {
namespace {

/// A value in a complaint.
Message inFewWords(const nlohmann::json& value) {
  if (value.is_array()) return message("an array of {}", value.size());
  if (value.is_object()) return message("an object");
  constexpr std::size_t kMax = 40;
  std::string text = value.dump(-1, ' ', true, nlohmann::json::error_handler_t::replace);
  if (text.size() > kMax) text = text.substr(0, kMax) + "...";
  return Message::verbatim(std::move(text));
}

/// The place of a complaint within a file.
MessageArgument placeOf(const std::string& path) {
  return path.empty() ? MessageArgument(message("top level")) : MessageArgument(path);
}

/// Builds the value of a text while the parser reads it, and stops at what no document of ours is: a key that is there
/// twice, of which readers would take one or the other, and more levels or values than are read.
class DocumentBuilder final : public nlohmann::json_sax<nlohmann::json> {
 public:
  DocumentBuilder(std::size_t most_values, std::size_t levels_above)
      : most_values_(most_values), levels_above_(levels_above) {}

  bool null() override { return add(nullptr); }
  bool boolean(bool value) override { return add(value); }
  bool number_integer(number_integer_t value) override { return add(value); }
  bool number_unsigned(number_unsigned_t value) override { return add(value); }
  bool number_float(number_float_t value, const string_t& /*text*/) override { return add(value); }
  bool string(string_t& value) override { return add(value); }
  bool binary(binary_t& /*value*/) override { return false; }
  bool start_object(std::size_t /*size*/) override { return open(nlohmann::json::value_t::object); }
  bool start_array(std::size_t /*size*/) override { return open(nlohmann::json::value_t::array); }
  bool end_object() override { return close(); }
  bool end_array() override { return close(); }
  bool key(string_t& value) override {
    open_.back().key = value;
    const auto [member, is_new] = open_.back().value->get_ref<nlohmann::json::object_t&>().try_emplace(value);
    if (!is_new) return refuse(message("is there twice, expected each key once"));
    member_ = &member->second;
    return true;
  }
  bool parse_error(std::size_t position, const std::string& last_token,
                   const nlohmann::json::exception& error) override {
    fault_ = {position, last_token, dynamic_cast<const nlohmann::json::parse_error*>(&error) != nullptr};
    return false;
  }

  /// Where and on what the parser stopped.
  struct Fault {
    std::size_t position = 0;  ///< bytes read, the offending one included
    std::string last_token;
    bool is_syntax = false;  ///< else a number that no double holds
  };
  [[nodiscard]] const Fault& fault() const { return fault_; }
  /// Why it stopped although the text is JSON; says nothing if it did not.
  [[nodiscard]] const Message& refusal() const { return refusal_; }
  nlohmann::json take() { return std::move(root_); }

  /// The key path of the value it was at when it stopped.
  [[nodiscard]] std::string path() const {
    // Hostile nesting and keys make longer ones, which nobody reads to the end.
    constexpr std::size_t kLongest = 200;
    constexpr std::size_t kLongestKey = 60;
    std::string path;
    for (const Level& level : open_) {
      if (path.size() > kLongest) return path + "...";
      if (level.value->is_array()) {
        const bool is_within_last = &level != &open_.back();
        path += "[" + std::to_string(level.value->size() - (is_within_last ? 1 : 0)) + "]";
      } else if (!level.key.empty()) {
        path += (path.empty() ? "" : ".") + shortened(level.key, kLongestKey);
      }
    }
    return path;
  }

 private:
  /// An array or an object that is not closed yet.
  struct Level {
    nlohmann::json* value;
    std::string key;  ///< of the member whose value is read
  };

  bool refuse(Message why) {
    refusal_ = std::move(why);
    return false;
  }

  bool count() {
    return ++values_ <= most_values_ ||
           refuse(message("the file has too many values, at most {} are read", most_values_));
  }

  /// The place of the next value, with the value in it.
  template <class Value>
  nlohmann::json& put(Value&& value) {
    if (open_.empty()) return root_ = std::forward<Value>(value);
    nlohmann::json& parent = *open_.back().value;
    if (parent.is_array()) {
      return parent.get_ref<nlohmann::json::array_t&>().emplace_back(std::forward<Value>(value));
    }
    return *member_ = std::forward<Value>(value);
  }

  template <class Value>
  bool add(Value&& value) {
    if (!count()) return false;
    put(std::forward<Value>(value));
    return endValue();
  }

  bool open(nlohmann::json::value_t kind) {
    if (levels_above_ + open_.size() >= kMaxJsonLevels) {
      return refuse(message("is nested too deeply, at most {} levels are read", kMaxJsonLevels));
    }
    if (!count()) return false;
    nlohmann::json& opened = put(nlohmann::json(kind));
    open_.push_back({&opened, {}});
    return true;
  }
  bool close() {
    open_.pop_back();
    return endValue();
  }
  bool endValue() {
    if (!open_.empty()) open_.back().key.clear();
    return true;
  }

  nlohmann::json root_;
  std::vector<Level> open_;           ///< from outside to inside
  nlohmann::json* member_ = nullptr;  ///< of the innermost object, whose value comes next
  std::size_t most_values_;
  std::size_t levels_above_;
  std::size_t values_ = 0;
  Message refusal_;
  Fault fault_;
};

/// The word of letters, digits, signs and points around a byte, for error messages.
std::string wordAround(std::string_view text, std::size_t position) {
  const auto isPart = [](char c) {
    return (c >= '0' && c <= '9') || (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '+' || c == '-' ||
           c == '.';
  };
  std::size_t begin = std::min(position, text.size());
  while (begin > 0 && isPart(text[begin - 1])) --begin;
  std::size_t end = std::min(position, text.size());
  while (end < text.size() && isPart(text[end])) ++end;
  constexpr std::size_t kMax = 40;
  return std::string(text.substr(begin, std::min(end - begin, kMax)));
}

bool isNotFinite(std::string_view word) {
  while (word.starts_with('-') || word.starts_with('+')) word.remove_prefix(1);
  std::string lower(word);
  std::ranges::transform(lower, lower.begin(),
                         [](char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c + 32) : c; });
  return lower == "nan" || lower == "inf" || lower == "infinity";
}

[[noreturn]] void throwParseError(std::string_view text, const std::string& file, const DocumentBuilder& builder) {
  if (text.find_first_not_of(" \t\r\n") == std::string_view::npos) {
    throw FormatError(file, message("the file is empty, expected JSON"));
  }
  constexpr std::size_t kLongestToken = 40;
  const DocumentBuilder::Fault& fault = builder.fault();
  const std::string path = builder.path();
  if (!fault.is_syntax) {
    throw FormatError(file, located(placeOf(path), message("expected a finite number, found {}",
                                                           fault.last_token.substr(0, kLongestToken))));
  }
  const std::size_t position = std::min(fault.position == 0 ? 0 : fault.position - 1, text.size());
  const std::string word = wordAround(text, position);
  if (isNotFinite(word)) {
    throw FormatError(file, located(placeOf(path), message("expected a finite number, found {}", word)));
  }
  const std::string_view before = text.substr(0, position);
  const auto line = std::ranges::count(before, '\n') + 1;
  const std::size_t line_start = before.rfind('\n');
  const std::size_t column = before.size() - (line_start == std::string_view::npos ? 0 : line_start + 1) + 1;
  Message place = path.empty() ? message("line {}, column {}", line, column)
                               : message("line {}, column {}, at {}", line, column, path);
  throw FormatError(
      file, located(std::move(place), fault.position > text.size()
                                          ? message("the file ends in the middle (truncated?), expected complete JSON")
                                          : message("this is not JSON, expected a JSON value here")));
}

}  // namespace

nlohmann::json parseJson(std::string_view text, const std::string& file, std::size_t most_values,
                         std::size_t levels_above) {
  if (text.size() > kMaxFileBytes) {
    throw FormatError(file, message("something in it is wrong or unusual; what it is, is looked for in files of "
                                    "up to {} MB only",
                                    kMaxFileBytes / 1'000'000));
  }
  DocumentBuilder builder(most_values, levels_above);
  if (nlohmann::json::sax_parse(text, &builder)) return builder.take();
  if (builder.refusal().empty()) throwParseError(text, file, builder);
  throw FormatError(file, located(placeOf(builder.path()), builder.refusal()));
}

std::optional<std::string> findJsonFormat(std::string_view text) {
  struct Found {};
  std::optional<std::string> format;
  bool is_format = false;
  // Keeps nothing of the document.
  const auto look = [&](int depth, nlohmann::json::parse_event_t event, const nlohmann::json& parsed) {
    using Event = nlohmann::json::parse_event_t;
    if (depth > static_cast<int>(kMaxJsonLevels)) throw Found();
    if (depth == 1 && event == Event::key) is_format = parsed == "format";
    if (depth == 1 && event == Event::value && is_format && parsed.is_string()) {
      format = parsed.get<std::string>();
      throw Found();
    }
    return depth == 0;
  };
  try {
    [[maybe_unused]] const nlohmann::json nothing = nlohmann::json::parse(text, look, false);
  } catch (const Found&) {
  }
  return format;
}

Message JsonReader::here(Message what) const { return located(*file_, located(placeOf(path_), std::move(what))); }

void JsonReader::fail(const Message& expected) const {
  throw FormatError(here(message("expected {}, found {}", expected, inFewWords(*value_))));
}

JsonReader JsonReader::at(const std::string& key) const {
  if (!value_->is_object()) fail(message("an object"));
  const auto found = value_->find(key);
  const std::string path = path_.empty() ? key : path_ + "." + key;
  if (found == value_->end()) throw FormatError(*file_, located(path, message("is missing")));
  return {*found, file_, path};
}

std::optional<JsonReader> JsonReader::find(const std::string& key) const {
  if (!value_->is_object()) fail(message("an object"));
  const auto found = value_->find(key);
  if (found == value_->end() || found->is_null()) return std::nullopt;
  return JsonReader(*found, file_, path_.empty() ? key : path_ + "." + key);
}

void JsonReader::requireKeys(std::initializer_list<std::string_view> known) const {
  if (!value_->is_object()) fail(message("an object"));
  constexpr std::size_t kMaxOfAKey = 40;
  for (const auto& [key, value] : value_->items()) {
    if (std::ranges::find(known, key) != known.end()) continue;
    const std::vector<std::string> names(known.begin(), known.end());
    const std::string found = excerptOf(key, kMaxOfAKey);
    const std::optional<std::string> meant = spellingSuggestion(key, names);
    throw FormatError(*file_, located(path_.empty() ? found : path_ + "." + found,
                                      meant ? message("there is no such key; did you mean {}?", *meant)
                                            : message("there is no such key; there are {}", names)));
  }
}

std::vector<JsonReader> JsonReader::items() const {
  if (!value_->is_array()) fail(message("an array"));
  std::vector<JsonReader> items;
  items.reserve(value_->size());
  for (std::size_t i = 0; i < value_->size(); ++i) items.push_back(itemAt(i));
  return items;
}

JsonReader JsonReader::itemAt(std::size_t index) const {
  return {(*value_)[index], file_, path_ + "[" + std::to_string(index) + "]"};
}

double JsonReader::number(double most) const {
  if (!value_->is_number()) fail(message("a number"));
  const auto value = value_->get<double>();
  if (!std::isfinite(value)) fail(message("a finite number"));
  if (!(std::abs(value) <= most)) fail(message("a number from {} to {}", Number{-most}, Number{most}));
  return value;
}

double JsonReader::positiveNumber() const {
  const double value = number();
  if (!(value > 0)) fail(message("a number above 0"));
  return value;
}

double JsonReader::nonNegativeNumber() const {
  const double value = number();
  if (!(value >= 0)) fail(message("a number of at least 0"));
  return value;
}

std::uint32_t JsonReader::unsignedInteger(std::uint32_t min, std::uint32_t max) const {
  const auto refuse = [&] { fail(message("a whole number from {} to {}", min, max)); };
  if (!value_->is_number_integer()) refuse();
  if (!value_->is_number_unsigned() && value_->get<std::int64_t>() < 0) refuse();
  const auto value = value_->get<std::uint64_t>();
  if (value < min || value > max) refuse();
  return static_cast<std::uint32_t>(value);
}

std::int64_t JsonReader::integer() const {
  const bool fits =
      value_->is_number_integer() && (!value_->is_number_unsigned() || value_->get<std::uint64_t>() <= INT64_MAX);
  if (!fits) fail(message("a whole number of 64 bits"));
  return value_->get<std::int64_t>();
}

bool JsonReader::boolean() const {
  if (!value_->is_boolean()) fail(message("true or false"));
  return value_->get<bool>();
}

std::string JsonReader::string() const {
  if (!value_->is_string()) fail(message("a text"));
  return value_->get<std::string>();
}

std::vector<double> JsonReader::numbers(std::size_t count, double most) const {
  if (!value_->is_array() || value_->size() != count) fail(message("an array of {} numbers", count));
  std::vector<double> values;
  values.reserve(count);
  for (const nlohmann::json& item : *value_) {
    // A reader for each item would cost a path for each number; only a bad one needs it.
    const double value = item.is_number() ? item.get<double>() : std::numeric_limits<double>::quiet_NaN();
    if (!std::isfinite(value)) itemAt(values.size()).fail(message("a finite number"));
    if (std::abs(value) > most) static_cast<void>(itemAt(values.size()).number(most));
    values.push_back(value);
  }
  return values;
}

Eigen::Vector3d JsonReader::vector3(double most) const { return Eigen::Vector3d(numbers(3, most).data()); }

Eigen::Matrix3d JsonReader::rotation() const {
  const std::vector<double> v = numbers(9);
  const Eigen::Matrix3d R = Eigen::Map<const Eigen::Matrix<double, 3, 3, Eigen::RowMajor>>(v.data());
  if (!isRotation(R)) fail(message("a rotation matrix (row-major, orthogonal to 1e-6, determinant +1)"));
  return R;
}

Eigen::Quaterniond JsonReader::unitQuaternion() const {
  const std::vector<double> v = numbers(4);
  const Eigen::Quaterniond q(v[0], v[1], v[2], v[3]);
  if (!isUnitQuaternion(q)) {
    constexpr int kDecimals = 7;  // it has to be 1 within a millionth
    fail(message("a unit quaternion (w, x, y, z); the length of this one is {}", Number{q.norm(), kDecimals}));
  }
  return q.normalized();
}

void JsonReader::requireFormat(std::string_view format, std::uint32_t newest) const {
  const auto name = find("format");
  if (!name || !name->isString() || name->string() != format) {
    throw FormatError(*file_,
                      located("format", name ? message("expected \"{}\", found {}", format, inFewWords(*name->value_))
                                             : message("expected \"{}\", but there is none", format)));
  }
  const std::uint32_t version = at("version").unsignedInteger(1);
  if (version > newest) {
    throw FormatError(
        *file_,
        located("version", message("this file has version {}, this program reads up to version {}", version, newest)));
  }
}

std::array<double, 4> quaternionWxyz(const Eigen::Matrix3d& R) {
  Eigen::Quaterniond q(R);
  q.normalize();
  if (q.w() < 0) q.coeffs() = -q.coeffs();
  return {q.w(), q.x(), q.y(), q.z()};
}

bool isUnitQuaternion(const Eigen::Quaterniond& q) {
  constexpr double kUnitTo = 1e-6;
  return std::abs(q.norm() - 1) <= kUnitTo;
}

}  // namespace hexoderm
