#pragma once

#include "hexoderm/solve/result/reconstruction.h"

#include <QIcon>
#include <QVariant>
#include <Qt>
#include <optional>

namespace hexoderm {

/// The value behind the text of a table's cell: a number in the header's unit, or a text. Invalid: not known.
constexpr int kRawRole = Qt::UserRole + 1;
/// The unit of the raw numbers below a column's header, such as "deg", empty for counts and texts; at a row's header
/// the kind of thing that the rows are, such as "Link", while their names are the header's raw value.
constexpr int kUnitRole = Qt::UserRole + 2;
/// The name alone of a header that shows more than its name.
constexpr int kNameRole = Qt::UserRole + 3;

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
