#pragma once

#include "widgets/tables/reconstruction_table.h"

#include <vector>

namespace hexoderm {

/// The columns Severity | What | Where; the worst findings come first.
class FindingTable : public ReconstructionTable {
  Q_OBJECT

 public:
  explicit FindingTable(QObject* parent = nullptr);
  QVariant data(const QModelIndex& index, int role) const override;

  [[nodiscard]] const Finding& findingAt(int row) const;

 protected:
  [[nodiscard]] int rows() const override { return static_cast<int>(rows_.size()); }
  void rebuild() override;

 private:
  std::vector<std::size_t> rows_;  ///< indices into Reconstruction::findings
};

}  // namespace hexoderm
