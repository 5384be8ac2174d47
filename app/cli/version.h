#pragma once

#include <string>

namespace hexoderm::cli {

/// The commit of the sources, and whether they had changes; empty if it is not known. Defined in a source that is
/// written when the program is built.
extern const char* const kCommit;

/// What `--version` says: version and commit, versions of files and wire, and libraries. The first line is the
/// program's name and version.
std::string versionText();

}  // namespace hexoderm::cli
