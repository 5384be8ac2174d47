#pragma once

#include <QAbstractItemModel>
#include <QByteArray>
#include <QObject>
#include <QSortFilterProxyModel>
#include <functional>

class QAbstractItemView;
class QTableView;

namespace hexoderm {

/// What is behind the text of a cell of a table: a number in the header's unit, or a text. Invalid: not known.
constexpr int kRawRole = Qt::UserRole + 1;
/// Of a header: the unit of the raw numbers below it, such as "deg", empty for counts and texts. Of a row's header:
/// what the rows are, such as "Link"; their names are its raw value.
constexpr int kUnitRole = Qt::UserRole + 2;
/// Of a header that shows more than its name: the name alone.
constexpr int kNameRole = Qt::UserRole + 3;

/// A table as CSV after RFC 4180: UTF-8, lines end with CR LF, fields quoted where they must be. The first line names
/// the columns with their units, as in "Residual (deg)". Raw numbers come with all their digits and a decimal point
/// whatever the locale, what is not known as an empty field; cells without a raw value as they are shown. Row names,
/// where a table has any, come first. Rows stand as the model has them, so a sorted view gives its order.
QByteArray tableAsCsv(const QAbstractItemModel& model);

/// Sorts any of the tables by what is behind the texts: numbers by value, names with numbers in them as a person would,
/// what is not known last whichever way round. Unsorted until a header is clicked; then the header says so by an arrow
/// in its text, because Qt's own takes room from every column.
class SortedTable : public QSortFilterProxyModel {
  Q_OBJECT

 public:
  explicit SortedTable(QAbstractItemModel* table, QObject* parent = nullptr);

  /// Lets clicks on the headers of a view of a sorted table sort it.
  static void enableIn(QTableView* view);

  void sort(int column, Qt::SortOrder order = Qt::AscendingOrder) override;
  QVariant headerData(int section, Qt::Orientation orientation, int role) const override;

 protected:
  bool lessThan(const QModelIndex& left, const QModelIndex& right) const override;
};

/// "Copy as CSV" and "Save as CSV…" in the context menu of a table. Where the file goes, and writing it, is the
/// window's business.
class TableActions : public QObject {
  Q_OBJECT

 public:
  /// Becomes a child of the view. `name`: what the file is called at first, without folder and extension.
  TableActions(QAbstractItemView* view, QString name);

 signals:
  /// The table as it is shown now.
  void saveRequested(const QString& name, const QByteArray& csv);

 private:
  QAbstractItemView* view_;
  QString name_;
};

/// Calls `picked` with the row, or cell, that somebody picks: by a click, an arrow key, or Return where the keyboard
/// is. A Tab that passes through the table picks nothing, although the view calls its first row the current one then.
void onPicked(QAbstractItemView* view, QObject* receiver, std::function<void(const QModelIndex&)> picked);

}  // namespace hexoderm
