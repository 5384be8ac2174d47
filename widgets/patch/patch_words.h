#pragma once

#include "hexoderm/solve/metrics/overlays.h"
#include "widgets/scene/patch_moment.h"
#include "widgets/scene/scene_items.h"

#include <QString>
#include <QStringList>
#include <optional>

namespace hexoderm {

// The words for what lies over the cells in the 3D view, in the user's language and locale.

QString itemName(SceneItem item);
QString itemTip(SceneItem item);
/// The reason why it can't be shown; empty if it can.
QString whyNotShown(SceneItem item, Availability availability);

/// One line for each thing that is drawn over the cells: its name and how much it is enlarged.
QStringList notesText(const SceneNotes& notes, const PatchOverlays& overlays);

/// "Cells 3 and 7: 84.2 mm ± 1.1 mm (95 %) apart, their faces 12.3° to each other".
QString distanceText(CellId a, CellId b, const std::optional<CellDistance>& distance);

}  // namespace hexoderm
