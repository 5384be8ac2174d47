#pragma once

#include "hexoderm/solve/result/reconstruction.h"

#include <QIcon>
#include <QVariant>
#include <optional>

namespace hexoderm {

// The parts of a table's cells that several tables have in common, as the roles of an item model want them. Models
// belong to no widget, so colours follow the application's palette.

/// Figures stand at the right, texts at the left.
QVariant alignment(bool figure);
/// kRawRole of an angle; invalid where it is not known.
QVariant rawDegrees(std::optional<double> angle_rad);
/// Colour of a row that is not used.
QVariant excludedForeground();

/// A tick for what is used, a dash for what is not.
QIcon usedMark(bool used);
/// A piece of the line that a link of this quality has in the graph.
QIcon strokeMark(EdgeQuality quality);
/// A cross, a triangle or a ring: shape and colour together tell the severities apart.
QIcon severityMark(Severity severity);

}  // namespace hexoderm
