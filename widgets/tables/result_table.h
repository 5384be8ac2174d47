#pragma once

#include "widgets/controls/selection.h"

#include <QAbstractTableModel>
#include <QVariant>
#include <optional>
#include <vector>

namespace hexoderm {

/// A small table of results: texts and figures with units. A row may be about a cell or a link, which can be picked.
class ResultTable : public QAbstractTableModel {
  Q_OBJECT

 public:
  struct Column {
    QString name;
    QString unit;  ///< as for kUnitRole
    QString explanation;
    int decimals = 0;
    bool is_text = false;
  };
  struct Row {
    std::vector<QVariant> values;  ///< one per column; invalid: not known
    std::optional<CellId> cell{};
    std::optional<Selection::Link> link{};
    bool remarkable = false;  ///< set in bold
  };

  using QAbstractTableModel::QAbstractTableModel;
  void setContent(std::vector<Column> columns, std::vector<Row> rows);
  [[nodiscard]] const Row& rowAt(int row) const { return rows_.at(static_cast<std::size_t>(row)); }

  int rowCount(const QModelIndex& parent = {}) const override;
  int columnCount(const QModelIndex& parent = {}) const override;
  QVariant data(const QModelIndex& index, int role) const override;
  QVariant headerData(int section, Qt::Orientation orientation, int role) const override;

 private:
  std::vector<Column> columns_;
  std::vector<Row> rows_;
};

}  // namespace hexoderm
