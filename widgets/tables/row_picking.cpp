#include "widgets/tables/row_picking.h"

#include <QAbstractItemView>
#include <QItemSelectionModel>

namespace hexoderm {

void onPicked(QAbstractItemView* view, QObject* receiver, std::function<void(const QModelIndex&)> picked) {
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
