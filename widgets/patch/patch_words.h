#pragma once

#include "hexoderm/reconstruction/figures/overlays.h"
#include "widgets/coloring/cell_coloring.h"
#include "widgets/scene/scene_items.h"
#include "widgets/scene/scene_overlays.h"

#include <QString>
#include <QStringList>
#include <optional>

namespace hexoderm {

// How what the 3D scene shows is called, in the user's locale.

/// "link quality", for the menu.
QString coloringName(CellColoring coloring);
/// "position uncertainty (95 %), mm", for the legend of a quantity.
QString coloringTitle(CellColoring coloring);
/// The numbers at a scale's ends; the upper one says "or more" where values can lie beyond it.
QString lowEndInWords(CellColoring coloring, const ColorRange& range);
QString highEndInWords(CellColoring coloring, const ColorRange& range);
/// Why cells can't be coloured by it; empty if they can.
QString whyNoColoring(CellColoring coloring, bool has_values);

QString itemName(SceneItem item);
QString itemTip(SceneItem item);
/// Why it can't be shown; empty if it can.
QString whyNotShown(SceneItem item, Availability availability);

/// One line for each thing that is drawn over the cells: what it is and how much enlarged.
QStringList notesInWords(const SceneNotes& notes, const std::optional<SurfaceEvaluation>& surface,
                         const std::optional<LoopEvaluation>& loop);

/// "Cells 3 and 7: 84.2 mm ± 1.1 mm (95 %) apart, their faces 12.3° to each other".
QString distanceInWords(CellId a, CellId b, const std::optional<CellDistance>& distance);

}  // namespace hexoderm
