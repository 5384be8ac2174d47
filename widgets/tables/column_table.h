#pragma once

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
  static QString inWords(const Column& column, const QVariant& value);

  using QAbstractTableModel::QAbstractTableModel;
  int rowCount(const QModelIndex& parent = {}) const override { return parent.isValid() ? 0 : rows(); }
  int columnCount(const QModelIndex& parent = {}) const override;
  QVariant data(const QModelIndex& index, int role) const override;
  QVariant headerData(int section, Qt::Orientation orientation, int role) const override;

 protected:
  [[nodiscard]] virtual int rows() const = 0;
  /// In the constructor, or between beginResetModel and endResetModel.
  void setColumns(std::vector<Column> columns) { columns_ = std::move(columns); }
  [[nodiscard]] virtual QVariant valueAt(const QModelIndex& index) const;
  /// What a whole row has in a role, before its columns are asked; invalid: nothing of its own.
  [[nodiscard]] virtual QVariant ofRow(int /*row*/, int /*role*/) const { return {}; }

 private:
  [[nodiscard]] QString textAt(const QModelIndex& index) const;

  std::vector<Column> columns_;
};

}  // namespace hexoderm
