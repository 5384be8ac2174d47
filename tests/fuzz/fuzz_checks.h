#pragma once

#include "hexoderm/base/error.h"
#include "hexoderm/session/session.h"

#include <cstddef>
#include <cstdint>
#include <span>
#include <string_view>

/// Defined by every target: returns 0, and crashes on anything that must not happen.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size);

namespace hexoderm::fuzz {

/// Crashes, which the fuzzer and the replay take for a failure, with `what` on standard error.
void require(bool condition, std::string_view what);

inline std::string_view asText(std::span<const std::uint8_t> bytes) {
  return {reinterpret_cast<const char*>(bytes.data()), bytes.size()};
}

/// Requires what every reader of sessions promises of a session that it returns: a model that makes sense, finite
/// numbers, variances of at least 0, rotations. Also that its topology makes a graph, however it contradicts itself.
void requireSound(const Session& session);

/// Requires of a complaint that a terminal can show it: of bounded length and, escaped, one line without what steers
/// it.
void requireSayable(const Error& error);

/// Calls what reads an input. It may throw an Error that a terminal can show.
template <class Read>
void takeOrComplain(const Read& read) {
  try {
    read();
  } catch (const Error& error) {
    requireSayable(error);
  }
}

}  // namespace hexoderm::fuzz
