#include "hexoderm/base/csv.h"

#include <boost/algorithm/string/replace.hpp>

#include <algorithm>
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
  return '"' + boost::algorithm::replace_all_copy(harmless, "\"", "\"\"") + '"';
}

std::optional<std::vector<std::string>> csvFields(std::string_view line, char separator) {
  std::vector<std::string> fields;
  std::size_t at = 0;
  while (true) {
    std::string& field = fields.emplace_back();
    if (at < line.size() && line[at] == '"') {
      for (++at; at < line.size(); ++at) {
        if (line[at] != '"') {
          field += line[at];
        } else if (at + 1 < line.size() && line[at + 1] == '"') {
          field += line[at++];
        } else {
          break;
        }
      }
      if (at == line.size()) return std::nullopt;
      ++at;
      if (at < line.size() && line[at] != separator) return std::nullopt;
    } else {
      const std::size_t end = std::min(line.find(separator, at), line.size());
      field = line.substr(at, end - at);
      at = end;
    }
    if (at == line.size()) return fields;
    ++at;
  }
}

}  // namespace hexoderm
