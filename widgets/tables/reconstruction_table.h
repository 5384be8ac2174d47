#pragma once

#include "hexoderm/reconstruction/result/reconstruction.h"
#include "widgets/tables/column_table.h"

#include <memory>
#include <utility>
#include <vector>

namespace hexoderm {

/// Base of the item models that show a Reconstruction, which comes in through the one entrance setReconstruction().
class ReconstructionTable : public ColumnTable {
  Q_OBJECT

 public:
  using ColumnTable::ColumnTable;
  /// Null empties the table.
  void setReconstruction(std::shared_ptr<const Reconstruction> reconstruction);
  [[nodiscard]] const std::shared_ptr<const Reconstruction>& reconstruction() const { return reconstruction_; }

 protected:
  /// Called between beginResetModel and endResetModel.
  virtual void rebuild() = 0;

 private:
  std::shared_ptr<const Reconstruction> reconstruction_;
};

/// Base of those with a row for each link, muted links included.
class LinkRowTable : public ReconstructionTable {
  Q_OBJECT

 public:
  using ReconstructionTable::ReconstructionTable;

  [[nodiscard]] const LinkEstimate& linkAt(int row) const;
  [[nodiscard]] int rowOf(LinkEnd source, LinkEnd target) const;  ///< -1 if there is none

 protected:
  [[nodiscard]] int rows() const override { return static_cast<int>(rows_.size()); }
  void rebuild() override;

 private:
  std::vector<std::pair<std::size_t, std::size_t>> rows_;  ///< patch, link
};

}  // namespace hexoderm
