#pragma once

#include "hexoderm/session/session.h"

#include <filesystem>
#include <string>
#include <string_view>

namespace hexoderm {

/// `*.session.json` (SPEC section 3). Beyond what is described there, a pose has `"taken_at_ms"?` (milliseconds since
/// 1970, UTC) and `"why_disabled"?`, a sample has `"temperature_c"?`, and `"muted_links"?` are those that the operator
/// set aside: `[{"source": 5, "source_port": 2, "target": 9, "target_port": 3, "why": "a cable"?}]`, their ends in
/// either order. Keys that the reader does not know are ignored. Numbers come back as the same doubles. Reading throws
/// StorageError (missing, unreadable) or FormatError naming file, key path and expectation; nothing is changed by a
/// failed read. The topology is taken as reported: contradictions are for SkinGraph to find.
Session readSessionJson(const std::filesystem::path& path);
Session parseSessionJson(std::string_view text, const std::string& file);

std::string sessionToJson(const Session& session);
/// Atomic. Throws StorageError.
void writeSessionJson(const Session& session, const std::filesystem::path& path);

}  // namespace hexoderm
