#pragma once

#include "hexoderm/base/file.h"
#include "hexoderm/session/session.h"

#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>

namespace hexoderm {

/// What stands under `format` and `version`; resources/formats/README.md says when the version grows.
inline constexpr std::string_view kSessionFormat = "hexoderm-session";
inline constexpr std::uint32_t kSessionVersion = 1;  ///< the newest version, which is written

/// `*.session.json` (its keys are in resources/formats/README.md). Keys that the reader does not know are ignored.
/// Numbers come back as the same doubles. Reading throws StorageError (missing, unreadable) or FormatError naming file,
/// key path and expectation, also where the readings are not in g but in m/s^2, mg or LSB, as far as their norm tells;
/// nothing is changed by a failed read. The topology is taken as reported: SkinGraph finds its contradictions.
Session readSessionJson(const std::filesystem::path& path);
/// The same of a text; `file` is named in errors.
Session parseSessionJson(std::string_view text, const std::string& file);

/// The text, in pieces; as a whole; and as a file, atomically, which throws StorageError. Numbers that are not finite
/// are InvalidArgument.
void writeSessionJson(const Session& session, const WriteBytes& write);
std::string sessionToJson(const Session& session);                                 ///< the text as a whole
void writeSessionJson(const Session& session, const std::filesystem::path& path);  ///< the text as a file, atomically

}  // namespace hexoderm
