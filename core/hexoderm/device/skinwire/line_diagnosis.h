#pragma once

// For the maker of a device, not for its messages.

#include "hexoderm/device/protocol_violation.h"

#include <string_view>
#include <vector>

namespace hexoderm::skinwire {

/// Whether a text has two messages of the line dialect with something else than a line feed in between.
bool lacksLineFeeds(std::string_view text);

/// What is wrong with a line, found by comparing it with the messages of skinwire.proto: the first of each kind, that
/// which the others may follow from first. Empty for a line without an unknown field that protobuf can read.
std::vector<ProtocolViolation> offencesOfLine(std::string_view line);

}  // namespace hexoderm::skinwire
