#pragma once

#include <QAbstractItemView>
#include <QItemSelectionModel>
#include <functional>

class QModelIndex;
class QObject;

namespace hexoderm {

/// Calls `picked` with the row, or cell, that the operator picks by a click, an arrow key, or Return. A Tab that passes
/// through the table picks nothing, although the view then makes its first row the current one.
inline void onPicked(QAbstractItemView* view, QObject* receiver, std::function<void(const QModelIndex&)> picked) {
  QObject::connect(view->selectionModel(), &QItemSelectionModel::selectionChanged, receiver,
                   [picked](const QItemSelection& selected) {
                     const QModelIndexList indexes = selected.indexes();
                     if (!indexes.isEmpty()) picked(indexes.front());
                   });
  QObject::connect(view, &QAbstractItemView::activated, receiver, [view, picked](const QModelIndex& index) {
    if (view->selectionModel()->isSelected(index)) {
      picked(index);  // again, because another view may have picked something else since
    } else {
      view->setCurrentIndex(index);
    }
  });
}

}  // namespace hexoderm
