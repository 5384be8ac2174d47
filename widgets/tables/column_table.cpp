#include "widgets/tables/column_table.h"

#include "widgets/tables/table_cells.h"
#include "widgets/tables/table_roles.h"
#include "widgets/words/formatting.h"

namespace hexoderm {

QString ColumnTable::inWords(const Column& column, const QVariant& value) {
  if (!value.isValid()) return noValue();
  const bool is_real = !column.is_text && value.userType() == QMetaType::Double;
  return is_real ? figureText(value.toDouble(), column.decimals) + column.sign : value.toString();
}

int ColumnTable::columnCount(const QModelIndex& parent) const {
  return parent.isValid() ? 0 : static_cast<int>(columns_.size());
}

QVariant ColumnTable::valueAt(const QModelIndex& index) const {
  return columns_[static_cast<std::size_t>(index.column())].value(index.row());
}

QString ColumnTable::textAt(const QModelIndex& index) const {
  const Column& column = columns_[static_cast<std::size_t>(index.column())];
  return column.text ? column.text(index.row()) : inWords(column, valueAt(index));
}

QVariant ColumnTable::data(const QModelIndex& index, int role) const {
  if (!checkIndex(index, CheckIndexOption::IndexIsValid)) return {};
  if (QVariant of_row = ofRow(index.row(), role); of_row.isValid()) return of_row;
  const Column& column = columns_[static_cast<std::size_t>(index.column())];
  switch (role) {
    case Qt::DisplayRole:
      return textAt(index);
    case Qt::AccessibleTextRole:
      return column.spoken ? column.spoken(index.row()) : textAt(index);
    case Qt::DecorationRole:
      return column.decoration ? column.decoration(index.row()) : QVariant();
    case Qt::ToolTipRole:
      return column.tool_tip ? column.tool_tip(index.row()) : QVariant();
    case kRawRole:
      return valueAt(index);
    case Qt::TextAlignmentRole:
      return headerData(index.column(), Qt::Horizontal, role);
    default:
      return {};
  }
}

QVariant ColumnTable::headerData(int section, Qt::Orientation orientation, int role) const {
  if (orientation != Qt::Horizontal || section < 0 || section >= columnCount()) return {};
  const Column& column = columns_[static_cast<std::size_t>(section)];
  switch (role) {
    case Qt::DisplayRole:
      return column.name;
    case kUnitRole:
      return column.unit;
    case Qt::ToolTipRole:
      return column.explanation;
    case Qt::TextAlignmentRole:
      return alignment(!column.is_text);
    default:
      return {};
  }
}

}  // namespace hexoderm
