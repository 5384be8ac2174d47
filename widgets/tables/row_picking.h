#pragma once

#include <functional>

class QAbstractItemView;
class QModelIndex;
class QObject;

namespace hexoderm {

/// Calls `picked` with the row, or cell, that the operator picks by a click, an arrow key, or Return. A Tab that passes
/// through the table picks nothing, although the view then makes its first row the current one.
void onPicked(QAbstractItemView* view, QObject* receiver, std::function<void(const QModelIndex&)> picked);

}  // namespace hexoderm
