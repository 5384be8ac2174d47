#pragma once

#include "widgets/tables/table_cells.h"

#include <QCollator>
#include <QHeaderView>
#include <QLocale>
#include <QSortFilterProxyModel>
#include <QTableView>

namespace hexoderm {

/// Sorts any of the tables by its raw values (kRawRole): numbers by value, names with numbers in them as a person
/// would, unknown values last in either order. Unsorted until a header is clicked; then an arrow in the header's text
/// shows the order, because Qt's own arrow takes room from every column.
class SortedTable : public QSortFilterProxyModel {
  Q_OBJECT

 public:
  explicit SortedTable(QAbstractItemModel* table, QObject* parent = nullptr) : QSortFilterProxyModel(parent) {
    setSourceModel(table);
  }

  /// Makes clicks on the headers of `view`, whose model is a SortedTable, sort it.
  static void enableIn(QTableView* view) {
    view->horizontalHeader()->setSortIndicator(-1, Qt::DescendingOrder);
    view->setSortingEnabled(true);
    view->horizontalHeader()->setSortIndicatorShown(false);
  }

  void sort(int column, Qt::SortOrder order = Qt::AscendingOrder) override {
    QSortFilterProxyModel::sort(column, order);
    if (columnCount() > 0) emit headerDataChanged(Qt::Horizontal, 0, columnCount() - 1);
  }

  QVariant headerData(int section, Qt::Orientation orientation, int role) const override {
    if (role == kNameRole) return QSortFilterProxyModel::headerData(section, orientation, Qt::DisplayRole);
    const QVariant value = QSortFilterProxyModel::headerData(section, orientation, role);
    if (role != Qt::DisplayRole || orientation != Qt::Horizontal || section != sortColumn()) return value;
    return value.toString() + (sortOrder() == Qt::AscendingOrder ? QStringLiteral(" ↑") : QStringLiteral(" ↓"));
  }

 protected:
  bool lessThan(const QModelIndex& left, const QModelIndex& right) const override {
    const QVariant a = left.data(kRawRole);
    const QVariant b = right.data(kRawRole);
    // The proxy reverses the order when it sorts in descending order; unknown values stay last all the same.
    if (!a.isValid() || !b.isValid()) {
      if (a.isValid() == b.isValid()) return false;
      return sortOrder() == Qt::AscendingOrder ? a.isValid() : b.isValid();
    }
    bool a_is_number = false;
    bool b_is_number = false;
    const double x = a.toDouble(&a_is_number);
    const double y = b.toDouble(&b_is_number);
    if (a_is_number && b_is_number) return x < y;
    static const QCollator kCollator = [] {
      // The locale "C" compares bytes and knows no numbers in names.
      const QLocale locale;
      QCollator collator(locale.language() == QLocale::C ? QLocale(QLocale::English) : locale);
      collator.setNumericMode(true);
      return collator;
    }();
    return kCollator.compare(a.toString(), b.toString()) < 0;
  }
};

}  // namespace hexoderm
