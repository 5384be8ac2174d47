#pragma once

#include <QCoreApplication>
#include <QModelIndex>

class QTableView;

namespace hexoderm {

class CellTable;
class FindingTable;
class LinkTable;
class PoseTable;

/// The tables of a reconstruction: a model with its view for the poses, the links, the findings, the cells. All but the
/// findings, which come in the order of their weight, can be sorted by a click on a header.
class ResultTables {
  Q_DECLARE_TR_FUNCTIONS(hexoderm::ResultTables)

 public:
  /// The models become children of `owner`, the views of what they are laid out in.
  explicit ResultTables(QObject* owner);

  PoseTable* poses;
  LinkTable* links;
  FindingTable* findings;
  CellTable* cells;
  QTableView* pose_view;
  QTableView* link_view;
  QTableView* finding_view;
  QTableView* cell_view;
};

/// The row of the model behind an index of a view, which may be sorted.
int sourceRow(const QModelIndex& index);
/// The index in the view of a row of the model behind it.
QModelIndex shownRow(const QTableView* view, int row);
/// Selects the row of the model behind the view; -1: nothing is selected any more.
void selectSourceRow(QTableView* view, int row);

}  // namespace hexoderm
