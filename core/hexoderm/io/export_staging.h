#pragma once

#include <filesystem>
#include <functional>
#include <string>
#include <vector>

namespace hexoderm {

/// Checks the bytes of a file as read back from the disk; throws FormatError if they are not what was meant.
using VerifyBytes = std::function<void(const std::string& bytes)>;

struct StagedFile {
  std::string name;  ///< without folders
  std::string content;
  VerifyBytes verify;
};

/// Writes the content into a temporary folder beside `path`, reads it back, verifies it, and only then renames it to
/// `path`. On any failure an earlier file of that name stays as it was and nothing else is left. Throws StorageError
/// and what `verify` throws.
void publishFile(const std::filesystem::path& path, std::string content, VerifyBytes verify);

/// Publishes the files of a folder in the same way, all or none. A missing folder is made; other files in an existing
/// one are not touched. Returns the paths of the files, in their order.
std::vector<std::filesystem::path> publishFolder(const std::filesystem::path& folder,
                                                 const std::vector<StagedFile>& files);

}  // namespace hexoderm
