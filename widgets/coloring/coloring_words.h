#pragma once

#include "widgets/coloring/coloring.h"

#include <QString>

namespace hexoderm {

// The words for colours in the user's language, the same in the graph and in the 3D view.

/// "link quality", for menus.
QString coloringName(Coloring coloring);

/// The title with its unit, for the graph's legend: "residual, rms over poses, °".
QString graphTitle(Coloring coloring);
/// The same for the legend of the 3D view; of classes the name.
QString patchTitle(Coloring coloring);

/// The reason why the cells of the 3D view can't be coloured by it; empty if they can.
QString whyNoColoring(Coloring coloring, bool has_values);

/// "patch 3", where patches are classes. `index` counts from 0.
QString patchWord(std::size_t index);
/// The word for cells and links without a value or a class.
QString notKnownWord();

}  // namespace hexoderm
