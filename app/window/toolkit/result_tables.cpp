#include "app/window/toolkit/result_tables.h"

#include "app/window/toolkit/table_views.h"
#include "widgets/tables/cell_table.h"
#include "widgets/tables/finding_table.h"
#include "widgets/tables/link_table.h"
#include "widgets/tables/pose_table.h"
#include "widgets/tables/sorted_table.h"

#include <QTableView>

namespace hexoderm {

ResultTables::ResultTables(QObject* owner)
    : poses(new PoseTable(owner)),
      links(new LinkTable(owner)),
      findings(new FindingTable(owner)),
      cells(new CellTable(owner)),
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

int sourceRow(const QModelIndex& index) {
  const auto* sorted = qobject_cast<const SortedTable*>(index.model());
  return sorted ? sorted->mapToSource(index).row() : index.row();
}

QModelIndex shownRow(const QTableView* view, int row) {
  const auto* sorted = qobject_cast<const SortedTable*>(view->model());
  return sorted ? sorted->mapFromSource(sorted->sourceModel()->index(row, 0)) : view->model()->index(row, 0);
}

void selectSourceRow(QTableView* view, int row) {
  if (row < 0) {
    view->clearSelection();
    view->selectionModel()->clearCurrentIndex();
  } else if (const QModelIndex shown = shownRow(view, row); !view->selectionModel()->isRowSelected(shown.row(), {})) {
    view->selectRow(shown.row());
  }
}

}  // namespace hexoderm
