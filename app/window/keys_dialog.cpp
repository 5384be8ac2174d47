#include "app/window/keys_dialog.h"

#include "app/window/actions.h"

#include <QDialog>
#include <QDialogButtonBox>
#include <QFormLayout>
#include <QLabel>
#include <QVBoxLayout>

namespace hexoderm {

void showKeysDialog(QWidget* parent, const WindowActions& actions) {
  auto* dialog = new QDialog(parent);
  dialog->setObjectName(QStringLiteral("keysDialog"));
  dialog->setAttribute(Qt::WA_DeleteOnClose);
  dialog->setWindowTitle(QCoreApplication::translate("hexoderm::KeysDialog", "Keys"));
  auto* form = new QFormLayout;
  form->setHorizontalSpacing(28);
  form->setVerticalSpacing(7);
  for (const QAction* action : actions.withKeys()) {
    auto* keys = new QLabel(QKeySequence::listToString(action->shortcuts(), QKeySequence::NativeText));
    QFont bold = keys->font();
    bold.setWeight(QFont::DemiBold);
    keys->setFont(bold);
    form->addRow(keys, new QLabel(action->iconText()));
  }
  auto* buttons = new QDialogButtonBox(QDialogButtonBox::Close);
  QObject::connect(buttons, &QDialogButtonBox::rejected, dialog, &QDialog::reject);
  auto* layout = new QVBoxLayout(dialog);
  layout->setContentsMargins(22, 18, 22, 14);
  layout->setSpacing(14);
  layout->addLayout(form);
  layout->addWidget(buttons);
  dialog->show();
  dialog->raise();
  dialog->activateWindow();
}

}  // namespace hexoderm
