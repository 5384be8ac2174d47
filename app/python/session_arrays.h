#pragma once

#include "app/python/arrays.h"

#include "hexoderm/session/session.h"

#include <pybind11/pybind11.h>

#include <cstddef>
#include <optional>
#include <string>

namespace hexoderm::python {

/// A pose as arrays, in the order of the session's cells.
struct PoseArrays {
  std::optional<std::size_t> index;    ///< its place in arrays of several poses, for errors
  Doubles readings;                    ///< (cells, 3); NaN: no reading
  std::optional<Doubles> covariances;  ///< (cells, 3, 3)
  std::optional<Numbers> counts;       ///< (cells,)
  std::string label;
  JointAngles joint_angles;
};

/// The pose with the next ID of the session. Throws InvalidArgument naming the array that does not fit.
SessionPose poseFrom(const Session& session, const PoseArrays& arrays);

/// Throws as if the session were read from a file: numbers that make no sense, readings in another unit than g.
void checkAsFile(const Session& session);

void bindSessionArrays(pybind11::class_<Session>& session);

}  // namespace hexoderm::python
