#pragma once

#include "tests/support/temporary_folder.h"

namespace hexoderm::fuzz {

/// A file of this process, in a folder that goes away with it; in memory where the system has a folder for that.
class ScratchFile {
 public:
  explicit ScratchFile(const char* name) : path_(folder_.path() / name) {}
  void write(std::string_view bytes) const { folder_.put(path_.filename(), bytes); }
  [[nodiscard]] const std::filesystem::path& path() const { return path_; }
  /// Whether nothing was left beside it.
  [[nodiscard]] bool isAlone() const { return folder_.entryCount() == 1; }

 private:
  test::TemporaryFolder folder_{std::filesystem::is_directory("/dev/shm") ? "/dev/shm"
                                                                          : std::filesystem::temp_directory_path()};
  std::filesystem::path path_;
};

}  // namespace hexoderm::fuzz
