#pragma once

#include "hexoderm/solve/faults/explanation.h"
#include "hexoderm/solve/tree/skin_links.h"

#include <span>
#include <vector>

namespace hexoderm {

/// Per link: by how many deviations its angles lie outside the scatter (median absolute deviation) of the other links
/// of its patch, or its cells moved against each other, whichever is more. That alone says nothing against a link; 0
/// for one that is muted or not measured.
std::vector<double> linkDeviations(const SkinLinks& skin);

/// The links of the tear that a link belongs to: those side by side with it between the cells that are nearer to its
/// source and those that are nearer to its target, by links that are not odd (4 deviations); along the tear cells go to
/// the side that their links speak for. Empty where the others of them stand out by less than 3.5 deviations (rms), and
/// unless both sides have more cells than the tear has links: around a few cells it is the cells that are wrong.
/// `deviations`: per link.
std::vector<std::size_t> tearThrough(const SkinLinks& skin, std::size_t link, std::span<const double> deviations);

/// TornSkin about these links of the graph, the ends of which it names link by link.
Finding describeTear(const SkinLinks& skin, std::vector<std::size_t> links);

/// Makes one finding of all that an explanation says about links of one tear.
void foldTears(const SkinLinks& skin, Explanation& explanation);

}  // namespace hexoderm
