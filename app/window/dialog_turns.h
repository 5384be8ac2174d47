#pragma once

class QDialog;

namespace hexoderm {

enum class Modality { Window, None };

/// Opens a dialog in a later turn of the event loop than the one that has made it, and deletes it in a later one than
/// that which has closed it, so that whoever clicks or types meanwhile waits for one of them at a time. While another
/// dialog of the same parent is about to open, as when a key was hit twice, `dialog` is deleted instead.
void openInTurns(QDialog* dialog, Modality modality = Modality::Window);

}  // namespace hexoderm
