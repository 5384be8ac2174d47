#pragma once

#include <filesystem>
#include <string>
#include <string_view>

namespace hexoderm {

/// The whole file as bytes. Throws StorageError naming the file if it is missing, a folder or unreadable.
std::string readFile(const std::filesystem::path& path);

/// Writes a temporary file beside `path`, syncs it, renames it over `path` and syncs the folder: at any moment either
/// the old or the new content is there, whole. Throws StorageError naming the file and the reason.
void writeFileAtomically(const std::filesystem::path& path, std::string_view content);

}  // namespace hexoderm
