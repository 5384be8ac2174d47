#pragma once

// Faults of the simulator, as people write them.

#include "hexoderm/base/enum_names.h"
#include "hexoderm/sim/skin_faults.h"

#include <string>

namespace hexoderm {

struct SkinChoice;

inline constexpr EnumNames<SkinFault> kSkinFaultNames = {{"dead", "stuck", "stuck-axis", "dead-axis", "saturated",
                                                          "noisy", "wrong-gain", "no-samples", "echo", "swapped",
                                                          "yawed", "reglued"}};
inline constexpr EnumNames<LinkFaultKind> kLinkFaultNames = {{"wrong-port", "joint", "cable"}};
inline constexpr EnumNames<WholeSkinFault> kWholeSkinFaultNames = {
    {"identical", "axes-swapped", "axes-permuted", "ports-rotated", "port-offset", "shuffled", "random"}};

/// The faults of a simulated skin as people write them: "KIND:CELL with KIND dead, ...".
std::string faultSyntax();
/// Adds a fault in that syntax to a skin. Throws InvalidArgument, which begins with `what` ("--fault").
void addFault(const std::string& text, const std::string& what, SkinChoice& skin);

}  // namespace hexoderm
