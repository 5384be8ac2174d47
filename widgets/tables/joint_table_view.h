#pragma once

#include "widgets/tables/joint_table.h"

#include <QAction>
#include <QApplication>
#include <QClipboard>
#include <QHeaderView>
#include <QKeyEvent>
#include <QLineEdit>
#include <QStyledItemDelegate>
#include <QTableView>

namespace hexoderm {

/// A JointTable to type into, as into a spreadsheet: a digit begins, Return goes on to the pose below, Delete makes a
/// joint unknown, Ctrl+C and Ctrl+V copy and paste blocks.
class JointTableView : public QTableView {
  Q_OBJECT

 public:
  /// The table outlives the view, or is its child.
  explicit JointTableView(JointTable* table, QWidget* parent = nullptr) : QTableView(parent), table_(table) {
    setModel(table);
    setItemDelegate(new TypingDelegate(this));
    setSelectionBehavior(QAbstractItemView::SelectItems);
    setSelectionMode(QAbstractItemView::ContiguousSelection);
    setEditTriggers(QAbstractItemView::AnyKeyPressed | QAbstractItemView::EditKeyPressed |
                    QAbstractItemView::DoubleClicked);
    setTabKeyNavigation(false);
    setWordWrap(false);
    horizontalHeader()->setHighlightSections(false);
    horizontalHeader()->setSectionResizeMode(QHeaderView::ResizeToContents);
    verticalHeader()->setHighlightSections(false);
    auto* copy = new QAction(tr("Copy"), this);
    copy->setShortcut(QKeySequence::Copy);
    auto* paste = new QAction(tr("Paste"), this);
    paste->setShortcut(QKeySequence::Paste);
    for (QAction* action : {copy, paste}) action->setShortcutContext(Qt::WidgetShortcut);
    // Its key is one of the window too, which means poses there: keyPressEvent() knows it.
    auto* clear = new QAction(tr("Clear"), this);
    connect(copy, &QAction::triggered, this, &JointTableView::copy);
    connect(paste, &QAction::triggered, this, &JointTableView::paste);
    connect(clear, &QAction::triggered, this, [this] { table_->clear(selectedIndexes()); });
    addActions({copy, paste, clear});
    setContextMenuPolicy(Qt::ActionsContextMenu);
  }

  void copy() { QApplication::clipboard()->setText(table_->block(selectedIndexes())); }
  void paste() { table_->paste(currentIndex(), QApplication::clipboard()->text()); }

 protected:
  bool event(QEvent* event) override {
    if (event->type() == QEvent::ShortcutOverride) {
      const auto* key = static_cast<QKeyEvent*>(event);
      if (clears(*key) || beginsNumber(*key)) {
        event->accept();
        return true;
      }
    }
    return QTableView::event(event);
  }

  void keyPressEvent(QKeyEvent* event) override {
    if (clears(*event) && state() != QAbstractItemView::EditingState) {
      table_->clear(selectedIndexes());
      return;
    }
    QTableView::keyPressEvent(event);
  }

  void closeEditor(QWidget* editor, QAbstractItemDelegate::EndEditHint hint) override {
    QTableView::closeEditor(editor, hint);
    if (hint != QAbstractItemDelegate::SubmitModelCache || !currentIndex().isValid()) return;
    const QModelIndex below = currentIndex().siblingAtRow(currentIndex().row() + 1);
    if (below.isValid()) setCurrentIndex(below);
  }

 private:
  static bool clears(const QKeyEvent& event) {
    return event.key() == Qt::Key_Delete || event.key() == Qt::Key_Backspace;
  }
  static bool beginsNumber(const QKeyEvent& event) {
    const QString text = event.text();
    return !text.isEmpty() && (text.front().isDigit() || QStringLiteral("+-.,").contains(text.front()));
  }

  /// What is being typed stays when new figures come meanwhile.
  class TypingDelegate : public QStyledItemDelegate {
   public:
    using QStyledItemDelegate::QStyledItemDelegate;
    void setEditorData(QWidget* editor, const QModelIndex& index) const override {
      const auto* line = qobject_cast<QLineEdit*>(editor);
      if (!line || !line->isModified()) QStyledItemDelegate::setEditorData(editor, index);
    }
  };

  JointTable* table_;
};

}  // namespace hexoderm
