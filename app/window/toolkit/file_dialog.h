#pragma once

#include <QFileDialog>
#include <functional>

class QDialogButtonBox;
class QPushButton;

namespace hexoderm {

/// Qt's, with columns as wide as their headings are in any language.
class FileDialog : public QFileDialog {
 public:
  FileDialog(QWidget* parent, const QString& title, const QString& folder, const QString& filter = {});
};

/// Asks for a file that is there, or for a folder, and hands over the one that is chosen. `name`: of the dialog, by
/// which it is found. Nothing is taken any more once `receiver` is gone.
void askForFile(QWidget* parent, const char* name, const QString& title, const QString& folder, const QString& filter,
                const QObject* receiver, const std::function<void(const QString&)>& take);
void askForFolder(QWidget* parent, const char* name, const QString& title, const QString& folder,
                  const QObject* receiver, const std::function<void(const QString&)>& take);

/// The button that a dialog is answered by in most cases, also with Return.
QPushButton* addPrimaryButton(QDialogButtonBox* buttons, const QString& text, const char* name);

}  // namespace hexoderm
