#pragma once

#include "hexoderm/skin/skin_graph.h"

#include <vector>

namespace hexoderm {

/// What alone holds patches together, by biconnected components (J. Hopcroft and R. Tarjan, "Algorithm 447: efficient
/// algorithms for graph manipulation", Communications of the ACM 16, 1973). Muted links count as taken out.
struct CutElements {
  std::vector<bool> is_bridge;        ///< per link: it is in no loop, and its patch falls apart without it
  std::vector<bool> is_articulation;  ///< per cell: its patch falls apart without it
};

CutElements findCutElements(const SkinGraph& graph);

/// The links that are in all loops through a link, with it: without any one of them, none of these loops is left. In a
/// ring these are all its links, inside a sheet it is mostly the link alone. Empty for a bridge, and a muted link.
std::vector<std::size_t> linksOfAllLoopsThrough(const SkinGraph& graph, std::size_t link);

}  // namespace hexoderm
