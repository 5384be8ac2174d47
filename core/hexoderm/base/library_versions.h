#pragma once

#include <string>
#include <vector>

namespace hexoderm {

struct LibraryVersion {
  std::string name;
  std::string version;
};

/// The libraries that this one is made with, by name. Of a shared library that can tell, the version that is loaded; of
/// all others the one that was compiled with.
std::vector<LibraryVersion> libraryVersions();

}  // namespace hexoderm
