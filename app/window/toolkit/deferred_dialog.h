#pragma once

#include <Qt>

class QDialog;

namespace hexoderm {

/// Opens a dialog in a later turn of the event loop than the one that has made it, and deletes it in a later one than
/// that which has closed it, so that whoever clicks or types meanwhile waits for one of them at a time. Until a modal
/// dialog is there, its parent's window takes no keys and no clicks, as it will not after that.
void openInTurns(QDialog* dialog, Qt::WindowModality modality = Qt::WindowModal);

}  // namespace hexoderm
