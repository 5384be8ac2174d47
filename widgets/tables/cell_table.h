#pragma once

#include "hexoderm/solve/metrics/review_summary.h"
#include "widgets/tables/reconstruction_table.h"

#include <unordered_map>
#include <vector>

namespace hexoderm {

/// The columns Cell | Patch | X | Y | Z | Roll | Pitch | Yaw | ± mm | ± ° | Placed by | Worst residual | Offset |
/// Scale; one row per cell, patch by patch, with placements in the frame of the patch's origin.
class CellTableModel : public ReconstructionTable {
  Q_OBJECT

 public:
  explicit CellTableModel(QObject* parent = nullptr);

  [[nodiscard]] CellId cellAt(int row) const;
  [[nodiscard]] int rowOf(CellId cell) const;  ///< -1 if there is none

 protected:
  [[nodiscard]] int rows() const override { return static_cast<int>(rows_.size()); }
  [[nodiscard]] QVariant ofRow(int row, int role) const override;
  void rebuild() override;

 private:
  struct Row {
    CellSummary summary;
    Eigen::Vector3d rpy_rad;
  };
  std::vector<Row> rows_;
  std::unordered_map<CellId, int> row_of_;
};

}  // namespace hexoderm
