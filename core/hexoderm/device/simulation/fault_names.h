#pragma once

#include "hexoderm/device/simulation/skin_faults.h"

#include <span>
#include <string>
#include <string_view>
#include <utility>

namespace hexoderm {

struct SimulatedSkinOptions;

/// Names of the simulator's faults, as people write them, in the order in which they are listed.
std::span<const std::pair<std::string_view, SkinFault>> skinFaultNames();
std::span<const std::pair<std::string_view, LinkFaultKind>> linkFaultNames();  ///< the same of faults of links
/// The same of faults of all cells at once.
std::span<const std::pair<std::string_view, WholeSkinFault>> wholeSkinFaultNames();

/// The faults of a simulated skin as people write them: "KIND:CELL with KIND dead, ...".
std::string faultSyntax();
/// Adds a fault in that syntax to a skin. Throws InvalidArgument, which begins with `what` ("--fault").
void addFault(const std::string& text, const std::string& what, SimulatedSkinOptions& skin);

}  // namespace hexoderm
