#pragma once

#include "hexoderm/util/ids.h"
#include "widgets/patch/patch_controls.h"

#include <QAction>
#include <QCoreApplication>
#include <QMenu>
#include <functional>
#include <optional>

namespace hexoderm {

/// What the menu of the 3D view does besides what its buttons do.
struct PatchMenuCommands {
  std::function<void(CellId)> pick;
  std::function<void(CellId)> center;  ///< brings the cell into the middle
  std::function<void()> copy_picture;
};

struct PatchMenu {
  Q_DECLARE_TR_FUNCTIONS(hexoderm::PatchMenu)
};

inline QAction* addNamedEntry(QMenu& menu, const char* name, const QString& text) {
  QAction* action = menu.addAction(text);
  action->setObjectName(QString::fromLatin1(name));
  return action;
}

inline void addEntriesOfCell(QMenu& menu, CellId cell, const PatchMenuCommands& commands) {
  QAction* pick = addNamedEntry(menu, "actionPickCell", PatchMenu::tr("&Pick cell %1").arg(cell.value()));
  QObject::connect(pick, &QAction::triggered, &menu, [pick = commands.pick, cell] { pick(cell); });
  QAction* center =
      addNamedEntry(menu, "actionCenterCell", PatchMenu::tr("&Bring cell %1 into the middle").arg(cell.value()));
  QObject::connect(center, &QAction::triggered, &menu, [center = commands.center, cell] { center(cell); });
  menu.addSeparator();
}

/// Fills the menu that opens in the 3D view by the right button or the menu key: first what can be done with `cell`,
/// the one under the mouse, if there is one, then what the buttons over the scene offer too.
inline void fillPatchMenu(QMenu& menu, const PatchControls& controls, std::optional<CellId> cell,
                          const PatchMenuCommands& commands) {
  menu.setToolTipsVisible(true);
  if (cell) addEntriesOfCell(menu, *cell, commands);
  menu.addAction(controls.fitAction());
  QMenu* look = menu.addMenu(PatchMenu::tr("&Look from"));
  look->setToolTipsVisible(true);
  for (QAction* view : controls.viewActions()) look->addAction(view);
  menu.addActions({controls.parallelAction(), controls.cutAction()});
  menu.addSeparator();
  menu.addMenu(controls.coloringMenu());
  menu.addMenu(controls.showMenu());
  menu.addAction(controls.measureAction());
  menu.addSeparator();
  QAction* copy = addNamedEntry(menu, "actionCopyPicture", PatchMenu::tr("Copy pict&ure"));
  copy->setToolTip(PatchMenu::tr("The scene with its legend, to be pasted elsewhere"));
  QObject::connect(copy, &QAction::triggered, &menu, [copy = commands.copy_picture] { copy(); });
  menu.addAction(controls.pictureAction());
}

}  // namespace hexoderm
