#pragma once

#include "hexoderm/solve/checks/calibration_check.h"
#include "hexoderm/solve/checks/evaluation.h"
#include "hexoderm/solve/checks/loop_search.h"
#include "hexoderm/solve/hold_out.h"
#include "widgets/controls/banner.h"
#include "widgets/tables/result_table.h"

#include <vector>

namespace hexoderm {

// Results of the checks of a calibration: a verdict as a sentence, and the figures behind it as a table.

struct VerifySentence {
  Tone tone = Tone::Neutral;
  QString text;
};
struct VerifyMetrics {
  std::vector<ResultTable::Column> columns;
  std::vector<ResultTable::Row> rows;
};

VerifySentence holdOutText(const HoldOutResult& result);
/// Of its cells, or `by_link`.
VerifyMetrics holdOutMetrics(const HoldOutResult& result, bool by_link);

/// `patches`: how many there are to have loops in.
VerifySentence loopsText(const std::vector<FoundLoop>& loops, std::size_t patches);
VerifyMetrics loopMetrics(const std::vector<FoundLoop>& loops);

/// `stated_m`: what the calibration states for positions with 95 %.
VerifySentence surfaceText(const SurfaceEvaluation& surface, std::optional<double> stated_m);
VerifyMetrics surfaceMetrics(const std::vector<SurfaceEvaluation>& surfaces);

VerifySentence distanceCheckText(const DistanceCheck& check);

VerifySentence comparisonText(const std::vector<Comparison>& comparisons, const QString& against);
VerifyMetrics comparisonMetrics(const std::vector<Comparison>& comparisons);

VerifySentence oldCalibrationText(const CalibrationCheck& check, const QString& calibration);
/// The cells that changed come first. A cell that is none of `today` can't be picked.
VerifyMetrics oldCalibrationMetrics(const CalibrationCheck& check, const Reconstruction& today);

}  // namespace hexoderm
