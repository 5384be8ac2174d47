#pragma once

#include "hexoderm/device/simulation/skin_faults.h"

#include <span>
#include <string_view>
#include <utility>

namespace hexoderm {

/// Names of the simulator's faults, for the command line, in the order in which they are listed.
std::span<const std::pair<std::string_view, SkinFault>> skinFaultNames();
std::span<const std::pair<std::string_view, LinkFaultKind>> linkFaultNames();  ///< the same of faults of links
/// The same of faults of all cells at once.
std::span<const std::pair<std::string_view, WholeSkinFault>> wholeSkinFaultNames();

}  // namespace hexoderm
