#include "widgets/tables/result_table.h"

#include <QApplication>
#include <QFont>
#include <utility>

namespace hexoderm {

void ResultTable::setContent(std::vector<Column> columns, std::vector<Row> rows) {
  beginResetModel();
  setColumns(std::move(columns));
  rows_ = std::move(rows);
  endResetModel();
}

QVariant ResultTable::valueAt(const QModelIndex& index) const {
  return rowAt(index.row()).values.at(static_cast<std::size_t>(index.column()));
}

QVariant ResultTable::data(const QModelIndex& index, int role) const {
  if (role != Qt::FontRole) return ColumnTable::data(index, role);
  if (!checkIndex(index, CheckIndexOption::IndexIsValid) || !rowAt(index.row()).remarkable) return {};
  QFont font = QApplication::font();
  font.setBold(true);
  return font;
}

}  // namespace hexoderm
