#pragma once

#include "widgets/controls/selection.h"
#include "widgets/tables/reconstruction_table.h"

#include <map>
#include <optional>
#include <vector>

namespace hexoderm {

/// Links x poses: how badly each link fits each pose. One row a link, as LinkTable has them; the first column is the
/// link's rms over its poses, then one column a pose. Row headers name the links.
class ResidualTable : public ReconstructionTable {
  Q_OBJECT

 public:
  using ReconstructionTable::ReconstructionTable;
  int rowCount(const QModelIndex& parent = {}) const override;
  QVariant data(const QModelIndex& index, int role) const override;
  QVariant headerData(int section, Qt::Orientation orientation, int role) const override;

  [[nodiscard]] const LinkEstimate& linkAt(int row) const;
  [[nodiscard]] int rowOf(const Selection::Link& link) const;                      ///< -1 if there is none
  [[nodiscard]] std::optional<PoseId> poseAt(int column) const;                    ///< none for the first column
  [[nodiscard]] std::optional<double> residualAt(const QModelIndex& index) const;  ///< radians

 protected:
  void rebuild() override;
  [[nodiscard]] QVariant valueAt(const QModelIndex& index) const override;

 private:
  std::vector<std::pair<std::size_t, std::size_t>> rows_;  ///< patch, link
  std::map<Selection::Link, int> row_of_;
};

}  // namespace hexoderm
