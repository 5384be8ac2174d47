#pragma once

#include "hexoderm/device/skin_source.h"

#include <functional>
#include <memory>
#include <span>
#include <string>
#include <string_view>

namespace hexoderm {

/// One kind of address that openSkinSource understands.
struct SourceKind {
  std::string_view prefix;   ///< "tcp://"; an address that begins with it is of this kind
  std::string_view example;  ///< for people: "tcp://HOST:PORT"
  std::function<std::unique_ptr<SkinSource>(const std::string& address)> open;
  std::function<void(const std::string& address)> check;  ///< see checkSkinAddress()
};

/// All kinds there are, in the order in which they are listed to people.
std::span<const SourceKind> sourceKinds();
/// Adds a kind of source, or replaces the one of the same prefix. Call it before any source is opened: it is not
/// synchronised with the functions of this header.
void addSourceKind(SourceKind kind);
std::string sourceKindsText();  ///< "tcp://HOST:PORT, udp://HOST:PORT, ..."

/// A source, not yet started: "tcp://HOST:PORT", "udp://HOST:PORT", "serial:/dev/tty...[?baud=N]", "stdin",
/// "replay:FILE[?speed=X|max|step]", or of a kind that was added. Throws InvalidArgument naming the expected address,
/// and whatever the added kind throws.
std::unique_ptr<SkinSource> openSkinSource(const std::string& address);

/// Throws as openSkinSource() for what is wrong with the address itself. Opens and builds nothing, and is quick enough
/// for every key that is typed.
void checkSkinAddress(const std::string& address);

}  // namespace hexoderm
