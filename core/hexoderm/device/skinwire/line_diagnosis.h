#pragma once

// Private to skinwire/: for the maker of a device, not for its messages.

#include "hexoderm/device/offence.h"

#include <string_view>
#include <vector>

namespace hexoderm::skinwire {

/// What is wrong with a line, found by comparing it with the messages of skinwire.proto: the first of each kind, that
/// which the others may follow from first. Empty for a line without an unknown field that protobuf can read.
std::vector<Offence> offencesOfLine(std::string_view line);

}  // namespace hexoderm::skinwire
