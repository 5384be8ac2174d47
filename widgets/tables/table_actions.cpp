#include "widgets/tables/table_actions.h"

#include "hexoderm/util/text.h"

#include <QAbstractItemView>
#include <QAction>
#include <QApplication>
#include <QClipboard>
#include <QCollator>
#include <QHeaderView>
#include <QLocale>
#include <QTableView>
#include <algorithm>
#include <utility>

namespace hexoderm {
namespace {

bool isReal(const QVariant& value) {
  return value.userType() == QMetaType::Double || value.userType() == QMetaType::Float;
}

QByteArray quoted(const QString& field) {
  QByteArray text = field.toUtf8();
  const bool special =
      std::any_of(text.cbegin(), text.cend(), [](char c) { return c == ',' || c == '"' || c == '\n' || c == '\r'; });
  if (!special) return text;
  text.replace('"', "\"\"");
  return '"' + text + '"';
}

QByteArray field(const QModelIndex& index) {
  const QVariant raw = index.data(kRawRole);
  if (isReal(raw)) return QByteArray::fromStdString(formatExact(raw.toDouble()));
  if (raw.isValid()) return quoted(raw.toString());
  // Tables that know the role say "not known" by an invalid value; others have no more than their texts.
  const bool knows_role = index.model()->headerData(index.column(), Qt::Horizontal, kUnitRole).isValid();
  return knows_role ? QByteArray() : quoted(index.data(Qt::DisplayRole).toString());
}

QByteArray heading(const QAbstractItemModel& model, int column) {
  const QVariant plain = model.headerData(column, Qt::Horizontal, kNameRole);
  QString name = (plain.isValid() ? plain : model.headerData(column, Qt::Horizontal, Qt::DisplayRole)).toString();
  if (name.endsWith(QStringLiteral(" °"))) name.chop(2);  // said by the unit
  const QString unit = model.headerData(column, Qt::Horizontal, kUnitRole).toString();
  const bool named = unit.isEmpty() || name.endsWith(QLatin1Char(' ') + unit);
  return quoted(named ? name : QStringLiteral("%1 (%2)").arg(name, unit));
}

}  // namespace

QByteArray tableAsCsv(const QAbstractItemModel& model) {
  const int columns = model.columnCount();
  const int rows = model.rowCount();
  // Tables without names for their rows leave it to Qt, which counts them.
  const bool row_names = rows > 0 && model.headerData(0, Qt::Vertical, kRawRole).isValid();
  QByteArray csv;
  if (row_names) csv += quoted(model.headerData(0, Qt::Vertical, kUnitRole).toString());
  for (int column = 0; column < columns; ++column) {
    if (column > 0 || row_names) csv += ',';
    csv += heading(model, column);
  }
  csv += "\r\n";
  for (int row = 0; row < rows; ++row) {
    if (row_names) csv += quoted(model.headerData(row, Qt::Vertical, kRawRole).toString());
    for (int column = 0; column < columns; ++column) {
      if (column > 0 || row_names) csv += ',';
      csv += field(model.index(row, column));
    }
    csv += "\r\n";
  }
  return csv;
}

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
  // The view turns the order round for descending; the unknown stay last.
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

TableActions::TableActions(QAbstractItemView* view, QString name) : QObject(view), view_(view), name_(std::move(name)) {
  auto* copy = new QAction(tr("Copy as CSV"), view);
  copy->setObjectName(QStringLiteral("actionCopyCsv"));
  copy->setShortcut(QKeySequence::Copy);
  copy->setShortcutContext(Qt::WidgetShortcut);
  auto* save = new QAction(tr("Save as CSV…"), view);
  save->setObjectName(QStringLiteral("actionSaveCsv"));
  connect(copy, &QAction::triggered, this,
          [this] { QApplication::clipboard()->setText(QString::fromUtf8(tableAsCsv(*view_->model()))); });
  connect(save, &QAction::triggered, this, [this] { emit saveRequested(name_, tableAsCsv(*view_->model())); });
  view->addActions({copy, save});
  view->setContextMenuPolicy(Qt::ActionsContextMenu);
}

void onPicked(QAbstractItemView* view, QObject* receiver, std::function<void(const QModelIndex&)> picked) {
  QObject::connect(view->selectionModel(), &QItemSelectionModel::selectionChanged, receiver,
                   [picked](const QItemSelection& selected) {
                     const QModelIndexList indexes = selected.indexes();
                     if (!indexes.isEmpty()) picked(indexes.front());
                   });
  QObject::connect(view, &QAbstractItemView::activated, receiver, [view, picked](const QModelIndex& index) {
    if (view->selectionModel()->isSelected(index)) {
      picked(index);  // again, as something else may have been picked elsewhere since
    } else {
      view->setCurrentIndex(index);
    }
  });
}

}  // namespace hexoderm
