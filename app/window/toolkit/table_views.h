#pragma once

#include <QStackedWidget>
#include <QString>
#include <vector>

class QAbstractItemModel;
class QLabel;
class QTableView;

namespace hexoderm {

/// A table of whole rows, one picked at a time, nothing edited. A text that is cut short stands whole in its tool tip.
QTableView* makeTable(QAbstractItemModel* model, const char* object_name, const QString& accessible_name);
/// One column takes the room that the others leave.
void stretchColumn(QTableView* view, int column);
/// Long texts take as many lines as they need, as long as measuring them is quick.
void wrapRows(QTableView* view);
/// Where the table is too narrow for all of its columns, `columns` are left out, the first ones first, so that
/// `stretched` keeps room for a word.
void leaveOutWhereNarrow(QTableView* view, const std::vector<int>& columns, int stretched);
/// The table, or a word on why it is empty.
class TableOrHint : public QStackedWidget {
 public:
  /// Takes over the view.
  TableOrHint(QTableView* view, const QString& hint);
  /// What is going on while there is nothing to show, in words, which stand in the hint's place; empty: nothing is.
  void setAwaited(const QString& awaited);

 private:
  QString hint_;
  QLabel* label_;
};

}  // namespace hexoderm
