#pragma once

#include "hexoderm/capture/pose_recorder.h"
#include "hexoderm/solve/metrics/pose_coverage.h"

#include <Eigen/Core>
#include <QString>
#include <optional>

namespace hexoderm {

// Core's numbers about capturing, in the operator's words (translated, whole sentences).

/// "Turn the part so that cell 1 faces a wall, its side towards the ceiling."
QString nextPoseText(const NextPose& next);
/// "About 70° around the horizontal axis shown."; that it is there where it is; empty where nobody knows.
QString turnText(const NextPose& next);
/// The angle alone, as turnText() says it: "90°". Empty where it says none.
QString turnAngleText(const NextPose& next);
/// "Why: gravity has been seen from two directions. ..."
QString gainText(const NextPose& next);
/// "With this pose the error falls to about 14 % of what it is now."; empty for the first pose.
QString sigmaText(const NextPose& next);

/// "No pose yet with cell 7 facing the ceiling or the floor: the third value is 0.02, needs 0.50."; that nothing is
/// missing where nothing is.
/// `next_up_o`: of the next pose, where that is shown: if it is such a direction, naming another cell that would do as
/// well only confuses.
QString missingText(const PoseCoverage& coverage, const std::optional<Eigen::Vector3d>& next_up_o = std::nullopt);
/// As long as what that says usually is at most: for whoever keeps room for it.
QString longMissingText();
/// All of it, for a screen reader. `next_up_o`: as for missingText().
QString coverageText(const PoseCoverage& coverage, const std::optional<Eigen::Vector3d>& next_up_o = std::nullopt);
/// "2 poses", "2 poses, 1 disabled".
QString poseCountText(const PoseCoverage& coverage);

/// An instruction in two or three words, and the small print of the ring: "Hold still", "starts over".
struct HoldWords {
  QString word;
  QString detail;
};
HoldWords holdText(const HoldStatus& hold);
/// "Waiting: cell 7 moves 44 mg, limit 30 mg": what is awaited, with cell, value and limit.
QString waitText(const HoldStatus& hold);
/// "Not waited for: cell 5 (noisy), cell 9 (silent)"; empty if there are none.
QString oddCellsText(const HoldStatus& hold);

}  // namespace hexoderm
