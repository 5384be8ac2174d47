#include "hexoderm/base/text.h"

#include "hexoderm/base/error.h"

#include <fmt/format.h>
#include <algorithm>
#include <array>
#include <boost/algorithm/string/split.hpp>
#include <charconv>
#include <cmath>
#include <cstdint>
#include <optional>

namespace hexoderm {
namespace {

[[noreturn]] void failToParse(std::string_view text, std::string_view what, const Message& expected) {
  throw InvalidArgument(what, message("expected {}, found \"{}\"", expected, shortened(text, 80)));
}

template <class Number>
Number parseWhole(std::string_view text, std::string_view what, const Message& expected) {
  Number value{};
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc() || end != text.data() + text.size() || text.empty()) failToParse(text, what, expected);
  return value;
}

bool continuesCharacter(char c) { return (static_cast<unsigned char>(c) & 0xC0U) == 0x80U; }

/// The character of UTF-8 that the text begins with, and its length in bytes; nullopt if it begins with none.
struct Utf8Character {
  std::uint32_t code = 0;
  std::size_t size = 0;
};
std::optional<Utf8Character> firstUtf8(std::string_view text) {
  const auto lead = static_cast<unsigned char>(text.front());
  if (lead < 0x80) return Utf8Character{lead, 1};
  const std::size_t size = lead >= 0xF0 ? 4 : lead >= 0xE0 ? 3 : 2;
  if (lead < 0xC2 || lead > 0xF4 || text.size() < size) return std::nullopt;
  std::uint32_t code = lead & (0xFFU >> (size + 1));
  for (const char c : text.substr(1, size - 1)) {
    if (!continuesCharacter(c)) return std::nullopt;
    code = code << 6U | (static_cast<unsigned char>(c) & 0x3FU);
  }
  constexpr std::array<std::uint32_t, 5> kMin = {0, 0, 0x80, 0x800, 0x10000};
  const bool is_surrogate = code >= 0xD800 && code <= 0xDFFF;
  if (code < kMin.at(size) || code > 0x10FFFF || is_surrogate) return std::nullopt;
  return Utf8Character{code, size};
}

bool steersTerminal(std::uint32_t code) {
  const bool is_control = code < 0x20 || (code >= 0x7F && code <= 0x9F);
  const bool breaks_line = code == 0x2028 || code == 0x2029;
  const bool turns_writing =
      code == 0x200E || code == 0x200F || (code >= 0x202A && code <= 0x202E) || (code >= 0x2066 && code <= 0x2069);
  return is_control || breaks_line || turns_writing;
}

std::string escapeOf(std::uint32_t code) {
  return code == '\n' ? "\\n" : code == '\r' ? "\\r" : code == '\t' ? "\\t" : fmt::format("\\u{:04x}", code);
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
  if (!std::isfinite(value)) throw InvalidArgument(what, message("expected a finite number"));
  return value;
}

double parseNumberWithin(std::string_view text, std::string_view what, double least, double most) {
  const auto inWords = [](double bound) { return Number{bound, bound == std::floor(bound) ? 0 : Number::kExact}; };
  const Message expected = message("a number from {} to {}", inWords(least), inWords(most));
  const auto value = parseWhole<double>(text, what, expected);
  if (!(value >= least && value <= most)) failToParse(text, what, expected);
  return value;
}

unsigned parseUnsigned(std::string_view text, std::string_view what) {
  return parseWhole<unsigned>(text, what, message("a whole number"));
}

std::string excerptOf(std::string_view bytes, std::size_t most) {
  std::string text;
  for (const char c : bytes) {
    const auto byte = static_cast<unsigned char>(c);
    const std::string next = c == '\n' || c == '\r' || c == '\t' ? escapeOf(byte)
                             : byte < 0x20 || byte >= 0x7F       ? fmt::format("\\x{:02x}", byte)
                                                                 : std::string(1, c);
    if (text.size() + next.size() > most) return text + "...";
    text += next;
  }
  return text;
}

std::string_view trimmed(std::string_view text) {
  constexpr std::string_view kBlanks = " \t\r\n";
  text.remove_prefix(std::min(text.find_first_not_of(kBlanks), text.size()));
  return text.substr(0, text.find_last_not_of(kBlanks) + 1);
}

std::vector<std::string> split(std::string_view text, char separator) {
  std::vector<std::string> parts;
  boost::algorithm::split(parts, text, [separator](char c) { return c == separator; });
  return parts;
}

std::string shortened(std::string_view text, std::size_t most) {
  constexpr std::string_view kGap = "...";
  if (text.size() <= most) return std::string(text);
  const std::size_t kept = most > kGap.size() ? most - kGap.size() : 0;
  std::size_t front = kept - kept / 2;
  while (front > 0 && continuesCharacter(text[front])) --front;
  std::size_t back = text.size() - kept / 2;
  while (back < text.size() && continuesCharacter(text[back])) ++back;
  return std::string(text.substr(0, front)).append(kGap).append(text.substr(back));
}

std::string forTerminal(std::string_view text) {
  std::string line;
  line.reserve(text.size());
  while (!text.empty()) {
    const std::optional<Utf8Character> first = firstUtf8(text);
    const std::size_t size = first ? first->size : 1;
    if (!first) {
      line += fmt::format("\\x{:02x}", static_cast<unsigned char>(text.front()));
    } else if (steersTerminal(first->code)) {
      line += escapeOf(first->code);
    } else {
      line += text.substr(0, size);
    }
    text.remove_prefix(size);
  }
  return line;
}

}  // namespace hexoderm
