#pragma once

#include "widgets/coloring/coloring.h"

#include <QString>

namespace hexoderm {

// The words for colours in the user's language, the same in the graph and in the 3D view.

/// "link quality", for menus.
QString coloringName(Coloring coloring);

/// A quantity's scale in words, for a legend.
struct ScaleWords {
  QString title;
  QString low;
  QString high;
};
/// "position known to (95 %)", "0", "±6 mm or more": the unit stands at the scale's end.
ScaleWords graphScaleInWords(Coloring coloring);
/// "position uncertainty (95 %), mm", "0", "6 or more": the unit stands in the title.
ScaleWords patchScaleInWords(Coloring coloring, const ColorRange& range);
/// The title with its unit; of classes the name.
QString patchTitle(Coloring coloring);

/// The reason why the cells of the 3D view can't be coloured by it; empty if they can.
QString whyNoColoring(Coloring coloring, bool has_values);

/// "patch 3", where patches are classes. `index` counts from 0.
QString patchWord(std::size_t index);
/// The word for cells and links without a value or a class.
QString notKnownWord();

}  // namespace hexoderm
