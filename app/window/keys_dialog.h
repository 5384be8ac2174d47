#pragma once

class QMenuBar;
class QWidget;

namespace hexoderm {

/// Shows the list of keys beside the window: those of all actions in the menus, to be searched. Of several calls one
/// list remains.
void showKeysDialog(QWidget* parent, const QMenuBar& menus);

}  // namespace hexoderm
