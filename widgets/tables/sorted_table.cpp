#include "widgets/tables/sorted_table.h"

#include "widgets/tables/table_roles.h"

#include <QCollator>
#include <QHeaderView>
#include <QLocale>
#include <QTableView>

namespace hexoderm {

SortedTable::SortedTable(QAbstractItemModel* table, QObject* parent) : QSortFilterProxyModel(parent) {
  setSourceModel(table);
}

void SortedTable::enableIn(QTableView* view) {
  view->horizontalHeader()->setSortIndicator(-1, Qt::DescendingOrder);
  view->setSortingEnabled(true);
  view->horizontalHeader()->setSortIndicatorShown(false);
}

void SortedTable::sort(int column, Qt::SortOrder order) {
  QSortFilterProxyModel::sort(column, order);
  if (columnCount() > 0) emit headerDataChanged(Qt::Horizontal, 0, columnCount() - 1);
}

QVariant SortedTable::headerData(int section, Qt::Orientation orientation, int role) const {
  if (role == kNameRole) return QSortFilterProxyModel::headerData(section, orientation, Qt::DisplayRole);
  const QVariant value = QSortFilterProxyModel::headerData(section, orientation, role);
  if (role != Qt::DisplayRole || orientation != Qt::Horizontal || section != sortColumn()) return value;
  return value.toString() + (sortOrder() == Qt::AscendingOrder ? QStringLiteral(" ↑") : QStringLiteral(" ↓"));
}

bool SortedTable::lessThan(const QModelIndex& left, const QModelIndex& right) const {
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

}  // namespace hexoderm
