#include "hexoderm/device/protocol_violation.h"

#include "hexoderm/base/enum_names.h"

#include <array>

namespace hexoderm {
namespace {

constexpr EnumNames<ProtocolViolationKind> kViolationNames = {
    {"broken-frame",       "wrong-dialect",  "no-line-feed",  "not-json",           "not-a-message",
     "unknown-message",    "unknown-field",  "wrong-type",    "wrong-value",        "wrong-length",
     "other-version",      "not-described",  "cell-model",    "cell-model-changed", "no-cells",
     "cell-id-zero",       "duplicate-cell", "unknown-port",  "unknown-neighbour",  "one-sided-link",
     "contradictory-link", "unknown-cell",   "repeated-cell", "no-scale",           "no-time",
     "time-backwards",     "time-unit",      "sequence",      "acceleration-unit",  "not-gravity"}};

}  // namespace

std::span<const ProtocolViolationKind> offenceKinds() {
  static const auto kinds = [] {
    std::array<ProtocolViolationKind, kViolationNames.names.size()> all{};
    for (std::size_t k = 0; k < all.size(); ++k) all[k] = static_cast<ProtocolViolationKind>(k);
    return all;
  }();
  return kinds;
}

std::string_view offenceName(ProtocolViolationKind kind) { return kViolationNames.of(kind); }

Message inWords(const ProtocolViolation& offence) {
  return offence.excerpt.empty() ? offence.reason
                                 : message("{}; the message begins: {}", offence.reason, offence.excerpt);
}

}  // namespace hexoderm
