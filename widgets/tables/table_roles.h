#pragma once

#include <Qt>

namespace hexoderm {

/// The value behind the text of a table's cell: a number in the header's unit, or a text. Invalid: not known.
constexpr int kRawRole = Qt::UserRole + 1;
/// Of a column's header: the unit of the raw numbers below it, such as "deg", empty for counts and texts. Of a row's
/// header: the kind of thing that the rows are, such as "Link"; their names are its raw value.
constexpr int kUnitRole = Qt::UserRole + 2;
/// Of a header that shows more than its name: the name alone.
constexpr int kNameRole = Qt::UserRole + 3;

}  // namespace hexoderm
