#pragma once

#include <string>
#include <string_view>

namespace hexoderm {

/// A text as one field of a CSV file (RFC 4180): in quotes if it holds a comma, a quote or a line break, or starts or
/// ends with a space, which some readers would trim; a quote inside is doubled.
inline std::string csvQuoted(std::string_view text) {
  const bool plain =
      text.find_first_of("\",\r\n") == std::string_view::npos && !text.starts_with(' ') && !text.ends_with(' ');
  if (plain) return std::string(text);
  std::string result = "\"";
  for (const char c : text) {
    if (c == '"') result += '"';
    result += c;
  }
  return result + '"';
}

}  // namespace hexoderm
