#pragma once

#include "tests/support/hand_made_skins.h"

namespace hexoderm {

/// A sheet whose position uncertainty grows with the cell's number.
inline std::shared_ptr<Reconstruction> growingSheet(std::uint32_t rows = 3, std::uint32_t columns = 4) {
  auto result = sampleSheet(rows, columns);
  double sigma_m = 0.0003;
  for (CellPlacement& cell : result->patches[0].cells) {
    cell.cov_t_r = Matrix6d::Zero();
    cell.cov_t_r->diagonal().setConstant(sigma_m * sigma_m);
    sigma_m += 0.0003;
  }
  return result;
}

}  // namespace hexoderm
