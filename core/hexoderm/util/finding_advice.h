#pragma once

#include "hexoderm/util/finding.h"

#include <span>
#include <vector>

namespace hexoderm {

/// What an operator can do about a finding with the program itself, about the link, the pose or the cell that the
/// finding names. Whether it can be done just now depends on the session and the device.
enum class FindingRemedy {
  MuteLink,       ///< or let it in again, where it is set aside
  DisablePose,    ///< or enable it
  RecapturePose,  ///< the next capture takes its place
  TakePose,
  LightCell,  ///< on the skin itself, to find it
};

/// What stands behind a code, and what helps.
struct FindingAdvice {
  FindingCode code;
  Message why;         ///< why the program thinks so; one sentence or two
  Message what_to_do;  ///< for a person at the skin
  std::vector<FindingRemedy> remedies;
};

/// One entry per code, in the order of the enumeration.
std::span<const FindingAdvice> findingAdvice();
const FindingAdvice& adviceOn(FindingCode code);  ///< the advice on a kind of finding

}  // namespace hexoderm
