#include "app/window/dialog_turns.h"

#include <QDialog>
#include <QPointer>
#include <QTimer>
#include <QVariant>
#include <algorithm>

namespace hexoderm {
namespace {

constexpr const char* kOpening = "opening";
/// A timer, for other posted events would be served in the same turn.
constexpr int kNextTurn_ms = 1;

bool isAnotherOpening(const QDialog& dialog) {
  const QWidget* parent = dialog.parentWidget();
  if (!parent) return false;
  const auto siblings = parent->findChildren<QDialog*>(QString(), Qt::FindDirectChildrenOnly);
  return std::any_of(siblings.begin(), siblings.end(),
                     [](const QDialog* sibling) { return sibling->property(kOpening).toBool(); });
}

}  // namespace

void openInTurns(QDialog* dialog, Modality modality) {
  if (isAnotherOpening(*dialog)) {
    dialog->deleteLater();
    return;
  }
  dialog->setProperty(kOpening, true);
  QTimer::singleShot(kNextTurn_ms, dialog, [dialog, modality] {
    dialog->setProperty(kOpening, QVariant());
    if (modality == Modality::Window) {
      dialog->open();
    } else {
      dialog->show();
      dialog->raise();
      dialog->activateWindow();
    }
  });
  QObject::connect(dialog, &QDialog::finished, dialog, [closed = QPointer<QDialog>(dialog)] {
    QTimer::singleShot(kNextTurn_ms, [closed] { delete closed; });
  });
}

}  // namespace hexoderm
