#pragma once

#include <Qt>

namespace hexoderm {

/// The value behind the text of a table's cell: a number in the header's unit, or a text. Invalid: not known.
constexpr int kRawRole = Qt::UserRole + 1;
/// The unit of the raw numbers below a column's header, such as "deg", empty for counts and texts; at a row's header
/// the kind of thing that the rows are, such as "Link", while their names are the header's raw value.
constexpr int kUnitRole = Qt::UserRole + 2;
/// The name alone of a header that shows more than its name.
constexpr int kNameRole = Qt::UserRole + 3;

}  // namespace hexoderm
