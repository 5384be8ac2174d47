#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace hexoderm {

/// A text that a spreadsheet takes as a text: one that begins with =, +, -, @, a tab or a line break, which would be
/// run as a formula, gets an apostrophe in front. A finite number, such as -1.5, stays as it is.
std::string csvHarmless(std::string_view text);

/// A text as one field of a CSV file (RFC 4180), harmless: in quotes if it holds a comma, a quote or a line break, or
/// starts or ends with a space, which some readers would trim; a quote inside is doubled.
std::string csvQuoted(std::string_view text);

/// The fields of one line (RFC 4180) without its end: quotes around a field are taken off, and a doubled one inside is
/// one. nullopt if a quote is not closed, or something follows one that is. Line breaks inside fields are not known.
std::optional<std::vector<std::string>> csvFields(std::string_view line, char separator = ',');

}  // namespace hexoderm
