#include "hexoderm/device/offence_log.h"

#include <algorithm>

namespace hexoderm {

bool OffenceLog::addAgain(OffenceKind kind, std::uint64_t count) {
  const auto known = std::ranges::find(offences_, kind, &Offence::kind);
  if (known == offences_.end()) return false;
  known->count += count;
  return true;
}

bool OffenceLog::explain(OffenceKind kind, const Message& cause) {
  const auto known = std::ranges::find(offences_, kind, &Offence::kind);
  if (known == offences_.end()) return false;
  known->reason = message("{} ({})", known->reason, cause);
  has_news_ = true;
  return true;
}

void OffenceLog::add(const Offence& offence) {
  if (addAgain(offence.kind, offence.count)) return;
  offences_.push_back(offence);
  has_news_ = true;
}

bool OffenceLog::has(OffenceKind kind) const {
  return std::ranges::find(offences_, kind, &Offence::kind) != offences_.end();
}

}  // namespace hexoderm
