#pragma once

#include "widgets/tables/table_cells.h"
#include "widgets/words/formatting.h"

#include <QAbstractTableModel>
#include <QVariant>
#include <functional>
#include <utility>
#include <vector>

namespace hexoderm {

/// Base of the item models whose columns say in one place what they are and what stands in their rows.
class ColumnTable : public QAbstractTableModel {
  Q_OBJECT

 public:
  struct Column {
    QString name;
    QString unit{};  ///< as for kUnitRole
    QString explanation{};
    int decimals = 0;      ///< of real numbers
    bool is_text = false;  ///< stands at the left
    QString sign{};        ///< of the unit, right behind real numbers
    /// The value in a row, as for kRawRole.
    std::function<QVariant(int row)> value{};
    /// The text of a row, where it is not the value in words.
    std::function<QString(int row)> text{};
    /// What else a row has in this column: an icon, a tool tip, and what a screen reader says instead of the text.
    std::function<QVariant(int row)> decoration{};
    std::function<QString(int row)> tool_tip{};
    std::function<QString(int row)> spoken{};
  };

  /// A value of the column as the table shows it.
  static QString inWords(const Column& column, const QVariant& value) {
    if (!value.isValid()) return noValue();
    const bool is_real = !column.is_text && value.userType() == QMetaType::Double;
    return is_real ? figureText(value.toDouble(), column.decimals) + column.sign : value.toString();
  }

  using QAbstractTableModel::QAbstractTableModel;
  int rowCount(const QModelIndex& parent = {}) const override { return parent.isValid() ? 0 : rows(); }

  int columnCount(const QModelIndex& parent = {}) const override {
    return parent.isValid() ? 0 : static_cast<int>(columns_.size());
  }

  QVariant data(const QModelIndex& index, int role) const override {
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

  QVariant headerData(int section, Qt::Orientation orientation, int role) const override {
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

 protected:
  [[nodiscard]] virtual int rows() const = 0;
  /// In the constructor, or between beginResetModel and endResetModel.
  void setColumns(std::vector<Column> columns) { columns_ = std::move(columns); }

  [[nodiscard]] virtual QVariant valueAt(const QModelIndex& index) const {
    return columns_[static_cast<std::size_t>(index.column())].value(index.row());
  }

  /// What a whole row has in a role, before its columns are asked; invalid: nothing of its own.
  [[nodiscard]] virtual QVariant ofRow(int /*row*/, int /*role*/) const { return {}; }

 private:
  [[nodiscard]] QString textAt(const QModelIndex& index) const {
    const Column& column = columns_[static_cast<std::size_t>(index.column())];
    return column.text ? column.text(index.row()) : inWords(column, valueAt(index));
  }

  std::vector<Column> columns_;
};

}  // namespace hexoderm
