#include "widgets/tables/table_csv.h"

#include "hexoderm/base/csv.h"
#include "hexoderm/base/text.h"
#include "widgets/controls/panel_parts.h"
#include "widgets/tables/table_cells.h"

#include <QAbstractItemModel>
#include <QAbstractItemView>
#include <QAction>
#include <QApplication>
#include <QClipboard>
#include <utility>

namespace hexoderm {
namespace {

QByteArray quoted(const QString& field) { return QByteArray::fromStdString(csvQuoted(field.toStdString())); }

QByteArray field(const QModelIndex& index) {
  const QVariant raw = index.data(kRawRole);
  if (raw.userType() == QMetaType::Double) return QByteArray::fromStdString(formatExact(raw.toDouble()));
  if (raw.isValid()) return quoted(raw.toString());
  // In tables that know the role an invalid value means "not known"; other tables have nothing but their texts.
  const bool knows_role = index.model()->headerData(index.column(), Qt::Horizontal, kUnitRole).isValid();
  return knows_role ? QByteArray() : quoted(index.data(Qt::DisplayRole).toString());
}

QByteArray heading(const QAbstractItemModel& model, int column) {
  const QVariant plain = model.headerData(column, Qt::Horizontal, kNameRole);
  QString name = (plain.isValid() ? plain : model.headerData(column, Qt::Horizontal, Qt::DisplayRole)).toString();
  if (name.endsWith(QStringLiteral(" °"))) name.chop(2);  // the unit says it
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
  QByteArrayList fields;
  const auto endLine = [&] {
    csv += fields.join(',') + "\r\n";
    fields.clear();
  };
  if (row_names) fields << quoted(model.headerData(0, Qt::Vertical, kUnitRole).toString());
  for (int column = 0; column < columns; ++column) fields << heading(model, column);
  endLine();
  for (int row = 0; row < rows; ++row) {
    if (row_names) fields << quoted(model.headerData(row, Qt::Vertical, kRawRole).toString());
    for (int column = 0; column < columns; ++column) fields << field(model.index(row, column));
    endLine();
  }
  return csv;
}

CsvActions::CsvActions(QAbstractItemView* view, QString name) : QObject(view), view_(view), name_(std::move(name)) {
  auto* copy = named(new QAction(tr("Copy as CSV"), view), "actionCopyCsv");
  copy->setShortcut(QKeySequence::Copy);
  copy->setShortcutContext(Qt::WidgetShortcut);
  auto* save = named(new QAction(tr("Save as CSV…"), view), "actionSaveCsv");
  connect(copy, &QAction::triggered, this,
          [this] { QApplication::clipboard()->setText(QString::fromUtf8(tableAsCsv(*view_->model()))); });
  connect(save, &QAction::triggered, this, [this] { emit saveRequested(name_, tableAsCsv(*view_->model())); });
  const auto follow = [view, copy, save] {
    for (QAction* action : {copy, save}) action->setEnabled(view->model()->rowCount() > 0);
  };
  for (const auto changed : {&QAbstractItemModel::rowsInserted, &QAbstractItemModel::rowsRemoved}) {
    connect(view->model(), changed, this, follow);
  }
  connect(view->model(), &QAbstractItemModel::modelReset, this, follow);
  follow();
  view->addActions({copy, save});
  view->setContextMenuPolicy(Qt::ActionsContextMenu);
}

}  // namespace hexoderm
