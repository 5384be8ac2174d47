#pragma once

#include <QString>

class QAbstractItemModel;
class QTableView;
class QWidget;

namespace hexoderm {

/// A table of whole rows, one picked at a time, nothing edited.
QTableView* makeTable(QAbstractItemModel* model, const char* object_name, const QString& accessible_name);
/// One column takes the room that the others leave.
void stretchColumn(QTableView* view, int column);
/// Long texts take as many lines as they need, as long as measuring them is quick.
void wrapRows(QTableView* view);
/// The table, or a word on why it is empty.
QWidget* withHint(QTableView* view, const QString& hint);

}  // namespace hexoderm
