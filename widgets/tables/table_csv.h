#pragma once

#include <QByteArray>
#include <QObject>
#include <QString>

class QAbstractItemModel;
class QAbstractItemView;

namespace hexoderm {

/// A table as CSV after RFC 4180: UTF-8, lines end with CR LF, fields quoted where they must be. The first line names
/// the columns with their units, as in "Residual (deg)". Raw numbers are written with all their digits and a decimal
/// point whatever the locale, unknown values as empty fields, and cells without a raw value as they are shown. Row
/// names, where a table has any, come first. Rows are in the model's order, so a sorted view is written in its order.
QByteArray tableAsCsv(const QAbstractItemModel& model);

/// "Copy as CSV" and "Save as CSV…" in the context menu of a table, as long as it has rows. Choosing and writing the
/// file is the window's business.
class CsvActions : public QObject {
  Q_OBJECT

 public:
  /// Becomes a child of the view, which has its model already. `name`: proposed name of the file, without folder and
  /// extension.
  CsvActions(QAbstractItemView* view, QString name);

 signals:
  /// `csv` is the table as it is shown now.
  void saveRequested(const QString& name, const QByteArray& csv);

 private:
  QAbstractItemView* view_;
  QString name_;
};

}  // namespace hexoderm
