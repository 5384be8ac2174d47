#pragma once

#include "hexoderm/reconstruction/result/reconstruction.h"

#include <string>

namespace hexoderm {

/// A cluster per patch, a node per cell at its place in the flat layout (real size; `neato` and `fdp` read `pos` in
/// inches), two directed edges per link with the ports at their ends and the quality as colour, style and tooltip.
std::string dotText(const Reconstruction& reconstruction);

}  // namespace hexoderm
