#pragma once

#include <cstddef>
#include <functional>
#include <string>
#include <string_view>
#include <vector>

namespace hexoderm {

/// `value` with `decimals` digits after the point, independent of the locale.
std::string formatFixed(double value, int decimals);

/// The shortest text that reads back as the same double, independent of the locale.
std::string formatExact(double value);

/// Parses a whole string as a finite number, independent of the locale. Throws InvalidArgument naming `what`.
double parseNumber(std::string_view text, std::string_view what);
/// The same, from `least` to `most`.
double parseNumberWithin(std::string_view text, std::string_view what, double least, double most);

/// Parses an unsigned integer of 32 bits.
unsigned parseUnsigned(std::string_view text, std::string_view what);

/// The beginning of a text or of bytes that somebody sent, safe for a terminal and a log: one line of printable ASCII,
/// all else as `\n`, `\r`, `\t` or `\xNN`, at most `most` characters and then "...".
std::string excerptOf(std::string_view bytes, std::size_t most = 80);

/// Without the blanks and the ends of lines around it.
std::string_view trimmed(std::string_view text);

/// The parts between separators, empty ones too.
std::vector<std::string> split(std::string_view text, char separator);

/// A text of at most `most` bytes: its beginning and its end around "..." if it is longer. Never cuts a UTF-8
/// character.
std::string shortened(std::string_view text, std::size_t most);

/// A text of others, a name or a file's content, as part of one line on a terminal: control characters, which could
/// move the cursor or hide what was said, marks that turn the direction of writing, and bytes that are not UTF-8 become
/// escapes (`\n`, `\u001b`, `\xff`).
std::string forTerminal(std::string_view text);

/// "a, b, c" of what `text_of`, a function or a member, says of items.
template <class Items, class TextOf = std::identity>
std::string inARow(const Items& items, TextOf text_of = {}, std::string_view separator = ", ") {
  std::string row;
  for (const auto& item : items) {
    if (!row.empty()) row += separator;
    row += std::invoke(text_of, item);
  }
  return row;
}

/// "1, 2 and 3" of items that have a `toString`.
template <class Items>
std::string listText(const Items& items) {
  std::string words;
  std::size_t index = 0;
  for (const auto& item : items) {
    if (index > 0) words += index + 1 == items.size() ? " and " : ", ";
    words += toString(item);
    ++index;
  }
  return words;
}

}  // namespace hexoderm
