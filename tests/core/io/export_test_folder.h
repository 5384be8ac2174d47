#pragma once

#include "hexoderm/base/file.h"
#include "tests/support/temporary_folder.h"
#include "tests/support/testing.h"

namespace hexoderm {

/// A folder of a test's own, gone at its end.
class ExportTest : public ::testing::Test {
 protected:
  [[nodiscard]] std::filesystem::path in(const std::string& name) const { return folder_ / name; }
  /// Names of everything in the folder and below, hidden things too.
  [[nodiscard]] std::vector<std::string> names() const {
    std::vector<std::string> found;
    for (const auto& entry : std::filesystem::recursive_directory_iterator(folder_)) {
      found.push_back(entry.path().lexically_relative(folder_).string());
    }
    std::ranges::sort(found);
    return found;
  }

  const test::TemporaryFolder temporary_;
  const std::filesystem::path& folder_ = temporary_.path();
};

}  // namespace hexoderm
