#pragma once

#include <QTableView>

namespace hexoderm {

class JointTable;

/// A JointTable to type into, as into a spreadsheet: a digit begins, Return goes on to the pose below, Delete makes a
/// joint unknown, Ctrl+C and Ctrl+V copy and paste blocks.
class JointTableView : public QTableView {
  Q_OBJECT

 public:
  /// The table outlives the view, or is its child.
  explicit JointTableView(JointTable* table, QWidget* parent = nullptr);

  void copy();
  void paste();

 protected:
  bool event(QEvent* event) override;
  void keyPressEvent(QKeyEvent* event) override;
  void closeEditor(QWidget* editor, QAbstractItemDelegate::EndEditHint hint) override;

 private:
  JointTable* table_;
};

}  // namespace hexoderm
