#pragma once

// The two ways to read a session file.

#include "hexoderm/session/session.h"

#include <optional>
#include <string>
#include <string_view>

namespace hexoderm {

/// The quick one, which makes no document of the text: for files that are as they usually are. nullopt for any other,
/// be it right or wrong. What it reads, sessionFromDocument() reads as the same session, to the last bit.
std::optional<Session> scanSessionJson(std::string_view text, const std::string& file);

/// The thorough one, which throws FormatError with what is wrong and where.
Session sessionFromDocument(std::string_view text, const std::string& file);

}  // namespace hexoderm
