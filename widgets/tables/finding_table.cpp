#include "widgets/tables/finding_table.h"

#include "widgets/tables/table_cells.h"
#include "widgets/words/formatting.h"
#include "widgets/words/words.h"

#include <algorithm>
#include <array>
#include <functional>
#include <numeric>

namespace hexoderm {
namespace {

enum FindingColumn { kSeverity, kWhat, kWhere, kFindingColumns };

}  // namespace

void FindingTable::rebuild() {
  rows_.clear();
  if (!reconstruction()) return;
  const std::vector<Finding>& findings = reconstruction()->findings;
  rows_.resize(findings.size());
  std::iota(rows_.begin(), rows_.end(), std::size_t{0});
  std::ranges::stable_sort(rows_, std::ranges::greater(), [&](std::size_t row) { return findings[row].severity; });
}

int FindingTable::rowCount(const QModelIndex& parent) const {
  return parent.isValid() ? 0 : static_cast<int>(rows_.size());
}

int FindingTable::columnCount(const QModelIndex& parent) const { return parent.isValid() ? 0 : kFindingColumns; }

const Finding& FindingTable::findingAt(int row) const {
  return reconstruction()->findings[rows_.at(static_cast<std::size_t>(row))];
}

QVariant FindingTable::data(const QModelIndex& index, int role) const {
  if (!checkIndex(index, CheckIndexOption::IndexIsValid)) return {};
  const Finding& finding = findingAt(index.row());
  switch (role) {
    case Qt::DisplayRole:
    case Qt::AccessibleTextRole:
      if (index.column() == kSeverity) return severityWord(finding.severity);
      return index.column() == kWhat ? words(finding.message) : placeInWords(finding);
    case Qt::DecorationRole:
      return index.column() == kSeverity ? QVariant(severityMark(finding.severity)) : QVariant();
    case Qt::TextAlignmentRole:
      return alignment(false);
    case Qt::ToolTipRole:
      return findingToolTip(finding);
    default:
      return {};
  }
}

QVariant FindingTable::headerData(int section, Qt::Orientation orientation, int role) const {
  if (orientation != Qt::Horizontal || section < 0 || section >= kFindingColumns) return {};
  if (role == Qt::TextAlignmentRole) return alignment(false);
  const std::array<QString, kFindingColumns> headers = {tr("Severity"), tr("What"), tr("Where")};
  return role == Qt::DisplayRole ? QVariant(headers.at(static_cast<std::size_t>(section))) : QVariant();
}

}  // namespace hexoderm
