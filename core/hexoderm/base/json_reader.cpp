#include "hexoderm/base/json_reader.h"

#include "hexoderm/base/error.h"
#include "hexoderm/base/is_rotation.h"
#include "hexoderm/base/spelling_suggestion.h"
#include "hexoderm/base/text.h"

#include <algorithm>
#include <cmath>
#include <iterator>

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
  explicit DocumentBuilder(std::size_t most_values) : most_values_(most_values) {}

  bool null() override { return add(nullptr); }
  bool boolean(bool value) override { return add(value); }
  bool number_integer(number_integer_t value) override { return add(value); }
  bool number_unsigned(number_unsigned_t value) override { return add(value); }
  bool number_float(number_float_t value, const string_t& /*text*/) override { return add(value); }
  bool string(string_t& value) override { return add(std::move(value)); }
  bool binary(binary_t& /*value*/) override { return false; }
  bool start_object(std::size_t /*size*/) override { return open(nlohmann::json::object()); }
  bool start_array(std::size_t /*size*/) override { return open(nlohmann::json::array()); }
  bool end_object() override { return close(); }
  bool end_array() override { return close(); }
  bool key(string_t& value) override {
    Level& object = open_.back();
    object.key = value;
    const auto [member, is_new] = object.value.get_ref<nlohmann::json::object_t&>().try_emplace(std::move(value));
    object.member = &member->second;
    return is_new || refuse(message("is there twice, expected each key once"));
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
    for (std::size_t k = 0; k < open_.size(); ++k) {
      if (path.size() > kLongest) return path + "...";
      const Level& level = open_[k];
      if (level.value.is_array()) {
        const std::size_t end = k + 1 < open_.size() ? open_[k + 1].first_item : items_.size();
        path += "[" + std::to_string(end - level.first_item) + "]";
      } else if (!level.key.empty()) {
        path += (path.empty() ? "" : ".") + shortened(level.key, kLongestKey);
      }
    }
    return path;
  }

 private:
  /// An array or an object that is not closed yet.
  struct Level {
    nlohmann::json value;              ///< an array gets its items when it is closed
    std::size_t first_item;            ///< in items_
    std::string key = {};              ///< of the member whose value is read
    nlohmann::json* member = nullptr;  ///< that member
  };

  bool refuse(Message why) {
    refusal_ = std::move(why);
    return false;
  }

  bool count() {
    return ++values_ <= most_values_ ||
           refuse(message("the file has too many values, at most {} are read", most_values_));
  }

  void put(nlohmann::json value) {
    if (open_.empty()) {
      root_ = std::move(value);
    } else if (Level& level = open_.back(); level.value.is_array()) {
      items_.push_back(std::move(value));
    } else {
      *level.member = std::move(value);
      level.key.clear();
    }
  }

  bool add(nlohmann::json value) {
    if (!count()) return false;
    put(std::move(value));
    return true;
  }

  bool open(nlohmann::json empty) {
    if (open_.size() >= kMaxJsonLevels) {
      return refuse(message("is nested too deeply, at most {} levels are read", kMaxJsonLevels));
    }
    if (!count()) return false;
    open_.push_back({std::move(empty), items_.size()});
    return true;
  }
  bool close() {
    Level level = std::move(open_.back());
    open_.pop_back();
    if (level.value.is_array()) {
      const auto first = items_.begin() + static_cast<std::ptrdiff_t>(level.first_item);
      level.value.get_ref<nlohmann::json::array_t&>().assign(std::move_iterator(first),
                                                             std::move_iterator(items_.end()));
      items_.erase(first, items_.end());
    }
    put(std::move(level.value));
    return true;
  }

  nlohmann::json root_;
  std::vector<Level> open_;            ///< from outside to inside
  std::vector<nlohmann::json> items_;  ///< of the arrays among them
  std::size_t most_values_;
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

/// The key path of a value of a document, or of a part of one; nullopt where it isn't.
std::optional<std::string> pathTo(const nlohmann::json& value, const nlohmann::json& within) {
  if (&value == &within) return "";
  if (!within.is_structured()) return std::nullopt;
  for (auto item = within.begin(); item != within.end(); ++item) {
    const std::optional<std::string> rest = pathTo(value, *item);
    if (!rest) continue;
    const bool is_array = within.is_array();
    const std::string step = is_array ? "[" + std::to_string(item - within.begin()) + "]" : item.key();
    return step + (rest->empty() || rest->starts_with('[') ? "" : ".") + *rest;
  }
  return std::nullopt;
}

}  // namespace

JsonDocument parseJson(std::string_view text, const std::string& file, std::size_t most_values) {
  DocumentBuilder builder(most_values);
  if (nlohmann::json::sax_parse(text, &builder)) return {builder.take(), file};
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

std::string JsonReader::path() const { return pathTo(*value_, document_->root).value(); }

std::string JsonReader::pathOf(std::string_view key) const {
  const std::string path = this->path();
  return path.empty() ? std::string(key) : path + "." + std::string(key);
}

void JsonReader::fail(const Message& expected) const {
  throw FormatError(document_->file,
                    located(placeOf(path()), message("expected {}, found {}", expected, inFewWords(*value_))));
}

const nlohmann::json* JsonReader::member(std::string_view key) const {
  if (!value_->is_object()) fail(message("an object"));
  const auto found = value_->find(key);
  return found == value_->end() ? nullptr : &*found;
}

JsonReader JsonReader::at(std::string_view key) const {
  const nlohmann::json* const found = member(key);
  if (found == nullptr) throw FormatError(document_->file, located(pathOf(key), message("is missing")));
  return {document_, found};
}

std::optional<JsonReader> JsonReader::find(std::string_view key) const {
  const nlohmann::json* const found = member(key);
  if (found == nullptr || found->is_null()) return std::nullopt;
  return JsonReader(document_, found);
}

void JsonReader::requireKeys(std::initializer_list<std::string_view> known) const {
  if (!value_->is_object()) fail(message("an object"));
  constexpr std::size_t kMaxOfAKey = 40;
  for (const auto& [key, value] : value_->items()) {
    if (std::ranges::find(known, key) != known.end()) continue;
    const std::vector<std::string> names(known.begin(), known.end());
    const std::optional<std::string> meant = spellingSuggestion(key, names);
    throw FormatError(document_->file, located(pathOf(excerptOf(key, kMaxOfAKey)),
                                               meant ? message("there is no such key; did you mean {}?", *meant)
                                                     : message("there is no such key; there are {}", names)));
  }
}

std::vector<JsonReader> JsonReader::items() const {
  if (!value_->is_array()) fail(message("an array"));
  std::vector<JsonReader> items;
  items.reserve(value_->size());
  for (const nlohmann::json& item : *value_) items.push_back({document_, &item});
  return items;
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

void JsonReader::readNumbers(std::span<double> values, double most) const {
  if (!value_->is_array() || value_->size() != values.size()) fail(message("an array of {} numbers", values.size()));
  for (std::size_t k = 0; k < values.size(); ++k) {
    const JsonReader item(document_, &(*value_)[k]);
    if (!item.value_->is_number()) item.fail(message("a finite number"));
    values[k] = item.number(most);
  }
}

Eigen::Vector3d JsonReader::vector3(double most) const { return Eigen::Vector3d(numbers<3>(most).data()); }

Eigen::Matrix3d JsonReader::rotation() const {
  const std::array<double, 9> by_rows = numbers<9>();
  const Eigen::Matrix3d R = Eigen::Map<const Eigen::Matrix<double, 3, 3, Eigen::RowMajor>>(by_rows.data());
  if (!isRotation(R)) fail(message("a rotation matrix (row-major, orthogonal to 1e-6, determinant +1)"));
  return R;
}

Eigen::Quaterniond JsonReader::unitQuaternion() const {
  const auto [w, x, y, z] = numbers<4>();
  const Eigen::Quaterniond q(w, x, y, z);
  if (!isUnitQuaternion(q)) {
    constexpr int kDecimals = 7;  // it has to be 1 within a millionth
    fail(message("a unit quaternion (w, x, y, z); the length of this one is {}", Number{q.norm(), kDecimals}));
  }
  return q.normalized();
}

void JsonReader::requireFormat(std::string_view format, std::uint32_t newest) const {
  const auto name = find("format");
  if (!name || !name->isString() || name->string() != format) {
    throw FormatError(document_->file,
                      located("format", name ? message("expected \"{}\", found {}", format, inFewWords(*name->value_))
                                             : message("expected \"{}\", but there is none", format)));
  }
  const std::uint32_t version = at("version").unsignedInteger(1);
  if (version > newest) {
    throw FormatError(
        document_->file,
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
