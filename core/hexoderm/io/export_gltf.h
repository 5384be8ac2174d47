#pragma once

#include "hexoderm/io/exporter.h"

#include <string>

namespace hexoderm {

/// glTF 2.0 in its binary form (.glb), metres. glTF has +Y up: the root node turns the skin's frame, whose z becomes
/// that +Y. Below it a node "cell_N" for each cell, with its place as translation and rotation and one of five shared
/// meshes, one a colour, and below that a node for each sensor. The frame is said in the root node's extras.
std::string gltfBytes(const Reconstruction& reconstruction, const std::string& frame);

}  // namespace hexoderm
