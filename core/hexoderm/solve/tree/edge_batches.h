#pragma once

#include "hexoderm/base/vector_instructions.h"
#include "hexoderm/solve/tree/edge_kernel.h"
#include "hexoderm/solve/tree/skin_links.h"

#include <optional>
#include <span>
#include <vector>

namespace hexoderm {

/// What the kernel needs to know of a cell model and of how edges are to be solved; as estimateEdgeRotation() does it.
EdgeKernelOptions edgeKernelOptions(const CellModel& model, const SolverOptions& options);

using EdgeKernel = void (*)(const EdgeKernelOptions&, const EdgeKernelInput&, EdgeKernelOutput&);
/// The fastest kernel that the computer can run.
inline EdgeKernel fastestEdgeKernel() { return hasVectorInstructions() ? estimateEdgesByFour : estimateEdgesByTwo; }

/// The rotations of the usual ones of these links, several at a time, by the skin's readings: those of which at least
/// two poses with clearly different directions are known, and that need no support axes. Equal to
/// estimateEdgeRotation() but for rounding. Go into `edges`, with their figures, and `pose_residuals`: per link of the
/// graph and pose of the table. Returns the links that are not usual, whose edges are left as they are.
std::vector<std::size_t> estimateUsualEdges(const SkinLinks& skin, std::span<const std::size_t> links,
                                            std::vector<EdgeRotation>& edges,
                                            std::vector<std::optional<double>>& pose_residuals,
                                            EdgeKernel kernel = fastestEdgeKernel());

}  // namespace hexoderm
