#pragma once

#include "hexoderm/device/simulation/simulated_skin.h"
#include "hexoderm/session/session.h"

namespace hexoderm {

/// A session without poses on a simulated skin: its model, neighbours, description and truth.
Session beginSimulatedSession(const SimulatedSkin& skin);

/// A whole scripted calibration of a simulated skin: `pose_count` poses as SimulatedSkin::upDirections() has them, each
/// the mean of `frame_count` samples.
Session simulateSession(SimulatedSkin& skin, std::size_t pose_count, std::size_t frame_count = 100);

}  // namespace hexoderm
