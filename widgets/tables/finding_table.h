#pragma once

#include "widgets/tables/reconstruction_table.h"
#include "widgets/tables/table_cells.h"
#include "widgets/words/formatting.h"
#include "widgets/words/words.h"

#include <algorithm>
#include <functional>
#include <numeric>
#include <vector>

namespace hexoderm {

/// The columns Severity | What | Where; the worst findings come first.
class FindingTable : public ReconstructionTable {
  Q_OBJECT

 public:
  explicit FindingTable(QObject* parent = nullptr) : ReconstructionTable(parent) {
    const auto column = [this](const QString& name, QString (*text)(const Finding&)) {
      return Column{.name = name, .is_text = true, .value = [this, text](int row) { return text(findingAt(row)); }};
    };
    Column severity = column(tr("Severity"), [](const Finding& finding) { return severityWord(finding.severity); });
    severity.decoration = [this](int row) { return severityMark(findingAt(row).severity); };
    setColumns({severity, column(tr("What"), [](const Finding& finding) { return words(finding.message); }),
                column(tr("Where"), [](const Finding& finding) { return placeText(finding); })});
  }

  [[nodiscard]] const Finding& findingAt(int row) const {
    return reconstruction()->findings[rows_.at(static_cast<std::size_t>(row))];
  }

 protected:
  [[nodiscard]] QVariant ofRow(int row, int role) const override {
    return role == Qt::ToolTipRole ? findingToolTip(findingAt(row)) : QVariant();
  }
  [[nodiscard]] int rows() const override { return static_cast<int>(rows_.size()); }
  void rebuild() override {
    rows_.clear();
    if (!reconstruction()) return;
    const std::vector<Finding>& findings = reconstruction()->findings;
    rows_.resize(findings.size());
    std::iota(rows_.begin(), rows_.end(), std::size_t{0});
    std::ranges::stable_sort(rows_, std::ranges::greater(), [&](std::size_t row) { return findings[row].severity; });
  }

 private:
  std::vector<std::size_t> rows_;  ///< indices into Reconstruction::findings
};

}  // namespace hexoderm
