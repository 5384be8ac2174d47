#pragma once

#include "hexoderm/device/protocol_violation.h"

#include <algorithm>
#include <vector>

namespace hexoderm {

/// What a device did wrong so far: the first offence of each kind, in the order in which they came, and their counts.
class ProtocolViolationLog {
 public:
  void add(const ProtocolViolation& offence) {
    if (addAgain(offence.kind, offence.count)) return;
    offences_.push_back(offence);
    has_news_ = true;
  }
  /// Adds to the count of a kind that came before; false if none did.
  bool addAgain(ProtocolViolationKind kind, std::uint64_t count) {
    const auto known = find(kind);
    if (known == offences_.end()) return false;
    known->count += count;
    return true;
  }
  /// Adds a cause, which is known only later, to the reason of a kind that came before; false if none did.
  bool explain(ProtocolViolationKind kind, const Message& cause) {
    const auto known = find(kind);
    if (known == offences_.end()) return false;
    known->reason = message("{} ({})", known->reason, cause);
    has_news_ = true;
    return true;
  }

  [[nodiscard]] const std::vector<ProtocolViolation>& offences() const { return offences_; }
  [[nodiscard]] bool has(ProtocolViolationKind kind) { return find(kind) != offences_.end(); }

  /// Whether a kind came for the first time since takeNews().
  [[nodiscard]] bool hasNews() const { return has_news_; }
  void takeNews() { has_news_ = false; }

 private:
  std::vector<ProtocolViolation>::iterator find(ProtocolViolationKind kind) {
    return std::ranges::find(offences_, kind, &ProtocolViolation::kind);
  }

  std::vector<ProtocolViolation> offences_;
  bool has_news_ = false;
};

}  // namespace hexoderm
