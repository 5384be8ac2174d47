#include "hexoderm/base/json_scanner.h"

#include "hexoderm/base/is_rotation.h"
#include "hexoderm/base/json_reader.h"

#include <algorithm>
#include <charconv>
#include <system_error>

namespace hexoderm {
namespace {

constexpr bool isSpace(char c) { return c == ' ' || c == '\n' || c == '\r' || c == '\t'; }
constexpr bool isDigit(char c) { return c >= '0' && c <= '9'; }
/// In a text: ASCII that stands for itself.
constexpr bool standsForItself(char c) { return c >= ' ' && c <= '~' && c != '"' && c != '\\'; }

const char* afterDigits(const char* at, const char* end) {
  const char* const begin = at;
  while (at != end && isDigit(*at)) ++at;
  if (at == begin) throw JsonScanner::Unusual();
  return at;
}

}  // namespace

void JsonScanner::skipSpace() {
  while (at_ != end_ && isSpace(*at_)) ++at_;
}

bool JsonScanner::take(char c) {
  if (at_ == end_ || *at_ != c) return false;
  ++at_;
  return true;
}

void JsonScanner::requireNext(char c) {
  if (!take(c)) throw Unusual();
}

void JsonScanner::requireWord(std::string_view word) {
  for (const char c : word) requireNext(c);
}

void JsonScanner::begin(char bracket) {
  skipSpace();
  requireNext(bracket);
  if (++levels_ > kMaxJsonLevels) throw Unusual();
  ++values_;
  is_first_ = true;
}

std::optional<std::string_view> JsonScanner::nextKey() {
  skipSpace();
  if (take('}')) {
    --levels_;
    is_first_ = false;
    return std::nullopt;
  }
  if (!is_first_) {
    requireNext(',');
    skipSpace();
  }
  is_first_ = false;
  requireNext('"');
  const char* const begin = at_;
  while (at_ != end_ && standsForItself(*at_)) ++at_;
  const std::string_view key(begin, static_cast<std::size_t>(at_ - begin));
  requireNext('"');
  skipSpace();
  requireNext(':');
  return key;
}

bool JsonScanner::nextItem() {
  skipSpace();
  if (take(']')) {
    --levels_;
    is_first_ = false;
    return false;
  }
  if (!is_first_) requireNext(',');
  is_first_ = false;
  return true;
}

double JsonScanner::number() {
  skipSpace();
  ++values_;
  const char* const begin = at_;
  const char* at = begin;
  if (at != end_ && *at == '-') ++at;
  const char* const digits = at;
  at = afterDigits(digits, end_);
  if (*digits == '0' && at - digits > 1) throw Unusual();
  bool is_whole = true;
  if (at != end_ && *at == '.') {
    is_whole = false;
    at = afterDigits(at + 1, end_);
  }
  if (at != end_ && (*at == 'e' || *at == 'E')) {
    is_whole = false;
    ++at;
    if (at != end_ && (*at == '+' || *at == '-')) ++at;
    at = afterDigits(at, end_);
  }
  double value = 0;
  const auto [after, error] = std::from_chars(begin, at, value);
  if (error != std::errc() || after != at) throw Unusual();
  at_ = at;
  return is_whole && value == 0 ? 0 : value;  // a -0 without a point is an integer, which has no sign
}

double JsonScanner::positiveNumber() {
  const double value = number();
  require(value > 0);
  return value;
}

double JsonScanner::nonNegativeNumber() {
  const double value = number();
  require(value >= 0);
  return value;
}

std::uint32_t JsonScanner::unsignedInteger(std::uint32_t min, std::uint32_t max) {
  skipSpace();
  ++values_;
  const char* const digits = at_;
  at_ = afterDigits(digits, end_);
  std::uint32_t value = 0;
  const bool fits = std::from_chars(digits, at_, value).ec == std::errc();
  if (!fits || (*digits == '0' && at_ - digits > 1) || value < min || value > max) throw Unusual();
  return value;
}

bool JsonScanner::boolean() {
  skipSpace();
  ++values_;
  const bool value = at_ != end_ && *at_ == 't';
  requireWord(value ? "true" : "false");
  return value;
}

bool JsonScanner::isNull() {
  skipSpace();
  if (at_ == end_ || *at_ != 'n') return false;
  ++values_;
  requireWord("null");
  return true;
}

void JsonScanner::skipText() {
  requireNext('"');
  while (!take('"')) {
    if (take('\\') && at_ == end_) throw Unusual();
    if (at_ == end_) throw Unusual();
    ++at_;
  }
}

std::string JsonScanner::string() {
  skipSpace();
  ++values_;
  const char* const begin = at_;
  skipText();
  const std::string_view whole(begin, static_cast<std::size_t>(at_ - begin));
  const std::string_view inside = whole.substr(1, whole.size() - 2);
  if (std::ranges::all_of(inside, standsForItself)) return std::string(inside);
  const nlohmann::json text = nlohmann::json::parse(whole, nullptr, false);
  if (!text.is_string()) throw Unusual();
  return text.get<std::string>();
}

void JsonScanner::numbers(std::span<double> values) {
  beginArray();
  for (double& value : values) {
    if (!nextItem()) throw Unusual();
    value = number();
  }
  if (nextItem()) throw Unusual();
}

Eigen::Vector3d JsonScanner::vector3(double most) { return Eigen::Vector3d(numbers<3>(most).data()); }

Eigen::Matrix3d JsonScanner::rotation() {
  const std::array<double, 9> by_rows = numbers<9>();
  const Eigen::Matrix3d R = Eigen::Map<const Eigen::Matrix<double, 3, 3, Eigen::RowMajor>>(by_rows.data());
  require(isRotation(R));
  return R;
}

Eigen::Quaterniond JsonScanner::unitQuaternion() {
  const auto [w, x, y, z] = numbers<4>();
  const Eigen::Quaterniond q(w, x, y, z);
  require(isUnitQuaternion(q));
  return q.normalized();
}

std::string_view JsonScanner::textOfValue() {
  skipSpace();
  const char* const begin = at_;
  std::size_t open = 0;
  ++values_;
  while (at_ != end_) {
    const char c = *at_;
    if (c == '"') {
      skipText();
    } else if (c == '[' || c == '{') {
      ++open;
      ++values_;
      ++at_;
    } else if (open == 0 && (c == ',' || c == ']' || c == '}' || isSpace(c))) {
      break;
    } else {
      if (c == ',') ++values_;
      ++at_;
      if ((c == ']' || c == '}') && --open == 0) break;
    }
  }
  if (open > 0) throw Unusual();
  return {begin, static_cast<std::size_t>(at_ - begin)};
}

nlohmann::json JsonScanner::document() { return parseJson(textOfValue(), "a part of a file", kMaxJsonValues, levels_); }

void JsonScanner::keep(std::string_view key, nlohmann::json& object) {
  if (!object.emplace(std::string(key), document()).second) throw Unusual();
}

void JsonScanner::finish() {
  skipSpace();
  if (at_ != end_ || values_ > kMaxScannedValues) throw Unusual();
}

}  // namespace hexoderm
