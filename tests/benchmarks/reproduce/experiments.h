#pragma once

#include "tests/benchmarks/reproduce/trials.h"

namespace hexoderm::cli {

/// The parts of `reproduce`. Each runs its trials, prints its tables unless --json is given, and returns the same as
/// JSON.

/// The paper's two experiments: its published single trials, its method and ours.
nlohmann::ordered_json reproducePaper(const Trials& trials, bool prints);
/// Accuracy of each method on simulated skins, with the bars that Hexoderm set itself.
nlohmann::ordered_json tabulateAccuracy(const Trials& trials, bool prints);
/// Whether the stated uncertainties are as large as the errors.
nlohmann::ordered_json checkUncertainty(const Trials& trials, bool prints);
/// Rates at which broken links and sensors are found, and sound ones blamed.
nlohmann::ordered_json countDetections(const Trials& trials, bool prints);
/// The same for sessions that make no sense as a whole or in part, and for healthy ones of all patches; part of
/// countDetections().
nlohmann::ordered_json countGarbage(const Trials& trials, bool prints);
/// How often `check` finds what changed since a calibration, and blames healthy cells.
nlohmann::ordered_json countChanges(const Trials& trials, bool prints);
/// How often the true place on a link is found by the link's surface, and how far off.
nlohmann::ordered_json placeOnLinks(const Trials& trials, bool prints);

}  // namespace hexoderm::cli
