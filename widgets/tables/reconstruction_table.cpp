#include "widgets/tables/reconstruction_table.h"

namespace hexoderm {

void ReconstructionTable::setReconstruction(std::shared_ptr<const Reconstruction> reconstruction) {
  beginResetModel();
  reconstruction_ = std::move(reconstruction);
  rebuild();
  endResetModel();
}

void LinkRowTable::rebuild() {
  rows_.clear();
  if (!reconstruction()) return;
  for (std::size_t patch = 0; patch < reconstruction()->patches.size(); ++patch) {
    for (std::size_t link = 0; link < reconstruction()->patches[patch].links.size(); ++link) {
      rows_.emplace_back(patch, link);
    }
  }
}

const LinkEstimate& LinkRowTable::linkAt(int row) const {
  const auto& [patch, link] = rows_.at(static_cast<std::size_t>(row));
  return reconstruction()->patches[patch].links[link];
}

int LinkRowTable::rowOf(LinkEnd source, LinkEnd target) const {
  if (target < source) std::swap(source, target);
  for (int row = 0; row < static_cast<int>(rows_.size()); ++row) {
    const LinkEstimate& link = linkAt(row);
    if (link.source == source && link.target == target) return row;
  }
  return -1;
}

}  // namespace hexoderm
