#pragma once

namespace hexoderm {

enum class Coloring;
class ScaleRanges;

/// Fixes the ranges of scales that the operator fixed before, as kept in the settings. What makes no sense there
/// (edited by hand, of another version) is left out.
void restoreScaleRanges(ScaleRanges& ranges);
/// Keeps the range of a colouring for the next start, or that it is fixed no longer.
void keepScaleRange(const ScaleRanges& ranges, Coloring coloring);

}  // namespace hexoderm
