#pragma once

#include "widgets/controls/selection.h"
#include "widgets/tables/column_table.h"

#include <QApplication>
#include <QFont>
#include <optional>
#include <utility>
#include <vector>

namespace hexoderm {

/// A small table of results: texts and figures with units. A row may be about a cell or a link, which can be picked.
class ResultTable : public ColumnTable {
  Q_OBJECT

 public:
  struct Row {
    std::vector<QVariant> values;  ///< one per column; invalid: not known
    std::optional<CellId> cell{};
    std::optional<Selection::Link> link{};
    bool remarkable = false;  ///< set in bold
  };

  using ColumnTable::ColumnTable;
  void setContent(std::vector<Column> columns, std::vector<Row> rows) {
    beginResetModel();
    setColumns(std::move(columns));
    rows_ = std::move(rows);
    endResetModel();
  }

  [[nodiscard]] const Row& rowAt(int row) const { return rows_.at(static_cast<std::size_t>(row)); }

 protected:
  [[nodiscard]] int rows() const override { return static_cast<int>(rows_.size()); }
  [[nodiscard]] QVariant ofRow(int row, int role) const override {
    if (role != Qt::FontRole || !rowAt(row).remarkable) return {};
    QFont font = QApplication::font();
    font.setBold(true);
    return font;
  }
  [[nodiscard]] QVariant valueAt(const QModelIndex& index) const override {
    return rowAt(index.row()).values.at(static_cast<std::size_t>(index.column()));
  }

 private:
  std::vector<Row> rows_;
};

}  // namespace hexoderm
