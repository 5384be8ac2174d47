#include "app/window/presenters/coloring_presenter.h"

#include "app/window/guide/guide.h"
#include "app/window/presenters/result_presenter.h"
#include "app/window/session/session_controller.h"
#include "app/window/settings/preferences.h"
#include "app/window/settings/scale_settings.h"
#include "hexoderm/reconstruction/figures/skin_signs.h"
#include "widgets/coloring/scale_ranges.h"
#include "widgets/controls/step_panel.h"
#include "widgets/graph/graph_view.h"
#include "widgets/patch/patch_view.h"

#include <algorithm>

namespace hexoderm {
namespace {

/// At least one cell states it.
bool isStated(const Reconstruction& result, std::optional<Matrix6d> CellPlacement::*covariance) {
  return std::ranges::any_of(result.patches, [&](const PatchReconstruction& patch) {
    return std::ranges::any_of(patch.cells, [&](const CellPlacement& cell) { return (cell.*covariance).has_value(); });
  });
}

}  // namespace

ColoringPresenter::ColoringPresenter(const Views& views, const SessionController& controller,
                                     const ResultPresenter& results, const Preferences& preferences,
                                     ScaleRanges& ranges)
    : views_(views), controller_(controller) {
  restoreScaleRanges(ranges);
  views_.patch.setScaleRanges(&ranges);
  views_.graph.setScaleRanges(&ranges);
  connect(&ranges, &ScaleRanges::changed, this, [&ranges](Coloring changed) { keepScaleRange(ranges, changed); });
  connect(&preferences, &Preferences::restored, &ranges, [&ranges] {
    for (const ColoringRow& row : coloringTable()) ranges.release(row.coloring);
  });
  connect(&views_.patch, &PatchView::coloringPicked, this, [this] { is_chosen_ = true; });
  connect(&views_.steps, &StepPanel::opened, this, &ColoringPresenter::choose);
  connect(&results, &ResultPresenter::handedOut, this, &ColoringPresenter::choose);
  connect(&controller.liveMode(), &LiveMode::toggled, this, &ColoringPresenter::choose);
}

void ColoringPresenter::choose() {
  if (!is_chosen_) views_.patch.setColoring(suggested());
}

Coloring ColoringPresenter::suggested() const {
  const Reconstruction* result = controller_.reconstruction().get();
  // A single moment says nothing of uncertainty.
  if (controller_.liveMode().isOn()) return Coloring::LinkQuality;
  if (result == nullptr || views_.steps.openIndex() < static_cast<int>(GuideStep::Review) || !isOfOneQuality(*result)) {
    return Coloring::LinkQuality;
  }
  if (isStated(*result, &CellPlacement::shape_cov_t_r)) return Coloring::ShapeUncertainty;
  return isStated(*result, &CellPlacement::cov_t_r) ? Coloring::PositionUncertainty : Coloring::LinkQuality;
}

}  // namespace hexoderm
