#pragma once

#include <QString>
#include <vector>

class QMenuBar;
class QWidget;

namespace hexoderm {

struct KeyLine {
  QString keys;  ///< the keys, written as on this desktop
  QString what;
};
struct KeyGroup {
  QString title;
  std::vector<KeyLine> lines;
};

/// The keys of all visible actions in the order of the menus, and those that work everywhere.
std::vector<KeyGroup> keysOf(const QMenuBar& menus);

/// Shows the list of keys beside the window: those of all actions in the menus, to be searched. Further calls show the
/// same list.
void showKeysDialog(QWidget* parent, const QMenuBar& menus);

}  // namespace hexoderm
