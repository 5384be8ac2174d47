#include "widgets/patch/patch_menu.h"

#include "widgets/patch/patch_controls.h"

#include <QAction>
#include <QCoreApplication>
#include <QMenu>

namespace hexoderm {
namespace {

struct PatchMenu {
  Q_DECLARE_TR_FUNCTIONS(hexoderm::PatchMenu)
};

QAction* addNamed(QMenu& menu, const char* name, const QString& text) {
  QAction* action = menu.addAction(text);
  action->setObjectName(QString::fromLatin1(name));
  return action;
}

void addCellEntries(QMenu& menu, CellId cell, const PatchMenuCommands& commands) {
  QAction* pick = addNamed(menu, "actionPickCell", PatchMenu::tr("&Pick cell %1").arg(cell.value()));
  QObject::connect(pick, &QAction::triggered, &menu, [pick = commands.pick, cell] { pick(cell); });
  QAction* center =
      addNamed(menu, "actionCenterCell", PatchMenu::tr("&Bring cell %1 into the middle").arg(cell.value()));
  QObject::connect(center, &QAction::triggered, &menu, [center = commands.center, cell] { center(cell); });
  menu.addSeparator();
}

}  // namespace

void fillPatchMenu(QMenu& menu, const PatchControls& controls, std::optional<CellId> cell,
                   const PatchMenuCommands& commands) {
  menu.setToolTipsVisible(true);
  if (cell) addCellEntries(menu, *cell, commands);
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
  QAction* copy = addNamed(menu, "actionCopyPicture", PatchMenu::tr("Copy pict&ure"));
  copy->setToolTip(PatchMenu::tr("The scene with its legend, to be pasted elsewhere"));
  QObject::connect(copy, &QAction::triggered, &menu, [copy = commands.copy_picture] { copy(); });
  menu.addAction(controls.pictureAction());
}

}  // namespace hexoderm
