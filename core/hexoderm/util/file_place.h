#pragma once

// Private to core: whether an open file still has the name that it was opened by.

#include <filesystem>
#include <optional>

namespace hexoderm {

/// Whether `path`, links followed, names the open file.
[[nodiscard]] bool isAt(const std::filesystem::path& path, int descriptor);
/// Where the open file is now; nullopt if that is not known, as a rule because it was removed.
[[nodiscard]] std::optional<std::filesystem::path> placeOf(int descriptor);

}  // namespace hexoderm
