#include "widgets/tables/finding_table.h"

#include "widgets/tables/table_cells.h"
#include "widgets/words/formatting.h"
#include "widgets/words/words.h"

#include <algorithm>
#include <functional>
#include <numeric>

namespace hexoderm {

FindingTable::FindingTable(QObject* parent) : ReconstructionTable(parent) {
  const auto column = [this](const QString& name, QString (*text)(const Finding&)) {
    return Column{.name = name, .is_text = true, .value = [this, text](int row) { return text(findingAt(row)); }};
  };
  setColumns({column(tr("Severity"), [](const Finding& finding) { return severityWord(finding.severity); }),
              column(tr("What"), [](const Finding& finding) { return words(finding.message); }),
              column(tr("Where"), [](const Finding& finding) { return placeInWords(finding); })});
}

void FindingTable::rebuild() {
  rows_.clear();
  if (!reconstruction()) return;
  const std::vector<Finding>& findings = reconstruction()->findings;
  rows_.resize(findings.size());
  std::iota(rows_.begin(), rows_.end(), std::size_t{0});
  std::ranges::stable_sort(rows_, std::ranges::greater(), [&](std::size_t row) { return findings[row].severity; });
}

const Finding& FindingTable::findingAt(int row) const {
  return reconstruction()->findings[rows_.at(static_cast<std::size_t>(row))];
}

QVariant FindingTable::data(const QModelIndex& index, int role) const {
  if (!checkIndex(index, CheckIndexOption::IndexIsValid)) return {};
  const Finding& finding = findingAt(index.row());
  switch (role) {
    case Qt::DecorationRole:
      return index.column() == 0 ? QVariant(severityMark(finding.severity)) : QVariant();
    case Qt::ToolTipRole:
      return findingToolTip(finding);
    default:
      return ReconstructionTable::data(index, role);
  }
}

}  // namespace hexoderm
