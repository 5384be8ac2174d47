#pragma once

#include "hexoderm/solve/result/reconstruction.h"
#include "widgets/tables/column_table.h"

#include <algorithm>
#include <memory>
#include <unordered_map>
#include <utility>
#include <vector>

namespace hexoderm {

/// Base of the item models that show a Reconstruction, which comes in through the one entrance setReconstruction().
class ReconstructionTable : public ColumnTable {
  Q_OBJECT

 public:
  using ColumnTable::ColumnTable;
  /// Null empties the table.
  void setReconstruction(std::shared_ptr<const Reconstruction> reconstruction) {
    beginResetModel();
    reconstruction_ = std::move(reconstruction);
    rebuild();
    endResetModel();
  }

  [[nodiscard]] const std::shared_ptr<const Reconstruction>& reconstruction() const { return reconstruction_; }

 protected:
  /// Called between beginResetModel and endResetModel.
  virtual void rebuild() {}

 private:
  std::shared_ptr<const Reconstruction> reconstruction_;
};

/// Base of those with a row for each link, excluded links included.
class LinkRowTable : public ReconstructionTable {
  Q_OBJECT

 public:
  using ReconstructionTable::ReconstructionTable;

  [[nodiscard]] const LinkEstimate& linkAt(int row) const {
    const auto& [patch, link] = rows_.at(static_cast<std::size_t>(row));
    return reconstruction()->patches[patch].links[link];
  }

  /// -1 if there is none
  [[nodiscard]] int rowOf(LinkEnd source, LinkEnd target) const {
    if (target < source) std::swap(source, target);
    const auto [first, last] = rows_from_.equal_range(source.cell);
    const auto found = std::find_if(first, last, [&](const auto& row_from) {
      const LinkEstimate& link = linkAt(row_from.second);
      return link.source == source && link.target == target;
    });
    return found == last ? -1 : found->second;
  }

 protected:
  [[nodiscard]] int rows() const override { return static_cast<int>(rows_.size()); }
  void rebuild() override {
    rows_.clear();
    rows_from_.clear();
    if (!reconstruction()) return;
    for (std::size_t patch = 0; patch < reconstruction()->patches.size(); ++patch) {
      const std::vector<LinkEstimate>& links = reconstruction()->patches[patch].links;
      for (std::size_t link = 0; link < links.size(); ++link) {
        rows_from_.emplace(links[link].source.cell, static_cast<int>(rows_.size()));
        rows_.emplace_back(patch, link);
      }
    }
  }

 private:
  std::vector<std::pair<std::size_t, std::size_t>> rows_;  ///< patch, link
  std::unordered_multimap<CellId, int> rows_from_;         ///< of the links whose source is this cell's
};

}  // namespace hexoderm
