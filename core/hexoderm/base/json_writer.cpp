#include "hexoderm/base/json_writer.h"

#include "hexoderm/base/error.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>

namespace hexoderm {
namespace {

constexpr std::size_t kLineWidth = 120;
constexpr std::size_t kPieceBytes = 65536;

/// A text of these alone is in JSON as it is.
bool isPlain(std::string_view text) {
  return std::ranges::all_of(text, [](char c) { return c >= ' ' && c <= '~' && c != '"' && c != '\\'; });
}

}  // namespace

void JsonWriter::indent(std::size_t levels) { text_.append(levels, ' '); }

void JsonWriter::putOnLines(std::size_t depth) {
  Level& level = levels_[depth];
  if (level.is_on_lines) return;
  level.is_on_lines = true;
  const std::string line = text_.substr(level.begin);
  text_.resize(level.begin + 1);  // the bracket stays
  std::size_t moved = 0;
  for (std::size_t k = 0; k < level.items.size(); ++k) {
    const bool is_last = k + 1 == level.items.size();
    constexpr std::size_t kComma = 2;
    const std::size_t from = level.items[k] - level.begin;
    const std::size_t size = is_last ? std::string::npos : level.items[k + 1] - level.items[k] - kComma;
    text_ += k == 0 ? "\n" : ",\n";
    indent(depth + 1);
    moved = text_.size() - level.items[k];
    text_.append(line, from, size);
  }
  // What has begun inside is a part of the last item.
  for (std::size_t inner = depth + 1; inner < depth_; ++inner) {
    levels_[inner].begin += moved;
    for (std::size_t& item : levels_[inner].items) item += moved;
  }
}

void JsonWriter::putOnLines() {
  for (std::size_t depth = 0; depth < depth_; ++depth) putOnLines(depth);
}

void JsonWriter::startItem(Level& level) {
  if (level.is_on_lines) {
    text_ += level.count == 0 ? "\n" : ",\n";
    indent(depth_);
  } else {
    if (level.count > 0) text_ += ", ";
    level.items.push_back(text_.size());
  }
  ++level.count;
}

void JsonWriter::startValue() {
  if (depth_ > 0 && !has_key_) startItem(levels_[depth_ - 1]);
  has_key_ = false;
}

void JsonWriter::key(std::string_view key) {
  // An object with an object in it that has members fits into no line, and neither does a long one.
  if (depth_ > 1) putOnLines(depth_ - 2);
  Level& level = levels_[depth_ - 1];
  if (!level.is_on_lines && depth_ + text_.size() - level.begin > kLineWidth) putOnLines(depth_ - 1);
  startItem(level);
  addText(key);
  text_ += ": ";
  has_key_ = true;
}

void JsonWriter::begin(Kind kind) {
  // An array with arrays or objects in it fits into no line, and neither does what it is in.
  if (depth_ > 0 && levels_[depth_ - 1].kind == Kind::Array) putOnLines();
  startValue();
  if (depth_ == levels_.size()) levels_.emplace_back();
  Level& level = levels_[depth_++];
  level.kind = kind;
  level.is_on_lines = false;
  level.count = 0;
  level.begin = text_.size();
  level.items.clear();
  text_ += kind == Kind::Object ? '{' : '[';
}

void JsonWriter::end(char bracket) {
  const Level& level = levels_[depth_ - 1];
  if (level.kind == Kind::Object && level.count > 0 && depth_ + text_.size() - level.begin > kLineWidth) {
    putOnLines(depth_ - 1);
  }
  if (level.is_on_lines) {
    text_ += '\n';
    indent(depth_ - 1);
  }
  text_ += bracket;
  --depth_;
  if (text_.size() < kPieceBytes || depth_ == 0 || !levels_[depth_ - 1].is_on_lines) return;
  write_(text_);
  text_.clear();
}

void JsonWriter::finish() {
  text_ += '\n';
  write_(text_);
  text_.clear();
}

void JsonWriter::addScalar(std::string_view text) {
  startValue();
  text_ += text;
}

void JsonWriter::addNumber(double number) {
  if (!std::isfinite(number)) {
    throw InvalidArgument(message("a value that is not a finite number can't be written to a file"));
  }
  std::array<char, 32> buffer{};
  const char* const end = std::to_chars(buffer.data(), buffer.data() + buffer.size(), number).ptr;
  const std::string_view digits(buffer.data(), static_cast<std::size_t>(end - buffer.data()));
  text_ += digits;
  if (digits.find_first_of(".e") == std::string_view::npos) text_ += ".0";  // else it would be read as a whole number
}

void JsonWriter::addUnsigned(std::uint64_t number) {
  std::array<char, 24> digits{};
  char* const end = std::to_chars(digits.data(), digits.data() + digits.size(), number).ptr;
  addScalar({digits.data(), static_cast<std::size_t>(end - digits.data())});
}

void JsonWriter::addSigned(std::int64_t number) {
  std::array<char, 24> digits{};
  char* const end = std::to_chars(digits.data(), digits.data() + digits.size(), number).ptr;
  addScalar({digits.data(), static_cast<std::size_t>(end - digits.data())});
}

void JsonWriter::addText(std::string_view text) {
  if (!isPlain(text)) {
    text_ += nlohmann::json(text).dump(-1, ' ', false, nlohmann::json::error_handler_t::replace);
    return;
  }
  text_ += '"';
  text_ += text;
  text_ += '"';
}

void JsonWriter::value(double number) {
  startValue();
  addNumber(number);
}

void JsonWriter::value(std::string_view text) {
  startValue();
  addText(text);
}

void JsonWriter::value(std::span<const double> numbers) {
  // One line at once; as begin(), in an array it puts that on lines.
  if (depth_ > 0 && levels_[depth_ - 1].kind == Kind::Array) putOnLines();
  startValue();
  text_ += '[';
  for (std::size_t k = 0; k < numbers.size(); ++k) {
    if (k > 0) text_ += ", ";
    addNumber(numbers[k]);
  }
  text_ += ']';
}

void JsonWriter::value(const Eigen::Matrix3d& m) {
  const Eigen::Matrix3d by_rows = m.transpose();
  value(std::span<const double>(by_rows.data(), 9));
}

void JsonWriter::value(const nlohmann::ordered_json& json) {
  switch (json.type()) {
    case nlohmann::ordered_json::value_t::object:
      beginObject();
      for (const auto& [name, its_value] : json.items()) member(name, its_value);
      return endObject();
    case nlohmann::ordered_json::value_t::array:
      beginArray();
      for (const nlohmann::ordered_json& item : json) value(item);
      return endArray();
    case nlohmann::ordered_json::value_t::number_float:
      return value(json.get<double>());
    case nlohmann::ordered_json::value_t::number_unsigned:
      return value(json.get<std::uint64_t>());
    case nlohmann::ordered_json::value_t::number_integer:
      return value(json.get<std::int64_t>());
    case nlohmann::ordered_json::value_t::string:
      return value(json.get_ref<const std::string&>());
    case nlohmann::ordered_json::value_t::boolean:
      return value(json.get<bool>());
    default:
      return null();
  }
}

}  // namespace hexoderm
