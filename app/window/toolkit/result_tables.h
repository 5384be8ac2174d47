#pragma once

#include "app/window/toolkit/table_views.h"
#include "widgets/tables/cell_table.h"
#include "widgets/tables/finding_table.h"
#include "widgets/tables/link_table.h"
#include "widgets/tables/pose_table.h"
#include "widgets/tables/sorted_table.h"

#include <QCoreApplication>
#include <QModelIndex>
#include <QTableView>

namespace hexoderm {

/// The tables of a reconstruction: a model with its view for the poses, the links, the findings, the cells. All but the
/// findings, which come in the order of their weight, can be sorted by a click on a header.
class ResultTables {
  Q_DECLARE_TR_FUNCTIONS(hexoderm::ResultTables)

 public:
  /// The models become children of `owner`, the views of what they are laid out in.
  explicit ResultTables(QObject* owner)
      : poses(new PoseTable(owner)),
        links(new LinkTable(owner)),
        findings(new FindingTable(owner)),
        cells(new CellTableModel(owner)),
        pose_view(makeTable(new SortedTable(poses, owner), "poseView", tr("Poses"))),
        link_view(makeTable(new SortedTable(links, owner), "linkView", tr("Links"))),
        finding_view(makeTable(findings, "findingView", tr("Findings"))),
        cell_view(makeTable(new SortedTable(cells, owner), "cellView", tr("Cells"))) {
    stretchColumn(pose_view, 1);
    stretchColumn(link_view, links->columnCount() - 1);
    stretchColumn(finding_view, 1);
    // The angles of a link are what its two cells show as well.
    leaveOutWhereNarrow(link_view, {LinkTable::kYawColumn, LinkTable::kTwistColumn}, links->columnCount() - 1);
    // The card beside the table says where, too.
    leaveOutWhereNarrow(finding_view, {findings->columnCount() - 1}, 1);
    wrapRows(finding_view);
    // Neither the noise nor what is new says whether a pose fits.
    leaveOutWhereNarrow(pose_view, {PoseTable::kNoiseColumn, PoseTable::kNewByColumn, PoseTable::kCellsColumn}, 1);
    wrapRows(pose_view);
    for (QTableView* view : {pose_view, link_view, cell_view}) SortedTable::enableIn(view);
  }

  PoseTable* poses;
  LinkTable* links;
  FindingTable* findings;
  CellTableModel* cells;
  QTableView* pose_view;
  QTableView* link_view;
  QTableView* finding_view;
  QTableView* cell_view;
};

/// The row of the model behind an index of a view, which may be sorted.
inline int sourceRow(const QModelIndex& index) {
  const auto* sorted = qobject_cast<const SortedTable*>(index.model());
  return sorted ? sorted->mapToSource(index).row() : index.row();
}

/// The index in the view of a row of the model behind it.
inline QModelIndex shownRow(const QTableView* view, int row) {
  const auto* sorted = qobject_cast<const SortedTable*>(view->model());
  return sorted ? sorted->mapFromSource(sorted->sourceModel()->index(row, 0)) : view->model()->index(row, 0);
}

/// Selects the row of the model behind the view; -1: nothing is selected any more.
inline void selectSourceRow(QTableView* view, int row) {
  if (row < 0) {
    view->clearSelection();
    view->selectionModel()->clearCurrentIndex();
  } else if (const QModelIndex shown = shownRow(view, row); !view->selectionModel()->isRowSelected(shown.row(), {})) {
    view->selectRow(shown.row());
  }
}

}  // namespace hexoderm
