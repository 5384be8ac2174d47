#pragma once

#include "app/window/guide/actions.h"
#include "app/window/toolkit/dialogs.h"
#include "widgets/controls/panel_parts.h"

#include <QAction>
#include <QCoreApplication>
#include <QDialog>
#include <QDialogButtonBox>
#include <QLabel>
#include <QLineEdit>
#include <QMenu>
#include <QMenuBar>
#include <QScreen>
#include <QString>
#include <QTreeWidget>
#include <QVBoxLayout>
#include <QVariant>
#include <algorithm>
#include <vector>

namespace hexoderm {

struct KeyLine {
  QString keys;  ///< the keys, written as on this desktop
  QString what;
};
struct KeyGroup {
  QString title;
  std::vector<KeyLine> lines;
};

/// What the list of keys is made of.
struct KeysDialog {
  Q_DECLARE_TR_FUNCTIONS(hexoderm::KeysDialog)

 public:
  static QString plain(QString text) { return text.remove(QLatin1Char('&')).remove(QStringLiteral("…")); }

  /// The constant name of an action: the text of undo and redo tells what it would do just now.
  static QString nameOf(const QAction& action) {
    const QVariant name = action.property(WindowActions::kAlways);
    return name.isValid() ? name.toString() : action.text();
  }

  static void addActions(KeyGroup& group, const QList<QAction*>& actions) {
    for (const QAction* action : actions) {
      if (action->menu()) {
        addActions(group, action->menu()->actions());
      } else if (action->isVisible() && !action->shortcuts().isEmpty()) {
        group.lines.push_back(
            {QKeySequence::listToString(action->shortcuts(), QKeySequence::NativeText), plain(nameOf(*action))});
      }
    }
  }

  /// Shows the keys that have a text in them or in what they do, under their headings; false: there are none.
  static bool showOnly(const QTreeWidget& list, const QString& text) {
    bool any = false;
    for (int k = 0; k < list.topLevelItemCount(); ++k) {
      QTreeWidgetItem* group = list.topLevelItem(k);
      bool any_here = false;
      for (int row = 0; row < group->childCount(); ++row) {
        QTreeWidgetItem* line = group->child(row);
        const bool meant = (line->text(0) + QLatin1Char(' ') + line->text(1)).contains(text, Qt::CaseInsensitive);
        line->setHidden(!meant);
        any_here = any_here || meant;
      }
      group->setHidden(!any_here);
      any = any || any_here;
    }
    return any;
  }
};

/// The keys of all visible actions in the order of the menus, and those that work everywhere.
inline std::vector<KeyGroup> keysOf(const QMenuBar& menus) {
  std::vector<KeyGroup> groups;
  for (const QAction* menu : menus.actions()) {
    KeyGroup group{KeysDialog::plain(menu->text()), {}};
    if (menu->menu()) KeysDialog::addActions(group, menu->menu()->actions());
    if (!group.lines.empty()) groups.push_back(std::move(group));
  }
  const auto key = [](int code) { return QKeySequence(code).toString(QKeySequence::NativeText); };
  groups.push_back({KeysDialog::tr("Everywhere"),
                    {{key(Qt::Key_Escape), KeysDialog::tr("Cancel or close what is open; never quits")},
                     {key(Qt::Key_Tab), KeysDialog::tr("Go to the next control, with Shift to the one before")},
                     {key(Qt::Key_Space), KeysDialog::tr("Press the button that has the focus")},
                     {key(Qt::Key_Return), KeysDialog::tr("Open the picked row or recent file")}}});
  return groups;
}

/// Shows the list of keys beside the window: those of all actions in the menus, to be searched. Further calls show the
/// same list.
inline void showKeysDialog(QWidget* parent, const QMenuBar& menus) {
  if (auto* open = parent->findChild<QDialog*>(QStringLiteral("keysDialog"))) {
    bringToFront(open);
    return;
  }
  auto* dialog = named(new QDialog(parent), "keysDialog");
  dialog->setWindowTitle(KeysDialog::tr("Keys"));
  auto* search = named(new QLineEdit, "keysSearch");
  search->setPlaceholderText(KeysDialog::tr("Search for a key or for what it does"));
  search->setAccessibleName(search->placeholderText());
  search->setClearButtonEnabled(true);

  auto* list = named(new QTreeWidget(dialog), "keysList", KeysDialog::tr("Keys"));
  list->setColumnCount(2);
  list->setHeaderHidden(true);
  list->setRootIsDecorated(false);
  list->setItemsExpandable(false);
  list->setFrameShape(QFrame::NoFrame);
  list->setSelectionMode(QAbstractItemView::NoSelection);
  list->setWordWrap(true);
  list->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  QFont bold = dialog->font();
  bold.setWeight(QFont::DemiBold);
  int rows = 0;
  int widest = 0;
  for (const KeyGroup& group : keysOf(menus)) {
    auto* head = new QTreeWidgetItem(list, {group.title.toUpper()});
    head->setFirstColumnSpanned(true);
    for (const KeyLine& line : group.lines) {
      auto* item = new QTreeWidgetItem(head, {line.keys, line.what});
      item->setFont(0, bold);
      item->setToolTip(1, line.what);  // where the screen is too narrow for it
      widest = std::max(widest, dialog->fontMetrics().horizontalAdvance(line.what));
    }
    rows += 1 + head->childCount();
  }
  list->expandAll();
  list->resizeColumnToContents(0);
  auto* nothing = styledAs(new QLabel(KeysDialog::tr("No key is like that.")), "muted");
  nothing->hide();
  QObject::connect(search, &QLineEdit::textChanged, dialog, [list, nothing](const QString& text) {
    nothing->setHidden(KeysDialog::showOnly(*list, text.trimmed()));
  });
  auto* buttons = new QDialogButtonBox(QDialogButtonBox::Close);
  QObject::connect(buttons, &QDialogButtonBox::rejected, dialog, &QDialog::reject);
  auto* layout = spaced(new QVBoxLayout(dialog), {22, 18, 12, 14}, 10);
  addWidgets(layout, {search, nothing});
  layout->addWidget(list, 1);
  layout->addWidget(buttons);
  const int width = list->columnWidth(0) + widest + 100;
  const int height = (rows + 6) * (dialog->fontMetrics().height() + 6);
  dialog->resize(QSize(width, height).boundedTo(0.85 * parent->screen()->availableSize()));
  search->setFocus();
  openInTurns(dialog, Qt::NonModal);
}

}  // namespace hexoderm
