#pragma once

#include "widgets/tables/reconstruction_table.h"

#include <utility>
#include <vector>

namespace hexoderm {

/// The columns Link | Quality | Residual | Predicted | Bend | Twist | Yaw | State; one row per link, muted links
/// included.
class LinkTable : public ReconstructionTable {
  Q_OBJECT

 public:
  /// Columns that can be done without, by their places.
  static constexpr int kTwistColumn = 5;
  static constexpr int kYawColumn = 6;

  explicit LinkTable(QObject* parent = nullptr);
  int rowCount(const QModelIndex& parent = {}) const override;
  QVariant data(const QModelIndex& index, int role) const override;

  [[nodiscard]] const LinkEstimate& linkAt(int row) const;
  [[nodiscard]] int rowOf(LinkEnd source, LinkEnd target) const;  ///< -1 if there is none

 protected:
  void rebuild() override;

 private:
  std::vector<std::pair<std::size_t, std::size_t>> rows_;  ///< patch, link
};

}  // namespace hexoderm
