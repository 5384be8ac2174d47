#pragma once

#include "app/window/guide/guide.h"
#include "app/window/presenters/presenter.h"
#include "app/window/presenters/result_presenter.h"
#include "app/window/settings/scale_settings.h"
#include "hexoderm/solve/metrics/skin_signs.h"
#include "widgets/coloring/coloring.h"
#include "widgets/coloring/scale_ranges.h"

#include <algorithm>

namespace hexoderm {

/// What the cells in 3D are coloured by until the operator chooses something: the quality of links until Review, from
/// there on, as soon as that is the same everywhere and shows nothing more, how well the shape is known. And the ranges
/// of scales that the operator fixes, which graph and 3D view share, and which are kept for the next start.
class ColoringPresenter : public Presenter {
 public:
  ColoringPresenter(const WindowParts& parts, const ResultPresenter& results) : Presenter(parts) {
    ScaleRanges& ranges = parts.scale_ranges;
    restoreScaleRanges(ranges);
    views.patch->setScaleRanges(&ranges);
    views.graph->setScaleRanges(&ranges);
    connect(&ranges, &ScaleRanges::changed, this, [&ranges](Coloring changed) { keepScaleRange(ranges, changed); });
    connect(&preferences, &Preferences::restored, &ranges, [&ranges] {
      for (const ColoringRow& row : coloringTable()) ranges.release(row.coloring);
    });
    connect(views.patch, &PatchView::coloringPicked, this, [this] { is_chosen_ = true; });
    connect(views.steps, &StepPanel::opened, this, &ColoringPresenter::choose);
    connect(&results, &ResultPresenter::handedOut, this, &ColoringPresenter::choose);
    connect(&controller.liveMode(), &LiveMode::toggled, this, &ColoringPresenter::choose);
  }

 private:
  void choose() {
    if (!is_chosen_) views.patch->setColoring(suggested());
  }

  /// At least one cell states it.
  static bool isStated(const Reconstruction& result, std::optional<Matrix6d> CellPlacement::*covariance) {
    return std::ranges::any_of(result.patches, [&](const PatchReconstruction& patch) {
      return std::ranges::any_of(patch.cells,
                                 [&](const CellPlacement& cell) { return (cell.*covariance).has_value(); });
    });
  }

  Coloring suggested() const {
    const Reconstruction* result = controller.reconstruction().get();
    // A single moment says nothing of uncertainty.
    if (controller.liveMode().isOn()) return Coloring::LinkQuality;
    if (result == nullptr || views.steps->openIndex() < static_cast<int>(GuideStep::Review) ||
        !isOfOneQuality(*result)) {
      return Coloring::LinkQuality;
    }
    if (isStated(*result, &CellPlacement::shape_cov_t_r)) return Coloring::ShapeUncertainty;
    return isStated(*result, &CellPlacement::cov_t_r) ? Coloring::PositionUncertainty : Coloring::LinkQuality;
  }

  bool is_chosen_ = false;  ///< by the operator
};

}  // namespace hexoderm
