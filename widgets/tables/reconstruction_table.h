#pragma once

#include "hexoderm/reconstruction/result/reconstruction.h"
#include "widgets/tables/column_table.h"

#include <memory>

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

}  // namespace hexoderm
