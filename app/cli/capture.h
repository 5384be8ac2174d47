#pragma once

#include "app/cli/command.h"

#include <cstddef>
#include <string>

namespace hexoderm::cli {

/// One live capture: `capture` itself, and what `check` compares.
struct CaptureOptions {
  std::string source;
  std::string output;     ///< *.hexo, a new file
  std::string recording;  ///< empty: none
  std::size_t poses = 0;  ///< 0: as many as the course of a capture takes
  bool automatic = false;
  bool keep_raw = false;
  double timeout_s = 30;
};

/// Throws InvalidArgument or StorageError for a name that a capture can't be kept under.
void requireNewSession(const std::string& output);

/// Captures and returns the session, which may have no pose. Says on standard error what goes on.
Session captureSession(const CaptureOptions& options, const Common& common);

}  // namespace hexoderm::cli
