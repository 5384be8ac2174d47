#pragma once

#include "hexoderm/io/exporter.h"
#include "tests/core/io/export_test_folder.h"
#include "tests/support/hand_made_skins.h"
#include "tests/support/matchers.h"

#include <string>

namespace hexoderm {

/// Exports of a skin whose first patch is placed on a link.
class PlacedSkin : public ExportTest {
 protected:
  /// What another reader says of the places of the first patch's cells, and of one of its sensors: `placeOf(name)`, in
  /// their link.
  template <class PlaceOf>
  void expectOnLink(PlaceOf placeOf) const {
    const auto expectAt = [&](const std::string& name, const SE3& T_o) {
      EXPECT_THAT(placeOf(name), SE3Near(T_l_o_ * T_o, 1e-9, 1e-9)) << name;
    };
    const std::vector<CellPlacement>& cells = reconstruction_.patches[0].cells;
    for (const CellPlacement& cell : cells) expectAt("skin_cell" + toString(cell.cell), cell.T_o_u);
    expectAt("skin_cell3_accelerometer", cells[0].sensors[0].T_o_s);
  }
  std::string bytes(ExportFormat format) const { return exportBytes(reconstruction_, format, options_); }

  const SE3 T_l_o_{rotationFromRpy({0.4, -0.9, 2.5}), {0.03, -0.01, 0.12}};
  Reconstruction reconstruction_ = makeTestReconstruction();
  ExportOptions options_ = [this] {
    ExportOptions options;
    options.placements = {{CellId(7), "forearm", T_l_o_, {}}};
    return options;
  }();
};

}  // namespace hexoderm
