#pragma once

#include "widgets/tables/reconstruction_table.h"

namespace hexoderm {

/// The columns Link | Quality | Residual | Predicted | Bend | Twist | Yaw | State; one row per link, excluded links
/// included.
class LinkTable : public LinkRowTable {
  Q_OBJECT

 public:
  /// Columns that can be done without, by their places.
  static constexpr int kTwistColumn = 5;
  static constexpr int kYawColumn = 6;

  explicit LinkTable(QObject* parent = nullptr);

 protected:
  [[nodiscard]] QVariant ofRow(int row, int role) const override;
};

}  // namespace hexoderm
