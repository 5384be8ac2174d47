#pragma once

#include <QString>
#include <vector>

class QWidget;

namespace hexoderm {

/// A text that does not fit into its place.
struct CutText {
  QString where;  ///< object names from the window down, and the class
  QString text;
  QString how;  ///< "needs 120 px, has 96 px in width"
};

/// Every visible label, button, tab, menu title, column header and group title under `root` (itself included) whose
/// text is wider or taller than its room, or which hangs over the edge of its parent. Scrolled contents may hang over.
/// A widget that draws its text itself reports by a dynamic property "textIsCut" (bool). Layouts must have settled.
std::vector<CutText> findCutTexts(const QWidget& root);

}  // namespace hexoderm
