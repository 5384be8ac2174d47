#pragma once

#include <Qt>

class QDialog;
class QWidget;

namespace hexoderm {

/// Opens a dialog in a later turn of the event loop than the one that has made it, and deletes it in a later one than
/// the one that has closed it, so that clicks and keys wait for one of them at a time. Until a modal dialog is there,
/// its parent's window takes no keys and no clicks, as it will not after that.
void openInTurns(QDialog* dialog, Qt::WindowModality modality = Qt::WindowModal);

/// Shows a window in front of the others, with the keyboard; one that is shown already, too.
void bringToFront(QWidget* window);

}  // namespace hexoderm
