#include "widgets/tables/reconstruction_table.h"

#include <utility>

namespace hexoderm {

void ReconstructionTable::setReconstruction(std::shared_ptr<const Reconstruction> reconstruction) {
  beginResetModel();
  reconstruction_ = std::move(reconstruction);
  rebuild();
  endResetModel();
}

}  // namespace hexoderm
