#include "widgets/tables/result_table.h"

#include "widgets/tables/table_cells.h"
#include "widgets/tables/table_roles.h"
#include "widgets/words/formatting.h"

#include <QApplication>
#include <QFont>
#include <utility>

namespace hexoderm {

void ResultTable::setContent(std::vector<Column> columns, std::vector<Row> rows) {
  beginResetModel();
  columns_ = std::move(columns);
  rows_ = std::move(rows);
  endResetModel();
}

int ResultTable::rowCount(const QModelIndex& parent) const {
  return parent.isValid() ? 0 : static_cast<int>(rows_.size());
}

int ResultTable::columnCount(const QModelIndex& parent) const {
  return parent.isValid() ? 0 : static_cast<int>(columns_.size());
}

QVariant ResultTable::data(const QModelIndex& index, int role) const {
  if (!checkIndex(index, CheckIndexOption::IndexIsValid)) return {};
  const Column& column = columns_[static_cast<std::size_t>(index.column())];
  const Row& row = rows_[static_cast<std::size_t>(index.row())];
  const QVariant& value = row.values.at(static_cast<std::size_t>(index.column()));
  switch (role) {
    case Qt::DisplayRole:
      if (!value.isValid()) return noValue();
      return column.is_text || value.userType() != QMetaType::Double ? value.toString()
                                                                     : figureInWords(value.toDouble(), column.decimals);
    case kRawRole:
      return value;
    case Qt::TextAlignmentRole:
      return alignment(!column.is_text);
    case Qt::FontRole: {
      if (!row.remarkable) return {};
      QFont font = QApplication::font();
      font.setBold(true);
      return font;
    }
    default:
      return {};
  }
}

QVariant ResultTable::headerData(int section, Qt::Orientation orientation, int role) const {
  if (orientation != Qt::Horizontal || section < 0 || section >= columnCount()) return {};
  const Column& column = columns_[static_cast<std::size_t>(section)];
  switch (role) {
    case Qt::DisplayRole:
      return column.name;
    case kUnitRole:
      return column.unit.isNull() ? QString(QLatin1String("")) : column.unit;
    case Qt::ToolTipRole:
      return column.explanation;
    case Qt::TextAlignmentRole:
      return alignment(!column.is_text);
    default:
      return {};
  }
}

}  // namespace hexoderm
