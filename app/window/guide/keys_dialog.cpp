#include "app/window/guide/keys_dialog.h"

#include "app/window/guide/actions.h"
#include "app/window/toolkit/deferred_dialog.h"
#include "widgets/controls/panel_parts.h"

#include <QAction>
#include <QCoreApplication>
#include <QDialog>
#include <QDialogButtonBox>
#include <QHBoxLayout>
#include <QLabel>
#include <QLineEdit>
#include <QMenu>
#include <QMenuBar>
#include <QScreen>
#include <QScrollArea>
#include <QVBoxLayout>
#include <QVariant>
#include <algorithm>

namespace hexoderm {
namespace {

struct KeysDialog {
  Q_DECLARE_TR_FUNCTIONS(hexoderm::KeysDialog)
};

QString plain(QString text) { return text.remove(QLatin1Char('&')).remove(QStringLiteral("…")); }

/// The constant name of an action: the text of undo and redo tells what it would do just now.
QString nameOf(const QAction& action) {
  const QVariant name = action.property(WindowActions::kAlways);
  return name.isValid() ? name.toString() : action.text();
}

void addActions(KeyGroup& group, const QList<QAction*>& actions) {
  for (const QAction* action : actions) {
    if (action->menu()) {
      addActions(group, action->menu()->actions());
    } else if (action->isVisible() && !action->shortcuts().isEmpty()) {
      group.lines.push_back(
          {QKeySequence::listToString(action->shortcuts(), QKeySequence::NativeText), plain(nameOf(*action))});
    }
  }
}

/// A heading with its keys, of which a search hides those that it does not mean.
struct ShownGroup {
  QLabel* title;
  std::vector<std::pair<QWidget*, QString>> rows;  ///< with what is searched
};

ShownGroup show(const KeyGroup& group, int keys_width, QVBoxLayout* layout) {
  ShownGroup shown;
  shown.title = new QLabel(group.title.toUpper());
  shown.title->setProperty("caption", true);
  shown.title->setContentsMargins(0, 10, 0, 2);
  layout->addWidget(shown.title);
  for (const KeyLine& line : group.lines) {
    auto* row = new QWidget(layout->parentWidget());
    auto* keys = new QLabel(line.keys);
    QFont bold = keys->font();
    bold.setWeight(QFont::DemiBold);
    keys->setFont(bold);
    keys->setFixedWidth(keys_width);
    auto* what = new QLabel(line.what);
    what->setWordWrap(true);
    auto* columns = spaced(new QHBoxLayout(row), {0, 2, 0, 2}, 20);
    columns->addWidget(keys);
    columns->addWidget(what, 1);
    layout->addWidget(row);
    shown.rows.emplace_back(row, line.keys + QLatin1Char(' ') + line.what);
  }
  return shown;
}

}  // namespace

std::vector<KeyGroup> keysOf(const QMenuBar& menus) {
  std::vector<KeyGroup> groups;
  for (const QAction* menu : menus.actions()) {
    KeyGroup group{plain(menu->text()), {}};
    if (menu->menu()) addActions(group, menu->menu()->actions());
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

void showKeysDialog(QWidget* parent, const QMenuBar& menus) {
  if (auto* open = parent->findChild<QDialog*>(QStringLiteral("keysDialog"))) {
    open->raise();
    open->activateWindow();
    return;
  }
  auto* dialog = new QDialog(parent);
  dialog->setObjectName(QStringLiteral("keysDialog"));
  dialog->setWindowTitle(KeysDialog::tr("Keys"));
  auto* search = new QLineEdit;
  search->setObjectName(QStringLiteral("keysSearch"));
  search->setPlaceholderText(KeysDialog::tr("Search for a key or for what it does"));
  search->setAccessibleName(search->placeholderText());
  search->setClearButtonEnabled(true);

  // The area gets its parent before it is filled: a widget that gets another parent is styled again, with all its
  // contents.
  auto* area = new QScrollArea(dialog);
  auto* content = new QWidget;
  area->setWidget(content);
  auto* list = spaced(new QVBoxLayout(content), {0, 0, 10, 0}, 0);
  const std::vector<KeyGroup> groups = keysOf(menus);
  QFont bold = dialog->font();
  bold.setWeight(QFont::DemiBold);
  int keys_width = 0;
  for (const KeyGroup& group : groups) {
    for (const KeyLine& line : group.lines) {
      keys_width = std::max(keys_width, QFontMetrics(bold).horizontalAdvance(line.keys) + 2);
    }
  }
  std::vector<ShownGroup> shown;
  for (const KeyGroup& group : groups) shown.push_back(show(group, keys_width, list));
  auto* nothing = new QLabel(KeysDialog::tr("No key is like that."));
  nothing->setProperty("muted", true);
  nothing->hide();
  list->addWidget(nothing);
  list->addStretch(1);
  area->setWidgetResizable(true);
  area->setFrameShape(QFrame::NoFrame);
  area->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  area->setAccessibleName(KeysDialog::tr("Keys"));

  QObject::connect(search, &QLineEdit::textChanged, dialog, [shown, nothing](const QString& text) {
    bool any = false;
    for (const ShownGroup& group : shown) {
      bool any_here = false;
      for (const auto& row : group.rows) {
        const bool meant = row.second.contains(text.trimmed(), Qt::CaseInsensitive);
        row.first->setVisible(meant);
        any_here = any_here || meant;
      }
      group.title->setVisible(any_here);
      any = any || any_here;
    }
    nothing->setVisible(!any);
  });
  auto* buttons = new QDialogButtonBox(QDialogButtonBox::Close);
  QObject::connect(buttons, &QDialogButtonBox::rejected, dialog, &QDialog::reject);
  auto* layout = spaced(new QVBoxLayout(dialog), {22, 18, 12, 14}, 10);
  layout->addWidget(search);
  layout->addWidget(area, 1);
  layout->addWidget(buttons);
  const int width = keys_width + 44 * dialog->fontMetrics().averageCharWidth() + 80;
  const int height = content->sizeHint().height() + 6 * dialog->fontMetrics().height();
  dialog->resize(QSize(width, height).boundedTo(0.85 * parent->screen()->availableSize()));
  openInTurns(dialog, Qt::NonModal);
}

}  // namespace hexoderm
