#include "hexoderm/device/protocol_violation_log.h"

#include <algorithm>

namespace hexoderm {

bool ProtocolViolationLog::addAgain(ProtocolViolationKind kind, std::uint64_t count) {
  const auto known = std::ranges::find(offences_, kind, &ProtocolViolation::kind);
  if (known == offences_.end()) return false;
  known->count += count;
  return true;
}

bool ProtocolViolationLog::explain(ProtocolViolationKind kind, const Message& cause) {
  const auto known = std::ranges::find(offences_, kind, &ProtocolViolation::kind);
  if (known == offences_.end()) return false;
  known->reason = message("{} ({})", known->reason, cause);
  has_news_ = true;
  return true;
}

void ProtocolViolationLog::add(const ProtocolViolation& offence) {
  if (addAgain(offence.kind, offence.count)) return;
  offences_.push_back(offence);
  has_news_ = true;
}

bool ProtocolViolationLog::has(ProtocolViolationKind kind) const {
  return std::ranges::find(offences_, kind, &ProtocolViolation::kind) != offences_.end();
}

}  // namespace hexoderm
