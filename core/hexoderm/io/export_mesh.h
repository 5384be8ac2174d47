#pragma once

// The formats that hold a mesh of the cells: their prisms, in PLY and OBJ in the colours of each cell's worst used
// link. The selection says in which frame the reconstruction is.

#include "hexoderm/io/export_selection.h"

#include <string>

namespace hexoderm {

/// ASCII PLY in metres with uchar colours and a comment that names unit and frame.
std::string plyText(const Reconstruction& reconstruction, const ExportSelection& selection = {});

/// Binary STL, in the unit asked for.
std::string stlBytes(const Reconstruction& reconstruction, LengthUnit unit);

/// Wavefront OBJ in metres: an object "cell_N" for each cell, its colour at each vertex ("v x y z r g b", which most
/// programs read and others skip), no file of materials.
std::string objText(const Reconstruction& reconstruction, const ExportSelection& selection = {});

}  // namespace hexoderm
