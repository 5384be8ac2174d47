#pragma once

// Zip archives in memory (libzip).

#include <span>
#include <string>

namespace hexoderm {

/// A file in an archive; folders in its name are parted by slashes.
struct ZipEntry {
  std::string name;
  std::string content;
};

/// The bytes of a zip archive of these files, compressed. Throws StorageError if there is no memory for them.
std::string zipBytes(std::span<const ZipEntry> entries);

}  // namespace hexoderm
