#pragma once

#include "hexoderm/session/session.h"

#include <filesystem>
#include <string>
#include <string_view>

namespace hexoderm {

/// `*.session.json` (SPEC section 3). Reading throws StorageError (missing, unreadable) or FormatError naming file, key
/// path and expectation; nothing is changed by a failed read. The topology is taken as reported: contradictions are for
/// SkinGraph to find.
Session readSessionJson(const std::filesystem::path& path);
Session parseSessionJson(std::string_view text, const std::string& file);

std::string sessionToJson(const Session& session);
/// Atomic. Throws StorageError.
void writeSessionJson(const Session& session, const std::filesystem::path& path);

}  // namespace hexoderm
