#pragma once

#include "widgets/tables/reconstruction_table.h"

namespace hexoderm {

/// The columns Pose | Label | Cells | Noise mg | New by | Residual; row k is Reconstruction::poses[k]. Disabled poses
/// are greyed and carry a dash instead of a tick.
class PoseTable : public ReconstructionTable {
  Q_OBJECT

 public:
  /// Columns that can be done without, by their places.
  static constexpr int kCellsColumn = 2;
  static constexpr int kNoiseColumn = 3;
  static constexpr int kNewByColumn = 4;

  explicit PoseTable(QObject* parent = nullptr);
  QVariant data(const QModelIndex& index, int role) const override;

 protected:
  [[nodiscard]] int rows() const override;
  [[nodiscard]] QVariant ofRow(int row, int role) const override;
};

}  // namespace hexoderm
