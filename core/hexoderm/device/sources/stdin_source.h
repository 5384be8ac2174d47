#pragma once

#include "hexoderm/device/skin_source.h"

#include <chrono>
#include <memory>

namespace hexoderm {

/// A skin on standard input, or on any other file descriptor: lines of JSON, or frames as on TCP. It can't be asked for
/// anything, so every command fails. The end of the input is the end of the source (Ended); it is never opened again.
/// `descriptor` is neither closed nor changed, and must stay open until stop().
std::unique_ptr<SkinSource> stdinSource(int descriptor = 0, std::chrono::milliseconds silent_after = kSilentAfter);

}  // namespace hexoderm
