#pragma once

#include <cstdint>
#include <filesystem>
#include <span>

namespace hexoderm::fuzz {

/// A file of this process, in a folder that goes away with it; in memory where the system has a folder for that.
class ScratchFile {
 public:
  explicit ScratchFile(const char* name);
  ~ScratchFile();
  ScratchFile(const ScratchFile&) = delete;
  ScratchFile& operator=(const ScratchFile&) = delete;

  void write(std::span<const std::uint8_t> bytes) const;
  [[nodiscard]] const std::filesystem::path& path() const { return path_; }
  /// Whether the file is alone in its folder: nothing was left beside it.
  [[nodiscard]] bool isAlone() const;

 private:
  std::filesystem::path folder_;
  std::filesystem::path path_;
};

}  // namespace hexoderm::fuzz
