#include "hexoderm/util/csv.h"

#include <charconv>
#include <cmath>

namespace hexoderm {
namespace {

bool isFiniteNumber(std::string_view text) {
  if (text.starts_with('+')) text.remove_prefix(1);
  double value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  return error == std::errc() && end == text.data() + text.size() && std::isfinite(value);
}

}  // namespace

std::string csvHarmless(std::string_view text) {
  const bool begins_a_formula = !text.empty() && std::string_view("=+-@\t\r\n").find(text.front()) != text.npos;
  return (begins_a_formula && !isFiniteNumber(text) ? "'" : "") + std::string(text);
}

std::string csvQuoted(std::string_view text) {
  const std::string harmless = csvHarmless(text);
  const bool plain =
      harmless.find_first_of("\",\r\n") == std::string::npos && !harmless.starts_with(' ') && !harmless.ends_with(' ');
  if (plain) return harmless;
  std::string result = "\"";
  for (const char c : harmless) {
    if (c == '"') result += '"';
    result += c;
  }
  return result + '"';
}

}  // namespace hexoderm
