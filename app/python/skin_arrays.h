#pragma once

#include "app/python/arrays.h"

#include "hexoderm/session/session.h"

#include <pybind11/pybind11.h>

#include <cstdint>
#include <string>
#include <vector>

namespace hexoderm::python {

/// Throws InvalidArgument naming `what` unless this can be an ID.
std::uint32_t idFrom(std::int64_t value, const char* what);

/// Of cells (N,) and links (links, 4), which both cells report, as after an exploration. Throws InvalidArgument naming
/// what does not fit.
NeighborList neighborsFrom(const Numbers& cells, const Numbers& links, const std::vector<std::string>& parts);
/// Each link once, from the end that reports it first; -1 for a port that was not reported.
Numbers linksOf(const Session& session);

/// Of (cells, positions, rotations), as Session.truth has it. Throws InvalidArgument, or TypeError for another type.
GroundTruth truthFrom(const pybind11::object& truth, const NeighborList& skin);
/// (cells, positions, rotations), in the frame of the truth; None where it is not known.
pybind11::object truthOf(const Session& session);

}  // namespace hexoderm::python
