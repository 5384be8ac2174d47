#pragma once

#include "hexoderm/util/ids.h"

#include <functional>
#include <optional>

class QMenu;

namespace hexoderm {

class PatchControls;

/// What the menu of the 3D view does besides what its buttons do.
struct PatchMenuCommands {
  std::function<void(CellId)> pick;
  std::function<void(CellId)> center;  ///< brings the cell into the middle
  std::function<void()> copy_picture;
};

/// Fills the menu that opens in the 3D view by the right button or the menu key: first what can be done with `cell`,
/// the one under the mouse, if there is one, then what the buttons over the scene offer too.
void fillPatchMenu(QMenu& menu, const PatchControls& controls, std::optional<CellId> cell,
                   const PatchMenuCommands& commands);

}  // namespace hexoderm
