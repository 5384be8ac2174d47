#pragma once

#include "app/window/session/place_facts.h"
#include "widgets/robot/robot_scene.h"

#include <cstddef>
#include <optional>

namespace hexoderm {

/// The robot as it stands in the shown pose, with the patches where they were placed, are proposed or are held; one
/// that was put by hand waits for its fit where it was put.
[[nodiscard]] RobotPicture robotPicture(const PlaceFacts& facts, const HandPlace& hand);

/// Where a patch is among those of a picture; nullopt: it isn't drawn.
[[nodiscard]] std::optional<std::size_t> indexInPicture(const RobotPicture& picture, const PatchReconstruction* patch);

}  // namespace hexoderm
