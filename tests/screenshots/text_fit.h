#pragma once

#include <QStringList>

class QWidget;

namespace hexoderm {

/// Every visible label, button, tab, menu title, column header and group title under `root` (itself included) whose
/// text is wider or taller than its room, or which hangs over the edge of its parent. Scrolled contents may hang over.
/// A widget that draws its text itself reports by a dynamic property "textIsCut" (bool). Layouts must have settled.
/// ElidedLabel, whose whole text is in its tool tip, may be cut. Each is said in a line: "text" needs 120 px, has 96 px
/// in width (its place by object names from the window down, and its class).
QStringList findCutTexts(const QWidget& root);

/// Two texts of which one lies over the other; notices and marks, which lie over the content on purpose, don't count.
/// Empty if there are none.
QStringList findOverlaps(const QWidget& root);

/// Areas that have to be scrolled sideways to be read; tables may.
QStringList findSidewaysScrolling(const QWidget& root);

}  // namespace hexoderm
