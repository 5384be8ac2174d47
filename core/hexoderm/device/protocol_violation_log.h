#pragma once

#include "hexoderm/device/protocol_violation.h"

#include <vector>

namespace hexoderm {

/// What a device did wrong so far: the first offence of each kind, in the order in which they came, and their counts.
class ProtocolViolationLog {
 public:
  void add(const ProtocolViolation& offence);
  /// Adds to the count of a kind that came before; false if none did.
  bool addAgain(ProtocolViolationKind kind, std::uint64_t count);
  /// Adds a cause, which is known only later, to the reason of a kind that came before; false if none did.
  bool explain(ProtocolViolationKind kind, const Message& cause);
  [[nodiscard]] const std::vector<ProtocolViolation>& offences() const { return offences_; }
  [[nodiscard]] bool has(ProtocolViolationKind kind) const;
  /// Whether a kind came for the first time since takeNews().
  [[nodiscard]] bool hasNews() const { return has_news_; }
  void takeNews() { has_news_ = false; }

 private:
  std::vector<ProtocolViolation> offences_;
  bool has_news_ = false;
};

}  // namespace hexoderm
