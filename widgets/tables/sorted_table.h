#pragma once

#include <QSortFilterProxyModel>

class QTableView;

namespace hexoderm {

/// Sorts any of the tables by its raw values (kRawRole): numbers by value, names with numbers in them as a person
/// would, unknown values last in either order. Unsorted until a header is clicked; then an arrow in the header's text
/// shows the order, because Qt's own arrow takes room from every column.
class SortedTable : public QSortFilterProxyModel {
  Q_OBJECT

 public:
  explicit SortedTable(QAbstractItemModel* table, QObject* parent = nullptr);

  /// Makes clicks on the headers of `view`, whose model is a SortedTable, sort it.
  static void enableIn(QTableView* view);

  void sort(int column, Qt::SortOrder order = Qt::AscendingOrder) override;
  QVariant headerData(int section, Qt::Orientation orientation, int role) const override;

 protected:
  bool lessThan(const QModelIndex& left, const QModelIndex& right) const override;
};

}  // namespace hexoderm
