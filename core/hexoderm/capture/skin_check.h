#pragma once

#include "hexoderm/capture/stillness.h"
#include "hexoderm/device/sample_frame.h"
#include "hexoderm/solve/result/reconstruction.h"

#include <span>
#include <vector>

namespace hexoderm {

/// One thing that was looked at, as one sentence for the operator. Info: it is as it should be.
struct SkinCheckItem {
  Severity severity = Severity::Info;
  Message message;
  std::vector<CellId> cells;  ///< cells concerned; empty: all
};

/// The state of a skin before its poses are captured.
struct SkinCheck {
  std::vector<SkinCheckItem> items;
  bool ready = false;  ///< poses can be captured
  Message because;     ///< why they can or can't
};

/// Looks at what was found (cells, links, patches), and at what the cells read just now: whether all of them send, and
/// whether what they send can be gravity, 1 g give or take five standard deviations of the cell model's offset and
/// scale. `readings`: means of the last moments, g; empty where no skin is connected. `odd`: cells that the stillness
/// detector complains about.
SkinCheck checkSkin(const Reconstruction& reconstruction, std::span<const CellSample> readings,
                    std::span<const OddCell> odd);

}  // namespace hexoderm
