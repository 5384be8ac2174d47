#include "hexoderm/util/text.h"

#include "hexoderm/util/error.h"

#include <array>
#include <charconv>
#include <cmath>

namespace hexoderm {
namespace {

template <class Number>
Number parseWhole(std::string_view text, std::string_view what, const Message& expected) {
  Number value{};
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc() || end != text.data() + text.size() || text.empty()) {
    throw InvalidArgument(located(what, message("expected {}, found \"{}\"", expected, text)));
  }
  return value;
}

}  // namespace

std::string formatFixed(double value, int decimals) {
  std::array<char, 400> buffer{};
  const auto result =
      std::to_chars(buffer.data(), buffer.data() + buffer.size(), value, std::chars_format::fixed, decimals);
  std::string text(buffer.data(), result.ptr);
  // "-0.00" says nothing that "0.00" does not.
  if (text.starts_with('-') && text.find_first_not_of("-0.") == std::string::npos) text.erase(0, 1);
  return text;
}

std::string formatExact(double value) {
  std::array<char, 64> buffer{};
  const auto result = std::to_chars(buffer.data(), buffer.data() + buffer.size(), value);
  return {buffer.data(), result.ptr};
}

double parseNumber(std::string_view text, std::string_view what) {
  const auto value = parseWhole<double>(text, what, message("a number"));
  if (!std::isfinite(value)) throw InvalidArgument(located(what, message("expected a finite number")));
  return value;
}

unsigned parseUnsigned(std::string_view text, std::string_view what) {
  return parseWhole<unsigned>(text, what, message("a whole number"));
}

std::string excerptOf(std::string_view bytes, std::size_t most) {
  constexpr std::string_view kDigits = "0123456789abcdef";
  std::string text;
  for (const char c : bytes) {
    std::string next;
    const auto byte = static_cast<unsigned char>(c);
    if (c == '\n') {
      next = "\\n";
    } else if (c == '\r') {
      next = "\\r";
    } else if (c == '\t') {
      next = "\\t";
    } else if (byte < 0x20 || byte >= 0x7F) {
      next = {'\\', 'x', kDigits[byte / 16], kDigits[byte % 16]};
    } else {
      next = c;
    }
    if (text.size() + next.size() > most) return text + "...";
    text += next;
  }
  return text;
}

std::vector<std::string> split(std::string_view text, char separator) {
  std::vector<std::string> parts;
  std::size_t begin = 0;
  while (true) {
    const std::size_t end = text.find(separator, begin);
    parts.emplace_back(text.substr(begin, end - begin));
    if (end == std::string_view::npos) return parts;
    begin = end + 1;
  }
}

}  // namespace hexoderm
