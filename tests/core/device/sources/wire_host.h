#pragma once

// A host that waits as long as a busy computer takes.

#include "hexoderm/device/sources/wire_source.h"
#include "tests/core/device/skinwire/collecting_listener.h"
#include "tests/support/testing.h"

#include <chrono>

namespace hexoderm {

/// Options for tests in which nothing may time out: every event has another reason.
inline WireOptions patient() {
  return {.first_retry = std::chrono::milliseconds(10),
          .silent_after = test::kForever,
          .reconnect_after = test::kForever,
          .command_timeout = test::kForever};
}

struct WireHost {
  explicit WireHost(const std::string& address, const WireOptions& options = patient())
      : source(wireSource(address, options)) {
    source->start(listener);
  }

  bool waitForFrames(std::size_t count) {
    return listener.waitFor([&](const CollectingListener::Delivered& d) { return d.frames.size() >= count; });
  }
  CommandOutcome ask(const SkinCommand& command) {
    const std::uint32_t number = source->send(command);
    EXPECT_TRUE(
        listener.waitFor([&](const CollectingListener::Delivered& d) { return d.outcomeOf(number) != nullptr; }));
    const CollectingListener::Delivered delivered = listener.delivered();
    const CommandOutcome* outcome = delivered.outcomeOf(number);
    return outcome == nullptr ? CommandOutcome{} : *outcome;
  }

  CollectingListener listener;
  std::unique_ptr<SkinSource> source;
};

}  // namespace hexoderm
