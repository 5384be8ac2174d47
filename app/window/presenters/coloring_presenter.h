#pragma once

#include "app/window/guide/guide.h"
#include "app/window/presenters/presenter.h"
#include "app/window/presenters/result_presenter.h"
#include "hexoderm/solve/metrics/skin_signs.h"
#include "widgets/coloring/coloring.h"
#include "widgets/coloring/scale_ranges.h"

#include <QSettings>
#include <QString>
#include <QStringList>
#include <algorithm>

namespace hexoderm {

/// The colouring's English name, which no translation changes.
inline QString keptRangeKey(Coloring coloring) {
  return QStringLiteral("colours/") + QString::fromUtf8(coloringRow(coloring).name).replace(' ', '_');
}

/// Fixes the ranges of scales that the operator fixed before, as kept in the settings. What makes no sense there
/// (edited by hand, of another version) is left out.
inline void restoreScaleRanges(ScaleRanges& ranges) {
  const QSettings settings;
  for (const ColoringRow& row : coloringTable()) {
    const QStringList ends = settings.value(keptRangeKey(row.coloring)).toStringList();
    if (ends.size() != 2) continue;
    bool has_low = false;
    bool has_high = false;
    const ColorRange range{ends[0].toDouble(&has_low), ends[1].toDouble(&has_high)};
    if (has_low && has_high) ranges.fix(row.coloring, range);
  }
}

/// Keeps the range of a colouring for the next start, or that it is fixed no longer.
inline void keepScaleRange(const ScaleRanges& ranges, Coloring coloring) {
  QSettings settings;
  const std::optional<ColorRange> range = ranges.fixed(coloring);
  if (range) {
    constexpr int kDigits = 12;
    settings.setValue(keptRangeKey(coloring), QStringList{QString::number(range->low, 'g', kDigits),
                                                          QString::number(range->high, 'g', kDigits)});
  } else {
    settings.remove(keptRangeKey(coloring));
  }
}

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
