#include "hexoderm/device/sources/open_source.h"

#include "hexoderm/base/error.h"
#include "hexoderm/base/text.h"
#include "hexoderm/device/sources/recording.h"
#include "hexoderm/device/sources/stdin_source.h"
#include "hexoderm/device/sources/wire_source.h"

#include <algorithm>
#include <limits>
#include <utility>
#include <vector>

namespace hexoderm {
namespace {

std::unique_ptr<SkinSource> openWire(const std::string& address) { return wireSource(address); }

std::unique_ptr<SkinSource> openStdin(const std::string& address) {
  if (address != "stdin")
    throw InvalidArgument(message("source \"{}\": expected stdin, without anything behind", address));
  return stdinSource();
}

std::unique_ptr<SkinSource> openReplay(const std::string& address) {
  constexpr std::string_view kPrefix = "replay:";
  constexpr std::string_view kSpeed = "?speed=";
  std::string file = address.substr(kPrefix.size());
  ReplayOptions options;
  // A file's name may have a question mark of its own.
  if (const std::size_t query = file.rfind(kSpeed); query != std::string::npos) {
    const std::string speed = file.substr(query + kSpeed.size());
    file.resize(query);
    if (speed == "max") {
      options.speed = std::numeric_limits<double>::infinity();
    } else if (speed == "step") {
      options.stepwise = true;
    } else {
      options.speed = parseNumber(speed, "source \"" + address + "\": speed (above 0, max or step)");
    }
  }
  if (file.empty()) throw InvalidArgument(message("source \"{}\": expected replay:FILE[?speed=X|max|step]", address));
  return replaySource(file, options);
}

std::vector<SourceKind>& kinds() {
  // Until they are started these hold their address and no more, so that opening one is a check of it.
  const auto by_opening = [](auto open) { return [open](const std::string& address) { open(address); }; };
  static std::vector<SourceKind> kinds = {
      {"tcp://", "tcp://HOST:PORT", openWire, by_opening(openWire)},
      {"udp://", "udp://HOST:PORT", openWire, by_opening(openWire)},
      {"serial:", "serial:/dev/DEVICE[?baud=N]", openWire, by_opening(openWire)},
      {"stdin", "stdin", openStdin, by_opening(openStdin)},
      {"replay:", "replay:FILE[?speed=X|max|step]", openReplay, by_opening(openReplay)},
  };
  return kinds;
}

const SourceKind& kindOf(const std::string& address) {
  for (const SourceKind& kind : sourceKinds()) {
    if (address.starts_with(kind.prefix)) return kind;
  }
  throw InvalidArgument(message("source \"{}\": expected one of {}", address, sourceKindsText()));
}

}  // namespace

std::string sourceKindsText() { return inARow(sourceKinds(), &SourceKind::example); }

std::span<const SourceKind> sourceKinds() { return kinds(); }

void addSourceKind(SourceKind kind) {
  const auto same = std::ranges::find(kinds(), kind.prefix, &SourceKind::prefix);
  if (same == kinds().end()) {
    kinds().push_back(std::move(kind));
  } else {
    *same = std::move(kind);
  }
}

std::unique_ptr<SkinSource> openSkinSource(const std::string& address) { return kindOf(address).open(address); }

void checkSkinAddress(const std::string& address) { kindOf(address).check(address); }

}  // namespace hexoderm
