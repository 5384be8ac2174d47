#pragma once

// Lays a planned patch on a surface.

#include "hexoderm/base/surface.h"
#include "hexoderm/sim/patch_plan.h"
#include "hexoderm/sim/simulated_skin.h"

#include <vector>

namespace hexoderm {

/// T_b_u of every cell of the plan: flat cells tangent to the surface at their centres, z along its normal.
///
/// From the plan's first cell each next one is reached along the geodesic that its neighbour's port points along. A
/// tree is then done. In a sheet every cell is fitted to all neighbours that are there already, and at the end the
/// sheet is relaxed.
///
/// How far eq. (2) of the paper holds between the placements: on a plane exactly, with either law. Bend law: exactly
/// along circumferences and generators of a cylinder and on spheres; sheets on a cylinder are relaxed until it is exact
/// in every direction. A tree's links that run obliquely on a cylinder miss by the geodesic's torsion (0.23 mm for X17
/// at r = 50.1 mm). Surface law: never on a curved surface; link points lie about (2/3) e a^2 apart, a = half the bend.
///
/// Throws InvalidArgument where the surface is too small: curved more sharply than a cell is wide, or the patch meets
/// itself; and where it leaves a closed ring open.
std::vector<SE3> layPatch(const PatchPlan& plan, const Surface& surface, LinkLaw law);

}  // namespace hexoderm
