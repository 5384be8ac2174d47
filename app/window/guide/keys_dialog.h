#pragma once

#include <QString>
#include <vector>

class QMenuBar;
class QWidget;

namespace hexoderm {

struct KeyLine {
  QString keys;  ///< as the desktop writes them
  QString what;
};
struct KeyGroup {
  QString title;
  std::vector<KeyLine> lines;
};

/// The keys of all visible actions in the order of the menus, and those that work everywhere.
std::vector<KeyGroup> keysOf(const QMenuBar& menus);

/// Shows the list of keys beside the window: those of all actions in the menus, to be searched. Of several calls one
/// list remains.
void showKeysDialog(QWidget* parent, const QMenuBar& menus);

}  // namespace hexoderm
